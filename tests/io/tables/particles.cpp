#include "io/tables/particles.hpp"

#include <array>
#include <limits>
#include <numeric>

#include "io/files.hpp"
#include "io/frames/hdf5.hpp"
#include "io/sandbox.hpp"

using namespace vortree::io;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

using Doubles = std::vector<double>;

const Doubles three{1, 2, 3};

/// A file with the good columns x, y, gamma, sigma, reach, but for what `spoil` adds or replaces.
template <class Spoil>
std::filesystem::path file_with(const Sandbox& box, std::string_view without, Spoil&& spoil) {
  h5::Handle file = h5::create_file(box / "p.h5");
  for (const char* name : {"x", "y", "gamma", "sigma", "reach"}) {
    if (name != without) h5::write(file, name, three);
  }
  spoil(file);
  h5::close_file(std::move(file), box / "p.h5");
  return box / "p.h5";
}

constexpr ParticleColumns all{
    .gamma = Need::required, .sigma = Need::optional, .reach = Need::optional};

/// The refusal, without the path before it.
std::string refused(const std::filesystem::path& path, ParticleColumns columns = all) {
  const std::string sentence = refusal([&] { (void)read_particles(path, columns); });
  REQUIRE_THAT(sentence, StartsWith(path.string()));
  return sentence.substr(path.string().size());
}

template <class Spoil>
std::string refused_with(const Sandbox& box, std::string_view without, Spoil&& spoil) {
  return refused(file_with(box, without, spoil));
}

}  // namespace

TEST_CASE("particles come back as they were written") {
  const Sandbox box;
  const Doubles x{0.1, -1e-300, 3}, gamma{1, -2, 0};
  const std::vector<std::int64_t> start{0, 1, 1, 4};
  const std::vector<std::int32_t> index{2, 0};
  write_columns(box / "p.h5",
                std::array<ParticleColumn, 5>{
                    {{"x", x}, {"y", three}, {"gamma", gamma}, {"start", start}, {"index", index}}},
                {{"method", std::string("boxes")}, {"tolerance", 1e-6}, {"n", std::int64_t{3}}});
  const ParticleFile p = read_particles(box / "p.h5", all);
  CHECK(p.x == x);
  CHECK(p.y == three);
  CHECK(p.gamma == gamma);
  CHECK(p.sigma.empty());
  CHECK(p.reach.empty());
  const h5::Handle file = h5::open_file(box / "p.h5");
  CHECK(h5::read(file, "start") == Doubles{0, 1, 1, 4});
  CHECK(h5::read(file, "index") == Doubles{2, 0});
  CHECK(h5::read_string(file, "method") == "boxes");
  CHECK(h5::read_double(file, "tolerance") == 1e-6);
  CHECK(h5::read_integer(file, "n") == 3);
}

TEST_CASE("any type of number is read") {
  const Sandbox box;
  const hid_t type = GENERATE(as<hid_t>{}, H5T_IEEE_F32LE, H5T_IEEE_F64BE, H5T_STD_I8LE,
                              H5T_STD_U16BE, H5T_STD_I64LE, H5T_NATIVE_LDOUBLE);
  const auto path = file_with(box, "x", [&](hid_t file) {
    const std::array<hsize_t, 1> shape{3};
    const h5::Handle space(H5Screate_simple(1, shape.data(), nullptr));
    const h5::Handle set(H5Dcreate2(file, "x", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    REQUIRE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, three.data()) >= 0);
  });
  CHECK(read_particles(path).x == three);
}

TEST_CASE("integers that doubles round are refused with their column, those before them are read") {
  const Sandbox box;
  const auto with_y = [&](std::int64_t last) {
    return file_with(box, "y", [&](hid_t file) {
      const std::vector<std::int64_t> y{1, -2, last};
      h5::write(file, "y", std::span<const std::int64_t>(y));
    });
  };
  const std::int64_t first_lost = (std::int64_t{1} << 53) + 1;
  CHECK(read_particles(with_y(first_lost - 2)).y.back() == static_cast<double>(first_lost - 2));
  for (const std::int64_t lost : {first_lost, -first_lost})
    CHECK_THAT(refused(with_y(lost)), StartsWith(": y[2] is ") && EndsWith("as doubles"));
}

TEST_CASE("no particles are particles too") {
  const Sandbox box;
  const Doubles none;
  write_columns(box / "p.h5", std::array<ParticleColumn, 2>{{{"x", none}, {"y", none}}});
  CHECK(read_particles(box / "p.h5").x.empty());
}

TEST_CASE("what nobody asked for cannot be wrong") {
  const Sandbox box;
  const auto path = file_with(box, "reach", [](hid_t file) {
    h5::write(file, "reach", Doubles{-1, 2});
  });
  const ParticleFile p = read_particles(path, {.sigma = Need::required});
  CHECK(p.gamma.empty());
  CHECK(p.reach.empty());
  CHECK(p.sigma == three);
}

