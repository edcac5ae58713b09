#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "fmm/blobs.hpp"
#include "fmm/plan.hpp"

namespace vortree::bench {

/// Velocities that are asked for: at the blobs themselves, or elsewhere.
struct Sum {
  fmm::Blobs blobs;
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

/// Told the name of a part of the work as it begins, and "" when the sum is done.
using Phase = std::function<void(std::string_view)>;

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
struct Method {
  std::string_view name;
  bool bare, exact;
  Account (*sum)(const Sum& sum, const fmm::Options& options, const Phase& phase, Use use);
};

/// Every method, best first.
std::span<const Method> methods();

}  // namespace vortree::bench
