#include "python/bind.hpp"

PYBIND11_MODULE(_core, core) {
  vortree::python::bind_quadtree(core);
  vortree::python::bind_plan(core);
  vortree::python::bind_neighbors(core);
}
