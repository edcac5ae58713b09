#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/kinds.hpp"
#include "base/vec2.hpp"

// What a flow can begin with: vorticity at t = 0, the same to every method. A kind of it is one
// object in a file of its own, and a line in the list of initial_flow.cpp.

namespace vortree::flow {

struct InitialSettings;

/// Vorticity around a centre of its own: the whole of a flow, or one of two vortices.
///
/// offset       of its centre from that of the flow [L]
/// circulation  of it [L^2/T]
/// half         half widths along x and y [L]: a and b of exp(-x^2/a^2 - y^2/b^2), or half axes
/// weight       at a place seen from its centre: what cores of width sigma on a lattice of step h
///              carry there, up to a factor, so that all together are the flow; without cores,
///              sigma = h = 0, the vorticity itself, which is circulation/area times it. About 1
///              where it is largest
/// area         integral of the weight without cores [L^2]
/// extent       half sides of the rectangle beyond which no weight is more than `faintest`
struct Patch {
  Vec2 offset{};
  double circulation = 0;
  Vec2 half{};
  double area = 0;
  std::function<double(Vec2 at, double sigma, double h)> weight;
  std::function<Vec2(double faintest, double sigma, double h)> extent;
};

/// A flow that fills the plane, the same again after each wavelength along x and along y, and known
/// for all times: velocity [L/T] and pressure per unit density [L^2/T^2], whose mean is 0.
///
/// wavelength, speed   its scales: [L], and its greatest velocity at t = 0 [L/T]
struct PeriodicFlow {
  double wavelength = 0, speed = 0;
  std::function<Vec2(Vec2 at, double t)> velocity;
  std::function<double(Vec2 at, double t)> pressure;
};

/// Cores of any width make it up.
inline void any_core(const InitialSettings&, double /*sigma_0*/) {}

/// There is nothing to be said against it.
inline std::vector<std::string> no_doubt(const InitialSettings&, double /*sigma_0*/) {
  return {};
}

/// A kind of initial flow. Its functions are asked about settings that have its numbers and no
/// others (refuse).
///
/// says     what it is: "a Gaussian vortex"
/// patches  one, or two of the same size; the left one first. None of a flow that fills the plane
/// hold     throws Refused if cores of sigma_0 cannot make it up
/// doubts   what of it is hardly meant, in sentences
/// sharp    vorticity ends at an edge that is as wide as the cores; otherwise as a Gaussian
/// periodic a flow that fills the plane, in fluid of viscosity nu; null for vortices
struct InitialFlow : Kind {
  std::string_view says;
  std::vector<Patch> (*patches)(const InitialSettings&);
  void (*hold)(const InitialSettings&, double sigma_0) = any_core;
  std::vector<std::string> (*doubts)(const InitialSettings&, double sigma_0) = no_doubt;
  bool sharp = false;
  PeriodicFlow (*periodic)(const InitialSettings&, double nu) = nullptr;
};

using InitialFlows = std::span<const InitialFlow* const>;

/// All that a scene can name, in the order in which it tells them; the first is the default.
[[nodiscard]] InitialFlows initial_flows();

/// The one of that name. throws std::out_of_range if there is none
[[nodiscard]] const InitialFlow& initial_flow(std::string_view name);

/// A place for the numbers of all kinds, none of them set yet.
[[nodiscard]] Dimensions initial_numbers();

}  // namespace vortree::flow
