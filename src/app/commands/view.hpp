#pragma once

#include <filesystem>
#include <string>

namespace vortree::app {

/// out        the page; DIR/view.html if it is not said
/// overwrite  replace a file that is there by another name
/// live       no file: the page is served on 127.0.0.1 while the run goes on
/// port       where; 0: one that is free
struct ViewJob {
  std::filesystem::path folder, out;
  bool overwrite = false, live = false;
  int port = 0;
};

/// A page that shows a run in a browser, from a file alone: its blobs as a field of vorticity, or
/// its particles, in time, with bodies, quadtree cells, drag and lift. It takes the place of an
/// older one when it is complete. Shows progress on standard error.
///
/// live: this process becomes the server of the page, which ends with 0 when it is interrupted.
///
/// returns  what was made, in a line
/// throws   io::InputError: no folder, no run, no frames, a file by another name than FILE.html or
///          one that is there and not to be replaced; std::runtime_error if it cannot be written
std::string view(ViewJob job);

}  // namespace vortree::app
