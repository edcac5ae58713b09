#include <filesystem>

#include "io/arrays/made.hpp"
#include "io/arrays/npz_file.hpp"
#include "io/arrays/zip.hpp"
#include "io/sandbox.hpp"
#include "io/tables/particles.hpp"

using namespace vortree::io;
using namespace vortree::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

using Doubles = std::vector<double>;

const Doubles three{0.1, -2, 3};

constexpr ParticleColumns blobs{
    .gamma = Need::required, .sigma = Need::optional, .reach = Need::optional};

ParticleFile read(const Sandbox& box, const std::string& bytes, ParticleColumns columns = blobs) {
  return read_particles(box.write("p.npz", bytes), columns);
}

std::string refused(const Sandbox& box, const std::string& bytes, ParticleColumns columns = blobs) {
  const std::string path = (box / "p.npz").string() + ": ";
  const std::string sentence = refusal([&] { (void)read(box, bytes, columns); });
  REQUIRE_THAT(sentence, StartsWith(path));
  return sentence.substr(path.size());
}

/// Good x, y, gamma, with `x` as it is given.
std::vector<MadeMember> with_x(MadeMember x) {
  return {{"y.npy", npy(three)}, {"gamma.npy", npy(three)}, std::move(x)};
}

MadeMember deflated(const std::string& name, const std::string& bytes) {
  return {name, bytes, 8, in_plain_blocks(bytes)};
}

// 500 times 1, 2 as an .npy, packed by zlib as close as it can.
const std::string packed_ramp(
    "\xed\xc8\x31\x0e\x82\x30\x18\x86\xe1\xb2\x72\x8a\x6e\xbf\x24\x1d\xca\x46\x8c\x46\x26\x36\x8c"
    "\x8b\x83\x13\x69\xa4\xc4\x81\x08\x69\xd9\x0c\xa7\xf0\xa2\x1e\x41\x94\x63\xf0\x7e\xcb\x97\xe7"
    "\x7d\x9f\xaf\xf5\xe5\x96\xa8\xa3\x7a\x49\xeb\xe3\x3d\xc8\x5e\xcb\xa1\x2b\xc4\x68\xe9\x86\x30"
    "\x05\xf7\x6c\x86\xd0\xfa\x5f\xaf\x5c\x1f\xfd\xd2\xe3\xc3\x8d\x7e\xf1\x2e\xb7\xd6\x9a\xcc\xe8"
    "\x39\x55\xff\x7d\x4e\xeb\xab\x12\x63\x8c\x31\xc6\x18\x63\x8c\x31\xc6\x18\x63\x8c\x31\xc6\x18"
    "\x63\x8c\x31\xde\xa2\xbf",
    121);

MadeMember ramp() {
  Doubles values;
  for (int k = 0; k < 500; ++k) values.insert(values.end(), {1, 2});
  const std::string bytes =
      npy_with("{'descr': '<f8', 'fortran_order': False, 'shape': (1000,), }", bytes_in(values));
  return {"x.npy", bytes, 8, packed_ramp};
}

}  // namespace

TEST_CASE("arrays of an .npz are read by their names, behind any comment and by long directories") {
  const Sandbox box;
  const bool longer = GENERATE(false, true);
  std::vector<MadeMember> members = with_x({"x.npy", npy(Doubles{1, 2, 3})});
  members.push_back({"notes.txt", "any"});
  members.push_back({"sigma.npy", npy("'<f4'", "(3,)", bytes_in(std::vector<float>{1, 2, 0.5}))});
  for (MadeMember& one : members) one.long_numbers = longer;
  for (const std::string comment : {"", "PK\5\6 longer than the end of a directory"}) {
    const ParticleFile p = read(box, zip(members, comment, longer));
    CHECK(p.x == Doubles{1, 2, 3});
    CHECK(p.y == three);
    CHECK(p.gamma == three);
    CHECK(p.sigma == Doubles{1, 2, 0.5});
    CHECK(p.reach.empty());
  }
}

#ifdef VORTREE_ZLIB
TEST_CASE("deflated arrays are unpacked") {
  const Sandbox box;
  const ParticleFile p = read(box, zip(with_x(deflated("x.npy", npy(Doubles{1, 2, 3})))));
  CHECK(p.x == Doubles{1, 2, 3});
  const Doubles many(100000, 0.25);
  CHECK(read(box, zip({deflated("x.npy", npy(many)), deflated("y.npy", npy(many))}), {}).y == many);
  const ParticleFile packed = read(box, zip({ramp(), {"y.npy", npy(Doubles(1000, 3))}}), {});
  REQUIRE(packed.x.size() == 1000);
  CHECK(std::ranges::count(packed.x, 1.0) == 500);
  CHECK(packed.x.back() == 2);
}

