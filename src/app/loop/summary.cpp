#include "app/loop/summary.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/install_paths.hpp"
#include "app/json.hpp"
#include "base/memory.hpp"
#include "io/tables/table.hpp"

namespace vortree::app {

namespace {

/// Indented and with a line end. Signs beyond ASCII are escaped, so that a title harms no terminal,
/// and a path need not be UTF-8.
std::string page(const Json& json) {
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + '\n';
}

/// Whether all that was reached has passed; null where nothing was.
Json check(std::span<const checks::Verdict> verdicts) {
  Json json;
  const bool missed = std::ranges::any_of(verdicts, &checks::Verdict::missed);
  const bool none = std::ranges::none_of(verdicts, &checks::Verdict::passed) && !verdicts.empty();
  json["passed"] = !missed && none ? Json() : Json(!missed);
  for (const checks::Verdict& v : verdicts) {
    Json& one = json[v.what];
    one["asked"] = v.asked;
    one["reached"] = v.reached.value ? Json(*v.reached.value) : Json();
    one["passed"] = v.reached.value ? Json(v.passed()) : Json();
    one["status"] = v.passed() ? "passed" : v.missed() ? "missed" : "not reached";
    if (!v.reached.value) one["why"] = v.reached.why;
  }
  return json;
}

}  // namespace

void Totals::save(flow::State& state) const {
  state["total particle_steps"] = {particle_steps};
  state["total most_particles"] = {most_particles};
  state["total seconds"] = {seconds};
  state["total processor_seconds"] = {processor_seconds};
}

void Totals::restore(const flow::State& state) {
  particle_steps = flow::saved_number(state, "total particle_steps");
  most_particles = flow::saved_number(state, "total most_particles");
  seconds = flow::saved_number(state, "total seconds");
  processor_seconds = flow::saved_number(state, "total processor_seconds");
}

std::string summary(const io::Scene& scene, const std::filesystem::path& folder,
                    const flow::Solver& solver, std::span<const std::string> phases,
                    const Totals& totals, std::span<const checks::Verdict> verdicts) {
  Json json;
  json["scene"] = scene.origin.path.string();
  json["title"] = scene.title;
  json["version"] = version();
  json["threads"] = omp_get_max_threads();
  json["method"] = scene.method;
  json["steps"] = solver.steps();
  json[solver.particle() + "s"] = solver.particles();
  json["largest_" + solver.particle() + "_count"] = std::llround(totals.most_particles);
  json["particle_steps"] = std::llround(totals.particle_steps);
  json["particle_steps_per_second"] = totals.particle_steps / totals.seconds;
  json["processor_seconds"] = totals.processor_seconds;
  json["peak_bytes"] = peak_bytes();
  json["largest_drift"] = solver.drift();
  json["seconds"]["total"] = totals.seconds;
  const io::Table report(folder / "report.csv");
  for (const std::string& phase : phases) {
    const auto laps = report.column("seconds_" + phase);
    json["seconds"][phase] = std::accumulate(laps.begin(), laps.end(), 0.0);
  }
  json["check"] = check(verdicts);
  for (const flow::Measure& number : solver.closing().numbers) {
    const std::size_t dot = number.name.find('.');
    json[number.name.substr(0, dot)][number.name.substr(dot + 1)] = number.value;
  }
  return page(json);
}

}  // namespace vortree::app
