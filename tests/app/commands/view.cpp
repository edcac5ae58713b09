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

TEST_CASE("a page never takes the place of what a link of its name leads to, but another page") {
  const TemporaryFolder folder;
  run(folder);
  const std::string frames = text_of(folder / "r/frames.h5");
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const Outcome outcome = call(arguments, folder);
    CAPTURE(arguments, outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(words) != std::string::npos);
    CHECK((text_of(folder / "r/frames.h5") == frames));
  };
  fs::create_symlink("r/frames.h5", folder / "link.html");
  refused("view r --out link.html --overwrite", "is the input r/frames.h5; the output would");
  fs::copy(folder / "r", folder / "copy");
  refused("view copy --out link.html --overwrite", "which is no .html file; the output would");
  fs::create_symlink("frames.h5", folder / "r/view.html");
  refused("view r", "is the input r/frames.h5; the output would destroy it");
  {
    // a run anew removes its older page, and no other run's frames
    fs::create_symlink("../r/frames.h5", folder / "copy/view.html");
    const NoFigures quick(folder);
    CHECK(call("run scene.toml --out copy --overwrite", folder).code == 0);
    CHECK((text_of(folder / "r/frames.h5") == frames));
  }
  fs::create_symlink(folder.write("page.html", "an older one"), folder / "page_too.html");
  CHECK(call("view r --out page_too.html --overwrite", folder).code == 0);
  CHECK(fs::is_symlink(folder / "page_too.html"));
  CHECK(text_of(folder / "page.html").starts_with("<!DOCTYPE html>"));
}

TEST_CASE("what keeps a page from being made is said with the file or the port") {
  const TemporaryFolder folder;
  run(folder);
  const auto refusal = [&](const std::string& line) {
    const Outcome refused = shell(line, folder);
    CAPTURE(line, refused.err);
    CHECK(refused.code == 2);
    CHECK(refused.error_lines() == 1);
    CHECK(refused.err.starts_with("vortree: "));
    return refused.err;
  };
  const std::string vortree = "'" VORTREE_PROGRAM "' ";
  using Catch::Contains;
  CHECK_THAT(refusal(vortree + "view r --out /proc/page.html"), Contains("/proc/page.html cannot"));
  CHECK_THAT(
      refusal("/usr/bin/python3 -c 'import socket, subprocess, sys; s = socket.socket();"
              "s.bind((\"127.0.0.1\", 0)); s.listen(); sys.exit(subprocess.call([sys.argv[1],"
              "\"view\", \"r\", \"--live\", f\"--port={s.getsockname()[1]}\"]))' " +
              vortree),
      Contains("port ") && Contains(" is in use"));
  fs::remove(folder / "r/report.csv");
  CHECK_THAT(refusal(vortree + "view r"), Contains("r/report.csv: no such file"));
}