TEST_CASE("a packed array that is damaged, or lies of its length, is refused") {
  const Sandbox box;
  const auto said = [&](const MadeMember& x) { return refused(box, zip(with_x(x))); };
  for (std::size_t at = 0; at < packed_ramp.size(); at += 7) {
    MadeMember x = ramp();
    x.packed[at] = static_cast<char>(~x.packed[at]);
    CAPTURE(at);
    CHECK_THAT(said(x), StartsWith("x: it is damaged: "));
  }
  MadeMember cut = ramp();
  cut.packed.resize(100);
  CHECK_THAT(said(cut), EndsWith("100 packed bytes do not unpack to 8071"));
  MadeMember more = ramp();
  more.packed += "more";
  CHECK_THAT(said(more), EndsWith("125 packed bytes do not unpack to 8071"));
  MadeMember other = ramp();
  other.bytes.resize(8000);
  CHECK_THAT(said(other), EndsWith("121 packed bytes do not unpack to 8000"));
  std::string bomb = zip(with_x(ramp()));
  const std::size_t size = bomb.rfind("PK\1\2") + 24;
  bomb.replace(size, 4, bytes_in(0xfffffff0u));
  CHECK(refused(box, bomb) ==
        "x: it claims to be 4294967280 bytes packed into 121; so close none is packed");
}
#else
TEST_CASE("without zlib a packed array is refused with what would pack none") {
  const Sandbox box;
  CHECK_THAT(refused(box, zip(with_x(ramp()))), Contains("numpy.savez"));
}
#endif

TEST_CASE("what else packs or hides a member is called by its name") {
  const Sandbox box;
  const auto said = [&](std::uint16_t method, std::uint16_t flags) {
    return refused(box, zip(with_x({"x.npy", npy(three), method, "packed", flags})));
  };
  const std::string wanted = "; numpy.savez and numpy.savez_compressed were expected";
  CHECK(said(12, 0) == "x: it is packed by bzip2 (zip method 12)" + wanted);
  CHECK(said(14, 0) == "x: it is packed by LZMA (zip method 14)" + wanted);
  CHECK(said(77, 0) == "x: it is packed by an unknown method (zip method 77)" + wanted);
  CHECK(said(0, 1) == "x: it is encrypted");
}

TEST_CASE("an .npz without the arrays that are needed is refused with those that it has") {
  const Sandbox box;
  CHECK(refused(box, zip({{"y.npy", npy(three)}, {"z", npy(three)}})) ==
        "there is no array x; the file has y, z");
  CHECK(refused(box, zip({})) == "there is no array x; the file has none");
  CHECK(refused(box, zip({{"x.npy", npy(three)}, {"y.npy", npy(Doubles{1, 2})}}), {}) ==
        "y has 2 values, but x has 3");
  CHECK_THAT(refused(box, zip(with_x({"x.npy", npy("'<c16'", "(1,)", std::string(16, '\0'))}))),
             StartsWith("x has dtype \"<c16\", complex numbers; "));
  CHECK(refused(box, zip(with_x({"x.npy", npy("'|O'", "(1,)", "pickle")}))) ==
        "x: it holds Python objects (dtype \"|O\"); numbers were expected");
  CHECK(refused(box, zip(with_x({"x.npy", "text"}))) ==
        "x: it is not an .npy array: other first bytes");
  CHECK(refused(box, zip(with_x({"x.npy", npy("[('a', '<f8')]", "(1,)", std::string(8, '\0'))}))) ==
        "x has records; an array of numbers was expected");
}

TEST_CASE("an .npz cut anywhere is refused, and so is one that was changed anywhere in x") {
  const Sandbox box;
  const std::string whole = zip({{"x.npy", npy(three)}, {"y.npy", npy(three)}});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    CAPTURE(length);
    CHECK(refused(box, whole.substr(0, length), {}).size() < 200);
  }
  CHECK(refused(box, whole.substr(0, 300), {}) ==
        "it is a zip file, but cut short: its end is missing");
  CHECK(refused(box, "x,y\n1,2\n", {}) == "it is not a zip file, as .npz files are");
  const std::size_t begin = whole.find("\x93NUMPY"), end = begin + npy(three).size();
  for (std::size_t at = begin; at < end; ++at) {
    std::string spoiled = whole;
    spoiled[at] = static_cast<char>(spoiled[at] ^ 1);
    CHECK_THAT(refused(box, spoiled, {}), StartsWith("x: it is damaged: its CRC is "));
  }
}

