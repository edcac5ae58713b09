#pragma once

#include "flow/solver.hpp"
#include "tree/base/phase.hpp"
#include "vortex/health.hpp"
#include "vortex/setup.hpp"

namespace vortree::vortex {

/// A flow by vortex blobs. Beside a wall the start releases the sheet that cancels its slip.
///
/// columns   x, y, gamma, sigma and the velocities u, v
/// measures  of all flows: blobs; circulation of blobs, those that have left, and body; impulse_x,
///           impulse_y of blobs and sheet, per unit density; second_moment, sum gamma (|X - O|^2 +
///           sigma^2), O the body's centre, or that of the initial vorticity as the stream carries
///           it. Beside a wall (else 0): bubble_length in diameters; separation_deg from the rear;
///           both 0 where the body moves, and of several. In free space (else 0): quadrupole_*,
///           separation, circulation_plus, plus_*, plus the part that turns anticlockwise
///           (vortex/blobs/moments.hpp)
/// counts    released, laid, split, beside_wall, merged (vortex/step.hpp)
/// drift     beside a wall of the circulation, else of the second moment but for diffusion
/// table     wall.csv, number of the body if there are several, vorticity, sheet, C_p
///           (wall_pressure.hpp) and C_f, the traction along the anticlockwise tangent, of each
///           panel; or energy.csv of up to 20 000 blobs, for the sum is over all pairs
class VortexSolver final : public flow::Solver {
 public:
  explicit VortexSolver(Setup setup);

  std::string particle() const override { return "blob"; }
  std::vector<std::string> phases() const override { return {"convect", "wall", "split", "merge"}; }
  void step(const tree::Phase& phase) override;
  long steps() const override { return steps_; }
  double time() const override { return setup_.problem.time; }
  std::size_t particles() const override { return blobs_.size(); }
  flow::Columns columns() const override;
  flow::Measures measures() const override { return measures_; }
  flow::Measures counts() const override;
  std::optional<flow::Force> force() const override;
  std::vector<flow::Force> forces_on_each() const override;
  double drift() const override { return drift_; }
  flow::Samples sample(tree::Points at) const override;
  std::vector<double> stream_function(tree::Points at) const override;
  std::vector<double> pressure(tree::Points at) const override;
  flow::FrameTable frame_table() const override;
  std::vector<double> frame_rows() const override;
  flow::Closing closing() const override;
  void save(flow::State& state) const override;
  void restore(long steps, const flow::Columns& columns, const flow::State& state) override;

  const Blobs& blobs() const { return blobs_; }  ///< as seen from the origin of the setup

 private:
  const Wall* wall() const { return setup_.problem.wall; }
  const body::Shape* shape() const { return wall() ? &wall()->shape() : nullptr; }
  Vec2 origin() const { return setup_.origin.at(time()); }
  Turn axes_at(double time) const;
  /// Vectors as they are computed become those of the scene, moved by `by`, or the other way round.
  void to_scene(std::vector<double>& x, std::vector<double>& y, Vec2 by) const;
  void from_scene(std::vector<double>& x, std::vector<double>& y, Vec2 by) const;
  bool turns() const { return setup_.problem.flow.motion.turns(); }
  /// The scene's places are not, bit by bit, those of the blobs.
  bool told_elsewhere() const { return dot(origin(), origin()) > 0 || turns(); }
  flow::Force force_on(std::size_t body) const;
  Vec2 acceleration_of_centroid(std::size_t body) const;
  double moment_of_frame(std::size_t body) const;
  std::optional<Box> box_at(double time) const;
  double time_of(long step) const { return static_cast<double>(step) * setup_.problem.dt; }
  flow::Measures measure() const;
  double drift_now() const;
  double share_gone() const;
  void take(Wake wake);
  std::vector<double> pressure_slope() const;
  void restore_left(const flow::State& state);

  Setup setup_;
  Blobs blobs_;
  Wake wake_;
  std::vector<double> slope_before_;  // Wake::pressure_slope of the step before, if any
  Growth growth_;
  long steps_ = 0;
  flow::Measures measures_;
  double second_moment_at_start_ = 0, drift_ = 0;
};

}  // namespace vortree::vortex
