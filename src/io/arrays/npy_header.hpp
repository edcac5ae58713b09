#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/arrays/array_file.hpp"

namespace vortree::io {

/// A type of numpy's as its files spell it, "<f8".
///
/// kind   f, i, u, and whatever else numpy knows
/// width  bytes
struct NumpyType {
  char kind = 0;
  std::uint64_t width = 0;
  bool big_endian = false;
  std::string spelled;
};

/// A part of each record; the only one of a plain array has no name.
struct NumpyField {
  std::string name;
  NumpyType type;
  std::uint64_t offset = 0;
};

struct NpyHeader {
  std::vector<NumpyField> fields;
  bool of_records = false;
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
  std::uint64_t width = 0;  ///< bytes of an element
  std::uint64_t begin = 0;  ///< where the first one lies
  std::uint64_t count = 0;
};

/// Reads what stands before the numbers of an .npy file: its magic, version (1.0, 2.0, 3.0) and a
/// Python dictionary of `descr`, `fortran_order` and `shape`.
///
/// throws  BadArray: other magic or version, cut short, no such dictionary, Python objects, a shape
///         that claims another number of bytes than there are
/// source  NEP 1, "A Simple File Format for NumPy Arrays"
[[nodiscard]] NpyHeader read_npy_header(std::string_view bytes);

/// "(5, 2)", as numpy prints it.
[[nodiscard]] std::string numpy_shape(const std::vector<std::uint64_t>& shape);

}  // namespace vortree::io
