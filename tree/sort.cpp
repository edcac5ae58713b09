#include "tree/sort.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "tree/radix_sort.hpp"

namespace vortree::tree {

namespace {

// One axis of the domain.
struct Axis {
  double first, last, scale;
  [[nodiscard]] bool holds(double v) const { return (v >= first) & (v <= last); }
  // Defined for any v, so that a whole pass may run before somebody looks for strays.
  [[nodiscard]] std::uint32_t cell(double v) const {
    constexpr double last_cell = 0x1p31 - 1;
    const double q = (v - first) * scale;
    const double not_below = q > 0 ? q : 0;
    return static_cast<std::uint32_t>(
        static_cast<std::int64_t>(not_below < last_cell ? not_below : last_cell));
  }
};

[[noreturn]] void refuse_point(Points points, const Domain& domain, std::size_t i) {
  std::ostringstream text;
  text.precision(17);
  text << "morton_order: point " << i << " at (" << points.x[i] << ", " << points.y[i]
       << ") is outside the domain [" << domain.x0 << ", " << domain.x0 + domain.side << "] x ["
       << domain.y0 << ", " << domain.y0 + domain.side << "]";
  throw std::invalid_argument(text.str());
}

void check_request(Points points, const Domain& domain, int finest) {
  std::ostringstream text;
  if (points.x.size() != points.y.size()) {
    text << points.x.size() << " x but " << points.y.size() << " y coordinates";
  } else if (points.size() >= std::numeric_limits<std::uint32_t>::max()) {
    text << points.size() << " points; at most 2^32 - 2 can be indexed";
  } else if (finest < 0 || finest > max_level) {
    text << "finest level is " << finest << "; it must be in 0.." << max_level;
  } else if (!(domain.side >= 0x1p-900 && std::isfinite(domain.x0 + domain.side) &&
               std::isfinite(domain.y0 + domain.side))) {
    text << "domain (" << domain.x0 << ", " << domain.y0 << ") of side " << domain.side
         << " is not a finite square with side >= 2^-900";
  } else {
    return;
  }
  throw std::invalid_argument("morton_order: " + text.str());
}

std::vector<Key> encode_points(Points points, const Domain& domain, int finest) {
  const double scale = 0x1p31 / domain.side;
  const Axis x{domain.x0, domain.x0 + domain.side, scale};
  const Axis y{domain.y0, domain.y0 + domain.side, scale};
  const std::uint32_t mask = ~std::uint32_t{0} << (max_level - finest);
  const std::size_t n = points.size();
  std::vector<Key> keys(n);
  std::uint64_t strays = 0;
#pragma omp parallel for schedule(static) reduction(+ : strays) if (n > 50000)
  for (std::size_t i = 0; i < n; ++i) {
    strays += static_cast<std::uint64_t>(!(x.holds(points.x[i]) & y.holds(points.y[i])));
    keys[i] = encode({x.cell(points.x[i]) & mask, y.cell(points.y[i]) & mask});
  }
  if (strays != 0) {
    std::size_t i = 0;
    while (x.holds(points.x[i]) && y.holds(points.y[i])) {
      ++i;
    }
    refuse_point(points, domain, i);
  }
  return keys;
}

}  // namespace

MortonOrder morton_order(Points points, const Domain& domain, int finest) {
  check_request(points, domain, finest);
  MortonOrder order{domain, finest, encode_points(points, domain, finest), {}};
  order.index.resize(points.size());
  std::iota(order.index.begin(), order.index.end(), 0u);
  radix_sort(order.keys, order.index);
  return order;
}

}  // namespace vortree::tree
