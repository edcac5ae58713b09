#include "app/commands/movie.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "app/folder/older_run.hpp"
#include "app/folder/shown_place.hpp"
#include "app/install_paths.hpp"
#include "app/loop/progress.hpp"
#include "app/plot.hpp"

namespace vortree::app {
namespace {

std::vector<std::string> words_of(const MovieJob& job) {
  std::vector<std::string> words{"--out=" + job.out.string(), "--what=" + job.what,
                                 fmt::format("--fps={}", job.fps),
                                 fmt::format("--size={}", job.size)};
  if (job.streamlines) words.push_back("--streamlines");
  words.insert(words.end(), {"--", job.folder.string()});
  return words;
}

}  // namespace

std::string movie(MovieJob job) {
  require_frames(job.folder);
  if (job.out.empty()) job.out = job.folder / "movie.mp4";
  require_shown_place(job.out, ".mp4", job.folder);
  ProgressLine progress;
  const std::string made =
      run_script(movie_script(), words_of(job), [&progress](std::string_view line) {
        if (line.starts_with("picture ")) progress.show_line(line);
      });
  progress.clear();
  return made;
}

}  // namespace vortree::app
