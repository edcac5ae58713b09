#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>

#include "flow/initial/initial_flow.hpp"
#include "flow/initial/settings.hpp"
#include "flow/scales.hpp"
#include "sph/adapt/wanted_spacing.hpp"
#include "sph/adapt/wishes.hpp"
#include "sph/boundary/open_boundary.hpp"
#include "sph/boundary/outer_box.hpp"
#include "sph/boundary/standing_bodies.hpp"
#include "sph/cloud/cloud.hpp"
#include "sph/motion/ambient.hpp"
#include "sph/operators/stencils.hpp"
#include "sph/settings.hpp"

namespace vortree::sph {

/// A scene made ready, as seen from the first body's centre, or the lower left corner of a periodic
/// box.
struct SphSetup {
  flow::Scales scales;
  Ambient ambient;
  Vec2 centre{};
  std::optional<flow::InitialSettings> initial{};  ///< vortices beside a body
  std::optional<flow::PeriodicFlow> periodic{};    ///< what a flow in a periodic box begins with
  OuterBox box{};
  WantedSpacing wanted;
  std::optional<VorticityWish> by_vorticity{};
  Confines confines;
  OperatorOptions operators;
  double motion_period = INFINITY;  ///< of the bodies (flow/case.hpp)
  bool far_field = true;
  double shift = 6, courant = 0.3, tolerance = 1e-5, dt = 0;
  std::uint64_t seed = 1;

  /// None in a periodic box.
  [[nodiscard]] const StandingBodies& bodies() const { return confines.bodies; }
};

/// The bodies of a scene as they stand, seen from the centre of the first.
[[nodiscard]] StandingBodies bodies_of(const SphCase& scene);

/// What a scene asks of the spacing, beside bodies of some shape and in its regions.
///
/// from     where the shape is seen from, in the scene
/// period   of a periodic box, in which regions are there again in every period
[[nodiscard]] WantedSpacing wanted_of(const SphSettings& own,
                                      std::shared_ptr<const body::Shape> shape, Vec2 from,
                                      double period = 0);

[[nodiscard]] SphSetup setup_of(const SphCase& scene);

/// Particles as a flow begins, at rest: if there are bodies, nodes on walls and on the box, and
/// rings; between them a lattice that is split level by level, moved off its places at random by up
/// to a tenth of the spacing, and spread evenly. A lattice without a flaw would stay one where the
/// flow strains it, its rows ever nearer to each other: repulsion cancels there.
[[nodiscard]] Cloud starting_cloud(const SphSetup& setup);

/// Spreads particles evenly before a flow begins, and puts them in order.
void settle(Cloud& cloud, const OperatorOptions& options);

}  // namespace vortree::sph
