#include "io/arrays/hdf5_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/files.hpp"
#include "io/frames/group.hpp"
#include "io/frames/hdf5.hpp"
#include "io/frames/hdf5_inside.hpp"
#include "io/input_error.hpp"
#include "io/quote.hpp"

namespace vortree::io {
namespace {

h5::Handle opened(const std::filesystem::path& path) {
  require_regular_file(path);
  if (!h5::is_hdf5(path)) throw InputError(path.string() + " is not an HDF5 file");
  try {
    return h5::open_file(path);
  } catch (const h5::Failure&) {
    throw InputError(path.string() + " is HDF5, but damaged or cut short: it cannot be opened");
  }
}

std::vector<std::uint64_t> shape_of(hid_t set) {
  const h5::Handle space(H5Dget_space(set));
  std::vector<hsize_t> shape(std::max(H5Sget_simple_extent_ndims(space), 0));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return {shape.begin(), shape.end()};
}

class Hdf5Datasets : public ArrayFile {
 public:
  explicit Hdf5Datasets(const std::filesystem::path& path) : file_(opened(path)) {
    if (has("x") || has("points")) return;
    if (const auto frames = frame_places(file_).size(); frames > 0)
      throw InputError(
          fmt::format("{0} has {1} frames of a run; which of them? {0}::last, or {0}::"
                      "0 for the first",
                      path.string(), frames));
  }

  std::string_view noun() const override { return "dataset"; }

  std::vector<std::string> names(std::size_t most) override {
    std::vector<std::string> found;
    for (auto& link : h5::links(file_, most)) found.push_back(shortened(link.name, 40));
    return found;
  }

  bool has(const std::string& name) override { return h5::has(file_, name); }

  ArrayLayout layout(const std::string& name) override {
    const h5::Handle& set = dataset(name);
    const h5::Handle type(H5Dget_type(set));
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT)
      throw h5::Failure(fmt::format("{} does not hold numbers", name));
    (void)h5::believed_count(set, name);
    return {.shape = shape_of(set), .of_integers = kind == H5T_INTEGER};
  }

  std::vector<double> read(const std::string& name, std::uint64_t column) override {
    const h5::Handle& set = dataset(name);
    const std::vector<std::uint64_t> shape = shape_of(set);
    std::vector<double> all = h5::read_dataset(set, name);
    if (shape.size() < 2) return all;
    for (std::size_t row = 0; row < shape[0]; ++row) all[row] = all[row * shape[1] + column];
    all.resize(shape[0]);
    return all;
  }

 private:
  const h5::Handle& dataset(const std::string& name) {
    const auto [at, fresh] = sets_.try_emplace(name);
    if (fresh) at->second = h5::open_dataset(file_, name);
    return at->second;
  }

  h5::Handle file_;
  std::map<std::string, h5::Handle> sets_;
};

}  // namespace

std::unique_ptr<ArrayFile> open_hdf5(const std::filesystem::path& path) {
  return std::make_unique<Hdf5Datasets>(path);
}

}  // namespace vortree::io
