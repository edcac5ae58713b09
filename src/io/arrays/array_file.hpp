#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace vortree::io {

/// What is wrong with the numbers of a file, as a sentence; who knows the file puts its name before
/// it.
class BadArray : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How the numbers under a name lie; none of them is read yet.
struct ArrayLayout {
  std::vector<std::uint64_t> shape;  ///< empty: a single number
  bool of_integers = false;
};

/// Numbers under names, whatever kind of file keeps them. A length is held against the file before
/// anything is made room for.
///
/// throws  BadArray or h5::Failure for whatever is wrong with what is asked for, and with no more
class ArrayFile {
 public:
  ArrayFile() = default;
  ArrayFile(const ArrayFile&) = delete;
  ArrayFile& operator=(const ArrayFile&) = delete;
  virtual ~ArrayFile() = default;

  /// What one of them is called: "dataset", "column".
  [[nodiscard]] virtual std::string_view noun() const = 0;
  [[nodiscard]] virtual std::vector<std::string> names(std::size_t most) = 0;
  [[nodiscard]] virtual bool has(const std::string& name) = 0;
  /// throws  unless they are real numbers
  [[nodiscard]] virtual ArrayLayout layout(const std::string& name) = 0;
  /// Those of one column of rows; all, if there are no rows (column 0).
  [[nodiscard]] virtual std::vector<double> read(const std::string& name, std::uint64_t column) = 0;
  /// One of them, as a complaint names it.
  [[nodiscard]] virtual std::string place(const std::string& name, std::size_t index) const {
    return name + "[" + std::to_string(index) + "]";
  }
};

}  // namespace vortree::io
