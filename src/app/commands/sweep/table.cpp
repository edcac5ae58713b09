#include "app/commands/sweep/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "checks/convergence.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"
#include "io/tables/table.hpp"
#include "provenance/provenance.hpp"

namespace vortree::app {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double number_or_nan(const std::string& word) {
  return io::number(word).value_or(unknown);
}

/// Names of all that was held against an answer, in the order of the checks.
std::vector<std::string> errors_of(std::span<const Member> members) {
  std::vector<std::string> names;
  for (const Member& m : members)
    for (const checks::Verdict& v : m.result.verdicts)
      if (std::ranges::find(names, v.what) == names.end()) names.push_back(v.what);
  return names;
}

/// NaN if it was not.
double reached(const Member& member, const std::string& what) {
  for (const checks::Verdict& v : member.result.verdicts)
    if (v.what == what) return v.reached.value.value_or(unknown);
  return unknown;
}

/// The members that differ in their last value alone, as [first, last).
std::vector<std::pair<std::size_t, std::size_t>> groups(const SweepPlan& plan, std::size_t n) {
  const std::size_t size = plan.axes.back().values.size();
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t first = 0; first < n; first += size)
    result.emplace_back(first, std::min(first + size, n));
  return result;
}

struct ErrorCurve {
  std::vector<double> h, e;
};

ErrorCurve curve(const SweepPlan& plan, std::span<const Member> members, const std::string& what) {
  const bool flows = !tells_the_same_flow(plan);
  ErrorCurve c;
  for (const Member& m : members) {
    c.h.push_back(flows ? unknown : number_or_nan(m.values.back()));
    c.e.push_back(reached(m, what));
  }
  return c;
}

/// Of a number that is finite; a gap for others.
std::string text(double number, const char* digits) {
  return std::isfinite(number) ? fmt::format(fmt::runtime(digits), number) : "";
}

using RowCells = std::vector<std::string>;

const char* word_of(Lack lack) {
  if (lack == Lack::missing) return "missing";
  return lack == Lack::failed ? "failed" : "unfinished";
}

RowCells row_of(const Member& m, std::span<const std::string> errors,
                std::span<const std::vector<double>> order, std::size_t i) {
  RowCells row = m.values;
  const RunResult& r = m.result;
  if (m.ended())
    row.insert(row.end(), {fmt::format("{}", r.steps), fmt::format("{}", r.most_particles),
                           fmt::format("{:.3g}", r.seconds)});
  else
    row.insert(row.end(), {word_of(m.lack), "", ""});
  for (std::size_t k = 0; k < errors.size(); ++k)
    row.insert(row.end(), {text(reached(m, errors[k]), "{:.3g}"), text(order[k][i], "{:.2f}")});
  return row;
}

/// The orders that fit all of a group; nothing where there is none.
RowCells fitted_row(const SweepPlan& plan, std::span<const Member> group,
                    std::span<const std::string> errors) {
  const std::size_t axes = plan.axes.size();
  RowCells fitted(axes + 3 + 2 * errors.size());
  bool any = false;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const ErrorCurve c = curve(plan, group, errors[k]);
    const double order = group.size() < 3 ? unknown : checks::fitted_order(c.h, c.e);
    fitted[axes + 4 + 2 * k] = text(order, "{:.2f}");
    any = any || std::isfinite(order);
  }
  fitted[axes - 1] = "all";
  return any ? fitted : RowCells{};
}

/// Words that hold a comma are quoted.
std::string cell(const std::string& word) {
  return word.find(',') == std::string::npos ? word : fmt::format("'{}'", word);
}

/// `drag_max 0.03 of 0.02, ...` of what was missed.
std::string missed(const Member& m) {
  RowCells words;
  for (const checks::Verdict& v : m.result.verdicts)
    if (v.missed())
      words.push_back(fmt::format(
          "{} {} of {:.3g}", v.what,
          std::isfinite(*v.reached.value) ? fmt::format("{:.3g}", *v.reached.value) : "not finite",
          v.asked));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Of a line that every run has in words of its own.
bool own_to_each(const std::string& line) {
  return line.starts_with("load: ") || line.starts_with("date: ");
}

/// Whether the words of one are among those of the other, between bars.
bool among(const std::string& line, const std::string& other) {
  const auto words = [](const std::string& of) { return of.substr(of.find(": ") + 2); };
  return (" | " + words(line) + " | ").find(" | " + words(other) + " | ") != std::string::npos;
}

/// Lines of the first run that ended; what differs from run to run by all its values, but for the
/// load and the date.
RowCells origins(std::span<const Member> members) {
  std::vector<RowCells> of_runs;
  for (const Member& m : members) {
    if (!m.ended()) continue;
    of_runs.push_back({fmt::format("threads: {}", m.result.threads)});
    of_runs.back().insert(of_runs.back().end(), m.result.origin.begin(), m.result.origin.end());
  }
  if (of_runs.empty()) return provenance();
  RowCells lines = of_runs.front();
  for (const RowCells& other : of_runs)
    for (std::size_t k = 0; k < std::min(lines.size(), other.size()); ++k)
      if (!own_to_each(lines[k]) && !among(lines[k], other[k]))
        lines[k] += " | " + other[k].substr(other[k].find(": ") + 2);
  return lines;
}

}  // namespace

