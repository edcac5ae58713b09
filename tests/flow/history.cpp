#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "flow/record.hpp"
#include "flow/scenes.hpp"
#include "io/scene/scene.hpp"

using namespace vortree;
using namespace vortree::test;
using flow::Record;

namespace {

flow::FlowCase flow_of(const std::vector<std::string>& overrides = {}) {
  return flow::flow_case(io::parse_scene(cylinder_by_hand, "cylinder.toml", overrides));
}

using Of = std::function<double(double t)>;

// The records 0 .. n of a flow whose impulse along x is -given(t), all by pressure but for a steady
// friction of 0.1.
std::vector<Record> records(const Of& given, double dt, int n, double start = 0) {
  std::vector<Record> list;
  for (int k = 0; k <= n; ++k) {
    const double t = start + k * dt;
    Record r{.t = t, .T = 2 * t, .impulse_x = -given(t), .impulse_y = 2 * given(t)};
    r.friction_x = 0.1;
    if (k > 0) r.pressure_x = (given(t) - given(t - dt)) / dt - 0.1;
    list.push_back(r);
  }
  return list;
}

std::vector<Record> rows_of(const std::vector<Record>& all, const flow::FlowCase& flow) {
  std::vector<Record> rows;
  flow::History history(flow);
  const auto keep = [&](const Record& row) { rows.push_back(row); };
  for (const Record& one : all) history.add(one, keep);
  history.finish(keep);
  return rows;
}

}  // namespace

TEST_CASE("forces are exact to the last row for what goes as 1, sqrt(t) and t") {
  const auto flow = flow_of();
  const Of given = [](double t) { return 3 + 0.7 * std::sqrt(t) + 0.4 * t; };
  for (const int steps : {2, 3, 4, 9}) {
    const auto rows = rows_of(records(given, 0.02, steps), flow);
    REQUIRE(rows.size() == static_cast<std::size_t>(steps));
    for (const Record& row : rows) {
      CAPTURE(steps, row.t);
      const double force = 0.35 / std::sqrt(row.t) + 0.4;
      CHECK(row.cd_impulse == Approx(2 * force).epsilon(1e-11));
      CHECK(row.cd_wall == Approx(2 * force).epsilon(1e-11));
      CHECK(row.cl_impulse == Approx(-4 * force).epsilon(1e-11));
    }
  }
}

TEST_CASE("the error of the last row falls as dt^2, like that of the others") {
  const auto flow = flow_of();
  const Of given = [](double t) { return std::sin(3 * t); };
  const auto errors = [&](double dt) {  // of the last row, and of that before it
    const auto rows = rows_of(records(given, dt, static_cast<int>(std::lround(1 / dt))), flow);
    std::vector<double> off;
    for (const Record* row : {&rows.back(), &rows[rows.size() - 2]})
      for (const double cd : {row->cd_impulse, row->cd_wall})
        off.push_back(std::abs(cd - 6 * std::cos(3 * row->t)));
    return off;
  };
  const auto coarse = errors(0.02), fine = errors(0.01);
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    CAPTURE(k);
    CHECK(std::log2(coarse[k] / fine[k]) == Approx(2).margin(0.2));
  }
  // Of f''' dt^2: 1/6 in the middle, 2/3 or so at the end of four.
  CHECK(fine[0] < 8 * fine[2]);
}

TEST_CASE(
    "noise of the impulse makes no more of the last row than the end of four records has to") {
  const double dt = 0.01, start = 100;  // far from the start sqrt(t) is as good as t
  const auto flow = flow_of();
  double squares = 0;
  for (int noisy = 0; noisy < 4; ++noisy) {
    auto list = records([](double) { return 0; }, dt, 8, start);
    list[list.size() - 1 - noisy].impulse_x = 1;
    squares += std::pow(rows_of(list, flow).back().cd_impulse / 2 * dt, 2);
  }
  CHECK(std::sqrt(squares) == Approx(std::sqrt(2.45)).epsilon(1e-3));  // (21, -13, -17, 9)/20
}

TEST_CASE("a run of one step has the force of sqrt(t) after an impulsive start, else of t") {
  const auto impulsive =
      rows_of(records([](double t) { return std::sqrt(t); }, 0.02, 1), flow_of());
  REQUIRE(impulsive.size() == 1);
  CHECK(impulsive[0].cd_impulse == Approx(1 / std::sqrt(0.02)));
  CHECK(impulsive[0].cd_wall == Approx(1 / std::sqrt(0.02) - 0.1 + 0.2));  // half of -0.1 t
  const auto flow = flow_of({"flow.stream=[0,0]", "plunge.amplitude=0.1", "plunge.frequency=0.5"});
  const auto gentle = rows_of(records([](double t) { return 5 * t; }, 0.02, 1), flow);
  const auto none = rows_of(records([](double) { return 0; }, 0.02, 1), flow);
  const double scale = 2 / (flow.speed * flow.speed);
  CHECK(gentle[0].cl_impulse - none[0].cl_impulse == Approx(-scale * 5));
}

TEST_CASE(
    "a body that plunges feels its area times its acceleration besides, in the last row too") {
  const auto flow = flow_of({"plunge.amplitude=0.1", "plunge.frequency=0.5"});
  const double omega = std::numbers::pi;
  for (const Record& row : rows_of(records([](double t) { return t; }, 0.02, 6), flow)) {
    const double lift = 2 * std::numbers::pi / 4 * -0.1 * omega * omega * std::cos(omega * row.t);
    CHECK(row.cl_wall == Approx(lift).epsilon(0.05));  // area of sixteen panels
    CHECK(row.cl_impulse == Approx(row.cl_wall - 4).epsilon(1e-9));
    CHECK(row.cd_impulse == Approx(2));
  }
}

TEST_CASE("a history that is saved and restored goes on to the same bits, wherever it is cut") {
  const auto flow = flow_of();
  const auto list = records([](double t) { return std::sin(t) + std::sqrt(t); }, 0.02, 7);
  const auto whole = rows_of(list, flow);
  for (std::size_t cut = 1; cut < list.size(); ++cut) {
    std::vector<Record> rows;
    const auto keep = [&](const Record& row) { rows.push_back(row); };
    flow::History first(flow), second(flow);
    for (std::size_t k = 0; k < cut; ++k) first.add(list[k], keep);
    second.restore(first.saved());
    for (std::size_t k = cut; k < list.size(); ++k) second.add(list[k], keep);
    second.finish(keep);
    REQUIRE(rows.size() == whole.size());
    for (std::size_t k = 0; k < rows.size(); ++k) CHECK(rows[k].values() == whole[k].values());
  }
}

TEST_CASE("free space has rows without forces, and a start alone has none") {
  const auto flow = flow::flow_case(io::parse_scene(
      "[flow]\nnu = 1e-3\n[cores]\nsigma_0 = 0.1\nsigma_max = 0.2\n[initial]\nkind = "
      "\"lamb_oseen\"\ncirculation = 1\ncore = 0.3\n[time]\ndt = 0.02\nend = 1\n",
      "vortex.toml"));
  const auto rows = rows_of(records([](double t) { return t; }, 0.02, 4), flow);
  REQUIRE(rows.size() == 4);
  for (const Record& row : rows) CHECK((row.cd_impulse == 0 && row.cd_wall == 0));
  CHECK(rows.back().t == Approx(0.08));
  CHECK(rows_of(records([](double t) { return t; }, 0.02, 0), flow).empty());
}
