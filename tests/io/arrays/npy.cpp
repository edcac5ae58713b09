#include "io/arrays/npy.hpp"

#include <cmath>
#include <limits>

#include "io/arrays/made.hpp"
#include "io/sandbox.hpp"
#include "io/tables/particles.hpp"

using namespace vortree::io;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

namespace {

using Doubles = std::vector<double>;

constexpr ParticleColumns blobs{.gamma = Need::required, .sigma = Need::optional};

ParticleFile read(const Sandbox& box, const std::string& bytes, ParticleColumns columns = blobs) {
  return read_particles(box.write("p.npy", bytes), columns);
}

/// The refusal, without the path before it.
std::string refused(const Sandbox& box, const std::string& bytes, ParticleColumns columns = blobs) {
  const std::string path = (box / "p.npy").string() + ": ";
  const std::string sentence = refusal([&] { (void)read(box, bytes, columns); });
  REQUIRE_THAT(sentence, Catch::Matchers::StartsWith(path));
  return sentence.substr(path.size());
}

const Doubles rows{0.1, 2, 3, 1e-3, -0.5, 5, -6, 0};  // two, of four
const Doubles down{0.1, -0.5, 2, 5, 3, -6, 1e-3, 0};  // the same by columns
const std::string four = npy("'<f8'", "(2, 4)", bytes_in(rows));

void check_rows(const ParticleFile& p) {
  CHECK(p.x == Doubles{0.1, -0.5});
  CHECK(p.y == Doubles{2, 5});
  CHECK(p.gamma == Doubles{3, -6});
  CHECK(p.sigma == Doubles{1e-3, 0});
}

}  // namespace

TEST_CASE("rows of an .npy are x, y and what the job reads, in whatever order of bytes") {
  const Sandbox box;
  check_rows(read(box, four));
  check_rows(read(box, npy("'<f8'", "(2, 4)", bytes_in(down), true)));
  check_rows(read(box, npy("'>f8'", "(2, 4)", bytes_in(rows, true))));
  const std::string spaced = "{\"shape\": (2,4), 'descr':'<f8','fortran_order' : False}   ";
  for (const int version : {1, 2, 3})
    check_rows(read(box, npy_with(spaced, bytes_in(rows), version)));
  check_rows(read(box, npy_with("{'descr': '<f8', 'fortran_order': False, 'shape': (2L, 4L)}",
                                bytes_in(rows))));
}

TEST_CASE("rows may leave out what is optional, and end there") {
  const Sandbox box;
  const std::string three = npy("'<f8'", "(2, 3)", bytes_in(Doubles{1, 2, 3, 4, 5, 6}));
  CHECK(read(box, three).gamma == Doubles{3, 6});
  CHECK(read(box, three).sigma.empty());
  CHECK(read(box, three, {.reach = Need::required}).reach == Doubles{3, 6});
  const std::string two = npy("'<f8'", "(2, 2)", bytes_in(Doubles{1, 2, 3, 4}));
  CHECK(read(box, two, {}).y == Doubles{2, 4});
  CHECK(refused(box, two) == "there is no column gamma; the file has x, y");
  CHECK(read(box, npy("'<f8'", "(0, 3)", "")).x.empty());
}

TEMPLATE_TEST_CASE("an .npy of any type of real number is read", "", float, std::int8_t,
                   std::int16_t, std::int32_t, std::int64_t, std::uint8_t, std::uint16_t,
                   std::uint32_t, std::uint64_t) {
  const Sandbox box;
  const char kind = std::is_floating_point_v<TestType> ? 'f'
                    : std::is_signed_v<TestType>       ? 'i'
                                                       : 'u';
  constexpr auto most = std::numeric_limits<TestType>::max();
  constexpr bool fits = std::numeric_limits<TestType>::digits <= 53;
  const std::vector<TestType> values{1, 2, fits ? most : static_cast<TestType>(0x1p52), 0};
  for (const bool big : {false, true}) {
    const std::string descr =
        std::string(big ? "'>" : "'<") + kind + std::to_string(sizeof(TestType)) + "'";
    const ParticleFile p = read(box, npy(descr, "(2, 2)", bytes_in(values, big)), {});
    CHECK(p.x == Doubles{1, static_cast<double>(values[2])});
    CHECK(p.y == Doubles{2, 0});
  }
}

