#include "boundaries/includes.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace vortree::test {

namespace {

namespace fs = std::filesystem;

// What a part may see beside the standard library: other parts, or single headers of theirs.
// Libraries are named by how their headers begin.
struct Permit {
  std::set<std::string> parts;
  std::vector<std::string> libraries;
};

const std::string anything = "*";

const std::map<std::string, Permit>& permits() {
  static const std::map<std::string, Permit> permits{
      // Large pages can only be asked of the operating system.
      {"tree/base", {{"tree/base"}, {"sys/mman.h"}}},
      {"tree", {{"tree", "tree/base"}, {}}},
      {"fmm", {{"fmm", "tree", "tree/base"}, {}}},
      {"base", {{"base", "tree/base"}, {"sys/", "unistd.h"}}},
      {"provenance", {{"provenance"}, {"sys/", "unistd.h"}}},
      {"body", {{"body", "base", "tree/base"}, {}}},
      {"exact", {{"exact"}, {}}},
      {"flow", {{"flow", "body", "base", "tree", "tree/base"}, {"fmt/"}}},
      {"vortex",
       {{"vortex", "flow", "body", "base", "fmm", "tree/base", "tree"}, {"Eigen/", "fmt/"}}},
      {"neighbors", {{"neighbors", "base", "tree", "tree/base"}, {"boost/"}}},
      {"sph",
       {{"sph", "neighbors", "flow", "body", "base", "fmm", "tree/base", "tree"},
        {"Eigen/", "fmt/"}}},
      {"io", {{"io", "flow", "body", "base", "tree/base"}, {anything}}},
      {"checks", {{"checks", "flow", "body", "io", "exact", "base"}, {"fmt/", "fftw3.h"}}},
      {"bench",
       {{"bench", "neighbors", "sph", "flow", "fmm", "base", "provenance", "tree", "tree/base"},
        {anything}}},
      {"app/loop",
       {{"app", "app/loop", "app/folder", "app/methods", "checks", "flow", "io", "base",
         "provenance"},
        {anything}}},
      {"app/folder", {{"app", "app/folder", "checks", "flow", "io", "base"}, {anything}}},
      {"app/methods", {{"app", "app/methods", "flow", "io", "vortex", "sph", "base"}, {anything}}},
      {"app/commands",
       {{"app", "app/commands", "app/loop", "app/folder", "app/methods", "bench", "checks", "flow",
         "io", "neighbors", "fmm", "tree", "base", "provenance",
         "vortex/choice/warnings_of_means.hpp"},
        {anything}}},
      {"app", {{"app", "app/commands", "app/loop", "io", "fmm", "tree", "base"}, {anything}}},
      {"python", {{"python", "fmm", "tree", "tree/base", "base/free_memory.hpp"}, {"pybind11/", "unistd.h"}}},
      {"python/simulation",
       {{"python", "python/simulation", "app/methods", "io", "flow", "base", "tree"},
        {"pybind11/"}}},
      {"tests", {{anything}, {anything}}},
      {"cases", {{anything}, {anything}}}};
  return permits;
}

// FFTW is under the GPL: nothing that gets installed as a library may see it.
bool may_see_fftw(const std::string& part) {
  return part == "bench" || part == "checks" || part == "tests" || part == "cases";
}

// Headers of the standard have neither folder nor suffix; OpenMP and vector intrinsics come with
// the compiler.
bool comes_with_compiler(const std::string& name) {
  return name.find_first_of("/.") == std::string::npos || name == "omp.h" || name == "immintrin.h";
}

// The part of the house that an include leads to; empty if it leads to a library.
std::string destination(const Include& include) {
  std::string name = include.name;
  if (name.starts_with("vortree/")) {
    name.erase(0, std::string_view("vortree/").size());
  }
  const bool here = include.quoted && name.find('/') == std::string::npos;
  if (here || name.starts_with(".")) {
    return part_of(
        (fs::path(include.file).parent_path() / name).lexically_normal().generic_string());
  }
  return part_of(name);
}

std::string why_not(const std::string& part, const Include& include) {
  const auto permit = permits().find(part);
  if (permit == permits().end()) {
    return "nobody has said yet what this folder may include";
  }
  const std::string to = destination(include);
  if (!to.empty()) {
    const auto& parts = permit->second.parts;
    const bool allowed =
        parts.contains(anything) || parts.contains(to) || parts.contains(include.name);
    return allowed ? "" : part + " must not depend on " + to;
  }
  if (include.name.starts_with("fftw") && !may_see_fftw(part)) {
    return "FFTW must stay out of what gets installed";
  }
  const auto& libraries = permit->second.libraries;
  const bool allowed =
      std::any_of(libraries.begin(), libraries.end(), [&](const std::string& library) {
        return library == anything || include.name.starts_with(library);
      });
  return allowed || comes_with_compiler(include.name) ? "" : part + " must not use this library";
}

bool is_source(const fs::path& path) {
  static const std::set<std::string> suffixes{".hpp", ".cpp", ".h",   ".c",
                                              ".hh",  ".cc",  ".cxx", ".inl"};
  return suffixes.contains(path.extension().string());
}

bool is_foreign_folder(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with(".") || name.starts_with("build") || name == "runs";
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) {
    throw std::runtime_error("cannot read " + path.string());
  }
  return text.str();
}

}  // namespace

std::string part_of(std::string_view file) {
  if (file.starts_with("src/")) file.remove_prefix(std::string_view("src/").size());
  std::string longest;
  for (const auto& [part, permit] : permits())
    if (file.starts_with(part + "/") && part.size() > longest.size()) longest = part;
  return longest;
}

std::vector<Include> includes_in(const std::string& file, std::string_view text) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
  std::vector<Include> includes;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_match(line, match, pattern)) {
      includes.push_back({file, number, match[2], match[1] == "\""});
    }
  }
  return includes;
}

std::string objection(const Include& include) {
  const std::string why = why_not(part_of(include.file), include);
  return why.empty() ? ""
                     : include.file + ":" + std::to_string(include.line) + ": includes " +
                           include.name + ": " + why;
}

std::vector<std::string> objections_below(const fs::path& root, int& files_read) {
  std::vector<std::string> objections;
  files_read = 0;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::end(entry); ++entry) {
    if (entry->is_directory() && is_foreign_folder(entry->path())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file() && is_source(entry->path())) {
      ++files_read;
      const std::string file = entry->path().lexically_relative(root).generic_string();
      for (const Include& include : includes_in(file, text_of(entry->path()))) {
        const std::string said = objection(include);
        if (!said.empty()) objections.push_back(said);
      }
    }
  }
  std::sort(objections.begin(), objections.end());
  return objections;
}

}  // namespace vortree::test
