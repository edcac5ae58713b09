#pragma once

#include <array>
#include <csignal>
#include <filesystem>

namespace vortree::io {

/// While it is there, a file of somebody else's is being read. HDF5 1.10 crashes on some damaged
/// files; then this says which file it was, in one line, and the program leaves with exit code 2.
class WhileReading {
 public:
  explicit WhileReading(const std::filesystem::path& file);
  ~WhileReading();
  WhileReading(const WhileReading&) = delete;
  WhileReading& operator=(const WhileReading&) = delete;

 private:
  static constexpr std::array<int, 4> signals{SIGSEGV, SIGBUS, SIGFPE, SIGABRT};
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace vortree::io
