#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sph/choice/cost.hpp"
#include "sph/solver/periodic.hpp"

using namespace vortree;
using namespace vortree::sph::test;
using Catch::Contains;
using Box = std::array<double, 4>;

TEST_CASE("an accuracy chooses spacing, levels, zone, box, reach and step of SPH") {
  SphScene scene;
  scene.of.accuracy = 0.01;
  scene.choose();
  CHECK(scene.number("spacing") == Approx(0.05).epsilon(1e-12));
  CHECK(scene.number("levels") == 3);  // 0.05, 0.1, 0.2: a fifth of the diameter
  CHECK(scene.number("zone") == 0.5);
  CHECK(scene.number("reach") == 2.8);
  CHECK(scene.box() == Box{-5, -5, 7, 5});
  // A whole part of the end, as long as the Courant number 0.3 allows.
  CHECK(scene.of.time.dt <= 0.3 * 0.05);
  CHECK(scene.of.time.dt > 0.9 * 0.3 * 0.05);
  CHECK(std::remainder(1.0, scene.of.time.dt) == Approx(0).margin(1e-12));
  SphScene thinner;  // layers by the root of the Reynolds number
  thinner.of.accuracy = 0.01, thinner.of.flow.nu = 0.05 / 4;
  CHECK(thinner.choose().number("spacing") == Approx(0.025).epsilon(1e-12));
  SphScene coarse;
  coarse.of.accuracy = 0.5;
  CHECK(coarse.choose().number("spacing") == 0.1);
}

TEST_CASE("the box is longer on the side to which the stream goes, around the body") {
  for (const auto& [stream, box] : {std::pair{Pair{1, 0.5}, Box{-4, -6, 8, 4}},
                                    {Pair{-1, 0.5}, Box{-6, -6, 6, 4}},
                                    {Pair{0.5, 2}, Box{-4, -6, 6, 6}},
                                    {Pair{0.5, -2}, Box{-4, -8, 6, 4}}}) {
    SphScene scene;
    scene.of.accuracy = 0.01;
    scene.of.flow.stream = stream;
    scene.of.body->centre = {1, -1};
    CHECK(scene.choose().box() == box);
  }
}

TEST_CASE("the box goes by how far an ellipse extends, not by its first axis") {
  const auto box = [](double radius, double across, double incidence) {
    SphScene scene;
    scene.of.body = vortree::test::ellipse(radius, across, incidence);
    return scene.set("spacing", 0.02).choose().box();
  };
  for (const Box& found : {box(0.1, 0.5, 0), box(0.1, 0.5, 90), box(0.5, 0.1, 90)}) {
    const Box wanted{-5, -5, 7, 5};
    for (int k = 0; k < 4; ++k) CHECK(found[k] == Approx(wanted[k]).epsilon(1e-6));
  }
}

namespace {

/// A circle of diameter 1 in the origin, and one of that radius elsewhere.
SphScene two_circles(Pair centre, double radius = 0.5) {
  SphScene scene;
  scene.of.others.push_back(vortree::test::circle(radius));
  scene.of.others.back().centre = centre;
  return scene;
}

}  // namespace

TEST_CASE(
    "of several bodies the least chooses spacing and levels, and the box holds that of each") {
  SphScene scene = two_circles({2, 3}, 0.125);
  scene.of.accuracy = 0.01;
  scene.choose();
  // The small one has a quarter of the Reynolds number, below 20: 5 * 0.01 of its diameter.
  CHECK(scene.number("spacing") == Approx(0.0125).epsilon(1e-12));
  CHECK(scene.number("levels") == 3);  // to a fifth of its diameter
  CHECK(scene.number("zone") == 0.5);  // half of the greater
  CHECK(scene.box() == Box{-5, -5, 7, 5});
  SphScene alike = two_circles({2, 3});
  alike.of.accuracy = 0.01;
  CHECK(alike.choose().box() == Box{-5, -5, 9, 8});
}

TEST_CASE("how many particles bodies make is foreseen, of several as of one") {
  SphScene single;
  for (SphScene scene : {single, two_circles({0, 1.6}), two_circles({4, 0})}) {
    scene.set("spacing", 0.05).choose();
    const auto& own = scene.method.settings();
    const double foreseen = sph::expected_particles({scene.of, own});
    const double there = static_cast<double>(scene.begin()->particles());
    // Rings and nodes of walls and box stand closer: 10 to 11 % more, of one body or two.
    CHECK(foreseen == Approx(there).epsilon(0.12));
  }
}

