#include "app/grammar.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "app/commands/sums/quantities.hpp"
#include "app/commands/sweep/share.hpp"
#include "app/install_paths.hpp"
#include "app/plot.hpp"
#include "io/quote.hpp"

namespace vortree::app {
namespace {

/// The number that all of a word says, if a T can hold it.
template <class T>
std::optional<T> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// Holds a word to what it must be before it is read as a T.
template <class T, class Holds>
CLI::Validator must_be(const std::string& wanted, Holds holds) {
  return {[=](const std::string& word) {
            const std::optional<T> value = number_in<T>(word);
            if (value && holds(*value)) return std::string();
            return fmt::format("{} is no {}", io::shortened(word, 40), wanted);
          },
          ""};
}

/// A whole number, ends included.
template <class T>
CLI::Validator within(T low, T high) {
  return must_be<T>(fmt::format("whole number from {} to {}", low, high),
                    [=](T value) { return low <= value && value <= high; });
}

/// A whole number, whose range the library knows.
CLI::Validator whole() {
  return must_be<int>("whole number of up to nine digits", [](int) { return true; });
}

constexpr int most_threads = 4096, most_repeats = 1000000;

/// An empty one is what a script leaves of a variable that it has not set: not the default.
const CLI::Validator a_name(
    [](const std::string& word) { return word.empty() ? "the name is empty" : std::string(); }, "");

CLI::Validator not_negative() {
  return must_be<double>("finite number >= 0",
                         [](double value) { return value >= 0 && std::isfinite(value); });
}

const CLI::Validator a_share(
    [](const std::string& word) {
      try {
        (void)share_in(word);
        return std::string();
      } catch (const std::invalid_argument& refused) {
        return std::string(refused.what());
      }
    },
    "");

/// L or LX,LY; 0: not periodic that way.
std::optional<tree::PeriodicBox> box_in(std::string_view word) {
  const auto comma = word.find(',');
  const auto x = number_in<double>(word.substr(0, comma));
  const auto y = comma == word.npos ? x : number_in<double>(word.substr(comma + 1));
  const auto fit = [](double length) { return length >= 0 && std::isfinite(length); };
  if (!x || !y || !fit(*x) || !fit(*y)) return std::nullopt;
  return tree::PeriodicBox{*x, *y};
}

const CLI::Validator a_box(
    [](const std::string& word) {
      if (box_in(word)) return std::string();
      return fmt::format("{} is no length L or LX,LY of finite numbers >= 0",
                         io::shortened(word, 40));
    },
    "");

const CLI::Validator a_list_of_quantities(
    [](const std::string& word) {
      try {
        (void)quantities_in(word);
        return std::string();
      } catch (const std::invalid_argument& refused) {
        return std::string(refused.what());
      }
    },
    "");

/// What files of particles can be, for the end of a help.
std::string formats_of(std::string_view columns) {
  return fmt::format(
      "files: FILE.h5 (HDF5 datasets of these names), FILE.npz (arrays of these names),\n"
      "FILE.csv (a line of names, then rows; # notes), FILE.npy (n rows of {}, or the first\n"
      "of these; or records with these names), FILE::12, FILE::last, DIR::last (a frame of a\n"
      "run, counted from 0). In .h5 and .npz positions may be points, n x 2\n",
      columns);
}

/// One of these words, and nothing else, becomes its value.
template <class Value>
CLI::Validator one_of(const std::map<std::string, Value>& known) {
  std::string words;
  for (const auto& [word, value] : known) words += (words.empty() ? "" : ",") + word;
  return {[=](std::string& word) {
            const auto found = known.find(word);
            if (found == known.end())
              return fmt::format("{} not in {{{}}}", io::shortened(word, 40), words);
            word = fmt::format("{}", static_cast<int>(found->second));
            return std::string();
          },
          ":{" + words + "}"};
}

void add_threads(CLI::App& command, Words& words) {
  command.add_option("--threads", words.threads, "threads; all by default")
      ->check(within(1, most_threads))
      ->type_name("N");
}

void add_formats(CLI::App& command, Words& words) {
  command
      .add_option("--as", words.run.figures_as,
                  "figures as png, pdf or svg, or a list of these; png by default")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(figure_formats()))
      ->type_name("LIST");
}

CLI::Option* add_scene(CLI::App& command, std::string& scene, std::vector<std::string>& overrides) {
  auto* wanted =
      command.add_option("SCENE", scene, "a TOML file, or the name of a case")->required();
  command.add_option("key=value", overrides, "instead of what the scene says: table.key=value")
      ->check([](const std::string& word) {
        return word.find('=') == std::string::npos
                   ? "expected table.key=value, not " + io::shortened(word, 60)
                   : std::string();
      })
      ->type_name("");
  return wanted;
}

void add_run(CLI::App& program, Words& words) {
  auto& command = *program.add_subcommand("run", "run a scene");
  add_scene(command, words.run.scene, words.run.overrides);
  command.add_option("--out", words.run.out, "folder for the results; by default runs/SCENE")
      ->check(a_name)
      ->type_name("DIR");
  auto* resume =
      command.add_flag("--resume", words.run.resume, "go on from the last frame in that folder");
  command.add_flag("--overwrite", words.run.overwrite, "replace the run that is in that folder")
      ->excludes(resume);
  command
      .add_option("--only", words.only,
                  "of a list, as task K of N, each run N-th from the K-th on; K alone: that run. "
                  "Tasks share the folder; vortree sweep makes their table")
      ->check(a_share)
      ->type_name("K/N");
  add_formats(command, words);
  add_threads(command, words);
  command.footer(
      "example: vortree run cylinder_re550 time.end=1 --out runs/short\n"
      "a list runs one after the other: vortree run lamb_oseen cores.sigma_max=0.06,0.05\n"
      "and so do methods: vortree run cylinder method=vortex,sph flow.reynolds=20,40,100");
}

void add_sweep(CLI::App& program, Words& words) {
  auto& command = *program.add_subcommand(
      "sweep", "make the table and figures of a list of runs of what is there of it");
  command.add_option("DIR", words.folder, "folder of the list of runs")->required()->check(a_name);
  add_formats(command, words);
  command.footer(
      "example: vortree run cylinder accuracy=0.04,0.02,0.01 --out runs/c --only 2/3\n"
      "with 1/3 and 3/3 elsewhere, in any order or at once, then: vortree sweep runs/c");
}

void add_check(CLI::App& program, Words& words) {
  auto& command =
      *program.add_subcommand("check", "read a scene, print it with every default written out");
  auto* scene = add_scene(command, words.scene, words.overrides);
  command
      .add_flag_callback(
          "--keys",
          [&words, scene] {
            words.keys = true;
            scene->required(false);
          },
          "print what keys a scene may have instead: default, unit, limits, what each is")
      ->excludes(scene);
}

/// What a plan otherwise chooses by its tolerance.
void add_tree(CLI::App& command, fmm::Options& options) {
  command.add_option("--order", options.order, "terms of an expansion; 0: as the tolerance needs")
      ->check(whole())
      ->type_name("P")
      ->capture_default_str();
  command
      .add_option("--capacity", options.capacity, "most vortices in a childless cell; 0: chosen")
      ->check(within<std::uint32_t>(0, std::numeric_limits<std::uint32_t>::max()))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--level", options.finest_level, "finest level of the tree")
      ->check(whole())
      ->type_name("L")
      ->capture_default_str();
}

void add_velocity(CLI::App& program, Words& words) {
  using fmm::Builder;
  static const std::map<std::string, Builder> builders{{"reverse", Builder::reverse},
                                                       {"forward", Builder::forward}};
  auto& job = words.velocity;
  auto& command =
      *program.add_subcommand("velocity", "velocities of the vortices of a particle file");
  command
      .add_option("IN", job.in,
                  "file with x, y, gamma and, unless they are bare vortices, sigma (formats below)")
      ->required();
  command.add_option("--out", job.out, "file for u, v: .h5, .npz or .csv")
      ->required()
      ->check(a_name)
      ->type_name("FILE");
  command
      .add_option("--what", job.what,
                  "a list of velocity (u, v), gradient (ux, uy, vx), stream_function (psi), "
                  "vorticity (omega)")
      ->check(a_list_of_quantities)
      ->type_name("LIST")
      ->capture_default_str();
  command.add_option("--sigma", job.sigma, "core of all vortices, instead of what the file says")
      ->check(not_negative())
      ->type_name("REAL");
  command.add_option("--tolerance", job.options.tolerance, "relative L2 error that may be made")
      ->check(must_be<double>("number between 0 and 1", [](double t) { return t > 0 && t < 1; }))
      ->type_name("REAL")
      ->capture_default_str();
  command.add_option("--method", job.method, "how to sum")
      ->check(CLI::IsMember(velocity_methods()))
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--builder", job.options.builder, "how to build the tree")
      ->transform(one_of(builders))
      ->type_name("NAME")
      ->default_str("reverse");
  command
      .add_option("--targets", job.targets, "file with x, y: velocities there, not at the vortices")
      ->check(a_name)
      ->type_name("FILE");
  add_tree(command, job.options);
  command.add_flag("--verify", job.verify,
                   "compare with a direct sum in long double at 1000 random targets");
  command.add_option("--repeat", job.repeat, "sum so many times, report median times")
      ->check(within(1, most_repeats))
      ->type_name("K")
      ->capture_default_str();
  add_threads(command, words);
  command.footer(formats_of("x, y, gamma, sigma") +
                 "example: vortree velocity wake.h5 --out uv.h5 --tolerance 1e-9 --verify\n"
                 "vortree velocity runs/wake::last --what velocity,vorticity --out uv.csv");
}

void add_neighbors(CLI::App& program, Words& words) {
  using tree::PairRule;
  static const std::map<std::string, PairRule> rules{
      {"max", PairRule::max}, {"mean", PairRule::mean}, {"own", PairRule::own}};
  auto& job = words.neighbors;
  auto& command =
      *program.add_subcommand("neighbors", "neighbors of the particles of a particle file");
  command.add_option("IN", job.in, "file with x, y, reach (formats below)")->required();
  command
      .add_option("--out", job.out,
                  ".h5 or .npz for start (n + 1), index: the neighbors of particle i are "
                  "index[start[i]], ..., index[start[i + 1] - 1]; .csv for lines i,j")
      ->required()
      ->check(a_name)
      ->type_name("FILE");
  command
      .add_option("--rule", job.rule,
                  "neighbors are nearer than the larger reach, the mean, the particle's own")
      ->transform(one_of(rules))
      ->type_name("NAME")
      ->default_str("max");
  command.add_option("--reach", job.reach, "of all particles, instead of what the file says")
      ->check(not_negative())
      ->type_name("REAL");
  command.add_option("--method", job.method, "how to search")
      ->check(CLI::IsMember(neighbor_methods()))
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--periodic", [&job](const std::string& word) { job.box = box_in(word).value(); },
          "in a box [0, LX) x [0, LY) that goes around, by nearest images; one length is that of "
          "both, of 0 the box does not go around that way")
      ->check(a_box)
      ->type_name("LX,LY");
  command.add_flag("--half", job.half, "list each pair once");
  command.add_option("--repeat", job.repeat, "search so many times, report median times")
      ->check(within(1, most_repeats))
      ->type_name("K")
      ->capture_default_str();
  add_threads(command, words);
  command.footer(formats_of("x, y, reach") +
                 "example: vortree neighbors sph.h5 --out rows.h5 --rule mean --half\n"
                 "vortree neighbors runs/sph::last --reach 0.1 --out rows.npz");
}

