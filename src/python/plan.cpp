#include "fmm/plan.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "fmm/vorticity.hpp"
#include "python/bind.hpp"
#include "python/columns.hpp"
#include "python/unlocked.hpp"
#include "python/words.hpp"

namespace vortree::python {
namespace {

namespace py = pybind11;
using fmm::Plan;

constexpr std::array<std::string_view, 3> method_words{"fmm", "boxes", "direct"};
constexpr std::array<std::string_view, 2> core_words{"source", "mean"};

std::unique_ptr<Plan> make_plan(const NumpyReals& x, const NumpyReals& y, const NumpyReals& gamma,
                                const NumpyReals& sigma, double tolerance, std::string_view method,
                                std::string_view builder, std::string_view cores, int order,
                                std::uint32_t capacity, int finest_level, int threads) {
  const fmm::Sources blobs{values_of(x), values_of(y), values_of(gamma), values_of(sigma)};
  const fmm::Options options{.tolerance = tolerance,
                             .order = order,
                             .capacity = capacity,
                             .finest_level = finest_level,
                             .builder = chosen<fmm::Builder>("builder", builder, builder_words),
                             .cores = chosen<fmm::Cores>("cores", cores, core_words),
                             .method = chosen<fmm::SumMethod>("method", method, method_words)};
  return unlocked(threads, [&] { return std::make_unique<Plan>(blobs, options); });
}

void velocity(const Plan& plan, NumpyReals u, NumpyReals v, int threads) {
  const auto to_u = room_of(u), to_v = room_of(v);
  unlocked(threads, [&] { plan.velocity(to_u, to_v); });
}

void velocity_at(const Plan& plan, const NumpyReals& x, const NumpyReals& y,
                 const NumpyReals& sigma, NumpyReals u, NumpyReals v, int threads) {
  const fmm::Targets places{values_of(x), values_of(y), values_of(sigma)};
  const auto to_u = room_of(u), to_v = room_of(v);
  unlocked(threads, [&] { plan.velocity(places, to_u, to_v); });
}

void velocity_and_gradient(const Plan& plan, NumpyReals u, NumpyReals v, NumpyReals ux,
                           NumpyReals uy, NumpyReals vx, int threads) {
  const auto to_u = room_of(u), to_v = room_of(v);
  const auto to_ux = room_of(ux), to_uy = room_of(uy), to_vx = room_of(vx);
  unlocked(threads, [&] { plan.velocity_and_gradient(to_u, to_v, to_ux, to_uy, to_vx); });
}

void gradient_at(const Plan& plan, const NumpyReals& x, const NumpyReals& y,
                 const NumpyReals& sigma, NumpyReals ux, NumpyReals uy, NumpyReals vx,
                 int threads) {
  const fmm::Targets places{values_of(x), values_of(y), values_of(sigma)};
  const auto to_ux = room_of(ux), to_uy = room_of(uy), to_vx = room_of(vx);
  unlocked(threads, [&] { plan.gradient(places, to_ux, to_uy, to_vx); });
}

void stream_function_at(const Plan& plan, const NumpyReals& x, const NumpyReals& y,
                        const NumpyReals& sigma, NumpyReals psi, int threads) {
  const fmm::Targets places{values_of(x), values_of(y), values_of(sigma)};
  const auto to_psi = room_of(psi);
  unlocked(threads, [&] { plan.stream_function(places, to_psi); });
}

void vorticity_at(const Plan& plan, const NumpyReals& x, const NumpyReals& y, NumpyReals omega,
                  double tolerance, int threads) {
  const tree::Points places{values_of(x), values_of(y)};
  const auto to_omega = room_of(omega);
  unlocked(threads, [&] {
    const fmm::SourceColumns blobs = plan.sources();
    fmm::vorticity(blobs.view(), places, to_omega, tolerance);
  });
}

// x, y of the blobs, in two arrays that already are long enough.
void copy_places(const Plan& plan, NumpyReals x, NumpyReals y) {
  const auto to_x = room_of(x), to_y = room_of(y);
  fmm::check_result(plan.size(), to_x, to_y);
  unlocked(1, [&] {
    const fmm::SourceColumns blobs = plan.sources();
    std::ranges::copy(blobs.x, to_x.begin());
    std::ranges::copy(blobs.y, to_y.begin());
  });
}

}  // namespace

void bind_plan(py::module_& core) {
  py::class_<Plan>(core, "Plan")
      .def(py::init(&make_plan))
      .def("velocity", &velocity)
      .def("velocity_at", &velocity_at)
      .def("velocity_and_gradient", &velocity_and_gradient)
      .def("gradient_at", &gradient_at)
      .def("stream_function_at", &stream_function_at)
      .def("vorticity_at", &vorticity_at)
      .def("copy_places", &copy_places)
      .def("tree", &Plan::tree, py::return_value_policy::reference_internal)
      .def_property_readonly("size", &Plan::size)
      .def_property_readonly("order", &Plan::order)
      .def_property_readonly("nbytes", &Plan::bytes)
      .def_property_readonly("method", [](const Plan& plan) {
        return method_words[static_cast<std::size_t>(plan.method())];
      });
}

}  // namespace vortree::python
