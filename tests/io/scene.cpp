#include "io/scene.hpp"

#include <cmath>

#include "sandbox.hpp"

using namespace vortree::io;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

const std::string plain = R"(title = "A vortex"
[flow]
nu = 1e-3

[cores]
sigma_0 = 0.05
sigma_max = 0.1

[initial]
kind = "lamb_oseen"
circulation = 1
core = 0.2

[time]
dt = 0.01
end = 2
)";

const std::string full = R"(title = "tab \t, quote \", Gr\u00f6\u00dfe"
seed = 77
[flow]
nu = 0.001
stream = [1, -0.25]
[body]
shape = "circle"
radius = 0.3333333333333333
centre = [0.1, 0.2]
panels = 64
[cores]
sigma_0 = 0.05
sigma_max = 0.1
[splitting]
alpha = 0.8
children = 5
[merging]
tolerance = 0
reach = 1.5
cap = 1.3
[initial]
kind = "lamb_oseen"
circulation = -1.5
core = 0.2
spacing = 0.9
centre = [3, 4]
[time]
dt = 1e-300
end = 1e300
scheme = "rk4"
[velocity]
method = "direct"
tolerance = 1e-14
order = 13
capacity = 50
finest_level = 0
builder = "forward"
cores = "source"
[output]
frames = 0.125
fields = [0, 0.5, 1e-3]
window = [-1, -2, 3, 4]
field_spacing = 0.1
[check]
drag_max = 0.01
exact = "lamb_oseen"
blobs_max = 100000
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = plain;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

Scene parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_scene(text, "cases/ring.toml", overrides);
}

std::string refused(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return refusal([&] { (void)parse(text, overrides); });
}

}  // namespace

TEST_CASE("a scene says everything that it does not leave to the defaults") {
  const Scene scene = parse(plain);
  CHECK(scene.title == "A vortex");
  CHECK(scene.seed == 1);
  CHECK(scene.flow == SceneFlow{.nu = 1e-3});
  CHECK_FALSE(scene.body);
  CHECK(scene.cores == SceneCores{.sigma_0 = 0.05, .sigma_max = 0.1});
  CHECK(scene.splitting == SceneSplitting{.alpha = 0.7, .children = 4});
  CHECK(scene.merging == SceneMerging{.tolerance = 0.02, .reach = 2, .cap = 1.1});
  CHECK(scene.initial == SceneInitial{.circulation = 1, .core = 0.2, .spacing = 1});
  CHECK(scene.time == SceneTime{.dt = 0.01, .end = 2, .scheme = TimeScheme::rk2});
  CHECK(scene.velocity == SceneVelocity{});
  CHECK(scene.velocity.cores == PairCores::mean);
  CHECK(scene.output == SceneOutput{.frames = 2.0 / 14});
  CHECK(scene.check == SceneCheck{});
}

TEST_CASE("every key of a scene is read") {
  const Scene scene = parse(full);
  CHECK(scene.title == "tab \t, quote \", Größe");
  CHECK(scene.seed == 77);
  CHECK(scene.flow.stream == Vec2{1, -0.25});
  CHECK(scene.body == SceneBody{.radius = 1.0 / 3, .centre = {0.1, 0.2}, .panels = 64});
  CHECK(scene.splitting == SceneSplitting{.alpha = 0.8, .children = 5});
  CHECK(scene.merging == SceneMerging{.tolerance = 0, .reach = 1.5, .cap = 1.3});
  CHECK(scene.initial ==
        SceneInitial{.circulation = -1.5, .core = 0.2, .spacing = 0.9, .centre = {3, 4}});
  CHECK(scene.time == SceneTime{.dt = 1e-300, .end = 1e300, .scheme = TimeScheme::rk4});
  CHECK(scene.velocity == SceneVelocity{.method = VelocityMethod::direct,
                                        .tolerance = 1e-14,
                                        .order = 13,
                                        .capacity = 50,
                                        .finest_level = 0,
                                        .builder = TreeBuilder::forward,
                                        .cores = PairCores::source});
  CHECK(scene.output.fields == std::vector<double>{0, 0.5, 1e-3});
  CHECK(scene.output.window == std::array<double, 4>{-1, -2, 3, 4});
  CHECK(scene.output.field_spacing == 0.1);
  CHECK(scene.check ==
        SceneCheck{.drag_max = 0.01, .exact = ExactAnswer::lamb_oseen, .blobs_max = 100000});
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
  CHECK(parse_scene(scene.origin.text, scene.origin.path, scene.origin.overrides) == scene);
}

