#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/keys.hpp"
#include "body/shape.hpp"
#include "sph/cloud/cloud.hpp"
#include "sph/neighbors/neighbor_lists.hpp"
#include "sph/neighbors/periodic_images.hpp"
#include "tree/base/buffer.hpp"
#include "tree/base/simd.hpp"

namespace vortree::sph {

/// least_squares  fits of polynomials: they converge for any arrangement
/// pair_sums      as SPH has had them: gradients by the kernel's, corrected to be exact on linear
///                fields, and a Laplacian that is exact only where particles stand evenly,
///
///   (grad f)_i = L_i sum_j V_j (f_j - f_i) grad W,    L_i^-1 = sum_j V_j grad W (x_j - x_i)^T
///   (lap f)_i  = 2 sum_j V_j (f_j - f_i) F,           F = -W'(r)/r,   grad W = F (x_j - x_i)
///
///   source  Bonet & Lok 1999; Brookshaw, Proc. Astron. Soc. Aust. 6 (1985), 207; Morris, Fox &
///           Zhu, J. Comput. Phys. 136 (1997), 214
enum class OperatorKind { least_squares, pair_sums };

}  // namespace vortree::sph

namespace vortree {

template <>
inline constexpr std::array<std::string_view, 2> words_of<sph::OperatorKind>{"least_squares",
                                                                             "pair_sums"};

}  // namespace vortree

namespace vortree::sph {

/// How derivatives are found from neighbors.
///
/// degree   of the polynomials that they are exact on, 2 or 4
/// reach    radius of a particle's support, in its spacings
/// period   sides of a periodic domain with a corner at the origin [L]; 0: not periodic
/// body     through which particles do not see each other; null without one
/// kind     what of the weights below is a fit; pair sums have no degree
/// neighbors  how these are found
struct OperatorOptions {
  int degree = 2;
  double reach = 2.8;
  double period = 0;
  const body::Shape* body = nullptr;
  OperatorKind kind = OperatorKind::least_squares;
  NeighborSettings neighbors{};
};

/// Within which fits beside a boundary have their neighbors [spacings].
[[nodiscard]] double fitted_reach(const OperatorOptions& options);

/// Neighbors of all particles, and the weights by which derivatives follow from them:
///
///   (d_e f)_i = sum_j w_e,ij (f_j - f_i),      e = x, y, xx, xy, yy
///
/// exact on polynomials of the degree for any arrangement and any mix of spacings: moving least
/// squares with
///
///   w_ij = (s_j/s_i)^2 W(|x_j - x_i| / r_ij),   r_ij = reach (s_i + s_j)/2,
///   W(q) = (1 - q)^6 (1 + 6 q + 35/3 q^2)       (Wendland's C4)
///
/// Degree 4 holds where every neighbor nearer than 2.8 spacings is inside, degree 2 elsewhere, by
/// neighbors that are nearer than that; where neighbors cannot tell the terms apart, degree 1.
///
/// Particles of a group, lane_count of them, have their k-th neighbors side by side: slot k of
/// particle i is slot(i) + k lane_count, for k < length[i]; the slots up to those of the longest
/// row of the group are filled with i itself and weights of 0.
///
/// threads   the same bits for any number
/// source    Liu, Li & Belytschko, Int. J. Numer. Meth. Engng 38 (1995), 1655 (RKPM); Bonet & Lok,
///           Comput. Methods Appl. Mech. Engrg. 180 (1999), 97, for degree 1; Wendland, Adv.
///           Comput. Math. 4 (1995)
class Stencils {
 public:
  /// Finds neighbors and weights for particles where they are now: the one after the other.
  void renew(const Cloud& cloud, const OperatorOptions& options);
  void find_neighbors(const Cloud& cloud, const OperatorOptions& options);
  void fit(const Cloud& cloud, const OperatorOptions& options);

  [[nodiscard]] std::size_t size() const { return length_.size(); }
  [[nodiscard]] std::size_t groups() const { return first_.empty() ? 0 : first_.size() - 1; }
  [[nodiscard]] std::size_t length(std::size_t i) const { return length_[i]; }
  [[nodiscard]] std::size_t slot(std::size_t i) const {
    return first_[i / lane_count] * lane_count + i % lane_count;
  }
  /// Slots of a group: lane_count neighbors each.
  [[nodiscard]] std::size_t first(std::size_t group) const { return first_[group]; }

  /// For each neighbor of a particle: use(j, slot).
  template <class Use>
  void for_each(std::size_t i, const Use& use) const {
    const std::size_t from = slot(i), to = from + length_[i] * lane_count;
    for (std::size_t k = from; k < to; k += lane_count) use(static_cast<std::size_t>(index_[k]), k);
  }

  [[nodiscard]] std::int32_t index(std::size_t slot) const { return index_[slot]; }
  /// Where a neighbor is, as seen from the particle [L].
  [[nodiscard]] Vec2 offset(std::size_t slot) const { return {dx_[slot], dy_[slot]}; }
  /// The same of a slot of a group: all lanes.
  [[nodiscard]] std::array<Lanes, 2> offsets(std::size_t k) const {
    return {load(dx_.data() + k * lane_count), load(dy_.data() + k * lane_count)};
  }
  [[nodiscard]] double weight(int e, std::size_t slot) const { return weight_[e][slot]; }
  [[nodiscard]] double laplacian(std::size_t slot) const {
    return weight_[2][slot] + weight_[4][slot];
  }
  /// Of a slot of a group that begins here: all lanes.
  [[nodiscard]] Lanes laplacians(std::size_t slot) const {
    return load(weight_[2].data() + slot) + load(weight_[4].data() + slot);
  }

  [[nodiscard]] const std::int32_t* indices() const { return index_.data(); }
  [[nodiscard]] const double* weights(int e) const { return weight_[e].data(); }

  /// sum_j V_j W_ij with W of integral one, particle i among them: 1 where volumes fill the plane.
  [[nodiscard]] double filling(std::size_t i) const { return filling_[i]; }

  /// Distance to the nearest neighbor, in means of both spacings; 2 without any.
  [[nodiscard]] double nearest(std::size_t i) const { return nearest_[i]; }

  /// Fits of degree 1 where a higher one was meant, and the fewest neighbors of any particle.
  [[nodiscard]] std::size_t degraded() const { return degraded_; }
  [[nodiscard]] std::size_t least_length() const { return least_length_; }

  /// Which particles have a node of the outer boundary among their neighbors.
  [[nodiscard]] std::vector<char> beside_edge(const Cloud& cloud) const;

 private:
  void arrange(tree::Points points, std::size_t n);
  void fit_group(const Cloud& cloud, const OperatorOptions& options, std::size_t group);

  NeighborLists lists_;
  PeriodicImages images_;
  std::vector<double> reach_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> length_;
  tree::Buffer<std::int32_t> index_;
  tree::Buffer<double> dx_, dy_;
  std::array<tree::Buffer<double>, 5> weight_;
  std::vector<double> filling_, nearest_;
  std::vector<std::uint32_t> degraded_in_;
  std::size_t degraded_ = 0, least_length_ = 0;
};

}  // namespace vortree::sph
