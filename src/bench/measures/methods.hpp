#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "fmm/plan.hpp"
#include "fmm/sources.hpp"
#include "tree/base/phase.hpp"

namespace vortree::bench {

/// Velocities that are asked for: at the blobs themselves, or elsewhere.
struct VelocitySum {
  fmm::Sources blobs;
  fmm::Targets targets;  // those of the blobs, if not elsewhere
  bool elsewhere = false;
  std::span<double> u, v;  // as many as targets; overwritten
};

/// What a method says of its work; nothing where it has no such thing.
struct Account {
  std::optional<std::string_view> builder;
  std::optional<double> tolerance;
  std::optional<int> order;
  std::optional<fmm::Work> work;
};

/// repeated   one of many sums in this process: what pays only then may be done first
/// counted    the account shall hold the work, where that is not known anyway
struct Use {
  bool repeated = false, counted = true;
};

/// A way to sum.
///
/// name     on the command line
/// bare     it serves bare vortices too
/// exact    it knows no tolerance
/// throws   std::invalid_argument for blobs or options that it does not serve
struct VelocityMethod {
  std::string_view name;
  bool bare, exact;
  Account (*sum)(const VelocitySum& sum, const fmm::Options& options, const tree::Phase& phase,
                 Use use);
};

/// Every method, best first.
std::span<const VelocityMethod> methods();

}  // namespace vortree::bench