TEST_CASE("an override wins over the file, and the last one over those before") {
  CHECK(parse(plain, {"flow.nu=0.5"}).flow.nu == 0.5);
  CHECK(parse(plain, {"flow.nu=0.5", "flow.nu = 1"}).flow.nu == 1);
  CHECK(parse(plain, {"flow.stream=[1, 2]"}).flow.stream == Vec2{1, 2});
  CHECK(parse(plain, {"velocity.method=direct"}).velocity.method == VelocityMethod::direct);
  CHECK(parse(plain, {"velocity.method=\"direct\""}).velocity.method == VelocityMethod::direct);
  CHECK(parse(plain, {"title=Two vortices"}).title == "Two vortices");
  CHECK(parse(plain, {"body.radius=0.25"}).body == SceneBody{.radius = 0.25});
  CHECK(parse(plain, {"output.fields=[]"}).output.fields.empty());
}

TEST_CASE("an unknown key is refused with its line and the nearest known one") {
  CHECK(refused(with("nu = ", "nuu = ")) ==
        "cases/ring.toml:3: flow.nuu is not a key of [flow]; known: nu, stream, reynolds; did you "
        "mean nu?");
  CHECK(refused(plain + "[velocity]\ntolerence = 1e-3\n") ==
        "cases/ring.toml:18: velocity.tolerence is not a key of [velocity]; known: method, "
        "tolerance, order, capacity, finest_level, builder, cores; did you mean tolerance?");
  CHECK_THAT(
      refused(with("[time]", "[times]")),
      StartsWith("cases/ring.toml:14: [times] is not a table of a scene; known: flow, body,") &&
          EndsWith("did you mean time?"));
  CHECK(refused("speed = 1\n" + plain) ==
        "cases/ring.toml:1: speed is not a key at the top of a scene; known: title, seed, "
        "accuracy; did "
        "you mean seed?");
  CHECK_THAT(refused(with("nu = 1e-3", "nu = 1e-3\nzebra = 1")),
             EndsWith("known: nu, stream, reynolds"));
  CHECK_THAT(refused("\"a.b\" = 1\n" + plain), StartsWith("cases/ring.toml:1: a.b is not a key"));
}

TEST_CASE("a value of the wrong type is refused with what it is and what was expected") {
  const auto flow = [](const std::string& line) { return refused(with("nu = 1e-3", line)); };
  const auto extra = [](const std::string& lines) { return refused(plain + lines); };
  CHECK(flow("nu = \"small\"") == "cases/ring.toml:3: flow.nu is a string; a number was expected");
  CHECK(flow("nu = true") == "cases/ring.toml:3: flow.nu is a boolean; a number was expected");
  CHECK(flow("nu = 1979-05-27") ==
        "cases/ring.toml:3: flow.nu is a date or time; a number was expected");
  CHECK(flow("nu = 1\nstream = 1") ==
        "cases/ring.toml:4: flow.stream is an integer; an array of 2 numbers was expected");
  CHECK(flow("nu = 1\nstream = [1]") ==
        "cases/ring.toml:4: flow.stream has 1 elements; an array of 2 numbers was expected");
  CHECK(flow("nu = 1\nstream = [\n 1, 'a']") ==
        "cases/ring.toml:4: flow.stream[1] is a string; a number was expected");
  CHECK(extra("[body]\nradius = 1\npanels = 64.0") ==
        "cases/ring.toml:19: body.panels is a floating-point number; an integer was expected");
  CHECK(extra("[output]\nfields = 3") ==
        "cases/ring.toml:18: output.fields is an integer; an array of numbers was expected");
  CHECK(extra("[check]\nexact = 1") ==
        "cases/ring.toml:18: check.exact is an integer; a string was expected");
  CHECK(refused("velocity = 3\n" + plain) ==
        "cases/ring.toml:1: velocity is an integer; a table was expected");
  CHECK(extra("[[body]]\nradius = 1") ==
        "cases/ring.toml:17: body is an array; a table was expected");
  CHECK(extra("[velocity]\nmethod = \"fast\"") ==
        "cases/ring.toml:18: velocity.method is \"fast\"; known: fmm, boxes, direct");
}

