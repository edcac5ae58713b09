#include <utility>

#include "sph/solver.hpp"

// What a run goes on from.
namespace vortree::sph {
namespace {

/// Columns of the particles that a frame does not show.
constexpr std::pair<const char*, std::vector<double> Cloud::*> hidden[] = {
    {"x_in_flow", &Cloud::x},       {"y_in_flow", &Cloud::y}, {"u_before", &Cloud::u_before},
    {"v_before", &Cloud::v_before}, {"normal_x", &Cloud::nx}, {"normal_y", &Cloud::ny}};

}  // namespace

void SphSolver::save(flow::State& state) const {
  for (const auto& [name, column] : hidden) state[name] = cloud_.*column;
  state["place"].assign(cloud_.place.begin(), cloud_.place.end());
  state["left_x"] = far_field_.left_x;
  state["left_y"] = far_field_.left_y;
  state["left_gamma"] = far_field_.left_gamma;
  state["leaving"] = far_field_.leaving;
  state["travelled"] = {far_field_.travelled.x, far_field_.travelled.y};
  state["along_outlet"] = momentum_.along_outlet;
  state["last_dt"] = {last_dt_};
  state["substeps"] = {static_cast<double>(substeps_)};
  state["largest_drift"] = {drift_};
  state["pressure_iterations"] = {static_cast<double>(iterations_.pressure)};
  state["impulse_given"] = {force_.impulse.x, force_.impulse.y};
  state["pressure_apart"] = {smooth_pressure_.mean.x, smooth_pressure_.mean.y};
  state["mean_pressure_apart"] = {smooth_pressure_.mean_of_means.x,
                                  smooth_pressure_.mean_of_means.y};
  state["mean_pressure_force"] = {force_.pressure.x, force_.pressure.y};
  state["friction"] = {force_.friction.x, force_.friction.y};
  state["moments"] = {force_.pressure_moment, force_.friction_moment};
}

void SphSolver::restore(long steps, const flow::Columns& columns, const flow::State& state) {
  steps_ = steps;
  time_ = time();
  cloud_ = {};
  for (const auto& [name, column] : hidden) cloud_.*column = flow::saved(state, name);
  cloud_.u = flow::column(columns, "u"), cloud_.v = flow::column(columns, "v");
  cloud_.p = flow::column(columns, "pressure");
  cloud_.spacing = flow::column(columns, "spacing");
  for (const double kind : flow::column(columns, "kind"))
    cloud_.kind.push_back(static_cast<ParticleKind>(kind));
  for (const double place : flow::saved(state, "place"))
    cloud_.place.push_back(static_cast<std::int32_t>(place));
  cloud_.was.assign(cloud_.place.size(), -1);
  far_field_.left_x = flow::saved(state, "left_x");
  far_field_.left_y = flow::saved(state, "left_y");
  far_field_.left_gamma = flow::saved(state, "left_gamma");
  momentum_.along_outlet = flow::saved(state, "along_outlet");
  far_field_.leaving = flow::saved(state, "leaving");
  const auto saved_pair = [&](const char* name) {
    const std::vector<double>& of = flow::saved(state, name);
    return Vec2{of.at(0), of.at(1)};
  };
  far_field_.travelled = saved_pair("travelled");
  last_dt_ = flow::saved_number(state, "last_dt");
  substeps_ = static_cast<long>(flow::saved_number(state, "substeps"));
  drift_ = flow::saved_number(state, "largest_drift");
  iterations_.pressure = static_cast<int>(flow::saved_number(state, "pressure_iterations"));
  smooth_pressure_.mean = saved_pair("pressure_apart");
  smooth_pressure_.mean_of_means = saved_pair("mean_pressure_apart");
  stencils_.renew(cloud_, setup_.operators);
  look();
  traction_ = traction();
  force_ = {.t = time(),
            .impulse = saved_pair("impulse_given"),
            .pressure = saved_pair("mean_pressure_force"),
            .friction = saved_pair("friction"),
            .frame = setup_.area * setup_.ambient.motion.at(time()).acceleration,
            .pressure_moment = saved_pair("moments").x,
            .friction_moment = saved_pair("moments").y,
            .frame_moment = moment_of_frame()};
  measure();
}

}  // namespace vortree::sph
