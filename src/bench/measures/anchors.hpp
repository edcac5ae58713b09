#pragma once

namespace vortree::bench {

/// What the machine can do at most, measured in some ten milliseconds each: what the speed of a
/// method is held against.
///
/// fma               fused multiply-adds of doubles, a register full at a time [1/s]; of floats
///                   twice as many
/// divisions         of doubles, likewise [1/s]
/// single_divisions  of floats [1/s]
/// triad             bytes read and written by a = b + s c, from memory [1/s]
/// write             bytes written by a = s, to memory [1/s]
struct Anchors {
  double fma = 0.0, divisions = 0.0, single_divisions = 0.0, triad = 0.0, write = 0.0;
};

/// threads   working side by side; the rates are those of all together
Anchors measure_anchors(int threads);

}  // namespace vortree::bench
