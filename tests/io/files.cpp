#include "io/files.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <vector>

#include "io/part_file.hpp"
#include "sandbox.hpp"

using namespace vortree::io;
namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

long entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

/// A text, by a file with and without a name.
void write(const fs::path& path, std::string_view text, bool named) {
  if (!named) return write_text(path, text);
  replace_file(path, [&](const fs::path& fresh) { std::ofstream(fresh) << text; });
}

}  // namespace

TEST_CASE("an output replaces a regular file, and leaves nothing else behind") {
  const Sandbox box;
  const bool named = GENERATE(false, true);
  const std::string name = GENERATE(std::string("a.csv"), std::string(255, 'n'));
  write(box / name, "one", named);
  CHECK(text_of(box / name) == "one");
  REQUIRE(chmod((box / name).c_str(), 0640) == 0);
  write(box / name, "two", named);
  CHECK(text_of(box / name) == "two");
  CHECK((fs::status(box / name).permissions() & fs::perms::all) == fs::perms(0640));
  CHECK(entries(box.path()) == 1);
}

TEST_CASE("an output that fails leaves the older file, and nothing else behind") {
  const Sandbox box;
  box.write("a.csv", "old");
  CHECK_THROWS_WITH(replace_file(box / "a.csv",
                                 [](const fs::path& fresh) {
                                   std::ofstream(fresh) << "half";
                                   throw std::runtime_error("stopped");
                                 }),
                    "stopped");
  CHECK(text_of(box / "a.csv") == "old");
  CHECK(entries(box.path()) == 1);
}

TEST_CASE("links are followed: they stay, what they lead to is replaced, made or removed") {
  const Sandbox box;
  const bool named = GENERATE(false, true);
  fs::create_directory(box / "disk");
  box.write("disk/there.csv", "old");
  fs::create_symlink("disk/there.csv", box / "first");
  fs::create_symlink("first", box / "second");
  fs::create_symlink(box / "disk/new.csv", box / "dangling");
  write(box / "second", "text", named);
  write(box / "dangling", "text", named);
  for (const char* link : {"first", "second", "dangling"}) CHECK(fs::is_symlink(box / link));
  CHECK(text_of(box / "disk/there.csv") == "text");
  CHECK(text_of(box / "disk/new.csv") == "text");
  remove_file(box / "second");
  CHECK(fs::is_symlink(box / "second"));
  CHECK_FALSE(fs::exists(box / "disk/there.csv"));
  CHECK(entries(box.path()) == 4);
  CHECK(entries(box / "disk") == 1);
}

TEST_CASE("folders, devices, pipes, sockets and circles of links are no outputs, and stay") {
  const Sandbox box;
  fs::create_directory(box / "folder");
  REQUIRE(mkfifo((box / "pipe").c_str(), 0600) == 0);
  const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  (box / "socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
  REQUIRE(bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
  fs::create_symlink("circle", box / "circle");
  fs::create_symlink("/dev/null", box / "to_device");
  fs::create_symlink("pipe", box / "to_pipe");
  const auto [name, words] = GENERATE(table<std::string, std::string>({
      {"folder", " is a folder; a file was expected"},
      {"pipe", " is a pipe; a file was expected"},
      {"socket", " is a socket; a file was expected"},
      {"circle", " is a link that leads to itself"},
      {"to_device", " is a device; a file was expected"},
      {"to_pipe", " is a pipe; a file was expected"},
  }));
  const fs::path path = box / name;
  const auto before = fs::symlink_status(path).type();
  CHECK(refusal([&] { require_writable(path); }) == path.string() + words);
  CHECK(refusal([&] { write_text(path, "text"); }) == path.string() + words);
  CHECK(refusal([&] { replace_file(path, [](const fs::path&) {}); }) == path.string() + words);
  CHECK(refusal([&] { (void)open_to_append(path); }).starts_with(path.string()));
  CHECK(fs::symlink_status(path).type() == before);
  CHECK(entries(box.path()) == 6);
}

TEST_CASE("an input is no output, by whatever link or spelling") {
  const Sandbox box;
  const std::vector<fs::path> inputs{box / "none.h5", box.write("in.h5", "data")};
  fs::create_directory(box / "folder");
  fs::create_symlink("in.h5", box / "link.h5");
  fs::create_hard_link(box / "in.h5", box / "twin.h5");
  for (const char* name : {"in.h5", "link.h5", "twin.h5", "folder/../in.h5", "./in.h5"}) {
    CHECK_THAT(refusal([&] { require_writable(box / name, inputs); }),
               Contains(" is the input " + inputs[1].string()));
  }
  CHECK_NOTHROW(require_writable(box / "other.h5", inputs));
  CHECK_NOTHROW(require_writable(box / "none.h5", inputs));
  CHECK(refusal([&] { require_writable("", inputs); }) ==
        "an output needs a name; an empty one was given");
}

TEST_CASE("a file protected against writing is not replaced") {
  const Sandbox box;
  box.write("a.csv", "old");
  REQUIRE(chmod((box / "a.csv").c_str(), 0444) == 0);
  if (geteuid() == 0) return;  // root may write all
  CHECK_THAT(refusal([&] { write_text(box / "a.csv", "new"); }), Contains("Permission denied"));
  CHECK(text_of(box / "a.csv") == "old");
}

TEST_CASE("the next writer clears away what one that died has left, but not a living one's") {
  const Sandbox box;
  box.write("a.h5.vortree.part", "half of it");
  write(box / "a.h5", "whole", true);
  CHECK(entries(box.path()) == 1);
  {
    PartFile living(box / "a.h5", PartFile::Name::needed);
    CHECK(living.path() == box / "a.h5.vortree.part");
    write(box / "a.h5", "second", true);
    write(box / "a.h5", "third", false);
    CHECK(fs::exists(living.path()));
    std::ofstream(living.path()) << "first";
    living.put_in_place();
  }
  CHECK(text_of(box / "a.h5") == "first");
  CHECK(entries(box.path()) == 1);
}
