#include "app/loop/probes.hpp"

#include <cmath>

namespace vortree::app {
namespace {

/// Whether a step is the one nearest to a multiple of `every` steps.
bool due(long step, double every) {
  const auto now = static_cast<double>(step);
  return std::round(std::round(now / every) * every) == now;
}

}  // namespace

Probes::Probes(const io::Scene& scene) {
  for (const flow::ProbeSettings& asked : scene.probes) {
    Probe probe{{}, {}, asked.every.value_or(scene.time.dt) / scene.time.dt};
    for (const auto& [x, y] : asked.places()) {
      probe.x.push_back(x);
      probe.y.push_back(y);
    }
    probes_.push_back(std::move(probe));
  }
}

std::vector<std::string> Probes::names() const {
  if (probes_.empty()) return {};
  return {"t", "probe", "x", "y", "u", "v", "omega"};
}

std::vector<double> Probes::rows(const flow::Solver& solver) const {
  std::vector<double> number, x, y, rows;
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    if (!due(solver.steps(), probes_[i].every)) continue;
    x.insert(x.end(), probes_[i].x.begin(), probes_[i].x.end());
    y.insert(y.end(), probes_[i].y.begin(), probes_[i].y.end());
    number.resize(x.size(), static_cast<double>(i + 1));
  }
  if (x.empty()) return {};
  const flow::Samples found = solver.sample({x, y});
  for (std::size_t k = 0; k < x.size(); ++k)
    rows.insert(rows.end(),
                {solver.time(), number[k], x[k], y[k], found.u[k], found.v[k], found.omega[k]});
  return rows;
}

}  // namespace vortree::app
