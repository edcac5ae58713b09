#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tree/order/points.hpp"

namespace vortree::bench {

/// Particles of several sizes, as SPH around a body has them: sets that neighbor searches are
/// compared on. The bits depend on nothing but name and order (and the last digit of the machine's
/// square root): jitter comes from a hash of the lattice place, positions are rounded to float so
/// that searches in floats and in doubles see the same.
struct ParticleSet {
  std::vector<double> x, y, reach;
  std::vector<std::uint8_t> level;  // mass level: spacing and reach halve from one to the next
  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] tree::Points points() const { return {x, y}; }
};

/// shuffled   random
/// sorted     along a Morton curve: what a code that sorts its particles sees from step to step
/// made       as generated: lattice rows, the parts of split particles together
enum class Order { shuffled, sorted, made };

/// A set by name:
///
///   uni:n      n x n particles on [-10, 10]^2, one level
///   cyl:L:n    20 D x 20 D around a cylinder of diameter 1, n x n lattice, refined L - 1 times
///              inside nested ellipses; cyl:5:100 is case M of the paper's table 1
///   foil:L:n   30 C x 20 C around a NACA 0012 airfoil, n x 2n/3 lattice
///
/// A particle of level l lies in the middle of a lattice square of side dx_l = dx_0 / 2^l, moved by
/// up to a tenth of dx_l each way, and is split in four while that middle is inside ellipse l. None
/// is inside the body. Reach 3.9 dx_l: twice h = 1.95 dx_l, Wendland C6.
///
/// throws  std::invalid_argument for a name that is none, or more levels than there are ellipses
///         (cyl 5, foil 7)
/// source  Khorasanizade & Sousa 2019, tables 1 and 3; areas of the ellipses fitted to its counts
[[nodiscard]] ParticleSet make_particles(std::string_view name, Order order = Order::shuffled);

}  // namespace vortree::bench
