#include "vortex/moving_wall.hpp"

#include <algorithm>

#include "body/outlines/shape_group.hpp"

namespace vortree::vortex {
namespace {

constexpr std::size_t most_kept = 4;

/// Out of its place: a circle that spins about its centre stands.
bool moves(const body::Motion& own) {
  return own.course.moves() || own.plunge.frequency > 0;
}

}  // namespace

MovingWall::MovingWall(std::vector<WallBody> bodies, std::vector<body::Motion> own, bool turns)
    : bodies_(std::move(bodies)), own_(std::move(own)), moves_(std::ranges::any_of(own_, moves)) {
  for (WallBody& body : bodies_) body.grading.emplace(*body.shape, body.panels);
  if (!turns && std::ranges::none_of(own_, [](const auto& one) { return one.turns(); })) return;
  for (const WallBody& body : bodies_)
    alone_.emplace_back(Wall({{body.shape, body.panels, {}, body.grading}}));
}

std::size_t MovingWall::panels() const {
  std::size_t sum = 0;
  for (const WallBody& body : bodies_) sum += body.panels;
  return sum;
}

double MovingWall::perimeter() const {
  double sum = 0;
  for (const WallBody& body : bodies_) sum += body.shape->perimeter();
  return sum;
}

std::shared_ptr<const Standing> MovingWall::at(double time) const {
  const auto found = std::ranges::find_if(
      recent_, [&](const auto& known) { return !moves_ || known.first == time; });
  if (found != recent_.end()) return found->second;
  recent_.emplace_back(time, made(time));
  if (recent_.size() > most_kept) recent_.pop_front();
  return recent_.back().second;
}

/// A body that stands in the frame's origin and is not turned is left as it is.
std::shared_ptr<const Standing> MovingWall::made(double time) const {
  std::vector<WallBody> placed;
  std::vector<double> angles;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const body::Kinematics own = own_[k].at(time);
    const Vec2 at = bodies_[k].centre + own.place;
    angles.push_back(moves(own_[k]) ? own.angle : 0);
    const bool plain = at == Vec2{} && angles.back() == 0;
    placed.push_back(
        {plain ? bodies_[k].shape
               : std::make_shared<body::PlacedShape>(bodies_[k].shape, at, angles.back()),
         bodies_[k].panels, at, bodies_[k].grading});
  }
  auto standing = std::make_shared<Standing>(Standing{Wall(std::move(placed)), {}});
  for (std::size_t k = 0; k < alone_.size(); ++k)
    standing->turning.push_back(alone_[k].among(standing->wall, k, angles[k]));
  return standing;
}

}  // namespace vortree::vortex
