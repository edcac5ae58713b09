#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "io/scene/scene.hpp"
#include "vortex/step.hpp"

namespace vortree::flow {

/// More blobs are followed nowhere: a step takes minutes.
inline constexpr std::size_t most_blobs = 20'000'000;

/// From where positions are counted while a flow is computed: the centre of the body, or that of
/// the initial vorticity, which goes with the stream in free space. Round-off is then that of the
/// flow's own extent, wherever it lies.
struct Origin {
  Vec2 start{}, drift{};

  Vec2 at(double t) const { return start + t * drift; }
};

/// A column of coordinates, each moved by so much; bit for bit itself for 0.
std::vector<double> moved(std::vector<double> column, double by);

/// A scene made into what the solver works on; owns what the Problem points at. The problem, its
/// wall and all blobs are as seen from `origin`; what a run writes is as seen from the scene's.
struct FlowCase {
  std::unique_ptr<vortex::Wall> wall;  // none in free space
  vortex::Problem problem;
  Origin origin;
  std::optional<vortex::Box> box;       // of [merging], in the scene
  std::size_t held_blobs = most_blobs;  // by the machine's memory
  double crowding = 1;                  // io::crowding: how many times the usual number of blobs
  bool splits_endlessly = false;        // children are too wide to merge

  /// For a step from the problem's time to this one.
  void step_to(double time);

  /// Lengths and speeds that make coefficients: D and U (of the stream or, without one, the
  /// greatest of the plunge). Without a body, or without both, they are 1.
  double diameter = 1, speed = 1;

  /// Where drag points to: down the stream; without one, the way of the plunge, or x.
  Vec2 along{1, 0};
};

FlowCase flow_case(const io::Scene& scene);

/// The vorticity at t = 0, before any wall has released its sheet, as seen from the flow's origin.
vortex::Blobs initial_blobs(const io::Scene& scene);

}  // namespace vortree::flow
