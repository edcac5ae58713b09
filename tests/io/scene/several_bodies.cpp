#include <catch2/catch.hpp>

#include "flow/scales.hpp"
#include "io/scene/scenes.hpp"

using namespace vortree;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const std::string two = R"(title = "Two"
accuracy = 0.05
[flow]
stream = [1, 0]
nu = 0.01
[[body]]
radius = 0.5
[[body]]
radius = 0.25
centre = [2, 0]
[time]
end = 4
)";

/// The second body's motion, or another text, before [time].
std::string with_motion(const std::string& lines) {
  std::string text = two;
  return text.insert(text.find("[time]"), lines + "\n");
}

/// What its method doubts of a scene.
std::string doubts_of(const io::Scene& scene) {
  std::string all;
  for (const std::string& one : scene.computed_by().warnings(scene)) all += one + "\n";
  return all;
}

std::string at_rest(std::string text) {
  return text.replace(text.find("[1, 0]"), 6, "[0, 0]");
}

}  // namespace

TEST_CASE("several bodies are read, printed, and read back") {
  const io::Scene scene = parse(with_motion("[body.motion]\nangle = \"10*t\"\nabout = [0.1, 0]"));
  REQUIRE(scene.others.size() == 1);
  CHECK(scene.body->number("radius") == 0.5);
  CHECK(scene.others[0].centre == Pair{2, 0});
  CHECK(scene.others[0].motion->angle == "10*t");
  CHECK(scene.others[0].panels >= 128);  // chosen, as those of the first
  CHECK(flow::bodies_of(scene).size() == 2);
  const std::string text = io::resolved(scene);
  CHECK_THAT(text, Contains("\n[[body]]\n") && Contains("motion = {angle = \"10*t\""));
  CHECK(parse(text) == scene);
}

TEST_CASE("a key on the command line is that of each body, or of the one with its number") {
  const io::Scene all = parse(two, {"body.panels=200"});
  CHECK(all.body->panels == 200);
  CHECK(all.others[0].panels == 200);
  const io::Scene one = parse(two, {"body[1].centre=[3, 0.5]", "body[1].motion.y=\"0.1*t\""});
  CHECK(one.body->centre == Pair{0, 0});
  CHECK(one.others[0].centre == Pair{3, 0.5});
  CHECK(one.others[0].motion->y == "0.1*t");
  CHECK_THAT(refused(two, {"body[2].panels=200"}), Contains("body[2] is none of the 2"));
  CHECK_THAT(refused(two, {"body[1].panels=2"}),
             StartsWith("command line: body[1].panels=2: body[1].panels is 2; a body needs"));
}

TEST_CASE("what is wrong in one of several bodies is told by its number and line") {
  CHECK_THAT(refused(with_motion("shape = \"ellipse\"")),
             Contains("that needs the key body[1].across"));
  CHECK_THAT(refused(with_motion("radus = 1")),
             StartsWith("cases/ring.toml:11: body[1].radus is not a key of [body[1]]"));
  CHECK_THAT(refused(with_motion("[body.motion]\nx = \"0.1*q\"")),
             StartsWith("cases/ring.toml:12: body[1].motion.x is \"0.1*q\": "));
  CHECK_THAT(refused(with_motion("shape = \"ellipse\"\nacross = 0.1\n[body.motion]\nspin = 1")),
             Contains("body[1].motion.spin is 1; only a circle can turn in its place"));
  CHECK_THAT(refused(with_motion("[body.motion]")),
             Contains("[body[1].motion] needs one of the keys x, y, angle, file, spin"));
  CHECK_THAT(refused(with_motion("[motion]\nangle = \"t\"")),
             Contains("[motion] turns several bodies; together they can only travel"));
  CHECK_THAT(refused(plain + "[body]\nradius = 0.5\n[body.motion]\nspin = 1\n"),
             Contains("[body.motion] is for one of several bodies"));
}

TEST_CASE("bodies that overlap, touch, or come to, are refused with the time") {
  CHECK_THAT(refused(two, {"body[1].centre=[0.6, 0]"}),
             Contains("body[0] and body[1] overlap, by "));
  CHECK_THAT(refused(two, {"body[1].centre=[0, 0]"}), Contains("overlap"));
  CHECK_THAT(refused(two, {"body[1].centre=[0.7503, 0]"}),
             Contains("body[0] and body[1] are 0.0003 apart; "));
  // Of paths 1 - 0.5 t the walls meet at t = 2.5, and the least gap comes a little earlier.
  CHECK_THAT(refused(with_motion("[body.motion]\nx = \"-0.5*t\"")),
             StartsWith("cases/ring.toml:11: body[0] and body[1] overlap at t = "));
  CHECK_THAT(refused(two, {"body[1].centre=[1e8, 0]"}), Contains("1e+08 away from body[0]"));
}

TEST_CASE("a box holds each body wherever it goes") {
  const std::string moves = with_motion("[body.motion]\nx = \"t\"");
  CHECK_THAT(
      refused(moves, {"merging.box=[-2, -2, 5, 2]"}),
      Contains("it must hold body[1], wherever it goes, which fills [1.75, -0.25, 6.25, 0.25]"));
  CHECK_NOTHROW(parse(moves, {"merging.box=[-2, -2, 12, 2]"}));
}

TEST_CASE("speed and drag go by the fastest of all bodies, as all its motions add up") {
  const std::string rest = at_rest(two);
  const io::Scene against =
      parse(rest, {"motion.x=\"-2*t\"", "body[0].motion.x=t", "body[1].motion.x=t"});
  CHECK(flow::speed_of(against) == Approx(1).epsilon(1e-9));
  CHECK(flow::scales_of(against).along.x == Approx(1).epsilon(1e-9));
  const io::Scene across = parse(rest, {"body[0].motion.x=\"0.001*t\"", "body[1].motion.y=t"});
  CHECK(flow::speed_of(across) == Approx(1).epsilon(1e-9));
  CHECK(flow::scales_of(across).along.y == Approx(-1).epsilon(1e-9));
}

TEST_CASE("where bodies come near on their way cores are doubted") {
  const std::string passes = with_motion("[body.motion]\ny = \"t - 2\"");
  const auto doubts = [&](const std::string& centre) {
    return doubts_of(parse(passes, {"body[1].centre=" + centre}));
  };
  CHECK_THAT(doubts("[0.8, 0]"), Contains("are 0.05 apart at t = 2, "));
  CHECK_THAT(doubts("[3, 0]"), !Contains("apart"));
}

TEST_CASE("a course that begins at rest starts slowly, whatever round-off makes of its velocity") {
  const std::string rest = at_rest(two);
  CHECK_FALSE(flow::scales_of(parse(rest, {"motion.x=\"t - sin(pi*t)/pi\""})).impulsive);
  CHECK_FALSE(flow::scales_of(parse(rest, {"body[1].motion.angle=\"40*t^2\""})).impulsive);
  CHECK(flow::scales_of(parse(rest, {"motion.x=\"0.01*t + t^2\""})).impulsive);
  CHECK(flow::scales_of(parse(rest, {"body[1].motion.angle=\"t\""})).impulsive);
  CHECK(flow::scales_of(parse(two, {"motion.x=\"t^2\""})).impulsive);
}
