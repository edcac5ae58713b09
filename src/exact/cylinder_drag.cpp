#include "exact/cylinder_drag.hpp"

#include <cmath>
#include <numbers>

namespace vortree::exact {

double short_time_cylinder_drag(double re, double time) {
  using std::numbers::pi;
  return 4 * std::sqrt(pi / (re * time)) + 2 * pi / re - std::sqrt(pi * time) / std::pow(re, 1.5);
}

}  // namespace vortree::exact