void add_lyapunov(CLI::App& program, Words& words) {
  auto& job = words.lyapunov;
  auto& command = *program.add_subcommand(
      "lyapunov", "how fast fluid is drawn apart (FTLE), by the pictures of a run");
  const auto a_time =
      must_be<double>("time >= 0", [](double t) { return t >= 0 && std::isfinite(t); });
  command.add_option("DIR", job.folder, "folder of a run with pictures")->required()->check(a_name);
  command.add_option("--from", job.from, "times at which tracers begin, on a grid")
      ->required()
      ->check(a_time)
      ->type_name("T");
  command.add_option("--to", job.to, "where each of them ends; earlier: backward in time")
      ->required()
      ->check(a_time)
      ->type_name("T");
  command.add_option("--spacing", job.spacing, "of the grid; by default that of the pictures")
      ->check(must_be<double>("number > 0", [](double h) { return h > 0 && std::isfinite(h); }))
      ->type_name("H");
  add_threads(command, words);
  command.footer(
      "example: vortree lyapunov runs/wake --from 3 3.2 --to 2 2.2\n"
      "forward ridges repel, backward ones attract; both of one time come into one figure:\n"
      "vortree lyapunov runs/wake --from 3 3 --to 2 4");
}

void add_movie(CLI::App& program, Words& words) {
  auto& job = words.movie;
  auto& command = *program.add_subcommand("movie", "make a video of the pictures of a run");
  command.add_option("DIR", job.folder, "folder of a run with pictures")->required()->check(a_name);
  command
      .add_option("--what", job.what,
                  "what is shown in colours; blobs: those, or particles, of each frame")
      ->check(CLI::IsMember({"vorticity", "speed", "pressure", "blobs"}))
      ->type_name("NAME")
      ->capture_default_str();
  command.add_flag("--streamlines", job.streamlines, "draw lines of equal stream function, too");
  command.add_option("--fps", job.fps, "pictures in a second of the video")
      ->check(within(1, 240))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--size", job.size, "height in pixels")
      ->check(within(240, 4320))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option(
          "--out", job.out,
          "the video, by default DIR/movie.mp4; beside it comes a small one that moves on a "
          "page, .webp, of five seconds")
      ->check(a_name)
      ->type_name("FILE");
  command.footer(
      "example: vortree run cylinder_re550_quick output.fields_every=0.02 --out runs/wake\n"
      "         vortree movie runs/wake");
}

