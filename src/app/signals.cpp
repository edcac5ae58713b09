#include "app/signals.hpp"

#include <signal.h>

namespace vortree::app {
namespace {

volatile sig_atomic_t received = 0;

extern "C" void remember(int signal) {
  received = signal;
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
}

}  // namespace

StopRequest::StopRequest() {
  received = 0;
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

StopRequest::~StopRequest() {
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
}

int StopRequest::signal() const {
  return received;
}

}  // namespace vortree::app