TEST_CASE("SPH refuses bodies too close for their rings, cut by the box, or that part") {
  SphScene scene = two_circles({0, 1.5});
  SECTION("too close: two times 4 rings and 3 spacings in a gap of 0.5") {
    scene.set("spacing", 0.05);
    CHECK_THROWS_WITH(scene.choose(), Contains("the gap of 0.5 between two bodies") &&
                                          Contains("4 rings") && Contains("0.0454 at most"));
    CHECK_NOTHROW(scene.set("spacing", 0.045).choose());
  }
  SECTION("fewer rings fit, and hardly ten particles in a gap are warned of") {
    scene.set("spacing", 0.055).set("rings", 3);
    CHECK_NOTHROW(scene.choose());
    const flow::Warnings warnings = scene.method.warnings(scene.of);
    CHECK(std::ranges::any_of(warnings, [](const std::string& one) {
      return one.find("the gap of 0.5 between two bodies is only 9.1 particles wide") !=
             std::string::npos;
    }));
  }
  SECTION("a box that cuts the second") {
    scene.set("spacing", 0.04).set("box", Box{-5, -5, 7, 2});
    CHECK_THROWS_WITH(scene.choose(), Contains("sph.box"));
  }
  SECTION("a spacing that is too wide for the second alone") {
    SphScene small = two_circles({0, 3}, 0.1);
    small.set("spacing", 0.05);
    CHECK_THROWS_WITH(small.choose(), Contains("0.04 at most"));
  }
  SECTION("one that moves against the other") {
    scene.set("spacing", 0.04);
    body::MotionSettings slides;
    slides.x = "0.1*t";
    const body::Jets still{{0, 0}, {0, 0}, {0, 0}};
    slides.course = {{0, 1}, {body::Jets{{0, 0.1}, {0.1, 0.1}, {0, 0}}, still, still}, {}};
    scene.of.others[0].motion = slides;
    CHECK_THROWS_WITH(scene.choose(), Contains("moves body[1] against the others"));
    scene.of.others[0].motion = body::MotionSettings{2};
    CHECK_NOTHROW(scene.choose());
  }
  SECTION("a vortex within the second") {
    scene.set("spacing", 0.04);
    scene.of.initial.emplace();
    scene.of.initial->circulation = 1, scene.of.initial->core = 0.2;
    scene.of.initial->centre = {0.1, 1.6};
    CHECK_THROWS_WITH(scene.choose(), Contains("within a body"));
  }
}

TEST_CASE("what is written of SPH stays as it is written") {
  SphScene scene;
  scene.of.accuracy = 0.01;
  scene.set("spacing", 0.08).set("levels", 2).set("zone", 0.4).set("degree", 4).set("reach", 4.2);
  scene.set("box", Box{-3, -3, 4, 3}).step(0.01).choose();
  CHECK(scene.number("spacing") == 0.08);
  CHECK(scene.number("levels") == 2);
  CHECK(scene.number("zone") == 0.4);
  CHECK(scene.number("reach") == 4.2);
  CHECK(scene.box() == Box{-3, -3, 4, 3});
  CHECK(scene.of.time.dt == 0.01);
}

TEST_CASE("degree 4 reaches farther") {
  SphScene scene;
  CHECK(scene.set("spacing", 0.05).set("degree", 4).choose().number("reach") == 3.9);
}

