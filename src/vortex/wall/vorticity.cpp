#include "vortex/wall/vorticity.hpp"

#include "fmm/vorticity.hpp"
#include "vortex/cores/folded_centroid.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/cores/halves.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {

void vorticity(const Blobs& blobs, const body::Shape* wall, tree::Points at,
               std::span<double> omega) {
  Blobs all = wall ? blobs : Halves(blobs).parts;
  for (std::size_t i = 0; wall && i < blobs.size(); ++i) {
    if (wall->beyond(blobs.centre(i), folded::support * blobs.sigma[i])) continue;
    const body::WallPoint w = wall->nearest(blobs.centre(i));
    const double y = height(w, blobs.core(i).covariance(w.normal));
    if (!folded::applies(y, blobs.sigma[i])) continue;
    const Vec2 foot = blobs.centre(i) - w.distance * w.normal;
    all.put(i, foot + y * w.normal, blobs.gamma[i], blobs.core(i));
    all.append(foot - y * w.normal, blobs.gamma[i], blobs.sigma[i]);
  }
  fmm::vorticity({all.x, all.y, all.gamma, all.sigma}, at, omega, core_cut_off);
  for (std::size_t i = 0; wall && i < at.size(); ++i)
    if (wall->nearest({at.x[i], at.y[i]}).distance < 0) omega[i] = 0;
}

}  // namespace vortree::vortex
