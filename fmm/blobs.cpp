#include "fmm/blobs.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "tree/told.hpp"

namespace vortree::fmm {
namespace {

constexpr std::size_t many = 50000;  // values that threads share

void check_length(const char* name, std::size_t found, std::size_t expected) {
  if (found != expected) {
    throw std::invalid_argument(std::string(name) + " has " + std::to_string(found) +
                                " values, x has " + std::to_string(expected));
  }
}

[[noreturn]] void refuse(const char* name, std::size_t i, double value, const char* wish) {
  throw std::invalid_argument(std::string(name) + "[" + std::to_string(i) + "] is " +
                              tree::told(value) + "; it must be " + wish);
}

/// x - x is 0 for finite x only; one branch at the end lets the loop run by lanes.
bool all_finite(std::span<const double> values) {
  double rest = 0.0;
#pragma omp parallel for simd reduction(+ : rest) if (values.size() > many)
  for (std::size_t i = 0; i < values.size(); ++i) rest += values[i] - values[i];
  return rest == 0.0;
}

void check_finite(const char* name, std::span<const double> values) {
  if (all_finite(values)) return;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) refuse(name, i, values[i], "finite");
  }
}

void check_cores(std::span<const double> sigma, std::size_t n) {
  if (sigma.empty()) return;
  check_length("sigma", sigma.size(), n);
  for (std::size_t i = 0; i < n; ++i) {
    if (!(std::isfinite(sigma[i]) && sigma[i] >= 0.0)) {
      refuse("sigma", i, sigma[i], "finite and >= 0");
    }
  }
}

}  // namespace

void check(const Blobs& blobs) {
  check_length("y", blobs.y.size(), blobs.size());
  check_length("gamma", blobs.gamma.size(), blobs.size());
  check_finite("x", blobs.x);
  check_finite("y", blobs.y);
  check_finite("gamma", blobs.gamma);
  check_cores(blobs.sigma, blobs.size());
}

void check(const Targets& targets) {
  check_length("y", targets.y.size(), targets.size());
  check_finite("x", targets.x);
  check_finite("y", targets.y);
  check_cores(targets.sigma, targets.size());
}

void check_result(std::size_t n, std::span<const double> u, std::span<const double> v) {
  if (u.size() == n && v.size() == n) return;
  throw std::invalid_argument("u has " + std::to_string(u.size()) + " values and v " +
                              std::to_string(v.size()) + "; both must have " + std::to_string(n));
}

void check_result(std::size_t n, const char* name, std::span<const double> values) {
  if (values.size() == n) return;
  throw std::invalid_argument(std::string(name) + " has " + std::to_string(values.size()) +
                              " values; it must have " + std::to_string(n));
}

}  // namespace vortree::fmm
