#include "sph/adapt/population.hpp"

#include <cmath>

#include "sph/operators/interpolate.hpp"

namespace vortree::sph {

std::size_t Population::put(Vec2 at, double spacing,
                            const std::array<double, carried_count>& values) {
  const std::size_t k = cloud_.add(at, spacing, ParticleKind::fluid);
  for (std::size_t field = 0; field < carried_count; ++field)
    (cloud_.*carried[field])[k] = values[field];
  gone_.push_back(0);
  return k;
}

std::size_t Population::add(std::size_t parent, Vec2 by, double spacing) {
  return put(cloud_.at(parent) + by, spacing, carried_at(cloud_, parent, slopes_[parent], by));
}

std::size_t Population::add_among(std::size_t node, Vec2 by, double spacing) {
  std::array<double, carried_count> sum{};
  double weights = 0;
  const auto count = [&](std::size_t j, Vec2 apart) {
    const Vec2 d = by - apart;
    const double w = share_of_series(d, cloud_.volume(j));
    if (w == 0) return;
    const auto values = carried_at(cloud_, j, slopes_[j], d);
    for (std::size_t field = 0; field < carried_count; ++field) sum[field] += w * values[field];
    weights += w;
  };
  count(node, {});
  for_each_neighbor(node, count);
  for (double& value : sum) value /= weights;
  return put(cloud_.at(node) + by, spacing, sum);
}

std::size_t Population::merge(std::size_t i, std::size_t j) {
  const double a = cloud_.volume(i), b = cloud_.volume(j), share = a / (a + b);
  const Vec2 apart = nearest_image(cloud_.at(j) - cloud_.at(i), period_);
  auto values = carried_at(cloud_, i, slopes_[i], (1 - share) * apart);
  const auto others = carried_at(cloud_, j, slopes_[j], -share * apart);
  for (std::size_t field = 0; field < carried_count; ++field)
    values[field] = share * values[field] + (1 - share) * others[field];
  const std::size_t k = put(cloud_.at(i) + (1 - share) * apart, std::sqrt(a + b), values);
  remove(i), remove(j);
  return k;
}

}  // namespace vortree::sph
