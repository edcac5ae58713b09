#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "flow/columns.hpp"
#include "flow/force_history.hpp"
#include "flow/measures.hpp"
#include "tree/base/phase.hpp"
#include "tree/order/points.hpp"

namespace vortree::flow {

/// More particles are followed nowhere: a step takes minutes.
inline constexpr std::size_t most_particles = 20'000'000;

/// Why a flow cannot go on, in words for the user.
struct Diverged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A flow at some points: velocity [L/T] and vorticity [1/T], a value a point.
struct Samples {
  std::vector<double> u, v, omega;
};

/// A table of its own that a method keeps beside report.csv: some rows with every frame.
struct FrameTable {
  std::string name;
  std::vector<std::string> columns;
};

/// What a method says of a run that has ended: numbers for summary.json (a dot in a name parts
/// table and key), and a line for the user or none.
struct Closing {
  Measures numbers;
  std::string words;
};

/// A method at work on a flow: particles, and how they move. Whatever a flow has no matter what
/// moves it (time loop, frames, report, coefficients, pictures, checks) stands outside and knows no
/// more of a method than this.
///
/// Made with the flow at t = 0. Positions and velocities that go in and out are those of the scene.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  /// What one particle is called, and the phases of a step.
  virtual std::string particle() const = 0;
  virtual std::vector<std::string> phases() const = 0;

  /// One step of dt.
  ///
  /// phase   told the phases of this step, and "output" for what is measured at its end
  /// throws  Diverged with a reason; the flow then is what it was before the step
  virtual void step(const tree::Phase& phase) = 0;

  virtual long steps() const = 0;   ///< done so far
  virtual double time() const = 0;  ///< steps dt [T]
  virtual std::size_t particles() const = 0;

  /// The particles as frames show them; x and y among them, u and v if they have velocities.
  virtual Columns columns() const = 0;

  /// What is measured after each step, the number of particles first, under their name. Names and
  /// order never change on the way.
  virtual Measures measures() const = 0;

  /// What the last step has done to how many particles, by name, as far as the method counts it; 0
  /// of a flow that has not moved since it was made or restored.
  virtual Measures counts() const { return {}; }

  /// What the body feels, or all bodies together; none without one.
  virtual std::optional<Force> force() const = 0;

  /// What each of several bodies feels, without the impulse of the fluid; none of a single one.
  virtual std::vector<Force> forces_on_each() const { return {}; }

  /// The route by which coefficients are told, "impulse" or "wall"; the other is a check.
  virtual std::string route() const { return "impulse"; }

  /// Largest relative change so far of what the flow should keep.
  virtual double drift() const = 0;

  /// Velocity and vorticity at points; both 0 within a body.
  virtual Samples sample(tree::Points at) const = 0;

  /// Stream function [L^2/T] of that velocity, u = d psi/dy, v = -d psi/dx; its mean along a wall
  /// is 0, and within a body that turns it is the body's own. Empty of methods that tell none.
  virtual std::vector<double> stream_function(tree::Points) const { return {}; }

  /// Pressure per unit density [L^2/T^2] at points beyond that far away, in a frame at rest; 0
  /// within a body. Empty of a body just set off at once, and of methods that tell none.
  virtual std::vector<double> pressure(tree::Points) const { return {}; }

  virtual FrameTable frame_table() const = 0;
  virtual std::vector<double> frame_rows() const = 0;  ///< of the flow as it is, one after another

  virtual Closing closing() const { return {}; }

  /// What `restore` needs beside the columns, to go on to the same bits.
  virtual void save(State& state) const = 0;

  /// The flow after `steps` steps. throws std::out_of_range with the name of what is missing
  virtual void restore(long steps, const Columns& columns, const State& state) = 0;
};

/// Which column has a number that is not finite, in words, or nothing.
std::string not_finite(const Columns& columns, std::string_view particle);

}  // namespace vortree::flow