TEST_CASE("a directory that leads out of the file is refused") {
  const Sandbox box;
  const std::string whole = zip({{"x.npy", npy(three)}, {"y.npy", npy(three)}});
  const std::size_t first = whole.find("PK\1\2"), end = whole.find("PK\5\6");
  for (const std::size_t at :
       {first + 20, first + 24, first + 28, first + 30, first + 42, end + 16})
    for (const std::uint16_t value : {0xffff, 0x7fff}) {
      std::string spoiled = whole;
      spoiled.replace(at, 2, bytes_in(value));
      CAPTURE(at, value);
      CHECK(refused(box, spoiled, {}).size() < 200);
    }
  std::string other_disk = whole;
  other_disk[end + 4] = 1;
  CHECK(refused(box, other_disk, {}) == "it is a part of a zip file of several parts");
}

TEST_CASE("positions may be n x 2 in one array, where that can be told; a core that of all") {
  const Sandbox box;
  const std::string pairs = npy("'<f8'", "(3, 2)", bytes_in(Doubles{1, 2, 3, 4, 5, 6}));
  const std::string turned = npy("'<f8'", "(3, 2)", bytes_in(Doubles{1, 3, 5, 2, 4, 6}), true);
  const MadeMember gamma{"gamma.npy", npy(three)};
  for (const char* name : {"x.npy", "points.npy"})
    for (const std::string& array : {pairs, turned}) {
      const ParticleFile p =
          read(box, zip({gamma, {name, array}, {"sigma.npy", npy("'<f8'", "()", bytes_in(0.5))}}));
      CHECK(p.x == Doubles{1, 3, 5});
      CHECK(p.y == Doubles{2, 4, 6});
      CHECK(p.sigma == Doubles(3, 0.5));
    }
  CHECK(refused(box, zip({gamma, {"x.npy", pairs}, {"y.npy", npy(three)}})) ==
        "x has 2 dimensions (3 x 2); one was expected");
  CHECK(refused(box, zip({gamma, {"points.npy", npy("'<f8'", "(1, 3)", bytes_in(three))}})) ==
        "points has 2 dimensions (1 x 3); without y, n x 2 was expected");
  CHECK(refused(box, zip({gamma, {"x.npy", npy(three)}})) ==
        "there is no array y; the file has gamma, x");
  CHECK(
      refused(box, zip({gamma, {"points.npy", npy("'<f8'", "(1, 2)", bytes_in(Doubles{1, 2}))}})) ==
      "gamma has 3 values, but x has 1");
  const MadeMember bad{"sigma.npy", npy("'<f8'", "()", bytes_in(-0.5))};
  CHECK(refused(box, zip({gamma, {"points.npy", pairs}, bad})) == "sigma is -0.5; it must be >= 0");
}

TEST_CASE("the fast CRC is that of its definition, for any length") {
  CHECK(crc32_of("123456789") == 0xcbf43926);
  std::string bytes;
  for (int length = 0; length < 40; ++length) {
    CHECK(crc32_of(bytes) == plain_crc32(bytes));
    bytes += static_cast<char>(37 * length + 11);
  }
}

TEST_CASE("what is written as .npz is a zip file as others make it, and reads back") {
  const Sandbox box;
  const std::vector<std::int32_t> index{3, 1};
  write_columns(box / "o.npz",
                std::array<ParticleColumn, 3>{{{"x", three}, {"y", three}, {"index", index}}});
  const std::string bytes = text_of(box / "o.npz");
  const auto members = zip_members(bytes);
  REQUIRE(members.size() == 3);
  CHECK(members[2].name == "index.npy");
  std::string room;
  CHECK(members[2].crc == plain_crc32(bytes_of(members[2], bytes, room)));
  const ParticleFile p = read_particles(box / "o.npz");
  CHECK(p.x == three);
  CHECK(p.y == three);
  const auto arrays = open_npz(box / "o.npz");
  CHECK(arrays->read("index", 0) == Doubles{3, 1});
  CHECK(arrays->layout("index").of_integers);
}
