#pragma once

#include <bit>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "io/frames/frames.hpp"
#include "io/sandbox.hpp"

namespace vortree::test {

using io::Frame;
using io::RunInfo;

inline const RunInfo info{.version = "0.1.0",
                          .scene_path = "cases/ring.toml",
                          .scene = "[flow]\nnu = 1 # Größe\n",
                          .resolved = "",
                          .overrides = {"flow.nu=2", "title=Two vortices"},
                          .seed = 7,
                          .units = "D = 1, U = 1"};

inline Frame frame_of(std::int64_t step, std::size_t blobs) {
  std::mt19937_64 random(static_cast<std::uint64_t>(step));
  std::normal_distribution<double> normal;
  const auto draw = [&](std::size_t n) {
    std::vector<double> values(n);
    for (double& value : values) value = normal(random);
    return values;
  };
  return {.step = step,
          .time = 0.01 * static_cast<double>(step),
          .columns = {{"x", "L", draw(blobs)},
                      {"y", "L", draw(blobs)},
                      {"gamma", "L^2/T", draw(blobs)},
                      {"sigma", "L", draw(blobs)},
                      {"u", "L/T", draw(blobs)},
                      {"v", "L/T", draw(blobs)}},
          .state = {{"sheet", draw(5)}, {"nothing", {}}, {"kappa", {std::nan(""), -0.0}}}};
}

inline bool same(const Frame& a, const Frame& b) {
  // NaN must come back too, so the state is compared by its bits.
  const auto bits = [](const Frame& f) {
    std::map<std::string, std::vector<std::uint64_t>> words;
    for (const auto& [name, values] : f.state) {
      for (const double v : values) words[name].push_back(std::bit_cast<std::uint64_t>(v));
      words[name];
    }
    return words;
  };
  return a.step == b.step && a.time == b.time && a.columns == b.columns && bits(a) == bits(b);
}

inline std::filesystem::path frames_in(const Sandbox& box) {
  return box / "frames.h5";
}

/// Frames of steps 0, 25, 50, ... and how long the file was after each.
inline std::vector<std::uintmax_t> write_run(const Sandbox& box, std::size_t frames,
                                             std::size_t blobs) {
  io::create_frames(box.path(), info, frame_of(0, 0).columns);
  std::vector<std::uintmax_t> ends;
  for (std::size_t k = 0; k < frames; ++k) {
    io::append_frame(box.path(), frame_of(25 * static_cast<std::int64_t>(k), blobs + 10 * k));
    ends.push_back(std::filesystem::file_size(frames_in(box)));
  }
  return ends;
}

}  // namespace vortree::test
