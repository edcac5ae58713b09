#include <sys/stat.h>

#include <array>

#include "io/frames/frames.hpp"
#include "io/frames/hdf5.hpp"
#include "io/frames/read.hpp"
#include "io/sandbox.hpp"
#include "io/tables/fields.hpp"
#include "io/tables/particles.hpp"

using namespace vortree::io;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

// Files that were made to mislead, by a stranger or by accident.

namespace {

using Doubles = std::vector<double>;

const Doubles three{1, 2, 3};
const std::string only_inside = "; only what the file itself holds is read";

/// A dataset of `count` numbers that nobody writes, as its list of properties says.
void declare(hid_t file, const char* name, hsize_t count, hid_t creation,
             hid_t type = H5T_NATIVE_DOUBLE) {
  const h5::Handle space = h5::own(H5Screate_simple(1, &count, nullptr), "space");
  (void)h5::own(H5Dcreate2(file, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT), name);
}

h5::Handle creation_list() {
  return h5::own(H5Pcreate(H5P_DATASET_CREATE), "list");
}

h5::Handle chunked(hsize_t chunk) {
  h5::Handle creation = creation_list();
  h5::check(H5Pset_chunk(creation, 1, &chunk), "chunk");
  return creation;
}

/// As another program makes it: this one has told HDF5 to forget that there are such links.
void link_outside(hid_t place, const std::string& name, const std::string& target,
                  const std::string& object) {
  H5L_class_t external{};
  external.version = H5L_LINK_CLASS_T_VERS;
  external.id = H5L_TYPE_EXTERNAL;
  external.trav_func = [](const char*, hid_t, const void*, size_t, hid_t, hid_t) -> hid_t {
    return H5I_INVALID_HID;
  };
  h5::check(H5Lregister(&external), "class");
  const std::string words = std::string(1, '\0') + target + '\0' + object + '\0';
  h5::check(H5Lcreate_ud(place, name.c_str(), H5L_TYPE_EXTERNAL, words.data(), words.size(),
                         H5P_DEFAULT, H5P_DEFAULT),
            "link");
}

void make_virtual(hid_t file, const char* source) {
  const hsize_t count = 3;
  const h5::Handle space = h5::own(H5Screate_simple(1, &count, nullptr), "space");
  const h5::Handle creation = creation_list();
  h5::check(H5Pset_virtual(creation, space, source, "x", space), "virtual");
  declare(file, "x", count, creation);
}

void keep_outside(hid_t file, const char* raw) {
  const h5::Handle creation = creation_list();
  h5::check(H5Pset_external(creation, raw, 0, 3 * sizeof(double)), "raw");
  declare(file, "x", 3, creation);
}

/// Good columns y, gamma and the x that `make_x` makes.
template <class MakeX>
std::filesystem::path file_with(const Sandbox& box, MakeX&& make_x) {
  h5::Handle file = h5::create_file(box / "p.h5");
  for (const char* name : {"y", "gamma"}) h5::write(file, name, three);
  make_x(file);
  h5::close_file(std::move(file), box / "p.h5");
  return box / "p.h5";
}

/// The refusal, without the path and colon before it.
std::string refused(const std::filesystem::path& path) {
  const std::string sentence =
      refusal([&] { (void)read_particles(path, {.gamma = Need::required}); });
  REQUIRE_THAT(sentence, StartsWith(path.string() + ": "));
  return sentence.substr(path.string().size() + 2);
}

template <class MakeX>
std::string refused_with(const Sandbox& box, MakeX&& make_x) {
  return refused(file_with(box, make_x));
}

/// In the file's name table, or wherever the mark stands first, four other bytes.
void overwrite(const std::filesystem::path& path, const std::string& mark) {
  std::string bytes = text_of(path);
  const std::size_t at = bytes.find(mark);
  REQUIRE(at != std::string::npos);
  std::ofstream(path, std::ios::binary) << bytes.replace(at, 4, "XXXX");
}

}  // namespace

TEST_CASE("no number is read from outside of a particle file, and no pipe is waited for") {
  const Sandbox box;
  REQUIRE(mkfifo((box / "pipe").c_str(), 0600) == 0);
  write_columns(box / "other.h5", std::array<ParticleColumn, 1>{{{"x", three}}});
  const std::string target = (box / GENERATE("pipe", "other.h5", "p.h5", "there is none")).string();
  CAPTURE(target);
  CHECK(refused_with(box, [&](hid_t file) { link_outside(file, "x", target, "x"); }) ==
        "x is a link into another file" + only_inside);
  CHECK(refused_with(box, [&](hid_t file) { make_virtual(file, target.c_str()); }) ==
        "x is a virtual dataset, put together from others" + only_inside);
  CHECK(refused_with(box, [&](hid_t file) { keep_outside(file, target.c_str()); }) ==
        "x keeps its numbers in another, raw file" + only_inside);
  CHECK_THAT(refused_with(box,
                          [&](hid_t file) {
                            link_outside(file, "out", target, "/");
                            h5::check(H5Lcreate_soft("/out/x", file, "x", H5P_DEFAULT, H5P_DEFAULT),
                                      "link");
                          }),
             EndsWith("a link that leads to none in the file"));
}

