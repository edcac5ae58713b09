#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <string>

#include "body/shapes/circle.hpp"
#include "cylinder_flow.hpp"
#include "exact/cylinder_drag.hpp"
#include "flows.hpp"
#include "fmm/plan.hpp"
#include "vortex/cores/folded_core.hpp"
#include "vortex/step.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Problem;

namespace {

// Units of the diameter and the stream: T = U t/R = 2 t, and C_D = 2 F.
constexpr double re = 550, nu = 1 / re, dt = 0.005;
constexpr int steps = 20;

struct Run {
  Blobs blobs;
  std::vector<vortex::Wake> wakes;  // the start's, then each step's
  double worst_circulation = 0;
  std::vector<double> rounding;  // what round-off leaves of a vanishing moment, at each wake

  /// Force at the middle of step k by the moment's rate of change, per unit density.
  Vec2 by_impulse(int k) const {
    const Vec2 change = wakes[k].moment - wakes[k - 1].moment;
    return (1 / dt) * Vec2{-change.y, change.x};
  }
  /// Force during step k by what acts on the wall; the friction is known at the step's ends.
  Vec2 by_wall(int k) const {
    return wakes[k].pressure[0].force +
           0.5 * (wakes[k - 1].friction[0].force + wakes[k].friction[0].force);
  }
  /// What round-off leaves of a vanishing force, by either route: moments, or sheets, over dt.
  double force_rounding(int k) const { return (rounding[k - 1] + rounding[k]) / dt; }
};

/// The moment holds that of a sheet which answers to sums over all n blobs. A sum of n terms is
/// known to n unit round-offs of their sizes.
double moment_rounding(const Blobs& blobs) {
  constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
  double sizes = 0;
  for (std::size_t i = 0; i < blobs.size(); ++i)
    sizes += std::abs(blobs.gamma[i]) * std::hypot(blobs.x[i], blobs.y[i]);
  return static_cast<double>(blobs.size()) * unit * sizes;
}

vortex::Wall cylinder_wall() {
  return vortex::Wall(body::circle({}, 0.5), 200);
}

Problem problem_of(const vortex::Wall& wall, const fmm::Options& velocity) {
  return {.flow = {{1, 0}, nu},
          .dt = dt,
          .sigma_0 = std::sqrt(2 * nu * dt),
          .splitting = {.sigma_max = 0.0121},
          .merging = {.tolerance = 0.02, .sigma_max = 1.1 * 0.0121},
          .wall = &wall,
          .sums = velocity};
}

Run impulsive_start(const vortex::Wall& wall, const fmm::Options& velocity, int count = steps) {
  const Problem problem = problem_of(wall, velocity);
  Run run;
  run.wakes.push_back(start(run.blobs, problem));
  run.rounding.push_back(moment_rounding(run.blobs));
  for (int k = 1; k <= count; ++k) {
    run.wakes.push_back(step(run.blobs, problem, k, [](std::string_view) {}));
    run.rounding.push_back(moment_rounding(run.blobs));
    const double total = invariants(run.blobs, &wall.shape()).circulation;
    run.worst_circulation = std::max(run.worst_circulation, std::abs(total));
  }
  return run;
}

const Run& by_direct_sum() {
  static const Run run = impulsive_start(
      cylinder_wall(), fmm::Options{.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct});
  return run;
}

const Run& by_boxes() {
  static const Run run =
      impulsive_start(cylinder_wall(), fmm::Options{.tolerance = 1e-8, .cores = fmm::Cores::mean});
  return run;
}

double short_time_drag(int k) {
  return exact::short_time_cylinder_drag(re / 2, 2 * (k - 0.5) * dt);
}

}  // namespace

TEST_CASE("past a cylinder the whole circulation stays 0 to round-off, Kelvin's theorem") {
  CHECK(by_direct_sum().worst_circulation < 1e-13);
  CHECK(by_boxes().worst_circulation < 1e-13);
}