void add_view(CLI::App& program, Words& words) {
  auto& job = words.view;
  auto& command = *program.add_subcommand("view", "make a page to look at a run in a browser");
  command.add_option("DIR", job.folder, "folder of a run")->required()->check(a_name);
  command.add_option("--out", job.out, "the page, a single file; by default DIR/view.html")
      ->check(a_name)
      ->type_name("FILE");
  command.add_flag("--overwrite", job.overwrite, "replace a file that --out names");
  auto& live = *command.add_flag(
      "--live", job.live, "no file: serve the page on 127.0.0.1, while the run goes on, to Ctrl-C");
  command.add_option("--port", job.port, "where to serve it; by default one that is free")
      ->check(within(1, 65535))
      ->type_name("N")
      ->needs(&live);
  live.excludes("--out")->excludes("--overwrite");
  command.footer(
      "example: vortree run cylinder_re550_quick --out runs/wake && vortree view runs/wake\n"
      "the page needs no network: open runs/wake/view.html; its key ? lists the keys");
}

void add_bench(CLI::App& program, Words& words) {
  auto& command = *program.add_subcommand(
      "bench",
      "measure every way to a tree, to velocities, to neighbors, or through a step of a flow; "
      "writes CSV files and figures");
  command.add_option("WHAT", words.benched, "what to measure")
      ->required()
      ->check(CLI::IsMember({"trees", "velocity", "neighbors", "step"}));
  command
      .add_option("--out", words.bench.out, "folder for the results; by default runs/bench_WHAT")
      ->check(a_name)
      ->type_name("DIR");
  command.add_flag("--overwrite", words.bench.overwrite, "replace the tables in that folder");
  command.add_flag("--quick", words.bench.quick,
                   "smaller sets: two minutes, not half an hour (step: half a minute, not two)");
  command
      .add_option("--threads", words.bench.threads, "measured beside one thread; all by default")
      ->check(within(1, most_threads))
      ->type_name("N");
  command
      .add_option(
          "--largest", words.bench.largest,
          "most points of a set; by default 4000000 (trees 10000000), quick 1000000 (step: a "
          "flow is followed until it has so many blobs)")
      ->check(within<std::size_t>(100, 100000000))
      ->type_name("N");
  command
      .add_option("--blobs", words.bench.blobs,
                  "trees: the frames.h5 of a run, of which some moments are measured, too")
      ->check(a_name)
      ->type_name("FILE");
  command
      .add_option("--run", words.bench.runs,
                  "step: the folder of a run by vortices, whose last frame is measured instead of "
                  "the scenes that come with the program; any number of them")
      ->check(a_name)
      ->type_name("DIR");
  command.footer("example: vortree bench velocity --quick --out quick");
}

void add_plot(CLI::App& program, Words& words) {
  auto& command =
      *program.add_subcommand("plot", "draw the figures of a run or a bench into its folder");
  command.add_option("DIR", words.folder, "folder of a run or a bench")->required();
  add_formats(command, words);
  command.footer("example: vortree plot runs/cylinder --as pdf,png");
}

}  // namespace

std::unique_ptr<CLI::App> grammar(Words& words) {
  auto made = std::make_unique<CLI::App>("Vortex and particle methods on one quadtree.", "vortree");
  CLI::App& program = *made;
  program.set_version_flag("--version", "vortree " + version());
  program.require_subcommand(0, 1);
  program.add_subcommand("cases", "list the scenes that come with the program");
  add_run(program, words);
  add_sweep(program, words);
  add_check(program, words);
  add_velocity(program, words);
  add_neighbors(program, words);
  add_lyapunov(program, words);
  add_movie(program, words);
  add_view(program, words);
  add_bench(program, words);
  add_plot(program, words);
  return made;
}

}  // namespace vortree::app