TEST_CASE("a file that holds no particles is refused in a sentence") {
  const Sandbox box;
  CHECK(refused(box / "none.h5") == ": no such file");
  CHECK(refused(box.path()) == " is a folder; a file was expected");
  CHECK(refused(box.write("text.h5", "x,y\n1,2\n")) == " is not an HDF5 file");
  CHECK(refused(box.write("empty.h5", "")) == " is not an HDF5 file");
  const auto good = file_with(box, "", [](hid_t) {});
  const auto cut = box.write("cut.h5", text_of(good).substr(0, 1500));
  CHECK(refused(cut) == " is HDF5, but damaged or cut short: it cannot be opened");
}

TEST_CASE("a wrong column is refused with its name and what is wrong with it") {
  const Sandbox box;
  const auto nothing = [](hid_t) {};
  CHECK(refused_with(box, "x", nothing) ==
        ": there is no dataset x; the file has gamma, reach, sigma, y");
  CHECK(refused_with(box, "gamma", nothing) ==
        ": there is no dataset gamma; the file has reach, sigma, x, y");
  CHECK(refused_with(box, "y", [](hid_t file) {
          h5::write(file, "y", Doubles{1, 2});
        }) == ": y has 2 values, but x has 3");
  CHECK(refused_with(box, "gamma", [](hid_t file) { h5::write(file, "gamma", Doubles{}); }) ==
        ": gamma has 0 values, but x has 3");
  CHECK(refused_with(box, "sigma", [](hid_t file) { h5::write(file, "sigma", Doubles{}); }) ==
        ": sigma has 0 values, but x has 3");
  CHECK(refused_with(box, "x", [](hid_t file) { h5::write_grid(file, "x", Doubles(6), 3, 2); }) ==
        ": x has 2 dimensions (3 x 2); one was expected");
  CHECK(refused_with(box, "x", [](hid_t file) { (void)h5::create_group(file, "x"); }) ==
        ": x is not a dataset");
  CHECK(refused_with(box, "y", [](hid_t file) {
          const h5::Handle space(H5Screate(H5S_SCALAR));
          const h5::Handle set(H5Dcreate2(file, "y", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                                          H5P_DEFAULT, H5P_DEFAULT));
        }) == ": y has 0 dimensions (); one was expected");
  CHECK(refused_with(box, "y", [](hid_t file) {
          const std::array<hsize_t, 1> shape{3};
          const h5::Handle space(H5Screate_simple(1, shape.data(), nullptr));
          const h5::Handle set(
              H5Dcreate2(file, "y", H5T_C_S1, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        }) == ": y does not hold numbers");
}

TEST_CASE("a wrong value is refused with its column and index") {
  const Sandbox box;
  const auto value = [&](const std::string& name, double third) {
    return refused_with(box, name, [&](hid_t file) {
      h5::write(file, name, Doubles{1, 2, third});
    });
  };
  constexpr double inf = std::numeric_limits<double>::infinity();
  CHECK(value("x", std::nan("")) == ": x[2] is nan; finite numbers were expected");
  CHECK(value("gamma", -inf) == ": gamma[2] is -inf; finite numbers were expected");
  CHECK(value("sigma", -0.5) == ": sigma[2] is -0.5; it must be >= 0");
  CHECK(value("reach", -1) == ": reach[2] is -1; it must be >= 0");
}

TEST_CASE("an output that cannot be written is refused before anything is lost") {
  const Sandbox box;
  const std::array<ParticleColumn, 1> x{{{"x", three}}};
  const auto refused_output = [&](const std::filesystem::path& path) {
    CHECK(refusal([&] { require_writable(path); }) == refusal([&] { write_columns(path, x); }));
    return refusal([&] { require_writable(path); });
  };
  const std::string file = box.write("file", "words").string();
  CHECK(refused_output(box.path()) == box.path().string() + " is a folder; a file was expected");
  const auto nowhere = box / "none";
  CHECK(refused_output(nowhere / "p.h5") == (nowhere / "p.h5").string() +
                                                " cannot be written in the folder " +
                                                nowhere.string() + ": No such file or directory");
  CHECK(refused_output(file + "/p.h5") ==
        file + "/p.h5 cannot be written in the folder " + file + ": Not a directory");
  CHECK_THAT(refused_output("/proc/p.h5"),
             StartsWith("/proc/p.h5 cannot be written in the folder /proc: "));
  CHECK(std::distance(std::filesystem::directory_iterator(box.path()), {}) == 1);
}

TEST_CASE("HDF5 keeps its own words to itself") {
  const Sandbox box;
  std::fflush(stderr);
  const int kept = dup(2);
  REQUIRE(std::freopen((box / "stderr").c_str(), "w", stderr) != nullptr);
  const std::string sentence = refused_with(box, "x", [](hid_t) {});
  h5::write_attribute(h5::open_file(box / "p.h5", H5F_ACC_RDWR), "seed", std::int64_t{1});
  CHECK_THROWS_AS(h5::read(h5::open_file(box / "p.h5"), "none"), h5::Failure);
  std::fflush(stderr);
  dup2(kept, 2);
  close(kept);
  CHECK(text_of(box / "stderr").empty());
}
