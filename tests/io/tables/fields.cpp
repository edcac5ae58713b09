#include "io/tables/fields.hpp"

#include "io/frames/hdf5.hpp"
#include "io/sandbox.hpp"

using namespace vortree::io;

namespace {

Field field_of(double time) {
  Field field{.time = time, .x = {0, 1, 2}, .y = {5, 6}, .u = {}, .v = {}, .omega = {}};
  for (int i = 0; i < 6; ++i) {
    field.u.push_back(time + i);
    field.v.push_back(time - i);
    field.omega.push_back(time * i);
  }
  return field;
}

}  // namespace

TEST_CASE("a field comes back as it was saved, with y along the rows") {
  const Sandbox box;
  CHECK(field_times(box.path()).empty());
  for (const double time : {0.5, 10.0, 2.0, 0.1 + 0.2}) append_field(box.path(), field_of(time));
  CHECK(field_times(box.path()) == std::vector<double>{0.1 + 0.2, 0.5, 2, 10});
  CHECK(read_field(box.path(), 0.1 + 0.2) == field_of(0.1 + 0.2));
  const h5::Handle file = h5::open_file(box / "fields.h5");
  const h5::Handle omega(H5Dopen2(file, "field_10/omega", H5P_DEFAULT));
  const h5::Handle space(H5Dget_space(omega));
  hsize_t shape[2]{};
  REQUIRE(H5Sget_simple_extent_dims(space, shape, nullptr) == 2);
  CHECK(shape[0] == 2);
  CHECK(shape[1] == 3);
}

TEST_CASE("a field has stream function and pressure or not, and its checksum knows of them") {
  for (const auto& [name, grid] : {std::pair("psi", &Field::psi), std::pair("p", &Field::p)}) {
    const Sandbox box;
    Field with = field_of(1);
    with.*grid = {6, 5, 4, 3, 2, 1};
    append_field(box.path(), with);
    append_field(box.path(), field_of(2));
    CHECK(read_field(box.path(), 1) == with);
    CHECK(read_field(box.path(), 2) == field_of(2));
    rewind_fields(box.path(), 2);
    CHECK(read_field(box.path(), 1) == with);
    {
      const h5::Handle file = h5::open_file(box / "fields.h5", H5F_ACC_RDWR);
      REQUIRE(H5Ldelete(file, ("field_1/" + std::string(name)).c_str(), H5P_DEFAULT) >= 0);
    }
    CHECK_THROWS_AS(read_field(box.path(), 1), InputError);
    (with.*grid).pop_back();
    with.time = 3;
    CHECK_THROWS_AS(append_field(box.path(), with), std::invalid_argument);
  }
}

TEST_CASE("a resumed run drops the fields it will make again") {
  const Sandbox box;
  CHECK(rewind_fields(box.path(), 1).empty());
  CHECK_FALSE(std::filesystem::exists(box / "fields.h5"));
  for (const double time : {0.5, 1.0, 1.5, 2.0}) append_field(box.path(), field_of(time));
  CHECK(rewind_fields(box.path(), 1.0) == std::vector<double>{0.5, 1});
  CHECK(field_times(box.path()) == std::vector<double>{0.5, 1});
  append_field(box.path(), field_of(1.5));
  CHECK(read_field(box.path(), 1.5) == field_of(1.5));
}

TEST_CASE("a fields file that was cut does not stop a resumed run") {
  const Sandbox box;
  append_field(box.path(), field_of(1));
  const auto path = box / "fields.h5";
  const std::string whole = text_of(path);
  for (std::size_t length = 0; length < whole.size(); length += 37) {
    CAPTURE(length);
    box.write("fields.h5", whole.substr(0, length));
    rewind_fields(box.path(), 5);
    append_field(box.path(), field_of(3));
    CHECK(field_times(box.path()).back() == 3);
  }
}

TEST_CASE("a field with one wrong byte is noticed, and a resumed run goes on without it") {
  const Sandbox box;
  for (const double time : {1.0, 2.0, 3.0}) append_field(box.path(), field_of(time));
  const std::string whole = text_of(box / "fields.h5");
  int noticed = 0;
  for (std::size_t at = 0; at < whole.size(); at += 61) {
    CAPTURE(at);
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    box.write("fields.h5", damaged);
    std::vector<double> kept;
    try {
      kept = rewind_fields(box.path(), 5);
    } catch (const InputError&) {  // not even HDF5 any more
    }
    for (const double time : kept) CHECK(read_field(box.path(), time) == field_of(time));
    noticed += kept.size() < 3;
  }
  CHECK(noticed > 20);
}

TEST_CASE("a field of an earlier version, without a checksum, is taken") {
  const Sandbox box;
  append_field(box.path(), field_of(1));
  {
    const h5::Handle file = h5::open_file(box / "fields.h5", H5F_ACC_RDWR);
    const h5::Handle group(H5Gopen2(file, "field_1", H5P_DEFAULT));
    REQUIRE(H5Adelete(group, "checksum") >= 0);
  }
  CHECK(read_field(box.path(), 1) == field_of(1));
  CHECK(rewind_fields(box.path(), 5) == std::vector<double>{1});
}

TEST_CASE("a field that does not fit its grid, or is there already, is refused") {
  const Sandbox box;
  append_field(box.path(), field_of(1));
  CHECK_THROWS_AS(append_field(box.path(), field_of(1)), std::invalid_argument);
  Field wrong = field_of(2);
  wrong.y.push_back(7);
  CHECK_THROWS_AS(append_field(box.path(), wrong), std::invalid_argument);
  CHECK(refusal([&] { (void)read_field(box.path(), 2); }) ==
        (box / "fields.h5").string() + " has no field of t = 2 that can be read");
}
