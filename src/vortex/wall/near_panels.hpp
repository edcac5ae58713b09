#pragma once

#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "tree/order/points.hpp"
#include "vortex/wall/three_points.hpp"
#include "vortex/wall/tuning.hpp"

namespace vortree::vortex {

/// The panels of one body, one after another.
///
/// edge    where each begins; middle and tangent half a step of t on
/// sample  places where far fields are sampled, two a panel; stretch is ds/dt there over that in
///         the middle
/// arc     where each begins, from 0 on
struct PanelsOfBody {
  std::span<const Vec2> edge, middle, tangent;
  tree::Points sample;
  std::span<const double> stretch, length, arc;
};

/// What panels are to points near them, beyond what their middles and samples are: six to either
/// side of the nearest, a vector of them at a time.
///
/// Values of panels are kept `wrapped` around the curve, so that any such window lies side by side.
class NearPanels {
 public:
  explicit NearPanels(const PanelsOfBody& panels);

  std::vector<double> wrapped(std::span<const double> values) const;
  /// Adds up what was added to the same panel, here or around the curve.
  std::vector<double> unwrapped(std::span<const double> values) const;
  std::vector<double> wrapped_zeros() const { return std::vector<double>(places()); }

  /// Velocity of a sheet (wrapped) near the arc, less that of its panels as point vortices.
  Vec2 correction(Vec2 at, double arc, std::span<const double> sheet) const;

  /// The same of its stream function, without a step where the correction ends. Each chord is moved
  /// out to the mean of its arc, by 2/3 of its sagitta, and has the circulation of the arc: else a
  /// dipole of gamma b^3 curvature/12 is missing. And what the midpoint rule owes to the ends of a
  /// window, 1/24 of d(b f)/dt there, is no part of what it errs by all around.
  double stream_correction(Vec2 at, double arc, std::span<const double> sheet) const;

  /// Dipoles along the wall, per unit length, and how they change along it; all wrapped.
  struct DipoleLayer {
    std::vector<double> x, y, slope_x, slope_y;
  };
  DipoleLayer layer(std::span<const double> x, std::span<const double> y) const;

  /// Potential of a layer of dipoles near the arc, (1/2 pi) int q (x - x')/r^2 ds, less that of its
  /// panels as points. On each chord q is linear: of constant ones the potential would be in steps
  /// beside the wall.
  double dipole_correction(Vec2 at, double arc, const DipoleLayer& q) const;

  /// Adds to `missed` (wrapped) the average velocity along each panel of a vortex near the arc,
  /// less the mean of that at the panel's two samples.
  void add_missed(Vec2 at, double arc, double gamma, std::span<double> missed) const;

  /// Adds to `missed` (wrapped) what the average velocity along the panels near the arc, or along
  /// all panels, gains if a vortex becomes three points.
  void add_aside(Vec2 at, const ThreePoints& points, double arc, double gamma,
                 std::span<double> missed) const;
  void add_aside_everywhere(Vec2 at, const ThreePoints& points, double gamma,
                            std::span<double> missed) const;

  /// The panel in the middle of the window at this arc, and how many there are to either side.
  std::size_t panel_at(double arc) const { return first_place(arc) % panels_; }
  std::size_t aside() const;

  double length_at(double arc) const { return length_[first_place(arc) + exact_aside]; }
  double longest() const { return longest_; }
  /// Whether integrals over panels are exact for what is so far from the wall, nearest to this arc.
  bool close(double distance, double arc) const;

 private:
  double owed_at_end(Vec2 at, std::size_t place, bool last, std::span<const double> sheet,
                     double b) const;
  std::size_t places() const;
  std::size_t first_place(double arc) const;

  struct Column {
    std::vector<double> x, y;
  };
  Column column(auto of_panel) const;

  std::size_t panels_;
  double longest_;
  bool even_;
  std::vector<double> arc_, length_, per_length_, stretch_[2];  // per_length: 1/(2 pi length)
  Column begin_, end_, chord_, middle_, tangent_, sample_[2];
  std::vector<double> counts_;  // 1 for the panels of a window, 0 for what fills its last vector
};

}  // namespace vortree::vortex
