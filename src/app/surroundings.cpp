#include "app/surroundings.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <new>

#include "app/say.hpp"

namespace vortree::app {
namespace {

constexpr int failed = 1;

[[noreturn]] void end_with_a_line() {
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
    say("ended by a fault of its own");
  } catch (const std::bad_alloc&) {
    std::fputs("vortree: out of memory\n", stderr);
  } catch (const std::exception& error) {
    say("{}", error.what());
  }
  _exit(failed);
}

/// Libraries that are about to begin do not all bear it if they find no memory for that: better to
/// end here. What is given back stays with the program, for them.
void require_memory_to_begin() {
  constexpr std::size_t bytes = 1 << 23;
  void* room = std::malloc(bytes);
  if (!room) {
    std::fputs("vortree: out of memory\n", stderr);
    _exit(failed);
  }
  std::free(room);
}

}  // namespace

void bear_surroundings() {
  for (int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(number, F_GETFD) < 0) (void)!::open("/dev/null", O_RDWR);
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
  std::set_terminate(end_with_a_line);
}

void keep_freed_memory() {
  constexpr rlim_t ahead = 1 << 26;
  rlim_t pad = ahead;
  for (const auto kind : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limit = {};
    if (::getrlimit(kind, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      pad = std::min(pad, limit.rlim_cur / 64);
  }
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_TOP_PAD, static_cast<int>(pad));
  if (pad < ahead) require_memory_to_begin();
}

}  // namespace vortree::app
