#include "tree/neighbors/periodic_box.hpp"

#include <span>
#include <stdexcept>
#include <string>

#include "tree/base/told.hpp"

namespace vortree::tree {
namespace {

void check(const std::string& name, std::span<const double> coordinates, double length) {
  if (!(length >= 0 && std::isfinite(length))) {
    throw std::invalid_argument("the periodic box has the length " + told(length) + " along " +
                                name + "; it must be finite and >= 0");
  }
  if (length == 0) return;
  const auto inside = [=](double x) { return x >= 0 && x < length; };
  const auto out = std::ranges::find_if_not(coordinates, inside);
  if (out == coordinates.end()) return;
  throw std::invalid_argument(name + "[" + std::to_string(out - coordinates.begin()) + "] is " +
                              told(*out) + "; in the periodic box it must be in [0, " +
                              told(length) + ")");
}

}  // namespace

void check_inside(const PeriodicBox& box, Points points) {
  check("x", points.x, box.x);
  check("y", points.y, box.y);
}

}  // namespace vortree::tree
