#include "tree/sort.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace vortree::tree {

namespace {

constexpr int digit_bits = 8;
constexpr std::size_t buckets = std::size_t{1} << digit_bits;
constexpr int digits = 64 / digit_bits;
using Histogram = std::array<std::uint32_t, buckets>;

std::size_t digit(Key key, int which) {
  return key >> which * digit_bits & (buckets - 1);
}

std::array<Histogram, digits> count_digits(const std::vector<Key>& keys) {
  std::array<Histogram, digits> counts{};
  for (const Key key : keys) {
    for (int d = 0; d < digits; ++d) {
      ++counts[d][digit(key, d)];
    }
  }
  return counts;
}

// One axis of the domain.
struct Axis {
  double first, last, scale;
  [[nodiscard]] bool holds(double v) const { return v >= first && v <= last; }
  [[nodiscard]] std::int32_t cell(double v) const {
    constexpr double last_cell = 0x1p31 - 1;
    const double q = (v - first) * scale;
    return static_cast<std::int32_t>(q < last_cell ? q : last_cell);
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
  std::uint64_t outside = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const bool held = x.holds(points.x[i]) & y.holds(points.y[i]);
    outside |= !held;
    const double px = held ? points.x[i] : domain.x0;
    const double py = held ? points.y[i] : domain.y0;
    keys[i] = encode({static_cast<std::uint32_t>(x.cell(px)) & mask,
                      static_cast<std::uint32_t>(y.cell(py)) & mask});
  }
  if (outside != 0) {
    std::size_t i = 0;
    while (x.holds(points.x[i]) && y.holds(points.y[i])) {
      ++i;
    }
    refuse_point(points, domain, i);
  }
  return keys;
}

}  // namespace

void radix_sort(std::vector<Key>& keys, std::vector<std::uint32_t>& index) {
  const std::size_t n = keys.size();
  if (index.size() != n) {
    throw std::invalid_argument("radix_sort: " + std::to_string(n) + " keys but " +
                                std::to_string(index.size()) + " indices");
  }
  if (n < 2) {
    return;
  }
  std::array<Histogram, digits> counts = count_digits(keys);
  std::vector<Key> other_keys(n);
  std::vector<std::uint32_t> other_index(n);
  for (int d = 0; d < digits; ++d) {
    Histogram& next = counts[d];
    if (next[digit(keys[0], d)] == n) {
      continue;
    }
    std::exclusive_scan(next.begin(), next.end(), next.begin(), std::uint32_t{0});
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t to = next[digit(keys[i], d)]++;
      other_keys[to] = keys[i];
      other_index[to] = index[i];
    }
    std::swap(keys, other_keys);
    std::swap(index, other_index);
  }
}

MortonOrder morton_order(Points points, const Domain& domain, int finest) {
  check_request(points, domain, finest);
  MortonOrder order{domain, finest, encode_points(points, domain, finest), {}};
  order.index.resize(points.size());
  std::iota(order.index.begin(), order.index.end(), 0u);
  radix_sort(order.keys, order.index);
  return order;
}

}  // namespace vortree::tree
