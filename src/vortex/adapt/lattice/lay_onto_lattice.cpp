#include "vortex/adapt/lattice/lay_onto_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "tree/base/numbers_where.hpp"
#include "tree/order/radix_sort.hpp"
#include "vortex/adapt/lattice/spline_nodes.hpp"
#include "vortex/adapt/lattice/units.hpp"
#include "vortex/adapt/tuning.hpp"

namespace vortree::vortex {

namespace {

/// 2^(k/2), exact for even k, and for odd ones the same digits.
double root_of_power(int k) {
  return std::ldexp(k % 2 ? std::numbers::sqrt2 : 1.0, k / 2);
}

}  // namespace

LatticeLevel::LatticeLevel(double sigma_max, int level)
    : h(lattice_step * sigma_max * root_of_power(level)),
      square(std::ldexp(std::pow(lattice_core * sigma_max, 2), level)) {}

int level_of(double widening) {
  return std::ilogb(widening * widening);
}

NineNodes::NineNodes(Vec2 at, const Core& core, const LatticeLevel& level) {
  const double x = at.x / level.h, y = at.y / level.h, h2 = level.h * level.h;
  const double nearest_x = std::nearbyint(x), nearest_y = std::nearbyint(y);
  const double dx = x - nearest_x, dy = y - nearest_y, spread = (core.square - level.square) / 2;
  const double mx = (spread + core.deviator.xx) / h2 + dx * dx,
               my = (spread - core.deviator.xx) / h2 + dy * dy, corner = core.deviator.xy / h2 / 4;
  const std::array<double, 3> wx{(mx - dx) / 2, 1 - mx, (mx + dx) / 2},
      wy{(my - dy) / 2, 1 - my, (my + dy) / 2};
  gx = static_cast<std::int64_t>(nearest_x);
  gy = static_cast<std::int64_t>(nearest_y);
  for (int b = -1; b <= 1; ++b)
    for (int a = -1; a <= 1; ++a) share[4 + a + 3 * b] = wx[1 + a] * wy[1 + b] + a * b * corner;
}

namespace {

// Tiles of 16 x 16 nodes, numbered by level, row and column.
constexpr int across = 16, tile_bits = 28;
constexpr std::int64_t middle_tile = std::int64_t{1} << (tile_bits - 1);
using Tile = std::uint64_t;
using Sums = std::array<std::int64_t, across * across>;

constexpr std::int64_t tile_of(std::int64_t node) {
  return node >> 4;
}
Tile numbered(int level, std::int64_t row, std::int64_t column) {
  return static_cast<Tile>(level) << (2 * tile_bits) |
         static_cast<Tile>(row + middle_tile) << tile_bits |
         static_cast<Tile>(column + middle_tile);
}
int level_of_tile(Tile tile) {
  return static_cast<int>(tile >> (2 * tile_bits));
}
/// Number of the tile's first node along x, along y.
std::int64_t first_x(Tile tile) {
  constexpr Tile mask = (Tile{1} << tile_bits) - 1;
  return across * (static_cast<std::int64_t>(tile & mask) - middle_tile);
}
std::int64_t first_y(Tile tile) {
  return first_x(tile >> tile_bits);
}

/// Lattices by level.
class AllLevels {
 public:
  explicit AllLevels(double sigma_max) {
    for (int k = 0; k < most_levels; ++k) all_.emplace_back(sigma_max, k);
  }
  const LatticeLevel& operator[](int level) const { return all_[level]; }

 private:
  std::vector<LatticeLevel> all_;
};

/// Rows and columns of the tiles that a blob reaches.
struct TilesOfBlob {
  int level;
  std::int64_t row, rows, column, columns;

  /// reach  in nodes from the nearest
  TilesOfBlob(const WideBlob& blob, const AllLevels& levels, int reach) : level(blob.level) {
    const double h = levels[level].h;
    const auto x = static_cast<std::int64_t>(std::nearbyint(blob.at.x / h)),
               y = static_cast<std::int64_t>(std::nearbyint(blob.at.y / h));
    row = tile_of(y - reach);
    rows = tile_of(y + reach) - row + 1;
    column = tile_of(x - reach);
    columns = tile_of(x + reach) - column + 1;
  }
  std::size_t count() const { return static_cast<std::size_t>(rows * columns); }
  void for_each(const auto& use) const {
    for (std::int64_t k = 0; k < rows * columns; ++k)
      use(numbered(level, row + k / columns, column + k % columns));
  }
};

/// The blobs that reach into each tile, one tile after the other.
struct ReachedTiles {
  Unwritten<Tile> tile;
  Unwritten<std::uint32_t> blob;
  std::vector<std::size_t> first;  // of each tile that there is, and the end

