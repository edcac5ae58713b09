#pragma once

#include <deque>
#include <string>

#include "vortex/setup.hpp"

namespace vortree::vortex {

/// How many blobs there were after the steps of late, and how many there may be after the next.
class Growth {
 public:
  /// After each step, and at the start.
  void add(std::size_t blobs);

  /// More multiply faster than they merge: three times as many as before the step and more than
  /// 20 000, or as five steps before and more than 5000 (flows that went well had 1.9 times as
  /// many). In the first ten steps beside a wall, of substeps, 100 for each panel besides, and in
  /// the first of them 1000 a panel, at least 150 000: there the sheet of the start, in pieces as
  /// long as a panel, splits until its pieces are round and faint enough to merge, 40 a panel as a
  /// rule. Starts that went well, and had the usual number and drag soon after, had up to 597 a
  /// panel, all of it split five times, and 143 000 in all; in others nothing had merged at 2370 a
  /// panel. In free space, where all may split at once, what two splits of all leave, unless
  /// the children are too wide to merge; where all are laid onto lattices, nine nodes of each. All
  /// the numbers as many times larger as the merging tolerance leaves more blobs than usual. Never
  /// more than the machine's memory holds, or 2e7, minutes a step.
  std::size_t most(double time, const Setup& setup) const;

 private:
  std::deque<std::size_t> counts_;  // six at most, the oldest first
};

/// What would keep blobs fewer, in words. It depends on whether children are too wide to merge, or
/// nearly so: wider squared than half the square of what mergers may leave.
std::string remedy(const Setup& setup);

/// Why a run cannot go on with so many, in words.
std::string multiplied(std::size_t blobs, std::size_t before, const Setup& setup);

/// Why a run cannot go on from these blobs, in words, or nothing:
///
/// - a number that is not finite
/// - beside a body, sum |gamma| beyond 100 U D (and more for each ten diameters of way). An
///   impulsive start has 4 U D, and a wake gains less than 1 U D a diameter
std::string broken(const Blobs& blobs, const Setup& setup, double time);

}  // namespace vortree::vortex
