#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "checks/made_up.hpp"
#include "checks/scenes.hpp"
#include "exact/theodorsen.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

const double pi = std::numbers::pi;

// Known up to T = 4; the length of the wake from T = 2 on only, the angle everywhere but 0 at
// first.
std::string known() {
  std::string text = "T,C_D,L_over_D,sep_deg\n";
  for (double T = 0; T < 4.05; T += 0.1)
    text += fmt::format("{},{},{},{}\n", T, 1 + 0.1 * T, T < 1.95 ? "" : fmt::format("{}", T - 1),
                        T < 0.95 ? 0 : 20 * T);
  return text;
}

struct Reference {
  std::string column;
  double (*value)(double T);
};

using Words = std::vector<std::string>;

MadeUpRun held(const std::string& check, Words more = {}) {
  more.push_back("check." + check);
  return MadeUpRun(cylinder_by_hand, more, {{"known.csv", known()}, {"known_550.csv", known()}});
}

}  // namespace

TEST_CASE("drag, wake and separation are held against a reference, where it has values") {
  struct Row {
    std::string check;
    const char* column;
    double (*exact)(double T);
    bool relative;
  };
  const Row row = GENERATE(values<Row>({
      {"drag_max", "cd_impulse", [](double T) { return 1 + 0.1 * T; }, true},
      {"drag_rms", "cd_impulse", [](double T) { return 1 + 0.1 * T; }, true},
      {"bubble_max", "bubble_length", [](double T) { return T - 1; }, true},
      {"separation_max_deg", "separation_deg", [](double T) { return T < 0.95 ? 0 : 20 * T; },
       false},
  }));
  CAPTURE(row.check);
  MadeUpRun run = held(row.check + "=0.02", {"check.drag_reference=known.csv"});
  const auto off_by = [&](double part) {
    return run
        .with(row.column,
              [&row, part](double t) {
                return row.relative ? (1 + part) * row.exact(2 * t) : row.exact(2 * t) + part;
              })
        .verdict(60);
  };
  CHECK(off_by(0).passed());
  CHECK(*off_by(0).reached.value < 1e-12);
  for (const double part : {0.01, -0.01}) {
    CHECK(off_by(part).passed());
    CHECK(*off_by(part).reached.value == Approx(0.01));
  }
  for (const double part : {0.03, -0.03, 1.0}) {
    CHECK(off_by(part).missed());
    CHECK(*off_by(part).reached.value == Approx(std::abs(part)));
  }
  CHECK(off_by(NAN).missed());
  CHECK(off_by(INFINITY).missed());
}

TEST_CASE("lift is held against a reference, as a share of the largest at the times that count") {
  // Through zero, and to 2 at T = 1, which counts only for who begins before it.
  const auto known_lift = [](double T) { return 2 * std::sin(pi * T / 2) * std::exp(1 - T); };
  std::string table = "T,C_L\n";
  for (double T = 0; T < 4.005; T += 0.1) table += fmt::format("{},{}\n", T, known_lift(T));
  const auto run = [&](const std::string& check, const Words& more = {}) {
    Words overrides{"check.lift_reference=known.csv", "check." + check};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return MadeUpRun(cylinder_by_hand, overrides, {{"known.csv", table}});
  };
  double most = 0;
  for (int k = 1; k <= 40; ++k) most = std::max(most, std::abs(known_lift(0.1 * k)));
  for (const std::string check : {"lift_error_max", "lift_error_rms"})
    for (const double off : {0.0, 0.01, -0.01, 0.03, -0.03, 1.0}) {
      CAPTURE(check, off);
      MadeUpRun made = run(check + "=0.02");
      const auto verdict =
          made.with("cl_impulse", [&](double t) { return known_lift(2 * t) + off * most; })
              .verdict(60);
      CHECK(*verdict.reached.value == Approx(std::abs(off)).margin(1e-12));
      CHECK(verdict.passed() == (std::abs(off) < 0.02));
    }
  double late = 0;
  for (int k = 25; k <= 40; ++k) late = std::max(late, std::abs(known_lift(0.1 * k)));
  MadeUpRun from = run("lift_error_max=0.02", {"check.lift_from=2.5"});
  from.with("cl_impulse", [&](double t) { return t < 1.24 ? 9 : known_lift(2 * t) + 0.01 * late; });
  CHECK(*from.verdict(60).reached.value == Approx(0.01).epsilon(1e-9));
  CHECK(from.verdict(20).reached.why == "the run ends at T = 2");
  CHECK(run("lift_error_max=0.02").with("cl_impulse", NAN).verdict(60).missed());
  CHECK(run("lift_error_rms=0.02").with("cl_impulse", INFINITY).verdict(60).missed());
  MadeUpRun none = run("lift_error_max=0.02", {"check.lift_from=5"});
  CHECK(none.verdict(60).reached.why == "the reference has no values for these times");
}

