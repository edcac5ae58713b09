#include "app/loop/progress.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>

#include "app/say.hpp"

namespace vortree::app {
namespace {

using namespace std::chrono_literals;

constexpr double longest = 3e9;  // a century

std::string duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

/// Seconds, if they can be told.
std::optional<double> time_left(const Progress& progress, double elapsed) {
  const double done = progress.time - progress.start;
  if (!(done > 0.0) || !std::isfinite(elapsed)) return std::nullopt;
  const double left = std::max(0.0, elapsed * (progress.end - progress.time) / done);
  return left < longest ? std::optional(left) : std::nullopt;
}

/// For one who reads a log later.
std::string end_by_clock(const Progress& progress, double elapsed) {
  const std::optional<double> left = time_left(progress, elapsed);
  if (!left) return "";
  const std::time_t end = std::time(nullptr) + static_cast<std::time_t>(*left);
  return fmt::format("  ends about {:%F %H:%M}", fmt::localtime(end));
}

}  // namespace

std::string progress_line(const Progress& progress, double elapsed) {
  const std::optional<double> left = time_left(progress, elapsed);
  return fmt::format("step {}  t {:.4g}/{:.4g}  dt {:.3g}  {} {}s  ETA {}  drift {:.1e}",
                     progress.step, progress.time, progress.end, progress.dt, progress.particles,
                     progress.particle, left ? duration(*left) : "?", progress.drift);
}

ProgressLine::ProgressLine()
    : ProgressLine(isatty(STDERR_FILENO) != 0,
                   isatty(STDERR_FILENO) != 0 ? Clock::duration(200ms) : Clock::duration(30s)) {}

ProgressLine::ProgressLine(bool terminal, Clock::duration between)
    : terminal_(terminal), between_(between), last_(terminal ? start_ - between : start_) {}

ProgressLine::~ProgressLine() {
  clear();
}

void ProgressLine::show(const Progress& progress) {
  if (!due()) return;
  const double elapsed = std::chrono::duration<double>(last_ - start_).count();
  write(progress_line(progress, elapsed) + (terminal_ ? "" : end_by_clock(progress, elapsed)));
}

void ProgressLine::show_line(std::string_view line) {
  if (due()) write(line);
}

/// Whether it is time for a line; then the next one waits.
bool ProgressLine::due() {
  const auto now = Clock::now();
  if (now - last_ < between_) return false;
  last_ = now;
  return true;
}

void ProgressLine::write(std::string_view line) {
  if (!terminal_) return say_line(line);
  std::fputs(fmt::format("\r\x1b[K{}", line).c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
}

void ProgressLine::clear() {
  if (!shown_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace vortree::app
