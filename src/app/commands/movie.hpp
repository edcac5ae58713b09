#pragma once

#include <filesystem>
#include <string>

namespace vortree::app {

/// what         "vorticity", "speed", "pressure": of each picture; "blobs": those of each frame
/// streamlines  lines of equal stream function, too
/// fps, size    pictures in a second; height in pixels
/// out          the video; DIR/movie.mp4 if it is not said
struct MovieJob {
  std::filesystem::path folder, out;
  std::string what = "vorticity";
  bool streamlines = false;
  int fps = 25, size = 720;
};

/// A video (H.264, yuv420p) of the pictures that a run has left, in one scale of colours, with the
/// bodies where they are and their drag and lift in time; beside it a small animation of five
/// seconds, .webp, or .gif if ffmpeg cannot write that. Either takes the place of an older one when
/// it is complete. Shows progress on standard error.
///
/// returns  what was made, in a line
/// throws   io::InputError: no folder, no run, fewer than ten pictures (frames), none of what is to
///         be shown, no ffmpeg, a video by another name than FILE.mp4; std::runtime_error if it
///         cannot be written
std::string movie(MovieJob job);

}  // namespace vortree::app
