#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fmm/geometry/leaves.hpp"
#include "fmm/mutual/mutual_core_kernel.hpp"
#include "fmm/sources.hpp"
#include "tree/base/memory.hpp"

namespace vortree::fmm {

/// Near sums of blobs: the points of one childless cell after the other with vectors of points of
/// the runs that it meets. Every vector is taken as it is found: without cores if none shows in it,
/// and in single precision if that is exact enough.
///
/// single precision: coordinates are taken from the middle of the cell, in lengths of its smallest
/// core. An error of 2^-24 of the extent there moves a vortex of core S by that much of its largest
/// velocity over sqrt(S), so cores must be wide, extent^2 <= 256 S, for an error of 2^-24 times a
/// few, relative to the sum of |gamma_j| / sqrt(S_j). Where no core shows, at distances r of
/// several sqrt(S), the same error of place changes a velocity by extent/r of 2^-24 only: there
/// extents may be four times as large. Slopes err as much relative to the sum of |gamma_j| / S_j.
///
/// sums   velocity_sums, or slope_sums
template <std::size_t sums>
class MutualCores {
 public:
  /// reach2   a core S shows up to a gap of sqrt(reach2 S)
  /// coarse   single precision will do
  MutualCores(const Leaves& leaves, Cores cores, double reach2, bool coarse);

  /// Adds to the sums (times 2 pi, in the places of leaves) all pairs of a childless cell and the
  /// runs: both ways where the others are in the run of leaves; those in the run of leaves before
  /// the cell are left out, since they have met it.
  ///
  /// runs   of places, in whole vectors, ascending, disjoint
  using Sums = std::array<double*, sums>;
  void add(std::uint32_t leaf, tree::Range leaf_run, std::span<const tree::Range> runs,
           const Sums& to);

 private:
  /// The points of the cell, x = (position - x0)/length, from when they are first asked for.
  template <class Number>
  struct Room {
    bool open = false;
    double x0 = 0, y0 = 0, per_length = 1;
    Unwritten<Number> x, y, gamma, core;
    std::array<Unwritten<typename VectorOf<Number>::Type>, sums> sum;

    /// A sum is of 1/length, or of 1/length^2.
    [[nodiscard]] double scale(std::size_t s) const {
      return s < velocity_sums ? per_length : per_length * per_length;
    }
  };
  /// Of some vectors of points: does a core show between them and the cell, and is single precision
  /// exact enough?
  struct Look {
    bool shows, single;
  };

  void take(std::uint32_t leaf);
  template <class Number>
  void fill_room(Room<Number>& room) const;
  template <class Number>
  void empty_room(Room<Number>& room, const Sums& to) const;
  [[nodiscard]] Look look(std::uint32_t first, std::uint32_t count, bool both) const;
  template <bool both>
  void meet(tree::Range places, const Sums& to);
  void meet_itself(const Sums& to);
  template <bool both, class Number>
  void meet_some(Room<Number>& room, tree::Range points, std::uint32_t first, std::uint32_t count,
                 bool shows, const Sums& to) const;

  const Leaves& leaves_;
  Cores cores_;
  double reach2_;
  bool coarse_;

  std::uint32_t first_ = 0, size_ = 0;  // places of the cell
  double x_ = 0, y_ = 0, half_x_ = 0, half_y_ = 0, least_ = 0, widest_ = 0;
  bool fits_ = false, fits_bare_ = false;  // the cell in single precision; where no core shows
  Room<double> room_;
  Room<float> single_;
};

}  // namespace vortree::fmm
