#include "vortex/merge_close.hpp"

#include <cmath>

#include "vortex/bins.hpp"
#include "vortex/folded_core.hpp"
#include "vortex/merge_kernel.hpp"

namespace vortree::vortex {
namespace {

using merge_kernel::Candidates;
using merge_kernel::Choice;
using merge_kernel::none;

Choice best_partner(const Candidates& blobs, std::uint32_t i, const Bins& bins,
                    const Merging& merging) {
  merge_kernel::Search<merge_kernel::Lanes> search(blobs, i, merging);
  const double distance = merging.reach * std::sqrt(blobs.square[i]);
  bins.runs_near({blobs.x[i], blobs.y[i]}, distance,
                 [&](std::uint32_t first, std::uint32_t last) { search.run(first, last); });
  return search.best();
}

/// Blob i of the merged pair (i, j).
void merge(Blobs& b, std::size_t i, std::size_t j, const Shape* wall) {
  const double gamma = b.gamma[i] + b.gamma[j], w = gamma != 0 ? b.gamma[i] / gamma : 0.5;
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

/// Blobs on their way to being merged; who is merged away, and who still seeks a partner.
struct Crowd {
  Blobs blobs;
  std::vector<Choice> choice;
  std::vector<char> gone, seeking;

  std::ptrdiff_t size() const { return std::ssize(gone); }

  void resize(std::size_t n) {
    blobs.resize(n);
    choice.resize(n);
    gone.assign(n, 0);
    seeking.resize(n);
  }
};

/// Those of `from` that are not gone, in a new order; `now` is room for their new numbers.
void gather(const Crowd& from, std::span<const std::uint32_t> order,
            std::vector<std::uint32_t>& now, Crowd& to) {
  const std::ptrdiff_t n = std::ssize(order);
  to.resize(n);
  now.resize(from.size());
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t k = 0; k < n; ++k) now[order[k]] = static_cast<std::uint32_t>(k);
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t k = 0; k < n; ++k) {
    const std::uint32_t i = order[k];
    to.blobs.put(k, from.blobs.centre(i), from.blobs.gamma[i], from.blobs.sigma[i]);
    to.seeking[k] = from.seeking[i];
    const Choice c = from.choice[i];
    to.choice[k] = c.partner == none ? c : Choice{now[c.partner], c.error};
  }
}

/// Those who seek choose among all, then each is offered to the one it has chosen.
void choose(Crowd& crowd, const Bins& bins, const Merging& merging) {
  const std::ptrdiff_t n = crowd.size();
  const Candidates candidates(crowd.blobs);
#pragma omp parallel for schedule(dynamic, 128)
  for (std::ptrdiff_t i = 0; i < n; ++i)
    if (crowd.seeking[i]) crowd.choice[i] = best_partner(candidates, i, bins, merging);
  for (std::ptrdiff_t i = 0; i < n; ++i)
    if (const Choice c = crowd.choice[i];
        crowd.seeking[i] && c.partner != none && c.error < crowd.choice[c.partner].error)
      crowd.choice[c.partner] = {static_cast<std::uint32_t>(i), c.error};
}

/// Merges all mutual pairs into their first. True if anyone seeks again.
bool merge_mutual(Crowd& crowd, const Shape* wall) {
  const std::ptrdiff_t n = crowd.size();
  const auto& choice = crowd.choice;
  const auto mutual = [&](std::uint32_t i) {
    return choice[i].partner != none && choice[choice[i].partner].partner == i;
  };
  bool any = false;
#pragma omp parallel for schedule(static) reduction(|| : any)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::uint32_t j = choice[i].partner;
    const bool paired = mutual(i);
    crowd.gone[i] = paired && j < i;
    crowd.seeking[i] = !crowd.gone[i] && j != none && (paired || mutual(j));
    any = any || crowd.seeking[i];
    if (paired && j > i) merge(crowd.blobs, i, j, wall);
  }
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < n; ++i)
    if (crowd.seeking[i]) crowd.choice[i] = {};
  return any;
}

}  // namespace

void merge_close(Blobs& blobs, const Merging& merging, const Shape* wall) {
  if (merging.tolerance <= 0 || blobs.size() < 2) return;
  const double side = merging.reach * merging.sigma_max / 4;
  Crowd crowd, sorted;
  crowd.resize(blobs.size());
  crowd.blobs = std::move(blobs);
  blobs = {};
  std::ranges::fill(crowd.seeking, 1);
  std::vector<std::uint32_t> now;
  bool any = true;
  while (any) {
    Bins bins(crowd.blobs.x, crowd.blobs.y, side, crowd.gone);
    gather(crowd, bins.order(), now, sorted);
    std::swap(crowd, sorted);
    choose(crowd, bins, merging);
    any = merge_mutual(crowd, wall);
  }
  blobs.reserve(crowd.blobs.size());
  for (std::size_t i = 0; i < crowd.gone.size(); ++i)
    if (!crowd.gone[i])
      blobs.append(crowd.blobs.centre(i), crowd.blobs.gamma[i], crowd.blobs.sigma[i]);
}

}  // namespace vortree::vortex
