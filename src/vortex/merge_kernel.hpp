#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <experimental/simd>
#include <limits>
#include <vector>

#include "vortex/blobs.hpp"
#include "vortex/merge_close.hpp"

namespace vortree::vortex::merge_kernel {

namespace stdx = std::experimental;
using Lanes = stdx::native_simd<float>;
using Lone = stdx::simd<float, stdx::simd_abi::scalar>;  // the plain twin

constexpr float never = std::numeric_limits<float>::infinity();
constexpr std::uint32_t none = ~0u;

/// The partner with which merging costs least.
struct Choice {
  std::uint32_t partner = none;
  float error = never;
};

/// What choosing a partner reads of the blobs, in single precision: a choice to seven digits is as
/// good, and twice as many fit a vector. Behind the last blob the columns go on for a vector with
/// blobs out of everybody's reach.
struct Candidates {
  std::uint32_t size;
  std::vector<float> x, y, gamma, square, inverse_cube;

  explicit Candidates(const Blobs& blobs);
};

/// Error of merging blob i with the blobs from j on, one a lane, or `never` where merge_close.hpp
/// does not allow it. Symmetric in i and j.
template <class V>
V error(const Candidates& b, std::uint32_t i, std::uint32_t j, const Merging& merging) {
  const auto from = [j](const std::vector<float>& column) {
    return V(&column[j], stdx::element_aligned);
  };
  const V gi = b.gamma[i], si = b.square[i];
  const V gj = from(b.gamma), sj = from(b.square);
  const V dx = b.x[i] - from(b.x), dy = b.y[i] - from(b.y);
  const V d2 = dx * dx + dy * dy;
  const V w = gi / (gi + gj);
  const V reduced = abs(w * gj), unlike = abs(si - sj);
  const V cost = reduced * (d2 + unlike) * max(V(b.inverse_cube[i]), from(b.inverse_cube));
  const V wide = w * si + (1.0f - w) * sj + w * (1.0f - w) * d2;
  const auto reach2 = static_cast<float>(merging.reach * merging.reach);
  const auto widest2 = static_cast<float>(merging.sigma_max * merging.sigma_max);
  V result = never;
  where(((gi > 0.0f) == (gj > 0.0f)) && d2 <= reach2 * min(si, sj) &&
            cost <= V(static_cast<float>(merging.tolerance)) && wide <= V(widest2),
        result) = cost;
  return result;
}

/// The best partner of one blob among runs of others, lane by lane.
template <class V>
class Search {
 public:
  Search(const Candidates& blobs, std::uint32_t i, const Merging& merging)
      : blobs_(blobs), merging_(merging), i_(i) {}

  /// A run is read on to whole vectors: what lies behind it are candidates, too.
  void run(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t j = first; j < last; j += V::size()) {
      const V e = error<V>(blobs_, i_, j, merging_);
      const auto better = e < least_;
      if (none_of(better)) continue;
      for (std::uint32_t k = 0; k < V::size(); ++k)
        if (better[k] && j + k != i_) {
          least_[k] = static_cast<float>(e[k]);
          partner_[k] = j + k;
        }
    }
  }

  /// Equal errors, as of coincident blobs, go to the neighbor in order: all pair up at once.
  Choice best() const {
    Choice choice;
    if (const std::uint32_t next = i_ ^ 1; next < blobs_.size)
      if (const float e = error<Lone>(blobs_, i_, next, merging_)[0]; e < never) choice = {next, e};
    for (std::uint32_t k = 0; k < V::size(); ++k)
      if (least_[k] < choice.error) choice = {partner_[k], least_[k]};
    return choice;
  }

 private:
  const Candidates& blobs_;
  const Merging& merging_;
  std::uint32_t i_;
  V least_ = never;
  std::array<std::uint32_t, V::size()> partner_{};
};

}  // namespace vortree::vortex::merge_kernel
