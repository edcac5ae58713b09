#include "app/plot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "app/places.hpp"
#include "io/input_error.hpp"

extern char** environ;

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

// By name, not the first in PATH: that one may lack matplotlib.
constexpr const char* python = "/usr/bin/python3";

std::string read_all(int descriptor) {
  std::string text;
  std::array<char, 4096> piece;
  for (ssize_t n; (n = read(descriptor, piece.data(), piece.size())) > 0;)
    text.append(piece.data(), n);
  return text;
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

// Exit code of the script, and what it wrote on standard error.
struct Outcome {
  int status;
  std::string errors;
};

Outcome run_script(const fs::path& script, const fs::path& folder) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error(fmt::format("pipe: {}", std::strerror(errno)));
  std::string words[] = {python, script.string(), folder.string()};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  pid_t child = 0;
  const int refused = posix_spawn(&child, python, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (refused) {
    close(ends[0]);
    throw std::runtime_error(fmt::format("{}: {}", python, std::strerror(refused)));
  }
  Outcome outcome{0, read_all(ends[0])};
  close(ends[0]);
  waitpid(child, &outcome.status, 0);
  return outcome;
}

}  // namespace

void plot(const fs::path& folder, std::string_view kind) {
  if (!fs::is_directory(folder))
    throw io::InputError(fmt::format("{}: no such folder", folder.string()));
  setenv("MPLBACKEND", "Agg", 1);
  setenv("PYTHONDONTWRITEBYTECODE", "1", 1);
  for (const auto& script : plot_scripts()) {
    if (!script.filename().string().starts_with(kind)) continue;
    const auto [status, errors] = run_script(script, folder);
    if (status != 0)
      throw std::runtime_error(fmt::format("{}: {}", script.string(), last_line(errors)));
  }
}

}  // namespace vortree::app
