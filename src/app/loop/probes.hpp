#pragma once

#include <string>
#include <vector>

#include "flow/solver.hpp"
#include "io/scene/scene.hpp"

namespace vortree::app {

/// The rows of probes.csv, as [[probe]] of a scene asks for them: velocity and vorticity at its
/// places, from the start on; both are 0 within a body, as in pictures.
///
/// cost  one velocity at all places that are due, by Solver::sample; nothing without any
class Probes {
 public:
  explicit Probes(const io::Scene& scene);

  /// t, probe (the number of its table, from 1 on), x, y, u, v, omega; none of a scene without.
  std::vector<std::string> names() const;

  /// Those of a step, one after another, in the order of the scene.
  std::vector<double> rows(const flow::Solver& solver) const;

 private:
  struct Probe {
    std::vector<double> x, y;
    double every;  // in steps
  };

  std::vector<Probe> probes_;
};

}  // namespace vortree::app
