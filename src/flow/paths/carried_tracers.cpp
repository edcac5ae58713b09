#include "flow/paths/carried_tracers.hpp"

#include <cmath>
#include <utility>

namespace vortree::flow {
namespace {

/// Evenly from one end of a line to the other.
Vec2 on_line(const std::array<double, 4>& line, int k, int count) {
  const double share = count > 1 ? static_cast<double>(k) / (count - 1) : 0;
  return {line[0] + share * (line[2] - line[0]), line[1] + share * (line[3] - line[1])};
}

/// Evenly along the wall, at a distance from it, as seen from the body's centre in its axes.
Vec2 around_body(const body::Body& body, double distance, int k, int count) {
  const Vec2 at = body.shape->point(body.shape->perimeter() * k / count);
  return at + distance * body.shape->nearest(at).normal;
}

/// How many releases are due by a time; a hair early, for times of steps have round-off.
double due(const ReleaseSettings& when, double time) {
  const double hair = 1e-9 * std::abs(time);
  if (time + hair < when.from) return 0;
  return when.every ? std::floor((time + hair - when.from) / *when.every) + 1 : 1;
}

}  // namespace

CarriedTracers::CarriedTracers(const std::vector<ReleaseSettings>& releases,
                               const body::Bodies& bodies)
    : bodies_(bodies) {
  for (const ReleaseSettings& one : releases) {
    Released set{one, {}, {}};
    const auto put = [&](Vec2 at) { set.x.push_back(at.x), set.y.push_back(at.y); };
    for (int k = 0; one.line && k < one.count; ++k) put(on_line(*one.line, k, one.count));
    for (std::size_t body = 0; one.around && body < bodies.size(); ++body)
      for (int k = 0; k < one.count; ++k)
        put(around_body(bodies[body], *one.around, k, one.count));
    sets_.push_back(std::move(set));
  }
}

void CarriedTracers::release(double before, double now) {
  for (std::size_t number = 0; number < sets_.size(); ++number) {
    const Released& set = sets_[number];
    const double already = before < 0 ? 0 : due(set.when, before);
    if (due(set.when, now) <= already) continue;
    for (std::size_t k = 0; k < set.x.size(); ++k) {
      const Vec2 at = place(set, k, now);
      x_.push_back(at.x);
      y_.push_back(at.y);
    }
    set_.resize(x_.size(), static_cast<double>(number));
    from_.resize(x_.size(), now);
    for (auto* fresh : {&before_u_, &before_v_, &steps_}) fresh->resize(x_.size());
  }
}

Vec2 CarriedTracers::place(const Released& set, std::size_t k, double now) const {
  const Vec2 at{set.x[k], set.y[k]};
  if (set.when.line) return at;
  const body::Body& body = bodies_[k / static_cast<std::size_t>(set.when.count)];
  const body::Kinematics own = body.own.at(now);
  return body.centre + own.place + Turn(body.motion.at(now).angle + own.angle)(at);
}

void CarriedTracers::sample(const Solver& solver) {
  if (size() > 0) now_ = solver.sample({x_, y_});
}

void CarriedTracers::carry(double dt) {
  for (std::size_t i = 0; i < size(); ++i) {
    const double old = steps_[i] > 0 ? 0.5 : 0;
    x_[i] += dt * ((1 + old) * now_.u[i] - old * before_u_[i]);
    y_[i] += dt * ((1 + old) * now_.v[i] - old * before_v_[i]);
    steps_[i] += 1;
  }
  before_u_ = std::exchange(now_.u, {});
  before_v_ = std::exchange(now_.v, {});
}

namespace {

constexpr const char* names[] = {"tracers x",    "tracers y",        "tracers set",
                                 "tracers from", "tracers before u", "tracers before v",
                                 "tracers steps"};

}  // namespace

void CarriedTracers::save(State& state) const {
  if (none()) return;
  const std::vector<double>* columns[] = {&x_, &y_, &set_, &from_, &before_u_, &before_v_, &steps_};
  for (std::size_t k = 0; k < std::size(names); ++k) state[names[k]] = *columns[k];
}

void CarriedTracers::restore(const State& state) {
  if (none()) return;
  std::vector<double>* columns[] = {&x_, &y_, &set_, &from_, &before_u_, &before_v_, &steps_};
  for (std::size_t k = 0; k < std::size(names); ++k) *columns[k] = saved(state, names[k]);
}

}  // namespace vortree::flow
