#pragma once

#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/tables/particles.hpp"

namespace vortree::test {

namespace fs = std::filesystem;

/// A folder of its own for one test, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "vortree-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }
  const fs::path& path() const { return path_; }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }

 private:
  fs::path path_;
};

inline std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

struct Outcome {
  int code = -1;  // 128 + signal if it was killed
  std::string out, err;

  long error_lines() const { return std::ranges::count(err, '\n'); }
};

/// Runs a line of shell in a folder.
inline Outcome shell(const std::string& line, const TemporaryFolder& in) {
  const fs::path out = in / ".out", err = in / ".err";
  const std::string command =
      "cd '" + in.path().string() + "' && { " + line + "\n} >.out 2>.err </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(out),
          text_of(err)};
}

/// Runs `vortree ARGUMENTS` in a folder.
inline Outcome call(const std::string& arguments, const TemporaryFolder& in) {
  return shell("'" VORTREE_PROGRAM "' " + arguments, in);
}

/// As long as it lives, a shared folder without figure scripts, so that runs are not kept waiting
/// by their figures.
class NoFigures {
 public:
  explicit NoFigures(const TemporaryFolder& folder) {
    setenv("VORTREE_SHARE", folder.path().c_str(), 1);
  }
  ~NoFigures() { unsetenv("VORTREE_SHARE"); }
  NoFigures(const NoFigures&) = delete;
  NoFigures& operator=(const NoFigures&) = delete;
};

using Vector = std::vector<double>;

inline void write_particles(const fs::path& file,
                            const std::vector<std::pair<std::string, Vector>>& columns) {
  std::vector<io::ParticleColumn> spans;
  for (const auto& [name, values] : columns)
    spans.push_back({name, std::span<const double>(values)});
  io::write_columns(file, spans);
}

}  // namespace vortree::test
