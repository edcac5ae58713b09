#include <sys/stat.h>

#include <array>
#include <cmath>

#include "io/arrays/frame_file.hpp"
#include "io/frames/frames.hpp"
#include "io/frames/hdf5.hpp"
#include "io/sandbox.hpp"
#include "io/tables/particles.hpp"

using namespace vortree::io;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

// Tables of text, frames of runs, and what of HDF5 is like .npz.

namespace {

using Doubles = std::vector<double>;

const Doubles three{1, 2, 3};

constexpr ParticleColumns blobs{.gamma = Need::required, .sigma = Need::optional};

std::string refused(const std::filesystem::path& path, ParticleColumns columns = blobs) {
  return refusal([&] { (void)read_particles(path, columns); });
}

/// The refusal of a table, without the path before it.
std::string refused_text(const Sandbox& box, const std::string& text) {
  const auto path = box.write("p.csv", text);
  return refused(path).substr(path.string().size());
}

/// Frames of steps 0, 10 and 20, whose x begins with the step.
void make_frames(const Sandbox& box) {
  create_frames(box.path(), {});
  for (const std::int64_t step : {0, 10, 20})
    append_frame(box.path(), {.step = step,
                              .time = 0.1 * static_cast<double>(step),
                              .columns = {{"x", "L", {static_cast<double>(step), 1, 2}},
                                          {"y", "L", three},
                                          {"gamma", "L^2/T", three},
                                          {"sigma", "L", {0.1, 0.2, 0.3}}}});
}

}  // namespace

TEST_CASE("columns of a table are found by name; notes, blanks and other columns do not matter") {
  const Sandbox box;
  const auto good = box.write("p.csv",
                              "\xef\xbb\xbf# a note\r\nname, gamma ,x,y,odd\r\n\r\n"
                              "a,1,0.1, -2e-3,?\r\n# another\r\n\"b\",2,-3,+4.5,nan");
  const ParticleFile p = read_particles(good, blobs);
  CHECK(p.x == Doubles{0.1, -3});
  CHECK(p.y == Doubles{-2e-3, 4.5});
  CHECK(p.gamma == Doubles{1, 2});
  CHECK(p.sigma.empty());
  CHECK(read_particles(box.write("none.csv", "x,y\n")).x.empty());
}

TEST_CASE("a wrong table is refused with its line") {
  const Sandbox box;
  CHECK(refused_text(box, "x,gamma\n1,2\n") == ": there is no column y; the file has x, gamma");
  CHECK(refused_text(box, "x,y,gamma\n1,2,3\n\n4,five,6\n") ==
        ":4: y is \"five\"; a number was expected");
  CHECK(refused_text(box, "x,y,gamma\n1,2,3\n4,5\n") == ":3: 2 cells; 3 columns were expected");
  CHECK(refused_text(box, "x,y,gamma\n# n\n1,2,\n") ==
        ": gamma[0] (line 3) is nan; finite numbers were expected");
  CHECK(refused_text(box, "x,y,gamma,sigma\n1,2,3,1\n1,2,3,-1\n") ==
        ": sigma[1] (line 3) is -1; it must be >= 0");
  CHECK(refused_text(box, "x,y,x,gamma\n1,2,3,4\n") == ": x is the name of two columns");
  CHECK_THAT(refused_text(box, "# x,y,gamma\n1,2,3\n"),
             StartsWith(": it begins with a line of numbers; one of names, x,y,..., was expected"));
  CHECK(refused_text(box, "") == " is empty; a line of column names was expected");
  REQUIRE(mkfifo((box / "pipe.csv").c_str(), 0600) == 0);
  CHECK_THAT(refused(box / "pipe.csv"), EndsWith("is a device or a pipe; a file was expected"));
}

