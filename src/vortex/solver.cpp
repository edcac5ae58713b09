#include "vortex/solver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/rounded.hpp"
#include "flow/near_wake.hpp"
#include "vortex/blobs/energy.hpp"
#include "vortex/blobs/moments.hpp"
#include "vortex/pressure.hpp"
#include "vortex/stream_function.hpp"
#include "vortex/tuning.hpp"
#include "vortex/wall/vorticity.hpp"
#include "vortex/wall_pressure.hpp"

namespace vortree::vortex {
namespace {

void move(std::vector<double>& column, double by) {
  if (by != 0)
    for (double& value : column) value += by;
}

void turn(std::vector<double>& x, std::vector<double>& y, const Turn& turn) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec2 to = turn({x[i], y[i]});
    x[i] = to.x;
    y[i] = to.y;
  }
}

double strength(const Blobs& blobs) {
  double sum = 0;
  for (const double gamma : blobs.gamma) sum += std::abs(gamma);
  return sum;
}

/// Columns of the blobs that a frame does not show.
constexpr std::pair<const char*, std::vector<double> Blobs::*> hidden[] = {
    {"covariance_xx", &Blobs::xx}, {"covariance_xy", &Blobs::xy}};

/// Numbers of what has left, with their names in a saved state.
constexpr std::pair<const char*, double& (*)(Outflow&)> of_outflow[] = {
    {"retired circulation", [](Outflow& r) -> double& { return r.gamma; }},
    {"retired moment_x", [](Outflow& r) -> double& { return r.moment.x; }},
    {"retired moment_y", [](Outflow& r) -> double& { return r.moment.y; }},
    {"retired of_both_signs", [](Outflow& r) -> double& { return r.of_both_signs; }}};

/// Numbers of a wake, likewise.
constexpr std::pair<const char*, double& (*)(Wake&)> of_wake[] = {
    {"wake moment_x", [](Wake& w) -> double& { return w.moment.x; }},
    {"wake moment_y", [](Wake& w) -> double& { return w.moment.y; }},
    {"wake bubble_length", [](Wake& w) -> double& { return w.bubble_length; }}};

/// Numbers of a load, likewise.
constexpr std::pair<const char*, double& (*)(Load&)> of_load[] = {
    {"_x", [](Load& l) -> double& { return l.force.x; }},
    {"_y", [](Load& l) -> double& { return l.force.y; }},
    {"_moment", [](Load& l) -> double& { return l.moment; }}};

/// Loads of bodies, likewise.
constexpr std::pair<const char*, std::vector<Load> Wake::*> of_bodies[] = {
    {"wake pressure", &Wake::pressure}, {"wake friction", &Wake::friction}};

/// Columns of what drifts.
constexpr std::pair<const char*, std::vector<double> Drifting::*> of_drifting[] = {
    {"drifting x", &Drifting::x},
    {"drifting y", &Drifting::y},
    {"drifting gamma", &Drifting::gamma},
    {"drifting sigma", &Drifting::sigma},
    {"drifting spread", &Drifting::spread}};

/// Counts of a step, with their names.
constexpr std::pair<const char*, std::size_t StepCounts::*> of_counts[] = {
    {"released", &StepCounts::released},
    {"laid", &StepCounts::laid},
    {"split", &StepCounts::split},
    {"beside_wall", &StepCounts::beside_wall},
    {"merged", &StepCounts::merged}};

void save_numbers(flow::State& state, const auto& numbers, auto of) {
  for (const auto& [name, number] : numbers) state[name] = {number(of)};
}

void restore_numbers(const flow::State& state, const auto& numbers, auto& of) {
  for (const auto& [name, number] : numbers) number(of) = flow::saved_number(state, name);
}

/// A number of each body.
void save_loads(flow::State& state, Wake wake) {
  for (const auto& [of, loads] : of_bodies)
    for (const auto& [name, number] : of_load) {
      std::vector<double>& values = state[std::string(of) + name];
      values.clear();
      for (Load& load : wake.*loads) values.push_back(number(load));
    }
}

void restore_loads(const flow::State& state, std::size_t bodies, Wake& wake) {
  for (const auto& [of, loads] : of_bodies) {
    (wake.*loads).resize(bodies);
    for (const auto& [name, number] : of_load) {
      const std::vector<double>& values = flow::saved(state, std::string(of) + name);
      for (std::size_t k = 0; k < bodies; ++k) number((wake.*loads)[k]) = values.at(k);
    }
  }
}

}  // namespace

