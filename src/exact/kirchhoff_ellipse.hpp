#pragma once

namespace vortree::exact {

/// Kirchhoff's elliptic vortex (1876): uniform vorticity omega within an ellipse of half axes a and
/// b turns as it is, without change of form, at
///
///   rate = omega a b/(a + b)^2     [1/s], anticlockwise for omega > 0
///
/// Stable while a < 3 b (Love 1893).
struct KirchhoffEllipse {
  double gamma;  ///< circulation, omega pi a b [m^2/s]
  double a, b;   ///< half axes [m]

  double vorticity() const;
  double rate() const;
};

}  // namespace vortree::exact
