#include "app/summary.hpp"

#include <omp.h>

#include <algorithm>
#include <numeric>

#include "app/memory.hpp"
#include "app/places.hpp"
#include "io/table.hpp"

namespace vortree::app {

io::Json summary(const io::Scene& scene, const std::filesystem::path& folder, long steps,
                 std::size_t blobs, const Totals& totals, std::span<const Verdict> verdicts) {
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
  json["check"]["passed"] = std::ranges::all_of(verdicts, &Verdict::passed);
  for (const Verdict& v : verdicts) {
    json["check"][v.what]["asked"] = v.asked;
    json["check"][v.what]["reached"] = v.reached;
    json["check"][v.what]["passed"] = v.passed();
  }
  return json;
}

}  // namespace vortree::app
