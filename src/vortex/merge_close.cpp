#include "vortex/merge_close.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "vortex/bins.hpp"
#include "vortex/folded_core.hpp"

namespace vortree::vortex {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::uint32_t none = ~0u;

/// The partner with which merging costs least.
struct Choice {
  std::uint32_t partner = none;
  double error = never;
};

/// Error of merging i and j, or `never` where it is not allowed. Symmetric in i and j, and free of
/// branches so that compilers make vectors of it.
inline double merger_error(const Blobs& b, std::size_t i, std::size_t j, const Merging& merging) {
  const double gi = b.gamma[i], gj = b.gamma[j];
  const double dx = b.x[i] - b.x[j], dy = b.y[i] - b.y[j];
  const double d2 = dx * dx + dy * dy;
  const double least = std::min(b.sigma[i], b.sigma[j]);
  const double si = b.sigma[i] * b.sigma[i], sj = b.sigma[j] * b.sigma[j];
  const double w = gi / (gi + gj);
  const double error = std::abs(w * gj) * (d2 + std::abs(si - sj)) / (least * least * least);
  const double wide = w * si + (1 - w) * sj + w * (1 - w) * d2;
  const bool allowed = (gi * gj > 0) & (d2 <= merging.reach * merging.reach * least * least) &
                       (error <= merging.tolerance) &
                       (wide <= merging.sigma_max * merging.sigma_max);
  return allowed ? error : never;
}

Choice best_partner(const Blobs& blobs, std::uint32_t i, const Bins& bins, const Merging& merging) {
  constexpr std::uint32_t block = 64;
  std::array<double, block> error;
  Choice best;
  bins.runs_near(blobs.centre(i), [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t j = first; j < last; j += block) {
      const std::uint32_t count = std::min(block, last - j);
#pragma omp simd
      for (std::uint32_t k = 0; k < count; ++k) error[k] = merger_error(blobs, i, j + k, merging);
      for (std::uint32_t k = 0; k < count; ++k)
        if (error[k] < best.error && j + k != i) best = {j + k, error[k]};
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
  Bins sort(double distance) {
    Bins bins(blobs.x, blobs.y, distance);
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
#pragma omp parallel for schedule(dynamic, 128)
    for (std::ptrdiff_t i = 0; i < n; ++i)
      if (seeking[i]) choice[i] = best_partner(blobs, i, bins, merging);
    for (std::uint32_t i = 0; i < n; ++i)
      if (const Choice c = choice[i];
          seeking[i] && c.partner != none && c.error < choice[c.partner].error)
        choice[c.partner] = {i, c.error};
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
  const double widest = *std::max_element(blobs.sigma.begin(), blobs.sigma.end());
  const double distance = merging.reach * std::min(widest, merging.sigma_max);
  Mergers mergers(std::move(blobs));
  do {
    const Bins bins = mergers.sort(distance);
    mergers.choose(bins, merging);
  } while (mergers.merge_mutual(wall));
  blobs = std::move(mergers.blobs);
}

}  // namespace vortree::vortex
