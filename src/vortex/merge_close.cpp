#include "vortex/merge_close.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "vortex/bins.hpp"
#include "vortex/folded_core.hpp"

namespace vortree::vortex {
namespace {

constexpr float never = std::numeric_limits<float>::infinity();
constexpr std::uint32_t none = ~0u;

/// The partner with which merging costs least.
struct Choice {
  std::uint32_t partner = none;
  float error = never;
};

/// What choosing a partner reads of the blobs, in single precision: a choice to seven digits is as good,
/// and twice as many fit a vector.
struct Candidates {
  std::vector<float> x, y, gamma, square, inverse_cube;

  /// Quartered often enough, circulations vanish in single precision; their sign must not.
  static float shown(double gamma) {
    return static_cast<float>(std::copysign(std::max(std::abs(gamma), 1e-30), gamma));
  }

  explicit Candidates(const Blobs& blobs) {
    for (std::size_t i = 0; i < blobs.size(); ++i) {
      const double s = blobs.sigma[i];
      x.push_back(static_cast<float>(blobs.x[i]));
      y.push_back(static_cast<float>(blobs.y[i]));
      gamma.push_back(shown(blobs.gamma[i]));
      square.push_back(static_cast<float>(s * s));
      inverse_cube.push_back(static_cast<float>(1 / (s * s * s)));
    }
  }
};

/// Error of merging i and j, or `never` where it is not allowed. Symmetric in i and j, and free of
/// branches so that compilers make vectors of it.
inline float merger_error(const Candidates& b, std::size_t i, std::size_t j, float tolerance,
                          float reach2, float widest2) {
  const float gi = b.gamma[i], gj = b.gamma[j];
  const float dx = b.x[i] - b.x[j], dy = b.y[i] - b.y[j];
  const float d2 = dx * dx + dy * dy;
  const float si = b.square[i], sj = b.square[j];
  const float w = gi / (gi + gj);
  const float error =
      std::abs(w * gj) * (d2 + std::abs(si - sj)) * std::max(b.inverse_cube[i], b.inverse_cube[j]);
  const float wide = w * si + (1 - w) * sj + w * (1 - w) * d2;
  const bool allowed = ((gi > 0) == (gj > 0)) & (d2 <= reach2 * std::min(si, sj)) & (error <= tolerance) &
                       (wide <= widest2);
  return allowed ? error : never;
}

Choice best_partner(const Candidates& blobs, std::uint32_t i, const Bins& bins,
                    const Merging& merging) {
  constexpr std::uint32_t block = 128;
  const auto tolerance = static_cast<float>(merging.tolerance);
  const auto reach2 = static_cast<float>(merging.reach * merging.reach);
  const auto widest2 = static_cast<float>(merging.sigma_max * merging.sigma_max);
  std::array<float, block> error;
  Choice best;
  const double distance = merging.reach * std::sqrt(blobs.square[i]);
  bins.runs_near({blobs.x[i], blobs.y[i]}, distance, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t j = first; j < last; j += block) {
      const std::uint32_t count = std::min(block, last - j);
      float least = never;
#pragma omp simd reduction(min : least)
      for (std::uint32_t k = 0; k < count; ++k) {
        const float e = merger_error(blobs, i, j + k, tolerance, reach2, widest2);
        error[k] = j + k == i ? never : e;
        least = std::min(least, error[k]);
      }
      if (least >= best.error) continue;
      const auto found = std::find(error.begin(), error.begin() + count, least);
      best = {j + static_cast<std::uint32_t>(found - error.begin()), least};
    }
  });
  return best;
}

/// Blob i of the merged pair (i, j).
void merge(Blobs& b, std::size_t i, std::size_t j, const Shape* wall) {
  const double gamma = b.gamma[i] + b.gamma[j], w = b.gamma[i] / gamma;
  const double mean_square = w * b.sigma[i] * b.sigma[i] + (1 - w) * b.sigma[j] * b.sigma[j];
  const Vec2 apart = b.centre(i) - b.centre(j);
  Placed merged{w * b.centre(i) + (1 - w) * b.centre(j),
                std::sqrt(mean_square + w * (1 - w) * dot(apart, apart))};
  if (wall && folded::applies(wall->nearest(merged.centre).distance, 2 * merged.sigma)) {
    const double across = wall->nearest(b.centre(i)).distance - wall->nearest(b.centre(j)).distance;
    const Vec2 mean = w * acting_position(b.centre(i), b.sigma[i], wall) +
                      (1 - w) * acting_position(b.centre(j), b.sigma[j], wall);
    merged = place(mean, std::sqrt(mean_square + 2 * w * (1 - w) * across * across), wall);
  }
  b.x[i] = merged.centre.x;
  b.y[i] = merged.centre.y;
  b.gamma[i] = gamma;
  b.sigma[i] = merged.sigma;
}

