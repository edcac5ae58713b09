#include "io/scene/reference.hpp"
#include "scenes.hpp"

using namespace vortree::io;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

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
  CHECK(
      refused("speed = 1\n" + plain) ==
      "cases/ring.toml:1: speed is not a key at the top of a scene; known: title, seed, accuracy, "
      "tracers, probe, method; did you mean seed?");
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
  CHECK(extra("[[velocity]]\ntolerance = 1e-6") ==
        "cases/ring.toml:17: velocity is an array; a table was expected");
  CHECK(refused("body = [1, 2]\n" + plain) ==
        "cases/ring.toml:1: body is an array; tables were expected in it");
  CHECK(extra("[velocity]\nmethod = \"fast\"") ==
        "cases/ring.toml:18: velocity.method is \"fast\"; known: fmm, boxes, direct");
}

TEST_CASE("what is known of a wake is refused without how far off it may be") {
  const std::string cylinder = with("[initial]", "[body]\nradius = 0.5\n[initial]");
  for (const std::string key : {"strouhal", "mean_drag", "mean_lift", "morison_drag"})
    CHECK_THAT(refused(cylinder, {"check." + key + "=0.2"}),
               EndsWith("that needs check." + key + "_max, how far off it may be"));
}

TEST_CASE("what is known of each of several bodies is one number each, and how far off it may be") {
  const std::string alone =
      "[flow]\nnu = 1e-2\nstream = [1, 0]\n[cores]\nsigma_0 = 0.05\nsigma_max = 0.1\n"
      "[time]\ndt = 0.01\nend = 2\n[[body]]\nradius = 0.5\n";
  const std::string pair = alone + "[[body]]\nradius = 0.5\ncentre = [0, 2]\n";
  for (const std::string key : {"mean_drag_each", "mean_lift_each", "lift_rms_each"}) {
    const std::string name = "check." + key, bound = name + "_max=0.1";
    CHECK_THAT(refused(pair, {name + "=[1,2]"}),
               EndsWith("that needs " + name + "_max, how far off it may be"));
    CHECK_THAT(refused(pair, {bound}), EndsWith("that needs several bodies and " + name));
    CHECK_THAT(refused(alone, {name + "=[1]", bound}),
               EndsWith("that needs several bodies and " + name));
    CHECK_THAT(refused(pair, {name + "=[1]", bound}),
               EndsWith(name + " is a list of 1; a number of each of 2 bodies was expected"));
    CHECK_NOTHROW(parse(pair, {name + "=[1,2]", bound}));
  }
  CHECK_THAT(refused(pair, {"check.lift_phases_deg=[0,180]", "check.lift_phases_max_deg=5"}),
             EndsWith("is a list of 2; a number of each of 2 bodies but the first was expected"));
  CHECK_NOTHROW(parse(pair, {"check.lift_phases_deg=[180]", "check.lift_phases_max_deg=5"}));
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
        "cases/ring.toml:18: splitting.alpha is 1; it must be >= 0.1 and < 1");
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
        "cases/ring.toml: the table [time] is missing; [time] with dt, end was expected");
  CHECK(refused("[time]\ndt = 1\nend = 1\n[cores]\nsigma_0 = 1\nsigma_max = 1\n") ==
        "cases/ring.toml: the table [flow] is missing; [flow] with nu was expected");
  CHECK_THAT(
      refused(with("sigma_0 = 0.05\n", "")),
      StartsWith("cases/ring.toml:5: [cores] needs the key sigma_0, or the scene `accuracy`"));
  CHECK(refused("[flow]\nnu = 1\n[cores]\nsigma_0 = 1\nsigma_max = 1\n[time]\ndt = 1\nend = 2\n") ==
        "cases/ring.toml: a scene needs [body] or [initial]; without both there is no vorticity");
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
  CHECK(typed("initial={core=-1, separation=1}") ==
        "command line: initial={core=-1, separation=1}: initial.core is -1; it must be > 0");
  CHECK(typed("initial={separation=1}") ==
        "command line: initial={separation=1}: initial.kind is \"lamb_oseen\"; that does not have "
        "the key initial.separation");
  CHECK_THAT(typed("initial={cor=1}"),
             StartsWith("command line: initial={cor=1}: initial.cor is not a key of [initial]"));
  CHECK(typed("title={x=3}") ==
        "command line: title={x=3}: title is a string; a table was expected");
  CHECK(typed("title.x=3") == "cases/ring.toml:1: title is a string; a table was expected");
  CHECK(typed("time.end=0.001") ==
        "command line: time.end=0.001: time.end is 0.001; it must be >= time.dt = 0.01");
  CHECK(typed("flow.nu=1\nflow.nu=2") == "command line: flow.nu=1...: an override is one line");
}

