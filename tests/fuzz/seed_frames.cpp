#include "io/frames/frames.hpp"

// Usage: seed_frames FOLDER   leaves a frames.h5 of two frames there.

int main(int argc, char** argv) {
  using namespace vortree::io;
  if (argc != 2) return 2;
  const vortree::flow::Columns columns{{"x", "L", {1, 2, 3}},
                                       {"y", "L", {4, 5, 6}},
                                       {"gamma", "L^2/T", {1, -1, 1}},
                                       {"u", "L/T", {0, 0, 1}},
                                       {"v", "L/T", {0, 1, 0}}};
  create_frames(argv[1], {.version = "0",
                          .scene_path = "a.toml",
                          .scene = "seed = 1",
                          .resolved = "seed = 1",
                          .overrides = {"a=b", "c=d"},
                          .seed = 1,
                          .units = "none"},
                columns);
  for (const int step : {0, 25}) {
    append_frame(argv[1], {.step = step,
                           .time = 0.1 * step,
                           .columns = columns,
                           .state = {{"time", {1, 2}}, {"moments", {3}}}});
  }
}
