#include <fmt/format.h>

#include <cmath>

#include "body/extent.hpp"
#include "scenes.hpp"

using namespace vortree;
using namespace vortree::io;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

TEST_CASE("an accuracy chooses what is not written, and only that") {
  const std::string rest =
      "[flow]\nreynolds = 550\nstream = [2, 0]\n[body]\nradius = 0.25\n"
      "[time]\nend = 1\n";
  const Scene scene = parse("accuracy = 0.01\n" + rest);
  CHECK(scene.flow.nu == Approx(2 * 0.5 / 550));
  CHECK(scene.time.dt == Approx(0.02 * 0.25));
  CHECK(own(scene).cores.sigma_max == Approx(4 * std::sqrt(0.01 * scene.flow.nu * 0.25)));
  CHECK(own(scene).cores.sigma_0 == Approx(std::sqrt(2 * scene.flow.nu * scene.time.dt)));
  CHECK(own(scene).velocity.cores == vortex::PairCores::both);
  CHECK(parse(resolved(scene)) == scene);
  const Scene finer = parse("accuracy = 0.0025\n" + rest);
  CHECK(own(finer).cores.sigma_max == Approx(own(scene).cores.sigma_max / 2));
  CHECK(finer.time.dt < scene.time.dt);
  CHECK(own(finer).merging.tolerance == Approx(own(scene).merging.tolerance / 4));
  CHECK(own(finer).velocity.tolerance < own(scene).velocity.tolerance);
  CHECK(finer.body->panels > scene.body->panels);
  const Scene written = parse("accuracy = 0.01\n" + rest, {"time.dt=0.001", "body.panels=99"});
  CHECK(written.time.dt == 0.001);
  CHECK(written.body->panels == 99);
  CHECK(own(written).cores.sigma_max == Approx(std::sqrt(8 * scene.flow.nu * 0.001)));
  CHECK(own(parse(plain, {"accuracy=0.1"})).cores == own(parse(plain)).cores);
}

TEST_CASE("steps that the turn at the wall bounds go with the cube root of the accuracy") {
  const auto chosen = [](const std::string& reynolds, const std::string& accuracy) {
    return parse("accuracy = " + accuracy + "\n[flow]\nreynolds = " + reynolds +
                 "\nstream = [1, 0]\n[body]\nradius = 0.5\n[time]\nend = 1e4\n");
  };
  const Scene fast = chosen("8800", "0.01");
  CHECK(fast.time.dt == Approx(0.005).epsilon(1e-4));
  CHECK(chosen("8800", "0.00125").time.dt == Approx(0.0025).epsilon(1e-4));
  CHECK(chosen("8800", "0.4").time.dt == Approx(chosen("8800", "0.05").time.dt));
  // q = 1/4
  CHECK(own(fast).cores.sigma_max == Approx(std::sqrt(6.5 * fast.flow.nu * fast.time.dt)));
  const Scene slow = chosen("100", "0.01");
  CHECK(slow.time.dt == Approx(0.02).epsilon(1e-4));
  CHECK(own(slow).cores.sigma_max == Approx(std::sqrt(8 * slow.flow.nu * slow.time.dt)));
}

TEST_CASE("around a tip steps do not go with a coarse accuracy, and cores widen with it") {
  const auto chosen = [](const std::string& across, const std::string& accuracy) {
    return parse("accuracy = " + accuracy +
                 "\n[flow]\nreynolds = 8800\nstream = [1, 0]\n[body]\nshape = \"ellipse\"\n"
                 "radius = 0.5\nacross = " +
                 across + "\n[time]\nend = 1e4\n");
  };
  const Scene sharp = chosen("0.1", "0.04"), blunt = chosen("0.25", "0.04");
  CHECK(sharp.time.dt == Approx(0.005).epsilon(1e-4));
  CHECK(own(sharp).cores.sigma_max == Approx(std::sqrt(16 * sharp.flow.nu * sharp.time.dt)));
  CHECK(blunt.time.dt == Approx(0.005 * std::cbrt(4)).epsilon(1e-4));
  CHECK(own(chosen("0.1", "0.01")).cores.sigma_max ==
        Approx(own(chosen("0.25", "0.01")).cores.sigma_max));
}

