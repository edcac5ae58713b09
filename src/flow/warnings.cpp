#include "flow/warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "body/extent.hpp"
#include "flow/initial/widths.hpp"
#include "flow/steps.hpp"

namespace vortree::flow {
namespace {

void doubt_times(Warnings& list, const Case& of) {
  const long last = last_step(of.time);
  const double dt = of.time.dt, end = of.time.end, comes = static_cast<double>(last) * dt;
  if (!met(end, dt))
    list.push_back(fmt::format(
        "time.end = {:.9g} is no multiple of time.dt = {:.9g}: the run ends at t = {:.9g}; "
        "time.dt = {:.9g} meets it",
        end, dt, comes, end / std::ceil(end / dt)));
  if (of.output.frames < comes && !met(of.output.frames, dt))
    list.push_back(fmt::format(
        "output.frames = {:.9g} is no multiple of time.dt = {:.9g}: each frame is that of the "
        "nearest step, up to {:.2g} off",
        of.output.frames, dt, dt / 2));
  const double every = of.output.fields_every.value_or(0), from = of.output.fields_from.value_or(0);
  if (every > 0 && !(met(every, dt) && met(from, dt)))
    list.push_back(fmt::format(
        "output.fields_every = {:.9g} from {:.9g} on meets no multiples of time.dt = {:.9g}: each "
        "picture is that of the nearest step, up to {:.2g} off, and named by its time",
        every, from, dt, dt / 2));
  if (every > 0 && nearest_step(from, dt, last) > last)
    list.push_back(
        fmt::format("output.fields_from = {:.9g}: beyond the end, t = {:.9g}; no "
                    "picture",
                    from, comes));
  std::vector<std::string> moved, beyond;
  for (const double t : of.output.fields) {
    const long step = nearest_step(t, dt, last);
    if (step > last)
      beyond.push_back(fmt::format("{:.9g}", t));
    else if (!met(t, dt))
      moved.push_back(fmt::format("{:.9g} at t = {:.9g}", t, static_cast<double>(step) * dt));
  }
  if (!moved.empty())
    list.push_back(
        fmt::format("output.fields that are no multiples of time.dt = {:.9g} are drawn, and named, "
                    "at the nearest step: {}",
                    dt, fmt::join(moved, ", ")));
  if (!beyond.empty())
    list.push_back(fmt::format("output.fields = {}: beyond the end, t = {:.9g}; no picture",
                               fmt::join(beyond, ", "), comes));
}

/// Of a body that is still getting faster at the end, the run's length decides on its greatest
/// speed.
void doubt_speed(Warnings& list, const Case& of) {
  if (!of.body || !of.motion || speed_of_stream(of) > 0) return;
  const body::Course& course = of.motion->course;
  const auto speed_at = [&](double t) {
    const Vec2 v = course.at(t).velocity;
    return std::sqrt(dot(v, v));
  };
  double before = 0;
  for (const double t : course.times())
    if (t < 0.99 * of.time.end) before = std::max(before, speed_at(t));
  const double last = course.times().empty() ? 0 : speed_at(of.time.end);
  if (last > 1.01 * before)
    list.push_back(fmt::format(
        "[motion]: the body is fastest at time.end = {:.9g}, and still gains speed: with another "
        "end U, by which flow.reynolds, T and forces are told, would be another than {:.3g}",
        of.time.end, last));
}

/// The rectangle that body and initial vorticity fill, along the way that the stream takes them.
std::array<double, 4> place_of_flow(const Case& of) {
  std::array<double, 4> all{INFINITY, INFINITY, -INFINITY, -INFINITY};
  const auto add = [&](const Pair& centre, const Pair& half) {
    for (int axis : {0, 1}) {
      all[axis] = std::min(all[axis], centre[axis] - half[axis]);
      all[2 + axis] = std::max(all[2 + axis], centre[axis] + half[axis]);
    }
  };
  const auto add_moving = [&](const Pair& centre, const Pair& half) {
    add(centre, half);
    add({centre[0] + of.time.end * of.flow.stream[0], centre[1] + of.time.end * of.flow.stream[1]},
        half);
  };
  for (const body::BodySettings& one : every_body(of))
    add_moving(one.centre, body::half_extent(one));
  if (of.initial && !of.initial->kind->periodic) {
    const auto [x, y] = half_extent(*of.initial);
    add_moving(of.initial->centre, {x, y});
  }
  return all;
}

void doubt_output(Warnings& list, const Case& of) {
  const OutputSettings& output = of.output;
  if (!output.pictures()) return;
  const auto [x0, y0, x1, y1] = *output.window;
  const auto flow = place_of_flow(of);
  const bool somewhere = of.body || (of.initial && !of.initial->kind->periodic);
  if (somewhere && (x1 < flow[0] || flow[2] < x0 || y1 < flow[1] || flow[3] < y0))
    list.push_back(fmt::format(
        "output.window = [{:.4g}, {:.4g}, {:.4g}, {:.4g}]: the flow passes through [{:.4g}, "
        "{:.4g}, {:.4g}, {:.4g}]; pictures will show nothing of it",
        x0, y0, x1, y1, flow[0], flow[1], flow[2], flow[3]));
  if (*output.field_spacing > std::min(x1 - x0, y1 - y0) / 8)
    list.push_back(
        fmt::format("output.field_spacing = {:.3g}: pictures of {:.3g} x {:.3g} will "
                    "have hardly a point across; {:.2g} makes 200",
                    *output.field_spacing, x1 - x0, y1 - y0, (x1 - x0) / 200));
}

}  // namespace

Warnings warnings(const Case& of) {
  Warnings list;
  for (const body::BodySettings& one : every_body(of))
    std::ranges::move(body::told_of(one), std::back_inserter(list));
  doubt_times(list, of);
  doubt_speed(list, of);
  doubt_output(list, of);
  return list;
}

}  // namespace vortree::flow
