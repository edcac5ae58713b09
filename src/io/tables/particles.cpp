#include "io/tables/particles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "io/files.hpp"
#include "io/frames/hdf5.hpp"
#include "io/frames/hdf5_inside.hpp"
#include "io/quote.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

/// A column that has been looked at, but not read.
struct FoundColumn {
  std::string name;
  h5::Handle set;
  std::size_t count = 0;
  std::vector<double>* values;
  bool of_integers = false;
};

/// One file being read; every complaint begins with its name.
class Reader {
 public:
  explicit Reader(const fs::path& path) : path_(path) {
    require_regular_file(path);
    if (!h5::is_hdf5(path)) throw InputError(path.string() + " is not an HDF5 file");
    try {
      file_ = h5::open_file(path);
    } catch (const h5::Failure&) {
      throw InputError(path.string() + " is HDF5, but damaged or cut short: it cannot be opened");
    }
  }

  /// Looks at a column; `values` is where read_all will put it.
  void find(const std::string& name, Need need, std::vector<double>& values) {
    if (need == Need::unused) return;
    if (!h5::has(file_, name)) {
      if (need == Need::optional) return;
      refuse(fmt::format("there is no dataset {}; the file has {}", name, what_is_there()));
    }
    FoundColumn found{.name = name, .set = h5::open_dataset(file_, name), .values = &values};
    require_line_of_numbers(found);
    found.count = h5::believed_count(found.set, name);
    if (!found_.empty() && found.count != found_[0].count) {
      refuse(fmt::format("{} has {} values, but x has {}", name, found.count, found_[0].count));
    }
    found_.push_back(std::move(found));
  }

  void read_all() const {
    if (!found_.empty()) h5::require_room(found_[0].count * found_.size(), names());
    for (const FoundColumn& column : found_) {
      *column.values = h5::read_dataset(column.set, column.name);
      require(
          column, [](double v) { return std::isfinite(v); }, "finite numbers were expected");
      if (column.name == "sigma" || column.name == "reach") {
        require(
            column, [](double v) { return v >= 0; }, "it must be >= 0");
      }
      if (column.of_integers)
        require(
            column, [](double v) { return std::abs(v) < too_long; },
            "integers of 2^53 and more are read rounded, if at all: write the column as doubles");
    }
  }

 private:
  [[noreturn]] static void refuse(const std::string& words) { throw h5::Failure(words); }

  template <class Holds>
  static void require(const FoundColumn& column, Holds holds, std::string_view words) {
    const std::vector<double>& values = *column.values;
    const auto bad = std::find_if_not(values.begin(), values.end(), holds);
    if (bad != values.end()) {
      refuse(fmt::format("{}[{}] is {}; {}", column.name, bad - values.begin(), *bad, words));
    }
  }

  std::string names() const {
    std::vector<std::string_view> names;
    for (const FoundColumn& column : found_) names.push_back(column.name);
    return fmt::format("{}", fmt::join(names, " + "));
  }

  std::string what_is_there() const {
    std::vector<std::string> found;
    for (auto& link : h5::links(file_, most_links)) found.push_back(shortened(link.name, 40));
    if (found.empty()) return "none";
    if (found.size() == most_links) found.back() = "more";
    return fmt::format("{}", fmt::join(found, ", "));
  }

  static void require_line_of_numbers(FoundColumn& found) {
    const h5::Handle type(H5Dget_type(found.set));
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) {
      refuse(fmt::format("{} does not hold numbers", found.name));
    }
    found.of_integers = kind == H5T_INTEGER;
    const h5::Handle space(H5Dget_space(found.set));
    const int dimensions = H5Sget_simple_extent_ndims(space);
    if (dimensions == 1) return;
    std::vector<hsize_t> shape(std::max(dimensions, 0));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    refuse(fmt::format("{} has {} dimensions ({}); one was expected", found.name, shape.size(),
                       fmt::join(shape, " x ")));
  }

  static constexpr hsize_t most_links = 8;
  static constexpr double too_long = 0x1p53;  // from here on doubles leave integers out

  fs::path path_;
  h5::Handle file_;
  std::vector<FoundColumn> found_;
};

void write_all(const fs::path& path, std::span<const ParticleColumn> columns,
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

}  // namespace

ParticleFile read_particles(const fs::path& path, ParticleColumns columns) {
  ParticleFile p;
  try {
    Reader reader(path);
    reader.find("x", Need::required, p.x);
    reader.find("y", Need::required, p.y);
    reader.find("gamma", columns.gamma, p.gamma);
    reader.find("sigma", columns.sigma, p.sigma);
    reader.find("reach", columns.reach, p.reach);
    reader.read_all();
  } catch (const h5::Failure& failure) {
    throw InputError(fmt::format("{}: {}", path.string(), failure.what()));
  }
  return p;
}

void write_columns(const fs::path& path, std::span<const ParticleColumn> columns,
                   const Attributes& about) {
  require_writable(path);
  h5::replace_file(path, [&](const fs::path& fresh) { write_all(fresh, columns, about); });
}

}  // namespace vortree::io
