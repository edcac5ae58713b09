#include "io/arrays/npy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "io/arrays/bytes.hpp"
#include "io/frames/hdf5_inside.hpp"
#include "io/quote.hpp"

namespace vortree::io {
namespace {

static_assert(std::endian::native == std::endian::little);

/// Where the numbers of a column lie: bytes from the first to it, and from one to the next.
struct NpySteps {
  std::uint64_t first, step, count;
};

NpySteps steps_of(const NpyHeader& header, const NumpyField& field, std::uint64_t column) {
  const bool rows = header.shape.size() > 1;
  const std::uint64_t across = rows ? header.shape[1] : 1;
  const std::uint64_t down = rows ? header.shape[0] : header.count;
  const std::uint64_t first = header.fortran_order ? column * down : column;
  return {.first = header.begin + field.offset + first * header.width,
          .step = (header.fortran_order ? 1 : across) * header.width,
          .count = down};
}

template <class Number>
double number_at(const char* at, bool big_endian) {
  std::array<char, sizeof(Number)> digits;
  std::memcpy(digits.data(), at, sizeof(Number));
  if (big_endian) std::ranges::reverse(digits);
  return static_cast<double>(std::bit_cast<Number>(digits));
}

using NumberAt = double (*)(const char*, bool);

/// Nothing for types that are no real numbers.
NumberAt reader_of(const NumpyType& type) {
  struct Row {
    char kind;
    std::uint64_t width;
    NumberAt read;
  };
  constexpr Row rows[] = {{'f', 8, number_at<double>},        {'f', 4, number_at<float>},
                          {'i', 1, number_at<std::int8_t>},   {'i', 2, number_at<std::int16_t>},
                          {'i', 4, number_at<std::int32_t>},  {'i', 8, number_at<std::int64_t>},
                          {'u', 1, number_at<std::uint8_t>},  {'u', 2, number_at<std::uint16_t>},
                          {'u', 4, number_at<std::uint32_t>}, {'u', 8, number_at<std::uint64_t>}};
  for (const Row& row : rows)
    if (row.kind == type.kind && row.width == type.width) return row.read;
  return nullptr;
}

template <class Number>
std::string npy_of_line(std::span<const Number> values, std::string_view type) {
  constexpr std::size_t before = 10, aligned = 64;
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},), }}",
                                   type, values.size());
  const std::size_t filled = (before + header.size() + 1 + aligned - 1) / aligned * aligned;
  header.append(filled - before - header.size() - 1, ' ');
  header += '\n';
  std::string text("\x93NUMPY\x01\x00", 8);
  add_little_endian(text, header.size(), 2);
  text += header;
  return text.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

std::string_view meaning_of(char kind) {
  switch (kind) {
    case 'c':
      return "complex numbers";
    case 'f':
      return "numbers of that many bytes";
    case 'b':
      return "truth values";
    case 'S':
    case 'U':
      return "text";
    case 'M':
    case 'm':
      return "times";
    case 'a':
      return "an array in each record";
    default:
      return "no numbers";
  }
}

}  // namespace

void require_real(const NumpyField& field, const std::string& name) {
  if (reader_of(field.type) != nullptr) return;
  throw BadArray(fmt::format("{} has dtype {}, {}; float64, float32 or integers were expected",
                             name, quote(shortened(field.type.spelled, 40)),
                             meaning_of(field.type.kind)));
}

std::vector<double> npy_numbers(std::string_view bytes, const NpyHeader& header,
                                const NumpyField& field, std::uint64_t column) {
  const auto [first, step, count] = steps_of(header, field, column);
  h5::require_room(count, field.name.empty() ? "the array" : field.name);
  const NumberAt read = reader_of(field.type);
  std::vector<double> values(count);
  for (std::uint64_t i = 0; i < count; ++i)
    values[i] = read(bytes.data() + first + i * step, field.type.big_endian);
  return values;
}

std::string npy_of(std::span<const double> values) {
  return npy_of_line(values, "<f8");
}

std::string npy_of(std::span<const std::int64_t> values) {
  return npy_of_line(values, "<i8");
}

std::string npy_of(std::span<const std::int32_t> values) {
  return npy_of_line(values, "<i4");
}

}  // namespace vortree::io
