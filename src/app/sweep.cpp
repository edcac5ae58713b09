#include "app/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/convergence.hpp"
#include "app/places.hpp"
#include "app/plot.hpp"
#include "app/say.hpp"
#include "bench/provenance.hpp"
#include "io/files.hpp"
#include "io/input_error.hpp"
#include "io/quote.hpp"
#include "io/table.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The parts of a list between commas that are not inside brackets or quotes.
std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  char quote = 0;
  for (char c : text) {
    if (quote) {
      quote = c == quote ? 0 : quote;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',' && depth == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
  }
  return parts;
}

/// One run of a sweep: a value for each axis, and what came of it.
struct Member {
  std::vector<std::string> values;
  RunResult result;
  bool ran = false;
};

std::vector<Member> members_of(const SweepPlan& plan) {
  std::vector<Member> members(1);
  for (const Axis& axis : plan.axes) {
    std::vector<Member> more;
    for (const Member& m : members)
      for (const std::string& value : axis.values) {
        more.push_back(m);
        more.back().values.push_back(value);
      }
    members = std::move(more);
  }
  return members;
}

std::vector<std::string> overrides_of(const SweepPlan& plan, const Member& member) {
  std::vector<std::string> overrides;
  for (std::size_t k = 0; k < plan.axes.size(); ++k)
    overrides.push_back(plan.axes[k].key + "=" + member.values[k]);
  return overrides;
}

fs::path folder_of(const SweepPlan& plan, const Member& member) {
  std::string name = fmt::format("{}", fmt::join(overrides_of(plan, member), ","));
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == ' ' || c == '"'; }, '_');
  return name;
}

RunOptions options_of(const RunOptions& all, const SweepPlan& plan, const Member& member) {
  RunOptions options = all;
  options.overrides = plan.fixed;
  for (const std::string& word : overrides_of(plan, member)) options.overrides.push_back(word);
  options.out = all.out / folder_of(plan, member);
  options.resume = all.resume && fs::exists(options.out / "frames.h5");
  options.figures = false;
  return options;
}

double number_or_nan(const std::string& word) {
  return io::number(word).value_or(unknown);
}

/// Names of all that was held against an answer, in the order of the checks.
std::vector<std::string> errors_of(std::span<const Member> members) {
  std::vector<std::string> names;
  for (const Member& m : members)
    for (const Verdict& v : m.result.verdicts)
      if (std::ranges::find(names, v.what) == names.end()) names.push_back(v.what);
  return names;
}

