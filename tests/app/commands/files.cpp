#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>

#include "app/install_paths.hpp"
#include "app/program.hpp"
#include "io/arrays/frame_file.hpp"
#include "io/arrays/hdf5_file.hpp"
#include "io/arrays/made.hpp"
#include "io/arrays/npz_file.hpp"
#include "io/frames/frames.hpp"
#include "io/tables/table.hpp"

using namespace vortree;
using namespace vortree::test;

// `vortree velocity` and `vortree neighbors` on files of every kind that they read and write.

namespace {

using Columns = std::vector<std::pair<std::string, Vector>>;

constexpr std::size_t n = 700;

Vector random_values(unsigned seed, double from, double to) {
  std::mt19937_64 generator(seed);
  Vector values(n);
  for (double& value : values) value = std::uniform_real_distribution(from, to)(generator);
  return values;
}

const Columns& cloud() {
  static const Columns columns{{"x", random_values(1, 0, 1)},
                               {"y", random_values(2, 0, 1)},
                               {"gamma", random_values(3, -1, 1)},
                               {"sigma", random_values(4, 0.01, 0.03)}};
  return columns;
}

/// x, y and one more as `reach`.
Columns reaches() {
  Columns columns{cloud()[0], cloud()[1], cloud()[3]};
  columns[2].first = "reach";
  return columns;
}

Vector rows_of(const Columns& columns) {
  Vector rows;
  for (std::size_t i = 0; i < n; ++i)
    for (const auto& [name, values] : columns) rows.push_back(values[i]);
  return rows;
}

/// Seventeen digits, which every double reads back from.
std::string csv_of(const Columns& columns) {
  std::string text = "# made by a test\nnote";
  for (const auto& [name, values] : columns) text += "," + name;
  char digits[40];
  for (std::size_t i = 0; i < n; ++i) {
    text += "\nany";
    for (const auto& [name, values] : columns) {
      std::snprintf(digits, sizeof digits, ",%.17g", values[i]);
      text += digits;
    }
  }
  return text + "\n";
}

std::string records_of(const Columns& columns) {
  std::string descr = "[", data;
  for (const auto& [name, values] : columns) descr += "('" + name + "', '>f8'), ";
  for (const double value : rows_of(columns)) data += bytes_in(value, true);
  return npy(descr + "]", "(" + std::to_string(n) + ",)", data);
}

std::string rows_npy(const Columns& columns) {
  return npy("'<f8'", "(" + std::to_string(n) + ", " + std::to_string(columns.size()) + ")",
             bytes_in(rows_of(columns)));
}

std::string columns_npy(const Columns& columns) {
  std::string data;
  for (const auto& [name, values] : columns) data += bytes_in(values);
  return npy("'<f8'", "(" + std::to_string(n) + ", " + std::to_string(columns.size()) + ")", data,
             true);
}

std::string npz_of(const Columns& columns, bool deflated) {
  std::vector<MadeMember> members;
  for (const auto& [name, values] : columns) {
    const std::string bytes = npy(values);
    members.push_back({name + ".npy", bytes});
    if (deflated) members.back().method = 8, members.back().packed = in_plain_blocks(bytes);
  }
  return zip(members);
}

std::string npz_of_points(const Columns& columns) {
  std::vector<MadeMember> members{{"points.npy", rows_npy({columns[0], columns[1]})}};
  for (std::size_t k = 2; k < columns.size(); ++k)
    members.push_back({columns[k].first + ".npy", npy(columns[k].second)});
  return zip(members);
}

void write_frame(const TemporaryFolder& folder, const Columns& columns) {
  io::create_frames(folder / "run", {});
  for (const std::int64_t step : {0, 5}) {
    flow::Columns kept;
    for (const auto& [name, values] : columns) kept.push_back({name, "", values});
    if (step == 0) kept.front().values.assign(n, 0.5);  // another flow
    io::append_frame(folder / "run", {.step = step, .time = 0.1, .columns = kept});
  }
}

/// The same numbers in files of every kind; what to call them.
std::vector<std::string> write_every_kind(const TemporaryFolder& folder, const Columns& columns) {
  write_particles(folder / "in.h5", columns);
  folder.write("in.csv", csv_of(columns));
  folder.write("rows.npy", rows_npy(columns));
  folder.write("columns.npy", columns_npy(columns));
  folder.write("records.npy", records_of(columns));
  folder.write("stored.npz", npz_of(columns, false));
#ifdef VORTREE_ZLIB
  folder.write("packed.npz", npz_of(columns, true));
#else
  folder.write("packed.npz", npz_of(columns, false));
#endif
  folder.write("points.npz", npz_of_points(columns));
  write_frame(folder, columns);
  return {"in.h5",      "in.csv",     "rows.npy",   "columns.npy", "records.npy",
          "stored.npz", "packed.npz", "points.npz", "run::last",   "run/frames.h5::1"};
}

/// Equal numbers make equal files of .npz.
std::string bytes_made(const std::string& arguments, const TemporaryFolder& folder) {
  const Outcome outcome = call(arguments + " --out out.npz", folder);
  CAPTURE(arguments, outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  return text_of(folder / "out.npz");
}

std::string attribute(const TemporaryFolder& folder, const std::string& name) {
  const auto answer = shell("/usr/bin/python3 -c \"import h5py; a = h5py.File('o.h5').attrs['" +
                                name + "']; print(a.decode() if hasattr(a, 'decode') else a)\"",
                            folder);
  REQUIRE(answer.err == "");
  return answer.out.substr(0, answer.out.find('\n'));
}

Vector of_npz(const fs::path& file, const std::string& name) {
  return io::open_npz(file)->read(name, 0);
}

void check_refused(const Outcome& outcome, const std::string& about) {
  CAPTURE(outcome.err, about);
  CHECK(outcome.code == 2);
  CHECK(outcome.error_lines() == 1);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find(about) != std::string::npos);
}

}  // namespace

