#pragma once

#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "flow/columns.hpp"
#include "flow/measures.hpp"
#include "flow/scales.hpp"

namespace vortree::flow {

/// What one body feels at a time, per unit density, from two routes that share nothing but the
/// vorticity:
///
/// impulse   of the fluid [L^3/T]; the body feels minus its rate of change
/// pressure  mean force since the time before [L^3/T^2]
/// friction  at this time
/// frame     what both miss where the flow is computed in the frame of a body that speeds up
///           (body/motion.hpp)
/// *_moment  of the last three about the body's centre, anticlockwise [L^4/T^2]
struct Force {
  double t = 0;
  Vec2 impulse{}, pressure{}, friction{}, frame{};
  double pressure_moment = 0, friction_moment = 0, frame_moment = 0;
};

/// Forces of late, and what follows from them: a force is a rate of change, and needs its neighbors
/// in time.
///
///   C_D(t_n) = 2/(U^2 D) F_n,   F by impulse = -dP/dt
///                               F by the wall = d/dt(what pressure has given) + friction at t_n
///   C_M(t_n) = 2/(U^2 D^2) M_n, by the wall
///
/// The wall's drag and lift have two parts: friction, and pressure with what the frame hides.
///
/// by the parabola in sqrt(t) through three, the last of a run by that which fits the last four
/// best (base/rate_of_change.hpp), O(dt^2).
class ForceHistory {
 public:
  explicit ForceHistory(const Scales& scales) : scales_(scales) {}

  void add(const Force& force);

  /// How many are known, four at most.
  std::size_t size() const { return recent_.size(); }

  /// cd_impulse, cd_wall, cl_impulse, cl_wall, then cd_pressure, cd_friction, cl_pressure,
  /// cl_friction and cm_wall of the last but one; three must be known.
  Measures of_last_but_one() const;

  /// The same of the last, when no other will come; two must be known.
  Measures of_last() const;

  /// Of these, what is told of one of several bodies, by the wall alone, under names that end with
  /// its number from 1 on: cd_wall_1, cl_wall_1, cd_pressure_1, ..., cm_wall_1.
  static Measures of_body(const Measures& all, std::size_t number);

  /// The same names with values of 0; for flows without a body the first four.
  static Measures none(bool body);

  /// What tells the history of one of several bodies apart where it is saved; counted from 0.
  static std::string named(std::size_t body);

  /// body  a name of that kind, or none of all together
  void save(State& state, const std::string& body = "") const;
  void restore(const State& state, const std::string& body = "");

 private:
  static constexpr std::size_t most = 4;

  Scales scales_;
  std::vector<Force> recent_;  // the oldest first
};

}  // namespace vortree::flow
