#pragma once

#include <span>
#include <vector>

#include "vortex/wall/wall.hpp"

namespace vortree::vortex {

/// A core beside a wall, as the wall sees it.
///
/// at      the wall point nearest to its centre, as far away as the core's height
///         (folded_centroid.hpp)
/// across  its width along the normal, sigma_n [m]
/// along   its width along the wall, sigma_t [m]
struct CoreAtWall {
  double gamma;
  body::WallPoint at;
  double across, along;
};

/// A Gaussian along a wall: amount/(sqrt(pi) width) exp(-(s - arc)^2/width^2); a spike for width 0.
struct Trace {
  double amount, arc, width;
};

/// The wall vorticity of a folded core, along the wall as
///
///   exp(-(s - arc)^2/width^2),   1/width^2 = 1/sigma_t^2 + kappa y/sigma_n^2,
///
/// its amount, the integral along the wall [m/s], that of the heat flow without flux at a bent
/// wall:
///
///   gamma (2/(sqrt(pi) sigma_n) exp(-q^2) - kappa/2 (erfc(q) + 2 q/sqrt(pi) exp(-q^2))),
///
/// q = y/sigma_n; y and kappa are the distance and the curvature at the nearest wall point. (That
/// is d m/d(nu t) of the mean distance m in folded_core.hpp; of the sharpest edges, half the first
/// term.)
/// error  (kappa sigma_n)^2 of the amount
Trace trace(const CoreAtWall& core);

/// Sums of traces along a wall, a value a panel, smoothed over w = 3 panels. A trace ends with its
/// body.
///
/// Blobs are released a panel apart and split and merge at such distances, so that their bare sum
/// is rough there, at every step anew: by a tenth of the largest wall vorticity. The flow's own
/// varies along the wall by boundary layers, of a dozen panels. A trace therefore counts as
///
///   amount/(sqrt(pi) W) exp(-d^2/W^2) (1 + (w/W)^2 (1/2 - d^2/W^2)),   W^2 = w^2 + width^2,
///
/// which is its Gaussian g smoothed by another one, of width w, and freed of that one's broadening:
/// g_w - (w^2/4) g_w''. Amounts are kept. Where the wall bends, w is a quarter of its radius of
/// curvature, though not less than a panel, and grows from there by a quarter of the way.
///
/// error   of what varies as sin(k s): a share 1 - (1 + q) exp(-q) < q^2/2, q = (k w/2)^2; what is
///         cut off beyond 4 W is 2e-6 of a trace's largest value
/// cost    2 ns a panel within 4 W, more where panels are uneven, of which each takes an
///         exponential; a nearest wall point for each panel at the beginning
/// source  Beale & Majda, J. Comput. Phys. 58 (1985), for such kernels
///
/// wall  outlives it
class AlongWall {
 public:
  explicit AlongWall(const Wall& wall);

  void add(const Trace& trace, std::span<double> values) const;

  /// w at a panel [m].
  double smoothed_over(std::size_t panel) const { return smoothed_over_[panel]; }

 private:
  struct Smoothed;
  void add_evenly(const Trace& trace, const Ring& ring, std::span<double> values) const;
  /// here  the panel where the trace is
  void add_unevenly(const Trace& trace, std::size_t here, const Ring& ring,
                    std::span<double> values) const;

  const Wall* wall_;
  std::vector<double> smoothed_over_;
};

}  // namespace vortree::vortex
