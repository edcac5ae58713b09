#include "io/arrays/csv_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/files.hpp"
#include "io/quote.hpp"
#include "io/tables/table.hpp"

namespace vortree::io {
namespace {

/// Who opens a pipe waits for its other end.
const std::filesystem::path& regular(const std::filesystem::path& path) {
  require_regular_file(path);
  return path;
}

class CsvColumns : public ArrayFile {
 public:
  CsvColumns(const std::filesystem::path& path, std::vector<std::string_view> wanted)
      : table_(regular(path), std::move(wanted)) {
    const auto& names = table_.names();
    if (std::ranges::all_of(names,
                            [](const std::string& name) { return number(name).has_value(); }))
      throw BadArray(
          "it begins with a line of numbers; one of names, x,y,..., was expected before them, "
          "without # (numpy.savetxt: comments=\"\")");
  }

  std::string_view noun() const override { return "column"; }

  std::vector<std::string> names(std::size_t most) override {
    std::vector<std::string> all;
    for (const std::string& name : table_.names())
      if (all.size() < most) all.push_back(shortened(name, 40));
    return all;
  }

  bool has(const std::string& name) override { return table_.has(name); }

  ArrayLayout layout(const std::string& name) override {
    if (std::ranges::count(table_.names(), name) > 1)
      throw BadArray(fmt::format("{} is the name of two columns", name));
    return {.shape = {table_.rows()}};
  }

  std::vector<double> read(const std::string& name, std::uint64_t) override {
    return table_.column(name);
  }

  std::string place(const std::string& name, std::size_t index) const override {
    return fmt::format("{}[{}] (line {})", name, index, table_.line_of(index));
  }

 private:
  Table table_;
};

}  // namespace

std::unique_ptr<ArrayFile> open_csv(const std::filesystem::path& path,
                                    std::vector<std::string_view> wanted) {
  return std::make_unique<CsvColumns>(path, std::move(wanted));
}

}  // namespace vortree::io
