#include "sph/boundary/standing_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "body/outlines/shape_group.hpp"
#include "sph/boundary/wall_nodes.hpp"

namespace vortree::sph {

StandingBody stand(std::shared_ptr<const body::Shape> shape, double spacing, Vec2 centre,
                   double spin) {
  const double perimeter = shape->perimeter(), area = area_of(*shape);
  const int nodes = static_cast<int>(std::lround(perimeter / spacing));
  if (centre != Vec2{}) shape = std::make_shared<body::PlacedShape>(std::move(shape), centre);
  return {std::move(shape), centre, spin, area, nodes, perimeter / nodes};
}

StandingBodies::StandingBodies(std::vector<StandingBody> bodies) : bodies_(std::move(bodies)) {
  std::size_t first = 0;
  std::vector<std::shared_ptr<const body::Shape>> shapes;
  for (StandingBody& one : bodies_) {
    one.first = std::exchange(first, first + static_cast<std::size_t>(one.nodes));
    shapes.push_back(one.shape);
  }
  if (shapes.size() == 1) shape_ = shapes.front();
  if (shapes.size() > 1) shape_ = std::make_shared<body::ShapeGroup>(std::move(shapes));
}

double StandingBodies::area() const {
  double sum = 0;
  for (const StandingBody& one : bodies_) sum += one.area;
  return sum;
}

std::vector<int> StandingBodies::nodes_of_each() const {
  std::vector<int> all;
  for (const StandingBody& one : bodies_) all.push_back(one.nodes);
  return all;
}

const StandingBody& StandingBodies::nearest(Vec2 at) const {
  if (size() == 1) return bodies_.front();
  return *std::ranges::min_element(
      bodies_, {}, [&](const StandingBody& one) { return one.shape->distance(at); });
}

bool StandingBodies::within(Vec2 at, double spacings) const {
  return std::ranges::any_of(bodies_, [&](const StandingBody& one) {
    const double least = spacings * one.spacing;
    return !one.shape->beyond(at, least) && one.shape->distance(at) < least;
  });
}

std::vector<double> StandingBodies::shared(double circulation) const {
  if (size() == 1) return {circulation};
  double all = 0;
  for (const StandingBody& one : bodies_) all += one.shape->perimeter();
  std::vector<double> shares;
  for (const StandingBody& one : bodies_)
    shares.push_back(circulation * one.shape->perimeter() / all);
  return shares;
}

}  // namespace vortree::sph