VortexSolver::VortexSolver(Setup setup)
    : setup_(std::move(setup)), blobs_(std::move(setup_.blobs)) {
  setup_.problem.moving = setup_.wall.get();
  stand(setup_.problem, 0);
  setup_.problem.box = box_at(0);
  take(start(blobs_, setup_.problem));
  second_moment_at_start_ = flow::measured(measures_, "second_moment");
  drift_ = drift_now();
}

void VortexSolver::to_scene(std::vector<double>& x, std::vector<double>& y, Vec2 by) const {
  if (turns()) turn(x, y, axes_at(time()));
  move(x, by.x), move(y, by.y);
}

void VortexSolver::from_scene(std::vector<double>& x, std::vector<double>& y, Vec2 by) const {
  move(x, -by.x), move(y, -by.y);
  if (turns()) turn(x, y, Turn(-setup_.problem.flow.motion.at(time()).angle));
}

/// What turns places and velocities as they are computed into those of the scene.
Turn VortexSolver::axes_at(double time) const {
  return Turn(setup_.problem.flow.motion.at(time).angle);
}

/// The box as the blobs are seen.
std::optional<Box> VortexSolver::box_at(double time) const {
  if (!setup_.box) return std::nullopt;
  const Vec2 origin = setup_.origin.at(time);
  return Box{setup_.box->low - origin, setup_.box->high - origin, axes_at(time)};
}

/// What a step has left becomes the flow as it is.
void VortexSolver::take(Wake wake) {
  wake_ = std::move(wake);
  growth_.add(blobs_.size());
  measures_ = measure();
}

void VortexSolver::step(const tree::Phase& phase) {
  const double later = time_of(steps_ + 1);
  Problem& problem = setup_.problem;
  problem.box = box_at(later);
  problem.most_blobs = growth_.most(later, setup_);
  Blobs before = blobs_;
  const auto give_up = [&](const std::string& reason) {
    blobs_ = std::move(before);
    throw flow::Diverged(reason);
  };
  Wake wake;
  try {
    wake = vortex::step(blobs_, problem, static_cast<std::uint64_t>(steps_ + 1), phase);
  } catch (const Multiplied& many) {
    give_up(multiplied(many.blobs, before.size(), setup_));
  } catch (const Crowded& many) {
    give_up(many.what() + remedy(setup_));
  } catch (const std::bad_alloc&) {
    blobs_ = std::move(before);
    throw;
  } catch (const std::exception& refused) {
    give_up(refused.what());
  }
  phase("output");
  if (const std::string reason = broken(blobs_, setup_, later); !reason.empty()) give_up(reason);
  ++steps_;
  problem.outflow = wake.outflow;
  problem.drifting = std::move(wake.drifting);
  problem.time = later;
  stand(problem, later);
  slope_before_ = steps_ > 1 ? std::move(wake_.pressure_slope) : std::vector<double>{};
  take(std::move(wake));
  drift_ = std::max(drift_, drift_now());
}

flow::Columns VortexSolver::columns() const {
  Velocities u = velocity_at({blobs_.x, blobs_.y}, blobs_, setup_.problem);
  std::vector<double> x = blobs_.x, y = blobs_.y;
  to_scene(x, y, origin());
  to_scene(u.u, u.v, setup_.origin.drift);
  return {{"x", "L", std::move(x)},         {"y", "L", std::move(y)},
          {"gamma", "L^2/T", blobs_.gamma}, {"sigma", "L", blobs_.sigma},
          {"u", "L/T", std::move(u.u)},     {"v", "L/T", std::move(u.v)}};
}

