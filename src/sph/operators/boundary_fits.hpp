#pragma once

#include <cstdint>
#include <vector>

#include "sph/cloud/cloud.hpp"
#include "sph/operators/stencils.hpp"

namespace vortree::sph {

/// Values at nodes of boundaries, from the particles inside and the slope g = df/dn along the
/// node's normal:
///
///   f_i = sum_j a_j f_j - (sum_j a_j n_j) g
///
/// by least squares of p = f_i + g n + {t, n^2, n t, t^2}, n and t along and across the normal,
/// with the weights of Stencils. Where there are too few neighbors, without the terms of second
/// degree, then without t. The weights a_j add up to 1; those below 0 to about -1/3, as in (4 f_1 -
/// f_2)/3, where particles stand evenly.
///
/// error    O(s^3) with five terms
/// source   tests/sph/operators (derived there)
class BoundaryFits {
 public:
  void renew(const Cloud& cloud, const Stencils& stencils, const OperatorOptions& options);

  struct Neighbor {
    std::int32_t index;
    double weight;
  };
  struct Node {
    std::int32_t particle;
    std::vector<Neighbor> neighbors;
    double lever;  ///< sum_j a_j n_j [L]
  };

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

  /// The node that a particle is; it must be one.
  [[nodiscard]] const Node& of(std::size_t particle) const {
    return nodes_[static_cast<std::size_t>(number_[particle])];
  }

 private:
  std::vector<Node> nodes_;
  std::vector<std::int32_t> number_;  // of a particle among the nodes
};

}  // namespace vortree::sph