TEST_CASE("a value out of its range is refused with the range") {
  const auto extra = [](const std::string& lines) { return refused(plain + lines); };
  CHECK(refused(with("1e-3", "-0.001")) ==
        "cases/ring.toml:3: flow.nu is -0.001; viscosity must be >= 0");
  CHECK(refused(with("1e-3", "nan")) ==
        "cases/ring.toml:3: flow.nu is nan; a finite number was expected");
  CHECK(refused(with("1e-3", "-inf")) ==
        "cases/ring.toml:3: flow.nu is -inf; a finite number was expected");
  CHECK(refused(with("dt = 0.01", "dt = 0")) == "cases/ring.toml:15: time.dt is 0; it must be > 0");
  CHECK(refused(with("end = 2", "end = 0.001")) ==
        "cases/ring.toml:16: time.end is 0.001; it must be >= time.dt = 0.01");
  CHECK(refused(with("sigma_max = 0.1", "sigma_max = 0.01")) ==
        "cases/ring.toml:7: cores.sigma_max is 0.01; it must be >= cores.sigma_0 = 0.05");
  CHECK(refused(with("core = 0.2", "core = 0.05")) ==
        "cases/ring.toml:12: initial.core is 0.05; it must be > cores.sigma_0 = 0.05");
  CHECK(refused("seed = -1\n" + plain) == "cases/ring.toml:1: seed is -1; it must be >= 0");
  CHECK(extra("[body]\nradius = -2") == "cases/ring.toml:18: body.radius is -2; it must be > 0");
  CHECK(extra("[body]\nradius = 2\npanels = 7") ==
        "cases/ring.toml:19: body.panels is 7; a body needs at least 8 panels");
  CHECK(extra("[body]\nradius = 2\npanels = 3000000000") ==
        "cases/ring.toml:19: body.panels is 3000000000; it must be <= 2147483647");
  CHECK(extra("[splitting]\nalpha = 1") ==
        "cases/ring.toml:18: splitting.alpha is 1; it must lie between 0 and 1");
  CHECK(extra("[splitting]\nchildren = 2") ==
        "cases/ring.toml:18: splitting.children is 2; a ring has 3 to 64 children");
  CHECK(extra("[merging]\ntolerance = -1") ==
        "cases/ring.toml:18: merging.tolerance is -1; it must be >= 0");
  CHECK(extra("[velocity]\ntolerance = 1e-15") ==
        "cases/ring.toml:18: velocity.tolerance is 1e-15; it must lie in 1e-14 .. 0.1");
  CHECK(extra("[velocity]\nfinest_level = 32") ==
        "cases/ring.toml:18: velocity.finest_level is 32; it must lie in 0 .. 31");
  CHECK(extra("[velocity]\norder = -1") ==
        "cases/ring.toml:18: velocity.order is -1; it must lie in 0 .. 100; 0: from the tolerance");
  CHECK(extra("[output]\nframes = 0.001") ==
        "cases/ring.toml:18: output.frames is 0.001; it must be >= time.dt = 0.01");
  CHECK(extra("[output]\nfields = [1, -1]") ==
        "cases/ring.toml:18: output.fields[1] is -1; it must be >= 0");
}