flow::Measures VortexSolver::measure() const {
  const Invariants now = invariants(blobs_, shape());
  const Flow& flow = setup_.problem.flow;
  double circulation = now.circulation + wake_.outflow.gamma;
  const auto turning = setup_.problem.turning;
  for (std::size_t k = 0; k < turning.size(); ++k)
    circulation += flow.rate(k, time()) * turning[k].circulation;
  Vec2 moment = wall() ? wake_.moment : now.moment + wake_.outflow.moment;
  // Beside a body all circulation adds up to 0, and its moment is the same from anywhere.
  const Vec2 from = wall() ? Vec2{} : origin();
  const bool elsewhere = dot(from, from) > 0;
  if (elsewhere) moment = moment + circulation * from;
  const Moments moments = wall() ? Moments{} : vortex::moments(blobs_);
  const Vec2 plus = wall() ? Vec2{} : moments.positive_centre;
  const bool wake = wall() && wall()->rings().size() == 1 && dot(flow.stream, flow.stream) > 0 &&
                    !flow.motion.moves();
  flow::Measures measures{
      {"blobs", "", static_cast<double>(blobs_.size())},
      {"circulation", "L^2/T", circulation},
      {"impulse_x", "L^3/T", moment.y},
      {"impulse_y", "L^3/T", -moment.x},
      {"second_moment", "L^4/T", now.second},
      {"bubble_length", "", wake ? wake_.bubble_length / setup_.scales.length : 0},
      {"separation_deg", "deg",
       wake ? flow::separation_angle(wake_.wall_vorticity, wall()->middles(), flow.stream) : 0},
      {"quadrupole_xx", "L^4/T", moments.quadrupole.x},
      {"quadrupole_xy", "L^4/T", moments.quadrupole.y},
      {"separation", "L", moments.separation},
      {"circulation_plus", "L^2/T", moments.positive},
      {"plus_x", "L", elsewhere ? plus.x + from.x : plus.x},
      {"plus_y", "L", elsewhere ? plus.y + from.y : plus.y},
  };
  flow::add_place(measures, flow.motion, time());
  for (std::size_t k = 0; k < flow.own.size(); ++k)
    flow::add_place(measures, flow.own[k], time(), std::to_string(k + 1).insert(0, 1, '_'));
  return measures;
}

flow::Measures VortexSolver::counts() const {
  flow::Measures counts;
  for (const auto& [name, count] : of_counts)
    counts.push_back({name, "", static_cast<double>(wake_.counts.*count)});
  return counts;
}

/// By the wall, of all that presses and drives on a body; the impulse of the fluid is that of all.
flow::Force VortexSolver::force_on(std::size_t body) const {
  const Load& pressure = wake_.pressure[body];
  const Load& friction = wake_.friction[body];
  return flow::Force{.t = time(),
                     .pressure = pressure.force,
                     .friction = friction.force,
                     .frame = wall()->area(body) * acceleration_of_centroid(body),
                     .pressure_moment = pressure.moment,
                     .friction_moment = friction.moment,
                     .frame_moment = moment_of_frame(body)};
}

std::optional<flow::Force> VortexSolver::force() const {
  if (!wall()) return std::nullopt;
  const Vec2 moment = wake_.moment;
  const Load pressure = total(wake_.pressure, *wall()), friction = total(wake_.friction, *wall());
  flow::Force all{.t = time(),
                  .impulse = {moment.y, -moment.x},
                  .pressure = pressure.force,
                  .friction = friction.force,
                  .pressure_moment = pressure.moment,
                  .friction_moment = friction.moment};
  for (std::size_t k = 0; k < wall()->rings().size(); ++k) {
    const flow::Force own = force_on(k);
    all.frame += own.frame;
    all.frame_moment += own.frame_moment + dot(left_of(wall()->rings()[k].centre), own.frame);
  }
  return all;
}

std::vector<flow::Force> VortexSolver::forces_on_each() const {
  std::vector<flow::Force> each;
  for (std::size_t k = 0; wall() && k < wall()->rings().size(); ++k) each.push_back(force_on(k));
  return each.size() > 1 ? each : std::vector<flow::Force>{};
}

/// Of the force that drives the fluid with the frame, which acts on the body's centroid.
double VortexSolver::moment_of_frame(std::size_t body) const {
  const Vec2 from_centre =
      wall()->area_moment(body) - wall()->area(body) * wall()->rings()[body].centre;
  return dot(left_of(axes_at(time())(from_centre)),
             setup_.problem.flow.motion.at(time()).acceleration);
}

