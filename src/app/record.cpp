#include "app/record.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "vortex/form.hpp"
#include "vortex/near_wake.hpp"

namespace vortree::app {

std::array<double, Record::numbers> Record::values() const {
  return std::bit_cast<std::array<double, numbers>>(*this);
}

Record Record::from(std::span<const double> values) {
  std::array<double, numbers> all;
  std::ranges::copy(values.first(numbers), all.begin());
  return std::bit_cast<Record>(all);
}

std::vector<std::string> Record::names() {
  return {"t",
          "T",
          "blobs",
          "circulation",
          "impulse_x",
          "impulse_y",
          "second_moment",
          "cd_impulse",
          "cd_wall",
          "cl_impulse",
          "cl_wall",
          "bubble_length",
          "separation_deg",
          "quadrupole_xx",
          "quadrupole_xy",
          "separation",
          "circulation_plus",
          "plus_x",
          "plus_y",
          "seconds",
          "seconds_convect",
          "seconds_wall",
          "seconds_split",
          "seconds_merge",
          "seconds_output"};
}

Record measure(long step, const vortex::Blobs& blobs, const vortex::Wake& wake,
               const FlowCase& flow) {
  const vortex::Problem& p = flow.problem;
  const vortex::Invariants now = vortex::invariants(blobs, p.wall ? &p.wall->shape() : nullptr);
  Record record;
  record.t = static_cast<double>(step) * p.dt;
  record.T = p.wall ? 2 * flow.speed * record.t / flow.diameter : record.t;
  record.blobs = static_cast<double>(blobs.size());
  record.circulation = now.circulation + wake.retired.gamma;
  vortex::Vec2 moment = p.wall ? wake.moment : now.moment + wake.retired.moment;
  const vortex::Vec2 origin = flow.origin.at(record.t);
  // Beside a body all circulation adds up to 0, and its moment is the same from anywhere.
  const bool elsewhere = !p.wall && dot(origin, origin) > 0;
  if (elsewhere) moment = moment + record.circulation * origin;
  record.impulse_x = moment.y;
  record.impulse_y = -moment.x;
  record.second_moment = now.second;
  if (!p.wall) {
    const vortex::Form form = vortex::form(blobs);
    record.quadrupole_xx = form.quadrupole.x;
    record.quadrupole_xy = form.quadrupole.y;
    record.separation = form.separation;
    record.circulation_plus = form.positive;
    const vortex::Vec2 plus = form.positive_centre;
    record.plus_x = elsewhere ? plus.x + origin.x : plus.x;
    record.plus_y = elsewhere ? plus.y + origin.y : plus.y;
    return record;
  }
  record.pressure_x = wake.pressure.x;
  record.pressure_y = wake.pressure.y;
  record.friction_x = wake.friction.x;
  record.friction_y = wake.friction.y;
  if (dot(p.flow.stream, p.flow.stream) > 0 && p.flow.plunge.frequency == 0) {
    record.bubble_length = wake.bubble_length / flow.diameter;
    record.separation_deg = vortex::separation_angle(wake.wall_vorticity, *p.wall, p.flow.stream);
  }
  return record;
}

Record History::with_forces(const Record& record, vortex::Vec2 by_impulse,
                            vortex::Vec2 by_wall) const {
  Record done = record;
  if (!flow_.problem.wall) return done;
  const vortex::Vec2 along = flow_.along, across{-along.y, along.x};
  const double scale = 2 / (flow_.speed * flow_.speed * flow_.diameter);
  const vortex::Vec2 displaced =
      flow_.problem.wall->area() * flow_.problem.flow.plunge.acceleration(record.t);
  done.cd_impulse = scale * dot(by_impulse + displaced, along);
  done.cl_impulse = scale * dot(by_impulse + displaced, across);
  done.cd_wall = scale * dot(by_wall + displaced, along);
  done.cl_wall = scale * dot(by_wall + displaced, across);
  return done;
}

namespace {

vortex::Vec2 impulse(const Record& r) {
  return {r.impulse_x, r.impulse_y};
}
vortex::Vec2 pressure(const Record& r) {
  return {r.pressure_x, r.pressure_y};
}
vortex::Vec2 friction(const Record& r) {
  return {r.friction_x, r.friction_y};
}

/// Rate of change, at the second of three times, of what is f at each, by the parabola through them
/// in sqrt(t): what an impulsive start sets off at t = 0 goes as powers of that.
class RateOfChange {
 public:
  RateOfChange(double t0, double t1, double t2) {
    const double s0 = std::sqrt(t0), s1 = std::sqrt(t1), s2 = std::sqrt(t2);
    before_ = (s1 - s2) / ((s0 - s1) * (s0 - s2)) / (2 * s1);
    after_ = (s1 - s0) / ((s2 - s0) * (s2 - s1)) / (2 * s1);
  }
  vortex::Vec2 operator()(vortex::Vec2 f0, vortex::Vec2 f1, vortex::Vec2 f2) const {
    return before_ * (f0 - f1) + after_ * (f2 - f1);
  }

 private:
  double before_, after_;
};

}  // namespace

void History::add(const Record& record, const Write& write) {
  recent_.push_back(record);
  if (recent_.size() < 3) return;
  if (recent_.size() > 3) recent_.pop_front();
  write(with_forces_in_the_middle());
}

/// Of the middle one of three.
Record History::with_forces_in_the_middle() const {
  const Record &a = recent_[0], &b = recent_[1], &c = recent_[2];
  const RateOfChange rate(a.t, b.t, c.t);
  // A body at rest feels minus the rate of change of the fluid's impulse; of what the pressure has
  // given it since the first of the three, the rate is the force.
  const vortex::Vec2 by_b = (b.t - a.t) * pressure(b), by_c = by_b + (c.t - b.t) * pressure(c);
  return with_forces(b, -1 * rate(impulse(a), impulse(b), impulse(c)),
                     rate({}, by_b, by_c) + friction(b));
}

void History::finish(const Write& write) {
  if (recent_.size() < 2) return;
  const Record &before = recent_[recent_.size() - 2], &now = recent_.back();
  write(with_forces(now, (-1 / (now.t - before.t)) * (impulse(now) - impulse(before)),
                    pressure(now) + friction(now)));
}

std::vector<double> History::saved() const {
  std::vector<double> values;
  for (const Record& record : recent_)
    for (double value : record.values()) values.push_back(value);
  return values;
}

void History::restore(std::span<const double> values) {
  recent_.clear();
  for (std::size_t k = 0; k + Record::numbers <= values.size(); k += Record::numbers)
    recent_.push_back(Record::from(values.subspan(k, Record::numbers)));
}

}  // namespace vortree::app