TEST_CASE("an impulsively started cylinder's drag is that of short times to 2 %, by either route") {
  // Blobs of one release all split in one step, and the drag jumps then: means over windows of T.
  for (const Run* run : {&by_direct_sum(), &by_boxes()}) {
    for (int first : {6, 11}) {  // by T = 0.2 convection, which the formula lacks, adds 3 %
      double exact = 0, impulse = 0, wall = 0;
      for (int k = first; k < first + 5; ++k) {
        exact += short_time_drag(k);
        impulse += 2 * run->by_impulse(k).x;
        wall += 2 * run->by_wall(k).x;
      }
      INFO("steps from " << first);
      CHECK(impulse == Approx(exact).epsilon(0.02));
      CHECK(wall == Approx(exact).epsilon(0.02));
      CHECK(wall == Approx(impulse).epsilon(0.012));
    }
  }
}

TEST_CASE("by the direct sum the flow past a cylinder stays its own mirror image, without lift") {
  const Run& run = by_direct_sum();
  const auto shape = body::circle({}, 0.5);
  const Blobs blobs = test::folded_there(run.blobs, shape.get());
  CHECK(test::apart(blobs, test::mirrored(blobs)) < 1e-8);  // on the wall, the root of round-off
  for (int k = 1; k <= steps; ++k) {
    CAPTURE(k);
    CHECK(std::abs(run.by_impulse(k).y) < run.force_rounding(k));
    CHECK(std::abs(run.by_wall(k).y) < run.force_rounding(k));
  }
}

TEST_CASE("by boxes the lift of a symmetric flow keeps below 0.02") {
  for (int k = 1; k <= steps; ++k) {
    CHECK(std::abs(2 * by_boxes().by_impulse(k).y) < 0.02);
    CHECK(std::abs(2 * by_boxes().by_wall(k).y) < 0.02);
  }
}

TEST_CASE("boxes and direct sum lead to the same drag, until blobs merge with other partners") {
  for (int k = 1; k <= steps; ++k) {
    CAPTURE(k);
    CHECK(by_boxes().by_impulse(k).x ==
          Approx(by_direct_sum().by_impulse(k).x).epsilon(k < 5 ? 1e-5 : 0.01));
  }
}

TEST_CASE("no blob enters the cylinder: not where it acts, nor its centre by more than its sag") {
  const auto shape = body::circle({}, 0.5);
  const Blobs& blobs = by_direct_sum().blobs;
  const vortex::FoldedBlobs acts = fold(blobs, shape.get());
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const body::WallPoint w = shape->nearest(blobs.centre(i));
    const vortex::Covariance v = blobs.core(i).covariance(w.normal);
    CHECK(height(w, v) > -1e-14);
    CHECK(shape->distance(acts.at(i)) > 0);
  }
}

TEST_CASE("a whole run past a cylinder is the same bits for any number of threads") {
  const vortex::Wall wall = cylinder_wall();
  const auto velocity = fmm::Options{.cores = fmm::Cores::mean};
  const auto run = [&] { return impulsive_start(wall, velocity, 5).blobs; };
  const Blobs once = test::with_threads(1, run);
  CHECK(once == test::with_threads(2, run));
}

TEST_CASE("what a step has released cancels the slip from where it is, some way off the wall") {
  const vortex::Wall wall(body::circle({}, 0.5), 200);
  Problem p =
      problem_of(wall, fmm::Options{.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct});
  p.flow.nu = 0.05;  // so that it is a tenth of the radius away
  p.dt = 0.08;
  p.sigma_0 = std::sqrt(2 * p.flow.nu * p.dt);
  p.splitting.sigma_max = 10;
  p.merging.tolerance = 0;
  Blobs blobs;
  start(blobs, p);
  const vortex::Wake wake = step(blobs, p, 100, [](std::string_view) {});
  const vortex::FoldedBlobs at = fold(blobs, &wall.shape());
  vortex::Velocities bare(2 * wall.panels());
  fmm::Plan(fmm::Sources{at.x, at.y, blobs.gamma, at.sigma}, p.sums)
      .velocity_bare(wall.samples(), bare.u, bare.v);
  double slip = 0, sheet = 0;
  for (const double s : wall.slip(p.flow.stream, bare, at, blobs.gamma))
    slip = std::max(slip, std::abs(s));
  for (const double s : wake.sheet) sheet = std::max(sheet, std::abs(s));
  // A sheet that cancels it on the wall leaves a tenth, this one the square of that.
  const double away = p.sigma_0 * vortex::folded::inverse_sqrt_pi / 0.5;
  CAPTURE(slip, sheet, away);
  CHECK(away == Approx(0.1).epsilon(0.1));
  CHECK(slip < away * away * sheet);
}

