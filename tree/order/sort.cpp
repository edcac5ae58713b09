#include "tree/order/sort.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "tree/base/parallel.hpp"
#include "tree/base/tuning.hpp"
#include "tree/order/encode_kernel.hpp"
#include "tree/order/radix_sort.hpp"

namespace vortree::tree {

namespace {

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

Unwritten<MortonKey> encode_points(Points points, const Domain& domain, int finest) {
  const double scale = 0x1p31 / domain.side;
  const kernel::DomainAxis x{domain.x0, domain.x0 + domain.side, scale};
  const kernel::DomainAxis y{domain.y0, domain.y0 + domain.side, scale};
  const MortonKey mask = ~MortonKey{0} << 2 * (max_level - finest);
  const std::size_t n = points.size();
  Unwritten<MortonKey> keys(n);
  const std::size_t pieces = pieces_of(n);
  std::array<std::size_t, shared_pieces> strays{};
  for_each_piece(pieces, [&](std::size_t p) {
    const Range own = piece(n, p, pieces);
    strays[p] = kernel::codes(points.x.data() + own.first, points.y.data() + own.first, own.size(),
                              x, y, mask, keys.data() + own.first);
  });
  if (std::ranges::any_of(strays, [](std::size_t some) { return some != 0; })) {
    std::size_t i = 0;
    while (x.holds(points.x[i]) && y.holds(points.y[i])) ++i;
    refuse_point(points, domain, i);
  }
  return keys;
}

}  // namespace

MortonOrder morton_order(Points points, const Domain& domain, int finest) {
  check_request(points, domain, finest);
  MortonOrder order{domain, finest, encode_points(points, domain, finest), {}};
  order.index = radix_sort(order.keys);
  return order;
}

}  // namespace vortree::tree
