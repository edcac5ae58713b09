#include "scenes.hpp"

using namespace vortree;
using namespace vortree::io;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const std::string cylinder = R"(accuracy = 0.04
[flow]
reynolds = 100
stream = [1.0, 0.0]
[body]
radius = 0.5
[time]
end = 1.0
)";

std::string typed(const std::string& text, const std::string& word) {
  return refused(text, {word});
}

}  // namespace

TEST_CASE("numbers whose products leave the doubles are refused, wherever they stand") {
  const auto beyond = Contains("numbers of a size within 1e-30 .. 1e+30 are computed with");
  CHECK_THAT(typed(plain, "flow.nu=1e31"), beyond);
  CHECK_THAT(typed(plain, "flow.nu=1e-31"), beyond);
  CHECK_THAT(typed(plain, "flow.stream=[0,-1e300]"), beyond);
  CHECK_THAT(typed(plain, "initial.circulation=-1e300"), beyond);
  CHECK_THAT(typed(plain, "initial.centre=[1e306,0]"), beyond);
  CHECK_THAT(typed(plain, "merging.box=[-1e99,-1,1,1]"), beyond);
  CHECK_THAT(typed(plain, "merging.tolerance=1e-300"), beyond);
  CHECK_THAT(typed(cylinder, "body.radius=1e-200"), beyond);
  CHECK_NOTHROW(parse(plain, {"initial.centre=[1e20,-1e-20]", "merging.tolerance=0"}));
  CHECK_NOTHROW(parse(plain, {"check.circulation_max=1e-300", "output.frames=1e300"}));
}

TEST_CASE("a scene in which nothing turns or moves is refused") {
  CHECK_THAT(typed(plain, "initial.circulation=0"), Contains("no vorticity to follow"));
  CHECK_THAT(typed(cylinder, "flow.stream=[0,0]"), Contains("nothing moves"));
}

TEST_CASE("vortices upon each other, out of each other's sight, or of single blobs are refused") {
  const auto pair = [](const std::string& apart) {
    return refused(with("lamb_oseen", "dipole"), {"initial.separation=" + apart});
  };
  CHECK_THAT(pair("1e-9"), Contains("two vortices are at least a core, cores.sigma_0 = 0.05"));
  CHECK_THAT(pair("1e4"), Contains("5000 apart at most"));
  CHECK_THAT(typed(plain, "initial.spacing=5"), Contains("make no vortex; 1 is right"));
  CHECK_THAT(refused(plain, {"body.radius=0.5", "body.centre=[0,1e5]"}),
             Contains("initial.centre is 100000 away from body.centre"));
}

TEST_CASE("merging.box holds the body and the initial vorticity, or is refused") {
  const auto boxed = [](const std::string& box, const std::string& more = "seed=1") {
    return refused(cylinder, {"merging.box=" + box, more});
  };
  const auto body = Contains("it must hold the body, which fills [-0.5, -0.5, 0.5, 0.5]");
  for (const char* box : {"[0.6,-2,8,2]", "[-0.1,-0.1,0.1,0.1]", "[10,10,11,11]", "[-9,-9,0.4,9]"})
    CHECK_THAT(boxed(box), body);
  CHECK_THAT(boxed("[2,-2,-2,2]"), Contains("x0 < x1 and y0 < y1 were expected"));
  CHECK_THAT(boxed("[-2,0,2,0]"), Contains("x0 < x1 and y0 < y1 were expected"));
  CHECK_THAT(boxed("[-inf,-2,2,2]"), Contains("a finite number was expected"));
  CHECK_THAT(boxed("[-1,-1,1,1]", "body.centre=[7,0]"), Contains("which fills [6.5, -0.5"));
  CHECK_NOTHROW(parse(cylinder, {"merging.box=[-0.5,-0.5,0.5,0.5]"}));
  CHECK_THAT(typed(plain, "merging.box=[-0.5,-1,1,1]"),
             Contains("it must hold the initial vorticity, which fills [-0.6, -0.6, 0.6, 0.6]"));
  CHECK_NOTHROW(parse(plain, {"merging.box=[-0.61,-0.61,0.61,0.62]"}));
}

TEST_CASE("cores wider than half the body, and steps that turn the flow around, are refused") {
  const std::string own = "[cores]\nsigma_0 = 0.1\nsigma_max = 0.2\n";
  CHECK_THAT(refused(cylinder + own, {"cores.sigma_max=0.6"}),
             Contains("cores.sigma_max is 0.6; cores wider than half the body's length, 0.5"));
  CHECK_THAT(refused(cylinder + own, {"cores.sigma_max=0.7", "cores.sigma_0=0.6"}),
             Contains("cores.sigma_0 is 0.6"));
  CHECK_THAT(refused(cylinder + own, {"cores.sigma_0=0.9e-6"}),
             Contains("cores.sigma_0 is 9e-07; cores thinner than 1e-06 of the body's length"));
  CHECK_NOTHROW(parse(cylinder + own, {"cores.sigma_0=1.1e-6"}));
  CHECK_THAT(refused(plain, {"initial.circulation=1e5"}), Contains("rad a step"));
  CHECK_THAT(refused(cylinder, {"time.dt=10", "time.end=100", "flow.reynolds=1e4"}),
             Contains("rad a step"));
  CHECK_THAT(refused(cylinder, {"plunge.amplitude=0.1", "plunge.frequency=1", "time.dt=0.3"}),
             Contains("a period of the body's motion, 1, has 3.3 steps"));
  CHECK_THAT(refused(plain, {"diffusion.kind=particle_exchange", "flow.nu=1"}),
             Contains("that is unstable"));
}

TEST_CASE("panels that step over a tip are refused, and chosen so that they do not") {
  const std::vector<std::string> thin{"body.shape=ellipse", "body.across=0.01"};
  CHECK_THAT(refused(cylinder, {thin[0], thin[1], "body.panels=128"}),
             Contains("step over the body's tips of radius 0.0002; at least 132 see them, 394 "
                      "resolve them"));
  CHECK_NOTHROW(parse(cylinder, {thin[0], thin[1], "body.panels=1000"}));
  CHECK_THAT(refused(cylinder, {thin[0], "body.across=1e-4"}),
             StartsWith("command line: ") || Contains("tips of radius 2e-08"));
  CHECK(parse(cylinder, thin).body->panels >= 393);
  CHECK(parse(cylinder, {thin[0], "body.across=0.4"}).body->panels == parse(cylinder).body->panels);
}

TEST_CASE("at low Reynolds numbers cores stay as small against the body as at 20") {
  const auto chosen = [](const std::string& reynolds, const std::string& accuracy) {
    return own(parse(cylinder, {"flow.reynolds=" + reynolds, "accuracy=" + accuracy})).cores;
  };
  const double fitted = std::sqrt(1.02);  // steps are shortened by so much to meet the end
  for (const char* accuracy : {"0.05", "0.01", "0.003"})
    for (const char* reynolds : {"5", "1", "0.01"}) {
      CHECK(chosen(reynolds, accuracy).sigma_0 <= fitted * chosen("20", accuracy).sigma_0);
      CHECK(chosen(reynolds, accuracy).sigma_max <= fitted * chosen("20", accuracy).sigma_max);
    }
  CHECK(chosen("1e-3", "1").sigma_max <= 0.25);
}
