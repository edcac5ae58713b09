#include "app/plot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/install_paths.hpp"
#include "io/input_error.hpp"

extern char** environ;

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

// By name, not the first in PATH: that one may lack matplotlib.
constexpr const char* python = "/usr/bin/python3";

std::string read_all(int descriptor, const Heard& heard) {
  std::string text;
  std::array<char, 4096> piece;
  std::size_t told = 0;
  for (ssize_t n; (n = read(descriptor, piece.data(), piece.size())) > 0;) {
    text.append(piece.data(), n);
    for (std::size_t end; heard && (end = text.find('\n', told)) != std::string::npos;
         told = end + 1)
      heard(std::string_view(text).substr(told, end - told));
  }
  return text;
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

constexpr int refused_input = 2;

// Runs the scripts one after another as if each were called alone: python SCRIPT FOLDER FORMATS.
// Python and matplotlib take longer to begin than most figures to draw. Who prints no name has
// drawn nothing.
constexpr int nothing_drawn = 3;
constexpr const char* runner = R"(
import contextlib, io, os, runpy, sys, traceback
folder, formats, *scripts = sys.argv[1:]
drawn = False
for script in scripts:
    sys.argv = [script, folder, *formats.split()]
    sys.path[0] = os.path.dirname(script)
    told = io.StringIO()
    try:
        with contextlib.redirect_stdout(told):
            runpy.run_path(script, run_name="__main__")
    except SystemExit as end:
        if end.code == 2:
            raise
        if end.code:
            sys.exit(f"{script}: {end.code}")
    except Exception as error:
        traceback.print_exc()
        sys.exit(f"{script}: {type(error).__name__}: {error}")
    drawn = drawn or told.getvalue() != ""
    try:
        print(told.getvalue(), end="", flush=True)
    except OSError:  # nobody listens
        sys.stdout = open(os.devnull, "w")
sys.exit(0 if drawn else 3)
)";

// How the scripts ended, as waitpid() tells it, and what they wrote on standard error.
struct Outcome {
  int status;
  std::string errors;
};

void set_surroundings() {
  setenv("MPLBACKEND", "Agg", 1);
  setenv("PYTHONDONTWRITEBYTECODE", "1", 1);
}

/// Python's own first.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  words.insert(words.begin(), python);
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

[[noreturn]] void throw_unstarted(int error) {
  throw std::runtime_error(fmt::format("{}: {}", python, std::strerror(error)));
}

Outcome run_python(std::vector<std::string> words, const Heard& heard = {}) {
  set_surroundings();
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error(fmt::format("pipe: {}", std::strerror(errno)));
  const std::vector<char*> arguments = pointers_to(words);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  pid_t child = 0;
  const int refused = posix_spawn(&child, python, &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (refused) {
    close(ends[0]);
    throw_unstarted(refused);
  }
  Outcome outcome{0, read_all(ends[0], heard)};
  close(ends[0]);
  waitpid(child, &outcome.status, 0);
  return outcome;
}

void throw_failed(int status, const std::string& errors) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == refused_input)
    throw io::InputError(last_line(errors));
  if (status != 0) throw std::runtime_error(last_line(errors));
}

}  // namespace

const std::vector<std::string>& figure_formats() {
  static const std::vector<std::string> known{"png", "pdf", "svg"};
  return known;
}

bool plot(const fs::path& folder, std::string_view kind, std::span<const std::string> formats) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw io::InputError(fmt::format("{}: no such folder", folder.string()));
  const std::vector<fs::path> scripts = plot_scripts(kind);
  if (scripts.empty()) return false;
  std::vector<std::string> words{"-c", runner, folder.string(),
                                 fmt::format("{}", fmt::join(formats, " "))};
  for (const fs::path& script : scripts) words.push_back(script.string());
  const auto [status, errors] = run_python(std::move(words));
  if (WIFEXITED(status) && WEXITSTATUS(status) == nothing_drawn) return false;
  throw_failed(status, errors);
  return true;
}

std::string run_script(const fs::path& script, std::vector<std::string> words, const Heard& heard) {
  words.insert(words.begin(), script.string());
  const auto [status, errors] = run_python(std::move(words), heard);
  throw_failed(status, errors);
  return last_line(errors);
}

void become_script(const fs::path& script, std::vector<std::string> words) {
  set_surroundings();
  words.insert(words.begin(), script.string());
  execv(python, pointers_to(words).data());
  throw_unstarted(errno);
}

}  // namespace vortree::app