TEST_CASE("velocities are the same bits from files of every kind") {
  const TemporaryFolder folder;
  const auto files = write_every_kind(folder, cloud());
  const std::string expected = bytes_made("velocity " + files[0], folder);
  for (const std::string& file : files) {
    CAPTURE(file);
    CHECK((bytes_made("velocity " + file, folder) == expected));
  }
  CHECK((bytes_made("velocity run::0", folder) != expected));
}

TEST_CASE("targets, too, come from files of every kind") {
  const TemporaryFolder folder;
  const auto files = write_every_kind(folder, {cloud()[0], cloud()[1]});
  write_particles(folder / "sources.h5", cloud());
  const std::string expected = bytes_made("velocity sources.h5 --targets in.h5", folder);
  for (const std::string& file : files) {
    CAPTURE(file);
    CHECK((bytes_made("velocity sources.h5 --targets " + file, folder) == expected));
  }
}

TEST_CASE("neighbors are the same from files of every kind") {
  const TemporaryFolder folder;
  const auto files = write_every_kind(folder, reaches());
  const std::string expected = bytes_made("neighbors " + files[0] + " --threads 1", folder);
  CHECK(of_npz(folder / "out.npz", "index").size() > n);
  for (const std::string& file : files) {
    CAPTURE(file);
    CHECK((bytes_made("neighbors " + file + " --threads 1", folder) == expected));
  }
}

TEST_CASE("results are the same numbers in files of every kind") {
  const TemporaryFolder folder;
  write_particles(folder / "in.h5", cloud());
  for (const char* out : {"o.h5", "o.npz", "o.csv"})
    REQUIRE(call("velocity in.h5 --out " + std::string(out), folder).code == 0);
  const io::Table table(folder / "o.csv");
  CHECK(table.names() == std::vector<std::string>{"u", "v"});
  for (const std::string name : {"u", "v"}) {
    const Vector values = io::open_hdf5(folder / "o.h5")->read(name, 0);
    REQUIRE(values.size() == n);
    CHECK(of_npz(folder / "o.npz", name) == values);
    CHECK(table.column(name) == values);
  }
}

