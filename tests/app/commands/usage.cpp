#include <unistd.h>

#include <catch2/catch.hpp>

#include "app/program.hpp"
#include "io/quote.hpp"

using namespace vortree::test;

namespace {

void write_wake(const TemporaryFolder& folder) {
  write_particles(folder / "wake.h5", {{"x", {0, 1, 2}}, {"y", {0, 0, 1}}, {"gamma", {1, 2, -1}}});
}

// Root may write everywhere but below a file, so for root the locked folder is one.
void lock(const TemporaryFolder& folder) {
  if (geteuid() == 0) {
    folder.write("locked", "");
  } else {
    fs::create_directory(folder / "locked");
    fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  }
}

// What every complaint has in common: one line, in the program's name, nothing on standard output.
void check_complaint(const Outcome& outcome, const std::string& about) {
  CAPTURE(outcome.out, outcome.err, about);
  CHECK(outcome.code == 2);
  CHECK(outcome.error_lines() == 1);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.starts_with("vortree: "));
  CHECK(outcome.err.find(about) != std::string::npos);
}

}  // namespace

TEST_CASE("wrong usage is answered with one line and exit code 2") {
  const TemporaryFolder folder;
  write_wake(folder);
  fs::create_directory(folder / "empty");
  fs::create_symlink("loop", folder / "loop");
  struct Row {
    std::string arguments, about;
  };
  const auto row = GENERATE(values<Row>({
      {"", "--help"},
      {"swim", "swim"},
      {"velocity", "IN"},
      {"velocity wake.h5", "--out"},
      {"velocity wake.h5 --out o.h5 --fast", "--fast"},
      {"velocity wake.h5 --out o.h5 --method magic", "magic"},
      {"velocity wake.h5 --out o.h5 --method fast", "boxes"},
      {"velocity wake.h5 --out o.h5 --method grid", "bare"},
      {"velocity wake.h5 --out o.h5 --builder sideways", "sideways"},
      {"velocity wake.h5 --out o.h5 --tolerance tight", "tight"},
      {"velocity wake.h5 --out o.h5 --tolerance -1e-6", "tolerance"},
      {"velocity wake.h5 --out o.h5 --tolerance nan", "tolerance"},
      {"velocity wake.h5 --out o.h5 --tolerance 1e-400", "1e-400"},
      {"velocity wake.h5 --out o.h5 --order -3", "order"},
      {"velocity wake.h5 --out o.h5 --order 1e9", "1e9 is no whole number"},
      {"velocity wake.h5 --out o.h5 --capacity -3", "capacity"},
      {"velocity wake.h5 --out o.h5 --level 99", "level"},
      {"velocity wake.h5 --out o.h5 --threads 0", "--threads"},
      {"velocity wake.h5 --out o.h5 --threads 1e99", "from 1 to 4096"},
      {"velocity wake.h5 --out o.h5 --repeat 0", "--repeat"},
      {"run", "SCENE"},
      {"run nowhere", "nowhere"},
      {"check", "SCENE"},
      {"check --keys lamb_oseen", "--keys"},
      {"check nowhere.toml", "nowhere.toml"},
      {"check .", "folder"},
      {"bench", "WHAT"},
      {"bench forests", "velocity"},
      {"bench velocity --fast", "--fast"},
      {"bench velocity --threads 0", "--threads"},
      {"bench velocity --largest 1", "--largest"},
      {"bench velocity --out wake.h5", "wake.h5"},
      {"bench velocity --out wake.h5/below", "wake.h5"},
      {"bench velocity --out /proc", "/proc"},
      {"plot nowhere", "nowhere"},
      {"plot empty", "empty: nothing to draw"},
      {"plot loop", "loop: no such folder"},
      {"cases please", "please"},
  }));
  const auto outcome = call(row.arguments, folder);
  CAPTURE(row.arguments);
  check_complaint(outcome, row.about);
  CHECK_FALSE(fs::exists(folder / "o.h5"));
}