/// Blobs on their way to being merged, sorted by place; who still seeks a partner.
struct Mergers {
  Blobs blobs;
  std::vector<Choice> choice;
  std::vector<char> seeking;

  explicit Mergers(Blobs start)
      : blobs(std::move(start)), choice(blobs.size()), seeking(blobs.size(), 1) {}

  /// Sorts by place and returns the bins of the new order.
  Bins sort(double side) {
    Bins bins(blobs.x, blobs.y, side);
    Mergers sorted{Blobs{}};
    sorted.blobs.reserve(blobs.size());
    std::vector<std::uint32_t> now(blobs.size());
    for (std::uint32_t i : bins.order()) {
      now[i] = static_cast<std::uint32_t>(sorted.blobs.size());
      sorted.blobs.append(blobs.centre(i), blobs.gamma[i], blobs.sigma[i]);
      sorted.choice.push_back(choice[i]);
      sorted.seeking.push_back(seeking[i]);
    }
    for (Choice& c : sorted.choice)
      if (c.partner != none) c.partner = now[c.partner];
    *this = std::move(sorted);
    return bins;
  }

  /// Those who seek choose among all, then each is offered to the one it has chosen.
  void choose(const Bins& bins, const Merging& merging) {
    const auto n = static_cast<std::ptrdiff_t>(blobs.size());
    const Candidates candidates(blobs);
#pragma omp parallel for schedule(dynamic, 128)
    for (std::ptrdiff_t i = 0; i < n; ++i)
      if (seeking[i]) choice[i] = best_partner(candidates, i, bins, merging);
    for (std::ptrdiff_t i = 0; i < n; ++i)
      if (const Choice c = choice[i];
          seeking[i] && c.partner != none && c.error < choice[c.partner].error)
        choice[c.partner] = {static_cast<std::uint32_t>(i), c.error};
  }

  /// Merges all mutual pairs, and drops what is merged away. True if anyone seeks again.
  bool merge_mutual(const Shape* wall) {
    const auto n = static_cast<std::uint32_t>(blobs.size());
    const auto mutual = [&](std::uint32_t i) {
      return choice[i].partner != none && choice[choice[i].partner].partner == i;
    };
    std::vector<char> paired(n);
    for (std::uint32_t i = 0; i < n; ++i) paired[i] = mutual(i);
    Mergers kept{Blobs{}};
    kept.blobs.reserve(n);
    std::vector<std::uint32_t> now(n);
    bool any = false;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = choice[i].partner;
      now[i] = static_cast<std::uint32_t>(kept.blobs.size());
      if (paired[i] && j < i) continue;
      if (paired[i]) merge(blobs, i, j, wall);
      const bool again = j != none && (paired[i] || paired[j]);
      kept.blobs.append(blobs.centre(i), blobs.gamma[i], blobs.sigma[i]);
      kept.choice.push_back(again ? Choice{} : choice[i]);
      kept.seeking.push_back(again);
      any |= again;
    }
    for (Choice& c : kept.choice)
      if (c.partner != none) c.partner = now[c.partner];
    *this = std::move(kept);
    return any;
  }
};

}  // namespace

void merge_close(Blobs& blobs, const Merging& merging, const Shape* wall) {
  if (merging.tolerance <= 0 || blobs.size() < 2) return;
  const double side = merging.reach * merging.sigma_max / 4;
  Mergers mergers(std::move(blobs));
  do {
    const Bins bins = mergers.sort(side);
    mergers.choose(bins, merging);
  } while (mergers.merge_mutual(wall));
  blobs = std::move(mergers.blobs);
}

}  // namespace vortree::vortex
