#include "fmm/losses/closeness.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

namespace vortree::fmm {
namespace {

/// From this many limits on, no two coordinates are nearer than the limit.
constexpr double sparse = 0x1p54;

/// A point and the square of side `limit` that holds it; a coordinate that has no neighbors is a
/// square of its own.
struct Square {
  double column, row, x, y;
  std::size_t index;

  [[nodiscard]] auto key() const { return std::tie(column, row, x, y); }
};

double square_of(double value, double limit) {
  return std::abs(value) < sparse * limit ? std::floor(value / limit) : value / limit;
}

std::vector<Square> sort_places(std::span<const double> x, std::span<const double> y,
                                double limit) {
  std::vector<Square> squares(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double px = x[i] + 0.0, py = y[i] + 0.0;  // no -0
    squares[i] = {square_of(px, limit), square_of(py, limit), px, py, i};
  }
  std::ranges::sort(squares, {}, [](const Square& at) { return std::tuple(at.key(), at.index); });
  const auto same = [](const Square& a, const Square& b) { return a.key() == b.key(); };
  squares.erase(std::unique(squares.begin(), squares.end(), same), squares.end());
  return squares;
}

}  // namespace

std::optional<ClosePair> find_close_pair(std::span<const double> x, std::span<const double> y,
                                         double least_magnitude, double limit) {
  if (!(limit > 0.0) || least_magnitude >= sparse * limit) return std::nullopt;
  const std::vector<Square> squares = sort_places(x, y, limit);
  const auto square = [](const Square& at) { return std::pair(at.column, at.row); };
  for (const Square& at : squares) {
    for (int k = 0; k < 9; ++k) {
      const std::pair near(at.column + (k / 3 - 1), at.row + (k % 3 - 1));
      // Of places in one square each is looked at once, so that few are.
      const auto last = std::ranges::upper_bound(squares, near, {}, square);
      for (auto other = std::ranges::lower_bound(squares, near, {}, square); other != last;
           ++other) {
        const double distance = std::hypot(other->x - at.x, other->y - at.y);
        if (distance > 0.0 && distance < limit) {
          return ClosePair{std::min(at.index, other->index), std::max(at.index, other->index),
                           distance};
        }
      }
    }
  }
  return std::nullopt;
}

}  // namespace vortree::fmm