TEST_CASE("SPH refuses what it cannot compute, in words with numbers") {
  SphScene scene;
  SECTION("neither spacing nor accuracy") {
    CHECK_THROWS_WITH(scene.choose(), Contains("neither written nor chosen"));
  }
  SECTION("no body") {
    scene.of.body.reset();
    CHECK_THROWS_WITH(scene.choose(), Contains("needs a [body]"));
  }
  SECTION("a spacing wider than a fifth of the body") {
    scene.set("spacing", 0.21);
    CHECK_THROWS_WITH(scene.choose(), Contains("0.21") && Contains("fifth"));
  }
  SECTION("no viscosity") {
    scene.of.flow.nu = 0;
    scene.set("spacing", 0.05);
    CHECK_THROWS_WITH(scene.choose(), Contains("viscosity"));
  }
  SECTION("degree 3") {
    scene.set("spacing", 0.05).set("degree", 3);
    CHECK_THROWS_WITH(scene.choose(), Contains("sph.degree is 3"));
  }
  SECTION("a box that cuts the body, or its rings") {
    for (const double left : {-0.4, -0.6, -0.85}) {
      scene.set("spacing", 0.05).set("box", Box{left, -5, 7, 5});
      CHECK_THROWS_WITH(scene.choose(), Contains("sph.box"));
    }
  }
  SECTION("a vortex within the body, or outside of the box") {
    scene.set("spacing", 0.05);
    scene.of.initial.emplace();
    scene.of.initial->circulation = 1, scene.of.initial->core = 0.2;
    for (const std::array<double, 2> centre : {std::array{0.1, 0.2}, {100.0, 0.0}}) {
      scene.of.initial->centre = centre;
      CHECK_THROWS_WITH(scene.choose(), Contains("initial.centre = ["));
    }
    scene.of.initial->centre = {1, 0.5};
    CHECK_NOTHROW(scene.choose());
  }
  SECTION("a body that plunges upstream as fast as the stream") {
    // 2 pi 0.5 0.4 cos(45 degrees) = 0.89, and at 0.46 it is 1.02.
    scene.set("spacing", 0.05);
    scene.of.plunge = body::PlungeSettings{0.4, 0.5, {1, 1}};
    CHECK_NOTHROW(scene.choose());
    scene.of.plunge = body::PlungeSettings{0.46, 0.5, {1, 1}};
    CHECK_THROWS_WITH(scene.choose(), Contains("the body moves as fast along flow.stream"));
  }
  SECTION("a reach that does not go with the degree") {
    scene.set("spacing", 0.05).set("reach", 2.0);
    CHECK_THROWS_WITH(scene.choose(), Contains("sph.reach is 2") && Contains("2.4 .. 4"));
    scene.set("degree", 4).set("reach", 8.0);
    CHECK_THROWS_WITH(scene.choose(), Contains("3.2 .. 5"));
  }
  SECTION("rings wider than the finest zone") {
    scene.set("spacing", 0.05).set("rings", 16).set("zone", 0.5);
    CHECK_THROWS_WITH(scene.choose(), Contains("sph.zone is 0.5") && Contains("16 rings"));
  }
  SECTION("a box in which the widest spacing is not reached") {
    scene.set("spacing", 0.05).set("levels", 4).set("box", Box{-2, -2, 3, 2});
    CHECK_THROWS_WITH(scene.choose(), Contains("sph.levels is 4"));
  }
  SECTION("a body thinner than two particles") {
    scene.of.body = vortree::test::ellipse(0.5, 0.02);
    scene.set("spacing", 0.05);
    CHECK_THROWS_WITH(scene.choose(), Contains("half its mean thickness"));
  }
  SECTION("a box inside out") {
    scene.set("spacing", 0.05).set("box", Box{5, 5, -5, -5});
    CHECK_THROWS_WITH(scene.choose(), Contains("sph.box"));
  }
}

TEST_CASE("a flow that fills the plane chooses box, levels and step by its wavelength and speed") {
  SphScene scene = vortices(32);
  scene.of.initial->centre = {3, -1};
  scene.choose();
  CHECK(scene.box() == Box{3, -1, 4, 0});
  CHECK(scene.number("levels") == 1);
  CHECK(scene.of.time.dt == Approx(0.5 / 80).epsilon(1e-12));  // 0.2/32 = 0.5/80
  SphScene accurate = vortices(32);
  accurate.of.accuracy = 2e-3;
  accurate.written.erase("sph.spacing");
  CHECK(accurate.choose().number("spacing") == Approx(1.0 / 32).epsilon(1e-12));
  // The finest goes by.
  CHECK(vortices(32).region({0, 0}, {0.1, 0.1}, 0.01).choose().of.time.dt <= 0.2 * 0.01);
}

