#include <catch2/catch.hpp>

#include "app/program.hpp"

using namespace vortree::test;

// What a browser makes of a page: tests/view/run.py.

namespace {

const std::string circle = R"(
accuracy = 0.1
[flow]
reynolds = 40
stream = [1.0, 0.0]
[body]
radius = 0.5
[time]
dt = 0.04
end = 0.16
[output]
frames = 0.04
)";

/// The folder r of a run without figures.
void run(const TemporaryFolder& in, const std::string& more = "") {
  const NoFigures quick(in);
  in.write("scene.toml", circle);
  REQUIRE(call("run scene.toml --out r " + more, in).code == 0);
}

}  // namespace

TEST_CASE("a page is one file that asks for nothing else, and takes the place of an older one") {
  const TemporaryFolder folder;
  run(folder);
  folder.write("r/view.html", "an older one");
  const Outcome made = call("view r", folder);
  CHECK(made.err == "");
  REQUIRE(made.code == 0);
  CHECK(made.out.starts_with("r/view.html: 5 frames, up to "));
  const std::string page = text_of(folder / "r/view.html");
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(page.ends_with("</html>\n"));
  CHECK(page.find("://") == std::string::npos);
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(page.find("id=\"frame-4\"") != std::string::npos);
  CHECK(page.find("{{") == std::string::npos);
}

TEST_CASE("a page goes where it is asked to go, over another file only if told so") {
  const TemporaryFolder folder;
  run(folder);
  REQUIRE(call("view r --out mine.html", folder).code == 0);
  folder.write("mine.html", "of someone");
  const Outcome refused = call("view r --out mine.html", folder);
  CHECK(refused.code == 2);
  CHECK(refused.err.find("mine.html is there already: --overwrite") != std::string::npos);
  CHECK(text_of(folder / "mine.html") == "of someone");
  CHECK(call("view r --out mine.html --overwrite", folder).code == 0);
  CHECK(text_of(folder / "mine.html").starts_with("<!DOCTYPE html>"));
  CHECK(!fs::exists(folder / "r/view.html"));
}

TEST_CASE("a page of nothing is refused in a line, and none is left") {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& arguments) {
    const Outcome refused = call(arguments, folder);
    CAPTURE(arguments, refused.err);
    CHECK(refused.code == 2);
    CHECK(refused.error_lines() == 1);
    return refused.err;
  };
  using Catch::Contains;
  CHECK_THAT(refusal("view nowhere"), Contains("nowhere: no such folder"));
  CHECK_THAT(refusal("view nowhere --live"), Contains("nowhere: no such folder"));
  fs::create_directory(folder / "empty");
  CHECK_THAT(refusal("view empty"), Contains("no run has left frames.h5"));
  CHECK_THAT(refusal("view empty --port 80"), Contains("--live"));
  CHECK_THAT(refusal("view empty --live --port 0"), Contains("--port"));
  CHECK_THAT(refusal("view empty --live --out a.html"), Contains("--out"));
  run(folder);
  CHECK_THAT(refusal("view r --out page.txt"), Contains(".html"));
  CHECK_THAT(refusal("view r --out none/page.html"), Contains("no such folder"));
  folder.write("empty/frames.h5", "no frames");
  CHECK_THAT(refusal("view empty"), Contains("not a readable HDF5 file"));
  CHECK_THAT(refusal("view empty --live"), Contains("not a readable HDF5 file"));
  CHECK(!fs::exists(folder / "r/view.html"));
  CHECK(!fs::exists(folder / "empty/view.html"));
}

TEST_CASE("a page goes with the run that it shows, and is no figure") {
  const TemporaryFolder folder;
  run(folder);
  folder.write("r/view.html", "of another flow");
  run(folder, "--overwrite");
  CHECK(!fs::exists(folder / "r/view.html"));
  CHECK(call("plot r", folder).out.find("view") == std::string::npos);
}
