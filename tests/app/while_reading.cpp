#include "io/while_reading.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdio>

#include "app/program.hpp"

using namespace vortree::test;

TEST_CASE("a crash inside of a reader is told in one line, with exit code 2") {
  const TemporaryFolder folder;
  const int signal = GENERATE(SIGSEGV, SIGBUS, SIGFPE, SIGABRT);
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    if (!std::freopen((folder / "err").c_str(), "w", stderr)) _exit(3);
    const vortree::io::WhileReading reading("a\x1b.h5");
    std::raise(signal);
    _exit(4);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 2);
  CHECK(text_of(folder / "err") ==
        "vortree: a\\x1b.h5: the file is damaged: HDF5 itself fails on it\n");
}