TEST_CASE("a lift of zero that is known is compared with as it is") {
  std::string table = "T,C_L\n";
  for (int k = 0; k <= 40; ++k) table += fmt::format("{},0\n", 0.1 * k);
  MadeUpRun run(cylinder_by_hand, {"check.lift_reference=known.csv", "check.lift_error_max=0.02"},
                {{"known.csv", table}});
  CHECK(run.with("cl_impulse", -0.01).verdict(20).passed());
  CHECK(run.with("cl_impulse", -0.03).verdict(20).missed());
}

TEST_CASE("one value that is not finite among good ones is missed, not passed over") {
  MadeUpRun run = held("drag_max=0.02", {"check.drag_reference=known.csv"});
  for (const double bad : {double(NAN), double(INFINITY)}) {
    const auto verdict =
        run.with("cd_impulse", [&](double t) { return t == 0.5 ? bad : 1 + 0.2 * t; }).verdict(40);
    CHECK(verdict.missed());
    CHECK(checks::verdict_line(std::vector{verdict}) ==
          "check FAILED: drag_max is not finite (missed)");
  }
}

TEST_CASE("only rows from the asked time on count, and a run that ends before has not reached it") {
  MadeUpRun run = held("drag_max=0.02", {"check.drag_reference=known.csv", "check.drag_from=2.0"});
  run.with("cd_impulse", [](double t) { return t < 0.95 ? 7 : 1 + 0.2 * t; });
  CHECK(run.verdict(30).passed());
  const checks::Verdict early = run.verdict(10);
  CHECK_FALSE(early.passed());
  CHECK_FALSE(early.missed());
  CHECK(early.reached.why == "the run ends at T = 1");
  run.with("cd_impulse", 7);
  CHECK(run.verdict(30).missed());
}

TEST_CASE("a reference without values at these times is said to have none") {
  MadeUpRun run = held("drag_max=0.02", {"check.drag_reference=known.csv", "check.drag_from=5"});
  const checks::Verdict verdict = run.verdict(60);
  CHECK_FALSE(verdict.reached.value);
  CHECK(verdict.reached.why == "the reference has no values for these times");
}

TEST_CASE("what is held against a reference that this Reynolds number lacks is not reached") {
  for (const std::string check : {"drag_max", "drag_rms", "bubble_max", "separation_max_deg",
                                  "lift_error_max", "lift_error_rms"}) {
    const std::string force = check.starts_with("lift") ? "lift" : "drag";
    const checks::Verdict verdict =
        held(check + "=0.02", {"flow.nu=0.05", "flow.reynolds=20",
                               "check." + force + "_reference='known_{reynolds}.csv'"})
            .verdict(60);
    CHECK_FALSE(verdict.reached.value);
    CHECK(verdict.reached.why == "there is no reference for this Reynolds number");
  }
}

TEST_CASE("a reference of zero is compared with as it is") {
  MadeUpRun run = held("separation_max_deg=0.5", {"check.drag_reference=known.csv"});
  CHECK(run.verdict(5).passed());  // 0 of 0
  CHECK(held("mean_lift_max=0.02", {"check.mean_lift=0.0"})
            .with("cl_impulse", 0.01)
            .verdict(120)
            .passed());
  CHECK(held("mean_lift_max=0.02", {"check.mean_lift=0.0"})
            .with("cl_impulse", 0.03)
            .verdict(120)
            .missed());
  CHECK(held("lift_routes_max=0.03").verdict(20).passed());  // no lift by either
  CHECK(held("lift_routes_max=0.03").with("cl_wall", 0.1).verdict(20).missed());
  CHECK(held("routes_max=0.03").verdict(20).passed());
  CHECK(held("routes_max=0.03").with("cd_impulse", 0.1).verdict(20).missed());
}

