#include "flow/courses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vortree::flow {
namespace {

constexpr int moments = 32;
constexpr double same_within = 1e-9;

struct FromFile {
  std::string key;
  const body::MotionSettings& motion;
};

std::vector<FromFile> from_files(const Case& of) {
  std::vector<FromFile> all;
  if (of.motion && of.motion->file) all.push_back({"motion.file", *of.motion});
  const BodyList bodies = every_body(of);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (const auto& own = bodies[k].get().motion; own && own->file)
      all.push_back({key_of_body(of, k, "motion.file"), *own});
  return all;
}

std::string name_of(const FromFile& one) {
  return "course by " + one.key;
}

/// The time until which it is noted, and x, y and angle from the start to then.
std::vector<double> course_until(double t, const body::MotionSettings& motion) {
  std::vector<double> noted{t};
  for (int k = 0; k <= moments; ++k) {
    const body::Kinematics at = motion.course.at(t * k / moments);
    noted.insert(noted.end(), {at.place.x, at.place.y, at.angle});
  }
  return noted;
}

void hold(const FromFile& one, const std::vector<double>& was) {
  const std::vector<double> now = course_until(was.front(), one.motion);
  double extent = 0;
  for (std::size_t i = 1; i < was.size(); ++i) extent = std::max(extent, std::abs(was[i]));
  for (std::size_t i = 1; i < std::min(was.size(), now.size()); ++i)
    if (std::abs(now[i] - was[i]) > same_within * extent)
      throw Refused(one.key,
                    fmt::format("{} leads elsewhere than when the run was there: at t = {:.6g} {} "
                                "was {:.9g}, now it is {:.9g}",
                                one.key, was.front() * ((i - 1) / 3) / moments,
                                i % 3 == 1 ? "x" : (i % 3 == 2 ? "y" : "the angle in radians"),
                                was[i], now[i]));
}

}  // namespace

void save_courses(const Case& of, double t, State& state) {
  for (const FromFile& one : from_files(of)) state[name_of(one)] = course_until(t, one.motion);
}

void hold_courses(const Case& of, const State& state) {
  for (const FromFile& one : from_files(of))
    if (const auto was = state.find(name_of(one)); was != state.end()) hold(one, was->second);
}

}  // namespace vortree::flow
