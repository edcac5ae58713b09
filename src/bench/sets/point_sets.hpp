#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "fmm/sources.hpp"

namespace vortree::bench {

/// Sets of vortices that velocity methods are compared on. The bits depend on nothing but the kind
/// and the number (and the last digit of the machine's log, exp, cos, sin, pow): uniform numbers
/// are rng() >> 11 over 2^53 with std::mt19937_64, no distribution of the library is used.
struct PointSet {
  std::vector<double> x, y, gamma, sigma;  // sigma empty: bare vortices
  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] fmm::Sources blobs() const { return {x, y, gamma, sigma}; }
};

/// Numbers in [0, 1), the same with every library.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }

 private:
  std::mt19937_64 engine_;
};

/// uniform    unit square
/// ringwake   half in a thin layer around a cylinder of radius 0.5, half in 20 Gaussian clumps
/// hard       half uniform, a quarter on a segment 1e-6 long, a quarter closing in on a point
enum class PointKind { uniform, ringwake, hard };
inline constexpr std::array every_kind{PointKind::uniform, PointKind::ringwake, PointKind::hard};
inline constexpr std::array kind_names{"uniform", "ringwake", "hard"};

/// n bare vortices with gamma uniform in [-1, 1], in random order.
PointSet make_points(PointKind kind, std::size_t n);

/// n overlapping blobs of equal cores in random order, one at a random place of each square of a
/// lattice on the unit square, cores twice as wide as the squares:
///
///   gamma = sin(2 pi x) sin(2 pi y) dA
PointSet make_blobs(std::size_t n);

}  // namespace vortree::bench
