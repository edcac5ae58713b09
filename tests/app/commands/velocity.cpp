#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "app/program.hpp"

using namespace vortree::test;

namespace {

Vector random_values(std::size_t n, unsigned seed, double from, double to) {
  std::mt19937_64 generator(seed);
  Vector values(n);
  for (double& value : values) value = std::uniform_real_distribution(from, to)(generator);
  return values;
}

void write_cloud(const fs::path& file, std::size_t n, bool cored) {
  std::vector<std::pair<std::string, Vector>> columns{{"x", random_values(n, 1, 0, 1)},
                                                      {"y", random_values(n, 2, 0, 1)},
                                                      {"gamma", random_values(n, 3, -1, 1)}};
  if (cored) columns.push_back({"sigma", Vector(n, 0.01)});
  write_particles(file, columns);
}

struct Velocities {
  Vector u, v;
};

Velocities read_velocities(const TemporaryFolder& folder, const std::string& file) {
  const auto lines = shell(
      "/usr/bin/python3 -c \"import h5py; f = h5py.File('" + file +
          "'); [print(float(a).hex(), float(b).hex()) for a, b in zip(f['u'][:], f['v'][:])]\"",
      folder);
  REQUIRE(lines.err == "");
  Velocities velocities;
  std::istringstream words(lines.out);
  for (std::string u, v; words >> u >> v;) {
    velocities.u.push_back(std::strtod(u.c_str(), nullptr));
    velocities.v.push_back(std::strtod(v.c_str(), nullptr));
  }
  return velocities;
}

double relative_l2(const Velocities& found, const Velocities& expected) {
  REQUIRE(found.u.size() == expected.u.size());
  double difference = 0, length = 0;
  for (std::size_t i = 0; i < found.u.size(); ++i) {
    difference += std::pow(found.u[i] - expected.u[i], 2) + std::pow(found.v[i] - expected.v[i], 2);
    length += std::pow(expected.u[i], 2) + std::pow(expected.v[i], 2);
  }
  return std::sqrt(difference / length);
}

// Asks python, which knows JSON better than we do.
std::string json(const TemporaryFolder& folder, const std::string& line,
                 const std::string& expression) {
  folder.write("line.json", line);
  const auto answer =
      shell("/usr/bin/python3 -c \"import json; d = json.load(open('line.json')); print(" +
                expression + ")\"",
            folder);
  REQUIRE(answer.err == "");
  return answer.out.substr(0, answer.out.find('\n'));
}

}  // namespace

TEST_CASE("so few terms that the tolerance cannot be kept are warned of") {
  const TemporaryFolder folder;
  write_cloud(folder / "in.h5", 300, false);
  const auto few = call("velocity in.h5 --out uv.h5 --order 1", folder);
  CHECK(few.code == 0);
  CHECK(few.err.starts_with("vortree: warning: --order 1: so few terms err by some 0.05"));
  CHECK(call("velocity in.h5 --out uv.h5 --order 16", folder).err.empty());
  CHECK(call("velocity in.h5 --out uv.h5 --order 1 --method direct", folder).err.empty());
}

TEST_CASE("what cannot be summed is refused with the file it stands in, sources or targets") {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, double x, double sigma) {
    write_particles(folder / name,
                    {{"x", {x, 0}}, {"y", {0, 1}}, {"gamma", {1, 1}}, {"sigma", {sigma, sigma}}});
  };
  write("good.h5", 1, 0.1);
  write("far.h5", 1e308, 0.1);
  write("wide.h5", 1, 1e300);
  const auto said = [&](const std::string& files) {
    const auto outcome = call("velocity " + files + " --out uv.h5", folder);
    CHECK(outcome.code == 2);
    return outcome.err;
  };
  CHECK(said("far.h5").starts_with("vortree: far.h5: x[0] is 1e+308"));
  CHECK(said("wide.h5").starts_with("vortree: wide.h5: sigma[0] is 1e+300"));
  CHECK(said("good.h5 --targets far.h5").starts_with("vortree: far.h5: "));
}

