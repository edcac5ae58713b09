#include "flow/force_history.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

using namespace vortree;
using flow::Force;
using flow::ForceHistory;
using flow::Measures;

namespace {

const flow::Scales stream{.body = true, .impulsive = true};

using Of = std::function<double(double t)>;

// The forces 0 .. n on a body to which the fluid has given given(t) along x, all by pressure but
// for a steady friction of 0.1, and -2 given(t) along y by impulse alone.
std::vector<Force> forces(const Of& given, double dt, int n, double start = 0) {
  std::vector<Force> list;
  for (int k = 0; k <= n; ++k) {
    const double t = start + k * dt;
    Force f{.t = t, .impulse = {-given(t), 2 * given(t)}, .friction = {0.1, 0}};
    if (k > 0) f.pressure.x = (given(t) - given(t - dt)) / dt - 0.1;
    list.push_back(f);
  }
  return list;
}

struct Row {
  double t;
  Measures of;
  double operator[](const char* name) const { return flow::measured(of, name); }
};

// As a run asks for them: each when the one after it is known, the last at the end.
std::vector<Row> rows_of(const std::vector<Force>& all, ForceHistory history,
                         std::size_t first = 0) {
  std::vector<Row> rows;
  for (std::size_t k = first; k < all.size(); ++k) {
    history.add(all[k]);
    if (history.size() > 2) rows.push_back({all[k - 1].t, history.of_last_but_one()});
  }
  if (history.size() > 1) rows.push_back({all.back().t, history.of_last()});
  return rows;
}

std::vector<Row> rows_of(const std::vector<Force>& all, const flow::Scales& scales = stream) {
  return rows_of(all, ForceHistory(scales));
}

}  // namespace

TEST_CASE("forces are exact to the last row for what goes as 1, sqrt(t) and t") {
  const Of given = [](double t) { return 3 + 0.7 * std::sqrt(t) + 0.4 * t; };
  for (const int steps : {2, 3, 4, 9}) {
    const auto rows = rows_of(forces(given, 0.02, steps));
    REQUIRE(rows.size() == static_cast<std::size_t>(steps));
    for (const Row& row : rows) {
      CAPTURE(steps, row.t);
      const double force = 0.35 / std::sqrt(row.t) + 0.4;
      CHECK(row["cd_impulse"] == Approx(2 * force).epsilon(1e-11));
      CHECK(row["cd_wall"] == Approx(2 * force).epsilon(1e-11));
      CHECK(row["cl_impulse"] == Approx(-4 * force).epsilon(1e-11));
    }
  }
}

