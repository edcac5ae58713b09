#include "flow/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "body/extent.hpp"
#include "body/shapes/shapes.hpp"
#include "flow/steps.hpp"

namespace vortree::flow {

std::vector<Key> keys(Case& of) {
  return {key("title", of.title, anything, "", "name of the scene"),
          key("seed", of.seed, not_negative, "", "start of the random numbers"),
          key("accuracy", of.accuracy,
              {.low = 0, .high = 1, .above_low = true, .words = "it must lie between 0 and 1"}, "",
              "relative error aimed at: the method chooses by it what is not written of `time.dt`, "
              "`body.panels` and its own tables (`cores`, `merging` and `velocity` of vortices, "
              "`sph` of SPH)"),
          list("tracers", of.tracers,
               "points that go with the flow into the frames, a table [[tracers]] each"),
          list("probe", of.probes,
               "places where velocity and vorticity are told in time, a table [[probe]] each")};
}

std::vector<SceneTable> tables(Case& of) {
  return {table("flow", of.flow, true), table("body", of.body, of.others),
          table("plunge", of.plunge),   table("motion", of.motion),
          table("initial", of.initial), table("time", of.time, true),
          table("output", of.output)};
}

namespace {

constexpr double most_picture_points = 1e8;
constexpr double most_tracers = 1e6;
constexpr double closest = 0.003;  // of the smaller body's perimeter
constexpr double farthest = 1e6;   // of the first one's length

double fastest_plunge(const Case& of) {
  if (!of.plunge) return 0;
  return 2 * std::numbers::pi * of.plunge->frequency * of.plunge->amplitude;
}

bool moves_on_its_own(const body::BodySettings& body) {
  return body.motion && body.motion->course.moves();
}

/// Of the centre of a body.
double fastest_travel(const Case& of) {
  if (std::ranges::any_of(every_body(of), moves_on_its_own)) {
    const Vec2 fastest = body::fastest_velocity(bodies_of(of), of.time.end);
    return std::hypot(fastest.x, fastest.y);
  }
  return fastest_plunge(of) + (of.motion ? body::FastestMoves(of.motion->course).speed : 0);
}

/// Of the wall about the centre.
double fastest_turn(const Case& of) {
  double fastest = 0;
  const double common =
      of.motion ? std::abs(of.motion->spin) + body::FastestMoves(of.motion->course).rate : 0;
  for (const body::BodySettings& one : every_body(of)) {
    const double own =
        one.motion ? std::abs(one.motion->spin) + body::FastestMoves(one.motion->course).rate : 0;
    const double rate = common + own;
    fastest = std::max(fastest, rate * body::length_of(one) / 2);
  }
  return fastest;
}

void refuse_plunge(const Case& of) {
  if (!of.body) throw Refused("plunge", "[plunge] is how a body moves; there is no [body]");
  if (of.plunge->direction == Pair{0, 0})
    throw Refused("plunge.direction",
                  "plunge.direction is [0, 0]; a direction was expected, as [0, 1]");
}

void refuse_motion(const body::BodySettings& body, const body::MotionSettings& motion) {
  body::refuse(motion);
  if (motion.spin != 0 && !body::round(body))
    throw Refused(
        "motion.spin",
        fmt::format("motion.spin is {}; only a circle can turn in its place, the shape of "
                    "the body is \"{}\"",
                    motion.spin, body.shape->name));
}

void refuse_motion(const Case& of) {
  if (!of.body) throw Refused("motion", "[motion] is how a body moves; there is no [body]");
  refuse_motion(*of.body, *of.motion);
}

/// What a body's own settings refuse, under the names that it has among several.
void refuse_body(const Case& of, std::size_t number, const body::BodySettings& body) {
  const std::string key = fmt::format("body[{}]", number);
  try {
    body::refuse(body);
  } catch (const Refused& refused) {
    if (of.others.empty()) throw;
    throw renamed(refused, "body", key);
  }
  if (!body.motion) return;
  if (of.others.empty())
    throw Refused("body.motion",
                  "[body.motion] is for one of several bodies; of a single one write [motion]");
  try {
    refuse_motion(body, *body.motion);
  } catch (const Refused& refused) {
    throw renamed(refused, "motion", key + ".motion");
  }
}

void refuse_meetings(const Case& of) {
  const body::Bodies bodies = bodies_of(of);
  for (const body::NearestApproach& one : of.meetings) {
    const double least = closest * std::min(bodies[one.first].shape->perimeter(),
                                            bodies[one.second].shape->perimeter());
    if (one.gap >= least) continue;
    const std::string when = one.time > 0 ? fmt::format(" at t = {:.4g}", one.time) : "";
    throw Refused(
        fmt::format("body[{}].{}", one.second, one.time > 0 ? "motion" : "centre"),
        one.gap >= 0
            ? fmt::format("body[{}] and body[{}] are {:.3g} apart{}; {:.3g} is the least that can "
                          "be computed",
                          one.first, one.second, one.gap, when, least)
            : fmt::format("body[{}] and body[{}] overlap{}, by {:.3g}", one.first, one.second, when,
                          -one.gap));
  }
}

/// Bodies so far apart that doubles are too coarse for places beside the other.
void refuse_distances(const Case& of) {
  const BodyList bodies = every_body(of);
  const double most = farthest * body::length_of(*of.body);
  for (std::size_t k = 1; k < bodies.size(); ++k) {
    const double x = bodies[k].get().centre[0] - of.body->centre[0],
                 y = bodies[k].get().centre[1] - of.body->centre[1];
    if (std::hypot(x, y) > most)
      throw Refused(fmt::format("body[{}].centre", k),
                    fmt::format("body[{}] is {:.3g} away from body[0]; {:.3g} is the most that can "
                                "be computed",
                                k, std::hypot(x, y), most));
  }
}

void refuse_several(const Case& of) {
  if (of.others.empty()) return;
  if (of.motion && of.motion->spin != 0)
    throw Refused("motion.spin",
                  "motion.spin is of a single circle; of several bodies write "
                  "[body.motion] with spin below each that turns");
  refuse_distances(of);
}

void refuse_tracers(const Case& of) {
  double all = 0;
  for (std::size_t k = 0; k < of.tracers.size(); ++k) {
    const ReleaseSettings& one = of.tracers[k];
    const std::string name = fmt::format("tracers[{}]", k);
    if (one.line.has_value() == one.around.has_value())
      throw Refused("tracers",
                    fmt::format("{} has {}; one of them was expected", name,
                                one.line ? "both line and around" : "neither line nor around"));
    if (one.around && !of.body)
      throw Refused("tracers", name + ".around needs a body to go around; there is no [body]");
    const double times = one.every ? std::floor((of.time.end - one.from) / *one.every) + 1 : 1;
    const double bodies = one.around ? static_cast<double>(every_body(of).size()) : 1;
    all += std::max(times, 0.0) * one.count * bodies;
  }
  if (all > most_tracers)
    throw Refused("tracers", fmt::format("[[tracers]] releases {:.2g} tracers until time.end; "
                                         "{:.0e} at most are carried",
                                         all, most_tracers));
}

void refuse_window(const OutputSettings& output) {
  const auto [x0, y0, x1, y1] = *output.window;
  if (!(x0 < x1 && y0 < y1))
    throw Refused("output.window",
                  fmt::format("output.window is [{}, {}, {}, {}]; [x0, y0, x1, y1] with x0 < x1 "
                              "and y0 < y1 was expected",
                              x0, y0, x1, y1));
  if (!output.field_spacing) return;
  const double points = (x1 - x0) * (y1 - y0) / (*output.field_spacing * *output.field_spacing);
  if (points > most_picture_points)
    throw Refused("output.field_spacing",
                  fmt::format("output.field_spacing is {}; that makes a picture of {:.2g} "
                              "points, {:.0e} at most are drawn",
                              *output.field_spacing, points, most_picture_points));
}

void refuse_output(const Case& of) {
  const OutputSettings& output = of.output;
  if (output.frames < of.time.dt)
    throw Refused("output.frames", fmt::format("output.frames is {}; it must be >= time.dt = {}",
                                               output.frames, of.time.dt));
  if (output.pictures() && !(output.window && output.field_spacing)) {
    const std::string key = output.fields_every ? "output.fields_every" : "output.fields";
    throw Refused(key, key + " needs output.window and output.field_spacing beside it");
  }
  if (output.fields_from && !output.fields_every)
    throw Refused("output.fields_from", "output.fields_from needs output.fields_every beside it");
  if (output.fields_every && of.time.end / *output.fields_every > most_pictures)
    throw Refused(
        "output.fields_every",
        fmt::format("output.fields_every is {}; that makes {:.2g} pictures, {:.0e} at "
                    "most are drawn",
                    *output.fields_every, of.time.end / *output.fields_every, most_pictures));
  if (output.window) refuse_window(output);
}

}  // namespace

void choose_viscosity(Case& of, const Written& written) {
  const bool given = written("flow", "nu");
  if (!of.flow.reynolds) {
    if (!given) throw Refused("flow", "[flow] needs the key nu");
    return;
  }
  const auto periodic = periodic_flow_of(of);
  if (!periodic && (!of.body || speed_of(of) == 0))
    throw Refused("flow.reynolds",
                  fmt::format("flow.reynolds is {}; that needs [body] and a flow.stream, "
                              "[plunge] or [motion]",
                              *of.flow.reynolds));
  const double size =
      periodic ? periodic->speed * periodic->wavelength : speed_of(of) * body::length_of(*of.body);
  const double nu = size / *of.flow.reynolds;
  if (given && std::abs(of.flow.nu / nu - 1) > 1e-6)
    throw Refused("flow.reynolds",
                  fmt::format("flow.reynolds is {}, which makes flow.nu {}, but that is {}; "
                              "write one of them",
                              *of.flow.reynolds, nu, of.flow.nu));
  if (!given) of.flow.nu = nu;
}

void complete_times(Case& of) {
  refuse_uncountable(of.time);
  if (of.output.frames == 0) of.output.frames = usual_frames(of.time);
  refuse_output(of);
  refuse(of.probes, of.time.dt);
}

void refuse_senseless(const Case& of) {
  const BodyList bodies = every_body(of);
  for (std::size_t k = 0; k < bodies.size(); ++k) refuse_body(of, k, bodies[k]);
  refuse_several(of);
  if (of.plunge) refuse_plunge(of);
  if (of.motion) refuse_motion(of);
  if (of.initial) refuse(*of.initial);
  refuse_tracers(of);
  if (of.body && of.initial && of.initial->kind->periodic)
    throw Refused(
        "initial.kind",
        fmt::format("initial.kind is \"{}\"; that fills the plane, and has no place for a "
                    "[body]",
                    of.initial->kind->name));
}

void refuse_rest(const Case& of) {
  if (!of.others.empty() && of.motion && of.motion->course.turns())
    throw Refused(of.motion->angle ? "motion.angle" : "motion.file",
                  "[motion] turns several bodies; together they can only travel, each turns by "
                  "its own [body.motion]");
  if (!of.others.empty()) refuse_meetings(of);
  if (of.body && !of.initial && speed_of(of) == 0)
    throw Refused("flow",
                  "nothing moves: a body needs a flow.stream, a [plunge], a [motion] or [initial] "
                  "vorticity");
}

BodyList every_body(const Case& of) {
  BodyList all;
  if (of.body) all.push_back(*of.body);
  all.insert(all.end(), of.others.begin(), of.others.end());
  return all;
}

std::string key_of_body(const Case& of, std::size_t number, std::string_view key) {
  return of.others.empty() ? fmt::format("body.{}", key) : fmt::format("body[{}].{}", number, key);
}

body::Bodies bodies_of(const Case& of) {
  body::Bodies all;
  for (const body::BodySettings& one : every_body(of))
    all.push_back({body::outline_of(one),
                   {one.centre[0], one.centre[1]},
                   body::motion_of(of.plunge, of.motion),
                   body::motion_of(std::nullopt, one.motion),
                   one.panels});
  return all;
}

void complete_meetings(Case& of) {
  of.meetings = body::meetings(bodies_of(of), of.time.end);
}

std::optional<PeriodicFlow> periodic_flow_of(const Case& of) {
  return of.initial ? periodic_flow(*of.initial, of.flow.nu) : std::nullopt;
}

double speed_of_stream(const Case& of) {
  return std::hypot(of.flow.stream[0], of.flow.stream[1]);
}

double speed_of(const Case& of) {
  for (const double speed : {speed_of_stream(of), fastest_travel(of)})
    if (speed > 0) return speed;
  return fastest_turn(of);
}

double fastest_of(const Case& of) {
  return std::hypot(speed_of_stream(of), fastest_travel(of)) + fastest_turn(of);
}

double period_of(const Case& of) {
  const double plunge = of.plunge ? 1 / of.plunge->frequency : INFINITY;
  double moves = of.motion ? body::FastestMoves(of.motion->course).period() : INFINITY;
  for (const body::BodySettings& one : every_body(of))
    if (one.motion) moves = std::min(moves, body::FastestMoves(one.motion->course).period());
  return std::min(plunge, std::max(moves, of.time.end / 50));
}

}  // namespace vortree::flow