TEST_CASE("keys that need others say which") {
  const auto extra = [](const std::string& lines) { return refused(plain + lines); };
  CHECK(extra("[output]\nfields = [1]") ==
        "cases/ring.toml:18: output.fields needs output.window and output.field_spacing beside it");
  CHECK(extra("[output]\nwindow = [0, 0, 0, 1]") ==
        "cases/ring.toml:18: output.window is [0, 0, 0, 1]; [x0, y0, x1, y1] with x0 < x1 and "
        "y0 < y1 was expected");
  CHECK_THAT(extra("[output]\nwindow = [0, 0, 1, 1]\nfield_spacing = 1e-6"),
             StartsWith("cases/ring.toml:19: output.field_spacing is 1e-06; that makes a picture "
                        "of 1e+12 points"));
  CHECK(refused(with("nu = 1e-3", "")) == "cases/ring.toml:2: [flow] needs the key nu");
  CHECK(refused(with("circulation = 1\n", "")) ==
        "cases/ring.toml:9: [initial] needs the key circulation");
  CHECK(refused("[flow]\nnu = 1\n[cores]\nsigma_0 = 1\nsigma_max = 1\n") ==
        "cases/ring.toml: the table [time] is missing");
  CHECK_THAT(
      refused(with("sigma_0 = 0.05\n", "")),
      StartsWith("cases/ring.toml:5: [cores] needs the key sigma_0, or the scene `accuracy`"));
  CHECK(refused("[flow]\nnu = 1\n[cores]\nsigma_0 = 1\nsigma_max = 1\n[time]\ndt = 1\nend = 2\n") ==
        "cases/ring.toml: a scene needs [body] or [initial]; without both there is no vorticity");
}

TEST_CASE("an accuracy chooses what is not written, and only that") {
  const std::string rest =
      "[flow]\nreynolds = 550\nstream = [2, 0]\n[body]\nradius = 0.25\n"
      "[time]\nend = 1\n";
  const Scene scene = parse("accuracy = 0.01\n" + rest);
  CHECK(scene.flow.nu == Approx(2 * 0.5 / 550));
  CHECK(scene.time.dt == Approx(0.02 * 0.25));
  CHECK(scene.cores.sigma_max == Approx(4 * std::sqrt(0.01 * scene.flow.nu * 0.25)));
  CHECK(scene.cores.sigma_0 == Approx(std::sqrt(2 * scene.flow.nu * scene.time.dt)));
  CHECK(scene.velocity.cores == PairCores::both);
  CHECK(parse(resolved(scene)) == scene);
  const Scene finer = parse("accuracy = 0.0025\n" + rest);
  CHECK(finer.cores.sigma_max == Approx(scene.cores.sigma_max / 2));
  CHECK(finer.time.dt < scene.time.dt);
  CHECK(finer.merging.tolerance == Approx(scene.merging.tolerance / 2));
  CHECK(finer.velocity.tolerance < scene.velocity.tolerance);
  CHECK(finer.body->panels > scene.body->panels);
  const Scene own = parse("accuracy = 0.01\n" + rest, {"time.dt=0.001", "body.panels=99"});
  CHECK(own.time.dt == 0.001);
  CHECK(own.body->panels == 99);
  CHECK(own.cores.sigma_max == scene.cores.sigma_max);
  CHECK(parse(plain, {"accuracy=0.1"}).cores == parse(plain).cores);
}

