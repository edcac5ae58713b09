#pragma once

#include "vortex/blobs/outflow.hpp"

namespace vortree::vortex {

/// Vortices that have left the box beside a body and are still felt, by its wall and by the blobs.
///
///   d x_i/dt = stream, as the body sees it
///
/// and nothing else: two that drove each other, one of each sign, would come back. What the blobs
/// and the sheet would carry them beyond the stream goes into the account, Outflow, of which they
/// are part:
///
///   d moment/dt = sum_i gamma_i u(x_i) = sum_i gamma_i stream - sum_j gamma_j u_drifting(x_j),
///
/// j the blobs and the sheet. It is what holds the vortices on their way, and no force on the body;
/// left out, it makes as much noise of the lift as vortices that vanish. If the wall alone felt
/// them, blobs would pass through it at u_drifting (cylinder_re100 to t = 60: Strouhal number 2 %,
/// drag 1.4 % and lift by a fourth off a box to x = 200, instead of 0.02, 0.01 and 0.3 %).
///
/// A vortex that leaves keeps place, circulation and core, so that nothing jumps. Beyond
/// `whole_until` times as far as the box less and less of it is felt, linearly, and from
/// `felt_until` times on nothing: of one that ceased at once the body would miss gamma/(2 pi L) in
/// one step.
///
/// x, y    [m], from the body's centre; gamma [m^2/s], never 0
/// sigma   core [m], with which they act upon blobs: it holds all that was merged
/// spread  mean square of the distance of what was merged from its centroid [m^2]
struct Drifting {
  std::vector<double> x, y, gamma, sigma, spread;

  std::size_t size() const { return x.size(); }
  Vec2 at(std::size_t i) const { return {x[i], y[i]}; }
  void append(Vec2 place, double circulation, double core, double wide);
  void drop_last();
  friend bool operator==(const Drifting&, const Drifting&) = default;
};

/// Blobs as vortices that drift; those of no circulation are left out.
void take(Drifting& drifting, const Blobs& left);

/// Turns as the axes turn the other way, and goes on by `way`, while cores grow by `spread` of
/// sigma^2; what is no longer felt is left out.
void drift(Drifting& drifting, Vec2 way, double spread, const Box& box, const Turn& turn = {});

/// Takes away those that have come back into the box, as blobs.
Blobs come_back(Drifting& drifting, const Box& box);

/// How much of a vortex is felt, 1 to 0; the box holds the origin.
double felt_share(Vec2 at, const Box& box);

/// The vortices as blobs, with so much of their circulation as is felt.
Blobs felt(const Drifting& drifting, const Box& box);

/// Merges vortices of one sign while the body, within `radius` of the origin, feels of it no more
/// than `unfelt` [m/s], to second order in their distances:
///
///   |gamma| spread/(2 pi L^3) <= unfelt,   L = |x| - radius (radius/10 at least)
///
/// about the vortex that a merger leaves, for all that was ever merged into it. Circulation and
/// first moment stay, and the second moment, sigma^2 with it, does. If more than `most_drifting`
/// are left, with `unfelt` doubled until they are not.
/// cost  O(n^2), n a hundred or so
void merge_drifting(Drifting& drifting, double radius, double unfelt);

}  // namespace vortree::vortex