bool tells_the_same_flow(const SweepPlan& plan) {
  const std::string& key = plan.axes.back().key;
  return !key.starts_with("flow.") && key != "seed";
}

std::string table(const SweepPlan& plan, std::span<const Member> members) {
  const RowCells errors = errors_of(members);
  RowCells headings;
  for (const Axis& axis : plan.axes) headings.push_back(axis.key);
  headings.insert(headings.end(), {"steps", "particles", "seconds"});
  for (const std::string& what : errors) headings.insert(headings.end(), {what, "order"});
  std::vector<RowCells> rows;
  for (const auto& [first, last] : groups(plan, members.size())) {
    const auto group = members.subspan(first, last - first);
    std::vector<std::vector<double>> order;
    for (const std::string& what : errors) {
      const ErrorCurve c = curve(plan, group, what);
      order.push_back(checks::orders(c.h, c.e));
    }
    for (std::size_t i = 0; i < group.size(); ++i)
      rows.push_back(row_of(group[i], errors, order, i));
    RowCells fitted = fitted_row(plan, group, errors);
    if (!fitted.empty()) rows.push_back(std::move(fitted));
  }
  return checks::text_table(headings, rows);
}

void require_own_table(const std::filesystem::path& file) {
  const std::filesystem::path target = io::target_of(file);
  std::error_code error;
  if (target == file || !std::filesystem::exists(target, error)) return;
  const bool of_a_run = std::filesystem::exists(io::folder_of(target) / "frames.h5", error);
  if (of_a_run || target.extension() != file.extension())
    throw io::InputError(fmt::format(
        "{} is a link to {}, {}, which the table of a sweep would destroy", file.string(),
        target.string(), of_a_run ? "in the folder of a run" : "a file of another kind"));
}

void write_csv(const std::filesystem::path& file, const std::string& scene, const SweepPlan& plan,
               std::span<const Member> members) {
  std::ostringstream out;
  const RowCells errors = errors_of(members);
  out << fmt::format("# scene: {} {}\n", scene, fmt::join(plan.fixed, " "));
  for (const std::string& line : origins(members)) out << "# " << line << "\n";
  const auto ran = std::ranges::find_if(members, &Member::ended);
  if (ran != members.end())
    for (const checks::Verdict& v : ran->result.verdicts)
      out << fmt::format("# asked: {} {}\n", v.what, v.asked);
  for (const Axis& axis : plan.axes) out << axis.key << ",";
  out << fmt::format("steps,particles,particle_steps,seconds,processor_seconds{}{}\n",
                     errors.empty() ? "" : ",", fmt::join(errors, ","));
  for (const Member& m : members) {
    for (const std::string& value : m.values) out << cell(value) << ",";
    const RunResult& r = m.result;
    if (m.ended())
      out << fmt::format("{},{},{},{},{}", r.steps, r.most_particles, r.particle_steps, r.seconds,
                         r.processor_seconds);
    else
      out << ",,,,";
    for (const std::string& what : errors) out << "," << text(reached(m, what), "{}");
    out << "\n";
  }
  io::write_text(file, out.str());
}

std::string what_went_wrong(const SweepPlan& plan, std::span<const Member> members) {
  constexpr std::size_t told = 3;
  RowCells words;
  std::array<std::size_t, 3> lacking{};
  std::size_t wrong = 0, missing_checks = 0;
  for (const Member& m : members) {
    const std::string why = m.ended() ? missed(m) : m.failure;
    if (why.empty()) continue;
    ++(m.ended() ? missing_checks : lacking[static_cast<std::size_t>(m.lack)]);
    if (++wrong <= told)
      words.push_back(fmt::format("{} {}: {}", name_of(plan, m),
                                  m.ended() ? "missed its check" : word_of(m.lack), why));
  }
  if (wrong == 0) return "";
  if (wrong > told) words.push_back(fmt::format("and {} more", wrong - told));
  const auto [failed, unfinished, missing] = lacking;
  const std::string open = unfinished + missing == 0
                               ? ""
                               : fmt::format(", {} unfinished, {} missing", unfinished, missing);
  return fmt::format("{} of {} runs failed, {} missed their checks{}: {}", failed, members.size(),
                     missing_checks, open, fmt::join(words, "; "));
}

}  // namespace vortree::app
