#include "io/particles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/files.hpp"
#include "io/hdf5.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

/// One file being read; every complaint begins with its name.
class Reader {
 public:
  explicit Reader(const fs::path& path) : path_(path) {
    require_file(path);
    if (!h5::is_hdf5(path)) throw InputError(path.string() + " is not an HDF5 file");
    try {
      file_ = h5::open_file(path);
    } catch (const h5::Failure&) {
      throw InputError(path.string() + " is HDF5, but damaged or cut short: it cannot be opened");
    }
  }

  std::vector<double> column(const std::string& name, Need need,
                             std::optional<std::size_t> length = {}) const {
    if (need == Need::unused) return {};
    if (!h5::has(file_, name)) {
      if (need == Need::optional) return {};
      refuse(fmt::format("there is no dataset {}; the file has {}", name, what_is_there()));
    }
    require_line_of_numbers(name);
    std::vector<double> values;
    try {
      values = h5::read(file_, name);
    } catch (const h5::Failure&) {
      refuse(fmt::format("{} cannot be read: the file is damaged", name));
    }
    if (length && values.size() != *length) {
      refuse(fmt::format("{} has {} values, but x has {}", name, values.size(), *length));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i])) {
        refuse(fmt::format("{}[{}] is {}; finite numbers were expected", name, i, values[i]));
      }
    }
    return values;
  }

  template <class Holds>
  void require(const std::string& name, std::span<const double> values, Holds holds,
               std::string_view words) const {
    const auto bad = std::find_if_not(values.begin(), values.end(), holds);
    if (bad != values.end()) {
      refuse(fmt::format("{}[{}] is {}; it must be {}", name, bad - values.begin(), *bad, words));
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& words) const {
    throw InputError(fmt::format("{}: {}", path_.string(), words));
  }

  std::string what_is_there() const {
    std::vector<std::string> found;
    for (const auto& [index, name] : h5::links(file_)) found.push_back(name);
    return found.empty() ? "none" : fmt::format("{}", fmt::join(found, ", "));
  }

  void require_line_of_numbers(const std::string& name) const {
    const h5::Handle set(H5Dopen2(file_, name.c_str(), H5P_DEFAULT));
    if (set < 0) refuse(fmt::format("{} is not a dataset", name));
    const h5::Handle type(H5Dget_type(set));
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) {
      refuse(fmt::format("{} does not hold numbers", name));
    }
    const h5::Handle space(H5Dget_space(set));
    const int dimensions = H5Sget_simple_extent_ndims(space);
    if (dimensions == 1) return;
    std::vector<hsize_t> shape(std::max(dimensions, 0));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    refuse(fmt::format("{} has {} dimensions ({}); one was expected", name, shape.size(),
                       fmt::join(shape, " x ")));
  }

  fs::path path_;
  h5::Handle file_;
};

void write_all(const fs::path& path, std::span<const Column> columns, const Attributes& about) {
  h5::Handle file = h5::create_file(path);
  for (const Column& column : columns) {
    std::visit([&](const auto& values) { h5::write(file, column.name, values); }, column.values);
  }
  for (const auto& [name, value] : about) {
    std::visit([&](const auto& v) { h5::write_attribute(file, name, v); }, value);
  }
  h5::close_file(std::move(file), path);
}

}  // namespace

Particles read_particles(const fs::path& path, Columns columns) {
  const Reader reader(path);
  Particles p;
  p.x = reader.column("x", Need::required);
  const std::size_t n = p.x.size();
  p.y = reader.column("y", Need::required, n);
  p.gamma = reader.column("gamma", columns.gamma, n);
  p.sigma = reader.column("sigma", columns.sigma, n);
  p.reach = reader.column("reach", columns.reach, n);
  reader.require(
      "sigma", p.sigma, [](double v) { return v >= 0; }, ">= 0");
  reader.require(
      "reach", p.reach, [](double v) { return v >= 0; }, ">= 0");
  return p;
}

void write_columns(const fs::path& path, std::span<const Column> columns, const Attributes& about) {
  check_writable(path);
  replace_file(path, [&](const fs::path& fresh) { write_all(fresh, columns, about); });
}

void check_writable(const fs::path& path) {
  require_writable(path);
}

}  // namespace vortree::io