TEST_CASE("velocity at points is that of stream, blobs and the sheet that holds the body at rest") {
  const vortex::Wall wall = cylinder_wall();
  const auto velocity = fmm::Options{.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct};
  Blobs blobs;
  blobs.append({0.1, 0.9}, 1, 0.05);
  blobs.append({0.1, -0.9}, -1, 0.05);
  const std::vector<double> x{100, 0, -100, 0, 0.3}, y{0, 100, 3, 0.8, -0.6};
  const vortex::Velocities u = velocity_at({x, y}, blobs, problem_of(wall, velocity));
  const auto core = [](std::complex<double> d) {  // what a Gaussian core leaves of a vortex
    return -std::expm1(-std::norm(d) / (0.05 * 0.05));
  };
  for (std::size_t k = 0; k < x.size(); ++k) {
    const test::Complex z{x[k], y[k]}, up{0.1, 0.9}, down{0.1, -0.9};
    const test::Complex cores =
        ((core(z - up) - 1) / (z - up) - (core(z - down) - 1) / (z - down)) /
        (2 * std::numbers::pi * test::i_unit);
    const test::Complex exact = test::stream_past(0.5, z) + test::vortex_beside(0.5, up, -1, z) -
                                test::vortex_beside(0.5, down, -1, z) + cores;
    CHECK(std::abs(test::Complex{u.u[k], -u.v[k]} - exact) < 5e-5);
  }
}

TEST_CASE("a step past a wall names its phases in their order") {
  const vortex::Wall wall = cylinder_wall();
  const auto velocity = fmm::Options{.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct};
  const Problem problem = problem_of(wall, velocity);
  std::vector<std::string> names;
  Blobs blobs;
  step(blobs, problem, 20, [&](std::string_view name) { names.emplace_back(name); });
  CHECK(names == std::vector<std::string>{"convect", "wall", "split", "merge"});
  CHECK(blobs.size() >= wall.panels());
}

TEST_CASE("what a step counts is what becomes of the number of blobs") {
  const vortex::Wall wall = cylinder_wall();
  Problem problem = problem_of(wall, {.method = fmm::SumMethod::direct});
  problem.splitting.scheme = vortex::SplitScheme::ring;
  problem.splitting.children = 4;  // as beside a wall
  for (const double tolerance : {0.02, 0.0}) {
    problem.merging.tolerance = tolerance;
    Blobs blobs;
    start(blobs, problem);
    std::size_t split = 0, merged = 0;
    for (const int k : {6, 7, 8}) {  // of 2, 2 and 1 parts
      const std::size_t before = blobs.size();
      const vortex::StepCounts made = step(blobs, problem, k, [](std::string_view) {}).counts;
      CHECK(made.released == (k < 8 ? 2 : 1) * wall.panels());
      CHECK(made.laid == 0);
      CHECK(blobs.size() == before + made.released + 3 * made.split - made.merged);
      split += made.split;
      merged += made.merged;
    }
    CHECK(split > 0);
    CHECK((merged > 0) == (tolerance > 0));
  }
}

TEST_CASE("what is laid onto lattices has no children, and nodes merge as before") {
  const vortex::Wall wall = cylinder_wall();
  Problem problem = problem_of(wall, {.method = fmm::SumMethod::direct});
  problem.splitting.scheme = vortex::SplitScheme::lattice;
  Blobs blobs;
  start(blobs, problem);
  std::size_t laid = 0;
  for (const int k : {8, 9, 10}) {
    const std::size_t before = blobs.size();
    const vortex::StepCounts made = step(blobs, problem, k, [](std::string_view) {}).counts;
    CHECK(made.laid + made.split <= before + made.released);
    CHECK(made.beside_wall > 0);
    laid += made.laid;
  }
  CHECK(laid > 0);
}

