#include "flow/initial/gaussian.hpp"

#include <cmath>
#include <numbers>

#include "tree/base/told.hpp"

namespace vortree::flow {

Patch gaussian(double gamma, double a, double b, Vec2 offset) {
  return {.offset = offset,
          .circulation = gamma,
          .half = {a, b},
          .area = std::numbers::pi * a * b,
          .weight =
              [a, b](Vec2 at, double sigma, double) {
                const double p2 = a * a - sigma * sigma, q2 = b * b - sigma * sigma;
                return std::exp(-at.x * at.x / p2 - at.y * at.y / q2);
              },
          .extent =
              [a, b](double faintest, double sigma, double) {
                const double p2 = a * a - sigma * sigma, q2 = b * b - sigma * sigma;
                const double far = -std::log(faintest);
                return Vec2{std::sqrt(p2 * far), std::sqrt(q2 * far)};
              }};
}

void hold_wider(const std::string& key, double width, double sigma_0) {
  if (width > sigma_0) return;
  throw Refused(key, key + " is " + tree::told(width) +
                         "; it must be > cores.sigma_0 = " + tree::told(sigma_0));
}

}  // namespace vortree::flow
