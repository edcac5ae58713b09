#pragma once

#include <memory>
#include <vector>

#include "body/bodies.hpp"
#include "flow/settings.hpp"
#include "flow/solver.hpp"

namespace vortree::flow {

/// Points that go with the fluid while a flow is computed, by the velocity that its Solver samples
/// at the beginning of each step (Adams and Bashforth; a point's first step is Euler's):
///
///   x(t + dt) = x(t) + dt (3/2 u(x, t) - 1/2 u'),   u' that of the step before
///
/// They change nothing of the flow. Velocity within a body is 0: what comes into it stays there.
/// Places are those of the scene, with a body that moves seen from its centre as at t = 0, as
/// pictures are.
/// error  O(dt^2), of each first step dt^2/2 of its acceleration (tests/flow/paths)
/// cost   a sample of the flow a step; nothing if there are none
class CarriedTracers {
 public:
  /// bodies  of the flow, as they stand at t = 0
  CarriedTracers(const std::vector<ReleaseSettings>& releases, const body::Bodies& bodies);

  bool none() const { return sets_.empty(); }

  /// Adds those that are due: once for each set that has come to a time of its own since `before`.
  /// before  the time a step ago; less than 0 at the start
  void release(double before, double now);

  /// Velocities at the beginning of a step; and the step, once the flow has made it.
  void sample(const Solver& solver);
  void carry(double dt);

  std::size_t size() const { return x_.size(); }
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }

  /// As `tracers x`, `tracers y` [L], `tracers set`, its number from 0 on, and `tracers from`, when
  /// it was released [T]; with what it takes to go on.
  void save(State& state) const;
  void restore(const State& state);

 private:
  struct Released {
    ReleaseSettings when;
    std::vector<double> x, y;  // around a body from its centre, in its axes
  };
  Vec2 place(const Released& set, std::size_t k, double now) const;

  body::Bodies bodies_;
  std::vector<Released> sets_;
  std::vector<double> x_, y_, set_, from_;
  std::vector<double> before_u_, before_v_;  // of the step before; of new ones never read
  std::vector<double> steps_;                // that each has made
  Samples now_;
};

}  // namespace vortree::flow
