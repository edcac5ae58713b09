#pragma once

#include <cmath>
#include <numbers>

#include "base/vec2.hpp"

namespace vortree::body {

/// A body that moves to and fro without turning: its place at time t, and what follows from it.
///
///   X(t) = amplitude cos(2 pi frequency t)
///
/// A flow around it is computed in the frame of the body, which stands still there in the stream
/// U - dX/dt. That frame does not turn, so that vorticity obeys the same equation; the force which
/// drives the fluid with the frame, -d2X/dt2 per mass, has a potential and only changes the
/// pressure: the body feels by the area A (per unit density, in two dimensions) times d2X/dt2 more
/// than in its own frame,
///
///   F = F of the frame + A d2X/dt2.
struct Plunge {
  Vec2 amplitude;
  double frequency = 0;

  Vec2 place(double t) const { return std::cos(omega() * t) * amplitude; }
  Vec2 velocity(double t) const { return (-omega() * std::sin(omega() * t)) * amplitude; }
  Vec2 acceleration(double t) const { return (-omega() * omega()) * place(t); }

  double omega() const { return 2 * std::numbers::pi * frequency; }
};

/// A circle that turns about its centre at a steady rate, from t = 0 on.
///
/// Its outline stays where it is, and only friction tells the fluid of it: the wall moves with
/// Omega R along itself. Within, the body turns as a vortex of vorticity 2 Omega would; outside,
/// that one is the circulation
///
///   2 Omega A
///
/// at the centre (A the body's area), whose velocity along the wall is the wall's own. So a sheet
/// at the wall has to cancel no more slip than on a body at rest, but the circulation of the fluid
/// is that of the body with the other sign.
struct Spin {
  double rate = 0;  ///< Omega, anticlockwise [1/s]

  double circulation(double area) const { return 2 * rate * area; }
};

}  // namespace vortree::body
