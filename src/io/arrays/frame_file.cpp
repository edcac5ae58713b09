#include "io/arrays/frame_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "io/frames/read.hpp"
#include "io/quote.hpp"

namespace vortree::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view between = "::", last_word = "last";

/// throws  InputError
std::optional<std::size_t> number_of_frame(const fs::path& word, std::string_view tail) {
  if (tail == last_word) return std::nullopt;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(tail.data(), tail.data() + tail.size(), number);
  if (error == std::errc{} && end == tail.data() + tail.size()) return number;
  throw InputError(
      fmt::format("{}: {} names no frame; last or a number, counted from 0, was expected",
                  word.string(), quote(shortened(tail, 40))));
}

class FrameColumns : public ArrayFile {
 public:
  explicit FrameColumns(const FramePointer& pointer)
      : columns_(read_frame_of(pointer.file, pointer.number).columns) {}

  std::string_view noun() const override { return "column"; }

  std::vector<std::string> names(std::size_t most) override {
    std::vector<std::string> all;
    for (const flow::Column& column : columns_)
      if (all.size() < most) all.push_back(column.name);
    return all;
  }

  bool has(const std::string& name) override {
    return std::ranges::find(columns_, name, &flow::Column::name) != columns_.end();
  }

  ArrayLayout layout(const std::string& name) override {
    return {.shape = {flow::column(columns_, name).size()}};
  }

  std::vector<double> read(const std::string& name, std::uint64_t) override {
    return flow::column(columns_, name);
  }

 private:
  flow::Columns columns_;
};

}  // namespace

std::optional<FramePointer> frame_pointer(const fs::path& word) {
  const std::string text = word.string();
  const std::size_t at = text.rfind(between);
  std::error_code unknown;
  if (at == text.npos || fs::exists(word, unknown)) return std::nullopt;
  fs::path file = text.substr(0, at);
  if (fs::is_directory(file, unknown)) file /= "frames.h5";
  return FramePointer{std::move(file),
                      number_of_frame(word, std::string_view(text).substr(at + between.size()))};
}

std::unique_ptr<ArrayFile> open_frame(const FramePointer& pointer) {
  return std::make_unique<FrameColumns>(pointer);
}

}  // namespace vortree::io
