#include <catch2/catch.hpp>
#include <cmath>

#include "app/loop/run.hpp"
#include "app/program.hpp"
#include "io/frames/frames.hpp"
#include "io/tables/fields.hpp"
#include "io/tables/table.hpp"
#include "vortex/method.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

/// A table of its own.
struct TracerSettings {
  int count = 10;
};

std::vector<Key> keys(TracerSettings& of) {
  return {key("count", of.count, positive, "", "so many points are carried")};
}

/// The smallest method there is: points carried by a given velocity, the stream and a shear across
/// it, (U, V + sin x), by the midpoint rule. All that a method has to bring stands here.
class Tracers final : public flow::Solver {
 public:
  Tracers(const flow::Case& of, int count) : dt_(of.time.dt), stream_(of.flow.stream) {
    for (int k = 0; k < count; ++k) {
      x_.push_back(0.3 * k);
      y_.push_back(0.1 * k * k);
    }
  }

  std::string particle() const override { return "tracer"; }
  std::vector<std::string> phases() const override { return {"carry"}; }

  void step(const tree::Phase& phase) override {
    phase("carry");
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double middle = x_[i] + 0.5 * dt_ * stream_[0];
      x_[i] += dt_ * stream_[0];
      y_[i] += dt_ * rise(middle);
    }
    if (std::abs(y_[0]) > 100) throw flow::Diverged("the first tracer has left");
    ++steps_;
  }

  long steps() const override { return steps_; }
  double time() const override { return static_cast<double>(steps_) * dt_; }
  std::size_t particles() const override { return x_.size(); }

  flow::Columns columns() const override {
    const flow::Samples here = sample({x_, y_});
    return {{"x", "L", x_}, {"y", "L", y_}, {"u", "L/T", here.u}, {"v", "L/T", here.v}};
  }

  flow::Measures measures() const override {
    double height = 0;
    for (const double y : y_) height += y / static_cast<double>(y_.size());
    return {{"tracers", "", static_cast<double>(x_.size())}, {"mean_height", "L", height}};
  }

  std::optional<flow::Force> force() const override { return std::nullopt; }
  double drift() const override { return 0; }

  flow::Samples sample(tree::Points at) const override {
    flow::Samples found;
    for (const double x : at.x) {
      found.u.push_back(stream_[0]);
      found.v.push_back(rise(x));
      found.omega.push_back(std::cos(x));
    }
    return found;
  }

  flow::FrameTable frame_table() const override { return {"heights.csv", {"t", "first", "last"}}; }
  std::vector<double> frame_rows() const override { return {time(), y_.front(), y_.back()}; }
  void save(flow::State& state) const override { state["number of tracers"] = {1.0 * x_.size()}; }

  void restore(long steps, const flow::Columns& columns, const flow::State& state) override {
    steps_ = steps;
    x_ = flow::column(columns, "x");
    y_ = flow::column(columns, "y");
    if (flow::saved_number(state, "number of tracers") != 1.0 * x_.size())
      throw std::out_of_range("tracers are missing");
  }

 private:
  double rise(double x) const { return stream_[1] + std::sin(x); }

  double dt_;
  Pair stream_;
  std::vector<double> x_, y_;
  long steps_ = 0;
};

/// How a scene names it.
class TracerMethod final : public flow::Method {
 public:
  std::unique_ptr<flow::Method> clone() const override {
    return std::make_unique<TracerMethod>(*this);
  }
  std::unique_ptr<flow::Method> blank() const override { return std::make_unique<TracerMethod>(); }
  std::string_view name() const override { return "tracers"; }
  std::vector<SceneTable> tables() override { return {table("carried", settings_)}; }
  std::unique_ptr<flow::Solver> begin(const flow::Case& of, double) const override {
    return std::make_unique<Tracers>(of, settings_.count);
  }

 private:
  TracerSettings settings_;
};

const flow::Methods methods{flow::AnyMethod(std::make_unique<TracerMethod>()),
                            flow::AnyMethod(std::make_unique<vortex::VortexMethod>())};

