#include "app/commands/sweep/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "io/input_error.hpp"

namespace vortree::app {
namespace {

constexpr std::size_t most_runs = 10'000;

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

std::vector<Member> members_of(const SweepPlan& plan) {
  std::vector<Member> members(1);
  for (const Axis& axis : plan.axes) {
    if (members.size() * axis.values.size() > most_runs)
      throw io::InputError(
          fmt::format("command line: a sweep of more than {} runs, by {}", most_runs, axis.key));
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

std::string name_of(const SweepPlan& plan, const Member& member) {
  return fmt::format("{}", fmt::join(overrides_of(plan, member), " "));
}

std::filesystem::path folder_of(const SweepPlan& plan, const Member& member) {
  std::string name = fmt::format("{}", fmt::join(overrides_of(plan, member), ","));
  std::ranges::replace_if(
      name, [](char c) { return c == '/' || c == ' ' || c == '"'; }, '_');
  return name;
}

std::vector<std::string> all_overrides(const SweepPlan& plan, const Member& member) {
  std::vector<std::string> words = plan.fixed;
  for (std::string& word : overrides_of(plan, member)) words.push_back(std::move(word));
  return words;
}

}  // namespace vortree::app
