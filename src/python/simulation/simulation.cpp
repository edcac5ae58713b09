#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/methods/methods.hpp"
#include "base/free_memory.hpp"
#include "flow/courses.hpp"
#include "flow/force_history.hpp"
#include "flow/scales.hpp"
#include "flow/steps.hpp"
#include "io/frames/frames.hpp"
#include "io/frames/stored_scene.hpp"
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

/// Columns of Python beside the flow, by name.
using Extras = std::map<std::string, NumpyReals>;

/// How their names begin in a frame, where no other does so.
const std::string extra = "python ";

/// Which tells the frame of a saved flow from that of a run.
const std::string saved_mark = "saved alone";

bool is_saved_flow(const std::string& file) {
  try {
    const io::RecoveredFrames found = io::read_last_good(file);
    return found.steps.size() == 1 && found.last->state.contains(saved_mark);
  } catch (const io::InputError&) {
    return false;
  }
}

/// throws  io::InputError if there is a file of that name that save() has not written
void require_saved_or_free(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || is_saved_flow(file)) return;
  throw io::InputError(file + " is there already and is no saved flow: save() does not replace it");
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
        forces_(flow::scales_of(scene_)),
        on_each_(solver_->forces_on_each().size(), forces_),
        info_(io::info_of(scene_, VORTREE_VERSION)) {
    info_.scene_path = std::filesystem::absolute(scene_.origin.path).string();
    remember_force();
  }

  /// The flow that a frames file was left with.
  ///
  /// overrides  of keys that may change on the way
  /// throws     io::InputError for a file that is none, or of another scene or program
  static std::unique_ptr<SteppedFlow> restored(const std::string& file,
                                               const std::vector<std::string>& overrides) {
    io::RecoveredFrames found = io::read_last_good(file);
    if (!found.last) throw io::InputError(file + ": no frame to go on from");
    auto flow = std::make_unique<SteppedFlow>(
        io::stored_scene(found.info, file, found.info.scene_path, app::methods(), overrides));
    io::hold_time(*found.last, flow->scene_.time.dt, file);
    if (!found.warning.empty()) flow->doubts_.push_back(found.warning);
    flow->restore(*found.last, file);
    flow->info_.scene_path = found.info.scene_path, flow->info_.scene = found.info.scene;
    flow->info_.overrides = found.info.overrides;
    flow->info_.overrides.insert(flow->info_.overrides.end(), overrides.begin(), overrides.end());
    return flow;
  }

  /// Writes the flow as it is, and the columns, into a frames file of one frame.
  /// throws  io::InputError if a file is there that is no such one
  void save(const std::string& file, const Extras& extras) {
    std::map<std::string, std::span<const double>> columns;
    for (const auto& [name, values] : extras) columns[name] = values_of(values);
    alone(1, [&] {
      require_saved_or_free(file);
      io::Frame frame{solver_->steps(), solver_->time(), solver_->columns(), {}};
      if (const auto bad = flow::not_finite(frame.columns, solver_->particle()); !bad.empty())
        throw flow::Diverged(bad);
      solver_->save(frame.state);
      forces_.save(frame.state);
      for (std::size_t k = 0; k < on_each_.size(); ++k)
        on_each_[k].save(frame.state, flow::ForceHistory::named(k));
      flow::save_courses(scene_, frame.time, frame.state);
      for (const auto& [name, values] : columns)
        frame.state[extra + name].assign(values.begin(), values.end());
      frame.state[saved_mark] = {1};
      io::write_frames(file, info_, frame);
      return 0;
    });
  }

  /// The columns of Python that were saved with it.
  py::dict extras() const {
    py::dict values;
    for (const auto& [name, column] : extras_)
      values[py::str(name.substr(extra.size()))] = owning(std::vector<double>(column));
    return values;
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
    return dict_of(alone(1, [&] {
      if (forces_.size() < 2) return flow::Measures{};
      flow::Measures all = forces_.of_last();
      for (std::size_t k = 0; k < on_each_.size(); ++k)
        std::ranges::move(flow::ForceHistory::of_body(on_each_[k].of_last(), k + 1),
                          std::back_inserter(all));
      return all;
    }));
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
  py::array_t<double> pressure(const NumpyReals& x, const NumpyReals& y, int threads) {
    const tree::Points places{values_of(x), values_of(y)};
    return owning(alone(threads, [&] { return solver_->pressure(places); }));
  }

  py::dict units() {
    py::dict units;
    for (const flow::Column& one : alone(1, [&] { return solver_->columns(); }))
      units[py::str(one.name)] = one.unit;
    return units;
  }

  [[nodiscard]] std::string scene() const { return io::resolved(scene_); }
  [[nodiscard]] const flow::Warnings& doubts() const { return doubts_; }
  [[nodiscard]] std::string particle() const { return solver_->particle(); }
  [[nodiscard]] double time() const { return solver_->time(); }
  [[nodiscard]] long steps() const { return solver_->steps(); }
  [[nodiscard]] long last_step() const { return flow::last_step(scene_.time); }
  [[nodiscard]] double dt() const { return scene_.time.dt; }

 private:
  void restore(const io::Frame& frame, const std::string& file) {
    try {
      flow::hold_courses(scene_, frame.state);
      solver_->restore(frame.step, frame.columns, frame.state);
      forces_.restore(frame.state);
      for (std::size_t k = 0; k < on_each_.size(); ++k)
        on_each_[k].restore(frame.state, flow::ForceHistory::named(k));
    } catch (const Refused& other) {
      throw io::InputError(file + ": " + other.what());
    } catch (const std::out_of_range& missing) {
      throw io::InputError(file + ": " + missing.what() +
                           "; another version of the program has written it");
    }
    for (const auto& [name, values] : frame.state)
      if (name.starts_with(extra)) extras_[name] = values;
  }

  void remember_force() {
    if (const auto force = solver_->force()) forces_.add(*force);
    const std::vector<flow::Force> each = solver_->forces_on_each();
    for (std::size_t k = 0; k < each.size(); ++k) on_each_[k].add(each[k]);
  }

  std::mutex mutex_;
  io::Scene scene_;
  flow::Warnings doubts_;
  std::unique_ptr<flow::Solver> solver_;
  flow::ForceHistory forces_;                // of all bodies
  std::vector<flow::ForceHistory> on_each_;  // of several bodies
  io::RunInfo info_;
  flow::State extras_;
};