TEST_CASE("neighbors in a .csv are the entries of the rows, a line each") {
  const TemporaryFolder folder;
  write_particles(folder / "in.h5", reaches());
  const std::string half = GENERATE("", " --half");
  const std::string line = "neighbors in.h5 --threads 1" + half + " --out ";
  for (const char* out : {"o.npz", "o.csv"}) REQUIRE(call(line + out, folder).code == 0);
  const Vector start = of_npz(folder / "o.npz", "start"), index = of_npz(folder / "o.npz", "index");
  const io::Table table(folder / "o.csv");
  CHECK(table.column("j") == index);
  Vector owner;
  for (std::size_t i = 0; i < n; ++i)
    owner.insert(owner.end(), static_cast<std::size_t>(start[i + 1] - start[i]), i);
  CHECK(table.column("i") == owner);
}

TEST_CASE("gradient, stream function and vorticity are written under their names") {
  const TemporaryFolder folder;
  write_particles(folder / "in.h5", cloud());
  const std::string all = "velocity in.h5 --what vorticity,stream_function,gradient,velocity";
  const Outcome made = call(all + " --tolerance 1e-10 --out o.npz", folder);
  REQUIRE(made.code == 0);
  CHECK(made.out.find("\"gradient\":") != std::string::npos);
  REQUIRE(
      call("velocity in.h5 --what gradient,stream_function,velocity --method direct --out d.npz",
           folder)
          .code == 0);
  for (const std::string name : {"u", "v", "ux", "uy", "vx", "psi"}) {
    const Vector found = of_npz(folder / "o.npz", name), direct = of_npz(folder / "d.npz", name);
    REQUIRE(found.size() == n);
    double apart = 0, length = 0;
    for (std::size_t i = 0; i < n; ++i)
      apart += std::pow(found[i] - direct[i], 2), length += direct[i] * direct[i];
    CAPTURE(name);
    CHECK(std::sqrt(apart / length) < 1e-9);  // of the gradient all parts together keep 1e-10
  }
  const Vector vx = of_npz(folder / "o.npz", "vx"), uy = of_npz(folder / "o.npz", "uy"),
               omega = of_npz(folder / "o.npz", "omega");
  const double peak = 1 / (M_PI * 0.01 * 0.01);  // of the strongest blob in the narrowest core
  for (std::size_t i = 0; i < n; ++i) CHECK(std::abs(vx[i] - uy[i] - omega[i]) < 1e-8 * peak);
}

TEST_CASE("velocities are the same bits with and without other quantities") {
  const TemporaryFolder folder;
  write_particles(folder / "in.h5", cloud());
  REQUIRE(call("velocity in.h5 --out a.npz", folder).code == 0);
  REQUIRE(call("velocity in.h5 --what velocity,vorticity --out b.npz", folder).code == 0);
  REQUIRE(call("velocity in.h5 --what vorticity --out c.npz", folder).code == 0);
  CHECK(of_npz(folder / "a.npz", "u") == of_npz(folder / "b.npz", "u"));
  CHECK(of_npz(folder / "c.npz", "omega") == of_npz(folder / "b.npz", "omega"));
  CHECK_FALSE(io::open_npz(folder / "c.npz")->has("u"));
}