double reached(const Member& member, const std::string& what) {
  for (const Verdict& v : member.result.verdicts)
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

struct Curve {
  std::vector<double> h, e;
};

Curve curve(std::span<const Member> members, const std::string& what) {
  Curve c;
  for (const Member& m : members) {
    c.h.push_back(number_or_nan(m.values.back()));
    c.e.push_back(reached(m, what));
  }
  return c;
}

std::string order_text(double p) {
  return std::isfinite(p) ? fmt::format("{:.2f}", p) : "";
}

std::string table(const SweepPlan& plan, std::span<const Member> members) {
  const std::vector<std::string> errors = errors_of(members);
  std::vector<std::string> headings;
  for (const Axis& axis : plan.axes) headings.push_back(axis.key);
  headings.insert(headings.end(), {"steps", "blobs", "seconds"});
  for (const std::string& what : errors) headings.insert(headings.end(), {what, "order"});
  std::vector<std::vector<std::string>> rows;
  for (const auto& [first, last] : groups(plan, members.size())) {
    const auto group = members.subspan(first, last - first);
    std::vector<std::vector<double>> order;
    for (const std::string& what : errors) {
      const Curve c = curve(group, what);
      order.push_back(orders(c.h, c.e));
    }
    for (std::size_t i = 0; i < group.size(); ++i) {
      std::vector<std::string> row = group[i].values;
      const RunResult& r = group[i].result;
      row.insert(row.end(), {fmt::format("{}", r.steps), fmt::format("{}", r.most_blobs),
                             fmt::format("{:.3g}", r.seconds)});
      for (std::size_t k = 0; k < errors.size(); ++k)
        row.insert(row.end(),
                   {fmt::format("{:.3g}", reached(group[i], errors[k])), order_text(order[k][i])});
      rows.push_back(std::move(row));
    }
    if (group.size() < 3 || errors.empty()) continue;
    std::vector<std::string> fitted(headings.size());
    fitted[plan.axes.size() - 1] = "all";
    for (std::size_t k = 0; k < errors.size(); ++k) {
      const Curve c = curve(group, errors[k]);
      fitted[plan.axes.size() + 4 + 2 * k] = order_text(fitted_order(c.h, c.e));
    }
    rows.push_back(std::move(fitted));
  }
  return text_table(headings, rows);
}

/// Words that hold a comma are quoted.
std::string cell(const std::string& word) {
  return word.find(',') == std::string::npos ? word : fmt::format("'{}'", word);
}

void write_csv(const fs::path& file, const RunOptions& options, const SweepPlan& plan,
               std::span<const Member> members) {
  std::ostringstream out;
  const std::vector<std::string> errors = errors_of(members);
  out << fmt::format("# scene: {} {}\n", options.scene, fmt::join(plan.fixed, " "));
  for (const std::string& line : bench::provenance()) out << "# " << line << "\n";
  for (const Verdict& v : members.empty() ? std::vector<Verdict>{} : members[0].result.verdicts)
    out << fmt::format("# asked: {} {}\n", v.what, v.asked);
  for (const Axis& axis : plan.axes) out << axis.key << ",";
  out << fmt::format("steps,blobs,particle_steps,seconds{}{}\n", errors.empty() ? "" : ",",
                     fmt::join(errors, ","));
  for (const Member& m : members) {
    for (const std::string& value : m.values) out << cell(value) << ",";
    const RunResult& r = m.result;
    out << fmt::format("{},{},{},{}", r.steps, r.most_blobs, r.particle_steps, r.seconds);
    for (const std::string& what : errors) out << fmt::format(",{}", reached(m, what));
    out << "\n";
  }
  io::write_text(file, out.str());
}

}  // namespace

SweepPlan sweep_plan(std::span<const std::string> overrides) {
  SweepPlan plan;
  for (const std::string& word : overrides) {
    const std::size_t equals = word.find('=');
    const auto values =
        equals == std::string::npos ? std::vector<std::string>{} : listed(word.substr(equals + 1));
    if (values.size() < 2) {
      plan.fixed.push_back(word);
      continue;
    }
    if (std::ranges::any_of(values, &std::string::empty))
      throw io::InputError(
          fmt::format("command line: {}: there is an empty value between two commas", word));
    plan.axes.push_back({word.substr(0, equals), values});
  }
  return plan;
}

int sweep(const RunOptions& options, const SweepPlan& plan) {
  std::vector<Member> members = members_of(plan);
  for (const Member& m : members)  // before hours are spent on the first of them
    (void)io::load_scene(find_scene(options.scene), options_of(options, plan, m).overrides);
  bool all_ran = true;
  std::size_t done = 0;
  for (Member& m : members) {
    say("run {} of {}: {}", done + 1, members.size(), fmt::join(overrides_of(plan, m), " "));
    try {
      m.result = run(options_of(options, plan, m));
      if (!m.result.finished) return 1;
      m.ran = true;
    } catch (const std::runtime_error& broken) {
      say_line(broken.what());
    }
    all_ran = all_ran && m.ran;
    write_csv(options.out / "sweep.csv", options, plan, std::span(members).first(++done));
  }
  fmt::print("{}", table(plan, members));
  plot(options.out);
  fmt::print("results in {}\n", io::printable(options.out.string()));
  return all_ran ? 0 : 1;
}

}  // namespace vortree::app
