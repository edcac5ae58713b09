#include <fmt/format.h>

#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/arrays/npy.hpp"
#include "io/arrays/zip.hpp"
#include "io/files.hpp"
#include "io/frames/hdf5.hpp"
#include "io/tables/particles.hpp"

// How columns become files; how files are read stands in particles.cpp.

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

void write_hdf5(const fs::path& path, std::span<const ParticleColumn> columns,
                const Attributes& about) {
  h5::Handle file = h5::create_file(path);
  for (const ParticleColumn& column : columns) {
    std::visit([&](const auto& values) { h5::write(file, column.name, values); }, column.values);
  }
  for (const auto& entry : about) {
    std::visit([&](const auto& v) { h5::write_attribute(file, entry.first, v); }, entry.second);
  }
  h5::close_file(std::move(file), path);
}

std::string npz_text(std::span<const ParticleColumn> columns) {
  std::vector<ZipEntry> entries;
  for (const ParticleColumn& column : columns)
    std::visit(
        [&](auto values) {
          entries.push_back({column.name + ".npy", npy_of(values)});
        },
        column.values);
  return zip_of(entries);
}

std::size_t length_of(const ParticleColumn& column) {
  return std::visit([](auto values) { return values.size(); }, column.values);
}

std::string csv_text(std::span<const ParticleColumn> columns) {
  const std::size_t rows = columns.empty() ? 0 : length_of(columns.front());
  std::string text;
  for (const ParticleColumn& column : columns) {
    if (length_of(column) != rows)
      throw std::invalid_argument("columns of a .csv must have one length: " + column.name);
    text += (text.empty() ? "" : ",") + column.name;
  }
  for (std::size_t i = 0; i < rows; ++i) {
    char between = '\n';
    for (const ParticleColumn& column : columns) {
      text += std::exchange(between, ',');
      std::visit([&](auto values) { fmt::format_to(std::back_inserter(text), "{}", values[i]); },
                 column.values);
    }
  }
  return text += '\n';
}

}  // namespace

void require_writable_format(const fs::path& path) {
  if (format_of(path) == ParticleFormat::npy)
    throw InputError(path.string() + ": an .npy holds one array; .npz, .csv or .h5 was expected");
}

void write_columns(const fs::path& path, std::span<const ParticleColumn> columns,
                   const Attributes& about) try {
  require_writable_format(path);
  require_writable(path);
  switch (format_of(path)) {
    case ParticleFormat::csv:
      return write_text(path, csv_text(columns));
    case ParticleFormat::npz:
      return write_text(path, npz_text(columns));
    default:
      break;
  }
  h5::replace_file(path, [&](const fs::path& fresh) { write_hdf5(fresh, columns, about); });
} catch (const BadArray& bad) {
  throw InputError(fmt::format("{}: {}", path.string(), bad.what()));
}

}  // namespace vortree::io
