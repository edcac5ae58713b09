#pragma once

#include <cmath>
#include <filesystem>
#include <vector>

#include "input.hpp"
#include "io/tables/particles.hpp"

namespace vortree::fuzz {

inline void require_good(const std::vector<double>& values, std::size_t n, double least) {
  if (values.size() != n) fail("unequal lengths");
  for (const double value : values)
    if (!std::isfinite(value) || value < least) fail("a value that is none");
}

/// Reads; what is read is what the header promises: columns of equal lengths, or empty, of finite
/// numbers, cores and reaches >= 0.
inline void expect_particles(const std::filesystem::path& path) {
  expect_answer([&] {
    using enum io::Need;
    const auto p =
        io::read_particles(path, {.gamma = optional, .sigma = optional, .reach = optional});
    const std::size_t n = p.x.size();
    require_good(p.x, n, -INFINITY);
    require_good(p.y, n, -INFINITY);
    if (!p.gamma.empty()) require_good(p.gamma, n, -INFINITY);
    if (!p.sigma.empty()) require_good(p.sigma, n, 0);
    if (!p.reach.empty()) require_good(p.reach, n, 0);
  });
}

}  // namespace vortree::fuzz