TEST_CASE("two routes to a force agree within what is asked, or not") {
  for (const char* pair : {"routes_max", "lift_routes_max"}) {
    const std::string letter = std::string(pair) == "routes_max" ? "cd" : "cl";
    CAPTURE(pair);
    MadeUpRun run = held(std::string(pair) + "=0.02", {"check.routes_from=0.5"});
    run.with(letter + "_wall", 1.0);
    CHECK(run.with(letter + "_impulse", 1.01).verdict(20).passed());
    CHECK(*run.verdict(20).reached.value == Approx(0.01).epsilon(0.02));
    CHECK(run.with(letter + "_impulse", 0.97).verdict(20).missed());
    CHECK(run.with(letter + "_impulse", [](double t) { return t < 0.24 ? 5 : 1.0; })
              .verdict(20)
              .passed());
    CHECK_FALSE(run.verdict(4).reached.value);
  }
  MadeUpRun lift = held("lift_max=0.02");
  CHECK(lift.with("cl_wall", -0.01).verdict(20).passed());
  CHECK(lift.with("cl_wall", -0.03).verdict(20).missed());
  CHECK(lift.with("cl_wall", 0.0).with("cl_impulse", 0.03).verdict(20).missed());
}

TEST_CASE("a wake that sheds has its frequency and its means, from a hundred rows on") {
  const auto wave = [](double frequency, double mean) {
    return [=](double t) { return mean + std::sin(2 * pi * frequency * t); };
  };
  MadeUpRun strouhal = held("strouhal_max=0.03", {"check.strouhal=0.2", "check.shedding_from=10"});
  CHECK(strouhal.with("cl_impulse", wave(0.2, 0)).verdict(1000).passed());
  CHECK(strouhal.with("cl_impulse", wave(0.21, 0)).verdict(1000).missed());
  CHECK(strouhal.with("cl_impulse", 0.0).verdict(1000).missed());
  CHECK(strouhal.verdict(150).reached.why == "the run ends at T = 15");
  MadeUpRun drag = held("mean_drag_max=0.03", {"check.mean_drag=1.3"});
  CHECK(drag.with("cd_impulse", wave(0.2, 1.32)).verdict(1000).passed());
  CHECK(drag.with("cd_impulse", wave(0.2, 1.4)).verdict(1000).missed());
  CHECK_FALSE(drag.verdict(99).reached.value);
  MadeUpRun thrust = held("mean_drag_max=0.03", {"check.mean_drag=-0.15"});
  CHECK(thrust.with("cd_impulse", wave(0.2, -0.153)).verdict(1000).passed());
  CHECK(thrust.with("cd_impulse", wave(0.2, -0.16)).verdict(1000).missed());
  CHECK(thrust.with("cd_impulse", wave(0.2, 0.15)).verdict(1000).missed());
}

