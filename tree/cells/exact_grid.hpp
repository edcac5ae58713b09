#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vortree::tree {

/// Square cells of any level, on which every double has its exact place.
///
/// Cells of level l have sides 2^(top + 1 - l) / g, and the lines x = 0, y = 0 are borders of all
/// levels but 0: that is the square [-2^top / g, 2^top / g]^2. Of g x, the product of 53 bits and
/// of 11, no bit is lost; which cell of a level a coordinate lies in is read off these bits.
/// Negative coordinates are mirror images: a border between cells belongs to the outer one.
///
/// g    1024..2047, chosen so that cells of some level are as wide as a wished length, and less
///      than a thousandth wider
class ExactGrid {
 public:
  /// Deeper than any level that differs.
  static constexpr int bottom = 4096;

  /// farthest   largest magnitude of a coordinate
  /// wished     a length that cells of some level span; 0: any will do
  ExactGrid(double farthest, double wished) : factor_(fit(wished)) {
    top_ = farthest > 0 ? magnitude(farthest).leading + 1 : 0;
  }

  /// The deepest level whose cells span a reach, 0 if there is none; bottom for 0.
  [[nodiscard]] int spanning(double reach) const {
    if (!(reach > 0)) return bottom;
    const Magnitude r = magnitude(reach);
    const int side = r.leading + (r.digits == first_digit ? 0 : 1);
    return std::max(0, top_ + 1 - side);
  }

  /// The level of the smallest cells that two coordinates share; bottom if they are equal.
  [[nodiscard]] int shared(double a, double b) const {
    if ((a < 0) != (b < 0)) return 0;
    const Magnitude p = magnitude(a), q = magnitude(b);
    const int leading = std::max(p.leading, q.leading);
    if (p.leading != q.leading) return top_ - leading;
    return p.digits == q.digits ? bottom : top_ - leading + std::countl_zero(p.digits ^ q.digits);
  }

  /// Of 31 levels below a given one: which of the cells of the last, counted from the border of the
  /// cell of the first.
  [[nodiscard]] std::uint32_t window(double v, int level) const {
    constexpr std::uint32_t all = 0x7fffffff;
    const Magnitude p = magnitude(v);
    // The lowest bit of the window is worth 2^(top + 1 - level - 31).
    const int shift = p.leading - 63 - (top_ + 1 - level - 31);
    const std::uint64_t bits = shift <= -64 || shift >= 31 ? 0
                               : shift < 0                 ? p.digits >> -shift
                                                           : p.digits << shift;
    const auto mirrored =
        v < 0 ? ~static_cast<std::uint32_t>(bits) & all : static_cast<std::uint32_t>(bits) & all;
    return level == 0 ? mirrored ^ 0x40000000u : mirrored;
  }

  /// Is it the upper half of its cell of a level, in which a coordinate lies?
  [[nodiscard]] unsigned half(double v, int level) const { return window(v, level) >> 30; }

  /// Side of a cell, not less than 2^-1000.
  [[nodiscard]] double side(int level) const {
    return std::max(0x1p-1000, std::ldexp(1.0 / static_cast<double>(factor_), top_ + 1 - level));
  }

 private:
  static constexpr std::uint64_t first_digit = std::uint64_t{1} << 63;

  // |g v| = digits 2^(leading - 63), the first digit being 1; nothing at all for 0.
  struct Magnitude {
    std::uint64_t digits = 0;
    int leading = -bottom;
  };

  [[nodiscard]] Magnitude magnitude(double v) const {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(v) << 1 >> 1;
    if (bits == 0) return {};
    const int exponent = std::max(static_cast<int>(bits >> 52), 1) - 1075;
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t hidden = static_cast<std::uint64_t>(bits >> 52 != 0) << 52;
    const std::uint64_t product = (fraction | hidden) * factor_;
    const int zeros = std::countl_zero(product);
    return {product << zeros, exponent + 63 - zeros};
  }

  static std::uint64_t fit(double wished) {
    int exponent = 0;
    const double part = std::frexp(wished, &exponent);
    if (!(part > 0.5)) return 1024;
    return static_cast<std::uint64_t>(1024 / part);
  }

  std::uint64_t factor_;
  int top_;
};

}  // namespace vortree::tree
