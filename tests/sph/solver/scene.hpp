#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "body/some_bodies.hpp"
#include "flow/case.hpp"
#include "sph/method.hpp"
#include "sph/solver.hpp"

namespace vortree::sph::test {

/// A scene of the method as a file would have it: what is set counts as written.
struct SphScene {
  flow::Case of;
  SphMethod method;
  std::set<std::string, std::less<>> written;

  /// A circle of diameter 1 in a stream of 1, Re = 20.
  SphScene() {
    of.flow.stream = {1, 0};
    of.flow.nu = 0.05;
    of.body = vortree::test::circle(0.5);
    of.time.end = 1;
  }

  template <class T>
  SphScene& set(std::string_view name, T value) {
    for (const SceneTable& table : method.tables())
      for (const Key& key : table.keys())
        if (key.name == name) {
          put(key.target, value);
          written.insert(std::string(table.name) + "." + std::string(name));
          return *this;
        }
    FAIL("no key " << name);
    return *this;
  }

  /// One more ellipse with finer particles.
  SphScene& region(Pair centre, Pair half_axes, double spacing) {
    for (const Key& key : method.tables().front().keys()) {
      const auto* list = std::get_if<ListOfTables>(&key.target);
      if (!list) continue;
      list->resize(list->size() + 1);
      for (const Key& own : list->keys(list->size() - 1)) {
        if (own.name == "centre") *std::get<Pair*>(own.target) = centre;
        if (own.name == "half_axes") *std::get<Pair*>(own.target) = half_axes;
        if (own.name == "spacing") *std::get<double*>(own.target) = spacing;
      }
    }
    return *this;
  }

  SphScene& step(double dt) {
    of.time.dt = dt;
    written.insert("time.dt");
    return *this;
  }

  /// Fills in what is not written, and refuses what cannot be meant.
  SphScene& choose() {
    flow::complete_meetings(of);
    method.choose(of, [&](std::string_view table, std::string_view key) {
      return written.contains(std::string(table) + "." + std::string(key));
    });
    method.refuse(of);
    return *this;
  }

  /// The value of a key of [sph] by now.
  double number(std::string_view name) {
    for (const Key& key : method.tables().front().keys()) {
      if (key.name != name) continue;
      if (const auto real = std::get_if<double*>(&key.target)) return **real;
      if (const auto whole = std::get_if<int*>(&key.target)) return **whole;
    }
    FAIL("no number " << name);
    return 0;
  }
  std::array<double, 4> box() {
    for (const Key& key : method.tables().front().keys())
      if (key.name == "box")
        return std::get<std::optional<std::array<double, 4>>*>(key.target)->value();
    return {};
  }

  [[nodiscard]] std::unique_ptr<flow::Solver> begin() const { return method.begin(of, 1e9); }

 private:
  static void put(const Target& target, double value) {
    if (const auto real = std::get_if<double*>(&target)) **real = value;
    if (const auto whole = std::get_if<int*>(&target)) **whole = static_cast<int>(value);
    if (const auto open = std::get_if<std::optional<double>*>(&target)) **open = value;
  }
  static void put(const Target& target, int value) { put(target, static_cast<double>(value)); }
  static void put(const Target& target, std::array<double, 4> value) {
    *std::get<std::optional<std::array<double, 4>>*>(target) = value;
  }
  template <Worded E>
  static void put(const Target& target, E value) {
    std::get<OneOf>(target).set(static_cast<std::size_t>(value));
  }
};

/// Small and coarse: about a thousand particles, a step of 0.05.
inline SphScene small_scene() {
  SphScene scene;
  scene.set("spacing", 0.1).set("box", std::array{-1.8, -1.7, 2.2, 1.7}).step(0.05);
  return scene;
}

inline std::unique_ptr<flow::Solver> small_flow() {
  return small_scene().choose().begin();
}

inline void advance(flow::Solver& solver, int steps) {
  for (int k = 0; k < steps; ++k) solver.step([](auto) {});
}

/// All numbers that a flow tells, to be equal to the last bit.
struct Told {
  flow::Columns columns;
  flow::Measures measures;
  flow::State state;
  std::vector<double> rows, force;
  double time, drift;
  explicit Told(const flow::Solver& solver)
      : columns(solver.columns()),
        measures(solver.measures()),
        rows(solver.frame_rows()),
        time(solver.time()),
        drift(solver.drift()) {
    solver.save(state);
    const flow::Force f = solver.force().value_or(flow::Force{});
    force = {f.t,          f.impulse.x,  f.impulse.y, f.pressure.x, f.pressure.y,
             f.friction.x, f.friction.y, f.frame.x,   f.frame.y};
  }
};

inline void check_same(const Told& a, const Told& b) {
  REQUIRE(a.columns.size() == b.columns.size());
  for (std::size_t k = 0; k < a.columns.size(); ++k) {
    CAPTURE(a.columns[k].name);
    CHECK((a.columns[k] == b.columns[k]));
  }
  REQUIRE(a.measures.size() == b.measures.size());
  for (std::size_t k = 0; k < a.measures.size(); ++k) {
    CAPTURE(a.measures[k].name);
    CHECK(a.measures[k].value == b.measures[k].value);
  }
  REQUIRE(a.state.size() == b.state.size());
  for (const auto& [name, values] : a.state) {
    CAPTURE(name);
    CHECK((values == flow::saved(b.state, name)));
  }
  CHECK(a.rows == b.rows);
  CHECK(a.force == b.force);
  CHECK(a.time == b.time);
  CHECK(a.drift == b.drift);
}

}  // namespace vortree::sph::test
