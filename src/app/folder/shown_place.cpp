#include "app/folder/shown_place.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "io/files.hpp"
#include "io/input_error.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

/// What the run has left, and whatever else is there, but for files of that suffix.
std::vector<fs::path> others_in(const fs::path& folder, std::string_view suffix) {
  std::vector<fs::path> others;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable))
    if (entry.path().extension() != suffix) others.push_back(entry.path());
  return others;
}

void require_named_place(const fs::path& out, std::string_view suffix) {
  if (out.extension() != suffix)
    throw io::InputError(
        fmt::format("--out {}: expected a name that ends in {}", out.string(), suffix));
  std::error_code error;
  if (!fs::is_directory(io::folder_of(out), error))
    throw io::InputError(fmt::format("--out {}: no such folder", out.string()));
}

}  // namespace

void require_shown_place(const fs::path& out, std::string_view suffix, const fs::path& run) {
  require_named_place(out, suffix);
  io::require_writable(out, others_in(run, suffix));
  if (!io::keeps_suffix(out))
    throw io::InputError(
        fmt::format("{} is a link to {}, which is no {} file; the output would destroy it",
                    out.string(), io::target_of(out).string(), suffix));
}

}  // namespace vortree::app
