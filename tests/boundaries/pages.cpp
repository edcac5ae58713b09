#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = VORTREE_SOURCE_DIR;

// README.md and all pages beside the sources.
std::vector<std::string> pages() {
  std::vector<std::string> all{"README.md"};
  for (const char* part : {"tree", "fmm", "src", "cases", "tests", "plots"})
    for (const auto& entry : fs::recursive_directory_iterator(root / part))
      if (entry.path().extension() == ".md")
        all.push_back(entry.path().lexically_relative(root).generic_string());
  REQUIRE(all.size() > 1);
  return all;
}

std::string text_of(const fs::path& page) {
  std::ifstream file(page);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Without listings.
std::string prose_of(const fs::path& page) {
  return std::regex_replace(text_of(page), std::regex("```[^`]*```"), "");
}

std::vector<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex wanted(pattern);
  std::vector<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), wanted); it != std::sregex_iterator();
       ++it)
    all.push_back((*it)[1]);
  return all;
}

// The anchors of the headings, as GitHub makes them: lower case, no punctuation, spaces as hyphens.
std::set<std::string> anchors_of(const fs::path& page) {
  std::set<std::string> anchors;
  for (const std::string& heading : found(prose_of(page), "\n#+ ([^\n]+)")) {
    std::string anchor;
    for (unsigned char c : heading)
      if (std::isalnum(c) || c == '-' || c == '_')
        anchor += static_cast<char>(std::tolower(c));
      else if (c == ' ')
        anchor += '-';
    anchors.insert(anchor);
  }
  return anchors;
}

// The sections with pictures: what an error costs, and the gallery that follows it.
std::string gallery() {
  const std::string readme = prose_of(root / "README.md");
  const auto begin = readme.find("\n## What an error costs\n");
  REQUIRE(begin != std::string::npos);
  const auto second = readme.find("\n## ", begin + 1);
  REQUIRE(readme.compare(second, 12, "\n## Gallery\n") == 0);
  return readme.substr(begin, readme.find("\n## ", second + 1) - begin);
}

}  // namespace

TEST_CASE("every link of a page leads to a file, and to a heading there") {
  for (const std::string& name : pages()) {
    const fs::path page = root / name;
    for (const std::string& link : found(prose_of(page), R"(\]\(([^)\s]+)\))")) {
      CAPTURE(name, link);
      if (link.starts_with("http")) continue;
      const auto hash = link.find('#');
      const std::string file = link.substr(0, hash);
      const fs::path target = file.empty() ? page : page.parent_path() / file;
      REQUIRE(fs::exists(target));
      if (hash != std::string::npos) CHECK(anchors_of(target).contains(link.substr(hash + 1)));
    }
  }
}

TEST_CASE("every source that a page names is there") {
  int named = 0;
  for (const std::string& name : pages())
    for (const std::string& file :
         found(prose_of(root / name), R"(`([\w]+/[\w/]+\.(?:hpp|cpp|py))`)")) {
      CAPTURE(name, file);
      CHECK((fs::exists(root / file) || fs::exists(root / "src" / file)));
      ++named;
    }
  CHECK(named > 0);
}

TEST_CASE("the gallery names a command for each of its pictures, and holds no others") {
  const auto shown = found(gallery(), R"(\(plots/gallery/([^)]+)\))");
  CHECK(shown.size() == found(gallery(), R"(`\./(vortree [^`]+)`)").size());
  std::set<std::string> there;
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root / "plots" / "gallery"))
    if (entry.path().extension() == ".png") {
      there.insert(entry.path().lexically_relative(root / "plots" / "gallery").generic_string());
      CHECK(entry.file_size() < 150'000);
      bytes += entry.file_size();
    }
  CHECK(there == std::set<std::string>(shown.begin(), shown.end()));
  CHECK(bytes < 1'200'000);
}
