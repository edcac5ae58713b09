#include "io/tables/particles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

#include "io/arrays/csv_file.hpp"
#include "io/arrays/frame_file.hpp"
#include "io/arrays/hdf5_file.hpp"
#include "io/arrays/npy_file.hpp"
#include "io/arrays/npz_file.hpp"
#include "io/files.hpp"
#include "io/frames/hdf5.hpp"
#include "io/frames/hdf5_inside.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

/// A column that has been looked at, but not read.
struct FoundColumn {
  std::string name, array;   // gamma; the array that it is a part of
  std::uint64_t column = 0;  // of that array
  ArrayLayout layout;
  std::vector<double>* values;
};

/// One file being read.
class ColumnReader {
 public:
  explicit ColumnReader(ArrayFile& file) : file_(file) {}

  /// x and y, as they are, or rows of both under one name; the vectors are where read_all will put
  /// them.
  void find_points(std::vector<double>& x, std::vector<double>& y) {
    if (!file_.has("y")) {
      for (const std::string name : {"x", "points"}) {
        if (!file_.has(name)) continue;
        ArrayLayout rows = file_.layout(name);
        if (name == "x" && rows.shape.size() == 1) break;  // and there is no y
        require_pairs(name, rows);
        add({.name = "x", .array = name, .layout = rows, .values = &x});
        return add({.name = "y", .array = name, .column = 1, .layout = rows, .values = &y});
      }
    }
    find("x", Need::required, x);
    find("y", Need::required, y);
  }

  void find(const std::string& name, Need need, std::vector<double>& values) {
    if (need == Need::unused) return;
    if (!file_.has(name)) {
      if (need == Need::optional) return;
      refuse(
          fmt::format("there is no {} {}; the file has {}", file_.noun(), name, what_is_there()));
    }
    ArrayLayout layout = file_.layout(name);
    const bool of_all = layout.shape.empty() && (name == "sigma" || name == "reach");
    if (!of_all) require_line(name, layout);
    add({.name = name, .array = name, .layout = std::move(layout), .values = &values});
  }

  void read_all() const {
    h5::require_room(count_ * found_.size(), names());
    for (const FoundColumn& column : found_) {
      *column.values = file_.read(column.array, column.column);
      require_good(column);
      if (column.layout.shape.empty()) column.values->assign(count_, column.values->front());
    }
  }

 private:
  [[noreturn]] static void refuse(const std::string& words) { throw BadArray(words); }

  void add(FoundColumn found) {
    if (!found.layout.shape.empty()) {
      const std::uint64_t count = found.layout.shape[0];
      if (!found_.empty() && count != count_)
        refuse(fmt::format("{} has {} values, but x has {}", found.name, count, count_));
      count_ = count;
    }
    found_.push_back(std::move(found));
  }

  static void require_line(const std::string& name, const ArrayLayout& layout) {
    if (layout.shape.size() == 1) return;
    refuse(fmt::format("{} has {} dimensions ({}); one was expected", name, layout.shape.size(),
                       fmt::join(layout.shape, " x ")));
  }

  static void require_pairs(const std::string& name, const ArrayLayout& layout) {
    if (layout.shape.size() == 2 && layout.shape[1] == 2) return;
    refuse(fmt::format("{} has {} dimensions ({}); without y, n x 2 was expected", name,
                       layout.shape.size(), fmt::join(layout.shape, " x ")));
  }

  void require_good(const FoundColumn& column) const {
    require(
        column, [](double v) { return std::isfinite(v); }, "finite numbers were expected");
    if (column.name == "sigma" || column.name == "reach")
      require(
          column, [](double v) { return v >= 0; }, "it must be >= 0");
    if (column.layout.of_integers)
      require(
          column, [](double v) { return std::abs(v) < too_long; },
          "integers of 2^53 and more are read rounded, if at all: write the column as doubles");
  }

  template <class Holds>
  void require(const FoundColumn& column, Holds holds, std::string_view words) const {
    const std::vector<double>& values = *column.values;
    const auto bad = std::find_if_not(values.begin(), values.end(), holds);
    if (bad == values.end()) return;
    const std::string place =
        column.layout.shape.empty()
            ? column.name
            : file_.place(column.name, static_cast<std::size_t>(bad - values.begin()));
    refuse(fmt::format("{} is {}; {}", place, *bad, words));
  }

  std::string names() const {
    std::vector<std::string_view> names;
    for (const FoundColumn& column : found_) names.push_back(column.name);
    return fmt::format("{}", fmt::join(names, " + "));
  }

  std::string what_is_there() const {
    std::vector<std::string> found = file_.names(most_names);
    if (found.empty()) return "none";
    if (found.size() == most_names) found.back() = "more";
    return fmt::format("{}", fmt::join(found, ", "));
  }

  static constexpr std::size_t most_names = 8;
  static constexpr double too_long = 0x1p53;  // from here on doubles leave integers out

  ArrayFile& file_;
  std::uint64_t count_ = 0;
  std::vector<FoundColumn> found_;
};

/// In the order that the rows of an .npy have.
std::vector<std::string_view> wanted(const ParticleColumns& columns) {
  std::vector<std::string_view> names{"x", "y"};
  if (columns.gamma != Need::unused) names.push_back("gamma");
  if (columns.sigma != Need::unused) names.push_back("sigma");
  if (columns.reach != Need::unused) names.push_back("reach");
  return names;
}

void refuse_run(const fs::path& path) {
  std::error_code unknown;
  if (fs::is_directory(path, unknown) && fs::exists(path / "frames.h5", unknown))
    throw InputError(
        fmt::format("{0} is the folder of a run; which of its frames? {0}::last, or "
                    "{0}::0 for the first",
                    path.string()));
}

std::unique_ptr<ArrayFile> open(const fs::path& path, const ParticleColumns& columns) {
  if (const auto pointer = frame_pointer(path)) return open_frame(*pointer);
  refuse_run(path);
  const std::vector<std::string_view> names = wanted(columns);
  switch (format_of(path)) {
    case ParticleFormat::csv:
      return open_csv(path, names);
    case ParticleFormat::npy:
      return open_npy(path, {names.begin(), names.end()});
    case ParticleFormat::npz:
      return open_npz(path);
    case ParticleFormat::hdf5:
      break;
  }
  return open_hdf5(path);
}

ParticleFile read(ArrayFile& file, const ParticleColumns& columns) {
  ParticleFile p;
  ColumnReader reader(file);
  reader.find_points(p.x, p.y);
  reader.find("gamma", columns.gamma, p.gamma);
  reader.find("sigma", columns.sigma, p.sigma);
  reader.find("reach", columns.reach, p.reach);
  reader.read_all();
  return p;
}

}  // namespace

ParticleFormat format_of(const fs::path& path) {
  const fs::path suffix = path.extension();
  if (suffix == ".csv") return ParticleFormat::csv;
  if (suffix == ".npy") return ParticleFormat::npy;
  return suffix == ".npz" ? ParticleFormat::npz : ParticleFormat::hdf5;
}

fs::path file_behind(const fs::path& word) {
  const auto pointer = frame_pointer(word);
  return pointer ? pointer->file : word;
}

ParticleFile read_particles(const fs::path& path, ParticleColumns columns) {
  const auto refuse = [&](const std::exception& bad) -> ParticleFile {
    throw InputError(fmt::format("{}: {}", path.string(), bad.what()));
  };
  try {
    return read(*open(path, columns), columns);
  } catch (const h5::Failure& failure) {
    return refuse(failure);
  } catch (const BadArray& bad) {
    return refuse(bad);
  }
}

}  // namespace vortree::io
