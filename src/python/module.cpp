#include <omp.h>

#include <exception>
#include <stdexcept>

#include "python/bind.hpp"

namespace {

/// More pairs than the memory holds.
void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::length_error& too_many) {
    PyErr_SetString(PyExc_MemoryError, too_many.what());
  }
}

}  // namespace

PYBIND11_MODULE(_core, core) {
  pybind11::register_local_exception_translator(&translate);
  vortree::python::bind_quadtree(core);
  vortree::python::bind_plan(core);
  vortree::python::bind_neighbors(core);
  core.def("threads", &omp_get_max_threads);
  core.attr("version") = VORTREE_VERSION;
}
