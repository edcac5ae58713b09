#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "body/outlines/grading.hpp"
#include "body/shape.hpp"
#include "fmm/options.hpp"
#include "vortex/blobs/velocities.hpp"
#include "vortex/cores/folded_centroid.hpp"
#include "vortex/wall/far_moments.hpp"
#include "vortex/wall/linear_system.hpp"
#include "vortex/wall/near_panels.hpp"

namespace vortree::vortex {

/// One of the bodies that a wall goes around.
///
/// shape    as seen from the wall's origin
/// centre   about which its moments are told
/// grading  where its panels are, if it is known by now
struct WallBody {
  std::shared_ptr<const body::Shape> shape;
  int panels;
  Vec2 centre{};
  std::optional<body::Grading> grading{};
};

/// The panels of one body among those of a wall: they lie one after another.
///
/// arc     where its first panel begins, along all of the wall
/// length  of each of them, in the mean
/// even    all have that length
struct Ring {
  std::size_t first, panels;
  double arc, length;
  Vec2 centre;
  bool even;

  std::size_t end() const { return first + panels; }
  /// Of values of all panels, those of this body.
  template <class Values>
  auto of(Values& values) const {
    return std::span(values).subspan(first, panels);
  }
};

/// A vortex sheet on the outlines of bodies that holds all interiors at rest. Each outline s(t) is
/// in panels from t = i to i + 1 (body/outlines/grading.hpp), of length b_i = ds/dt in the middle.
///
/// The slip of stream and blobs along panel i, averaged over it, fixes the sheet:
///
///   gamma_i/2 - sum_j b_j K(x_i, x_j) gamma_j = slip_i,   K(x, x') = (1/2 pi) d/dn ln|x - x'|,
///   sum_i b_i gamma_i = total,  of each body,
///
/// gamma, slip and tangent all anticlockwise (the bare stream past a circle gives -2 U sin theta).
/// The trapezoid rule converges faster than any power of b on a smooth curve; K(x, x) is the
/// curvature/(4 pi). Between bodies, and between the two sides of a thin one, it errs by
/// exp(-2 pi distance/b). The matrix is factorised once. The average over a panel is
/// 1/b_i int slip ds; that of a vortex's tangential velocity is the angle under which it sees the
/// panel, gamma/(2 pi b) * angle: exact however near it is. A core that the wall folds is seen as
/// three bare points with its second moments (three_points.hpp), a free one as one.
/// cost    setting up O(panels^3) once; a sheet O(panels^2 + blobs near the wall)
/// source  Koumoutsakos, Leonard & Pepin, J. Comput. Phys. 113 (1994), eq. 12-15
class Wall {
 public:
  /// throws std::invalid_argument for fewer than 8 panels
  explicit Wall(std::vector<WallBody> bodies);
  Wall(std::shared_ptr<const body::Shape> shape, int panels)
      : Wall(std::vector<WallBody>{{std::move(shape), panels}}) {}

  /// Of all bodies.
  const body::Shape& shape() const { return *shape_; }
  std::span<const Ring> rings() const { return rings_; }
  /// The number of the ring that has this panel, or this arc.
  std::size_t ring_of(std::size_t panel) const;
  std::size_t ring_at(double arc) const { return shape_->curve_at(arc); }

  std::size_t panels() const { return middle_.size(); }
  double panel_length(std::size_t i) const { return length_[i]; }
  std::span<const double> panel_lengths() const { return length_; }
  /// Of its middle, along all of the wall.
  double arc(std::size_t i) const { return arc_[i]; }
  /// The panel of a body where this arc is, along all of the wall.
  std::size_t panel_at(std::size_t ring, double arc) const {
    return rings_[ring].first + parts_[ring].near.panel_at(arc - rings_[ring].arc);
  }
  Vec2 middle(std::size_t i) const { return middle_[i]; }
  std::span<const Vec2> middles() const { return middle_; }
  Vec2 tangent(std::size_t i) const { return tangent_[i]; }

  /// Points where the far field is sampled for the slip: two Gauss points a panel.
  tree::Points samples() const { return {sample_x_, sample_y_}; }

  /// Of what was found there, the mean along a panel.
  Vec2 mean_of_samples(const Velocities& at_samples, std::size_t i) const;