const std::string scene = R"(
method = "tracers"
[flow]
nu = 0.0
stream = [1.0, 0.5]
[time]
dt = 0.05
end = 1.0
[output]
frames = 0.2
fields = [0.0, 0.5]
window = [0.0, 0.0, 2.0, 1.0]
field_spacing = 0.5
[check]
blobs_max = 10
)";

class Runs {
 public:
  Runs() { folder_.write("tracers.toml", scene); }

  app::RunResult operator()(const std::string& out, std::vector<std::string> overrides = {},
                            bool resume = false, bool figures = false) const {
    return app::run({.scene = (folder_ / "tracers.toml").string(),
                     .overrides = std::move(overrides),
                     .out = folder_ / out,
                     .resume = resume,
                     .figures = figures},
                    methods);
  }

  const TemporaryFolder& folder() const { return folder_; }
  std::string text(const std::string& name) const { return text_of(folder_ / name); }
  io::Table table(const std::string& name) const { return io::Table(folder_ / name); }
  io::Frame last(const std::string& out) const {
    return *io::read_last_good(folder_ / out / "frames.h5").last;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("a method of another kind runs to its end, and leaves what every run leaves") {
  const Runs run;
  const auto result = run("whole");
  CHECK(result.passed());
  CHECK(result.steps == 20);
  const io::Table report = run.table("whole/report.csv");
  const auto t = report.column("t"), height = report.column("mean_height");
  REQUIRE(t.size() == 20);
  // y rises by the integral of 0.5 + sin(x + t): the midpoint rule errs by dt^2/24 of it.
  const io::Frame last = run.last("whole");
  const auto &x = flow::column(last.columns, "x"), &y = flow::column(last.columns, "y");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double x0 = 0.3 * i, y0 = 0.1 * i * i;
    CHECK(x[i] == Approx(x0 + 1));
    CHECK(y[i] == Approx(y0 + 0.5 + std::cos(x0) - std::cos(x0 + 1)).margin(0.05 * 0.05 / 24));
  }
  CHECK(run.table("whole/heights.csv").column("t").size() == 6);
  for (const char* name : {"summary.json", "frames.xdmf", "fields.h5", "fields.xdmf"})
    CHECK(fs::exists(run.folder() / "whole" / name));
  const std::string summary = run.text("whole/summary.json");
  for (const char* words :
       {"\"method\": \"tracers\"", "\"tracers\": 10", "\"carry\":", "\"largest_tracer_count\": 10"})
    CHECK_THAT(summary, Catch::Matchers::Contains(words));
  CHECK_THAT(run.text("whole/frames.xdmf"), Catch::Matchers::Contains("view/velocity"));
}

TEST_CASE("tracers of a scene go with the flow of any method, to second order, and are resumed") {
  const Runs run;
  const std::vector<std::string> two{
      "tracers=[{line=[0, 1, 2, 1], count=5, from=0.1, every=0.25}, {line=[3, 4, 3, 4]}]"};
  const auto after = [&](const std::string& out) { return run.last(out).state; };
  run("carried", two);
  const flow::State state = after("carried");
  const auto &x = state.at("tracers x"), &y = state.at("tracers y"), &set = state.at("tracers set"),
             &from = state.at("tracers from");
  REQUIRE(x.size() == 1 + 4 * 5);
  CHECK(set[0] == 1);
  CHECK(from[0] == 0);
  CHECK(x[0] == Approx(4));
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (k > 0) CHECK(from[k] == Approx(0.1 + 0.25 * ((k - 1) / 5)));
    const double x0 = k > 0 ? 0.5 * ((k - 1) % 5) : 3, passed = 1 - from[k];
    CHECK(x[k] == Approx(x0 + passed));
    const double rise = 0.5 * passed + std::cos(x0) - std::cos(x0 + passed);
    // dt^2/2 cos x of the first step, 5/12 dt^2 of the change of cos x along the rest
    CHECK(y[k] == Approx((k > 0 ? 1 : 4) + rise).margin(0.05 * 0.05 * (0.5 + 2 * 5. / 12)));
  }
  std::vector<std::string> first = two;
  first.push_back("time.end=0.4");
  run("parts", first);
  run("parts", two, true);
  for (const char* name : {"tracers x", "tracers y", "tracers set", "tracers from"})
    CHECK(after("parts").at(name) == state.at(name));
  run("without");
  CHECK_FALSE(after("without").contains("tracers x"));
  CHECK(run.last("without").columns == run.last("carried").columns);
}

