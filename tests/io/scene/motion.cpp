#include "io/scene/motion.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "base/keys.hpp"
#include "body/some_bodies.hpp"
#include "flow/warnings.hpp"
#include "scenes.hpp"

using namespace vortree;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

const double pi = std::numbers::pi;

body::Course of(const std::string& x, const std::string& angle = "0", double end = 2) {
  body::MotionSettings motion{.x = x, .angle = angle};
  io::complete_motion(motion, end, ".");
  return motion.course;
}

/// What an expression is refused with.
std::string said(const std::string& x) {
  try {
    of(x);
  } catch (const Refused& refused) {
    CHECK(refused.key == "motion.x");
    return refused.what();
  }
  return "nothing";
}

/// What a file is refused with.
std::string said_of_file(const std::string& text) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  std::ofstream(folder / "motion_of_test.csv") << text;
  body::MotionSettings motion{.file = "motion_of_test.csv"};
  try {
    io::complete_motion(motion, 2, folder);
  } catch (const std::runtime_error& refused) {
    return refused.what();
  }
  return "nothing";
}

const std::string disc = "[body]\nradius = 0.25\n";

}  // namespace

TEST_CASE("an expression of t is met with its derivatives, angles in degrees") {
  const body::Course course = of("0.1*cos(2*pi*t) + t^2/2", "30*sin(3*t)");
  for (const double t : {0.0, 0.3, 1.234, 2.0}) {
    const body::Kinematics now = course.at(t);
    CHECK(now.place.x == Approx(0.1 * std::cos(2 * pi * t) + t * t / 2).margin(1e-9));
    CHECK(now.velocity.x == Approx(-0.2 * pi * std::sin(2 * pi * t) + t).margin(1e-7));
    CHECK(now.acceleration.x == Approx(-0.4 * pi * pi * std::cos(2 * pi * t) + 1).margin(1e-5));
    CHECK(now.angle == Approx(pi / 6 * std::sin(3 * t)).margin(1e-9));
    CHECK(now.rate == Approx(pi / 2 * std::cos(3 * t)).margin(1e-7));
  }
}

TEST_CASE("what is fast is met by more steps, what bends at once within a few of them") {
  CHECK(of("sin(200*t)").at(1.2345).place.x == Approx(std::sin(246.9)).margin(1e-7));
  const body::Course ramp = of("t < 1 ? 0 : t - 1");
  CHECK(ramp.at(0.999).velocity.x == Approx(0).margin(1e-9));
  CHECK(ramp.at(1.001).velocity.x == Approx(1).margin(1e-9));
  CHECK_FALSE(ramp.turns());
}

TEST_CASE("an expression that cannot be meant is refused with where and why") {
  CHECK_THAT(said("0.1*foo(t)"), Contains("motion.x is \"0.1*foo(t)\"") && Contains("foo") &&
                                     EndsWith("as \"0.1*cos(2*pi*t)\""));
  CHECK_THAT(said("sin(t"), Contains("an expression of t was expected"));
  CHECK_THAT(said(""), Contains("an expression of t was expected"));
  CHECK_THAT(said("u"), Contains("\"u\""));
  CHECK(said("t = 3") == "motion.x is \"t = 3\": = sets nothing here; == compares");
  CHECK(said("1, 2") == "motion.x is \"1, 2\": one value was expected");
  CHECK_THAT(said("log(t - 1)"), Contains("at t = 0"));
  CHECK_THAT(said("1/(t - 1)"), Contains("that is inf at t = 1"));
}

TEST_CASE("a file gives a spline through its rows") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  {
    std::ofstream file(folder / "motion_of_test.csv");
    file << "# a foil that pitches\nt,angle,y\n";
    for (int i = 0; i <= 200; ++i)
      file << 0.01 * i << ',' << 10 * std::sin(0.03 * i) << ',' << 0.01 * i << '\n';
  }
  body::MotionSettings motion{.file = "motion_of_test.csv", .about = {-0.25, 0}};
  io::complete_motion(motion, 2, folder);
  const body::Kinematics now = motion.course.at(0.777);
  CHECK(now.angle == Approx(pi / 18 * std::sin(3 * 0.777)).epsilon(1e-5));
  CHECK(now.spin_up == Approx(-9 * pi / 18 * std::sin(3 * 0.777)).epsilon(1e-2));
  CHECK((now.place + Turn(now.angle)({-0.25, 0})).y == Approx(0.777));
}

TEST_CASE("a file that cannot be a motion is refused with the row") {
  CHECK_THAT(said_of_file("t,x\n0,0\n1,1\n2,2\n"), Contains("it has 3 rows"));
  CHECK_THAT(said_of_file("t,x\n0,0\n0.5,1\n0.5,2\n2,2\n"), Contains("t of row 3 is 0.5"));
  CHECK_THAT(said_of_file("t,x\n0,0\n0.5,1\n1,2\n1.5,2\n"),
             EndsWith("it ends at t = 1.5; the run ends at time.end = 2"));
  CHECK_THAT(said_of_file("t,x\n0.1,0\n0.5,1\n1,2\n2.5,2\n"), Contains("it begins at t = 0.1"));
  CHECK_THAT(said_of_file("t,x\n0,0\n0.5,nan\n1,2\n2.5,2\n"), Contains("x of row 2 is nan"));
  CHECK_THAT(said_of_file("t,z\n0,0\n0.5,1\n1,2\n2,2\n"), Contains("none of the columns x, y"));
  CHECK_THAT(said_of_file("x,y\n0,0\n0.5,1\n1,2\n2,2\n"), Contains("t"));
}

TEST_CASE("a motion says each thing once, and something") {
  const auto motion = [](const std::string& lines) {
    return refused(plain + disc + "[motion]\n" + lines);
  };
  CHECK_THAT(motion("angle = \"t\"\nspin = 1\n"), Contains("both turn the body"));
  CHECK_THAT(motion("x = \"t\"\nfile = \"m.csv\"\n"), Contains("not both"));
  CHECK_THAT(motion("file = \"none_such.csv\"\n"), Contains("none_such.csv"));
  CHECK_THAT(motion("x = \"t +\"\n"), Contains("ring.toml:20: motion.x is \"t +\""));
}

TEST_CASE("of a body that still gains speed at the end the run's length is said to decide on U") {
  const auto doubts = [](const std::string& x, const std::string& stream = "") {
    flow::Case scene;
    scene.body = circle(0.5);
    scene.time = {.dt = 0.1, .end = 2};
    if (!stream.empty()) scene.flow.stream = {1, 0};
    scene.motion = body::MotionSettings{.x = x};
    io::complete_motion(*scene.motion, scene.time.end, ".");
    return std::ranges::count_if(flow::warnings(scene), [](const std::string& one) {
      return one.find("would be another than 4") != std::string::npos;
    });
  };
  CHECK(doubts("t^2") == 1);
  CHECK(doubts("t^2", "in a stream") == 0);
  CHECK(doubts("4*t") == 0);
  CHECK(doubts("2*sin(2*t)") == 0);
}