TEST_CASE("--sigma and --reach are of all, whatever the file says") {
  const TemporaryFolder folder;
  Columns same = cloud(), bare = cloud();
  same[3].second.assign(n, 0.02);
  bare.pop_back();
  write_particles(folder / "same.h5", same);
  write_particles(folder / "other.h5", cloud());
  folder.write("bare.npy", rows_npy(bare));
  const std::string expected = bytes_made("velocity same.h5", folder);
  CHECK((bytes_made("velocity other.h5 --sigma 0.02", folder) == expected));
  CHECK((bytes_made("velocity bare.npy --sigma 0.02", folder) == expected));
  CHECK((bytes_made("velocity bare.npy", folder) != expected));
  const std::string zero = bytes_made("velocity bare.npy --sigma 0", folder);
  CHECK((bytes_made("velocity bare.npy", folder) == zero));
  same.erase(same.begin() + 2);
  same[2].first = "reach";
  write_particles(folder / "reach.h5", same);
  const std::string rows = bytes_made("neighbors reach.h5 --threads 1", folder);
  folder.write("places.npy", rows_npy({same[0], same[1]}));
  CHECK((bytes_made("neighbors places.npy --reach 0.02 --threads 1", folder) == rows));
  CHECK((bytes_made("neighbors other.h5 --reach 0.02 --threads 1", folder) == rows));
}

TEST_CASE("an HDF5 output tells where its numbers come from") {
  const TemporaryFolder folder;
  folder.write("a file.csv", csv_of(cloud()));
  folder.write("at.csv", "x,y\n0.5,0.5\n");
  REQUIRE(call("velocity 'a file.csv' --out o.h5 --tolerance 1e-5 --targets at.csv", folder).code ==
          0);
  CHECK(attribute(folder, "command_line") ==
        "vortree velocity 'a file.csv' --out o.h5 --tolerance 1e-5 --targets at.csv");
  CHECK(attribute(folder, "version") + "\n" == call("--version", folder).out.substr(8));
  CHECK(attribute(folder, "input") == "a file.csv");
  CHECK(attribute(folder, "targets") == "at.csv");
  CHECK(attribute(folder, "particles") == std::to_string(n));
  CHECK(attribute(folder, "tolerance") == "1e-05");
  CHECK(attribute(folder, "method") == "fmm");
  REQUIRE(call("neighbors 'a file.csv' --reach 0.1 --rule mean --half --out o.h5", folder).code ==
          0);
  CHECK(attribute(folder, "rule") == "mean");
  CHECK(attribute(folder, "half") == "1");
  CHECK(attribute(folder, "particles") == std::to_string(n));
}