TEST_CASE("records of an .npy are columns by their names, whatever lies between") {
  const Sandbox box;
  std::string data;
  for (int i = 0; i < 3; ++i)
    data += bytes_in(static_cast<std::int8_t>(7)) + std::string(3, '?') + bytes_in(0.5 * i) +
            bytes_in(static_cast<float>(i), true) + bytes_in(std::int32_t{-i}) +
            std::string(12, '?');
  const std::string descr =
      "[('tag', '|i1'), ('', '|V3'), ('y', '<f8'), (('a title', 'x'), '>f4'), ('gamma', '<i4'), "
      "('name', '<U1', (3,))]";
  const ParticleFile p = read(box, npy(descr, "(3,)", data));
  CHECK(p.x == Doubles{0, 1, 2});
  CHECK(p.y == Doubles{0, 0.5, 1});
  CHECK(p.gamma == Doubles{0, -1, -2});
  CHECK(refused(box, npy(descr, "(3,)", data), {.reach = Need::required}) ==
        "there is no column reach; the file has tag, y, x, gamma, name");
  CHECK(refused(box, npy("[('x', '<f8'), ('y', '<f8', (2,))]", "(1,)", bytes_in(Doubles{1, 2, 3})),
                {}) ==
        "y has dtype \"<f8\", an array in each record; float64, float32 or integers were expected");
  CHECK(refused(box, npy("[('x', '<f8'), ('y', '<f8')]", "(1, 1)", bytes_in(Doubles{1, 2}))) ==
        "its records have shape (1, 1); one dimension was expected");
}

TEST_CASE("an .npy cut anywhere, or with more behind it, is refused") {
  const Sandbox box;
  for (std::size_t length = 0; length < four.size(); ++length) {
    CAPTURE(length);
    CHECK(refused(box, four.substr(0, length)).size() < 300);
  }
  CHECK(refused(box, four.substr(0, four.size() - 1)) ==
        "it claims shape (2, 4) of 8 bytes each, 64 bytes; 63 are there");
  CHECK_THAT(refused(box, four + "!"), EndsWith("64 bytes; 65 are there"));
  CHECK_THAT(refused(box, four.substr(0, 40)), Catch::Matchers::StartsWith("it is cut short: "));
  CHECK(refused(box, "x,y\n1,2\n") == "it is not an .npy array: other first bytes");
}

TEST_CASE("a shape that no file holds is refused before any memory") {
  const Sandbox box;
  const auto claims = [&](const std::string& shape) {
    return refused(box, npy("'<f8'", shape, bytes_in(rows)));
  };
  CHECK(claims("(100000000000, 2)") ==
        "it claims shape (100000000000, 2) of 8 bytes each, 1600000000000 bytes; 64 are there");
  for (const char* shape : {"(4611686018427387904, 4)", "(4294967296, 4294967296, 4294967296)",
                            "(2, 9223372036854775807)"})
    CHECK_THAT(claims(shape), EndsWith("of 8 bytes each; no file holds so much"));
  CHECK_THAT(claims("(99999999999999999999, 4)"), Contains("a number of elements was expected"));
  CHECK_THAT(claims("(-2, 4)"), Contains("a number of elements was expected"));
}

