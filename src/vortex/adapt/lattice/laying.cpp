#include "vortex/adapt/lattice/laying.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tree/base/numbers_where.hpp"
#include "vortex/adapt/lattice/lay_onto_lattice.hpp"
#include "vortex/adapt/tuning.hpp"
#include "vortex/cores/folded_core.hpp"

namespace vortree::vortex {
namespace {

/// How near to the wall a blob is laid, in sigma_max of its level: its nodes are up to 1.5 steps
/// off in either direction, and free of the wall.
constexpr double zone = folded::support * lattice_core + 1.5 * std::numbers::sqrt2 * lattice_step;

/// In how many steps a node's square spreads to the least that is laid; 0: it never does.
std::uint64_t period(const LatticeLevel& level, double spread) {
  const double steps = (level.least() - level.square) / spread * (1 - 1e-9);
  return steps < 0x1p30 ? static_cast<std::uint64_t>(std::ceil(steps)) : 0;
}

}  // namespace

Laying::Laying(const Splitting& splitting, const body::Shape* wall, std::uint64_t step)
    : splitting_(splitting),
      wall_(wall),
      clock_((step & 0xffffffffu) + (step >> 32)),
      wall_lattice_(splitting.sigma_max, 0) {
  if (splitting.spread > 0)
    period_ = period(LatticeLevel(splitting.sigma_max, 0), splitting.spread);
  if (strains()) period_ = std::min(period_ > 0 ? period_ : UINT64_MAX, splitting.strained_steps);
  wall_lattice_ = WallLattice(splitting.sigma_max, static_cast<double>(period_) * splitting.spread);
  wall_is_followed_ = wall && wall_lattice_.fits(*wall);
}

double Laying::seen_from(double widest) const {
  return zone * std::max(splitting_.sigma_max, 1.001 * widest);
}

int Laying::coarsest(double distance) const {
  const double room = distance / (zone * splitting_.sigma_max);
  return room >= 1 ? std::min(level_of(std::min(room, 0x1p31)), most_levels - 1) : none;
}

int Laying::finest(double distance, double widening) const {
  const int level = level_of(widening);
  return level <= coarsest(distance) ? level : none;
}

bool Laying::in_turn(int level) const {
  return period_ == 0 || clock_ % (period_ << std::min(level, 31)) == 0;
}

/// Whether a blob is laid in this step.
bool Laying::due(double square, int finest) const {
  const LatticeLevel level(splitting_.sigma_max, finest);
  if (square >= 2 * level.least()) return true;
  return in_turn(finest) && square >= (period_ > 0 ? level.square : level.least());
}

double Laying::faintness(double gamma, double square) const {
  const double vorticity = std::abs(gamma) / square;
  if (wall_ || vorticity >= splitting_.faint) return 1;
  return std::min(std::pow(splitting_.faint / vorticity, 0.25), faint_widening);
}

float Laying::widening(double of_place, int finest) const {
  return static_cast<float>(std::max(of_place, std::exp2(0.5 * finest)));
}

/// Whether a blob is laid along the wall in this step.
bool Laying::goes_along_wall(const Core& core, const body::WallPoint& nearest) const {
  const bool wide = core.square >= 2 * splitting_.sigma_max * splitting_.sigma_max;
  return wall_is_followed_ && nearest.distance < zone * splitting_.sigma_max &&
         (in_turn(0) || wide) && wall_lattice_.takes(core, nearest);
}

Laying::Lot Laying::lot(const Blobs& blobs, std::size_t i, const body::WallPoint& nearest,
                        double distance, float of_place) const {
  const Core core = blobs.core(i);
  const double sure = blobs.gamma[i] + core.square + core.deviator.size();
  if (splitting_.scheme != SplitScheme::lattice || !std::isfinite(sure))
    return {.widening = of_place, .leniency = of_place};
  if (goes_along_wall(core, nearest))
    return {.level = along_wall, .widening = of_place, .leniency = of_place};
  const int level = finest(distance, of_place * faintness(blobs.gamma[i], core.square));
  if (level == none || !on_lattices(blobs.centre(i), splitting_.sigma_max))
    return {.widening = of_place, .leniency = of_place};
  Lot lot{.free = true,
          .widening = widening(of_place, level),
          .leniency = static_cast<float>(lattice_leniency) * of_place};
  if (!due(core.square, level)) return lot;
  const int own = std::ilogb(core.square / LatticeLevel(splitting_.sigma_max, 0).least());
  lot.level = static_cast<std::int8_t>(std::max(level, std::min(own, coarsest(distance))));
  return lot;
}

AdaptedBlob Laying::node(Vec2 at, double gamma, int level) const {
  const double square = LatticeLevel(splitting_.sigma_max, level).square;
  const bool coarsens = wall_ && !splitting_.coarsening.everywhere_alike();
  const float of_place = coarsens ? splitting_.coarsening.widening(wall_->distance(at)) : 1.0f;
  const int wide = level_of(of_place * faintness(gamma, square));
  return {at.x,
          at.y,
          gamma,
          square,
          {},
          no_wall,
          widening(of_place, wide),
          static_cast<float>(lattice_leniency) * of_place};
}

void Laying::append_free_nodes(Unwritten<AdaptedBlob>& all, std::span<const WideBlob> wide) const {
  if (wide.empty()) return;
  const std::vector<LatticeNode> nodes =
      lay_onto_lattice(wide, splitting_.sigma_max, strains() ? Shares::spline : Shares::nine);
  const std::size_t first = all.size();
  const std::ptrdiff_t n = std::ssize(nodes);
  all.resize(first + nodes.size());
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i)
    all[first + i] = node(nodes[i].at, nodes[i].gamma, nodes[i].level);
}

void Laying::append_nodes(AdaptedBlobs& adapted, const Blobs& blobs,
                          std::span<const std::int8_t> level, const WallPoints& nearest) const {
  const auto wide = tree::made_of<WideBlob>(
      tree::numbers_where(blobs.size(), [&](std::uint32_t i) { return level[i] >= 0; }),
      [&](std::uint32_t i) {
        return WideBlob{blobs.centre(i), blobs.gamma[i], blobs.core(i), level[i]};
      });
  append_free_nodes(adapted.all, wide);
  if (!wall_) return;
  const auto at_wall = tree::made_of<WideAtWall>(
      tree::numbers_where(blobs.size(), [&](std::uint32_t i) { return level[i] == along_wall; }),
      [&](std::uint32_t i) {
        return WideAtWall{blobs.centre(i), blobs.gamma[i], blobs.core(i), nearest.known(i)};
      });
  lay_along_wall(adapted, at_wall, wall_lattice_, *wall_);
}

}  // namespace vortree::vortex