TEST_CASE("the first steps past a wall have 8, 4, 3, 2, 2, 2 and 2 parts") {
  const vortex::Wall wall = cylinder_wall();
  const auto velocity = fmm::Options{.cores = fmm::Cores::mean, .method = fmm::SumMethod::direct};
  const auto parts = [&](std::uint64_t number) {
    Blobs blobs;
    int count = 0;
    step(blobs, problem_of(wall, velocity), number,
         [&](std::string_view name) { count += name == "convect"; });
    return count;
  };
  std::vector<int> counts;
  for (std::uint64_t number = 1; number <= 9; ++number) counts.push_back(parts(number));
  CHECK(counts == std::vector<int>{8, 4, 3, 2, 2, 2, 2, 1, 1});
}

TEST_CASE("the drag of the first steps is right to 1 %, as substeps lengthen, too") {
  // What scenes choose with an accuracy of 1/120. cases/reference/cylinder_drag_re40.csv at the
  // middle of steps 5, 8 and 11. Where substeps double at once, the fifth is 2.2 % low.
  const double nu = 1.0 / 40, dt = 1.0 / 60;
  const vortex::Wall wall(body::circle({}, 0.5), 128);
  Problem problem = problem_of(wall, {.tolerance = 1e-5, .cores = fmm::Cores::mean});
  problem.flow.nu = nu;
  problem.dt = dt;
  problem.sigma_0 = std::sqrt(2 * nu * dt);
  problem.splitting.sigma_max = std::sqrt(8 * nu * dt);
  problem.merging = {1.0 / 120, 3, std::sqrt(1.2 * 8 * nu * dt)};
  Blobs blobs;
  std::vector<vortex::Wake> wakes{start(blobs, problem)};
  for (int k = 1; k <= 11; ++k) wakes.push_back(step(blobs, problem, k, [](std::string_view) {}));
  const std::array<std::pair<int, double>, 3> references{
      {{5, 4.44800}, {8, 3.56364}, {11, 3.11265}}};
  for (const auto& [k, exact] : references) {
    const double drag = -2 * (wakes[k].moment.y - wakes[k - 1].moment.y) / dt;
    CAPTURE(k, drag / exact - 1);
    CHECK(drag == Approx(exact).epsilon(0.01));
  }
}

namespace {

/// Mean drag coefficients of T = 0.1 to 0.3, of cores that grow on the wall without ever splitting,
/// Re = 40.
struct Drags {
  double impulse, wall;
};

Drags drag_of_growing_cores() {
  // From the eighth on steps are whole.
  constexpr int from = 10, to = 30;
  const vortex::Wall wall = cylinder_wall();
  const Problem problem{.flow = {{1, 0}, 1.0 / 40},
                        .dt = 0.005,
                        .sigma_0 = std::sqrt(2 * 0.005 / 40),
                        .splitting = {.sigma_max = 0.5},
                        .merging = {.tolerance = 0.04, .reach = 3, .sigma_max = 0.5},
                        .wall = &wall,
                        .sums = fmm::Options{.tolerance = 1e-5, .cores = fmm::Cores::mean}};
  Run run;
  run.wakes.push_back(start(run.blobs, problem));
  for (int k = 1; k <= to; ++k)
    run.wakes.push_back(step(run.blobs, problem, k, [](std::string_view) {}));
  const auto at = [&](int k) -> const vortex::Wake& { return run.wakes[k]; };
  Drags drags{-2 * (at(to).moment.y - at(from).moment.y) / ((to - from) * problem.dt), 0};
  for (int k = from + 1; k <= to; ++k)
    drags.wall += (at(k).pressure[0].force.x +
                   (at(k - 1).friction[0].force.x + at(k).friction[0].force.x) / 2) *
                  2 / (to - from);
  return drags;
}

}  // namespace

TEST_CASE("cores that grow on a cylinder without a split leave its drag right to 3.5 %") {
  // Simpson's rule, cases/reference/cylinder_drag_re40.csv. The wall sees that the cores, in the
  // end a third of the radius, are wider along it than across: as points they have 10 % less.
  const double exact = (5.35034 + 4 * 4.44800 + 2 * 3.91841 + 4 * 3.56364 + 3.30726) / 12;
  const Drags drags = drag_of_growing_cores();
  CHECK(drags.impulse == Approx(exact).epsilon(0.035));
  CHECK(drags.wall == Approx(exact).epsilon(0.035));
}