TEST_CASE("a particle file that is wrong is named with what is wrong in it") {
  const TemporaryFolder folder;
  write_wake(folder);
  folder.write("text.h5", "not hdf5\n");
  folder.write("empty.h5", "");
  fs::create_directory(folder / "folder.h5");
  const Vector two{1, 2}, three{1, 2, 3};
  write_particles(folder / "no_x.h5", {{"y", two}, {"gamma", two}});
  write_particles(folder / "no_gamma.h5", {{"x", two}, {"y", two}});
  write_particles(folder / "lengths.h5", {{"x", two}, {"y", three}, {"gamma", two}});
  write_particles(folder / "nan.h5",
                  {{"x", {0, 1, 2, 3, NAN}}, {"y", {0, 1, 2, 3, 4}}, {"gamma", {1, 1, 1, 1, 1}}});
  write_particles(folder / "inf.h5", {{"x", two}, {"y", two}, {"gamma", {1, INFINITY}}});
  write_particles(folder / "core.h5",
                  {{"x", two}, {"y", two}, {"gamma", two}, {"sigma", {0.1, -0.1}}});
  lock(folder);
  struct Row {
    std::string arguments, about;
  };
  const auto row = GENERATE(values<Row>({
      {"missing.h5 --out o.h5", "missing.h5"},
      {"folder.h5 --out o.h5", "folder.h5"},
      {"text.h5 --out o.h5", "text.h5"},
      {"empty.h5 --out o.h5", "empty.h5"},
      {"no_x.h5 --out o.h5", "x"},
      {"no_gamma.h5 --out o.h5", "gamma"},
      {"lengths.h5 --out o.h5", "3"},
      {"nan.h5 --out o.h5", "4"},
      {"inf.h5 --out o.h5", "gamma"},
      {"core.h5 --out o.h5", "sigma"},
      {"wake.h5 --out o.h5 --targets missing.h5", "missing.h5"},
      {"wake.h5 --out o.h5 --targets nan.h5", "nan.h5"},
      {"wake.h5 --out nowhere/o.h5", "nowhere"},
      {"wake.h5 --out folder.h5", "folder.h5"},
      {"wake.h5 --out wake.h5/o.h5", "wake.h5"},
      {"wake.h5 --out /proc/o.h5", "/proc"},
      {"wake.h5 --out locked/o.h5", "locked"},
  }));
  const auto outcome = call("velocity " + row.arguments, folder);
  CAPTURE(row.arguments);
  check_complaint(outcome, row.about);
  CHECK_FALSE(fs::exists(folder / "o.h5"));
}

TEST_CASE("help and version go to standard output with exit code 0") {
  const TemporaryFolder folder;
  const auto version = call("--version", folder);
  CHECK(version.code == 0);
  CHECK(version.out.starts_with("vortree 0."));
  for (const std::string command : {"", "run", "check", "cases", "velocity", "bench", "plot"}) {
    const auto help = call(command + " --help", folder);
    CAPTURE(command);
    CHECK(help.code == 0);
    CHECK(help.err.empty());
    CHECK(help.out.find(command.empty() ? "velocity" : "vortree " + command) != std::string::npos);
  }
}

TEST_CASE("a complaint is short and shows what it must not do to a terminal") {
  const TemporaryFolder folder;
  write_wake(folder);
  fs::create_symlink("circle", folder / "circle");
  const std::string escape = "$(printf '\\033[31m\\302\\233\\377')";
  const std::string lengthy = "$(head -c 5000 /dev/zero | tr '\\0' k)";
  const std::string arguments = GENERATE_COPY(
      as<std::string>{}, "WORD", "run WORD", "check WORD", "check WORD.toml", "plot WORD",
      "bench WORD", "check circle", "check lamb_oseen WORD", "check lamb_oseen WORD=1",
      "check lamb_oseen a.WORD=1", "check lamb_oseen velocity.method=WORD",
      "check lamb_oseen velocity.method=\\'WORD\\'", "velocity WORD --out o.h5",
      "velocity wake.h5 --out WORD/o.h5", "velocity wake.h5 --out o.h5 --method WORD",
      "velocity wake.h5 --out o.h5 --tolerance WORD", "velocity wake.h5 --out o.h5 --WORD",
      "neighbors wake.h5 --out o.h5 --rule WORD");
  for (const std::string& word : {escape, lengthy}) {
    std::string line = arguments;
    if (const auto at = line.find("WORD"); at != std::string::npos) line.replace(at, 4, word);
    const auto outcome = call(line, folder);
    CAPTURE(line, outcome.err);
    check_complaint(outcome, "");
    CHECK(outcome.err.size() < 350);
    CHECK(vortree::io::printable(outcome.err) ==
          outcome.err.substr(0, outcome.err.size() - 1) + " ");
  }
}

TEST_CASE("a key that is given twice is refused, as an option is, and words are not numbers") {
  const TemporaryFolder folder;
  folder.write("a.toml", "");
  for (const char* line : {"check a.toml time.dt=1 time.dt=2", "run a.toml seed=1 'seed =2'"}) {
    const auto outcome = call(line, folder);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("a key is given once") != std::string::npos);
  }
  for (const char* option :
       {"velocity a.h5 --out b.h5 --builder 1", "neighbors a.h5 --out b.h5 --rule 1"})
    CHECK(call(option, folder).err.find(": 1 not in {") != std::string::npos);
}
