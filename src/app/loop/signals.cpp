#include "app/loop/signals.hpp"

#include <signal.h>

#include <array>

namespace vortree::app {
namespace {

constexpr std::array asking{SIGINT, SIGTERM, SIGHUP, SIGXCPU};

volatile sig_atomic_t received = 0;
volatile sig_atomic_t hangs_up = 1;

void kill_at_the_next() {
  for (const int signal : asking)
    if (signal != SIGHUP || hangs_up) ::signal(signal, SIG_DFL);
}

extern "C" void remember(int signal) {
  received = signal;
  kill_at_the_next();
}

}  // namespace

StopRequest::StopRequest() {
  received = 0;
  struct sigaction action = {}, before = {};
  sigaction(SIGHUP, nullptr, &before);
  hangs_up = before.sa_handler != SIG_IGN;
  action.sa_handler = remember;
  action.sa_flags = SA_RESTART;
  for (const int signal : asking)
    if (signal != SIGHUP || hangs_up) sigaction(signal, &action, nullptr);
}

StopRequest::~StopRequest() {
  kill_at_the_next();
}

int StopRequest::signal() const {
  return received;
}

}  // namespace vortree::app