TEST_CASE("a Reynolds number needs a body and a stream, and no other viscosity beside it") {
  CHECK(refused(with("nu = 1e-3", "reynolds = 10")) ==
        "cases/ring.toml:3: flow.reynolds is 10; that needs [body] and a flow.stream "
        "or a [plunge]");
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
  CHECK(length_of(*foil.body) == 3);
  CHECK(edge_of(*foil.body) == 0.005);
  CHECK(parse(resolved(foil)) == foil);
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
  CHECK(speed_of(rest) == Approx(fastest));
  CHECK(rest.flow.nu == Approx(fastest / 10));
  CHECK(parse(resolved(rest)) == rest);
  const Scene stream = parse(with("nu = 1e-3", "reynolds = 10\nstream = [3, 4]") + body + plunge);
  CHECK(speed_of(stream) == Approx(5));
  CHECK(fastest_of(stream) == Approx(std::hypot(5, fastest)));
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

TEST_CASE("a wrong override is refused as it was typed") {
  const auto typed = [](const std::string& text) { return refused(plain, {"seed=3", text}); };
  CHECK(typed("flow.nu=-1") == "command line: flow.nu=-1: flow.nu is -1; viscosity must be >= 0");
  CHECK(typed("flow.nu=small") ==
        "command line: flow.nu=small: flow.nu is a string; a number was expected");
  CHECK_THAT(typed("flow.nu=1e"), StartsWith("command line: flow.nu=1e: not a TOML value: "));
  CHECK(typed("flow.nu=") == "command line: flow.nu=: there is no value behind the =");
  CHECK(typed("flow.nu") == "command line: flow.nu: an override is written table.key=value");
  CHECK(typed("=3") == "command line: =3: an override is written table.key=value");
  CHECK(
      typed("flow.nuu=1") ==
      "command line: flow.nuu=1: flow.nuu is not a key of [flow]; known: nu, stream, reynolds; did "
      "you mean nu?");
  CHECK_THAT(typed("flw.nu=1"), StartsWith("command line: flw.nu=1: [flw] is not a table of a "));
  CHECK_THAT(typed("a.b.c=1"), StartsWith("command line: a.b.c=1: [a] is not a table of a scene"));
  CHECK(typed("body.panels=20") ==
        "command line: body.panels=20: body.shape is \"circle\"; that needs the key body.radius");
  CHECK(typed("flow=3") == "command line: flow=3: flow is an integer; a table was expected");
  CHECK(typed("title.x=3") == "cases/ring.toml:1: title is a string; a table was expected");
  CHECK(typed("time.end=0.001") ==
        "command line: time.end=0.001: time.end is 0.001; it must be >= time.dt = 0.01");
  CHECK(typed("flow.nu=1\nflow.nu=2") == "command line: flow.nu=1...: an override is one line");
}

TEST_CASE("what is no scene at all is refused") {
  const Sandbox box;
  const auto loaded = [](const std::filesystem::path& path) {
    return refusal([&] { (void)load_scene(path); });
  };
  const auto at = [&](std::string_view name) { return (box / name).string(); };
  CHECK(loaded(box / "none.toml") == at("none.toml") + ": no such file");
  CHECK(loaded(box.path()) == box.path().string() + " is a folder; a file was expected");
  const std::string empty = " is empty; a scene needs [flow], [cores] and [time]";
  CHECK(loaded(box.write("empty.toml", "")) == at("empty.toml") + empty);
  CHECK(loaded(box.write("comment.toml", "# nothing\n")) == at("comment.toml") + empty);
  CHECK_THAT(loaded(box.write("bad.toml", "[flow]\nnu = 1\nthis is not TOML\n")),
             StartsWith(at("bad.toml") + ":3: not TOML: "));
  CHECK_THAT(loaded(box.write("twice.toml", plain + "[flow]\nnu = 2\n")),
             StartsWith(at("twice.toml") + ":17: not TOML: "));
  CHECK_THAT(loaded(box.write("binary.toml", std::string("\x89HDF\r\n\x1a\n\0\0\0", 11))),
             StartsWith(at("binary.toml") + ":1: not TOML: "));
}

TEST_CASE("a reference file is looked for beside the scene, and must be there") {
  const Sandbox box;
  std::filesystem::create_directory(box / "reference");
  const auto path =
      box.write("scene.toml", plain + "[check]\ndrag_reference = \"reference/drag.csv\"\n");
  const std::string file = (box / "reference/drag.csv").string();
  CHECK(refusal([&] { (void)load_scene(path); }) ==
        path.string() + ":18: check.drag_reference is \"reference/drag.csv\"; there is no file " +
            file);
  box.write("reference/drag.csv", "T,C_D\n");
  const Scene scene = load_scene(path);
  CHECK(reference_path(scene, *scene.check.drag_reference) == file);
}
