#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace vortree::io {

/// A JSON value that keeps the order in which its members were set.
///
///   Json summary;
///   summary["n"] = 1000;
///   summary["seconds"]["total"] = 0.25;
///   summary["blobs"] = Json::array({1, 2, 3});
///
/// Doubles are written in the shortest form that reads back the same; NaN and infinity, which JSON
/// lacks, as null.
class Json {
 public:
  using Members = std::vector<std::pair<std::string, Json>>;
  using Elements = std::vector<Json>;

  Json() = default;  ///< null; becomes an object at the first operator[]
  Json(bool value) : value_(value) {}
  Json(double value) : value_(value) {}
  Json(int value) : value_(std::int64_t{value}) {}
  Json(std::int64_t value) : value_(value) {}
  Json(std::uint64_t value) : value_(value) {}
  Json(std::uint32_t value) : value_(std::int64_t{value}) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}

  [[nodiscard]] static Json array(Elements);

  /// The member of that name, added at the end if there is none.
  /// throws  std::logic_error on a value that is no object
  Json& operator[](std::string_view name);

  /// Calls `write` with the value itself: std::monostate, bool, a number, a text, Elements,
  /// Members.
  template <class Write>
  void visit(Write&& write) const {
    std::visit(write, value_);
  }

  [[nodiscard]] std::string line() const;  ///< on one line, no line end
  [[nodiscard]] std::string page() const;  ///< indented, ends with a line end

 private:
  using Value = std::variant<std::monostate, bool, double, std::int64_t, std::uint64_t, std::string,
                             Elements, Members>;
  Value value_;
};

/// Writes the page in place of an older file, in one rename.
/// throws  std::runtime_error if it cannot be written
void write_json(const std::filesystem::path&, const Json&);

}  // namespace vortree::io
