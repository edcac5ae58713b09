#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec2.hpp"
#include "vortex/blobs/covariance.hpp"

namespace vortree::vortex {

/// Wide blobs laid onto the nodes of a lattice, whose cores are narrow again: vorticity that was
/// carried into disorder is in order again, and a field that is smooth stays as smooth as a lattice
/// has it, to 2 exp(-(pi s/h)^2) a direction.
///
/// Lattices of levels k = 0, 1, ... have their nodes at h g, g a pair of whole numbers:
///
///   h = 0.9 sigma_max 2^(k/2),   s = 0.77 sigma_max 2^(k/2)      steps and cores of the nodes
///
/// They stand where positions are counted from, which is the centre of the body, and have the
/// symmetries of a square about it.
struct LatticeLevel {
  double h, square;  // of steps [m], of cores squared [m^2]

  LatticeLevel(double sigma_max, int level);

  /// The least sigma^2 that is laid onto it: V >= 1/4, see below. 0.998 sigma_max^2 2^k.
  double least() const { return square + h * h / 2; }
};

/// The level on which cores are as wide as this allows: floor(2 log2 widening), widening >= 1.
int level_of(double widening);

/// The nine nodes g + (a, b), a, b = -1, 0, 1, that a blob is laid onto, and the share that each
/// has of its circulation. With X the blob's centre, sigma and D its core,
///
///   g nearest to X/h,   d = X/h - g,   V = ((sigma^2 - s^2)/2 I + D)/h^2,   m = V_xx + d_x^2 (V_yy
///   + d_y^2),
///   w_(-1, 0, 1) = (m - d)/2, 1 - m, (m + d)/2,   share_ab = w_a(x) w_b(y) + a b V_xy/4
///
/// are what has the sums 1, d, V + d d^T of a^0, (a, b) and (a, b)(a, b)^T: with the nodes' own
/// cores they keep circulation, impulse and all second moments, strain included. They are all the
/// nine can keep: third moments err by h^3 d (1 - d^2 - 3 V), nothing at d = 0, or 1/2 with V =
/// 1/4. Of a round core no share is negative for 1/4 <= V <= 3/4; with V = 1/4 they are those of
/// the quadratic B-spline, which change evenly as a blob moves on.
struct NineNodes {
  std::int64_t gx, gy;
  std::array<double, 9> share;  // of (a, b) at 4 + a + 3 b

  NineNodes(Vec2 at, const Core& core, const LatticeLevel& level);
};

/// Onto which nodes blobs are laid: those above, or, in free space where cores are strained, more
/// of them (spline_nodes.hpp).
enum class Shares { nine, spline };

/// A blob to be laid onto a lattice.
struct WideBlob {
  Vec2 at;
  double gamma;
  Core core;
  int level;
};

/// A node that something has been laid onto.
struct LatticeNode {
  Vec2 at;
  double gamma;
  int level;
};

/// Places that can be laid: whole numbers of steps tell them apart.
bool on_lattices(Vec2 at, double sigma_max);

/// Lays blobs onto the lattices, and returns the nodes that are not 0, by level, tiles of 16 x 16
/// nodes and rows.
///
/// Shares are added as whole numbers, of 2^-58 of all circulation of both signs or less. Such sums
/// have no order: any number of threads, and any order of the blobs, give the same bits; the mirror
/// image of blobs (in either axis) gives the mirror image to the bit, and what cancels is nothing.
///
/// blobs  at places on_lattices, all finite
/// error  circulation, impulse and second moments: round-off of the sums of their terms
/// cost   O(blobs)
/// source our own
std::vector<LatticeNode> lay_onto_lattice(std::span<const WideBlob> blobs, double sigma_max,
                                          Shares shares = Shares::nine);

}  // namespace vortree::vortex