TEST_CASE("what are no real numbers in an .npy is called by its name") {
  const Sandbox box;
  const auto of_type = [&](const std::string& descr, std::size_t width) {
    return refused(box, npy("'" + descr + "'", "(2, 3)", std::string(6 * width, '\0')));
  };
  const std::string wanted = "; float64, float32 or integers were expected";
  CHECK(of_type("<c16", 16) == "the array has dtype \"<c16\", complex numbers" + wanted);
  CHECK(of_type("|b1", 1) == "the array has dtype \"|b1\", truth values" + wanted);
  CHECK(of_type("<U5", 20) == "the array has dtype \"<U5\", text" + wanted);
  CHECK(of_type("<M8[ns]", 8) == "the array has dtype \"<M8[ns]\", times" + wanted);
  CHECK(of_type("<f2", 2) == "the array has dtype \"<f2\", numbers of that many bytes" + wanted);
  CHECK(of_type("|O", 8) == "it holds Python objects (dtype \"|O\"); numbers were expected");
}

TEST_CASE("a shape that is not rows of particles is refused with what was expected") {
  const Sandbox box;
  const auto of_shape = [&](const std::string& shape, std::size_t count) {
    return refused(box, npy("'<f8'", shape, bytes_in(Doubles(count))));
  };
  const std::string wanted = "; n rows of x, y, gamma, sigma, or the first of these, were expected";
  CHECK(of_shape("()", 1) == "the array has shape ()" + wanted);
  CHECK(of_shape("(6,)", 6) == "the array has shape (6,)" + wanted);
  CHECK(of_shape("(6, 1)", 6) == "the array has shape (6, 1)" + wanted);
  CHECK(of_shape("(6, 5)", 30) == "the array has shape (6, 5)" + wanted);
  CHECK(of_shape("(3, 9)", 27) == "the array has shape (3, 9)" + wanted + ": save its transpose");
  CHECK(of_shape("(2, 3, 2)", 12) == "the array has shape (2, 3, 2)" + wanted);
}

TEST_CASE("a wrong number in an .npy is named by column and index") {
  const Sandbox box;
  const auto with = [&](std::size_t place, double value) {
    Doubles spoiled = rows;
    spoiled[place] = value;
    return refused(box, npy("'<f8'", "(2, 4)", bytes_in(spoiled)));
  };
  CHECK(with(6, std::nan("")) == "gamma[1] is nan; finite numbers were expected");
  CHECK(with(0, INFINITY) == "x[0] is inf; finite numbers were expected");
  CHECK(with(7, -0.5) == "sigma[1] is -0.5; it must be >= 0");
  const std::vector<std::int64_t> whole{1, 2, 3, std::int64_t{1} << 53};
  CHECK_THAT(refused(box, npy("'<i8'", "(2, 2)", bytes_in(whole)), {}),
             EndsWith("write the column as doubles"));
}

TEST_CASE("a damaged header of an .npy is refused, whichever byte of it is damaged") {
  const Sandbox box;
  const std::size_t header = four.size() - bytes_in(rows).size();
  int refusals = 0;
  for (std::size_t at = 0; at < header; ++at)
    for (const char byte : {'\0', '(', '9', '\'', '\xff'}) {
      std::string spoiled = four;
      spoiled[at] = byte;
      try {
        (void)read(box, spoiled);
      } catch (const InputError& error) {
        CHECK(std::string(error.what()).size() < 600);
        ++refusals;
      }
    }
  // The rest are bytes that were that already, blanks, and the minor version, of which there is
  // one.
  CHECK(refusals > 4 * static_cast<int>(header));
}

TEST_CASE("what is written as .npy is read back, and begins where numpy aligns it") {
  const Doubles values{0.1, -1e-300, 3};
  const std::string bytes = npy_of(std::span<const double>(values));
  const NpyHeader header = read_npy_header(bytes);
  CHECK(header.begin % 64 == 0);
  CHECK(header.shape == std::vector<std::uint64_t>{3});
  CHECK(npy_numbers(bytes, header, header.fields[0], 0) == values);
  const std::vector<std::int64_t> whole{-1, 5};
  CHECK_THAT(npy_of(std::span<const std::int64_t>(whole)), Contains("'<i8'") && Contains("(2,)"));
  const std::vector<std::int32_t> none;
  CHECK(read_npy_header(npy_of(std::span<const std::int32_t>(none))).count == 0);
}
