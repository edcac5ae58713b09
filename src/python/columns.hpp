#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace vortree::python {

/// Values of numpy, one after the other; an array that is not made so is a TypeError.
template <class T>
using NumpyColumn = pybind11::array_t<T, pybind11::array::c_style>;
using NumpyReals = NumpyColumn<double>;

[[nodiscard]] inline std::span<const double> values_of(const NumpyReals& column) {
  return {column.data(), static_cast<std::size_t>(column.size())};
}

/// throws  std::domain_error, a ValueError, if the array is read-only
[[nodiscard]] inline std::span<double> room_of(NumpyReals& column) {
  return {column.mutable_data(), static_cast<std::size_t>(column.size())};
}

/// An array that keeps a buffer or a vector of the library, without a copy.
template <class Row>
requires(!std::is_lvalue_reference_v<Row>) [[nodiscard]] auto owning(Row&& row) {
  auto kept = std::make_unique<Row>(std::move(row));
  const auto size = static_cast<pybind11::ssize_t>(kept->size());
  auto* const data = kept->data();
  const pybind11::capsule owner(
      kept.get(), [](void* gone) { const std::unique_ptr<Row> last(static_cast<Row*>(gone)); });
  (void)kept.release();
  return pybind11::array_t<std::remove_pointer_t<decltype(data)>>(size, data, owner);
}

/// A read-only array of what another object of Python holds, and keeps alive.
template <class T>
[[nodiscard]] pybind11::array_t<T> view_of(std::span<const T> values, pybind11::handle owner) {
  pybind11::array_t<T> view(static_cast<pybind11::ssize_t>(values.size()), values.data(), owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

}  // namespace vortree::python
