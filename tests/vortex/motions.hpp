#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include "flow/force_history.hpp"
#include "vortex/solver.hpp"

namespace vortree::test {

using OfTime = std::function<double(double)>;

inline double still(double) {
  return 0;
}

/// A motion until t = 1, by functions of time.
inline body::Course course(const OfTime& x, const OfTime& y, const OfTime& angle, Vec2 about = {}) {
  const int steps = 1000;
  std::vector<double> t;
  std::array<std::vector<double>, 3> values;
  for (int i = 0; i <= steps; ++i) {
    t.push_back(static_cast<double>(i) / steps);
    values[0].push_back(x(t.back()));
    values[1].push_back(y(t.back()));
    values[2].push_back(angle(t.back()));
  }
  std::array<body::Jets, 3> jets;
  for (int k = 0; k < 3; ++k) jets[k] = body::known_evenly(values[k], 1.0 / steps);
  return {t, jets, about};
}

/// What a run tells after each of some steps, but for the last.
struct Told {
  std::vector<double> cd_impulse, cl_impulse, cd_wall, cl_wall;
};

inline Told told(vortex::Setup setup, int steps) {
  flow::ForceHistory history(setup.scales);
  vortex::VortexSolver solver(std::move(setup));
  history.add(*solver.force());
  Told rows;
  for (int k = 0; k < steps; ++k) {
    solver.step([](std::string_view) {});
    history.add(*solver.force());
    if (history.size() < 3) continue;
    const flow::Measures now = history.of_last_but_one();
    rows.cd_impulse.push_back(flow::measured(now, "cd_impulse"));
    rows.cl_impulse.push_back(flow::measured(now, "cl_impulse"));
    rows.cd_wall.push_back(flow::measured(now, "cd_wall"));
    rows.cl_wall.push_back(flow::measured(now, "cl_wall"));
    CHECK(std::abs(flow::measured(solver.measures(), "circulation")) < 1e-12);
  }
  return rows;
}

inline double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

inline double apart(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  std::vector<double> off;
  for (std::size_t i = 0; i < a.size(); ++i) off.push_back(a[i] - b[i]);
  return largest(off);
}

}  // namespace vortree::test
