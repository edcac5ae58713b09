#pragma once

#include <memory>
#include <vector>

#include "body/shape.hpp"

namespace vortree::body {

/// A shape somewhere in the plane, turned anticlockwise by `angle`, radians, about its own origin.
class PlacedShape final : public Shape {
 public:
  PlacedShape(std::shared_ptr<const Shape> shape, Vec2 at, double angle = 0)
      : shape_(std::move(shape)), at_(at), turn_(angle), back_(-angle) {}

  double perimeter() const override { return shape_->perimeter(); }
  Vec2 point(double arc) const override { return at_ + turn_(shape_->point(arc)); }
  WallPoint nearest(Vec2 at) const override;
  double distance(Vec2 at) const override { return shape_->distance(back_(at - at_)); }
  bool beyond(Vec2 at, double d) const override { return shape_->beyond(back_(at - at_), d); }
  std::vector<OutlinePoint> trace() const override;

 private:
  std::shared_ptr<const Shape> shape_;
  Vec2 at_;
  Turn turn_, back_;
};

/// Several bodies, no two of which touch: the place that is nearest on any of them. Arcs of the
/// first begin at 0, those of each other where the one before it ends.
/// cost  of each member, unless its bound (Shape::beyond) says that it is too far
class ShapeGroup final : public Shape {
 public:
  explicit ShapeGroup(std::vector<std::shared_ptr<const Shape>> members);

  double perimeter() const override { return first_arc_.back(); }
  std::vector<double> perimeters() const override;
  std::size_t curve_at(double arc) const override;
  Vec2 point(double arc) const override;
  WallPoint nearest(Vec2 at) const override;
  double distance(Vec2 at) const override;
  bool beyond(Vec2 at, double d) const override;

 private:
  std::vector<std::shared_ptr<const Shape>> members_;
  std::vector<double> first_arc_;  // and where the last ends
};

/// The least distance of two outlines, which is 0 or less where they cross or one holds the other.
/// error  1e-12 of the perimeters, if the places that are nearest are among the 512 of each
///        (Shape::trace), or beside them
[[nodiscard]] double gap_between(const PlacedShape& a, const PlacedShape& b);

}  // namespace vortree::body
