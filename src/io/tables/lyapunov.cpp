#include "io/tables/lyapunov.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <vector>

#include "io/files.hpp"
#include "io/frames/hdf5.hpp"
#include "io/frames/xdmf.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

using OfOneTime = std::vector<const flow::LyapunovField*>;

std::map<double, OfOneTime> by_time(std::span<const flow::LyapunovField> fields) {
  std::map<double, OfOneTime> all;
  for (const flow::LyapunovField& field : fields) all[field.from].push_back(&field);
  return all;
}

std::string group_name(double time) {
  return fmt::format("lyapunov_{}", time);
}

std::string way(const flow::LyapunovField& field) {
  return field.to > field.from ? "forward" : "backward";
}

void write_axes(hid_t group, const flow::PictureGrid& grid) {
  std::vector<double> x, y;
  for (int column = 0; column < grid.columns; ++column) x.push_back(grid.point(0, column).x);
  for (int row = 0; row < grid.rows; ++row) y.push_back(grid.point(row, 0).y);
  h5::write(group, "x", std::span<const double>(x));
  h5::write(group, "y", std::span<const double>(y));
}

void write_group(hid_t file, double time, const OfOneTime& fields) {
  h5::append_group(file, group_name(time), [&](hid_t group) {
    const flow::PictureGrid& grid = fields.front()->grid;
    write_axes(group, grid);
    h5::write_attribute(group, "time", time);
    for (const flow::LyapunovField* field : fields) {
      h5::write_grid(group, way(*field), field->exponent, grid.rows, grid.columns);
      h5::write_attribute(group, way(*field) + "_to", field->to);
    }
  });
}

FieldLabel label(double time, const OfOneTime& fields) {
  FieldLabel made{.name = group_name(time),
                  .time = time,
                  .rows = static_cast<std::size_t>(fields.front()->grid.rows),
                  .columns = static_cast<std::size_t>(fields.front()->grid.columns),
                  .values = {}};
  for (const flow::LyapunovField* field : fields) made.values.push_back(way(*field));
  return made;
}

void write_all(const fs::path& path, const std::map<double, OfOneTime>& all,
               const Attributes& about) {
  h5::Handle file = h5::create_file(path);
  for (const auto& [time, fields] : all) write_group(file, time, fields);
  for (const auto& [name, value] : about)
    std::visit([&, &of = name](const auto& v) { h5::write_attribute(file, of, v); }, value);
  h5::close_file(std::move(file), path);
}

}  // namespace

void write_lyapunov(const fs::path& dir, std::span<const flow::LyapunovField> fields,
                    const Attributes& about) {
  const auto all = by_time(fields);
  h5::replace_file(dir / "lyapunov.h5", [&](const fs::path& p) { write_all(p, all, about); });
  std::vector<FieldLabel> labels;
  for (const auto& [time, of] : all) labels.push_back(label(time, of));
  write_derived_text(dir / "lyapunov.xdmf", fields_xdmf_text("lyapunov.h5", labels));
}

}  // namespace vortree::io
