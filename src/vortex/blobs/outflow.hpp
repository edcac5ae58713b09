#pragma once

#include "vortex/blobs/blobs.hpp"

namespace vortree::vortex {

/// A part of the plane, sides parallel to axes from which those of positions are turned by `axes`.
struct Box {
  Vec2 low, high;
  Turn axes{};

  bool holds(Vec2 at) const {
    at = axes(at);
    return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y;
  }
};

/// The account of what has left: sum gamma, sum |gamma| and sum gamma x, which goes on with the
/// stream (as the body sees it),
///
///   d moment/dt = gamma stream.
///
/// It still counts for Kelvin's theorem and for the impulse. Beside a body those that are not yet
/// far are felt, too, and what carries them beyond the stream is added (drifting.hpp). The others
/// are felt nowhere: of a wake that sheds gamma_s of either sign, h apart, every l of way the body
/// misses a velocity of about gamma_s h/(2 pi l L), L their distance. (As two vortices far behind,
/// one of each sign, they would drive themselves back to the body.)
struct Outflow {
  double gamma = 0;
  Vec2 moment;
  double of_both_signs = 0;

  void drift(Vec2 way) { moment = moment + gamma * way; }
  void take_back(const Outflow& back) {
    gamma -= back.gamma;
    moment = moment - back.moment;
    of_both_signs -= back.of_both_signs;
  }
  friend Outflow operator+(const Outflow& a, const Outflow& b) {
    return {a.gamma + b.gamma, a.moment + b.moment, a.of_both_signs + b.of_both_signs};
  }
};

/// What these blobs are in the account.
Outflow account_of(const Blobs& blobs);

/// Takes all blobs outside the box away, and hands them out.
Blobs take_outside(Blobs& blobs, const Box& box);

/// Takes blobs of no more circulation than `faintest` away, of either sign [m^2/s], and says what
/// they were.
///
/// Where every step splits blobs, their children reach out faster than vorticity does: blobs of
/// 1e-12 to 1e-120 U D soon outnumber all others, of which sums to a tolerance of 1e-6 feel
/// nothing.
Outflow remove_faint(Blobs& blobs, double faintest);

}  // namespace vortree::vortex
