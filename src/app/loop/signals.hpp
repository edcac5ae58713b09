#pragma once

namespace vortree::app {

/// While it lives, the first signal that asks for an end only asks: Ctrl-C (SIGINT), SIGTERM, the
/// terminal that goes (SIGHUP, unless nohup had it ignored), the processor time that is used up
/// (SIGXCPU). A second one kills. One at a time.
class StopRequest {
 public:
  StopRequest();
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// Has the user asked for an end?
  explicit operator bool() const { return signal() != 0; }

  /// The signal that asked, 0 if none did.
  int signal() const;
};

}  // namespace vortree::app