TEST_CASE("a pipe is no file of particles, frames or fields") {
  const Sandbox box;
  for (const char* name : {"p.h5", "frames.h5", "fields.h5"}) {
    REQUIRE(mkfifo((box / name).c_str(), 0600) == 0);
  }
  const std::string words = " is a device or a pipe; a file was expected";
  CHECK(refusal([&] { (void)read_particles(box / "p.h5"); }) == (box / "p.h5").string() + words);
  const std::string frames = (box / "frames.h5").string();
  CHECK(refusal([&] { (void)read_last_good(frames); }) == frames + words);
  CHECK(refusal([&] { (void)read_frames(frames, 1); }) == frames + words);
  CHECK(refusal([&] { (void)field_times(box.path()); }) == (box / "fields.h5").string() + words);
}

TEST_CASE("a link may lead anywhere in the file, but must end at a dataset") {
  const Sandbox box;
  const auto soft = [&](const char* target) {
    return file_with(box, [&](hid_t file) {
      h5::check(H5Lcreate_soft("/x", file, "circle", H5P_DEFAULT, H5P_DEFAULT), "link");
      h5::check(H5Lcreate_soft(target, file, "x", H5P_DEFAULT, H5P_DEFAULT), "link");
    });
  };
  CHECK(read_particles(soft("/gamma")).x == three);
  for (const char* target : {"/circle", "/x", "/nothing", "/gamma/x"}) {
    CHECK(refused(soft(target)) == "x is not a dataset, but a link that leads to none in the file");
  }
}

TEST_CASE("a length that the file cannot hold is refused with the numbers, before any memory") {
  const Sandbox box;
  const hsize_t count = GENERATE(10000000u, 2147483648u, 1000000000000000u, 9223372036854775807u);
  const auto claims = [&](const h5::Handle& creation, hid_t type, int width) {
    const std::string said =
        refused_with(box, [&](hid_t file) { declare(file, "x", count, creation, type); });
    CHECK(said == "x claims " + std::to_string(count) + " numbers of " + std::to_string(width) +
                      " bytes each; the whole file has " +
                      std::to_string(std::filesystem::file_size(box / "p.h5")) + " bytes");
  };
  claims(chunked(1024), H5T_NATIVE_INT8, 1);
  if (count > hsize_t{1} << 60) return;  // HDF5 itself refuses to write such a file
  claims(chunked(1024), H5T_NATIVE_DOUBLE, 8);
  claims(creation_list(), H5T_NATIVE_DOUBLE, 8);
  h5::Handle packed = chunked(1024);
  h5::check(H5Pset_deflate(packed, 9), "deflate");
  claims(packed, H5T_NATIVE_DOUBLE, 8);
}

TEST_CASE("columns of unequal length are refused before the first is read") {
  const Sandbox box;
  CHECK(refused_with(box, [](hid_t file) { declare(file, "x", 100000, creation_list()); }) ==
        "y has 3 values, but x has 100000");
}

TEST_CASE("a filter that is not there is called by its name, and is no damage") {
  const Sandbox box;
  constexpr H5Z_filter_t lzf = 32000;
  const auto path = file_with(box, [](hid_t file) {
    const h5::Handle creation = chunked(3);
    h5::check(H5Pset_filter(creation, lzf, H5Z_FLAG_OPTIONAL, 0, nullptr), "filter");
    declare(file, "x", 3, creation);
    const h5::Handle set = h5::own(H5Dopen2(file, "x", H5P_DEFAULT), "x");
    const hsize_t at = 0;
    h5::check(H5Dwrite_chunk(set, H5P_DEFAULT, 0, &at, 24, three.data()), "chunk");
  });
  CHECK_THAT(refused(path),
             StartsWith("x needs the filter ") && EndsWith("(id 32000), which this HDF5 lacks"));
}

TEST_CASE("a damaged file is named, whatever is damaged in it") {
  const Sandbox box;
  const auto path = file_with(box, [](hid_t) {});
  const std::string mark = GENERATE("SNOD", "TREE", "HEAP");
  overwrite(path, mark);
  CHECK(refused(path) == "the list of names is damaged");
}

TEST_CASE("of many or long names a few are told, in part") {
  const Sandbox box;
  const std::string said = refused_with(box, [](hid_t file) {
    for (int i = 0; i < 300; ++i) {
      h5::write(file, std::string(5000, 'a') + std::to_string(i), three);
    }
  });
  CHECK_THAT(said, StartsWith("there is no dataset x; the file has aaaaa") && EndsWith(", more"));
  CHECK(said.size() < 350);
}

TEST_CASE("a frame that leads into another file is a lost frame") {
  const Sandbox box;
  const Frame frame{.step = 0, .time = 0, .columns = {{"x", "L", three}, {"y", "L", three}}};
  create_frames(box.path(), {});
  append_frame(box.path(), frame);
  std::filesystem::rename(box / "frames.h5", box / "other.h5");
  create_frames(box.path(), {});
  {
    h5::Handle file = h5::open_file(box / "frames.h5", H5F_ACC_RDWR);
    link_outside(file, "frame_000000", (box / "other.h5").string(), "frame_000000");
  }
  const RecoveredFrames found = read_last_good(box / "frames.h5");
  CHECK_FALSE(found.last);
  CHECK_THAT(found.warning, EndsWith("the frame of step 0 is lost; no good frame is left in it"));
}
