#pragma once

#include <span>
#include <string>

namespace vortree::fmm {

struct Bounds;
struct SourceBounds;
struct Units;

/// What is summed: vortex blobs of Gaussian core, read only.
///
///   omega(x) = gamma/(pi sigma^2) exp(-|x - X|^2 / sigma^2),   gamma > 0 turns anticlockwise
///
/// x, y    n positions [m]
/// gamma   n circulations [m^2/s]
/// sigma   n core sizes [m], >= 0; 0 is a bare vortex; empty: all are bare
struct Sources {
  std::span<const double> x, y, gamma, sigma;
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// Where a velocity is asked for.
///
/// x, y    n positions [m]
/// sigma   n core sizes [m]; empty: all 0. Read only with Cores::mean.
struct Targets {
  std::span<const double> x, y, sigma;
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// The squared core S of a pair, target i and source j.
///   source   S = sigma_j^2                      the velocity field of the blobs
///   mean     S = (sigma_i^2 + sigma_j^2) / 2    symmetric: conserves sum gamma x to round-off
enum class Cores { source, mean };

/// throws  std::invalid_argument naming what differs in length, or the first value that cannot be
///         summed, with its index: not finite; (sigma) negative; of blobs also a coordinate beyond
///         1e307, two places nearer than 6e-67 of the extent of all, unless all have cores 1e20
///         times as wide, or a core of more than 1e60 extents that would count
/// returns the units of the blobs
Units check(const Sources& sources);
Units check(const Sources& sources, const SourceBounds& bounds);
void check(const Targets& targets);
/// Why gradient and stream function cannot be told of such cores, which they feel each at its own
/// place: one is not nothing, but less than 6e-67 of the extent, or with `wide` more than 1e60.
/// Empty if they can.
std::string complain_of_cores(std::span<const double> sigma, const Units& units, bool wide);
std::string complain_of_cores(std::span<const double> sigma, const Bounds& bounds,
                              const Units& units, bool wide);
/// throws  std::invalid_argument unless u and v hold n values, or those of a name
void check_result(std::size_t n, std::span<const double> u, std::span<const double> v);
void check_result(std::size_t n, const char* name, std::span<const double> values);

}  // namespace vortree::fmm
