#pragma once

#include <cmath>
#include <numbers>

#include "base/vec2.hpp"
#include "body/course.hpp"

namespace vortree::body {

/// A body that moves to and fro without turning: its place at time t, and what follows from it.
///
///   X(t) = amplitude cos(2 pi frequency t)
struct Plunge {
  Vec2 amplitude;
  double frequency = 0;

  Vec2 place(double t) const { return std::cos(omega() * t) * amplitude; }
  Vec2 velocity(double t) const { return (-omega() * std::sin(omega() * t)) * amplitude; }
  Vec2 acceleration(double t) const { return (-omega() * omega()) * place(t); }

  double omega() const { return 2 * std::numbers::pi * frequency; }
};

/// A circle that turns about its centre at a steady rate, from t = 0 on. Its outline stays where it
/// is: only friction tells the fluid of it.
struct Spin {
  double rate = 0;  ///< Omega, anticlockwise [1/T]
};

/// How a body moves, by all that a scene says of it.
///
/// A flow around it is computed in the frame of its centre, X(t), where it stands in the stream
/// U - dX/dt. That frame does not turn, so that vorticity obeys the same equation; the force which
/// drives the fluid with the frame, -d2X/dt2 per mass, has a potential and only changes the
/// pressure: the body feels by the area A (per unit density, in two dimensions) times d2X/dt2 more
/// than in its own frame,
///
///   F = F of the frame + A d2X/dt2.
///
/// A body that turns at the rate Omega turns as a vortex of vorticity 2 Omega would. So a sheet at
/// the wall has to cancel what fluid slips there beyond Omega x, and the circulation of the fluid
/// is that of the body, 2 Omega A, with the other sign.
struct Motion {
  Plunge plunge{};
  Spin spin{};
  Course course{};

  Kinematics at(double t) const {
    Kinematics now = course.at(t);
    if (plunge.frequency > 0) {
      now.place += plunge.place(t);
      now.velocity += plunge.velocity(t);
      now.acceleration += plunge.acceleration(t);
    }
    now.angle += spin.rate * t;
    now.rate += spin.rate;
    return now;
  }

  bool moves() const { return plunge.frequency > 0 || spin.rate != 0 || course.moves(); }
  bool travels() const { return plunge.frequency > 0 || course.moves(); }
  bool turns() const { return spin.rate != 0 || course.turns(); }
};

}  // namespace vortree::body
