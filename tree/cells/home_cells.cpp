#include "tree/cells/home_cells.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "tree/base/memory.hpp"
#include "tree/base/parallel.hpp"
#include "tree/base/tuning.hpp"
#include "tree/build/build_reverse.hpp"
#include "tree/build/extent_kernel.hpp"
#include "tree/cells/home_cell_kernel.hpp"
#include "tree/order/digit_sort.hpp"
#include "tree/order/encode_kernel.hpp"
#include "tree/order/radix_sort.hpp"

namespace vortree::tree {

namespace {

// Reaches are taken so much larger that neither the rounding of codes (2^-20 of the finest cell)
// nor that of distances puts a neighbor two cells away.
constexpr double margin = 1 + 0x1p-18;

// work(piece, range) for all portions of every piece, one after the other.
template <class Work>
void for_each_portion(std::size_t n, const Work& work) {
  const std::size_t pieces = pieces_of(n);
  for_each_piece(pieces, [&](std::size_t p) {
    const Range all = piece(n, p, pieces);
    for (std::uint32_t first = all.first; first < all.last; first += located_at_once) {
      work(p, Range{first, std::min(all.last, first + located_at_once)});
    }
  });
}

// The domain so much larger that the cells of some level are as wide as the largest reach.
Domain fit(const Domain& tight, double largest) {
  const double wide = largest * (1 + 0x1p-17);
  const double finest = tight.cell_side(kernel::deepest_own);
  if (!(wide > finest && wide < tight.side && tight.side < 0x1p1000)) return tight;
  const double cells = tight.side / wide;
  return enlarge(tight, std::exp2(std::ceil(std::log2(cells))) / cells);
}

bool acceptable(double reach) {
  return reach >= 0 && reach <= std::numeric_limits<double>::max();
}

[[noreturn]] void refuse_reach(std::span<const double> reach) {
  const auto bad = std::find_if_not(reach.begin(), reach.end(), acceptable);
  std::ostringstream text;
  text.precision(17);
  text << "neighbors: reach[" << bad - reach.begin() << "] is " << *bad
       << "; it must be finite and >= 0";
  throw std::invalid_argument(text.str());
}

struct Extremes {
  double least, most;
};

Extremes extremes(std::span<const double> reach) {
  if (reach.empty()) return {0, 0};
  const std::size_t pieces = pieces_of(reach.size());
  std::array<Extent, shared_pieces> found;
  for_each_piece(pieces, [&](std::size_t p) {
    const Range some = piece(reach.size(), p, pieces);
    found[p] = kernel::extent(reach.subspan(some.first, some.size()));
  });
  const Extent all = kernel::united({found.data(), pieces});
  if (!acceptable(all.low) || !acceptable(all.high)) refuse_reach(reach);
  return {all.low, all.high};
}

// How particles become addresses.
struct AddressFrame {
  Domain domain;
  double spanned;  // side of the domain, so much shorter that cells span reaches with a margin
  kernel::Addresses addresses;

  AddressFrame(const Domain& all, Extremes reach)
      : domain(all),
        spanned(all.side / margin),
        addresses{kernel::own_level(spanned, reach.most), kernel::own_level(spanned, reach.least)} {
  }