TEST_CASE("a Reynolds number needs a body and a stream, and no other viscosity beside it") {
  CHECK(refused(with("nu = 1e-3", "reynolds = 10")) ==
        "cases/ring.toml:3: flow.reynolds is 10; that needs [body] and a flow.stream, "
        "[plunge] or [motion]");
  CHECK_THAT(refused(with("nu = 1e-3", "nu = 1e-3\nstream = [1, 0]\nreynolds = 10") +
                     "[body]\nradius = 0.5"),
             StartsWith("cases/ring.toml:5: flow.reynolds is 10, which makes flow.nu 0.1, but that "
                        "is 0.001"));
}

TEST_CASE("a body has the keys of its shape, and no others") {
  const auto body = [](const std::string& lines) { return refused(plain + "[body]\n" + lines); };
  CHECK(body("shape = \"ellipse\"\nradius = 1") ==
        "cases/ring.toml:17: body.shape is \"ellipse\"; that needs the key body.across");
  CHECK(body("shape = \"naca0012\"\nradius = 1") ==
        "cases/ring.toml:19: body.shape is \"naca0012\"; that does not have the key body.radius");
  CHECK(body("shape = \"naca0012\"") ==
        "cases/ring.toml:17: body.shape is \"naca0012\"; that needs the key body.chord");
  CHECK(body("radius = 1\nedge = 0.01") ==
        "cases/ring.toml:19: body.shape is \"circle\"; that does not have the key body.edge");
  CHECK(body("shape = \"naca0012\"\nchord = 1\nedge = 0.1") ==
        "cases/ring.toml:20: body.edge is 0.1; it must lie in 1e-4 .. 0.02");
  const Scene foil = parse(plain + "[body]\nshape = \"naca0012\"\nchord = 3");
  CHECK(body::length_of(*foil.body) == 3);
  CHECK(foil.body->number("edge") == 0.005);
  CHECK(parse(resolved(foil)) == foil);
}

TEST_CASE("points of a body are read from a file beside the scene, and stand in what is resolved") {
  const Sandbox box;
  std::string circle;
  for (int i = 0; i < 20; ++i)
    circle +=
        fmt::format("{} {}\n", std::cos(0.1 * 3.14159265 * i), std::sin(0.1 * 3.14159265 * i));
  box.write("round.dat", circle);
  const auto read = [&](const std::string& lines) {
    return parse_scene(plain + "[body]\nshape = \"points\"\n" + lines, box / "ring.toml",
                       by_vortices());
  };
  const Scene scene = read("file = \"round.dat\"");
  CHECK(scene.body->points->size() == 40);
  CHECK(body::length_of(*scene.body) == Approx(2));
  // So that a run can go on, or be looked at, where the file is not.
  const Scene elsewhere = parse(resolved(scene));
  CHECK(elsewhere.body->points == scene.body->points);
  CHECK(elsewhere == scene);

  const std::string place = (box / "ring.toml").string() + ":19: ";
  const auto said = [&](const std::string& lines) { return refusal([&] { (void)read(lines); }); };
  CHECK_THAT(said("file = \"rond.dat\""), StartsWith(place + "body.file: there is no file ") &&
                                              EndsWith("did you mean round.dat?"));
  CHECK_THAT(said("file = \".\""), StartsWith(place + "body.file: "));
  CHECK(said("points = [1, 2, 3]") == place + "body.points: point 2: there is an x without a y");
  box.write("round.dat", "round\n");
  CHECK(said("file = \"round.dat\"") == (box / "round.dat").string() +
                                            ":1: there are no points; lines of x and y were "
                                            "expected");
}