  /// Average slip along each panel: stream, the bare velocity at samples(), what the samples miss
  /// of the vortices closer than a few panels, and the second moments of folded cores.
  std::vector<double> slip(Vec2 stream, const Velocities& at_samples, const FoldedBlobs& folded,
                           std::span<const double> gamma) const;

  /// The sheet that cancels a slip, with a circulation for each body; or with one for all, which
  /// they share by their perimeters.
  std::vector<double> sheet(std::span<const double> slip, std::span<const double> totals) const;
  std::vector<double> sheet(std::span<const double> slip, double total) const;

  /// Shares of a circulation that belongs to all bodies together.
  std::vector<double> shared(double total) const;

  /// Adds the velocity of a sheet at points of the fluid: panels as point vortices from afar (for
  /// them the trapezoid rule errs by exp(-2 pi distance/b)), exact panel integrals near.
  ///
  /// found  wall points nearest to the targets
  void add_velocity(std::span<const double> sheet, const fmm::Options& sums, tree::Points targets,
                    Velocities& u, const WallPoints& found = WallPoints()) const;

  /// Adds the stream function of a sheet at points of the fluid and on the wall,
  ///
  ///   psi = -1/(2 pi) int gamma ln r ds,
  ///
  /// of panels as point vortices from afar, as integrals near.
  void add_stream_function(std::span<const double> sheet, const fmm::Options& sums,
                           tree::Points targets, std::span<double> psi) const;

  /// Adds the potential of a layer of dipoles q along the wall, of strength (x, y) per unit length,
  /// at points of the fluid,
  ///
  ///   (1/2 pi) oint q (x - x')/r^2 ds,
  ///
  /// of panels as points from afar, as integrals of what is linear along each chord near.
  void add_dipoles(std::span<const double> x, std::span<const double> y, const fmm::Options& sums,
                   tree::Points targets, std::span<double> potential) const;

  /// 2 pi K(x_i, x_j) for all j [1/m].
  std::vector<double> kernel(std::size_t i) const;

  /// Of a body [m^2], and int x dA over it [m^3]; of the first, or of that with this number.
  double area(std::size_t ring = 0) const;
  Vec2 area_moment(std::size_t ring = 0) const;

  /// sum of gamma b x over the panels.
  Vec2 first_moment(std::span<const double> sheet) const;

 private:
  /// What the panels of a body are to points near them, and far away.
  struct Part {
    std::shared_ptr<const body::Shape> shape;
    NearPanels near;
    FarMoments far;
  };

  /// What the two samples a panel miss of some vortices: of those close to it, and of cores.
  struct Missed {
    std::vector<std::vector<double>> near;     // a value a panel, of each body
    std::vector<std::vector<double>> moments;  // of folded cores, for panels far along the wall
    Missed& operator+=(const Missed& other);
  };

  void add_body(const WallBody& body, double arc);
  /// Of the panels of one body, as point vortices.
  void add_velocity_of_points(const Ring& ring, std::span<const double> sheet,
                              const fmm::Options& sums, tree::Points targets, Velocities& u) const;
  /// Calls use(number, place, arc along the body) for targets that are near a body.
  void each_near(std::size_t k, tree::Points targets, const WallPoints& found,
                 const auto& use) const;
  Missed missed_by_samples(const FoldedBlobs& folded, std::span<const double> gamma,
                           std::size_t first, std::size_t last) const;
  void add_core(Vec2 at, const Deviator& deviator, const body::WallPoint& nearest, double gamma,
                Missed& missed) const;
  /// The place on one body, its arc counted from there, that is nearest to a point, of which the
  /// nearest on all bodies is known or none is; or none if that is farther than `reach`.
  body::WallPoint nearest_on(std::size_t k, const body::WallPoint& known, Vec2 at,
                             double reach) const;

  std::shared_ptr<const body::Shape> shape_;
  std::vector<Ring> rings_;
  std::vector<Part> parts_;
  std::vector<Vec2> edge_, middle_, tangent_;
  std::vector<double> sample_x_, sample_y_, sample_stretch_, middle_x_, middle_y_, length_, arc_;
  std::optional<LinearSystem> system_;
};

}  // namespace vortree::vortex
