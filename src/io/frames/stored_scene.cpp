#include "io/frames/stored_scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "io/scene/schema.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

bool may_change(std::string_view key) {
  return key == "title" || key == "accuracy" || key == "time.end" || key.starts_with("output.") ||
         key.starts_with("check.");
}

/// What scenes were like before they knew of a key: blobs were split into rings.
std::vector<std::string> before_its_keys(std::string_view resolved) {
  const std::size_t table = resolved.find("[splitting]\n");
  if (table == std::string_view::npos) return {};
  const std::string_view rest = resolved.substr(table);
  const bool known = rest.substr(0, rest.find("\n[")).find("\nscheme") != std::string_view::npos;
  return known ? std::vector<std::string>{} : std::vector<std::string>{"splitting.scheme=ring"};
}

}  // namespace

RunInfo info_of(const Scene& scene, std::string version) {
  return {.version = std::move(version),
          .scene_path = scene.origin.path.string(),
          .scene = scene.origin.text,
          .resolved = resolved(scene),
          .overrides = scene.origin.overrides,
          .seed = scene.seed,
          .units = "consistent: lengths, times and circulations as in the scene"};
}

Scene stored_scene(const RunInfo& info, const fs::path& file, const fs::path& path,
                   const flow::Methods& methods) {
  try {
    return parse_scene(info.resolved, path, methods, before_its_keys(info.resolved));
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}: the scene stored in it is none: {}", file.string(), error.what()));
  }
}

Scene stored_scene(const RunInfo& info, const fs::path& file, const fs::path& path,
                   const flow::Methods& methods, std::span<const std::string> overrides) {
  Scene was = stored_scene(info, file, path, methods);
  if (overrides.empty()) return was;
  std::vector<std::string> all = before_its_keys(info.resolved);
  all.insert(all.end(), overrides.begin(), overrides.end());
  Scene now = parse_scene(info.resolved, path, methods, all);
  hold_scene(was, now, file);
  return now;
}

std::string flow_difference(const Scene& a, const Scene& b) {
  const std::string name = first_difference(a, b, may_change);
  const std::size_t dot = name.find('.');
  return dot == std::string::npos ? name : fmt::format("[{}]", name.substr(0, dot));
}

void hold_scene(const Scene& was, const Scene& now, const fs::path& file) {
  const std::string where = flow_difference(was, now);
  if (where.empty()) return;
  throw InputError(
      fmt::format("{}: was run with another {} than {} has now, or than this version "
                  "chooses; only time.end, [output] and [check] may change on the way",
                  file.string(), where, now.origin.path.string()));
}

void hold_time(const Frame& frame, double dt, const fs::path& file) {
  const double expected = static_cast<double>(frame.step) * dt;
  if (std::abs(frame.time - expected) <= 1e-12 * expected) return;
  throw InputError(fmt::format(
      "{}: the frame of step {} is that of t = {}, where steps of time.dt = {} come to t = {}: the "
      "file is damaged, or another run's",
      file.string(), frame.step, frame.time, dt, expected));
}

}  // namespace vortree::io
