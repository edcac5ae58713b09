#include "app/commands/velocity.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "app/commands/sums/origin.hpp"
#include "app/commands/sums/velocity_problem.hpp"
#include "app/json.hpp"
#include "app/say.hpp"
#include "base/clock.hpp"
#include "base/free_memory.hpp"
#include "base/memory.hpp"
#include "bench/measures/accuracy.hpp"
#include "bench/measures/methods.hpp"
#include "io/files.hpp"
#include "io/quote.hpp"
#include "io/tables/particles.hpp"
#include "tree/order/points.hpp"
#include "vortex/choice/warnings_of_means.hpp"

namespace vortree::app {
namespace {

void check_quantities(const VelocityJob& job) {
  if (job.verify && !asks_for_velocity(job))
    throw std::invalid_argument("--verify is for velocities; --what does not ask for them");
  if (job.method == "grid" && job.what != "velocity")
    throw std::invalid_argument("--method grid sums velocities alone");
}

const bench::VelocityMethod& method_named(std::string_view name) {
  const auto found = std::ranges::find(bench::methods(), name, &bench::VelocityMethod::name);
  if (found != bench::methods().end()) return *found;
  throw std::invalid_argument("no method \"" + std::string(name) + "\"");
}

// Beside the columns of the files and the result, which are there: what fmm/README.md says that a
// plan takes.
constexpr std::uint64_t bytes_a_vortex = 130, bytes_a_target = 40;

void check_memory(const VelocityProblem& problem) {
  const std::uint64_t n = problem.sources.x.size();
  const std::uint64_t m = problem.elsewhere ? problem.points().size() : 0;
  const std::uint64_t needed = bytes_a_vortex * n + bytes_a_target * m, left = free_memory();
  if (needed <= left) return;
  throw std::runtime_error(
      fmt::format("{} vortices and {} targets need some {:.1f} GB of memory, {:.1f} GB are free", n,
                  m, 1e-9 * static_cast<double>(needed), 1e-9 * static_cast<double>(left)));
}

fmm::SumMethod sum_method(std::string_view name) {
  if (name == "direct") return fmm::SumMethod::direct;
  return name == "boxes" ? fmm::SumMethod::boxes : fmm::SumMethod::fmm;
}

bench::Account account_of(const fmm::Plan& plan, const fmm::Options& options) {
  bench::Account account;
  if (options.method == fmm::SumMethod::direct) return account;
  account.builder = options.builder == fmm::Builder::reverse ? "reverse" : "forward";
  account.tolerance = options.tolerance;
  account.order = plan.order();
  return account;
}

// What is asked for beside velocities.
bench::Account sum_others(VelocityProblem& problem, const VelocityJob& job, Stopwatch& watch) {
  fmm::Options options = job.options;
  options.method = sum_method(job.method);
  watch.begin("plan");
  const fmm::Plan plan(problem.blobs(), options);
  for (std::size_t k = 0; k < problem.others.size(); ++k) {
    watch.begin(problem.others[k].name);
    problem.others[k].sum(plan, problem.blobs(), problem.points(), options.tolerance,
                          problem.found[k]);
  }
  watch.end();
  return account_of(plan, options);
}

// Sums once: the result into the problem, the time into the stopwatch.
bench::Account sum(VelocityProblem& problem, const VelocityJob& job, Stopwatch& watch) {
  const auto phase = [&watch](std::string_view name) { watch.begin(name); };
  std::optional<bench::Account> account;
  if (problem.velocities)
    account = method_named(job.method)
                  .sum({problem.blobs(), problem.points(), problem.elsewhere, problem.u, problem.v},
                       job.options, phase, {.repeated = job.repeat > 1});
  if (problem.others.empty()) return *account;
  const bench::Account others = sum_others(problem, job, watch);
  return account.value_or(others);
}

void blame_if_refused(const std::filesystem::path& file, const auto& check) {
  try {
    check();
  } catch (const std::invalid_argument& refused) {
    throw io::InputError(fmt::format("{}: {}", file.string(), refused.what()));
  }
}

// What a method refuses has a file's name, if that file alone is refused.
bench::Account sum_or_blame(VelocityProblem& problem, const VelocityJob& job, Stopwatch& watch) {
  try {
    return sum(problem, job, watch);
  } catch (const std::invalid_argument&) {
    blame_if_refused(job.in, [&] {
      (void)fmm::check(problem.blobs());
      (void)tree::enclose({problem.sources.x, problem.sources.y});
    });
    blame_if_refused(job.targets, [&] {
      (void)tree::enclose({problem.points().x, problem.points().y});
    });
    throw;
  }
}

void warn_of_few_terms(const VelocityJob& job, const bench::Account& account) {
  if (!account.order) return;
  const int order = job.options.order;
  const std::string doubt =
      vortex::doubt_of_terms(order, fmt::format("--order {}", order), "--tolerance");
  if (!doubt.empty()) say("warning: {}", doubt);
}

template <class Value>
Json if_any(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

io::Attributes attributes_of(const VelocityProblem& problem, const VelocityJob& job,
                             const bench::Account& account) {
  io::Attributes about = origin_of(job.said, job.in, problem.sources.x.size());
  about.emplace_back("method", job.method);
  if (account.tolerance) about.emplace_back("tolerance", *account.tolerance);
  if (!problem.elsewhere) return about;
  about.emplace_back("targets", io::shortened(job.targets.string(), 7000));
  return about;
}

void require_names(const VelocityJob& job) {
  io::require_writable_format(job.out);
  io::require_writable(job.out, std::array{io::file_behind(job.in), io::file_behind(job.targets)});
}

// Medians of the phases and of their sums. The four phases of a tree code come first, null where a
// method cannot tell them apart; then what it can tell.
Json median_seconds(const std::vector<Stopwatch>& laps) {
  Json seconds;
  for (const auto* phase : {"tree", "upward", "far", "near"}) seconds[phase] = nullptr;
  for (const auto& [phase, ignored] : laps.front().phases()) {
    std::vector<double> values;
    for (const Stopwatch& lap : laps) values.push_back(lap.seconds(phase));
    seconds[phase] = median(values);
  }
  std::vector<double> totals;
  for (const Stopwatch& lap : laps) {
    totals.push_back(0);
    for (const auto& [phase, spent] : lap.phases()) totals.back() += spent;
  }
  seconds["total"] = median(totals);
  return seconds;
}

Json error_json(const bench::VelocityError& error) {
  Json members;
  members["relative_l2"] = error.relative_l2;
  members["p99"] = error.p99;
  members["max"] = error.max;
  members["targets"] = error.targets;
  members["condition"] = error.condition;
  return members;
}

// What is promised: the tolerance, or where sums cancel what doubles can hold (fmm::Plan).
std::optional<std::string> miss(const bench::VelocityError& error, double tolerance) {
  const double promised = std::max(tolerance, fmm::round_off * error.condition);
  if (error.relative_l2 <= promised) return std::nullopt;
  return fmt::format(
      "the tolerance was missed: the relative L2 error is {:.3g} at {} targets, {:.3g} "
      "was asked for",
      error.relative_l2, error.targets, tolerance);
}

}  // namespace

std::vector<std::string> velocity_methods() {
  std::vector<std::string> names;
  for (const bench::VelocityMethod& method : bench::methods()) names.emplace_back(method.name);
  return names;
}

VelocityReport velocity(const VelocityJob& job) {
  method_named(job.method);
  check_quantities(job);
  Stopwatch files;
  files.begin("io");
  require_names(job);
  VelocityProblem problem = read_problem(job);
  files.end();

  check_memory(problem);
  std::vector<Stopwatch> laps(job.repeat);
  bench::Account account;
  for (Stopwatch& lap : laps) account = sum_or_blame(problem, job, lap);
  if (!job.verify) warn_of_few_terms(job, account);  // which measures the error itself

  files.begin("io");
  io::write_columns(job.out, columns_of(problem), attributes_of(problem, job, account));
  files.end();

  Json report;
  report["n"] = problem.blobs().size();
  report["method"] = job.method;
  report["builder"] = if_any(account.builder);
  report["threads"] = omp_get_max_threads();
  report["tolerance"] = if_any(account.tolerance);
  report["order"] = if_any(account.order);
  report["pairs"] = account.work ? Json(account.work->bare + account.work->cored) : Json();
  report["peak_bytes"] = peak_bytes();
  report["seconds"] = median_seconds(laps);
  report["seconds"]["io"] = files.seconds("io");
  if (!job.verify) return {report.dump(), {}};
  const bench::Exact exact = bench::exact_velocity(problem.blobs(), problem.points());
  const bench::VelocityError error = bench::velocity_error(exact, problem.u, problem.v);
  report["error"] = error_json(error);
  return {report.dump(), miss(error, job.options.tolerance)};
}

}  // namespace vortree::app