TEST_CASE("boxes and the direct sum agree within the tolerance, for bare and for cored vortices") {
  const TemporaryFolder folder;
  const bool cored = GENERATE(false, true);
  write_cloud(folder / "in.h5", 3000, cored);
  REQUIRE(call("velocity in.h5 --out direct.h5 --method direct", folder).code == 0);
  REQUIRE(call("velocity in.h5 --out boxes.h5 --tolerance 1e-8", folder).code == 0);
  const auto direct = read_velocities(folder, "direct.h5");
  const auto boxes = read_velocities(folder, "boxes.h5");
  REQUIRE(direct.u.size() == 3000);
  CHECK(relative_l2(boxes, direct) <= 1e-8);
}

TEST_CASE("the grid sums blobs as the direct sum does, and refuses bare vortices") {
  const TemporaryFolder folder;
  write_cloud(folder / "blobs.h5", 2000, true);
  write_cloud(folder / "bare.h5", 10, false);
  REQUIRE(call("velocity blobs.h5 --out direct.h5 --method direct", folder).code == 0);
  const auto outcome =
      call("velocity blobs.h5 --out grid.h5 --tolerance 1e-8 --method grid", folder);
  REQUIRE(outcome.code == 0);
  CHECK(json(folder, outcome.out, "d['method'], d['seconds']['transform'] > 0") == "grid True");
  CHECK(relative_l2(read_velocities(folder, "grid.h5"), read_velocities(folder, "direct.h5")) <=
        1e-8);
  const auto refused = call("velocity bare.h5 --out o.h5 --method grid", folder);
  CHECK(refused.code == 2);
  CHECK(refused.error_lines() == 1);
  CHECK(refused.err.find("bare") != std::string::npos);
}

TEST_CASE("other targets get the velocities of the sources") {
  const TemporaryFolder folder;
  constexpr double pi = 3.14159265358979323846;
  write_particles(folder / "in.h5", {{"x", {1}}, {"y", {0}}, {"gamma", {2 * pi}}});
  write_particles(folder / "at.h5", {{"x", {0, 3}}, {"y", {0, 0}}});
  for (const std::string method : {"boxes", "direct"}) {
    const auto outcome =
        call("velocity in.h5 --out o.h5 --targets at.h5 --verify --method " + method, folder);
    REQUIRE(outcome.code == 0);
    const auto at = read_velocities(folder, "o.h5");
    REQUIRE(at.u.size() == 2);
    CHECK(at.v[0] == Approx(-1));
    CHECK(at.v[1] == Approx(0.5));
    CHECK(at.u[0] == Approx(0).margin(1e-15));
    CHECK(json(folder, outcome.out, "d['n'], d['error']['targets'], d['error']['max'] < 1e-14") ==
          "1 2 True");
  }
}

TEST_CASE("a check that misses its tolerance ends with 1 and one line, the JSON is there") {
  const TemporaryFolder folder;
  write_cloud(folder / "in.h5", 2000, false);
  const auto missed = call("velocity in.h5 --out o.h5 --order 3 --tolerance 1e-9 --verify", folder);
  CHECK(missed.code == 1);
  CHECK(missed.error_lines() == 1);
  CHECK(missed.err.find("the tolerance was missed") != std::string::npos);
  CHECK(json(folder, missed.out, "d['order'], d['error']['relative_l2'] > 1e-9") == "3 True");
  const auto kept = call("velocity in.h5 --out o.h5 --order 60 --tolerance 1e-9 --verify", folder);
  CHECK(kept.code == 0);
  CHECK(json(folder, kept.out, "d['error']['condition'] > 1") == "True");
}

