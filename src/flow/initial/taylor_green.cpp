#include <cmath>
#include <numbers>

#include "flow/initial/settings.hpp"

namespace vortree::flow {
namespace {

PeriodicFlow periodic(const InitialSettings& i, double nu) {
  const double L = i.number("wavelength"), U = i.number("speed"), k = 2 * std::numbers::pi / L;
  const Vec2 centre{i.centre[0], i.centre[1]};
  const auto decay = [k, nu](double t) { return std::exp(-2 * k * k * nu * t); };
  return {.wavelength = L,
          .speed = U,
          .velocity =
              [=](Vec2 at, double t) {
                const auto [x, y] = k * (at - centre);
                return U * decay(t) * Vec2{-std::cos(x) * std::sin(y), std::sin(x) * std::cos(y)};
              },
          .pressure =
              [=](Vec2 at, double t) {
                const auto [x, y] = 2 * k * (at - centre);
                return -0.25 * std::pow(U * decay(t), 2) * (std::cos(x) + std::cos(y));
              }};
}

std::vector<Patch> none(const InitialSettings&) {
  return {};
}

}  // namespace

/// Vortices of both signs side by side in the whole plane, which decay and stay in their places:
///
///   u = -U cos(kx) sin(ky) e,   v = U sin(kx) cos(ky) e,   k = 2 pi/L,   e = exp(-2 k^2 nu t)
///   p = -U^2 (cos(2kx) + cos(2ky))/4 e^2
///
/// source  Taylor & Green, Proc. R. Soc. Lond. A 158 (1937)
const InitialFlow& taylor_green() {
  static const InitialFlow kind{
      {"taylor_green",
       {{"wavelength", positive, "L", "L, after which it is the same again along x and y"},
        {"speed", positive, "L/T", "its greatest velocity", 1}}},
      "vortices of both signs side by side in the whole plane, for SPH in a periodic box",
      none,
      any_core,
      no_doubt,
      false,
      periodic};
  return kind;
}

}  // namespace vortree::flow