  /// reach  of a blob, in nodes from the nearest
  ReachedTiles(std::span<const WideBlob> blobs, const AllLevels& levels, int reach) {
    const std::size_t pieces = tree::pieces_of(blobs.size());
    const auto of = [&](std::uint32_t i) { return TilesOfBlob(blobs[i], levels, reach); };
    const auto begins = tree::begins_of_pieces(blobs.size(), pieces,
                                               [&](std::uint32_t i) { return of(i).count(); });
    tile.resize(begins[pieces]);
    blob.resize(begins[pieces]);
    tree::for_each_piece(pieces, [&](std::size_t p) {
      const tree::Range own = tree::piece(blobs.size(), p, pieces);
      std::size_t next = begins[p];
      for (std::uint32_t i = own.first; i < own.last; ++i)
        of(i).for_each([&](Tile reached) {
          tile[next] = reached;
          blob[next++] = i;
        });
    });
    tree::radix_sort(tile, blob);
    for (std::size_t k = 0; k < tile.size(); ++k)
      if (k == 0 || tile[k] != tile[k - 1]) first.push_back(k);
    first.push_back(tile.size());
  }
};

double strength(std::span<const WideBlob> blobs) {
  double all = 0;
  for (const WideBlob& b : blobs) all += std::abs(b.gamma);
  return all;
}

/// The shares of one blob, together what it has itself; the one in the middle has what is left.
template <std::size_t N>
std::array<std::int64_t, N> parted(std::int64_t units, const std::array<double, N>& share) {
  std::array<std::int64_t, N> parts;
  std::int64_t left = units;
  for (std::size_t k = 0; k < N; ++k) {
    parts[k] = std::llrint(static_cast<double>(units) * share[k]);
    if (k != N / 2) left -= parts[k];
  }
  parts[N / 2] = left;
  return parts;
}

/// Adds what of a blob falls into a tile.
template <class Nodes>
void add(Sums& sums, Tile tile, const Nodes& nodes, std::int64_t gamma) {
  const auto units = parted(gamma, nodes.share);
  constexpr std::int64_t reach = units.size() == 9 ? 1 : SplineNodes::reach, row = 2 * reach + 1;
  const std::int64_t x = nodes.gx - first_x(tile), y = nodes.gy - first_y(tile);
  for (std::int64_t b = -reach; b <= reach; ++b)
    for (std::int64_t a = -reach; a <= reach; ++a)
      if (x + a >= 0 && x + a < across && y + b >= 0 && y + b < across)
        sums[(y + b) * across + x + a] += units[reach + a + row * (reach + b)];
}

}  // namespace

bool on_lattices(Vec2 at, double sigma_max) {
  constexpr double most = static_cast<double>(across * (middle_tile - 1));
  const double h = lattice_step * sigma_max;
  return std::abs(at.x) < most * h && std::abs(at.y) < most * h;
}

std::vector<LatticeNode> lay_onto_lattice(std::span<const WideBlob> blobs, double sigma_max,
                                          Shares shares) {
  const AllLevels levels(sigma_max);
  const CirculationUnits units(strength(blobs));
  const ReachedTiles tiled(blobs, levels, shares == Shares::nine ? 1 : SplineNodes::reach);
  const std::size_t tiles = tiled.first.size() - 1;
  Unwritten<Sums> sums(tiles);
  std::vector<std::size_t> begin(tiles + 1);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t t = 0; t < tiles; ++t) {
    const Tile tile = tiled.tile[tiled.first[t]];
    sums[t].fill(0);
    for (std::size_t k = tiled.first[t]; k < tiled.first[t + 1]; ++k) {
      const WideBlob& b = blobs[tiled.blob[k]];
      const std::int64_t gamma = units.of(b.gamma);
      if (shares == Shares::nine)
        add(sums[t], tile, NineNodes(b.at, b.core, levels[b.level]), gamma);
      else
        add(sums[t], tile, SplineNodes(b.at, b.core, levels[b.level]), gamma);
    }
    begin[t + 1] = across * across - std::ranges::count(sums[t], 0);
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<LatticeNode> made(begin[tiles]);
#pragma omp parallel for schedule(dynamic, tiles_a_turn)
  for (std::size_t t = 0; t < tiles; ++t) {
    const Tile tile = tiled.tile[tiled.first[t]];
    const int level = level_of_tile(tile);
    const double h = levels[level].h;
    std::size_t next = begin[t];
    for (int k = 0; k < across * across; ++k)
      if (sums[t][k] != 0)
        made[next++] = {{h * static_cast<double>(first_x(tile) + k % across),
                         h * static_cast<double>(first_y(tile) + k / across)},
                        units.circulation(sums[t][k]),
                        level};
  }
  return made;
}

}  // namespace vortree::vortex
