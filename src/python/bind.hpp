#pragma once

#include <pybind11/pybind11.h>

namespace vortree::python {

/// The classes of the compiled module `_core`. They take columns as vortree/_arrays.py makes them,
/// and a number of threads, 0 for as many as OpenMP would take; who calls the package from Python
/// sees vortree/_plan.py, _neighbors.py and _quadtree.py instead.
void bind_plan(pybind11::module_& core);
void bind_neighbors(pybind11::module_& core);
void bind_quadtree(pybind11::module_& core);

}  // namespace vortree::python