TEST_CASE("a plunge needs a body and a direction; its speed serves where there is no stream") {
  const std::string body = "[body]\nradius = 0.5\n";
  const std::string plunge = "[plunge]\namplitude = 0.2\nfrequency = 3\n";
  CHECK(refused(plain + plunge) ==
        "cases/ring.toml:17: [plunge] is how a body moves; there is no [body]");
  CHECK(refused(plain + body + plunge + "direction = [0, 0]") ==
        "cases/ring.toml:22: plunge.direction is [0, 0]; a direction was expected, as [0, 1]");
  CHECK(refused(plain + body + "[plunge]\namplitude = 1") ==
        "cases/ring.toml:19: [plunge] needs the key frequency");
  CHECK(refused(plain + body + "[plunge]\namplitude = -1\nfrequency = 1") ==
        "cases/ring.toml:20: plunge.amplitude is -1; it must be > 0");
  const double fastest = 2 * 3.14159265358979 * 0.2 * 3;
  const Scene rest = parse(with("nu = 1e-3", "reynolds = 10") + body + plunge);
  CHECK(flow::speed_of(rest) == Approx(fastest));
  CHECK(rest.flow.nu == Approx(fastest / 10));
  CHECK(parse(resolved(rest)) == rest);
  const Scene stream = parse(with("nu = 1e-3", "reynolds = 10\nstream = [3, 4]") + body + plunge);
  CHECK(flow::speed_of(stream) == Approx(5));
  CHECK(flow::fastest_of(stream) == Approx(std::hypot(5, fastest)));
  CHECK(stream.flow.nu == Approx(0.5));
}

TEST_CASE("beside a body vorticity diffuses by core spreading only") {
  CHECK_THAT(refused(plain + "[body]\nradius = 1\n[diffusion]\nkind = \"random_walk\""),
             EndsWith("beside a body vorticity diffuses by core_spreading only"));
}

TEST_CASE("a vortex has the keys of its kind, and no others") {
  const auto kind = [](const std::string& lines) {
    return refused(with("kind = \"lamb_oseen\"", lines));
  };
  CHECK(kind("kind = \"dipole\"") ==
        "cases/ring.toml:9: initial.kind is \"dipole\"; that needs the key initial.separation");
  CHECK(kind("kind = \"lamb_oseen\"\nseparation = 1") ==
        "cases/ring.toml:11: initial.kind is \"lamb_oseen\"; that does not have the key "
        "initial.separation");
  CHECK(kind("kind = \"gaussian_ellipse\"\ncore_across = 0.01") ==
        "cases/ring.toml:11: initial.core_across is 0.01; it must be > cores.sigma_0 = 0.05");
  CHECK_NOTHROW(
      parse(with("kind = \"lamb_oseen\"", "kind = \"kirchhoff_ellipse\"\ncore_across = 0.01")));
  CHECK(refused(plain + "[check]\nexact = \"dipole\"") ==
        "cases/ring.toml:18: check.exact is \"dipole\"; that needs the table [initial] of kind "
        "\"dipole\"");
}

TEST_CASE("[motion] is that of a circle, and its speed is the wall's") {
  const std::string spins = "[motion]\nspin = -4\n", circle = "[body]\nradius = 0.25\n";
  const Scene scene = parse(plain + circle + spins);
  CHECK(flow::speed_of(scene) == 1);
  CHECK(flow::fastest_of(scene) == 1);
  CHECK(flow::speed_of(parse(plain + circle + spins, {"flow.stream=[3,0]"})) == 3);
  CHECK(flow::fastest_of(parse(plain + circle + spins, {"flow.stream=[3,0]"})) == 4);
  CHECK_THAT(refused(plain + spins), Contains("there is no [body]"));
  CHECK_THAT(refused(plain + "[body]\nshape = \"ellipse\"\nradius = 1\nacross = 0.5\n" + spins),
             Contains("only a circle can turn in its place, the shape of the body is \"ellipse\""));
  CHECK_THAT(refused(plain + circle + "[motion]\n"),
             Contains("[motion] needs one of the keys x, y, angle, file, spin"));
}

TEST_CASE("the exact flow around a circle that spins needs fluid at rest") {
  const std::string scene =
      "[flow]\nnu = 1e-3\n[cores]\nsigma_0 = 0.05\nsigma_max = 0.1\n[time]\ndt = 0.01\nend = 2\n"
      "[body]\nradius = 0.25\n[motion]\nspin = 4\n";
  const std::vector<std::string> asked{"check.exact=spinning_cylinder", "check.velocity_max=0.1"};
  CHECK(parse(scene, asked).check.exact == ExactAnswer::spinning_cylinder);
  for (const char* more : {"flow.stream=[1,0]", "plunge={amplitude=1,frequency=1}"}) {
    auto keys = asked;
    keys.push_back(more);
    CHECK_THAT(refused(scene, keys), Contains("that needs motion.spin alone, in fluid at rest"));
  }
}