TEST_CASE("of several bodies each has its means, and its lift a frequency, a size and a phase") {
  const auto wave = [](double mean, double size = 1, double ahead_deg = 0, double frequency = 0.2) {
    return [=](double t) {
      return mean + size * std::cos(2 * pi * frequency * t + ahead_deg * pi / 180);
    };
  };
  const auto pair = [&](const std::string& known, const std::string& most) {
    MadeUpRun run(pair_by_hand, {"check." + known, "check." + most});
    run.with("cl_wall_1", wave(0.1)).with("cl_wall_2", wave(-0.1, 0.5, 170));
    run.with("cd_wall_1", wave(1.5)).with("cd_wall_2", wave(-0.3, 0.2));
    return run;
  };
  // 1000 rows are 10 periods.
  MadeUpRun drag = pair("mean_drag_each=[1.5,-0.3]", "mean_drag_each_max=0.03");
  CHECK(*drag.verdict(1000).reached.value < 1e-12);
  CHECK(*drag.with("cd_wall_2", wave(-0.33)).verdict(1000).reached.value == Approx(0.02));
  CHECK(drag.with("cd_wall_2", wave(-0.36)).verdict(1000).missed());
  CHECK(drag.with("cd_wall_2", NAN).verdict(1000).missed());
  CHECK(drag.verdict(99).reached.why == "the run ends at T = 9.9");
  MadeUpRun lift = pair("mean_lift_each=[0.1,-0.1]", "mean_lift_each_max=0.2");
  CHECK(lift.verdict(1000).passed());
  CHECK(lift.with("cl_wall_1", wave(-0.1)).verdict(1000).missed());
  MadeUpRun size = pair(fmt::format("lift_rms_each=[{},{}]", std::sqrt(0.5), std::sqrt(0.125)),
                        "lift_rms_each_max=0.02");
  CHECK(size.verdict(1000).passed());
  CHECK(size.with("cl_wall_2", wave(-0.1, 0.6)).verdict(1000).missed());
  MadeUpRun phase = pair("lift_phases_deg=[-178]", "lift_phases_max_deg=15");
  CHECK(*phase.verdict(1000).reached.value == Approx(12).margin(0.1));
  CHECK(phase.with("cl_wall_2", wave(0, 1, 160)).verdict(1000).missed());
  CHECK(phase.with("cl_wall_2", wave(0, 1, -170)).verdict(1000).passed());
  MadeUpRun strouhal = pair("strouhal=0.2", "strouhal_max=0.03");
  CHECK(strouhal.with("cl_impulse", wave(0, 1, 0, 0.4)).verdict(1000).passed());
  CHECK(strouhal.with("cl_wall_2", wave(0, 1, 0, 0.21)).verdict(1000).missed());
}

TEST_CASE("wall vorticity is held against a reference at the times of frames") {
  std::string reference = "T,theta_deg,omega_R_over_U\n", wall = "t,T,angle_deg,vorticity,sheet\n";
  for (const double T : {0.5, 1.0, 9.0})
    for (int angle = 0; angle <= 180; angle += 10)
      reference += fmt::format("{},{},{}\n", T, angle, T * std::sin(angle * pi / 180));
  // R/U = 0.5: vorticity is twice the reference's; at T = 0.99 and 1.002 there are frames.
  for (const auto& [T, factor] : {std::pair{0.49, 2.0}, {0.99, 7.0}, {1.002, 2.06}})
    for (int angle = 5; angle < 180; angle += 10)
      wall += fmt::format("{},{},{},{},0\n", T / 2, T, angle,
                          factor * std::round(10 * T) / 10 * std::sin(angle * pi / 180));
  const auto run = [&](const std::string& check, const Words& more = {}) {
    Words overrides{"check.wall_vorticity_reference=known.csv", "check." + check};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return MadeUpRun(cylinder_by_hand, overrides, {{"known.csv", reference}, {"wall.csv", wall}})
        .verdict(20);
  };
  CHECK(*run("wall_vorticity_max=0.04").reached.value == Approx(0.03).epsilon(0.02));
  CHECK(*run("wall_vorticity_rms=0.04").reached.value == Approx(0.03 / std::sqrt(2)).epsilon(0.02));
  CHECK(run("wall_vorticity_max=0.04").passed());
  CHECK(run("wall_vorticity_max=0.02").missed());
  CHECK(run("wall_vorticity_rms=0.02").missed());
  CHECK(run("wall_vorticity_max=0.04", {"check.wall_vorticity_from=3"}).reached.why ==
        "the run ends at T = 2");
}

