#include "app/loop/summary.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "app/install_paths.hpp"
#include "app/json.hpp"
#include "base/memory.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"
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

checks::Verdict verdict_in(const std::string& what, const Json& one) {
  checks::Verdict verdict{what, one.at("asked"), {}};
  const Json& value = one.at("reached");
  if (!value.is_null())
    verdict.reached.value = value.get<double>();
  else if (one.at("status") == "missed")
    verdict.reached.value = std::numeric_limits<double>::quiet_NaN();
  else
    verdict.reached.why = one.at("why");
  return verdict;
}

/// The numbers that a count of particles was, by whatever name.
double largest_count(const Json& json) {
  for (const auto& [name, value] : json.items())
    if (name.starts_with("largest_") && name.ends_with("_count")) return value;
  throw Json::other_error::create(500, "no largest count", &json);
}

RunResult result_of(const Json& json) {
  RunResult result{.finished = true,
                   .steps = json.at("steps"),
                   .most_particles = largest_count(json),
                   .particle_steps = json.at("particle_steps"),
                   .seconds = json.at("seconds").at("total"),
                   .processor_seconds = json.at("processor_seconds"),
                   .threads = json.at("threads")};
  for (const auto& [name, words] : json.at("provenance").items())
    result.origin.push_back(name + ": " + words.get<std::string>());
  for (const auto& [name, one] : json.at("check").items())
    if (name != "passed") result.verdicts.push_back(verdict_in(name, one));
  return result;
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
                    const Totals& totals, std::span<const std::string> origin,
                    std::span<const checks::Verdict> verdicts) {
  Json json;
  json["scene"] = scene.origin.path.string();
  json["title"] = scene.title;
  json["version"] = version();
  json["threads"] = omp_get_max_threads();
  json["method"] = scene.method;
  for (const std::string& line : origin) {
    const std::size_t colon = line.find(": ");
    json["provenance"][line.substr(0, colon)] = line.substr(colon + 2);
  }
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

std::optional<RunResult> result_in(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "summary.json";
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  try {
    return result_of(Json::parse(io::read_text(file)));
  } catch (const Json::exception&) {
    throw io::InputError(fmt::format(
        "{}: is damaged, or of an earlier version; the run with --resume writes it again",
        file.string()));
  }
}

}  // namespace vortree::app