TEST_CASE("what is no scene at all is refused") {
  const Sandbox box;
  const auto loaded = [](const std::filesystem::path& path) {
    return refusal([&] { (void)load_scene(path, by_vortices()); });
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
  CHECK(refusal([&] { (void)load_scene(path, by_vortices()); }) ==
        path.string() + ":18: check.drag_reference is \"reference/drag.csv\"; there is no file " +
            file);
  box.write("reference/drag.csv", "T,C_D\n1,2\n");
  const Scene scene = load_scene(path, by_vortices());
  CHECK(reference_path(scene, *scene.check.drag_reference) == file);
  const std::vector<std::string> mistyped{"check.drag_reference='reference/darg.csv'"};
  CHECK_THAT(refusal([&] { (void)load_scene(path, by_vortices(), mistyped); }),
             EndsWith("darg.csv; did you mean drag.csv?"));
}

TEST_CASE("a reference may be named by the Reynolds number, which need not be known") {
  const Sandbox box;
  const auto path =
      box.write("scene.toml",
                "[flow]\nreynolds = 20.0\nstream = [1, 0]\n[body]\nradius = 0.5\n"
                "[cores]\nsigma_0 = 0.05\nsigma_max = 0.1\n[time]\ndt = 0.01\nend = 2\n"
                "[check]\ndrag_reference = \"drag_re{reynolds}.csv\"\ndrag_max = 0.1\n");
  const std::string written = "drag_re{reynolds}.csv";
  const auto with = [&](const std::string& override) {
    return load_scene(path, by_vortices(), std::vector<std::string>{override});
  };
  box.write("drag_re20.csv", "T,C_D\n1,2\n");
  box.write("drag_re40.5.csv", "T,C_L\n1,2\n");
  const Scene known = with("flow.reynolds=2e1"), unknown = with("flow.reynolds=30");
  CHECK(reference_path(known, written) == box / "drag_re20.csv");
  CHECK_FALSE(lacks_reference(known, written));
  CHECK(known.check.drag_reference == written);
  CHECK(lacks_reference(unknown, written));
  CHECK_FALSE(lacks_reference(unknown, "drag_re30.csv"));
  CHECK_THAT(refusal([&] { (void)with("flow.reynolds=40.5"); }), Contains("no column C_D"));
  CHECK_THAT(refused(plain, {"check.drag_reference='" + written + "'"}),
             EndsWith("{reynolds} needs flow.reynolds"));
}

TEST_CASE("a name by the Reynolds number that no file has for any number is mistyped") {
  const Sandbox box;
  std::filesystem::create_directory(box / "known");
  box.write("known/drag_re20.csv", "T,C_D\n1,2\n");
  const auto path =
      box.write("scene.toml",
                "[flow]\nreynolds = 20.0\nstream = [1, 0]\n[body]\nradius = 0.5\n"
                "[cores]\nsigma_0 = 0.05\nsigma_max = 0.1\n[time]\ndt = 0.01\nend = 2\n"
                "[check]\ndrag_reference = \"known/drag_re{reynolds}.csv\"\ndrag_max = 0.1\n");
  const auto with = [&](const std::string& reference) {
    return refusal([&] {
      (void)load_scene(path, by_vortices(),
                       std::vector<std::string>{"check.drag_reference='" + reference + "'"});
    });
  };
  CHECK_THAT(with("known/darg_re{reynolds}.csv"),
             EndsWith("there is no file " + (box / "known/darg_re20.csv").string() +
                      "; did you mean drag_re20.csv?"));
  CHECK_THAT(with("unknown/drag_re{reynolds}.csv"),
             EndsWith("there is no file " + (box / "unknown/drag_re20.csv").string()));
  CHECK_THAT(with(""), EndsWith("check.drag_reference is \"\"; the name of a file was expected"));
}

TEST_CASE("a reference whose notes tell another Reynolds number is doubted") {
  const Sandbox box;
  const auto path =
      box.write("scene.toml",
                "[flow]\nreynolds = 20.0\nstream = [1, 0]\n[body]\nradius = 0.5\n"
                "[cores]\nsigma_0 = 0.05\nsigma_max = 0.1\n[time]\ndt = 0.01\nend = 2\n"
                "[check]\ndrag_reference = \"known.csv\"\ndrag_max = 0.1\n");
  const auto doubts = [&](const std::string& override) {
    return doubt_references(load_scene(path, by_vortices(), std::vector<std::string>{override}));
  };
  for (const char* note : {"# Re = U D / nu = 20, symmetric\n", "# solved for Re = 20; alone\n",
                           "# made by hand\n#\n# Re = 2e1\n"}) {
    box.write("known.csv", note + std::string("T,C_D\n1,2\n"));
    box.write("other.csv", "# Re = 30\nT,C_L\n1,2\n");
    CHECK(doubts("seed=1").empty());
    REQUIRE(doubts("flow.reynolds=1e5").size() == 1);
    CHECK_THAT(doubts("flow.reynolds=1e5")[0],
               Contains("\"known.csv\": it says Re = 20, and the flow has 100000"));
    CHECK(doubts("flow.stream=[2,0]").empty());  // the viscosity follows
    CHECK(doubts("check.lift_reference=other.csv").size() == 1);
  }
  for (const char* silent : {"", "# Re = many\n", "# where Re is known\n"}) {
    box.write("known.csv", silent + std::string("T,C_D\n1,2\n"));
    CHECK(doubts("flow.reynolds=1e5").empty());
  }
}

TEST_CASE("a reference file is a table with the columns that the check asks for") {
  const Sandbox box;
  const std::string body =
      "[flow]\nnu = 1e-3\nstream = [1, 0]\n[body]\nradius = 0.5\n"
      "[cores]\nsigma_0 = 0.05\nsigma_max = 0.1\n[time]\ndt = 0.01\nend = 2\n[check]\n";
  const auto path = box.write("scene.toml", body + "drag_reference = \"known.csv\"\n");
  const std::string known = (box / "known.csv").string();
  const auto refused_with = [&](const std::vector<std::string>& overrides) {
    return refusal([&] { (void)load_scene(path, by_vortices(), overrides); });
  };
  const std::string at = path.string() + ":13: check.drag_reference is \"known.csv\"; " + known;
  box.write("known.csv", "root:x:0\nbin:x:1,2\n");
  CHECK(refused_with({}) == at + ":2: 2 cells; 1 columns were expected");
  box.write("known.csv", "T,C_L\n1,2\n");
  CHECK(refused_with({}) == at + ": there is no column C_D; the file has T, C_L");
  for (const std::string none : {"T,C_D\n1,nan\n2,nan\n", "T,C_D\n1,inf\n", "T,C_D\n"}) {
    box.write("known.csv", none);
    CHECK_THAT(refused_with({}), Contains("has no number"));
  }
  for (const std::string order :
       {"T,C_D\n1,2\n1,2\n", "T,C_D\n2,2\n1,2\n", "T,C_D\n1,2\nnan,2\n"}) {
    box.write("known.csv", order);
    CHECK_THAT(refused_with({}), Contains("times must increase"));
  }
  box.write("known.csv", "T,C_D\n1,2\n");
  CHECK(load_scene(path, by_vortices()).check.drag_reference == "known.csv");
  CHECK_THAT(refused_with({"check.bubble_max=0.1"}),
             EndsWith("no column L_over_D; the file has T, C_D"));
  CHECK_THAT(refused_with({"check.separation_max_deg=1"}), Contains("no column sep_deg"));
  CHECK_THAT(refused_with({"check.lift_reference=known.csv"}),
             EndsWith("no column C_L; the file has T, C_D"));
  for (const std::string key : {"drag", "lift", "wall_vorticity", "front_pressure", "moments"})
    CHECK(refused_with({"check." + key + "_reference=."}) ==
          "command line: check." + key + "_reference=.: check." + key + "_reference is \".\"; " +
              (box / ".").string() + " is a folder; a file was expected");
  CHECK_THAT(refused_with({"check.wall_vorticity_reference=known.csv"}),
             Contains("no column theta_deg"));
  CHECK_THAT(refused_with({"check.moments_reference=known.csv"}), Contains("no column t;"));
}

TEST_CASE("what a check asks has something that it is held against, or is refused") {
  const std::string body =
      "[flow]\nnu = 1e-3\nstream = [1, 0]\n[body]\nradius = 0.5\n"
      "[cores]\nsigma_0 = 0.05\nsigma_max = 0.1\n[time]\ndt = 0.01\nend = 2\n";
  const auto asked = [](const std::string& scene, const std::string& key) {
    return refused(scene, {"check." + key + "=0.01"});
  };
  for (const char* key : {"drag_max", "drag_rms"})
    CHECK_THAT(asked(body, key), EndsWith("that needs [body] and check.drag_reference"));
  for (const char* key : {"bubble_max", "separation_max_deg"})
    CHECK_THAT(asked(body, key), EndsWith("that needs a single [body] and check.drag_reference"));
  for (const char* key : {"lift_error_max", "lift_error_rms"})
    CHECK_THAT(asked(body, key), EndsWith("that needs [body] and check.lift_reference"));
  CHECK(asked(body, "strouhal_max") ==
        "command line: check.strouhal_max=0.01: check.strouhal_max is 0.01; that needs [body] and "
        "check.strouhal");
  for (const char* key :
       {"wall_vorticity_max", "wall_vorticity_rms", "front_pressure_max", "mean_drag_max",
        "mean_lift_max", "morison_drag_max", "theodorsen_max", "energy_max"})
    CHECK_THAT(asked(body, key), StartsWith("command line: check." + std::string(key)));
  for (const char* key :
       {"lift_max", "routes_max", "lift_routes_max", "vorticity_max", "velocity_max",
        "rotation_max", "merger_max", "speed_max", "quadrupole_max", "separation_max"})
    CHECK_THAT(asked(plain, key), StartsWith("command line: check." + std::string(key)));
  const std::vector<std::vector<std::string>> unlike{
      {"motion.spin=1"},
      {"body.shape=ellipse", "body.across=0.2"},
      {"plunge.amplitude=0.1", "plunge.frequency=0.5"},
      {"initial.kind=lamb_oseen", "initial.circulation=0.1", "initial.core=0.1",
       "initial.centre=[2,0]"}};
  for (std::vector<std::string> words : unlike) {
    words.push_back("check.early_drag_max=0.01");
    CHECK_THAT(refused(body, words),
               EndsWith("that needs a single circle at rest in a flow.stream, and no [initial]"));
  }
  const std::string pair = std::string(body).replace(body.find("[body]"), 20, "") +
                           "[[body]]\nradius = 0.5\n[[body]]\nradius = 0.5\ncentre = [0, 2]\n";
  for (const char* key : {"early_drag_max", "bubble_max", "wall_vorticity_max"})
    CHECK_THAT(asked(pair, key), Contains("that needs a single "));
  CHECK(parse(body, {"check.early_drag_max=0.01"}).check.early_drag_max == 0.01);
  CHECK(parse(plain, {"check.energy_max=0.01"}).check.energy_max == 0.01);
  CHECK(parse(body, {"check.lift_max=0.01"}).check.lift_max == 0.01);
}
