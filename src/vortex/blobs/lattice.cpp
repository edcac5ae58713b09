#include "vortex/blobs/lattice.hpp"

#include <stdexcept>
#include <string>

#include "flow/initial/gaussian.hpp"
#include "flow/initial/lattice.hpp"
#include "tree/base/told.hpp"

namespace vortree::vortex {
namespace {

void require(bool holds, const Lattice& lattice, Vec2 widths, const char* expected) {
  if (holds && lattice.sigma_0 > 0 && lattice.h > 0) return;
  throw std::invalid_argument("a vortex of widths " + tree::told(widths.x) + ", " +
                              tree::told(widths.y) + " cut into cores of " +
                              tree::told(lattice.sigma_0) + " every " + tree::told(lattice.h) +
                              "; " + expected + " > 0 and spacing > 0 were expected");
}

/// A kind that has one number beside circulation and core.
flow::InitialSettings settings(std::string_view kind, double gamma, double core,
                               std::string_view number, double value) {
  flow::InitialSettings made{.kind = &flow::initial_flow(kind), .circulation = gamma, .core = core};
  made.numbers[number] = value;
  return made;
}

}  // namespace

Blobs cut(const Lattice& lattice, const flow::Patch& patch) {
  require(true, lattice, patch.half, "cores");
  const auto [centre, sigma_0, h, faintest] = lattice;
  Blobs blobs;
  for (const auto& [at, gamma] : flow::cut(patch, sigma_0, h, faintest))
    blobs.append(centre + patch.offset + at, gamma, sigma_0);
  return blobs;
}

Blobs cut(const Lattice& lattice, const flow::InitialSettings& initial) {
  Blobs all;
  for (const flow::Patch& patch : initial.kind->patches(initial)) {
    const Blobs more = cut(lattice, patch);
    for (std::size_t k = 0; k < more.size(); ++k)
      all.append(more.centre(k), more.gamma[k], more.sigma[k]);
  }
  return all;
}

Blobs gaussian_ellipse(const Lattice& lattice, double gamma, double a, double b) {
  require(a > lattice.sigma_0 && b > lattice.sigma_0, lattice, {a, b}, "widths > sigma_0");
  return cut(lattice, flow::gaussian(gamma, a, b));
}

Blobs gaussian_vortex(Vec2 centre, double gamma, double core, double sigma_0, double h) {
  return gaussian_ellipse({centre, sigma_0, h}, gamma, core, core);
}

Blobs perturbed_vortex(const Lattice& lattice, double gamma, double a, double p) {
  require(a > lattice.sigma_0, lattice, {a, a}, "widths > sigma_0");
  return cut(lattice, settings("tripole", gamma, a, "perturbation", p));
}

Blobs uniform_ellipse(const Lattice& lattice, double gamma, double a, double b) {
  require(a > 0 && b > 0, lattice, {a, b}, "widths and sigma_0");
  return cut(lattice, settings("kirchhoff_ellipse", gamma, a, "core_across", b));
}

}  // namespace vortree::vortex
