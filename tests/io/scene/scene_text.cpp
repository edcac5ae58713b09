#include <fstream>
#include <regex>

#include "scenes.hpp"

using namespace vortree::io;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

std::string repeated(std::string_view word, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += word;
  return text;
}

std::string utf16(std::string_view text) {
  std::string wide = "\xff\xfe";
  for (const char c : text) wide += {c, '\0'};
  return wide;
}

}  // namespace

TEST_CASE("a scene that is no text of UTF-8 is refused with the line") {
  CHECK(refused(utf16(plain)) ==
        "cases/ring.toml:1: not TOML: the text is UTF-16; UTF-8 was expected");
  CHECK(refused(plain + "# gr\xfc\xdf\x65\n") ==
        "cases/ring.toml:17: not TOML: the byte 0xfc does not belong into a text of UTF-8");
  CHECK(refused(plain + std::string(1, '\0')) ==
        "cases/ring.toml:17: not TOML: the byte 0x00 does not belong into a text of UTF-8");
  CHECK_NOTHROW(parse("\xef\xbb\xbf" + plain));
}

TEST_CASE("no depth of a scene is too deep for an answer") {
  const std::string deep = "cases/ring.toml:1: not TOML: a key of more than 500 parts";
  CHECK(refused("[a" + repeated(".a", 20000) + "]\n") == deep);
  CHECK(refused("a" + repeated(".a", 20000) + " = 1\n") == deep);
  CHECK(refused("[[a" + repeated(". 'a'", 2000) + "]]\n") == deep);
  CHECK(refused("x = {a" + repeated(".a", 20000) + " = 1}\n") == deep);
  CHECK_THAT(refused("x = " + repeated("[", 20000)), StartsWith("cases/ring.toml:1: not TOML: "));
  CHECK_THAT(refused("x = " + repeated("{a = ", 10000)),
             StartsWith("cases/ring.toml:1: not TOML: "));
  CHECK_THAT(refused(plain, {"flow.nu={a" + repeated(".a", 20000) + " = 1}"}),
             EndsWith(": not a TOML value: a key of more than 500 parts"));
  CHECK_NOTHROW(parse("title = \"" + repeated(".", 500) + "\"\n" + plain.substr(plain.find('['))));
}

TEST_CASE("a scene is no longer than a frames file can keep") {
  CHECK(refused(plain + "#" + std::string(60000, 'x')) == "cases/ring.toml has " +
                                                              std::to_string(plain.size() + 60001) +
                                                              " bytes; a scene has 60000 at most");
  CHECK_THAT(refused(plain, {"title=" + std::string(70000, 'x')}), EndsWith(": too long"));
}

TEST_CASE("of long words and lists an error tells the part that helps") {
  const auto line = [](const std::string& text) { return refused(plain + text); };
  CHECK(line("[check]\nzebra = 1\n").size() < 200);
  CHECK_THAT(line("[check]\ndrag_maxx = 1\n"),
             Contains("known: drag_max,") && Contains(" more; did you mean drag_max?"));
  for (const std::string& said :
       {refused(std::string(50000, 'k') + " = 1\n" + plain),
        line("[" + std::string(40000, 'k') + "]\n"),
        line("[check]\n" + std::string(40000, 'k') + " = 1\n"),
        line("[velocity]\nmethod = \"" + std::string(40000, 'k') + "\"\n"),
        line("[check]\ndrag_reference = \"" + std::string(40000, 'k') + "\"\n"),
        refused(plain, {std::string(40000, 'k') + "=1"}),
        refused(plain, {"flow.nu=" + std::string(40000, '1')}),
        refused(plain, {"velocity.method=" + std::string(40000, 'k')})}) {
    CAPTURE(said);
    CHECK(said.size() < 400);
  }
}

TEST_CASE("the page of keys gives the defaults that the program has") {
  std::ifstream page(VORTREE_SOURCE_DIR "/cases/scenes.md");
  const std::regex row(R"(\| `([a-z]+)\.([a-z_0]+)` \| ([^|]+) \|.*)");
  const std::string text = plain + "[body]\nradius = 1\n";
  int given = 0, required = 0;
  for (std::string line; std::getline(page, line) && line != "<!-- end of keys -->";) {
    std::smatch cells;
    if (!std::regex_match(line, cells, row)) continue;
    if (cells[1] == "plunge" || cells[1] == "motion") continue;  // the scene at hand has neither
    if (cells[1] == "probe") continue;  // of tables in a list: tests/app/loop/probes.cpp
    if (cells[1] == "sph" || cells[1] == "neighbors") continue;  // of a method unknown here
    const std::string name = cells[2], usual = cells[3], key = cells[1].str() + "." + name;
    CAPTURE(key, usual);
    const std::string without = std::regex_replace(text, std::regex("\n" + name + " = [^\n]*"), "");
    if (usual == "needed" || (usual == "chosen" && key != "output.frames")) {
      CHECK_THAT(refused(without), Contains("needs the key") && Contains(name));
      ++required;
    } else if (cells[1] == "tracers" && usual != "none") {  // of a table in a list
      const std::string line = "tracers=[{line=[0, 0, 1, 1]";
      CHECK(parse(text, {line + ", " + name + "=" + usual + "}]"}) == parse(text, {line + "}]"}));
      ++given;
    } else if (usual != "none" && usual != "chosen") {
      CHECK(parse(without, {key + "=" + usual}) == parse(without));
      ++given;
    }
  }
  CHECK(given >= 20);
  CHECK(required >= 5);
}
