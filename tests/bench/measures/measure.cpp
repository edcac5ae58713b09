#include "bench/measures/measure.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <numeric>
#include <string_view>

#include "bench/measures/anchors.hpp"
#include "bench/measures/memory.hpp"
#include "bench/tables/velocity_row.hpp"

using namespace vortree;
using bench::Measurement;

namespace {

const bench::VelocityMethod& method(std::string_view name) {
  return *std::ranges::find(bench::methods(), name, &bench::VelocityMethod::name);
}

constexpr bench::Patience little{.seconds = 0.0, .most_repeats = 3, .most_pairs = 1e8};

Measurement measured(std::string_view name, const bench::PointSet& set, std::size_t sample) {
  const bench::Exact exact = bench::exact_velocity(set.blobs(), {set.x, set.y, {}}, sample);
  return bench::measure(method(name), set, exact, 1e-5, little);
}

double of_phases(const Measurement& made) {
  double sum = 0.0;
  for (const auto& [name, seconds] : made.phases) sum += seconds;
  return sum;
}

}  // namespace

TEST_CASE("every method is measured with its error, its phases and three repeats at least") {
  const bench::PointSet set = bench::make_blobs(2000);
  for (const bench::VelocityMethod& each : bench::methods()) {
    CAPTURE(each.name);
    const Measurement made = measured(each.name, set, 100);
    CHECK(made.repeats == 3);
    CHECK(made.targets == 2000);
    CHECK(0.0 < made.fastest);
    CHECK(made.fastest <= made.seconds);
    CHECK(of_phases(made) > 0.0);
    CHECK(made.error.relative_l2 > 0.0);
    CHECK(made.error.relative_l2 <= (each.exact ? 1e-14 : 1e-5));
  }
}

TEST_CASE("a direct sum that would take long is measured at some targets and scaled up") {
  const bench::PointSet set = bench::make_points(bench::PointKind::uniform, 20000);
  const Measurement made = measured("direct", set, 20);
  CHECK(made.targets < 20000);
  CHECK(made.error.targets == 20);
  CHECK(made.error.relative_l2 < 1e-13);
  CHECK(made.phases.size() == 1);
  CHECK(made.fastest <= made.seconds);
}

TEST_CASE(
    "of several laps the medians count, in all and by phase, and the fastest; all scaled up") {
  using Phases = Stopwatch::Phases;
  const Phases laps[] = {
      {{"tree", 1}, {"near", 2}}, {{"tree", 3}, {"near", 2}}, {{"tree", 2}, {"near", 7}}};
  Measurement made;
  bench::summarise(laps, 10, made);
  CHECK(made.seconds == 50);
  CHECK(made.fastest == 30);
  CHECK(made.repeats == 3);
  CHECK(made.phases == Phases{{"tree", 20}, {"near", 20}});
}

TEST_CASE("memory growth is what is touched, and what was freed before does not hide it") {
  for (int round = 0; round < 2; ++round) {
    const bench::MemoryGrowth growth;
    if (!growth.bytes()) return;  // the system does not tell
    std::vector<char> large(std::size_t{64} << 20, 1);
    CHECK(large.back() == 1);
    CHECK(*growth.bytes() >= large.size());
    CHECK(*growth.bytes() < 2 * large.size());
  }
}

TEST_CASE("a machine multiplies and adds faster than it divides, and moves some bytes") {
  const bench::Anchors machine = bench::measure_anchors(1);
  CHECK(machine.divisions > 0);
  CHECK(machine.fma > machine.divisions);
  CHECK(machine.single_divisions > 0);
  CHECK(machine.triad > 0);
  CHECK(machine.write > 0);
}

TEST_CASE("a row has a cell for every column; floors come from pairs and anchors") {
  const bench::PointSet set = bench::make_points(bench::PointKind::uniform, 1000);
  const Measurement made = measured("direct", set, 10);
  const bench::VelocityRow row{"uniform", "direct", 1000, {}, 1};
  const bench::Floors least = bench::floors(
      row, made, {.fma = 1e11, .divisions = 5e9, .single_divisions = 1e10, .triad = 1e10});
  CHECK(*least.near == Approx(0.5 * 999000 / 5e9));
  CHECK_FALSE(least.tree);
  const std::string line = bench::csv_line(row, made, least);
  CHECK(std::ranges::count(line, ',') == std::ranges::count(bench::csv_header(), ','));
  CHECK(line.starts_with("uniform,1000,direct,,1,"));
}
