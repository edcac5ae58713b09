#include "app/loop/summary.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>

#include "app/program.hpp"
#include "io/input_error.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

/// Two spots at rest.
struct Still final : flow::Solver {
  std::string particle() const override { return "spot"; }
  std::vector<std::string> phases() const override { return {"rest"}; }
  void step(const tree::Phase&) override {}
  long steps() const override { return 3; }
  double time() const override { return 0.3; }
  std::size_t particles() const override { return 2; }
  flow::Columns columns() const override { return {}; }
  flow::Measures measures() const override { return {}; }
  std::optional<flow::Force> force() const override { return std::nullopt; }
  double drift() const override { return NAN; }
  flow::Samples sample(tree::Points) const override { return {}; }
  flow::FrameTable frame_table() const override { return {}; }
  std::vector<double> frame_rows() const override { return {}; }
  flow::Closing closing() const override { return {{{"gone.spots", "", 1e-7}}, ""}; }
  void save(flow::State&) const override {}
  void restore(long, const flow::Columns&, const flow::State&) override {}
};

std::string page_of(const TemporaryFolder& folder, const std::string& title,
                    std::span<const checks::Verdict> verdicts) {
  folder.write("report.csv", "t,seconds_rest\n0.1,0.125\n0.2,0.25\n0.3,0.125\n");
  io::Scene scene;
  scene.origin.path = "b\xfc.toml";  // Latin-1
  scene.title = title;
  scene.method = "still";
  const app::Totals totals{
      .particle_steps = 6e15, .most_particles = 2, .seconds = 0.8, .processor_seconds = 1.5};
  const std::array<std::string, 2> origin{"machine: EPYC: two", "commit: c"};
  return app::summary(scene, folder.path(), Still(), std::array{std::string("rest")}, totals,
                      origin, verdicts);
}

std::string summary_of(const std::string& title, std::span<const checks::Verdict> verdicts) {
  const TemporaryFolder folder;
  const std::string page = page_of(folder, title, verdicts);
  const std::regex of_the_machine("(\"(?:version|threads|peak_bytes)\": )[^,]+");
  return std::regex_replace(page, of_the_machine, "$1...");
}

}  // namespace

TEST_CASE("the summary is a page of JSON in the order of its making; what is not finite is null") {
  const std::vector<checks::Verdict> verdicts{
      {"a_max", 0.1, {0.30000000000000004}}, {"b_max", 1, {NAN}}, {"c_max", 0.2, {{}, "no frame"}}};
  CHECK(summary_of("at rest", verdicts) == R"({
  "scene": "b\ufffd.toml",
  "title": "at rest",
  "version": ...,
  "threads": ...,
  "method": "still",
  "provenance": {
    "machine": "EPYC: two",
    "commit": "c"
  },
  "steps": 3,
  "spots": 2,
  "largest_spot_count": 2,
  "particle_steps": 6000000000000000,
  "particle_steps_per_second": 7.5e+15,
  "processor_seconds": 1.5,
  "peak_bytes": ...,
  "largest_drift": null,
  "seconds": {
    "total": 0.8,
    "rest": 0.5
  },
  "check": {
    "passed": false,
    "a_max": {
      "asked": 0.1,
      "reached": 0.30000000000000004,
      "passed": false,
      "status": "missed"
    },
    "b_max": {
      "asked": 1.0,
      "reached": null,
      "passed": false,
      "status": "missed"
    },
    "c_max": {
      "asked": 0.2,
      "reached": null,
      "passed": null,
      "status": "not reached",
      "why": "no frame"
    }
  },
  "gone": {
    "spots": 1e-07
  }
}
)");
}

TEST_CASE("nothing in a summary harms a terminal, whatever the title") {
  const std::string page =
      summary_of("\"Gr\xc3\xb6\xc3\x9f\x65\" \\ \x1b[31m \xc2\x9b \xe2\x80\xae", {});
  CHECK_THAT(page, Catch::Matchers::Contains(
                       R"("title": "\"Gr\u00f6\u00dfe\" \\ \u001b[31m \u009b \u202e")"));
}

TEST_CASE("what a summary says of a run is read again bit for bit, but for what was not finite") {
  const TemporaryFolder folder;
  CHECK_FALSE(app::result_in(folder.path()));
  const std::vector<checks::Verdict> verdicts{
      {"a_max", 0.1, {0.30000000000000004}}, {"b_max", 1, {NAN}}, {"c_max", 0.2, {{}, "no frame"}}};
  const std::string page = page_of(folder, "at rest", verdicts);
  folder.write("summary.json", page);
  const auto found = app::result_in(folder.path());
  REQUIRE(found);
  CHECK(found->finished);
  CHECK(found->steps == 3);
  CHECK(found->most_particles == 2);
  CHECK(found->particle_steps == 6e15);
  CHECK(found->seconds == 0.8);
  CHECK(found->processor_seconds == 1.5);
  CHECK(found->threads > 0);
  CHECK(found->origin == std::vector<std::string>{"machine: EPYC: two", "commit: c"});
  REQUIRE(found->verdicts.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const checks::Verdict &was = verdicts[k], &is = found->verdicts[k];
    CHECK(is.what == was.what);
    CHECK(is.asked == was.asked);
    CHECK(is.missed() == was.missed());
    CHECK(is.passed() == was.passed());
    CHECK(is.reached.why == was.reached.why);
  }
  CHECK(found->verdicts[0].reached.value == verdicts[0].reached.value);
  for (const std::string& broken :
       {page.substr(0, page.size() / 2), std::string("{}"), std::string("[1]")}) {
    folder.write("summary.json", broken);
    CHECK_THROWS_AS(app::result_in(folder.path()), io::InputError);
  }
}
