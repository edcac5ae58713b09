#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "body/motion.hpp"
#include "fmm/options.hpp"
#include "tree/base/phase.hpp"
#include "vortex/adapt/merge_close.hpp"
#include "vortex/adapt/split_wide.hpp"
#include "vortex/blobs/drifting.hpp"
#include "vortex/blobs/invariants.hpp"
#include "vortex/blobs/outflow.hpp"
#include "vortex/moving_wall.hpp"
#include "vortex/transport/convect.hpp"
#include "vortex/transport/diffusion.hpp"
#include "vortex/wall/forces.hpp"

namespace vortree::vortex {

/// stream  undisturbed velocity [m/s]; nu viscosity [m^2/s], 0: no diffusion, splitting or merging
/// motion  of the body, or of all bodies, in whose frame and axes, which turn with it, all is
///         computed: positions, velocities
/// own     of each of several bodies in that frame, or none
struct Flow {
  Vec2 stream;
  double nu;
  body::Motion motion{};
  std::vector<body::Motion> own{};

  /// The stream as the body sees it, and how far that goes in a time dt, in the axes at its end.
  Vec2 stream_at(double t) const {
    const body::Kinematics now = motion.at(t);
    return Turn(-now.angle)(stream - now.velocity);
  }
  Vec2 way(double t, double dt) const {
    const body::Kinematics later = motion.at(t + dt);
    return Turn(-later.angle)(dt * stream + motion.at(t).place - later.place);
  }
  /// How a body moves in the frame of all, and how fast it turns in all.
  body::Kinematics own_at(std::size_t body, double t) const {
    return own.empty() ? body::Kinematics{} : own[body].at(t);
  }
  double rate(std::size_t body, double t) const { return motion.at(t).rate + own_at(body, t).rate; }
  /// By how much the axes turn in a time dt.
  double turned(double t, double dt) const {
    return motion.turns() ? motion.at(t + dt).angle - motion.at(t).angle : 0;
  }
};

/// What a step needs to know, besides the blobs.
///
/// time      when the step begins; for velocity_at, now [s]
/// box       blobs that leave it are taken away; so are those of no more circulation than
///           `faintest` [m^2/s], 0: none; `outflow` all that have left in the steps before
/// drifting  beside a wall those that have left the box and are still felt, by wall and blobs; the
///           body may feel as much as `unfelt` of a merger of them [m/s]
/// moving    makes `wall` and `turning` stand as they do at a time; nullptr: they do as they are
/// wall      nullptr: free space
/// turning   of each body, or none where none turns
/// most_blobs  a step that leaves more of them, or a substep, throws Multiplied
/// advecting_cores  of a blob's core, that with which it advects others: 1, or sqrt(2), which in
///           the mean of a pair gives sigma_i^2 + sigma_j^2. Then each blob moves with the velocity
///           averaged over its own core, and the energy of free space is conserved too
/// strained_for  in free space, for how long cores are strained until they are laid onto lattices
///           anew, if diffusion has not made them wide enough before [s]; 0: cores stay round
/// sums      how velocities are summed
/// sigma_0   core of blobs released at the wall, or of those that exchange circulation [m]
/// area      of each blob that exchanges circulation [m^2]
struct Problem {
  Flow flow;
  double dt;
  double time = 0;
  flow::Scheme scheme = flow::Scheme::rk2;
  std::size_t most_blobs = 20'000'000;
  double advecting_cores = 1;
  double strained_for = 0;
  double sigma_0;
  Diffusion diffusion = Diffusion::core_spreading;
  double area = 0;
  Splitting splitting;
  Merging merging;
  std::optional<Box> box{};
  double faintest = 0;
  Outflow outflow{};
  Drifting drifting{};
  double unfelt = 1e-5;
  const MovingWall* moving = nullptr;
  std::shared_ptr<const Standing> standing{};
  const Wall* wall = nullptr;
  std::span<const Turning> turning{};
  fmm::Options sums;
};

/// Wall and turning of a problem become those of a time.
void stand(Problem& problem, double time);

/// How many blobs a step, in all its parts,
///
/// released     at the wall
/// laid         onto lattices
/// split        into children
/// beside_wall  looked at, of those that splitting left, because the wall folds their cores
/// merged       into others
struct StepCounts {
  std::size_t released = 0, laid = 0, split = 0, beside_wall = 0, merged = 0;
};

/// What one step leaves beside the blobs; but for `outflow` and `counts`, empty without a wall.
/// Vectors are told in axes that do not turn.
///
/// sheet           released at the end of the step [m/s], a value a panel
/// moment          sum gamma X of blobs, released sheet, what has left, and bodies that turn;
///                 forces are its rate of change
/// wall_vorticity  a value a panel [1/s]
/// pressure        on each body during the step, in its own frame (motion.hpp)
/// friction        the same, at the end of the step
/// pressure_slope  dp/ds along each panel in the body's own frame, its mean over the step [m/s^2]
/// bubble_length   of the closed wake of a single body, with the sheet not yet released [m]
///                 (near_wake.hpp)
/// outflow         all that has left the box, and `drifting` those of it that are still felt, to be
///                 handed to the next step
struct Wake {
  std::vector<double> sheet;
  Vec2 moment;
  std::vector<double> wall_vorticity, pressure_slope;
  std::vector<Load> pressure, friction;
  double bubble_length = 0;
  Outflow outflow{};
  Drifting drifting{};
  StepCounts counts{};
};

/// Blobs multiply faster than they merge: more than Problem::most_blobs.
struct Multiplied : std::runtime_error {
  std::size_t blobs;

  explicit Multiplied(std::size_t count)
      : std::runtime_error(std::to_string(count) + " blobs"), blobs(count) {}
};

/// The impulsive start: the sheet that cancels the slip of stream and blobs at t = 0, released.
Wake start(Blobs& blobs, const Problem& problem);

/// One step of length dt: half the diffusion, convection (in free space of strained cores, if they
/// may be), the other half, release of wall vorticity, splitting, merging. Beside a wall the first
/// steps, from number 1, are done in 8, 4, 3, 2, 2, 2 and 2 substeps: the last of step n is n/8 of
/// it, the others are alike and no longer; cores and mergers are as much finer. An impulsive start
/// changes the flow as fast as it is young.
/// throws  std::invalid_argument for other diffusion than core spreading beside a wall; Multiplied
Wake step(Blobs& blobs, const Problem& problem, std::uint64_t number, const tree::Phase& phase);

/// Blobs and those that have left and are felt, how the wall folds them, and how they move; in free
/// space strained blobs are two halves (cores/halves.hpp).
///
/// u      of each core as a whole, by stream, blobs and sheet
/// slope  its gradient, if it is wanted, averaged over the core; without the sheet's
struct MovingBlobs {
  Blobs blobs;
  FoldedBlobs at;
  Velocities u;
  Gradients slope{};
};
enum class WithSlope : bool { no, yes };
MovingBlobs moving(const Blobs& blobs, const Problem& problem, WithSlope wanted = WithSlope::no);

/// Velocity at points of the fluid: stream, blobs and the sheet that holds the body's interior at
/// rest.
Velocities velocity_at(tree::Points points, const Blobs& blobs, const Problem& problem);

/// What moves fluid there, besides the stream: blobs as they act, those that drift among them, and
/// the sheet, empty without a wall, with that of a body that turns.
struct Acting {
  std::vector<double> x, y, gamma, sigma, sheet;
};

Acting acting(const Blobs& blobs, const Problem& problem);

}  // namespace vortree::vortex
