#include "app/loop/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace vortree::app {
namespace {

constexpr double longest = 3e9;  // a century

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string time_left(const Progress& progress, double elapsed) {
  const double done = progress.time - progress.start;
  if (!(done > 0.0) || !std::isfinite(elapsed)) return "?";
  const double left = std::max(0.0, elapsed * (progress.end - progress.time) / done);
  return left < longest ? duration(left) : "?";
}

}  // namespace

std::string progress_line(const Progress& progress, double elapsed) {
  return fmt::format("step {}  t {:.4g}/{:.4g}  dt {:.3g}  {} particles  ETA {}  drift {:.1e}",
                     progress.step, progress.time, progress.end, progress.dt, progress.particles,
                     time_left(progress, elapsed), progress.drift);
}

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  clear();
}

void ProgressLine::show(const Progress& progress) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (!terminal_ || (shown_ && now - last_ < 200ms)) return;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  std::fputs(("\r\x1b[K" + progress_line(progress, elapsed)).c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
  last_ = now;
}

void ProgressLine::clear() {
  if (!shown_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace vortree::app
