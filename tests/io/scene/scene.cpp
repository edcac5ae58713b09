#include "scenes.hpp"

using namespace vortree;
using namespace vortree::io;
using namespace vortree::test;

TEST_CASE("a scene says everything that it does not leave to the defaults") {
  const Scene scene = parse(plain);
  CHECK(scene.title == "A vortex");
  CHECK(scene.seed == 1);
  CHECK(scene.flow == flow::FlowSettings{.nu = 1e-3});
  CHECK_FALSE(scene.body);
  CHECK(own(scene).cores == vortex::CoreSettings{.sigma_0 = 0.05, .sigma_max = 0.1});
  CHECK(own(scene).splitting == vortex::SplittingSettings{.alpha = 0.7, .children = 4});
  CHECK(own(scene).merging == vortex::MergingSettings{.tolerance = 0.02, .reach = 2, .cap = 1.1});
  CHECK(scene.initial == flow::InitialSettings{.circulation = 1, .core = 0.2, .spacing = 1});
  CHECK(scene.time == flow::TimeSettings{.dt = 0.01, .end = 2, .scheme = flow::Scheme::rk2});
  CHECK(own(scene).velocity == vortex::VelocitySettings{});
  CHECK(own(scene).velocity.cores == vortex::PairCores::mean);
  CHECK(scene.output == flow::OutputSettings{.frames = 0.01 * 14});
  CHECK(scene.check == CheckSettings{});
}

TEST_CASE("every key of a scene is read") {
  const Scene scene = parse(full);
  CHECK(scene.title == "tab \t, quote \", Größe");
  CHECK(scene.seed == 77);
  CHECK(scene.flow.stream == Pair{1, -0.25});
  body::BodySettings round{.centre = {0.1, 0.2}, .panels = 64};
  round.numbers["radius"] = 1.0 / 3;
  CHECK(scene.body == round);
  CHECK(own(scene).splitting == vortex::SplittingSettings{.alpha = 0.8, .children = 5});
  CHECK(own(scene).merging == vortex::MergingSettings{.tolerance = 0, .reach = 1.5, .cap = 1.3});
  CHECK(scene.initial ==
        flow::InitialSettings{.circulation = -1.5, .core = 0.2, .spacing = 0.9, .centre = {3, 4}});
  CHECK(scene.time == flow::TimeSettings{.dt = 1e-27, .end = 5e-20, .scheme = flow::Scheme::rk4});
  CHECK(own(scene).velocity == vortex::VelocitySettings{.method = fmm::SumMethod::direct,
                                                        .tolerance = 1e-14,
                                                        .order = 13,
                                                        .capacity = 50,
                                                        .finest_level = 0,
                                                        .builder = fmm::Builder::forward,
                                                        .cores = vortex::PairCores::source});
  CHECK(scene.output.fields == std::vector<double>{0, 0.5, 1e-3});
  CHECK(scene.output.window == std::array<double, 4>{-1, -2, 3, 4});
  CHECK(scene.output.field_spacing == 0.1);
  CHECK(scene.check ==
        CheckSettings{.lift_max = 0.01, .exact = ExactAnswer::lamb_oseen, .blobs_max = 100000});
}

TEST_CASE("an integer that no double holds is read as the nearest double") {
  CHECK(parse(plain, {"initial.centre=[9007199254740993,-9223372036854775807]"}).initial->centre ==
        Pair{9007199254740992.0, -9223372036854775808.0});
  CHECK(own(parse(plain, {"flow.nu=0x20000000000001", "initial.core=1e17", "cores.sigma_max=1e16",
                          "cores.sigma_0=9007199254740993"}))
            .cores.sigma_0 == 9007199254740992.0);
}

TEST_CASE("a resolved scene is a scene, and the same one") {
  for (const std::string& text : {plain, full}) {
    const Scene scene = parse(text);
    const Scene again = parse(resolved(scene));
    CHECK(again == scene);
    CHECK(resolved(again) == resolved(scene));
  }
  CHECK_FALSE(parse(plain) == parse(full));
  CHECK_FALSE(parse(plain) == parse(plain, {"seed=2"}));
}

TEST_CASE("a scene remembers to the letter where it came from") {
  const std::vector<std::string> overrides{"flow.nu=2e-3", "title=Other"};
  const Scene scene = parse(plain, overrides);
  CHECK(scene.origin.path == "cases/ring.toml");
  CHECK(scene.origin.text == plain);
  CHECK(scene.origin.overrides == overrides);
  CHECK(parse_scene(scene.origin.text, scene.origin.path, scene.methods, scene.origin.overrides) ==
        scene);
}

TEST_CASE("an override wins over the file, and the last one over those before") {
  CHECK(parse(plain, {"flow.nu=0.5"}).flow.nu == 0.5);
  CHECK(parse(plain, {"flow.nu=0.5", "flow.nu = 1"}).flow.nu == 1);
  CHECK(parse(plain, {"flow.stream=[1, 2]"}).flow.stream == Pair{1, 2});
  CHECK(own(parse(plain, {"velocity.method=direct"})).velocity.method == fmm::SumMethod::direct);
  CHECK(own(parse(plain, {"velocity.method=\"direct\""})).velocity.method ==
        fmm::SumMethod::direct);
  CHECK(parse(plain, {"title=Two vortices"}).title == "Two vortices");
  CHECK(parse(plain, {"body.radius=0.25"}).body->number("radius") == 0.25);
  CHECK(parse(plain, {"output.fields=[]"}).output.fields.empty());
}

TEST_CASE("an override that is a table sets the keys that it names, and no others") {
  const Scene was = parse(full);
  Scene now = parse(full, {"body={radius=0.5, panels=70}", "body.panels=80"});
  CHECK(now.body->number("radius") == 0.5);
  CHECK(now.body->panels == 80);
  now.body->numbers = was.body->numbers;
  now.body->panels = was.body->panels;
  CHECK(now == was);
  CHECK(parse(full, {"body={}"}) == was);
  CHECK(parse(plain, {"body={radius=0.25}"}).body->number("radius") == 0.25);
}
