#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

const fs::path root = VORTREE_SOURCE_DIR;

constexpr std::size_t most_names = 12;

/// The names of sources in each folder below tree, fmm and src, without their suffixes.
std::map<std::string, std::set<std::string>> rooms() {
  std::map<std::string, std::set<std::string>> all;
  for (const char* part : {"tree", "fmm", "src"})
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      const fs::path file = entry.path().lexically_relative(root);
      if (file.extension() == ".hpp" || file.extension() == ".cpp")
        all[file.parent_path().generic_string()].insert(file.stem().string());
    }
  return all;
}

std::string text_of(const fs::path& page) {
  std::ifstream file(page);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("a room has at most twelve names") {
  const auto all = rooms();
  CHECK(all.size() > 30);
  for (const auto& [room, names] : all) {
    CAPTURE(room);
    CHECK(names.size() <= most_names);
  }
}

TEST_CASE("each room has a sentence on the page of its part, and each sentence its room") {
  for (const std::string part : {"tree", "fmm", "src"}) {
    const std::string page = text_of(root / part / "README.md");
    std::set<std::string> told, there;
    for (std::size_t at = page.find("\n| `"); at != std::string::npos;
         at = page.find("\n| `", at + 1)) {
      const std::size_t begin = at + 4, end = page.find("/` | ", begin);
      if (end < page.find('\n', begin)) told.insert(part + "/" + page.substr(begin, end - begin));
    }
    for (const auto& [room, names] : rooms())
      if (room.starts_with(part + "/")) there.insert(room);
    CAPTURE(part);
    CHECK(told == there);
  }
}

TEST_CASE("a line of a source has at most a hundred characters") {
  constexpr std::size_t widest = 100;
  for (const auto& [room, names] : rooms())
    for (const auto& entry : fs::directory_iterator(root / room)) {
      const std::string suffix = entry.path().extension().string(), file = entry.path().string();
      if (suffix != ".hpp" && suffix != ".cpp") continue;
      std::ifstream lines(file);
      int number = 1;
      for (std::string line; std::getline(lines, line); ++number) {
        if (line.size() <= widest) continue;
        CAPTURE(file, number, line);
        CHECK(line.size() <= widest);
      }
    }
}

TEST_CASE("an enumeration is defined once: neither its name nor its values stand anywhere else") {
  const std::regex definition(R"(enum class (\w+)\s*(?::[^{]*)?\{([^}]*)\})"), blanks(R"(\s+)");
  std::map<std::string, std::string> names, values;  // where each was found first
  for (const char* part : {"tree", "fmm", "src"})
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      const std::string suffix = entry.path().extension().string();
      if (suffix != ".hpp" && suffix != ".cpp") continue;
      const std::string text = text_of(entry.path()), file = entry.path().string();
      for (std::sregex_iterator one(text.begin(), text.end(), definition), end; one != end; ++one) {
        const std::string list = std::regex_replace((*one)[2].str(), blanks, "");
        CAPTURE(file, (*one)[1].str(), list);
        CHECK(names.emplace((*one)[1], file).second);
        CHECK(values.emplace(list, file).second);
      }
    }
  CHECK(names.size() > 12);
}
