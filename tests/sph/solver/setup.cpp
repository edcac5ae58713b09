#include "sph/setup.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sph/solver/scene.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

SphCase scene_around(const body::BodySettings& body, Pair stream = {1, 0}) {
  SphCase scene;
  scene.flow.stream = stream;
  scene.flow.nu = 0.05;
  scene.body = body;
  scene.time = {.dt = 0.03, .end = 1};
  scene.sph.spacing = 0.1, scene.sph.levels = 2, scene.sph.zone = 0.3, scene.sph.reach = 2.8;
  scene.sph.box = {-2, -2, 2.4, 2};
  return scene;
}

std::size_t count(const Cloud& cloud, ParticleKind kind) {
  return static_cast<std::size_t>(std::ranges::count(cloud.kind, kind));
}

}  // namespace

TEST_CASE("a body's area is that of its outline") {
  const double pi = std::numbers::pi;
  // The outline is a polygon of 4096 corners: (2 pi/4096)^2/6 of a circle are missed.
  CHECK(setup_of(scene_around(vortree::test::circle(0.5))).bodies().area() ==
        Approx(pi / 4).epsilon(1e-6));
  CHECK(setup_of(scene_around(vortree::test::ellipse(0.5, 0.2, 20))).bodies().area() ==
        Approx(pi * 0.1).epsilon(1e-5));
  // 2 * 0.6 (0.2969 * 2/3 - 0.1260/2 - 0.3516/3 + 0.2843/4 - 0.1036/5), the section with its edge
  // closed; rounding moves it by 0.005 of the chord at one end.
  CHECK(setup_of(scene_around(vortree::test::foil(1))).bodies().area() ==
        Approx(0.0819).margin(0.002));
}

TEST_CASE("what is asked of a box is as seen from the body, whose wall is cut into equal parts") {
  SphCase scene = scene_around(vortree::test::circle(0.5));
  scene.body->centre = {0.3, -0.2};
  const SphSetup setup = setup_of(scene);
  CHECK(setup.confines.box.low.x == Approx(-2.3).epsilon(1e-14));
  CHECK(setup.confines.box.high.y == Approx(2.2).epsilon(1e-14));
  CHECK(setup.bodies()[0].nodes == 31);
  CHECK(std::numbers::pi / setup.bodies()[0].spacing == Approx(31).epsilon(1e-12));
  CHECK(setup.dt == 0.03);
}

TEST_CASE("fluid leaves by the side to which the stream goes, and by none in fluid at rest") {
  for (const Pair stream : {Pair{1, 0.9}, Pair{-1, 0}, Pair{0.1, 2}, Pair{0, -1}}) {
    const auto scene = scene_around(vortree::test::circle(0.5), stream);
    const Cloud cloud = starting_cloud(setup_of(scene));
    CAPTURE(stream[0], stream[1]);
    CHECK(count(cloud, ParticleKind::outlet) > 15);
    const OuterBox box = setup_of(scene).confines.box;
    const bool across = std::abs(stream[1]) > std::abs(stream[0]);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (cloud.kind[i] != ParticleKind::outlet) continue;
      CHECK(dot(cloud.normal(i), {stream[0], stream[1]}) < 0);
      CHECK((cloud.ny[i] != 0) == across);
      CHECK(std::abs(box.depth(cloud.at(i))) < 1e-14);
    }
  }
  SphCase plunging = scene_around(vortree::test::circle(0.5), {0, 0});
  plunging.plunge = body::PlungeSettings{0.1, 0.5, {0, 1}};
  CHECK(count(starting_cloud(setup_of(plunging)), ParticleKind::outlet) == 0);
  SphCase turning = scene_around(vortree::test::circle(0.5), {0, 0});
  turning.motion = body::MotionSettings{1};
  CHECK(count(starting_cloud(setup_of(turning)), ParticleKind::outlet) == 0);
}

TEST_CASE("places tell nodes and rings apart, and normals point into the fluid") {
  const SphSetup setup = setup_of(scene_around(vortree::test::ellipse(0.5, 0.3, 10)));
  const Cloud cloud = starting_cloud(setup);
  std::vector<int> seen(count(cloud, ParticleKind::wall));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.kind[i] == ParticleKind::wall) ++seen.at(static_cast<std::size_t>(cloud.place[i]));
    if (cloud.kind[i] == ParticleKind::ring)
      CHECK(setup.bodies().shape()->distance(cloud.at(i)) ==
            Approx(cloud.place[i] * setup.bodies()[0].spacing).epsilon(1e-9));
    if (cloud.free(i)) {
      CHECK(cloud.place[i] == 0);
      CHECK(dot(cloud.normal(i), cloud.normal(i)) == 0);
    } else {
      CHECK(dot(cloud.normal(i), cloud.normal(i)) == Approx(1).epsilon(1e-12));
    }
  }
  CHECK(std::ranges::all_of(seen, [](int times) { return times == 1; }));
}

TEST_CASE("the start fills the plane: with every particle in its place once, everywhere") {
  for (const auto& body : {vortree::test::circle(0.5), vortree::test::foil(1, 5)}) {
    SphCase scene = scene_around(body);
    const SphSetup setup = setup_of(scene);
    const Cloud cloud = starting_cloud(setup);
    Stencils stencils;
    stencils.renew(cloud, setup.operators);
    double sum = 0, worst = 0;
    int inside = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      bool surrounded = cloud.inside(i);
      stencils.for_each(
          i, [&](std::size_t j, std::size_t) { surrounded = surrounded && cloud.inside(j); });
      if (!surrounded) continue;
      ++inside, sum += stencils.filling(i);
      worst = std::max(worst, std::abs(stencils.filling(i) - 1));
    }
    CHECK(inside > 100);
    // Half a spacing inside the box belongs to its nodes, and is filled twice: 15 times 0.1 of 16.
    CHECK(sum / inside == Approx(1).margin(0.09));
    CHECK(worst < 0.25);
    CHECK(stencils.degraded() == 0);
  }
}