TEST_CASE("what cannot be meant of periodic boxes and regions is refused, in words with numbers") {
  SphScene scene = vortices(32);
  SECTION("a periodic box with a body") {
    scene.of.initial.reset();
    scene.of.body = vortree::test::circle(0.5);
    CHECK_THROWS_WITH(scene.choose(),
                      Contains("sph.outside is \"periodic\"") && Contains("no [body]"));
  }
  SECTION("a flow that fills the plane, but not the box") {
    scene.set("outside", sph::Outside::free);
    CHECK_THROWS_WITH(scene.choose(), Contains("sph.outside is \"free\"; for initial.kind = "
                                               "\"taylor_green\", \"periodic\" was expected"));
  }
  SECTION("a box that is no square, or no whole wavelength") {
    for (const Box& box : {Box{0, 0, 1, 2}, Box{0, 0, 1.5, 1.5}, Box{1, 1, 0, 0}}) {
      scene.set("box", box);
      CHECK_THROWS_WITH(scene.choose(), Contains("square of whole wavelengths of 1"));
    }
  }
  SECTION("a stream") {
    scene.of.flow.stream = {1, 0};
    CHECK_THROWS_WITH(scene.choose(), Contains("flow.stream is [1, 0]"));
  }
  SECTION("particles wider than an eighth of a wavelength") {
    scene.set("levels", 4);
    CHECK_THROWS_WITH(scene.choose(), Contains("up to 0.25 apart") && Contains("0.125"));
  }
  SECTION("no viscosity") {
    scene.of.flow.nu = 0;
    CHECK_THROWS_WITH(scene.choose(), Contains("viscosity"));
  }
  SECTION("a region that is no finer than all") {
    scene.region({0.5, 0.5}, {0.1, 0.1}, 0.04);
    CHECK_THROWS_WITH(scene.choose(), Contains("sph.region.spacing is 0.04") && Contains("0.0312"));
  }
  SECTION("a region finer than the body's particles") {
    SphScene cylinder;
    cylinder.set("spacing", 0.05).region({2, 0}, {1, 0.5}, 0.04);
    CHECK_THROWS_WITH(cylinder.choose(), Contains("sph.region.spacing is 0.04") &&
                                             Contains("sph.spacing = 0.05 or more"));
  }
  SECTION("a region at a side of a box that is not periodic") {
    SphScene cylinder;
    cylinder.set("spacing", 0.05).region({6.5, 0}, {1, 0.5}, 0.05);
    CHECK_THROWS_WITH(cylinder.choose(), Contains("sph.region asks for particles"));
  }
}

namespace {

/// Particles that a scene begins with, and those that were foreseen.
std::pair<double, double> particles(SphScene scene) {
  const auto solver = scene.choose().begin();
  return {static_cast<double>(solver->particles()),
          sph::expected_particles({scene.of, scene.method.settings()})};
}

}  // namespace

TEST_CASE("how many particles a region adds is foreseen to a fifth") {
  const auto add = [](SphScene scene, Pair centre, Pair half_axes, double spacing) {
    const auto [few, foreseen_few] = particles(scene);
    const auto [many, foreseen_many] = particles(scene.region(centre, half_axes, spacing));
    CAPTURE(few, many, foreseen_few, foreseen_many);
    CHECK(many > 1.2 * few);
    CHECK(foreseen_many - foreseen_few == Approx(many - few).epsilon(0.2));
  };
  CHECK(particles(vortices(32)).second == Approx(1024).epsilon(1e-12));
  add(vortices(32), {0.2, 0.4}, {0.25, 0.25}, 1.0 / 64);
  add(vortices(32), {0, 0.5}, {0.1, 0.2}, 1.0 / 128);
  add(SphScene().set("spacing", 0.1), {3.5, 1}, {2, 1.5}, 0.1);
}

TEST_CASE("refusals name the key that they are about") {
  const auto key_of = [](SphScene scene) {
    try {
      scene.choose();
    } catch (const Refused& refused) {
      return refused.key;
    }
    return std::string("none");
  };
  CHECK(key_of(SphScene()) == "sph.spacing");
  CHECK(key_of(SphScene().set("spacing", 0.1).set("degree", 3)) == "sph.degree");
  CHECK(key_of(SphScene().set("spacing", 0.1).set("box", Box{-1, -1, 1, 1})) == "sph.box");
  CHECK(key_of(SphScene().set("spacing", 0.1)) == "none");
}

TEST_CASE("a method that is cloned keeps its settings, a blank one has none") {
  SphScene scene;
  scene.set("spacing", 0.07);
  const auto spacing = [](flow::Method& method) {
    return **std::get_if<double*>(&method.tables().front().keys().front().target);
  };
  CHECK(spacing(*scene.method.clone()) == 0.07);
  CHECK(spacing(*scene.method.blank()) == 0);
  CHECK(scene.method.name() == "sph");
}