TEST_CASE("velocities of a frame are those that the run has written into it") {
  const TemporaryFolder folder;
  const std::string scene = (app::share_folder() / "cases/corotating_pair.toml").string();
  const NoFigures none(folder);
  const auto run =
      call("run '" + scene + "' time.end=0.1 velocity.tolerance=1e-9 --out run", folder);
  CAPTURE(run.err);
  REQUIRE(run.code == 0);
  REQUIRE(call("velocity run::0 --tolerance 1e-9 --out o.npz", folder).code == 0);
  const auto frame = io::open_frame({folder / "run/frames.h5", 0});
  double apart = 0, length = 0;
  for (const std::string name : {"u", "v"}) {
    const Vector found = of_npz(folder / "o.npz", name), written = frame->read(name, 0);
    REQUIRE(found.size() == written.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      apart += std::pow(found[i] - written[i], 2), length += written[i] * written[i];
  }
  CHECK(std::sqrt(apart / length) <= 2e-9);  // each of both sums keeps 1e-9
}

TEST_CASE("a wrong file or word is refused with one line, and nothing is written") {
  const TemporaryFolder folder;
  write_every_kind(folder, cloud());
  Columns bare = cloud();
  bare.pop_back();
  folder.write("bare.csv", csv_of(bare));
  folder.write("cut.npy", rows_npy(cloud()).substr(0, 9000));
  folder.write("cut.npz", npz_of(cloud(), false).substr(0, 9000));
  folder.write("text.npy", "x,y\n");
  folder.write("complex.npy", npy("'<c16'", "(1, 2)", std::string(32, '\0')));
  folder.write("nan.csv", "x,y,gamma\n1,2,3\n1,nan,3\n");
  folder.write("words.csv", "x,y,gamma\n1,two,3\n");
  folder.write("no_y.csv", "x,gamma\n1,2\n");
  folder.write("no_x.npz", zip({{"y.npy", npy({1, 2})}, {"gamma.npy", npy({1, 2})}}));
  folder.write("bzip2.npz", zip({{"x.npy", npy({1, 2}), 12, "BZh9"}}));
  folder.write("huge.npy", npy("'<f8'", "(1000000000000, 3)", "none"));
  const std::pair<std::string, std::string> rows[] = {
      {"cut.npy", "cut.npy: it claims shape (700, 4) of 8 bytes each, 22400 bytes; "},
      {"cut.npz", "cut.npz: it is a zip file, but cut short: its end is missing"},
      {"text.npy", "text.npy: it is not an .npy array: other first bytes"},
      {"complex.npy", "complex.npy: the array has dtype \"<c16\", complex numbers; "},
      {"nan.csv", "nan.csv: y[1] (line 3) is nan; finite numbers were expected"},
      {"words.csv", "words.csv:2: y is \"two\"; a number was expected"},
      {"no_y.csv", "no_y.csv: there is no column y; the file has x, gamma"},
      {"no_x.npz", "no_x.npz: there is no array x; the file has y, gamma"},
      {"bzip2.npz", "bzip2.npz: x: it is packed by bzip2 (zip method 12); "},
      {"huge.npy", "huge.npy: it claims shape (1000000000000, 3) of 8 bytes each"},
      {"run::2", "run/frames.h5: it has 2 frames, 0 to 1; there is no frame 2"},
      {"run::first", "run::first: \"first\" names no frame; last or a number"},
      {"run/frames.h5", "run/frames.h5 has 2 frames of a run; which of them?"},
      {"missing.npz", "missing.npz: no such file"},
      {"run", "run is the folder of a run; which of its frames? run::last, or run::0 for the"},
      {"in.h5 --targets rows.npy", "rows.npy: the array has shape (700, 4); n rows of x, y were"},
      {"in.h5 --what speed", "speed not in {velocity,gradient,stream_function,vorticity}"},
      {"in.h5 --what velocity,velocity", "velocity is there twice"},
      {"in.h5 --what velocity,", " not in {velocity,"},
      {"in.h5 --what gradient --verify", "--verify is for velocities"},
      {"in.h5 --what gradient --method grid", "grid sums velocities alone"},
      {"bare.csv --what vorticity", "bare.csv: bare vortices have no vorticity around them; "},
      {"in.h5 --sigma -1", "-1 is no finite number >= 0"},
      {"in.h5 --sigma inf", "inf is no finite number >= 0"}};
  for (const auto& [arguments, about] : rows)
    for (const char* out : {"o.h5", "o.csv"}) {
      check_refused(call("velocity " + arguments + " --out " + out, folder), about);
      CHECK_FALSE(fs::exists(folder / out));
    }
  check_refused(call("velocity in.h5 --out o.npy", folder), "o.npy: an .npy holds one array; ");
  check_refused(call("neighbors in.h5 --out o.h5", folder), "there is no dataset reach; ");
  check_refused(call("neighbors in.h5 --reach nan --out o.h5", folder), "nan is no finite number");
  check_refused(call("neighbors rows.npy --reach 1 --out o.h5", folder),
                "the array has shape (700, 4); n rows of x, y, reach, or the first of these, were");
}

TEST_CASE("no output destroys its input, nor the frames that it was read from") {
  const TemporaryFolder folder;
  write_every_kind(folder, cloud());
  const std::string frames = text_of(folder / "run/frames.h5"), csv = text_of(folder / "in.csv");
  check_refused(call("velocity run::last --out run/frames.h5", folder),
                "run/frames.h5 is the input run/frames.h5; the output would destroy it");
  check_refused(call("velocity in.h5 --targets run::0 --out run/frames.h5", folder), "destroy it");
  check_refused(call("neighbors run::last --reach 1 --out run/frames.h5", folder), "destroy it");
  check_refused(call("velocity in.csv --out in.csv", folder), "destroy it");
  CHECK((text_of(folder / "run/frames.h5") == frames));
  CHECK((text_of(folder / "in.csv") == csv));
}
