#include "io/tables/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/files.hpp"
#include "io/frames/checksum.hpp"
#include "io/frames/hdf5.hpp"
#include "io/frames/hdf5_inside.hpp"
#include "io/frames/recovered.hpp"
#include "io/frames/xdmf.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

struct NamedGrid {
  const char* name;
  std::vector<double> Field::*grid;
  bool always = true;  // there in all fields
};

constexpr std::array<NamedGrid, 5> grids{{{"u", &Field::u},
                                          {"v", &Field::v},
                                          {"omega", &Field::omega},
                                          {"psi", &Field::psi, false},
                                          {"p", &Field::p, false}}};

/// What a field has values of.
std::vector<NamedGrid> grids_of(const Field& field) {
  std::vector<NamedGrid> there;
  for (const NamedGrid& one : grids)
    if (one.always || !(field.*one.grid).empty()) there.push_back(one);
  return there;
}

fs::path fields_path(const fs::path& dir) {
  return dir / "fields.h5";
}

std::string field_name(double time) {
  return fmt::format("field_{}", time);
}

void require_sizes(const Field& field) {
  for (const auto& [name, grid, always] : grids_of(field)) {
    if ((field.*grid).size() != field.x.size() * field.y.size()) {
      throw std::invalid_argument(fmt::format("field of t = {}: {} has {} values on a grid {} x {}",
                                              field.time, name, (field.*grid).size(),
                                              field.y.size(), field.x.size()));
    }
  }
}

std::uint64_t checksum(const Field& field) {
  Checksum sum;
  sum.add(field.time);
  sum.add(field.x);
  sum.add(field.y);
  for (const auto& [name, grid, always] : grids_of(field)) sum.add(field.*grid);
  return sum.value();
}

void write_field(hid_t file, const Field& field) {
  h5::append_group(file, field_name(field.time), [&](hid_t group) {
    h5::write(group, "x", field.x);
    h5::write(group, "y", field.y);
    for (const auto& [name, grid, always] : grids_of(field)) {
      h5::write_grid(group, name, field.*grid, field.y.size(), field.x.size());
    }
    h5::write_attribute(group, "time", field.time);
    h5::write_attribute(group, "checksum", checksum(field));
  });
}

Field read_group(hid_t file, const std::string& name) {
  const h5::Handle group = h5::own(H5Gopen2(file, name.c_str(), H5P_DEFAULT), name);
  Field field;
  field.time = h5::read_double(group, "time");
  field.x = h5::read(group, "x");
  field.y = h5::read(group, "y");
  for (const auto& [column, grid, always] : grids)
    if (always || h5::has(group, column)) field.*grid = h5::read(group, column);
  // Fields of earlier versions have none.
  if (h5::has_attribute(group, "checksum") &&
      h5::read_unsigned(group, "checksum") != checksum(field)) {
    throw h5::Failure(name + " does not agree with its checksum");
  }
  return field;
}

using NamedTimes = std::vector<std::pair<double, std::string>>;

/// The fields whose time can be read, ascending.
NamedTimes list(hid_t file) {
  NamedTimes found;
  for (const auto& [index, name] : h5::links(file)) {
    try {
      const h5::Handle group = h5::own(H5Gopen2(file, name.c_str(), H5P_DEFAULT), name);
      found.emplace_back(h5::read_double(group, "time"), name);
    } catch (const h5::NotTheFile& refused) {
      throw std::runtime_error(fmt::format("{}: {}", h5::file_name(file), refused.what()));
    } catch (const h5::Failure&) {
      continue;
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<Field> read_if_good(hid_t file, const std::string& name) {
  try {
    return read_group(file, name);
  } catch (const h5::NotTheFile& refused) {
    throw std::runtime_error(
        fmt::format("{}: {}: {}; nothing was changed", h5::file_name(file), name, refused.what()));
  } catch (const h5::Failure&) {
    return std::nullopt;
  }
}

std::size_t length_of(hid_t group, const char* name) {
  return h5::believed_count(h5::open_dataset(group, name), name);
}

/// Of a file that has just been written: a field that cannot be read back is a failure, no damage.
void refresh_xdmf(const fs::path& dir) {
  const fs::path path = fields_path(dir);
  std::vector<FieldLabel> labels;
  try {
    const h5::Handle file = h5::open_file(path);
    for (const auto& [index, name] : h5::links(file)) {
      const h5::Handle group = h5::own(H5Gopen2(file, name.c_str(), H5P_DEFAULT), name);
      labels.push_back({.name = name,
                        .time = h5::read_double(group, "time"),
                        .rows = length_of(group, "y"),
                        .columns = length_of(group, "x")});
      for (const NamedGrid& one : grids)
        if (!one.always && h5::has(group, one.name)) labels.back().values.emplace_back(one.name);
    }
  } catch (const h5::Failure& failure) {
    throw std::runtime_error(
        fmt::format("{} cannot be read back ({})", path.string(), failure.what()));
  }
  std::ranges::sort(labels, {}, &FieldLabel::time);
  write_derived_text(dir / "fields.xdmf", fields_xdmf_text("fields.h5", labels));
}

}  // namespace

void append_field(const fs::path& dir, const Field& field) {
  require_sizes(field);
  const fs::path path = fields_path(dir);
  try {
    if (!fs::exists(path)) {
      h5::replace_file(path, [&](const fs::path& fresh) {
        h5::Handle file = h5::create_file(fresh);
        write_field(file, field);
        h5::close_file(std::move(file), fresh);
      });
      refresh_xdmf(dir);
      return;
    }
    h5::Handle file = h5::open_file(path, H5F_ACC_RDWR);
    if (h5::has(file, field_name(field.time))) {
      throw std::invalid_argument(
          fmt::format("{} has a field of t = {} already", path.string(), field.time));
    }
    write_field(file, field);
    h5::close_file(std::move(file), path);
    refresh_xdmf(dir);
  } catch (const h5::Failure& failure) {
    throw std::runtime_error(fmt::format("{}: the field of t = {} cannot be saved ({})",
                                         path.string(), field.time, failure.what()));
  }
}

std::vector<double> field_times(const fs::path& dir) {
  const fs::path path = fields_path(dir);
  std::vector<double> times;
  if (!fs::exists(path)) return times;
  const MendedFile mended = open_mended(path);
  if (mended.file < 0) return times;
  for (const auto& [time, name] : list(mended.file)) times.push_back(time);
  return times;
}

Field read_field(const fs::path& dir, double time) {
  const fs::path path = fields_path(dir);
  const MendedFile mended = open_mended(path);
  try {
    return read_group(mended.file, field_name(time));
  } catch (const h5::Failure&) {
    throw InputError(
        fmt::format("{} has no field of t = {} that can be read", path.string(), time));
  }
}

std::vector<double> rewind_fields(const fs::path& dir, double time) {
  const fs::path path = fields_path(dir);
  std::vector<double> kept;
  if (!fs::exists(path)) return kept;
  const MendedFile mended = open_mended(path);
  h5::replace_file(path, [&](const fs::path& fresh) {
    h5::Handle healthy = h5::create_file(fresh);
    for (const auto& [at, name] : mended.file >= 0 ? list(mended.file) : NamedTimes{}) {
      if (at > time) break;
      const auto field = read_if_good(mended.file, name);
      if (!field) continue;
      write_field(healthy, *field);
      kept.push_back(field->time);
    }
    h5::close_file(std::move(healthy), fresh);
  });
  refresh_xdmf(dir);
  return kept;
}

}  // namespace vortree::io