TEST_CASE("a search of all pairs is warned of where particles are many") {
  const auto told = [](neighbors::SearchMethod method, double spacing) {
    SphScene scene;
    scene.set("spacing", spacing).set("method", method).choose();
    return scene.method.warnings(scene.of).size();
  };
  using enum neighbors::SearchMethod;
  CHECK(told(all_pairs, 0.025) == told(qcg, 0.025) + 1);
  CHECK(told(linked_list, 0.025) == told(qcg, 0.025));
  CHECK(told(all_pairs, 0.1) == told(qcg, 0.1));
}

TEST_CASE("vortices thinner than particles, and wishes that nothing comes of, are warned of") {
  const auto told = [](const auto& change) {
    SphScene scene;
    scene.set("spacing", 0.05);
    change(scene);
    scene.choose();
    return scene.method.warnings(scene.of).size();
  };
  const auto vortex = [](double core) {
    return [core](SphScene& scene) {
      scene.of.initial.emplace();
      scene.of.initial->circulation = 1, scene.of.initial->core = core;
      scene.of.initial->centre = {1, 0.5};
    };
  };
  const std::size_t usual = told([](SphScene&) {});
  CHECK(told(vortex(0.15)) == usual);
  CHECK(told(vortex(0.05)) == usual + 1);  // 0.6 from the wall particles are 0.06 apart
  CHECK(told([](SphScene& scene) {
          scene.set("levels", 1).region({1, 1}, {0.2, 0.2}, 0.05);
        }) == usual + 1);
  CHECK(told([](SphScene& scene) { scene.region({50, 0}, {0.2, 0.2}, 0.05); }) == usual + 1);
}

TEST_CASE("particles wider than half the body are warned of") {
  const auto told = [](const auto& change) {
    SphScene scene;
    scene.set("spacing", 0.05);
    change(scene);
    scene.choose();
    return scene.method.warnings(scene.of).size();
  };
  const std::size_t usual = told([](SphScene&) {});
  const auto with = [&](const char* key, auto value, int levels) {
    return told([&](SphScene& scene) { scene.set(key, value).set("levels", levels); });
  };
  CHECK(with("zone", 0.3, 4) == usual);      // 0.4 apart at most
  CHECK(with("zone", 0.3, 5) == usual + 1);  // 0.8
}

TEST_CASE("a step that is longer than the Courant number asks for is warned of") {
  const auto told = [](double dt) {
    SphScene scene;
    scene.set("spacing", 0.05).choose();
    scene.of.time.dt = dt;
    return scene.method.warnings(scene.of).size();
  };
  const std::size_t usual = told(0.015);
  CHECK(told(0.03) == usual);
  CHECK(told(0.04) == usual + 1);
}

TEST_CASE("hardly ten particles in a wavelength are warned of, and neither degree there is") {
  const auto told = [](int particles, int degree) {
    SphScene scene = vortices(particles, degree).choose();
    return scene.method.warnings(scene.of).size();
  };
  CHECK(told(10, 2) == 1);
  CHECK(told(12, 2) == 0);
  CHECK(told(16, 4) == 0);
}

TEST_CASE("a region in a periodic box has an effect with one level, wherever it is written") {
  const auto told = [](SphScene scene) {
    scene.choose();
    return scene.method.warnings(scene.of).size();
  };
  const std::size_t usual = told(vortices(32));
  CHECK(told(vortices(32).region({0.5, 0.5}, {0.2, 0.2}, 1.0 / 64)) == usual);
  CHECK(told(vortices(32).region({7.5, -3.5}, {0.2, 0.2}, 1.0 / 64)) == usual);
  CHECK(told(vortices(32).region({0.5, 0.5}, {0.2, 0.2}, 1.0 / 32)) == usual + 1);
}

TEST_CASE("a warning of a spacing tells one that is less than that, and is not warned of") {
  const auto told = [](double spacing) {
    SphScene scene;  // Re = 20: a third of D/sqrt(20), 0.074536
    scene.set("spacing", spacing).choose();
    const auto list = scene.method.warnings(scene.of);
    return list.empty() ? std::string() : list.front();
  };
  for (const double spacing : {0.07454, 0.0746, 0.075})
    CHECK_THAT(told(spacing), Contains("forces want 0.074 or less"));
  CHECK_THAT(told(0.0746), Contains("sph.spacing = 0.0746:"));
  CHECK(told(0.074).empty());
  CHECK(told(0.0745355).empty());
}
