#include "io/frames/frames.hpp"

// Usage: seed_frames FOLDER   leaves a frames.h5 of two frames there.

int main(int argc, char** argv) {
  using namespace vortree::io;
  if (argc != 2) return 2;
  create_frames(argv[1], {.version = "0",
                          .scene_path = "a.toml",
                          .scene = "seed = 1",
                          .resolved = "seed = 1",
                          .overrides = {"a=b", "c=d"},
                          .seed = 1,
                          .units = "none"});
  for (const int step : {0, 25}) {
    append_frame(argv[1], {.step = step,
                           .time = 0.1 * step,
                           .x = {1, 2, 3},
                           .y = {4, 5, 6},
                           .gamma = {1, -1, 1},
                           .sigma = {0.1, 0.1, 0.1},
                           .u = {0, 0, 1},
                           .v = {0, 1, 0},
                           .state = {{"time", {1, 2}}, {"moments", {3}}}});
  }
}
