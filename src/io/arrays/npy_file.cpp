#include "io/arrays/npy_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "io/arrays/mapped_file.hpp"
#include "io/arrays/npy.hpp"
#include "io/quote.hpp"

namespace vortree::io {
namespace {

class NpyColumns : public ArrayFile {
 public:
  NpyColumns(const std::filesystem::path& path, std::vector<std::string> in_order)
      : file_(path), header_(read_npy_header(file_.bytes())) {
    if (header_.of_records) {
      require_a_line();
      return;
    }
    require_real(header_.fields.front(), "the array");
    require_rows(in_order);
    in_order.resize(header_.shape[1]);
    in_order_ = std::move(in_order);
  }

  std::string_view noun() const override { return "column"; }

  std::vector<std::string> names(std::size_t most) override {
    std::vector<std::string> all = in_order_;
    if (header_.of_records)
      for (const NumpyField& field : header_.fields)
        if (!field.name.empty()) all.push_back(shortened(field.name, 40));
    if (all.size() > most) all.resize(most);
    return all;
  }

  bool has(const std::string& name) override {
    if (!header_.of_records) return std::ranges::find(in_order_, name) != in_order_.end();
    return std::ranges::find(header_.fields, name, &NumpyField::name) != header_.fields.end();
  }

  ArrayLayout layout(const std::string& name) override {
    require_real(field(name), name);
    return {.shape = {header_.shape.front()}, .of_integers = field(name).type.kind != 'f'};
  }

  std::vector<double> read(const std::string& name, std::uint64_t) override {
    const auto column = std::ranges::find(in_order_, name) - in_order_.begin();
    return npy_numbers(file_.bytes(), header_, field(name),
                       header_.of_records ? 0 : static_cast<std::uint64_t>(column));
  }

 private:
  const NumpyField& field(const std::string& name) const {
    if (!header_.of_records) return header_.fields.front();
    return *std::ranges::find(header_.fields, name, &NumpyField::name);
  }

  void require_a_line() const {
    if (header_.shape.size() == 1) return;
    throw BadArray(fmt::format("its records have shape {}; one dimension was expected",
                               numpy_shape(header_.shape)));
  }

  void require_rows(const std::vector<std::string>& in_order) const {
    const auto& shape = header_.shape;
    const auto fits = [&](std::uint64_t length) {
      return length >= 2 && length <= in_order.size();
    };
    if (shape.size() == 2 && fits(shape[1])) return;
    const bool turned = shape.size() == 2 && fits(shape[0]);
    throw BadArray(fmt::format("the array has shape {}; n rows of {}{} were expected{}",
                               numpy_shape(shape), fmt::join(in_order, ", "),
                               in_order.size() > 2 ? ", or the first of these," : "",
                               turned ? ": save its transpose" : ""));
  }

  MappedFile file_;
  NpyHeader header_;
  std::vector<std::string> in_order_;
};

}  // namespace

std::unique_ptr<ArrayFile> open_npy(const std::filesystem::path& path,
                                    std::vector<std::string> in_order) {
  return std::make_unique<NpyColumns>(path, std::move(in_order));
}

}  // namespace vortree::io
