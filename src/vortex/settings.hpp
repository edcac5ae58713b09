#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "base/keys.hpp"
#include "flow/case.hpp"
#include "fmm/options.hpp"
#include "vortex/adapt/split_scheme.hpp"
#include "vortex/transport/diffusion.hpp"

// The tables of a scene that belong to the vortex method.

namespace vortree::vortex {

/// The core of a pair: the mean of both; that of the source; or the mean, with which each blob
/// moves as the mean over its own core does (Problem::advecting_cores).
enum class PairCores { mean, source, both };

}  // namespace vortree::vortex

namespace vortree {

template <>
inline constexpr std::array<std::string_view, 3> words_of<vortex::Diffusion>{
    "core_spreading", "random_walk", "particle_exchange"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<vortex::SplitScheme>{"ring", "lattice"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<vortex::PairCores>{"mean", "source",
                                                                             "both"};
template <>
inline constexpr std::array<std::string_view, 3> words_of<fmm::SumMethod>{"fmm", "boxes", "direct"};
template <>
inline constexpr std::array<std::string_view, 2> words_of<fmm::Builder>{"reverse", "forward"};

}  // namespace vortree

namespace vortree::vortex {

/// sigma_0: core of a blob released at the wall, or of an initial blob. A blob wider than sigma_max
/// splits; further than coarsen_from from the body cores, and the tolerance of mergers, may be
/// (distance/coarsen_from)^(3/4) times as wide (vortex/adapt/coarsening.hpp).
struct CoreSettings {
  double sigma_0 = 0;
  double sigma_max = 0;
  std::optional<double> coarsen_from{};
  bool operator==(const CoreSettings&) const = default;
};

/// A child has core alpha sigma; `children` of them stand on a ring. Away from the body wide blobs
/// split by either scheme.
struct SplittingSettings {
  SplitScheme scheme = SplitScheme::lattice;
  double alpha = 0.7;
  int children = 4;
  bool operator==(const SplittingSettings&) const = default;
};

/// tolerance 0: blobs never merge. reach is in cores; merged sigma^2 <= cap sigma_max^2. Blobs that
/// leave the box [x0, y0, x1, y1] are taken away and accounted for (vortex/blobs/outflow.hpp);
/// beside a body they drift on and are felt (vortex/blobs/drifting.hpp).
struct MergingSettings {
  double tolerance = 0.02;
  double reach = 2;
  double cap = 1.1;
  std::optional<std::array<double, 4>> box{};
  bool operator==(const MergingSettings&) const = default;
};

/// core_spreading: wider cores, split and merged; random_walk and particle_exchange: cores stay as
/// they are, in free space only.
struct DiffusionSettings {
  Diffusion kind = Diffusion::core_spreading;
  bool operator==(const DiffusionSettings&) const = default;
};

/// order 0: from the tolerance. capacity 0: chosen by the evaluator.
struct VelocitySettings {
  fmm::SumMethod method = fmm::SumMethod::fmm;
  double tolerance = 1e-6;
  int order = 0;
  int capacity = 0;
  int finest_level = 31;
  fmm::Builder builder = fmm::Builder::reverse;
  PairCores cores = PairCores::mean;
  bool operator==(const VelocitySettings&) const = default;
};

/// Their keys, in the order in which they are read and printed.
[[nodiscard]] std::vector<Key> keys(CoreSettings&);
[[nodiscard]] std::vector<Key> keys(SplittingSettings&);
[[nodiscard]] std::vector<Key> keys(MergingSettings&);
[[nodiscard]] std::vector<Key> keys(DiffusionSettings&);
[[nodiscard]] std::vector<Key> keys(VelocitySettings&);

/// All tables that the method brings to a scene.
struct VortexSettings {
  DiffusionSettings diffusion{};
  CoreSettings cores{};
  SplittingSettings splitting{};
  MergingSettings merging{};
  VelocitySettings velocity{};
};
[[nodiscard]] std::vector<SceneTable> tables(VortexSettings&);

/// A scene as the method sees it: what it says of the flow, and the method's own tables.
struct VortexCase : flow::Case, VortexSettings {};

}  // namespace vortree::vortex