Vec2 VortexSolver::acceleration_of_centroid(std::size_t body) const {
  const body::Kinematics now = setup_.problem.flow.motion.at(time()),
                         own = setup_.problem.flow.own_at(body, time());
  const Vec2 centre = now.acceleration + Turn(now.angle)(own.acceleration);
  if (setup_.problem.turning.empty()) return centre;
  const Turning& turning = setup_.problem.turning[body];
  const Vec2 arm = Turn(now.angle)(2 / turning.circulation * turning.of_centroid);
  const double rate = now.rate + own.rate;
  return centre + (now.spin_up + own.spin_up) * left_of(arm) - rate * rate * arm;
}

double VortexSolver::drift_now() const {
  const double circulation = flow::measured(measures_, "circulation");
  if (wall()) return std::abs(circulation) / (setup_.scales.speed * setup_.scales.length);
  const double grown = 4 * setup_.problem.flow.nu * time() * circulation;
  const double expected = second_moment_at_start_ + grown;
  return expected == 0 ? 0 : std::abs(flow::measured(measures_, "second_moment") / expected - 1);
}

flow::Samples VortexSolver::sample(tree::Points at) const {
  std::vector<double> x(at.x.begin(), at.x.end()), y(at.y.begin(), at.y.end());
  from_scene(x, y, origin());
  Velocities u = velocity_at({x, y}, blobs_, setup_.problem);
  std::vector<double> omega(x.size());
  vorticity(blobs_, shape(), {x, y}, omega);
  for (std::size_t k = 0; wall() && k < x.size(); ++k)
    if (shape()->nearest({x[k], y[k]}).distance < 0) u.u[k] = u.v[k] = 0;
  to_scene(u.u, u.v, setup_.origin.drift);
  return {std::move(u.u), std::move(u.v), std::move(omega)};
}

std::vector<double> VortexSolver::stream_function(tree::Points at) const {
  std::vector<double> x(at.x.begin(), at.x.end()), y(at.y.begin(), at.y.end());
  from_scene(x, y, origin());
  std::vector<double> psi = stream_function_at({x, y}, blobs_, setup_.problem);
  const Vec2 drift = setup_.origin.drift;
  for (std::size_t k = 0; k < psi.size(); ++k) psi[k] += drift.x * at.y[k] - drift.y * at.x[k];
  return psi;
}

std::vector<double> VortexSolver::pressure_slope() const {
  return slope_at_end({wake_.pressure_slope, slope_before_}, time(), setup_.problem.dt,
                      setup_.scales.impulsive);
}

/// None of an impulsive start, where it is infinite.
std::vector<double> VortexSolver::pressure(tree::Points at) const {
  if (wall() && steps_ == 0) return {};
  std::vector<double> x(at.x.begin(), at.x.end()), y(at.y.begin(), at.y.end());
  from_scene(x, y, origin());
  return pressure_at({x, y}, blobs_, setup_.problem, {pressure_slope(), wake_.wall_vorticity});
}

flow::FrameTable VortexSolver::frame_table() const {
  if (wall() && wall()->rings().size() > 1)
    return {"wall.csv", {"t", "T", "body", "angle_deg", "vorticity", "sheet", "cp", "cf"}};
  if (wall()) return {"wall.csv", {"t", "T", "angle_deg", "vorticity", "sheet", "cp", "cf"}};
  return {"energy.csv", {"t", "energy", "enstrophy"}};
}

std::vector<double> VortexSolver::frame_rows() const {
  std::vector<double> rows;
  const double t = time();
  if (!wall()) {
    if (blobs_.size() > most_for_energy) return {};
    const Energy now = energy(blobs_);
    return {t, now.energy, now.enstrophy};
  }
  if (steps_ == 0) return {};  // the wall vorticity of an impulsive start is infinite
  const std::vector<double> pressure = wall_pressure(blobs_, setup_.problem, pressure_slope());
  const double unit = setup_.scales.length * setup_.scales.of_force();
  const double T = setup_.scales.T(t);
  const Vec2 s = setup_.scales.along;
  const Turn axes = axes_at(t);
  for (std::size_t i = 0; i < wall()->panels(); ++i) {
    const std::size_t body = wall()->ring_of(i);
    const Vec2 d = axes(wall()->middle(i) - wall()->rings()[body].centre);
    const double angle = std::atan2(s.x * d.y - s.y * d.x, dot(s, d)) * 180 / std::numbers::pi;
    const double as_a_whole =
        !setup_.problem.turning.empty() ? 2 * setup_.problem.flow.rate(body, t) : 0;
    const double friction = setup_.problem.flow.nu * (wake_.wall_vorticity[i] - as_a_whole);
    rows.insert(rows.end(), {t, T});
    if (wall()->rings().size() > 1) rows.push_back(static_cast<double>(body + 1));
    rows.insert(rows.end(), {angle, wake_.wall_vorticity[i], wake_.sheet[i], unit * pressure[i],
                             unit * friction});
  }
  return rows;
}