std::unique_ptr<SteppedFlow> begin(const std::string& scene,
                                   const std::vector<std::string>& overrides, int threads) {
  return unlocked(threads, [&] {
    return std::make_unique<SteppedFlow>(io::load_scene(scene, app::methods(), overrides));
  });
}

std::unique_ptr<SteppedFlow> restored(const std::string& file,
                                      const std::vector<std::string>& overrides, int threads) {
  return unlocked(threads, [&] { return SteppedFlow::restored(file, overrides); });
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
      .def_static("restored", &vortree::python::restored)
      .def("save", &SteppedFlow::save)
      .def("extras", &SteppedFlow::extras)
      .def("step", &SteppedFlow::step)
      .def("columns", &SteppedFlow::columns)
      .def("measures", &SteppedFlow::measures)
      .def("coefficients", &SteppedFlow::coefficients)
      .def("sample", &SteppedFlow::sample)
      .def("stream_function", &SteppedFlow::stream_function)
      .def("pressure", &SteppedFlow::pressure)
      .def("units", &SteppedFlow::units)
      .def("scene", &SteppedFlow::scene)
      .def("doubts", &SteppedFlow::doubts)
      .def_property_readonly("particle", &SteppedFlow::particle)
      .def_property_readonly("time", &SteppedFlow::time)
      .def_property_readonly("dt", &SteppedFlow::dt)
      .def_property_readonly("steps", &SteppedFlow::steps)
      .def_property_readonly("last_step", &SteppedFlow::last_step);
}
