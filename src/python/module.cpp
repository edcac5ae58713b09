#include <omp.h>

#include "python/bind.hpp"

PYBIND11_MODULE(_core, core) {
  vortree::python::bind_quadtree(core);
  vortree::python::bind_plan(core);
  vortree::python::bind_neighbors(core);
  core.def("threads", &omp_get_max_threads);
  core.attr("version") = VORTREE_VERSION;
}