TEST_CASE("the error of the last row falls as dt^2, like that of the others") {
  const Of given = [](double t) { return std::sin(3 * t); };
  const auto errors = [&](double dt) {  // of the last row, and of that before it
    const auto rows = rows_of(forces(given, dt, static_cast<int>(std::lround(1 / dt))));
    std::vector<double> off;
    for (const Row* row : {&rows.back(), &rows[rows.size() - 2]})
      for (const char* route : {"cd_impulse", "cd_wall"})
        off.push_back(std::abs((*row)[route] - 6 * std::cos(3 * row->t)));
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
  double squares = 0;
  for (int noisy = 0; noisy < 4; ++noisy) {
    auto list = forces([](double) { return 0; }, dt, 8, start);
    list[list.size() - 1 - noisy].impulse.x = 1;
    squares += std::pow(rows_of(list).back()["cd_impulse"] / 2 * dt, 2);
  }
  CHECK(std::sqrt(squares) == Approx(std::sqrt(2.45)).epsilon(1e-3));  // (21, -13, -17, 9)/20
}

TEST_CASE("a run of one step has the force of sqrt(t) after an impulsive start, else of t") {
  const auto impulsive = rows_of(forces([](double t) { return std::sqrt(t); }, 0.02, 1));
  REQUIRE(impulsive.size() == 1);
  CHECK(impulsive[0]["cd_impulse"] == Approx(1 / std::sqrt(0.02)));
  CHECK(impulsive[0]["cd_wall"] == Approx(1 / std::sqrt(0.02) - 0.1 + 0.2));  // half of -0.1 t
  const flow::Scales gentle{.body = true, .length = 2, .speed = 3};
  const auto rows = rows_of(forces([](double t) { return 5 * t; }, 0.02, 1), gentle);
  CHECK(rows[0]["cl_impulse"] == Approx(-2.0 / (9 * 2) * 10));
}

TEST_CASE("what the frame of a moving body hides is added to both routes, in the last row too") {
  auto list = forces([](double t) { return t; }, 0.02, 6);
  for (Force& f : list) f.frame = {0.25 * f.t, -3};
  for (const Row& row : rows_of(list)) {
    CHECK(row["cd_impulse"] == Approx(2 + 0.5 * row.t));
    CHECK(row["cd_wall"] == Approx(2 + 0.5 * row.t));
    CHECK(row["cl_impulse"] == Approx(-4 - 6));
    CHECK(row["cl_wall"] == Approx(-6));
  }
}

TEST_CASE("drag is along the stream, lift a quarter turn on from it") {
  const flow::Scales up{.body = true, .along = {0, 1}, .impulsive = true};
  const auto list = forces([](double t) { return t; }, 0.02, 6);
  const auto across = rows_of(list), along = rows_of(list, up);
  for (std::size_t k = 0; k < across.size(); ++k) {
    CHECK(along[k]["cd_impulse"] == across[k]["cl_impulse"]);
    CHECK(along[k]["cl_impulse"] == -across[k]["cd_impulse"]);
  }
}

TEST_CASE("a history that is saved and restored goes on to the same bits, wherever it is cut") {
  const auto list = forces([](double t) { return std::sin(t) + std::sqrt(t); }, 0.02, 7);
  const auto whole = rows_of(list);
  for (std::size_t cut = 1; cut < list.size(); ++cut) {
    ForceHistory first(stream), second(stream);
    for (std::size_t k = 0; k < cut; ++k) first.add(list[k]);
    flow::State state;
    first.save(state);
    second.restore(state);
    const auto rest = rows_of(list, second, cut);
    REQUIRE(rest.size() <= whole.size());
    for (std::size_t k = 0; k < rest.size(); ++k)
      CHECK(rest[k].of == whole[whole.size() - rest.size() + k].of);
  }
}

TEST_CASE("pressure, with what the frame hides, and friction add up to the force by the wall") {
  auto list = forces([](double t) { return t * t; }, 0.02, 6);
  for (Force& f : list) f.friction = {0.3, -f.t}, f.frame = {0.25 * f.t, -3};
  for (const Row& row : rows_of(list)) {
    CHECK(row["cd_pressure"] + row["cd_friction"] == Approx(row["cd_wall"]).epsilon(1e-13));
    CHECK(row["cl_pressure"] + row["cl_friction"] == Approx(row["cl_wall"]).epsilon(1e-13));
    CHECK(row["cd_friction"] == Approx(0.6));
    CHECK(row["cl_friction"] == Approx(-2 * row.t));
    CHECK(row["cl_pressure"] == Approx(-6));
  }
}

TEST_CASE("a moment is the rate of change of what pressure has given, and the others as they are") {
  const flow::Scales large{.body = true, .length = 2, .speed = 3, .impulsive = true};
  const double dt = 0.02;
  std::vector<Force> list;
  for (int k = 0; k <= 7; ++k) {
    const double t = k * dt, before = t - dt;
    const auto given = [](double at) { return 0.7 * std::sqrt(at) + 0.4 * at; };
    Force f{.t = t, .friction_moment = 0.2 * t, .frame_moment = -0.5};
    if (k > 0) f.pressure_moment = (given(t) - given(before)) / dt;
    list.push_back(f);
  }
  for (const Row& row : rows_of(list, large)) {
    const double moment = 0.35 / std::sqrt(row.t) + 0.4 + 0.2 * row.t - 0.5;
    CHECK(row["cm_wall"] == Approx(moment / (0.5 * 9 * 4)).epsilon(1e-10));
    CHECK(row["cd_wall"] == 0);
  }
}

TEST_CASE("without a body the first names are the same, and there is no force") {
  const auto none = ForceHistory::none(false), body = ForceHistory::none(true);
  REQUIRE(none.size() == 4);
  const auto some = rows_of(forces([](double t) { return t; }, 0.1, 3)).front().of;
  REQUIRE(some.size() == body.size());
  for (std::size_t k = 0; k < some.size(); ++k) {
    CHECK(some[k].name == body[k].name);
    CHECK(body[k].value == 0);
    if (k < none.size()) CHECK(none[k] == body[k]);
  }
}
