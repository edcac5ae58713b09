#pragma once

#include <cmath>

namespace vortree::body {

/// A function of one variable and its first two derivatives.
struct Jet {
  double value = 0, first = 0, second = 0;

  friend Jet operator+(const Jet& a, const Jet& b) {
    return {a.value + b.value, a.first + b.first, a.second + b.second};
  }
  friend Jet operator-(const Jet& a, const Jet& b) { return a + -1 * b; }
  friend Jet operator*(double s, const Jet& a) { return {s * a.value, s * a.first, s * a.second}; }
  friend Jet operator*(const Jet& a, const Jet& b) {
    return {a.value * b.value, a.first * b.value + a.value * b.first,
            a.second * b.value + 2 * a.first * b.first + a.value * b.second};
  }
};

/// f(g(t)).
inline Jet composed(const Jet& f, const Jet& g) {
  return {f.value, f.first * g.first, f.second * g.first * g.first + f.first * g.second};
}

}  // namespace vortree::body
