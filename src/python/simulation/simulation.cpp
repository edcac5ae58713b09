#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/methods/methods.hpp"
#include "base/free_memory.hpp"
#include "flow/force_history.hpp"
#include "flow/scales.hpp"
#include "flow/steps.hpp"
#include "io/input_error.hpp"
#include "io/scene/scene.hpp"
#include "python/columns.hpp"
#include "python/unlocked.hpp"

namespace vortree::python {
namespace {

namespace py = pybind11;

py::dict dict_of(flow::Columns columns) {
  py::dict values;
  for (flow::Column& one : columns) values[py::str(one.name)] = owning(std::move(one.values));
  return values;
}

py::dict dict_of(const flow::Measures& measures) {
  py::dict values;
  for (const flow::Measure& one : measures) values[py::str(one.name)] = one.value;
  return values;
}

/// A flow that is moved step by step, as `vortree run` moves it, but that nothing is written. Of
/// several threads of Python that ask each waits for its turn.
class SteppedFlow {
  template <class Work>
  decltype(auto) alone(int threads, const Work& work) {
    return unlocked(threads, [&] {
      const std::lock_guard turn(mutex_);
      return work();
    });
  }

 public:
  /// throws  io::InputError, Refused for what the scene asks and cannot be
  explicit SteppedFlow(io::Scene scene)
      : scene_(std::move(scene)),
        doubts_(app::warnings(scene_)),
        solver_(scene_.computed_by().begin(scene_, static_cast<double>(machine_memory()))),
        forces_(flow::scales_of(scene_)) {
    remember_force();
  }

  void step(int threads) {
    alone(threads, [&] {
      solver_->step([](std::string_view) {});
      remember_force();
      return 0;
    });
  }

  py::dict columns() {
    return dict_of(alone(1, [&] { return solver_->columns(); }));
  }
  py::dict measures() {
    return dict_of(alone(1, [&] { return solver_->measures(); }));
  }
  py::dict coefficients() {
    return dict_of(
        alone(1, [&] { return forces_.size() < 2 ? flow::Measures{} : forces_.of_last(); }));
  }

  py::tuple sample(const NumpyReals& x, const NumpyReals& y, int threads) {
    const tree::Points places{values_of(x), values_of(y)};
    flow::Samples found = alone(threads, [&] { return solver_->sample(places); });
    return py::make_tuple(owning(std::move(found.u)), owning(std::move(found.v)),
                          owning(std::move(found.omega)));
  }
  py::array_t<double> stream_function(const NumpyReals& x, const NumpyReals& y, int threads) {
    const tree::Points places{values_of(x), values_of(y)};
    return owning(alone(threads, [&] { return solver_->stream_function(places); }));
  }

  [[nodiscard]] std::string scene() const { return io::resolved(scene_); }
  [[nodiscard]] const flow::Warnings& doubts() const { return doubts_; }
  [[nodiscard]] std::string particle() const { return solver_->particle(); }
  [[nodiscard]] double time() const { return solver_->time(); }
  [[nodiscard]] long steps() const { return solver_->steps(); }
  [[nodiscard]] long last_step() const { return flow::last_step(scene_.time); }

 private:
  void remember_force() {
    if (const auto force = solver_->force()) forces_.add(*force);
  }

  std::mutex mutex_;
  io::Scene scene_;
  flow::Warnings doubts_;
  std::unique_ptr<flow::Solver> solver_;
  flow::ForceHistory forces_;
};

std::unique_ptr<SteppedFlow> begin(const std::string& scene,
                                   const std::vector<std::string>& overrides, int threads) {
  return unlocked(threads, [&] {
    return std::make_unique<SteppedFlow>(io::load_scene(scene, app::methods(), overrides));
  });
}

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const io::InputError& refused) {
    PyErr_SetString(PyExc_ValueError, refused.what());
  } catch (const Refused& refused) {
    PyErr_SetString(PyExc_ValueError, refused.what());
  }
}

}  // namespace
}  // namespace vortree::python

PYBIND11_MODULE(_flow, module) {
  using vortree::python::SteppedFlow;
  pybind11::register_exception_translator(&vortree::python::translate);
  pybind11::class_<SteppedFlow>(module, "Flow")
      .def(pybind11::init(&vortree::python::begin))
      .def("step", &SteppedFlow::step)
      .def("columns", &SteppedFlow::columns)
      .def("measures", &SteppedFlow::measures)
      .def("coefficients", &SteppedFlow::coefficients)
      .def("sample", &SteppedFlow::sample)
      .def("stream_function", &SteppedFlow::stream_function)
      .def("scene", &SteppedFlow::scene)
      .def("doubts", &SteppedFlow::doubts)
      .def_property_readonly("particle", &SteppedFlow::particle)
      .def_property_readonly("time", &SteppedFlow::time)
      .def_property_readonly("steps", &SteppedFlow::steps)
      .def_property_readonly("last_step", &SteppedFlow::last_step);
}
