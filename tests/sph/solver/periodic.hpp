#pragma once

#include <string>

#include "sph/solver/scene.hpp"

namespace vortree::sph::test {

/// Vortices of Taylor and Green in the unit square, Re = 100, n particles a side, to t = 0.5; with
/// degree 4 in steps half as long, whose errors are then those of space.
inline SphScene vortices(int n, int degree = 2) {
  SphScene scene;
  scene.of.flow = {.nu = 0.01, .stream = {0, 0}};
  scene.of.body.reset();
  scene.of.initial.emplace();
  scene.of.initial->kind = &flow::initial_flow("taylor_green");
  scene.of.initial->numbers.at("wavelength") = 1;
  scene.of.time.end = 0.5;
  scene.set("outside", Outside::periodic).set("degree", degree);
  return scene.set("spacing", 1.0 / n).set("courant", degree > 2 ? 0.1 : 0.2);
}

/// The same with particles half as wide in a disc in their midst.
inline SphScene finer_in_disc(int n, int degree = 2) {
  return vortices(n, degree).region({0.5, 0.5}, {0.25, 0.25}, 0.5 / n);
}

}  // namespace vortree::sph::test
