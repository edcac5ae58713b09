#include "io/frames/file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "io/frames/checksum.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t frames_foreseen = 4096;
constexpr std::size_t longest_text = 60000;  // HDF5 keeps an attribute in 64 KiB

/// The table of names is as long as a B-tree leaf may be, and the heap of names has room for all,
/// so that both stay where they are put first: at the beginning of the file.
h5::Handle roomy_root() {
  h5::Handle creation = h5::own(H5Pcreate(H5P_FILE_CREATE), "a property list");
  constexpr std::size_t bytes_of_a_name = 16;
  h5::check(H5Pset_sym_k(creation, 0, frames_foreseen / 2), "a property list");
  h5::check(H5Pset_local_heap_size_hint(creation, (frames_foreseen + 4) * bytes_of_a_name),
            "a property list");
  return creation;
}

/// The dimension of each column. As the first link of the root it also fixes the place of the table
/// of names before any frame.
void write_units(hid_t file, const flow::Columns& columns) {
  h5::Handle units = h5::create_group(file, "units");
  for (const flow::Column& column : columns) h5::write_attribute(units, column.name, column.unit);
  h5::write_attribute(units, "time", std::string("T"));
  h5::close(std::move(units), "units");
}

std::uint64_t checksum(const RunInfo& info) {
  Checksum sum;
  for (const std::string* text :
       {&info.version, &info.scene_path, &info.scene, &info.resolved, &info.units})
    sum.add(*text);
  sum.add(fmt::format("{}", fmt::join(info.overrides, "\n")));
  sum.add(static_cast<std::uint64_t>(info.seed));
  return sum.value();
}

void require_short(const RunInfo& info, std::string_view what, std::string_view text) {
  if (text.size() > longest_text) {
    throw InputError(fmt::format("{}: the {} has {} bytes; a frames file keeps {} at most",
                                 info.scene_path, what, text.size(), longest_text));
  }
}

}  // namespace

void write_empty_frames(const fs::path& path, const RunInfo& info, const flow::Columns& columns) {
  const std::string overrides = fmt::format("{}", fmt::join(info.overrides, "\n"));
  require_short(info, "scene", info.scene);
  require_short(info, "resolved scene", info.resolved);
  require_short(info, "list of overrides", overrides);
  h5::Handle file = h5::create_file(path, roomy_root());
  h5::write_attribute(file, "version", info.version);
  h5::write_attribute(file, "scene_path", info.scene_path);
  h5::write_attribute(file, "scene", info.scene);
  h5::write_attribute(file, "resolved", info.resolved);
  h5::write_attribute(file, "overrides", overrides);
  h5::write_attribute(file, "seed", info.seed);
  h5::write_attribute(file, "units", info.units);
  h5::write_attribute(file, "checksum", checksum(info));
  write_units(file, columns);
  h5::close_file(std::move(file), path);
}

RunInfo read_run_info(hid_t file) {
  RunInfo info{.version = h5::read_string(file, "version"),
               .scene_path = h5::read_string(file, "scene_path"),
               .scene = h5::read_string(file, "scene"),
               .resolved = h5::read_string(file, "resolved"),
               .overrides = {},
               .seed = h5::read_integer(file, "seed"),
               .units = h5::read_string(file, "units")};
  std::string_view rest;
  const std::string overrides = h5::read_string(file, "overrides");
  for (rest = overrides; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    info.overrides.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return info;
}

bool agrees_with_checksum(hid_t file, const RunInfo& info) {
  return !h5::has_attribute(file, "checksum") ||
         h5::read_unsigned(file, "checksum") == checksum(info);
}

}  // namespace vortree::io
