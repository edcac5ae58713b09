#include <cmath>

#include "flow/steps.hpp"
#include "scenes.hpp"

using namespace vortree::flow;
using namespace vortree::io;
using namespace vortree::test;
using Catch::Matchers::EndsWith;

namespace {

// dt is left open; 0.4/omega is chosen, omega = 1/(pi 0.2^2), less what makes the end be met.
Scene open_step(const std::string& end, const std::vector<std::string>& overrides = {}) {
  return parse(
      "accuracy = 0.1\n[flow]\nnu = 1e-3\n[initial]\nkind = \"lamb_oseen\"\ncirculation = 1\n"
      "core = 0.2\n[time]\nend = " +
          end,
      overrides);
}

const double chosen = 0.4 * 3.14159265358979323846 * 0.04;

double steps_to(double t, const Scene& scene) {
  return t / scene.time.dt;
}

}  // namespace

TEST_CASE("a step that is chosen meets the end, with as few steps as the choice allows") {
  for (const char* end : {"0.3", "0.5", "1.0", "7.77", "123.4"}) {
    const Scene scene = open_step(end);
    CAPTURE(end, scene.time.dt);
    const double steps = std::ceil(scene.time.end / chosen);
    CHECK(scene.time.dt == scene.time.end / steps);
    CHECK(scene.time.dt <= chosen);
  }
  CHECK(open_step("0.01").time.dt == 0.01);  // shorter than the step that would do
}

TEST_CASE(
    "frames and pictures are met, too, where a fiftieth more steps do it, else the end alone") {
  const std::vector<std::string> pictures{"output.fields=[2.5,7.5]", "output.window=[-1,-1,1,1]",
                                          "output.field_spacing=0.5", "output.frames=1.25"};
  const Scene scene = open_step("10.0", pictures);  // 199 steps; 200 is a multiple of 8
  CHECK(steps_to(10, scene) == Approx(200).epsilon(1e-14));
  for (const double t : {1.25, 2.5, 7.5, 10.0}) CHECK(met(t, scene.time.dt));
  CHECK(steps_to(10, open_step("10.0")) == Approx(199).epsilon(1e-14));
  CHECK(steps_to(10, open_step("10.0", {"output.frames=0.0625001"})) == Approx(199).epsilon(1e-14));
}

TEST_CASE("a step that is written is kept; one that meets the end as it is, to the last bit") {
  CHECK(open_step("1.0", {"time.dt=0.03"}).time.dt == 0.03);
  Scene scene = open_step("1.0");
  for (const double dt : {0.1, 0.02, 1.0 / 3, 0.7 / 7}) {
    scene.time.end = 21 * dt;
    CHECK(fitted_step(scene, dt) == dt);
  }
}

TEST_CASE("a scene whose step was chosen prints what reads back to the same run") {
  const Scene scene = open_step("7.77"), again = parse(resolved(scene));
  CHECK(again == scene);
  CHECK(scene.origin.step_chosen);
  CHECK_FALSE(again.origin.step_chosen);
}

TEST_CASE("the usual frames are whole steps apart") {
  CHECK(usual_frames({.dt = 0.01, .end = 2}) == 0.01 * 14);
  CHECK(usual_frames({.dt = 0.3, .end = 1}) == 0.3);
}

TEST_CASE("steps that cannot be counted are refused with the numbers") {
  CHECK(refused(with("end = 2", "end = 1e20")) ==
        "cases/ring.toml:16: time.end is 1e+20, which is 1e+22 steps of time.dt = 0.01; 1e+09 at "
        "most are run");
  CHECK_THAT(refused(plain, {"time.dt=2e-12"}), EndsWith("which is 1e+12 steps of time.dt = 2e-12; "
                                                         "1e+09 at most are run"));
  CHECK_THAT(refused(plain, {"time.dt=1e-30", "time.end=1e30"}),
             EndsWith("which is 1e+60 steps of time.dt = 1e-30; 1e+09 at most are run"));
  CHECK(parse(plain, {"time.dt=2e-9"}).time.dt == 2e-9);
  // A choice that ends in such a step, too: the vortex turns 1e300 times a second.
  CHECK_THAT(refused("accuracy = 0.1\n[flow]\nnu = 1e-3\n[initial]\nkind = \"lamb_oseen\"\n"
                     "circulation = 1e30\ncore = 0.2\n[time]\nend = 1"),
             EndsWith("1e+09 at most are run"));
}
