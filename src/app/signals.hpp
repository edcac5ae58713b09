#pragma once

namespace vortree::app {

/// While it lives, the first Ctrl-C (SIGINT) or SIGTERM only asks for an end; a second one kills.
/// One at a time.
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
