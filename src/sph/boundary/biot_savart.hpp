#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "fmm/plan.hpp"
#include "sph/boundary/outer_box.hpp"
#include "sph/boundary/standing_bodies.hpp"
#include "sph/cloud/cloud.hpp"
#include "sph/operators/derivatives.hpp"

namespace vortree::sph {

/// The vorticity of a flow as point vortices: those of the particles, and of the wake that has left
/// the box, which drifts on with the stream. The velocity outside of bodies at rest in unbounded
/// fluid follows from it alone:
///
///   u(x) = U + 1/(2 pi) sum_j gamma_j (-(y - y_j), x - x_j)/|x - x_j|^2,   gamma_j = V_j omega_j
///
/// Nodes of a wall count with half their volume, as it lies half in the body. Particles near those
/// sides of the box through which no wake leaves are left out: a layer of wrong vorticity there,
/// some percent of U, would otherwise feed itself.
///
/// error    of the sums 1e-6
/// cost     O(n): fmm/plan.hpp
/// source   Weymouth & Lauber, arXiv 2404.09034, for boundary values by Biot and Savart
class BiotSavart {
 public:
  BiotSavart() = default;

  /// margin    beside sides without an outlet, within which nothing counts [L]
  /// bodies    whose walls have nodes; those that turn have a circulation, about their centres
  /// faintest  vortices of less circulation do not count [L^2/T]
  BiotSavart(const OuterBox& box, double margin, StandingBodies bodies, double faintest)
      : box_(box), margin_(margin), bodies_(std::move(bodies)), faintest_(faintest) {}

  /// Where vortices are and how they move, as seen from the box; what has left, with the stream.
  struct Vortices {
    std::vector<double> x, y, gamma, sigma, u, v;
  };
  [[nodiscard]] const Vortices& vortices() const { return all_; }

  /// Takes up the vorticity of a cloud. The steady stream tells the side by which it leaves.
  ///
  /// stream   that the box meets
  void renew(const Cloud& cloud, const std::vector<Slopes>& slopes, Vec2 steady, Vec2 stream);

  /// And the sheet of a wall that slips: (u - u_wall).t ds at each node.
  void add_sheet(const Cloud& cloud);

  /// What has left drifts on, and what flows out of the outlet in a step follows,
  ///
  ///   d gamma = u.n omega ds dt   at each of its nodes,
  ///
  /// as a vortex for each node and half a spacing of way, in the middle of what has left so far.
  ///
  /// drift   how far the fluid outside moves meanwhile, as seen from the box [L]
  void carry_out(const Cloud& cloud, const std::vector<Slopes>& slopes, Vec2 steady, Vec2 drift,
                 double dt);

  /// At nodes outside of the vorticity, with the stream.
  void velocity(const std::vector<double>& x, const std::vector<double>& y, Vec2 stream,
                std::span<double> u, std::span<double> v) const;

  /// Amid the vorticity, without the stream: particles have Gaussian cores of 1.5 spacings, and
  /// what has left of as many of the outlet's.
  void velocity_among(const std::vector<double>& x, const std::vector<double>& y,
                      std::span<double> u, std::span<double> v) const;

  [[nodiscard]] double circulation() const;    ///< of all [L^2/T]
  [[nodiscard]] Vec2 impulse() const;          ///< sum gamma (y, -x) of all [L^3/T]
  [[nodiscard]] double second_moment() const;  ///< sum gamma |x|^2 of all [L^4/T]

  // To be saved: what has left; what is about to, of each node of the outlet in the order of their
  // places, and the way that fluid has drifted meanwhile.
  std::vector<double> left_x, left_y, left_gamma, leaving;
  Vec2 travelled{};

 private:
  void add(Vec2 at, Vec2 velocity, double gamma, double spacing);
  void release(const Cloud& cloud, const std::vector<std::uint32_t>& outlet);

  [[nodiscard]] fmm::Plan plan(std::size_t targets, std::span<const double> cores) const;

  OuterBox box_{};
  double margin_ = 0;
  StandingBodies bodies_;
  double faintest_ = 0;
  Vortices all_;
};

}  // namespace vortree::sph