TEST_CASE("the check is right whatever the units, and where sums cancel") {
  const TemporaryFolder folder;
  const Vector x = random_values(300, 1, 0, 1), y = random_values(300, 2, 0, 1);
  for (const double unit : {1e-200, 1e120, 1e200}) {
    Vector scaled_x = x, scaled_y = y, gamma(300), sigma(300);
    for (std::size_t i = 0; i < 300; ++i) {
      scaled_x[i] *= unit, scaled_y[i] *= unit, sigma[i] = unit / 50;
      if (i % 2 == 1) scaled_x[i] = scaled_x[i - 1] + 1e-6 * unit, scaled_y[i] = scaled_y[i - 1];
      gamma[i] = (i % 2 == 0 ? 1 : -1) * unit;
    }
    write_particles(folder / "in.h5",
                    {{"x", scaled_x}, {"y", scaled_y}, {"gamma", gamma}, {"sigma", sigma}});
    for (const std::string method : {"fmm", "boxes", "direct"}) {
      const auto outcome = call("velocity in.h5 --out o.h5 --verify --method " + method, folder);
      CHECK(outcome.code == 0);
      CHECK(json(folder, outcome.out, "0 < d['error']['relative_l2'] < 1e-6") == "True");
    }
  }
}

TEST_CASE("one line of JSON says what was done") {
  const TemporaryFolder folder;
  write_cloud(folder / "in.h5", 2000, true);
  const auto outcome = call(
      "velocity in.h5 --out o.h5 --tolerance 1e-5 --builder forward --threads 2 --verify --repeat "
      "3",
      folder);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(std::ranges::count(outcome.out, '\n') == 1);
  const auto ask = [&](const std::string& expression) {
    return json(folder, outcome.out, expression);
  };
  CHECK(outcome.out.starts_with(
      R"({"n":2000,"method":"fmm","builder":"forward","threads":2,"tolerance":1e-05,"order":)"));
  CHECK(ask("*d") == "n method builder threads tolerance order pairs peak_bytes seconds error");
  CHECK(ask("d['n'], d['method'], d['builder'], d['threads'], d['tolerance']") ==
        "2000 fmm forward 2 1e-05");
  CHECK(ask("d['order'] > 0, d['pairs'] > 0, d['peak_bytes'] > 1e6") == "True True True");
  CHECK(ask("*list(d['seconds'])[:4], *list(d['seconds'])[-2:]") ==
        "tree upward far near total io");
  CHECK(ask("all(s > 0 for s in d['seconds'].values() if s is not None)") == "True");
  CHECK(ask("0 < d['error']['relative_l2'] <= 1e-5, d['error']['targets']") == "True 1000");
  CHECK(ask("0 < d['error']['p99'] <= d['error']['max'] < 1e-4") == "True");
}

TEST_CASE("what a method does not have is null") {
  const TemporaryFolder folder;
  write_cloud(folder / "in.h5", 20, true);
  const auto outcome = call("velocity in.h5 --out uv.h5 --method direct", folder);
  CHECK(
      json(folder, outcome.out, "d['builder'], d['tolerance'], d['order'], d['seconds']['far']") ==
      "None None None None");
}

TEST_CASE("the direct sum counts every pair and is right to round-off") {
  const TemporaryFolder folder;
  write_cloud(folder / "in.h5", 500, true);
  const auto outcome = call("velocity in.h5 --out o.h5 --method direct --verify", folder);
  REQUIRE(outcome.code == 0);
  CHECK(json(folder, outcome.out, "d['pairs'], d['error']['relative_l2'] < 1e-13, d['builder']") ==
        std::to_string(500 * 499) + " True None");
}

TEST_CASE("no vortices make no velocities, and no fuss") {
  const TemporaryFolder folder;
  write_particles(folder / "in.h5", {{"x", {}}, {"y", {}}, {"gamma", {}}});
  for (const std::string method : {"boxes", "direct"}) {
    const auto outcome = call("velocity in.h5 --out o.h5 --verify --method " + method, folder);
    CAPTURE(outcome.err);
    CHECK(outcome.code == 0);
    CHECK(json(folder, outcome.out, "d['n'], d['error']['relative_l2'] == 0") == "0 True");
    CHECK(read_velocities(folder, "o.h5").u.empty());
  }
}
