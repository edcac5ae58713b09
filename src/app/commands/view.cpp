#include "app/commands/view.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "app/folder/older_run.hpp"
#include "app/folder/shown_place.hpp"
#include "app/install_paths.hpp"
#include "app/loop/progress.hpp"
#include "app/plot.hpp"
#include "io/input_error.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

/// The page of a run is its own to replace, as its figures are.
void require_place(const ViewJob& job) {
  require_shown_place(job.out, ".html", job.folder);
  std::error_code error;
  const bool of_run = job.out == job.folder / "view.html";
  if (!job.overwrite && !of_run && fs::exists(fs::symlink_status(job.out, error)))
    throw io::InputError(
        fmt::format("{} is there already: --overwrite replaces it", job.out.string()));
}

}  // namespace

std::string view(ViewJob job) {
  require_frames(job.folder);
  if (job.live)
    become_script(view_script(),
                  {"--live", fmt::format("--port={}", job.port), "--", job.folder.string()});
  if (job.out.empty()) job.out = job.folder / "view.html";
  require_place(job);
  ProgressLine progress;
  const std::string made =
      run_script(view_script(), {"--out=" + job.out.string(), "--", job.folder.string()},
                 [&progress](std::string_view line) {
                   if (line.starts_with("frame ")) progress.show_line(line);
                 });
  progress.clear();
  return made;
}

}  // namespace vortree::app