TEST_CASE("tracers that nobody can mean are refused") {
  const Runs run;
  const auto refused = [](const std::string& words) { return Catch::Matchers::Contains(words); };
  CHECK_THROWS_WITH(run("r", {"tracers=[{count=3}]"}), refused("has neither line nor around"));
  CHECK_THROWS_WITH(run("r", {"tracers=[{line=[0, 0, 1, 1], around=0.1}]"}),
                    refused("tracers[0] has both line and around"));
  CHECK_THROWS_WITH(run("r", {"tracers=[{around=0.1}]"}), refused("there is no [body]"));
  CHECK_THROWS_WITH(run("r", {"tracers=[{line=[0, 0, 1, 1], count=0}]"}), refused("1 to 1000000"));
  CHECK_THROWS_WITH(run("r", {"tracers=[{line=[0, 0, 1, 1], count=1000, every=1e-4}]"}),
                    refused("1e+06 at most are carried"));
}

TEST_CASE("a method of another kind, stopped and resumed, ends as one that never was") {
  const Runs run;
  run("whole");
  run("parts", {"time.end=0.4"});
  run("parts", {}, true);
  CHECK(run.last("parts").columns == run.last("whole").columns);
  CHECK(run.text("parts/heights.csv") == run.text("whole/heights.csv"));
  const io::Table whole = run.table("whole/report.csv"), parts = run.table("parts/report.csv");
  for (const char* name : {"t", "T", "tracers", "mean_height", "cd_impulse"})
    CHECK(parts.column(name) == whole.column(name));
}

TEST_CASE("a method of another kind that cannot go on leaves its last good frame") {
  const Runs run;
  CHECK_THROWS_WITH(run("far", {"flow.stream=[1,200]"}),
                    Catch::Matchers::Contains("step 10, t = 0.5: the first tracer has left; the "
                                              "last good frame is that of step 9"));
  CHECK(run.last("far").step == 9);
}

TEST_CASE("figures are drawn of a run by another method") {
  const Runs run;
  run("drawn", {}, false, true);
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator(run.folder() / "drawn"))
    pictures += entry.path().extension() == ".png";
  CHECK(pictures > 0);
}

TEST_CASE("a method that nobody has is refused, with those that there are") {
  const Runs run;
  CHECK_THROWS_WITH(run("none", {"method=lattice"}),
                    Catch::Matchers::Contains("method is \"lattice\"; known: tracers, vortex"));
  CHECK_FALSE(fs::exists(run.folder() / "none"));
}

TEST_CASE("a method reads a table of its own, and leaves those of the others alone") {
  const Runs run;
  CHECK(run("few", {"carried.count=3"}).most_particles == 3);
  CHECK(run("others", {"cores.sigma_0=0.5"}).most_particles == 10);
  CHECK_THROWS_WITH(run("less", {"carried.count=0"}),
                    Catch::Matchers::Contains("carried.count is 0; it must be > 0"));
  CHECK_THROWS_WITH(run("wrong", {"cores.sigma_0=-1"}),
                    Catch::Matchers::Contains("cores.sigma_0 is -1; it must be > 0"));
}

TEST_CASE("what a resumed run may not change is told by its table, a method's own too") {
  const Runs run;
  run("parts", {"time.end=0.4"});
  const auto refused = [&](const std::string& word) {
    return Catch::Matchers::Contains("was run with another " + word + " than");
  };
  CHECK_THROWS_WITH(run("parts", {"carried.count=11"}, true), refused("[carried]"));
  CHECK_THROWS_WITH(run("parts", {"flow.stream=[1,0]"}, true), refused("[flow]"));
  CHECK_THROWS_WITH(run("parts", {"time.dt=0.1"}, true), refused("[time]"));
  CHECK_THROWS_WITH(run("parts", {"seed=5"}, true), refused("seed"));
  CHECK_THROWS_WITH(run("parts", {"body.radius=1"}, true), refused("[body]"));
  CHECK(run("parts", {"cores.sigma_0=0.5", "title=Other", "check.blobs_max=11"}, true).finished);
}