  void locate(Points points, std::span<const double> reach, Range some, MortonKey* to) const {
    const double scale = 0x1p31 / domain.side;
    const kernel::DomainAxis x{domain.x0, domain.x0 + domain.side, scale};
    const kernel::DomainAxis y{domain.y0, domain.y0 + domain.side, scale};
    (void)kernel::codes(&points.x[some.first], &points.y[some.first], some.size(), x, y,
                        ~MortonKey{0}, to);
    kernel::home_cells(addresses, spanned, &reach[some.first], some.size(), to);
  }
};

// Particles side by side: from random places one is fetched faster than its three numbers are.
struct Particle {
  double x, y, reach;
};
using ParticleRecords = Unwritten<Particle>;

void pack(Points points, std::span<const double> reach, Range some, ParticleRecords& to) {
  for (std::uint32_t i = some.first; i < some.last; ++i) {
    to[i] = {points.x[i], points.y[i], reach[i]};
  }
}

// A particle on its way.
struct Located {
  MortonKey address;
  std::uint32_t particle;
};

// Puts some particles in their places, sorted(j) telling the j-th, and notes those whose address is
// not that of the one before.
template <class Sorted>
void lay_out(const ParticleRecords& particles, const Sorted& sorted, Range some,
             SortedParticles& placed, std::vector<std::uint32_t>& begins) {
  std::array<std::uint32_t, located_at_once> fresh;
  std::size_t count = 0;
  MortonKey last = some.first == 0 ? ~MortonKey{0} : sorted(some.first - 1).address;
  for (std::uint32_t j = some.first; j < some.last; ++j) {
    const Located here = sorted(j);
    const Particle& particle = particles[here.particle];
    placed.x[j] = particle.x;
    placed.y[j] = particle.y;
    placed.reach[j] = particle.reach;
    placed.id[j] = static_cast<std::int32_t>(here.particle);
    fresh[count] = j;
    count += std::exchange(last, here.address) != here.address;
  }
  begins.insert(begins.end(), fresh.begin(), fresh.begin() + count);
}

// The same for all; each run of equal addresses is a cell.
template <class Sorted>
HomeCells lay_out(const ParticleRecords& particles, const AddressFrame& frame, const Sorted& sorted,
                  SortedParticles& placed) {
  const std::size_t n = particles.size();
  placed.renew(n);
  std::vector<std::vector<std::uint32_t>> begins(pieces_of(n));
  for_each_portion(n, [&](std::size_t piece, Range some) {
    lay_out(particles, sorted, some, placed, begins[piece]);
  });
  HomeCells cells{frame.domain, {}, {}, {}};
  for (const auto& some : begins) cells.first.insert(cells.first.end(), some.begin(), some.end());
  cells.corner.resize(cells.first.size());
  cells.level.resize(cells.first.size());
  for (std::size_t c = 0; c < cells.first.size(); ++c) {
    const MortonKey address = sorted(cells.first[c]).address;
    cells.corner[c] = frame.addresses.corner(address);
    cells.level[c] = static_cast<std::int16_t>(frame.addresses.level(address));
  }
  cells.first.push_back(static_cast<std::uint32_t>(n));
  return cells;
}

// By numbers that hold address and particle, if both fit.
HomeCells sort_numbers(Points points, std::span<const double> reach, const AddressFrame& frame,
                       int particle_bits, SortedParticles& placed) {
  Unwritten<std::uint64_t> numbers(points.size());
  ParticleRecords particles(points.size());
  for_each_portion(points.size(), [&](std::size_t /*piece*/, Range some) {
    frame.locate(points, reach, some, &numbers[some.first]);
    for (std::uint32_t i = some.first; i < some.last; ++i) {
      numbers[i] = numbers[i] << particle_bits | i;
    }
    pack(points, reach, some, particles);
  });
  digit_sort(numbers, particle_bits, particle_bits + frame.addresses.bits());
  const std::uint64_t mask = (std::uint64_t{1} << particle_bits) - 1;
  const auto sorted = [&](std::uint32_t j) {
    return Located{numbers[j] >> particle_bits, static_cast<std::uint32_t>(numbers[j] & mask)};
  };
  return lay_out(particles, frame, sorted, placed);
}

HomeCells sort_keys(Points points, std::span<const double> reach, const AddressFrame& frame,
                    std::vector<MortonKey> keys, Unwritten<std::uint32_t> order,
                    SortedParticles& placed) {
  radix_sort(keys, order);
  ParticleRecords particles(points.size());
  for_each_portion(points.size(), [&](std::size_t /*piece*/, Range some) {
    pack(points, reach, some, particles);
  });
  const auto sorted = [&](std::uint32_t j) { return Located{keys[j], order[j]}; };
  return lay_out(particles, frame, sorted, placed);
}

Unwritten<std::uint32_t> count_up(std::size_t n) {
  Unwritten<std::uint32_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

}  // namespace

Quadtree HomeCells::tree(std::uint32_t few) const {
  const SplitRule must_split = [this, few](const Block& block) {
    const Range inside = block.points;
    return level[inside.last - 1] > block.level && first[inside.last] - first[inside.first] > few;
  };
  return build_reverse({domain, kernel::deepest_own, corner, count_up(size())}, must_split);
}

void check_particles(Points points, std::span<const double> reach) {
  (void)enclose(points);
  (void)extremes(reach);
}

HomeCells sort_into_own_cells(Points points, std::span<const double> reach,
                              SortedParticles& placed) {
  const Extremes extreme = extremes(reach);
  const AddressFrame frame(fit(enclose(points), extreme.most), extreme);
  const std::size_t n = points.size();
  const int particle_bits = std::bit_width(n);
  if (frame.addresses.bits() + particle_bits <= 64) {
    return sort_numbers(points, reach, frame, particle_bits, placed);
  }
  std::vector<MortonKey> keys(n);
  for_each_portion(n, [&](std::size_t /*piece*/, Range some) {
    frame.locate(points, reach, some, &keys[some.first]);
  });
  return sort_keys(points, reach, frame, std::move(keys), count_up(n), placed);
}

HomeCells sort_into_own_cells(const Quadtree& tree, Points points, std::span<const double> reach,
                              SortedParticles& placed) {
  AddressFrame frame(tree.domain(), extremes(reach));
  frame.addresses.coarsest = 0;
  const auto order = tree.order();
  std::vector<MortonKey> keys(reach.size());
  for (const std::uint32_t c : tree.childless()) {
    const Cell& leaf = tree.cells()[c];
    for (std::uint32_t j = leaf.points.first; j < leaf.points.last; ++j) {
      const int level = kernel::own_level(frame.spanned, reach[order[j]]);
      keys[j] = frame.addresses.of(tree.keys()[j], std::min(leaf.level, level));
    }
  }
  return sort_keys(points, reach, frame, std::move(keys), {order.begin(), order.end()}, placed);
}

}  // namespace vortree::tree
