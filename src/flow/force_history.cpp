#include "flow/force_history.hpp"

#include <span>
#include <utility>

#include "base/rate_of_change.hpp"

namespace vortree::flow {
namespace {

/// Times, the fluid's impulse and what the pressure has given a body, and turned it by, since the
/// first of some forces.
struct Lately {
  std::vector<double> t;
  std::vector<Vec2> impulses, given, turned;  // turned: as x
};

Lately lately(std::span<const Force> forces) {
  Lately late;
  for (const Force& f : forces) {
    const bool first = late.t.empty();
    late.given.push_back(first ? Vec2{} : late.given.back() + (f.t - late.t.back()) * f.pressure);
    late.turned.push_back(
        first ? Vec2{} : late.turned.back() + (f.t - late.t.back()) * Vec2{f.pressure_moment, 0});
    late.t.push_back(f.t);
    late.impulses.push_back(f.impulse);
  }
  return late;
}

Measures by_routes(Vec2 by_impulse, Vec2 by_wall, const Scales& scales) {
  const double unit = scales.of_force();
  return {{"cd_impulse", "", unit * dot(by_impulse, scales.along)},
          {"cd_wall", "", unit * dot(by_wall, scales.along)},
          {"cl_impulse", "", unit * dot(by_impulse, scales.across())},
          {"cl_wall", "", unit * dot(by_wall, scales.across())}};
}

void add_parts_at_wall(Measures& measures, Vec2 pressure, Vec2 friction, double moment,
                       const Scales& scales) {
  const double unit = scales.of_force();
  for (const Measure& one : {Measure{"cd_pressure", "", unit * dot(pressure, scales.along)},
                             Measure{"cd_friction", "", unit * dot(friction, scales.along)},
                             Measure{"cl_pressure", "", unit * dot(pressure, scales.across())},
                             Measure{"cl_friction", "", unit * dot(friction, scales.across())},
                             Measure{"cm_wall", "", unit / scales.length * moment}})
    measures.push_back(one);
}

Measures coefficients(const Force& at, const Lately& late, const RateOfChange& rate,
                      const Scales& scales) {
  Measures all = by_routes(-1 * rate(late.impulses) + at.frame,
                           rate(late.given) + at.friction + at.frame, scales);
  add_parts_at_wall(all, rate(late.given) + at.frame, at.friction,
                    rate(late.turned).x + at.friction_moment + at.frame_moment, scales);
  return all;
}

/// Every number of a force with its name in a saved state.
constexpr std::pair<const char*, double& (*)(Force&)> numbers[] = {
    {"force t", [](Force& f) -> double& { return f.t; }},
    {"force impulse_x", [](Force& f) -> double& { return f.impulse.x; }},
    {"force impulse_y", [](Force& f) -> double& { return f.impulse.y; }},
    {"force pressure_x", [](Force& f) -> double& { return f.pressure.x; }},
    {"force pressure_y", [](Force& f) -> double& { return f.pressure.y; }},
    {"force friction_x", [](Force& f) -> double& { return f.friction.x; }},
    {"force friction_y", [](Force& f) -> double& { return f.friction.y; }},
    {"force frame_x", [](Force& f) -> double& { return f.frame.x; }},
    {"force frame_y", [](Force& f) -> double& { return f.frame.y; }},
    {"force pressure_moment", [](Force& f) -> double& { return f.pressure_moment; }},
    {"force friction_moment", [](Force& f) -> double& { return f.friction_moment; }},
    {"force frame_moment", [](Force& f) -> double& { return f.frame_moment; }},
};

}  // namespace

void ForceHistory::add(const Force& force) {
  recent_.push_back(force);
  if (recent_.size() > most) recent_.erase(recent_.begin());
}

Measures ForceHistory::of_last_but_one() const {
  const auto three = std::span(recent_).last(3);
  return coefficients(three[1], lately(three),
                      RateOfChange::in_the_middle(three[0].t, three[1].t, three[2].t), scales_);
}

Measures ForceHistory::of_last() const {
  const Lately late = lately(recent_);
  return coefficients(recent_.back(), late, RateOfChange::at_the_end(late.t, scales_.impulsive),
                      scales_);
}

Measures ForceHistory::none(bool body) {
  Measures none = by_routes({}, {}, {});
  if (body) add_parts_at_wall(none, {}, {}, 0, {});
  return none;
}

Measures ForceHistory::of_body(const Measures& all, std::size_t number) {
  Measures own;
  for (const Measure& one : all)
    if (!one.name.ends_with("_impulse"))
      own.push_back({one.name + "_" + std::to_string(number), one.unit, one.value});
  return own;
}

std::string ForceHistory::named(std::size_t body) {
  return " of body " + std::to_string(body + 1);
}

void ForceHistory::save(State& state, const std::string& body) const {
  std::vector<Force> forces = recent_;
  for (const auto& [name, number] : numbers) {
    std::vector<double>& values = state[name + body];
    values.clear();
    for (Force& force : forces) values.push_back(number(force));
  }
}

void ForceHistory::restore(const State& state, const std::string& body) {
  recent_.assign(saved(state, numbers[0].first + body).size(), {});
  for (const auto& [name, number] : numbers) {
    const std::vector<double>& values = saved(state, name + body);
    for (std::size_t k = 0; k < recent_.size(); ++k) number(recent_[k]) = values.at(k);
  }
}

}  // namespace vortree::flow
