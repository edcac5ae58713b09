#include "app/cli.hpp"

#include <fmt/format.h>

#include <CLI/Error.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "app/commands/check.hpp"
#include "app/commands/lyapunov.hpp"
#include "app/commands/movie.hpp"
#include "app/commands/plot.hpp"
#include "app/commands/sweep/gather.hpp"
#include "app/commands/sweep/sweep.hpp"
#include "app/commands/view.hpp"
#include "app/grammar.hpp"
#include "app/install_paths.hpp"
#include "app/loop/threads.hpp"
#include "app/say.hpp"
#include "base/free_memory.hpp"
#include "base/memory.hpp"
#include "io/input_error.hpp"
#include "io/quote.hpp"

namespace vortree::app {
namespace {

constexpr int done = 0, failed = 1, wrong_input = 2;

int complain(std::string message, int code) {
  while (!message.empty() && message.back() == '\n') message.pop_back();
  say_line(message);
  return code;
}

/// As an option that is given twice.
void refuse_repeated(std::span<const std::string> overrides) {
  std::map<std::string, std::string> seen;
  for (const std::string& word : overrides) {
    std::string key = word.substr(0, word.find('='));
    key.erase(key.find_last_not_of(' ') + 1);
    if (const auto [at, fresh] = seen.emplace(key, word); !fresh)
      throw io::InputError(fmt::format("command line: {} and {}: a key is given once", at->second,
                                       io::shortened(word, 60)));
  }
}

int run_scene(RunOptions options, int threads, const std::string& only) {
  refuse_repeated(options.overrides);
  options.threads = threads;
  if (options.out.empty())
    options.out = std::filesystem::path("runs") / find_scene(options.scene).stem();
  try {
    const SweepPlan plan = sweep_plan(options.overrides);
    if (plan.empty() && !only.empty())
      throw io::InputError("command line: --only is for a list of runs, as accuracy=0.04,0.02");
    const auto share = only.empty() ? std::nullopt : std::optional(share_in(only));
    if (!plan.empty()) return sweep(options, plan, share);
    return run(options).passed() ? done : failed;
  } catch (const std::invalid_argument& broken) {
    // What a library refuses in the middle of a run is not the user's input.
    return complain(broken.what(), failed);
  }
}

// Where standard output is the result, it must have arrived.
int arrived() {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return done;
  return complain(fmt::format("standard output cannot be written: {}", std::strerror(errno)),
                  failed);
}

int print_velocity(const VelocityJob& job) {
  const VelocityReport report = velocity(job);
  tell("{}\n", report.line);
  return report.missed ? complain(*report.missed, failed) : arrived();
}

// Results in files.
int run_bench(const std::string& what, const BenchJob& job) {
  if (!job.blobs.empty() && what != "trees")
    throw io::InputError("command line: --blobs is for bench trees alone");
  if (!job.runs.empty() && what != "step")
    throw io::InputError("command line: --run is for bench step alone");
  if (what == "trees") bench_trees(job);
  if (what == "velocity") bench_velocity(job);
  if (what == "neighbors") bench_neighbors(job);
  if (what == "step") bench_step(job);
  return done;
}

int print_scene(const Words& words) {
  refuse_repeated(words.overrides);
  tell("{}", words.keys ? keys() : check(words.scene, words.overrides));
  return arrived();
}

int carry_out(const CLI::App& program, const Words& words) {
  take_threads(words.threads);
  if (program.got_subcommand("run")) return run_scene(words.run, words.threads, words.only);
  if (program.got_subcommand("sweep")) return gather(words.folder, words.run.figures_as);
  if (program.got_subcommand("check")) return print_scene(words);
  if (program.got_subcommand("velocity")) return print_velocity(words.velocity);
  if (program.got_subcommand("bench")) return run_bench(words.benched, words.bench);
  if (program.got_subcommand("cases")) tell("{}", list_cases());
  if (program.got_subcommand("neighbors")) tell("{}\n", neighbors(words.neighbors));
  if (program.got_subcommand("lyapunov")) tell("{}", lyapunov(words.lyapunov));
  if (program.got_subcommand("movie")) tell("{}\n", movie(words.movie));
  if (program.got_subcommand("view")) tell("{}\n", view(words.view));
  if (program.got_subcommand("plot")) plot_folder(words.folder, words.run.figures_as);
  return arrived();
}

/// What the memory was wanted for, and how much of it there was.
std::string out_of_memory(const CLI::App& program, const Words& words) {
  const auto doing = [&]() -> std::string {
    if (program.got_subcommand("velocity"))
      return "the velocities of " + words.velocity.in.string();
    if (program.got_subcommand("neighbors"))
      return "the neighbors of " + words.neighbors.in.string();
    if (program.got_subcommand("lyapunov"))
      return "the tracers of " + words.lyapunov.folder.string();
    if (program.got_subcommand("run")) return "the run of " + words.run.scene;
    return program.got_subcommand("bench") ? "the bench of " + words.benched : "this command";
  }();
  return fmt::format("out of memory: {} took {:.2g} GB and needs more; {:.2g} GB are free", doing,
                     1e-9 * static_cast<double>(peak_bytes()),
                     1e-9 * static_cast<double>(free_memory()));
}

/// The words that were said, as a shell would take them again.
std::string joined(std::span<const char* const> words) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  std::string line = "vortree";
  for (const std::string_view word : words) {
    line += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == word.npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

/// throws  CLI::ParseError: what is wrong, or that only help or the version was asked for
void read(CLI::App& program, int argc, const char* const* argv) {
  program.parse(argc, argv);
  if (program.get_subcommands().empty())
    throw CLI::RequiredError("no command given", CLI::ExitCodes::RequiredError);
}

// The command line of the command that was being read, for the hint behind a usage error.
std::string help_of(const CLI::App& program) {
  const auto commands = program.get_subcommands();
  return commands.empty() ? "vortree --help"
                          : "vortree " + commands.front()->get_name() + " --help";
}

}  // namespace

std::optional<std::string> objection(int argc, const char* const* argv) {
  Words words;
  const std::unique_ptr<CLI::App> program = grammar(words);
  try {
    read(*program, argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return std::nullopt;
    return fmt::format("{}; see {}", error.what(), help_of(*program));
  }
}

int command_line(int argc, char** argv) {
  Words words;
  const std::unique_ptr<CLI::App> program = grammar(words);
  try {
    read(*program, argc, argv);
    words.velocity.said = words.neighbors.said =
        joined(std::span<const char* const>(argv, argc).subspan(1));
    return carry_out(*program, words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program->exit(error);
    return complain(fmt::format("{}; see {}", error.what(), help_of(*program)), wrong_input);
  } catch (const io::InputError& error) {
    return complain(error.what(), wrong_input);
  } catch (const std::invalid_argument& error) {
    return complain(error.what(), wrong_input);
  } catch (const std::bad_alloc&) {
    return complain(out_of_memory(*program, words), failed);
  } catch (const std::length_error&) {
    return complain(out_of_memory(*program, words), failed);
  } catch (const std::filesystem::filesystem_error& error) {
    // A link that leads to itself is the user's; whatever else fails here is the machine.
    const bool loops = error.code() == std::errc::too_many_symbolic_link_levels;
    return complain(fmt::format("{}: {}", error.path1().string(), error.code().message()),
                    loops ? wrong_input : failed);
  } catch (const std::exception& error) {
    return complain(error.what(), failed);
  }
}

}  // namespace vortree::app
