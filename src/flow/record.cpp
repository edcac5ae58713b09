#include "flow/record.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/rate_of_change.hpp"
#include "vortex/blobs/moments.hpp"
#include "vortex/wall/near_wake.hpp"

namespace vortree::flow {

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
  Vec2 moment = p.wall ? wake.moment : now.moment + wake.retired.moment;
  const Vec2 origin = flow.origin.at(record.t);
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
    const Vec2 plus = form.positive_centre;
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

namespace {

/// Times, the fluid's impulse and what the pressure has given a body at rest since the first of
/// some records.
struct Course {
  std::vector<double> t;
  std::vector<Vec2> impulses, given;
};

Course course_of(std::span<const Record> records) {
  Course course;
  for (const Record& r : records) {
    const Vec2 pressure{r.pressure_x, r.pressure_y};
    course.given.push_back(
        course.t.empty() ? Vec2{} : course.given.back() + (r.t - course.t.back()) * pressure);
    course.t.push_back(r.t);
    course.impulses.push_back({r.impulse_x, r.impulse_y});
  }
  return course;
}

/// A body at rest feels minus the rate of change of the fluid's impulse; of what the pressure has
/// given it, the rate is the force.
Record with_forces(const Record& record, const Course& course, const RateOfChange& rate,
                   const FlowCase& flow) {
  Record done = record;
  const Vec2 along = flow.along, across{-along.y, along.x};
  const double scale = 2 / (flow.speed * flow.speed * flow.diameter);
  const Vec2 displaced =
      flow.problem.wall->area() * flow.problem.flow.plunge.acceleration(record.t);
  const Vec2 by_impulse = -1 * rate(course.impulses) + displaced;
  const Vec2 by_wall = rate(course.given) + Vec2{record.friction_x, record.friction_y} + displaced;
  done.cd_impulse = scale * dot(by_impulse, along);
  done.cl_impulse = scale * dot(by_impulse, across);
  done.cd_wall = scale * dot(by_wall, along);
  done.cl_wall = scale * dot(by_wall, across);
  return done;
}

}  // namespace

void History::add(const Record& record, const Write& write) {
  recent_.push_back(record);
  if (recent_.size() < 3) return;
  if (recent_.size() > most) recent_.erase(recent_.begin());
  const auto three = std::span(recent_).last(3);
  write(flow_.problem.wall
            ? with_forces(three[1], course_of(three),
                          RateOfChange::in_the_middle(three[0].t, three[1].t, three[2].t), flow_)
            : three[1]);
}

void History::finish(const Write& write) {
  if (recent_.size() < 2) return;
  if (!flow_.problem.wall) return write(recent_.back());
  const Vec2 slip = flow_.problem.flow.stream_at(0);
  const Course course = course_of(recent_);
  write(with_forces(recent_.back(), course, RateOfChange::at_the_end(course.t, dot(slip, slip) > 0),
                    flow_));
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

}  // namespace vortree::flow
