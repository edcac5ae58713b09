#include "sph/cloud/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tree/order/sort.hpp"

namespace vortree::sph {
namespace {

/// act(column) for each.
void for_each_column(Cloud& cloud, const auto& act) {
  act(cloud.x), act(cloud.y), act(cloud.spacing), act(cloud.kind), act(cloud.place);
  act(cloud.nx), act(cloud.ny), act(cloud.was);
  for (const auto field : carried) act(cloud.*field);
}

}  // namespace

std::size_t Cloud::add(Vec2 at, double s, ParticleKind of) {
  for_each_column(*this, [](auto& column) { column.emplace_back(); });
  x.back() = at.x, y.back() = at.y, spacing.back() = s, kind.back() = of, was.back() = -1;
  return size() - 1;
}

std::size_t Cloud::add(const BoundaryNode& node, ParticleKind of, std::int32_t number) {
  add(node.at, node.spacing, of);
  place.back() = number, nx.back() = node.normal.x, ny.back() = node.normal.y;
  return size() - 1;
}

void Cloud::remove(std::span<const char> gone) {
  for_each_column(*this, [&](auto& column) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < gone.size(); ++i)
      if (!gone[i]) column[kept++] = column[i];
    column.resize(kept);
  });
}

void Cloud::reorder(std::span<const std::uint32_t> order) {
  for_each_column(*this, [&](auto& column) {
    const auto before = column;
    for (std::size_t i = 0; i < order.size(); ++i) column[i] = before[order[i]];
  });
}

double wrapped(double x, double period) {
  return period == 0 ? x : x - period * std::floor(x / period);
}

void wrap(Cloud& cloud, double period) {
  for (std::vector<double>* of : {&cloud.x, &cloud.y})
    for (double& x : *of) x = wrapped(x, period);
}

std::vector<std::uint32_t> in_order(const Cloud& cloud, ParticleKind kind) {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if (cloud.kind[i] == kind) nodes.push_back(i);
  std::ranges::sort(nodes, {}, [&](std::uint32_t i) { return cloud.place[i]; });
  return nodes;
}

void number(Cloud& cloud) {
  cloud.was.resize(cloud.size());
  std::iota(cloud.was.begin(), cloud.was.end(), 0);
}

void sort(Cloud& cloud) {
  const tree::MortonOrder order = tree::morton_order(cloud.points(), tree::enclose(cloud.points()));
  cloud.reorder({order.index.data(), order.index.size()});
}

}  // namespace vortree::sph
