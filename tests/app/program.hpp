#pragma once

#include <poll.h>
#include <stdlib.h>
#include <sys/inotify.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
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

/// A line of shell that runs another in a folder, where it keeps what that prints.
inline std::string kept(const std::string& line, const TemporaryFolder& in) {
  return "cd '" + in.path().string() + "' && { " + line + "\n} >.out 2>.err </dev/null";
}

inline Outcome outcome(int status, const TemporaryFolder& in) {
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(in / ".out"),
          text_of(in / ".err")};
}

/// Runs a line of shell in a folder.
inline Outcome shell(const std::string& line, const TemporaryFolder& in) {
  return outcome(std::system(kept(line, in).c_str()), in);
}

/// Runs `vortree ARGUMENTS` in a folder.
inline Outcome call(const std::string& arguments, const TemporaryFolder& in) {
  return shell("'" VORTREE_PROGRAM "' " + arguments, in);
}

/// Waits until a file has more than so many lines, or a process has ended.
inline void wait_for_lines(const fs::path& file, long lines, pid_t process) {
  fs::create_directories(file.parent_path());
  const int changes = inotify_init1(IN_CLOEXEC);
  inotify_add_watch(changes, file.parent_path().c_str(), IN_MODIFY | IN_MOVED_TO);
  const int end = static_cast<int>(syscall(SYS_pidfd_open, process, 0));
  if (changes < 0 || end < 0) throw std::runtime_error("the system tells of no changes");
  pollfd either[]{{changes, POLLIN, 0}, {end, POLLIN, 0}};
  char told[4096];
  while (std::ranges::count(text_of(file), '\n') <= lines)
    if (poll(either, 2, -1) < 0 || either[1].revents || read(changes, told, sizeof told) < 0) break;
  close(changes);
  close(end);
}

/// Runs `vortree ARGUMENTS` in a folder, with a Ctrl-C once a table has more than so many lines.
inline Outcome interrupted(const std::string& arguments, const TemporaryFolder& in,
                           const std::string& table, long lines) {
  const std::string line = kept("exec '" VORTREE_PROGRAM "' " + arguments, in);
  const pid_t process = fork();
  if (process == 0) {
    execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
    _exit(127);
  }
  wait_for_lines(in / table, lines, process);
  kill(process, SIGINT);
  int status = 0;
  waitpid(process, &status, 0);
  return outcome(status, in);
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

/// A folder with a scene whose runs have no figures.
class SceneFolder : public TemporaryFolder {
 public:
  SceneFolder(const std::string& name, const std::string& scene) { write(name, scene); }

 private:
  NoFigures quick_{*this};
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
