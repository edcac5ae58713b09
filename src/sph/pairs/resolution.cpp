#include "sph/pairs/resolution.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace vortree::sph {
namespace {

constexpr int deepest = 30;

void append(Particles& p, double x, double y, double mass, double reach, std::uint32_t root,
            std::uint64_t path) {
  p.x.push_back(x), p.y.push_back(y), p.mass.push_back(mass), p.reach.push_back(reach);
  p.root.push_back(root), p.path.push_back(path);
}

// Drops the particles that have gone, keeping the order.
void drop(Particles& p, const std::vector<bool>& gone) {
  const auto keep = [&](auto& values) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i >= gone.size() || !gone[i]) values[count++] = values[i];
    }
    values.resize(count);
  };
  keep(p.x), keep(p.y), keep(p.mass), keep(p.reach), keep(p.root), keep(p.path);
}

void append_merged(Particles& p, const std::uint32_t* four) {
  double x = 0, y = 0, mass = 0, reach = 0;
  for (int q = 0; q < 4; ++q) {
    const std::uint32_t i = four[q];
    x += p.mass[i] * p.x[i], y += p.mass[i] * p.y[i];
    mass += p.mass[i], reach = std::max(reach, p.reach[i]);
  }
  append(p, x / mass, y / mass, mass, 2 * reach, p.root[four[0]], p.path[four[0]] >> 2);
}

}  // namespace

int Particles::level(std::size_t i) const {
  return (static_cast<int>(std::bit_width(path[i])) - 1) / 2;
}

void Particles::add(double px, double py, double m, double r) {
  append(*this, px, py, m, r, roots++, 1);
}

void split(Particles& p, const std::function<bool(std::size_t)>& chosen, double spacing_of_reach) {
  const std::size_t n = p.size();
  std::vector<bool> gone(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    if (p.level(i) >= deepest || !chosen(i)) continue;
    gone[i] = true;
    const double away = spacing_of_reach * p.reach[i] / 4;
    for (unsigned q = 0; q < 4; ++q) {
      append(p, p.x[i] + (q % 2 == 0 ? -away : away), p.y[i] + (q / 2 == 0 ? -away : away),
             p.mass[i] / 4, p.reach[i] / 2, p.root[i], p.path[i] << 2 | q);
    }
  }
  drop(p, gone);
}

void merge(Particles& p, const std::function<bool(std::size_t)>& chosen) {
  const std::size_t n = p.size();
  std::vector<std::uint32_t> parts;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (p.path[i] > 1 && chosen(i)) parts.push_back(i);
  }
  const auto kin = [&](std::uint32_t i) { return std::tuple(p.root[i], p.path[i] >> 2); };
  std::ranges::sort(parts, {}, [&](std::uint32_t i) { return std::tuple(kin(i), i); });
  std::vector<bool> gone(n, false);
  for (std::size_t k = 0; k + 3 < parts.size();) {
    if (kin(parts[k]) != kin(parts[k + 3])) {
      ++k;
      continue;
    }
    append_merged(p, &parts[k]);
    for (int q = 0; q < 4; ++q) gone[parts[k++]] = true;
  }
  drop(p, gone);
}

}  // namespace vortree::sph
