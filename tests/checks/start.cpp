#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "checks/history_rows.hpp"
#include "checks/made_up.hpp"
#include "checks/scenes.hpp"
#include "exact/cylinder_drag.hpp"
#include "io/tables/table.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

// In units of the diameter and the stream: T = 2 t, Re_R = Re/2.
double bar_lev_and_yang(double re, double t) {
  using std::numbers::pi;
  return 4 * std::sqrt(pi / (re * t)) + 4 * pi / re - 4 * std::sqrt(pi * t / (re * re * re));
}

// Re = 100; five steps until T = 0.1.
MadeUpRun held(double part) {
  MadeUpRun run(cylinder_by_hand, {"time.dt=0.01", "check.early_drag_max=0.02"});
  run.with("cd_impulse",
           [=](double t) { return t < 0.055 ? (1 + part) * bar_lev_and_yang(100, t) : 7; });
  return run;
}

}  // namespace

TEST_CASE("the mean drag until T = 0.1 is held against that of a circle in a sudden stream") {
  CHECK(*held(0).verdict(20).reached.value < 1e-12);
  for (const double part : {0.01, -0.01}) {
    CHECK(held(part).verdict(20).passed());
    CHECK(*held(part).verdict(20).reached.value == Approx(0.01));
    CHECK(held(3 * part).verdict(20).missed());
  }
  CHECK(held(NAN).verdict(20).missed());
  MadeUpRun jumps = held(0);  // by as much up as down: the mean is what counts
  jumps.with("cd_impulse", [](double t) {
    return bar_lev_and_yang(100, t) + (t < 0.015 ? 1 : t < 0.025 ? -1 : 0);
  });
  CHECK(*jumps.verdict(5).reached.value < 1e-12);
}

TEST_CASE("a run that ends before T = 0.1, or steps over it, has no early drag") {
  CHECK(held(0).verdict(5).passed());
  CHECK(held(0).verdict(4).reached.why == "the run ends at T = 0.08");
  const auto over = MadeUpRun(cylinder_by_hand, {"time.dt=0.06", "check.early_drag_max=0.02"});
  CHECK(over.verdict(3).reached.why == "the first step ends after T = 0.1");
}

TEST_CASE("the exact drag of short times errs by what its header says") {
  // Tables of the whole equations, good to 0.015 % (cases/reference/impulsive_cylinder.py).
  for (const int re : {20, 40, 100, 200, 550, 1000, 3000, 9500}) {
    CAPTURE(re);
    const io::Table table(
        fmt::format("{}/cases/reference/cylinder_drag_re{}.csv", VORTREE_SOURCE_DIR, re));
    const auto T = table.column("T"), drag = table.column("C_D");
    const auto off = [&](double time) {
      return exact::short_time_cylinder_drag(re / 2.0, time) /
                 *checks::interpolated(T, drag, time) -
             1;
    };
    CHECK(std::abs(off(0.1)) < 0.01);
    CHECK(std::abs(off(0.2)) < 0.037);
    double ours = 0, whole = 0;
    for (double time = 0.02; time < 0.101; time += 0.02)
      ours += exact::short_time_cylinder_drag(re / 2.0, time),
          whole += *checks::interpolated(T, drag, time);
    CHECK(std::abs(ours / whole - 1) < 0.004);
  }
}