/// Of all vorticity of both signs, what has left the box.
double VortexSolver::share_gone() const {
  const double gone = setup_.problem.outflow.of_both_signs;
  return gone > 0 ? gone / (gone + strength(blobs_)) : 0;
}

flow::Closing VortexSolver::closing() const {
  if (!setup_.box) return {};
  const Outflow& gone = setup_.problem.outflow;
  return {{{"left_box.circulation", "L^2/T", gone.gamma},
           {"left_box.of_both_signs", "L^2/T", gone.of_both_signs},
           {"left_box.share", "", share_gone()},
           {"left_box.drifting", "", static_cast<double>(setup_.problem.drifting.size())}},
          rounded(std::round(100 * share_gone()), 6) +
              " % of the vorticity of both signs has left merging.box, " + rounded(gone.gamma, 3) +
              " net"};
}

void VortexSolver::save(flow::State& state) const {
  if (told_elsewhere()) {
    state["x_in_flow"] = blobs_.x;
    state["y_in_flow"] = blobs_.y;
  }
  for (const auto& [name, column] : hidden) state[name] = blobs_.*column;
  save_numbers(state, of_outflow, setup_.problem.outflow);
  for (const auto& [name, column] : of_drifting) state[name] = setup_.problem.drifting.*column;
  state["second_moment_at_start"] = {second_moment_at_start_};
  state["largest_drift"] = {drift_};
  if (!wall()) return;
  save_numbers(state, of_wake, wake_);
  save_loads(state, wake_);
  state["sheet"] = wake_.sheet;
  state["wall_vorticity"] = wake_.wall_vorticity;
  state["pressure_slope"] = wake_.pressure_slope;
  if (!slope_before_.empty()) state["pressure_slope_before"] = slope_before_;
}

/// What has left. Runs saved when nothing drifted have its moment a step ahead.
void VortexSolver::restore_left(const flow::State& state) {
  Problem& problem = setup_.problem;
  problem.box = box_at(problem.time);
  restore_numbers(state, of_outflow, problem.outflow);
  problem.drifting = {};
  if (!state.contains(of_drifting[0].first))
    return problem.outflow.drift(-1.0 * problem.flow.way(problem.time - problem.dt, problem.dt));
  for (const auto& [name, column] : of_drifting)
    problem.drifting.*column = flow::saved(state, name);
}

void VortexSolver::restore(long steps, const flow::Columns& columns, const flow::State& state) {
  steps_ = steps;
  Problem& problem = setup_.problem;
  problem.time = time_of(steps);
  stand(problem, problem.time);
  const bool elsewhere = told_elsewhere();
  blobs_ = {elsewhere ? flow::saved(state, "x_in_flow") : flow::column(columns, "x"),
            elsewhere ? flow::saved(state, "y_in_flow") : flow::column(columns, "y"),
            flow::column(columns, "gamma"), flow::column(columns, "sigma")};
  for (const auto& [name, column] : hidden) blobs_.*column = flow::saved(state, name);
  restore_left(state);
  second_moment_at_start_ = flow::saved_number(state, "second_moment_at_start");
  drift_ = flow::saved_number(state, "largest_drift");
  wake_ = {};
  wake_.outflow = problem.outflow;
  if (wall()) {
    restore_numbers(state, of_wake, wake_);
    restore_loads(state, wall()->rings().size(), wake_);
    wake_.sheet = flow::saved(state, "sheet");
    wake_.wall_vorticity = flow::saved(state, "wall_vorticity");
    wake_.pressure_slope = flow::saved(state, "pressure_slope");
    slope_before_.clear();
    if (const auto found = state.find("pressure_slope_before"); found != state.end())
      slope_before_ = found->second;
  }
  growth_ = {};
  growth_.add(blobs_.size());
  measures_ = measure();
}

}  // namespace vortree::vortex
