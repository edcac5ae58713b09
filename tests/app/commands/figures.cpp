#include <catch2/catch.hpp>
#include <string>

#include "app/lone_vortex.hpp"
#include "app/program.hpp"

using namespace vortree::test;

TEST_CASE("a run's figures as PDF and SVG are what they say, and the same bytes twice") {
  const TemporaryFolder folder;
  {
    const NoFigures quick(folder);
    folder.write("vortex.toml", lone_vortex_by_pairs);
    REQUIRE(call("run vortex.toml --out run", folder).code == 0);
  }
  const auto drawn = call("plot run --as pdf,svg", folder);
  CAPTURE(drawn.out, drawn.err);
  CHECK(drawn.code == 0);
  CHECK_FALSE(fs::exists(folder / "run/tree.png"));
  const std::string pdf = text_of(folder / "run/tree.pdf"), svg = text_of(folder / "run/tree.svg");
  CHECK(pdf.starts_with("%PDF-1.4\n"));
  CHECK(pdf.find("/FontFile2") != std::string::npos);  // TrueType, as pdf.fonttype 42 has it
  CHECK(pdf.find("CreationDate") == std::string::npos);
  CHECK(svg.starts_with("<?xml"));
  CHECK(svg.find("<svg ") != std::string::npos);
  CHECK(svg.find("<text ") == std::string::npos);
  CHECK(svg.find("<dc:date>") == std::string::npos);
  // In another order, beside another format.
  CHECK(call("plot run --as svg --as png --as pdf", folder).code == 0);
  CHECK(text_of(folder / "run/tree.pdf") == pdf);
  CHECK(text_of(folder / "run/tree.svg") == svg);
  CHECK(fs::exists(folder / "run/tree.png"));
  const auto refused = call("plot run --as jpg", folder);
  CHECK(refused.code == 2);
  CHECK(refused.error_lines() == 1);

  // A run draws as it is told, and refuses to draw over what is no figure of its own.
  fs::create_directory(folder / "other");
  folder.write("other/tree.pdf", "a page of somebody's");
  const auto over = call("run vortex.toml --out other --as pdf", folder);
  CHECK(over.code == 2);
  CHECK(over.err.find("tree.pdf is there already") != std::string::npos);
  CHECK(call("run vortex.toml --out other --as pdf --overwrite", folder).code == 0);
  CHECK(text_of(folder / "other/tree.pdf") == pdf);
}

TEST_CASE("a figure takes the place of a figure alone, and two may draw it at once") {
  const TemporaryFolder folder;
  {
    const NoFigures quick(folder);
    folder.write("vortex.toml", lone_vortex_by_pairs);
    REQUIRE(call("run vortex.toml --out run", folder).code == 0);
  }
  const std::string plot = "'" VORTREE_PROGRAM "' plot run";
  CHECK(shell(plot + " & one=$!; " + plot + " && wait $one", folder).code == 0);
  for (const auto& entry : fs::directory_iterator(folder / "run"))
    CHECK(entry.path().extension() != ".part");
  const std::string frames = text_of(folder / "run/frames.h5");
  const auto refused = [&](const std::string& words) {
    const auto outcome = call("plot run", folder);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(words) != std::string::npos);
    CHECK((text_of(folder / "run/frames.h5") == frames));
    fs::remove(folder / "run/tree.png");
  };
  fs::remove(folder / "run/tree.png");
  fs::create_symlink("frames.h5", folder / "run/tree.png");
  refused("run/tree.png is a link to ");
  fs::create_directory(folder / "run/tree.png");
  refused("run/tree.png is no file, and is not replaced");
}
