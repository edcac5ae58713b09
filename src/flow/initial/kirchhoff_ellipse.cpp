#include <algorithm>
#include <numbers>

#include "base/rounded.hpp"
#include "flow/initial/settings.hpp"

namespace vortree::flow {
namespace {

/// The share of a lattice's cell that lies inside, by 16 x 16 points of it.
double share_inside(Vec2 at, double h, double a, double b) {
  constexpr int fine = 16;
  int inside = 0;
  for (int j = 0; j < fine; ++j)
    for (int i = 0; i < fine; ++i) {
      const double x = at.x + ((i + 0.5) / fine - 0.5) * h, y = at.y + ((j + 0.5) / fine - 0.5) * h;
      inside += x * x / (a * a) + y * y / (b * b) < 1;
    }
  return inside / double(fine * fine);
}

std::vector<Patch> patches(const InitialSettings& i) {
  const double a = *i.core, b = i.number("core_across");
  return {{.circulation = *i.circulation,
           .half = {a, b},
           .area = std::numbers::pi * a * b,
           .weight = [a, b](Vec2 at, double, double h) { return share_inside(at, h, a, b); },
           .extent =
               [a, b](double, double, double h) {
                 return Vec2{a + h, b + h};
               }}};
}

std::vector<std::string> doubts(const InitialSettings& i, double sigma_0) {
  const double thin = std::min(*i.core, i.number("core_across"));
  if (sigma_0 <= 0.3 * thin) return {};
  return {"cores.sigma_0 = " + rounded(sigma_0, 3) +
          ": the vortex's edge is as wide, and its half width is " + rounded(thin, 3) + "; " +
          rounded(0.1 * thin, 2) + " is right"};
}

}  // namespace

/// Uniform vorticity gamma/(pi a b) within an ellipse of half axes `core` and `core_across`. Its
/// edge is as wide as the cores.
const InitialFlow& kirchhoff_ellipse() {
  static const InitialFlow kind{
      {"kirchhoff_ellipse", {{"core_across", positive, "L", "its half axis along y"}}},
      "uniform vorticity in an ellipse",
      patches,
      any_core,
      doubts,
      true};
  return kind;
}

}  // namespace vortree::flow
