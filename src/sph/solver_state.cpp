#include <utility>

#include "sph/solver.hpp"

// What a run goes on from.
namespace vortree::sph {
namespace {

/// Columns of the particles that a frame does not show.
constexpr std::pair<const char*, std::vector<double> Cloud::*> hidden[] = {
    {"x_in_flow", &Cloud::x},       {"y_in_flow", &Cloud::y}, {"u_before", &Cloud::u_before},
    {"v_before", &Cloud::v_before}, {"normal_x", &Cloud::nx}, {"normal_y", &Cloud::ny}};

/// Pairs of numbers of each body, saved one after another.
struct SavedPair {
  const char* name;
  double& (*first)(flow::Force&, SmoothPressure&);
  double& (*second)(flow::Force&, SmoothPressure&);
};
constexpr SavedPair of_bodies[] = {
    {"pressure_apart", [](flow::Force&, SmoothPressure& p) -> double& { return p.mean.x; },
     [](flow::Force&, SmoothPressure& p) -> double& { return p.mean.y; }},
    {"mean_pressure_apart",
     [](flow::Force&, SmoothPressure& p) -> double& { return p.mean_of_means.x; },
     [](flow::Force&, SmoothPressure& p) -> double& { return p.mean_of_means.y; }},
    {"mean_pressure_force", [](flow::Force& f, SmoothPressure&) -> double& { return f.pressure.x; },
     [](flow::Force& f, SmoothPressure&) -> double& { return f.pressure.y; }},
    {"friction", [](flow::Force& f, SmoothPressure&) -> double& { return f.friction.x; },
     [](flow::Force& f, SmoothPressure&) -> double& { return f.friction.y; }},
    {"moments", [](flow::Force& f, SmoothPressure&) -> double& { return f.pressure_moment; },
     [](flow::Force& f, SmoothPressure&) -> double& { return f.friction_moment; }},
};

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
  std::vector<flow::Force> forces = on_each_;
  std::vector<SmoothPressure> pressures = smooth_pressure_;
  for (const auto& [name, first, second] : of_bodies) {
    std::vector<double>& values = state[name];
    values.clear();
    for (std::size_t k = 0; k < forces.size(); ++k) {
      values.push_back(first(forces[k], pressures[k]));
      values.push_back(second(forces[k], pressures[k]));
    }
  }
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
  stencils_.renew(cloud_, setup_.operators);
  look();
  traction_ = tractions();
  on_each_ = frame_forces();
  for (const auto& [name, first, second] : of_bodies) {
    const std::vector<double>& values = flow::saved(state, name);
    for (std::size_t k = 0; k < on_each_.size(); ++k) {
      first(on_each_[k], smooth_pressure_[k]) = values.at(2 * k);
      second(on_each_[k], smooth_pressure_[k]) = values.at(2 * k + 1);
    }
  }
  add_up_forces(saved_pair("impulse_given"));
  measure();
}

}  // namespace vortree::sph
