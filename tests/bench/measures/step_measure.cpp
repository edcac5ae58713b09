#include "bench/measures/step_measure.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <string>
#include <thread>

using namespace vortree;
using bench::FlowState, bench::StepMeasure, bench::StepPatience;

namespace {

/// A flow that has `k` particles after step k and a body that feels a drag of 0.5; its odd steps
/// have a second phase.
class CountedFlow final : public flow::Solver {
 public:
  std::string particle() const override { return "particle"; }
  std::vector<std::string> phases() const override { return {"move", "lay"}; }
  void step(const tree::Phase& phase) override {
    ++steps_, ++stepped;
    phase("move");
    work();
    if (steps_ % 2 == 1) phase("lay"), work();
    phase("output");
    work();
  }
  long steps() const override { return steps_; }
  double time() const override { return 0.1 * static_cast<double>(steps_); }
  std::size_t particles() const override { return static_cast<std::size_t>(steps_); }
  flow::Columns columns() const override { return {}; }
  flow::Measures measures() const override { return {}; }
  flow::Measures counts() const override { return {{"laid", "", steps_ % 2 == 1 ? 10.0 : 0.0}}; }
  std::optional<flow::Force> force() const override {
    if (!body) return std::nullopt;
    return flow::Force{.t = time(), .impulse = {-0.25 * time(), 0}};
  }
  double drift() const override { return 0; }
  flow::Samples sample(tree::Points) const override { return {}; }
  flow::FrameTable frame_table() const override { return {}; }
  std::vector<double> frame_rows() const override { return {}; }
  void save(flow::State&) const override {}
  void restore(long steps, const flow::Columns&, const flow::State&) override { steps_ = steps; }

  bool body = true;
  int stepped = 0, longer = 1;

 private:
  void work() const { std::this_thread::sleep_for(std::chrono::microseconds(200 * longer)); }

  long steps_ = 0;
};

const flow::Scales unit{.body = true};

StepMeasure measured_alone(flow::Solver& flow, const FlowState& from,
                           const StepPatience& patience) {
  return bench::measure_steps(std::array{&flow}, from, unit, patience).front();
}

}  // namespace

TEST_CASE("steps are measured from the same state each time, and their phases are all of them") {
  CountedFlow flow;
  const StepMeasure made =
      measured_alone(flow, {.steps = 100}, {.steps = 4, .seconds = 1e9, .most_repeats = 3});
  CHECK(made.steps == 4);
  CHECK(made.repeats == 3);
  CHECK(flow.stepped == 4 * (1 + 3));  // once for the counts
  CHECK(made.particles == 101 + 102 + 103 + 104);
  REQUIRE(made.counts.size() == 1);
  CHECK(made.counts[0].value == Approx(5));
  std::vector<std::string> names;
  double sum = 0;
  for (const auto& [name, seconds] : made.phases) names.push_back(name), sum += seconds;
  CHECK(names == std::vector<std::string>{"move", "lay", "output"});
  CHECK(made.seconds() == sum);
}

TEST_CASE("a phase that some steps lack counts in those that have it") {
  CountedFlow flow;
  const StepMeasure made =
      measured_alone(flow, {.steps = 100}, {.steps = 4, .seconds = 1e9, .most_repeats = 5});
  // A sleep is never shorter: four of one phase, two of the other, whose median is 0 by steps.
  CHECK(made.phases[0].second >= 4 * 200e-6);
  CHECK(made.phases[1].second >= 2 * 200e-6);
}

TEST_CASE("the drag of the first step is what the impulse loses in it") {
  CountedFlow flow;
  const auto drag = [&] { return measured_alone(flow, {.steps = 7}, {.steps = 2}).drag; };
  REQUIRE(drag());
  CHECK(*drag() == Approx(2 * 0.25));  // C_D = 2 F at U = D = 1
  flow.body = false;
  CHECK_FALSE(drag());
}

TEST_CASE("solvers take turns, and who has run out of patience takes no more") {
  CountedFlow one, other;
  other.longer = 20;
  const StepPatience patience{.steps = 1, .seconds = 3e-3, .most_repeats = 3};
  const auto made =
      bench::measure_steps(std::array<flow::Solver*, 2>{&one, &other}, {}, unit, patience);
  REQUIRE(made.size() == 2);
  CHECK(made[1].repeats == 1);
  CHECK(other.stepped == 2);
  CHECK(one.stepped == 1 + made[0].repeats);
}

TEST_CASE("steps end when there are twice as many particles") {
  CountedFlow flow;
  CHECK(measured_alone(flow, {.steps = 3}, {.steps = 8, .seconds = 1e-9}).steps == 3);
  CHECK(flow.stepped == 2 * 3);
  CHECK(measured_alone(flow, {.steps = 1}, {.steps = 8, .seconds = 1e-9}).particles == 2);
}

TEST_CASE("a time that takes longer than there is patience for is measured once") {
  CountedFlow flow;
  CHECK(measured_alone(flow, {}, {.steps = 2, .seconds = 1e-4, .most_repeats = 9}).repeats == 1);
}
