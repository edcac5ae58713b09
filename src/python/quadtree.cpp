#include "tree/build/quadtree.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

#include "python/bind.hpp"
#include "python/columns.hpp"
#include "python/unlocked.hpp"
#include "python/words.hpp"
#include "tree/build/build_forward.hpp"
#include "tree/build/build_reverse.hpp"

namespace vortree::python {
namespace {

namespace py = pybind11;
using tree::Quadtree;

/// A cell as a row of an array: column i and row j within its level.
struct CellRow {
  std::int32_t level;
  std::uint32_t i, j;
  std::int32_t parent;
  std::uint32_t first_child, last_child, first, last;
};

CellRow row_of(const tree::Cell& cell) {
  const tree::GridCell place = tree::decode(cell.key);
  return {cell.level,          place.ix,           place.iy,          cell.parent,
          cell.children.first, cell.children.last, cell.points.first, cell.points.last};
}

Quadtree make_quadtree(const NumpyReals& x, const NumpyReals& y, std::uint32_t capacity,
                       std::string_view builder, int finest_level, int threads) {
  const tree::Points points{values_of(x), values_of(y)};
  const bool forward = chosen<int>("builder", builder, builder_words) == 1;
  const auto build = forward ? tree::build_forward : tree::build_reverse;
  return unlocked(threads, [&] {
    const tree::SplitRule rule = tree::crowded(capacity);
    return build(tree::morton_order(points, tree::enclose(points), finest_level), rule);
  });
}

py::array_t<CellRow> cells_of(const Quadtree& tree) {
  py::array_t<CellRow> rows(static_cast<py::ssize_t>(tree.cells().size()));
  std::ranges::transform(tree.cells(), rows.mutable_data(), row_of);
  return rows;
}

py::tuple centres_of(const Quadtree& tree) {
  const auto count = static_cast<py::ssize_t>(tree.cells().size());
  NumpyReals x(count), y(count);
  for (py::ssize_t c = 0; c < count; ++c) {
    const tree::Centre centre = tree.centre(tree.cells()[static_cast<std::size_t>(c)]);
    x.mutable_at(c) = centre.x, y.mutable_at(c) = centre.y;
  }
  return py::make_tuple(x, y);
}

const Quadtree& held(const py::object& tree) {
  return tree.cast<const Quadtree&>();
}

}  // namespace

void bind_quadtree(py::module_& core) {
  PYBIND11_NUMPY_DTYPE(CellRow, level, i, j, parent, first_child, last_child, first, last);
  py::class_<Quadtree>(core, "Quadtree")
      .def(py::init(&make_quadtree))
      .def("__eq__", [](const Quadtree& a, const Quadtree& b) { return a == b; })
      .def("cells", &cells_of)
      .def("centres", &centres_of)
      .def("order", [](py::object tree) { return view_of(held(tree).order(), tree); })
      .def("keys", [](py::object tree) { return view_of(held(tree).keys(), tree); })
      .def("childless", [](py::object tree) { return view_of(held(tree).childless(), tree); })
      .def("domain",
           [](const Quadtree& tree) {
             return py::make_tuple(tree.domain().x0, tree.domain().y0, tree.domain().side);
           })
      .def_property_readonly("depth", &Quadtree::depth);
}

}  // namespace vortree::python