TEST_CASE("what is written as .csv reads back to the same bits") {
  const Sandbox box;
  const Doubles x{0.1, 1.0 / 3, -5e-324, 1.7976931348623157e308}, y{-0.0, 1, 2, 3};
  write_columns(box / "o.csv", std::array<ParticleColumn, 2>{{{"x", x}, {"y", y}}});
  CHECK(text_of(box / "o.csv").starts_with("x,y\n0.1,-0\n0.3333333333333333,1\n-5e-324,2\n"));
  const ParticleFile p = read_particles(box / "o.csv");
  CHECK(p.x == x);
  CHECK(std::signbit(p.y[0]));
  CHECK_THROWS_AS(
      write_columns(box / "o.csv", std::array<ParticleColumn, 2>{{{"x", x}, {"y", three}}}),
      std::invalid_argument);
  CHECK_THAT(refusal([&] { write_columns(box / "o.npy", {}); }),
             EndsWith("an .npy holds one array; .npz, .csv or .h5 was expected"));
}

TEST_CASE("a frame is read by its number or as the last, from its file or its folder") {
  const Sandbox box;
  make_frames(box);
  const auto first_x = [&](const std::string& word) {
    return read_particles(word, blobs).x.front();
  };
  const std::string file = (box / "frames.h5").string(), folder = box.path().string();
  CHECK(first_x(file + "::0") == 0);
  CHECK(first_x(file + "::1") == 10);
  CHECK(first_x(file + "::last") == 20);
  CHECK(first_x(folder + "::last") == 20);
  CHECK(first_x(folder + "/::2") == 20);
  CHECK(read_particles(folder + "::0", blobs).sigma == Doubles{0.1, 0.2, 0.3});
  CHECK(file_behind(folder + "::last") == box / "frames.h5");
  CHECK(file_behind(file) == box / "frames.h5");
}

TEST_CASE("a frame that is not there is refused with those that are") {
  const Sandbox box;
  make_frames(box);
  const std::string file = (box / "frames.h5").string(), folder = box.path().string();
  CHECK(refused(file + "::3") == file + ": it has 3 frames, 0 to 2; there is no frame 3");
  for (const std::string tail : {"first", "-1", "1.5", "", "99999999999999999999999"})
    CHECK(refused(file + "::" + tail) == file + "::" + tail + ": \"" + tail +
                                             "\" names no frame; last or a number, counted from 0, "
                                             "was expected");
  CHECK(refused(file) == file + " has 3 frames of a run; which of them? " + file + "::last, or " +
                             file + "::0 for the first");
  CHECK(refused(folder + "::last", {.reach = Need::required}) ==
        folder + "::last: there is no column reach; the file has x, y, gamma, sigma");
  CHECK(refused((box / "none").string() + "::last") == (box / "none").string() + ": no such file");
  write_columns(box / "p.h5", std::array<ParticleColumn, 1>{{{"x", three}}});
  CHECK_THAT(refused((box / "p.h5").string() + "::last"), EndsWith(": it has no frames of a run"));
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  CHECK_THAT(refused(file + "::last"), StartsWith(file + ": "));
}

TEST_CASE("a file whose name has :: in it is that file") {
  const Sandbox box;
  CHECK(read_particles(box.write("a::b.csv", "x,y\n5,6\n")).x == Doubles{5});
  CHECK_FALSE(frame_pointer(box / "a::b.csv"));
  CHECK_FALSE(frame_pointer(box / "other.h5"));
}

TEST_CASE("positions of an HDF5 file may be n x 2, where that can be told") {
  const Sandbox box;
  const auto with = [&](const char* name, hsize_t rows, hsize_t columns, bool y) {
    h5::Handle file = h5::create_file(box / "p.h5");
    h5::write_grid(file, name, Doubles{1, 2, 3, 4, 5, 6}, rows, columns);
    h5::write(file, "gamma", three);
    if (y) h5::write(file, "y", three);
    h5::close_file(std::move(file), box / "p.h5");
    return box / "p.h5";
  };
  for (const char* name : {"x", "points"}) {
    const ParticleFile p = read_particles(with(name, 3, 2, false), blobs);
    CHECK(p.x == Doubles{1, 3, 5});
    CHECK(p.y == Doubles{2, 4, 6});
  }
  CHECK_THAT(refused(with("points", 2, 3, false)),
             EndsWith("points has 2 dimensions (2 x 3); without y, n x 2 was expected"));
  CHECK_THAT(refused(with("points", 3, 2, true)),
             EndsWith("there is no dataset x; the file has gamma, points, y"));
}
