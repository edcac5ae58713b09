#pragma once

#include <vector>

#include "flow/solver.hpp"
#include "sph/boundary/biot_savart.hpp"
#include "sph/boundary/smooth_pressure.hpp"
#include "sph/boundary/vorticity_force.hpp"
#include "sph/cloud/cloud.hpp"
#include "sph/motion/momentum.hpp"
#include "sph/operators/derivatives.hpp"
#include "sph/operators/stencils.hpp"
#include "sph/setup.hpp"

namespace vortree::sph {

/// A flow by incompressible SPH of variable resolution: past bodies, from the potential flow of the
/// stream around them on, or in a periodic box, from an initial flow on that fills the plane.
///
/// Forces are those at the wall, of the pressure without its noise (boundary/smooth_pressure.hpp);
/// the moment, which has no other route, is of the pressure as it is.
/// By impulse its rate of change comes from velocities and vorticity of one time
/// (boundary/vorticity_force.hpp): births, splits and mergers change the impulse itself by some
/// 1e-3 a step, of which differences in time would make a tenth of the drag.
///
/// Of several bodies the force is that on all, and its moment about the centre of the first; each
/// has its own by the same formulas, about its own centre.
///
/// A step of dt is made of as many as the Courant number asks for, and the first beside a body of
/// short ones, a tenth of dt and 1.2 times as long from one to the next, the last of them up to
/// twice.
///
/// columns   x, y, u, v, pressure, vorticity, spacing, kind (ParticleKind)
/// measures  past a body: particles; circulation; impulse_x, impulse_y; second_moment, sum gamma
///           |X|^2 from the first body's centre; bubble_length, separation_deg as of vortices, 0 of
///           several bodies; volume, of the particles and half the nodes', in that of the box
///           without bodies; pressure_iterations of the last step; least_neighbors of a particle
///           that is no node
///           in a periodic box: particles; volume, in that of the box; momentum_x, momentum_y, in
///           that of all fluid at the initial speed; energy, enstrophy, velocity_error,
///           pressure_error (motion/periodic_flow.hpp); the last two as above
/// drift     of the circulation [U D]; of the momentum, as above
/// table     wall.csv: number of the body if there are several, vorticity and pressure of each
///           node; or energy.csv
class SphSolver final : public flow::Solver {
 public:
  explicit SphSolver(SphSetup setup);

  std::string particle() const override { return "particle"; }
  std::vector<std::string> phases() const override {
    return {"move",     "adapt",    "neighbors", "operators",
            "boundary", "pressure", "viscosity", "slopes"};
  }
  void step(const tree::Phase& phase) override;
  long steps() const override { return steps_; }
  double time() const override { return static_cast<double>(steps_) * setup_.dt; }
  std::size_t particles() const override { return cloud_.size(); }
  flow::Columns columns() const override;
  flow::Measures measures() const override { return measures_; }
  std::optional<flow::Force> force() const override {
    return past_bodies() ? std::optional(force_) : std::nullopt;
  }
  std::vector<flow::Force> forces_on_each() const override;
  std::string route() const override { return "wall"; }
  double drift() const override { return drift_; }
  flow::Samples sample(tree::Points at) const override;
  std::vector<double> pressure(tree::Points at) const override;
  flow::FrameTable frame_table() const override;
  std::vector<double> frame_rows() const override;
  void save(flow::State& state) const override;
  void restore(long steps, const flow::Columns& columns, const flow::State& state) override;

  const Cloud& cloud() const { return cloud_; }  ///< as seen from the first body's centre

 private:
  /// On a body; the pressure's by two routes. Moments are about its centre.
  struct Traction {
    Vec2 pressure{}, friction{}, by_vorticity{};
    double pressure_moment = 0, friction_moment = 0;

    friend Traction operator+(const Traction& a, const Traction& b) {
      return {a.pressure + b.pressure, a.friction + b.friction, a.by_vorticity + b.by_vorticity,
              a.pressure_moment + b.pressure_moment, a.friction_moment + b.friction_moment};
    }
    friend Traction operator*(double s, const Traction& a) {
      return {s * a.pressure, s * a.friction, s * a.by_vorticity, s * a.pressure_moment,
              s * a.friction_moment};
    }
    Traction& operator+=(const Traction& a) { return *this = *this + a; }
  };
  using Tractions = std::vector<Traction>;  // of each body

  /// What a step changes before its end.
  struct Checkpoint {
    Cloud cloud;
    BiotSavart far_field;
    std::vector<double> along_outlet;
    double time, last_dt;
    long substeps;
    Iterations iterations;
  };

  Checkpoint checkpoint() const;
  void go_back(const Checkpoint& to);
  void start();
  void start_past_body();
  void start_periodic_flow();
  void substep(double dt, double later, const tree::Phase& phase);
  double next_dt(double left) const;
  void renew_particles();
  void look();
  void look_at_wall();
  void measure();
  void measure_past_body();
  void measure_periodic();
  bool past_bodies() const { return !setup_.bodies().empty(); }
  Tractions tractions() const;
  std::vector<flow::Force> frame_forces() const;
  void renew_forces(const Tractions& given, double took);
  void add_up_forces(Vec2 impulse);
  double bubble_length() const;
  struct AmongParticles;
  AmongParticles among_particles(tree::Points at) const;
  double head_beyond_vorticity(Vec2 at) const;
  double far_pressure() const;

  SphSetup setup_;
  Cloud cloud_;
  Stencils stencils_;
  std::vector<Slopes> slopes_;
  BiotSavart far_field_;
  VorticityForce by_vorticity_;
  std::vector<SmoothPressure> smooth_pressure_;  // of each body
  Momentum momentum_;
  std::vector<Vec2> wall_;  // its nodes
  std::vector<double> wall_vorticity_, wall_pressure_;
  double time_ = 0, last_dt_ = 0;
  long steps_ = 0, substeps_ = 0;
  Iterations iterations_;
  Tractions traction_;  // now
  std::vector<flow::Force> on_each_;
  flow::Force force_;  // on all
  flow::Measures measures_;
  double drift_ = 0;
};

}  // namespace vortree::sph
