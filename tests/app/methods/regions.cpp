#include <catch2/catch.hpp>

#include "app/methods/methods.hpp"
#include "io/input_error.hpp"
#include "io/scene/scene.hpp"
#include "sph/method.hpp"

using namespace vortree;
using Catch::Contains;

namespace {

const std::string two_regions = R"(method = "sph"
[flow]
nu = 0.01
[initial]
kind = "taylor_green"
wavelength = 1
[sph]
outside = "periodic"
spacing = 0.03125
[[sph.region]]
centre = [0.5, 0.25]
half_axes = [0.25, 0.125]
angle = 30
spacing = 0.02
[[sph.region]]
centre = [0, 0]
half_axes = [0.1, 0.1]
spacing = 0.01
[time]
end = 0.5
)";

io::Scene parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return io::parse_scene(text, "cases/vortices.toml", app::methods(), overrides);
}

const std::vector<sph::RegionSettings>& regions_of(const io::Scene& scene) {
  return dynamic_cast<const sph::SphMethod&>(scene.computed_by()).settings().regions;
}

std::string refused(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    (void)parse(text, overrides);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

std::string with(const std::string& old, const std::string& fresh) {
  std::string text = two_regions;
  return text.replace(text.find(old), old.size(), fresh);
}

}  // namespace

TEST_CASE("tables one after another are read into a list, with the defaults of their keys") {
  const io::Scene scene = parse(two_regions);
  CHECK(regions_of(scene) ==
        std::vector<sph::RegionSettings>{{{0.5, 0.25}, {0.25, 0.125}, 30, 0.02},
                                         {{0, 0}, {0.1, 0.1}, 0, 0.01}});
}

TEST_CASE("a list of tables is printed so that it reads back to itself") {
  for (const io::Scene& scene : {parse(two_regions), parse(two_regions, {"sph.region=[]"})}) {
    const io::Scene again = parse(io::resolved(scene));
    CHECK(regions_of(again) == regions_of(scene));
    CHECK(again == scene);
  }
  CHECK_FALSE(parse(two_regions) == parse(with("angle = 30", "angle = 31")));
}

TEST_CASE("a region that does not say its spacing has the finest") {
  CHECK(regions_of(parse(with("spacing = 0.01\n[time]", "[time]"))).at(1).spacing == 0.03125);
}

TEST_CASE("a list of tables can be written on the command line") {
  const io::Scene scene =
      parse(two_regions, {"sph.region=[{centre=[0.5, 0.5], half_axes=[0.2, 0.2], spacing=0.02}]"});
  CHECK(regions_of(scene) == std::vector<sph::RegionSettings>{{{0.5, 0.5}, {0.2, 0.2}, 0, 0.02}});
}

TEST_CASE("what is wrong in one of several tables is refused with its number and its own line") {
  CHECK(refused(with("spacing = 0.01", "spacing = -1")) ==
        "cases/vortices.toml:18: sph.region[1].spacing is -1; it must be > 0");
  CHECK(refused(with("half_axes = [0.1, 0.1]", "half_axes = [0.1, 0]")) ==
        "cases/vortices.toml:17: sph.region[1].half_axes[1] is 0; it must be > 0");
  CHECK(refused(with("centre = [0, 0]\n", "")) ==
        "cases/vortices.toml:15: [sph.region[1]] needs the key centre");
  CHECK_THAT(
      refused(with("angle = 30", "angel = 30")),
      Contains("cases/vortices.toml:13: sph.region[0].angel is not a key of [sph.region[0]]") &&
          Contains("did you mean angle?"));
  for (const std::string text : {"3", "[1, 2]", "{centre = [0, 0]}", "[{spacing = 1}, 2]"})
    CHECK_THAT(refused(two_regions, {"sph.region=" + text}),
               Contains("an array of tables was expected"));
  CHECK_THAT(refused(with("spacing = 0.01", "spacing = 1e-40")),
             Contains("sph.region is 1e-40; numbers of a size within"));
}
