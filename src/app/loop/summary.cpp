#include "app/loop/summary.hpp"

#include <omp.h>

#include <algorithm>
#include <numeric>

#include "app/install_paths.hpp"
#include "base/memory.hpp"
#include "io/tables/table.hpp"

namespace vortree::app {

namespace {

/// Whether all that was reached has passed; null where nothing was.
io::Json check(std::span<const checks::Verdict> verdicts) {
  io::Json json;
  const bool missed = std::ranges::any_of(verdicts, &checks::Verdict::missed);
  const bool none = std::ranges::none_of(verdicts, &checks::Verdict::passed) && !verdicts.empty();
  json["passed"] = !missed && none ? io::Json() : io::Json(!missed);
  for (const checks::Verdict& v : verdicts) {
    io::Json& one = json[v.what];
    one["asked"] = v.asked;
    one["reached"] = v.reached.value ? io::Json(*v.reached.value) : io::Json();
    one["passed"] = v.reached.value ? io::Json(v.passed()) : io::Json();
    one["status"] = v.passed() ? "passed" : v.missed() ? "missed" : "not reached";
    if (!v.reached.value) one["why"] = v.reached.why;
  }
  return json;
}

}  // namespace

io::Json summary(const io::Scene& scene, const std::filesystem::path& folder, long steps,
                 std::size_t blobs, const Totals& totals,
                 std::span<const checks::Verdict> verdicts) {
  io::Json json;
  json["scene"] = scene.origin.path.string();
  json["title"] = scene.title;
  json["version"] = version();
  json["threads"] = omp_get_max_threads();
  json["steps"] = std::int64_t{steps};
  json["blobs"] = static_cast<std::uint64_t>(blobs);
  json["largest_blob_count"] = totals.most_blobs;
  json["particle_steps"] = totals.particle_steps;
  json["particle_steps_per_second"] = totals.particle_steps / totals.seconds;
  json["peak_bytes"] = static_cast<std::uint64_t>(peak_bytes());
  json["largest_drift"] = totals.largest_drift;
  json["seconds"]["total"] = totals.seconds;
  const io::Table report(folder / "report.csv");
  for (const char* phase : {"convect", "wall", "split", "merge", "output"}) {
    const auto laps = report.column(std::string("seconds_") + phase);
    json["seconds"][phase] = std::accumulate(laps.begin(), laps.end(), 0.0);
  }
  json["check"] = check(verdicts);
  return json;
}

}  // namespace vortree::app
