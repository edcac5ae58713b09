#include "exact/kirchhoff_ellipse.hpp"

#include <numbers>

namespace vortree::exact {

double KirchhoffEllipse::vorticity() const {
  return gamma / (std::numbers::pi * a * b);
}

double KirchhoffEllipse::rate() const {
  return vorticity() * a * b / ((a + b) * (a + b));
}

}  // namespace vortree::exact