TEST_CASE("pressure at the front is held against a reference at the times of wall.csv") {
  std::string reference = "T,cp_front\n", wall = "t,T,angle_deg,vorticity,sheet,cp,cf\n";
  for (int k = 0; k <= 8; ++k) reference += fmt::format("{},{}\n", 0.25 * k, 1 + 0.025 * k * k);
  // On both sides of the front, but not at it; 0.03 more than it should be at T = 1.1.
  for (const auto& [T, more] : {std::pair{0.3, 0.01}, {1.1, 0.03}, {1.6, -0.02}, {3.0, 7.0}})
    for (int angle = -178; angle < 180; angle += 4)
      wall += fmt::format("{},{},{},0,0,{},0\n", T / 2, T, angle,
                          1 + 0.4 * T * T + more - 4 * std::pow(std::sin(angle * pi / 180), 2));
  const auto run = [&](const std::string& table, const Words& more) {
    Words overrides{"check.front_pressure_reference=known.csv", "check.front_pressure_max=0.025"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return MadeUpRun(cylinder_by_hand, overrides, {{"known.csv", reference}, {"wall.csv", table}})
        .verdict(20);
  };
  // A parabola in the angle is 1e-4 off.
  CHECK(*run(wall, {}).reached.value == Approx(0.03).margin(2e-4));
  CHECK(run(wall, {}).missed());
  CHECK(*run(wall, {"check.front_pressure_from=1.5"}).reached.value == Approx(0.02).margin(2e-4));
  CHECK(run(wall, {"check.front_pressure_from=1.5"}).passed());
  CHECK(run(wall, {"check.front_pressure_from=3"}).reached.why == "the run ends at T = 2");
  CHECK(run("t,T,angle_deg,vorticity,pressure\n", {}).reached.why ==
        "this method tells no cp along the wall");
}

TEST_CASE("a body that plunges in fluid at rest has the drag and mass that are known, or not") {
  const Words plunging{"flow.stream=[0,0]", "plunge.amplitude=0.1", "plunge.frequency=0.5",
                       "time.dt=0.02"};
  const auto run = [&](const std::string& check, const char* known) {
    Words overrides = plunging;
    overrides.insert(overrides.end(), {"check." + check + "_max=0.05", "check." + check + known});
    MadeUpRun made(cylinder_by_hand, overrides);
    // C_D |sin| sin against the velocity, C_M with the place: F = -D/2 C_D |V| V - pi/4 D^2 C_M V'.
    const double U = made.scales().speed, omega = pi;
    made.with("cd_impulse", [=](double t) {
      const double V = -std::sin(omega * t), A = -std::cos(omega * t) * omega / U * U;
      return 2 * (-0.5 * 2.0 * std::abs(V) * V - pi / 4 * 1.1 * A / U);
    });
    return std::pair{made.verdict(400), made.verdict(50)};
  };
  for (const std::string check : {"morison_drag", "morison_mass"}) {
    CAPTURE(check);
    const bool drag = check == "morison_drag";
    const auto [right, early] = run(check, drag ? "=2.0" : "=1.1");
    CHECK(*right.reached.value < 0.01);
    CHECK(right.passed());
    CHECK(early.reached.why == "the run ends before a whole period");
    const auto [wrong, ignored] = run(check, drag ? "=1.8" : "=1.0");
    CHECK(wrong.missed());
    CHECK(*wrong.reached.value == Approx(drag ? 2.0 / 1.8 - 1 : 0.1).epsilon(0.1));
  }
}

TEST_CASE("the lift of a body that plunges across a stream is a plate's, or not") {
  MadeUpRun run(cylinder_by_hand, {"plunge.amplitude=0.05", "plunge.frequency=0.5", "time.dt=0.02",
                                   "check.theodorsen_max=0.05"});
  const double omega = pi, k = omega * 0.5;
  const std::complex<double> plate = exact::lift_of_plunge(0.1, k);
  const auto lift = [=](std::complex<double> factor) {
    return [=](double t) { return std::real(factor * plate * std::polar(1.0, omega * t)); };
  };
  CHECK(run.with("cl_impulse", lift(1.0)).verdict(400).passed());
  CHECK(*run.verdict(400).reached.value < 1e-3);
  CHECK(run.with("cl_impulse", lift(1.1)).verdict(400).missed());
  CHECK(run.with("cl_impulse", lift({0, 1})).verdict(400).missed());  // the size is right
  CHECK_FALSE(run.verdict(99).reached.value);
}

TEST_CASE("a plunge along the stream has no plate's lift, and its own counts as it is") {
  MadeUpRun run(cylinder_by_hand, {"plunge.amplitude=0.05", "plunge.frequency=0.5", "time.dt=0.02",
                                   "plunge.direction=[1,0]", "check.theodorsen_max=0.05"});
  CHECK(run.verdict(400).passed());
  CHECK(run.with("cl_impulse", [](double t) { return std::sin(pi * t); }).verdict(400).missed());
}
