"""The quadtree upon points: the program's own rule, from its leaves up."""

import math

import numpy as np

FINEST = 31  # level


def childless(x, y, most):
    """Lower left corner and side of the whole square (tree/order/points.hpp), and of the cells that
    need not split: level, column, row (tree/build/build_reverse.hpp, for no more than `most`)."""
    corner, side = (x.min(), y.min()), enclosing_side(x, y)
    i, j = ((np.minimum((value - low) / side * 2.0**FINEST, 2.0**FINEST - 1)).astype(np.uint64)
            for value, low in zip((x, y), corner))
    codes = np.sort(spread(i) | spread(j) << np.uint64(1))
    levels, firsts, at = [], [], 0
    while at < codes.size:
        level = min(FINEST, 1 + max(shared(codes, at - 1, at), shared(codes, at, at + most)))
        levels.append(level)
        firsts.append(codes[at])
        beyond = (int(codes[at]) >> 2 * (FINEST - level)) + 1 << 2 * (FINEST - level)
        at = np.searchsorted(codes, np.uint64(beyond)) if beyond < 1 << 62 else codes.size
    levels, firsts = np.array(levels, np.uint8), np.array(firsts, np.uint64)
    drop = (FINEST - levels).astype(np.uint64)
    return corner, side, levels, *((gathered(firsts >> np.uint64(k)) >> drop).astype(np.uint32)
                                   for k in (0, 1))


def enclosing_side(x, y):
    farthest = max(np.abs(x).max(), np.abs(y).max())
    width = max(np.ptp(x), np.ptp(y), math.ldexp(farthest, -21), 2.0**-900)
    significand, exponent = math.frexp(width)
    return math.ldexp(math.floor(math.ldexp(significand, 20)) + 2, exponent - 20)


def shared(codes, a, b):
    """The deepest level at which two points lie in one cell; -1 without one of them."""
    if a < 0 or b >= codes.size:
        return -1
    return FINEST - (int(codes[a] ^ codes[b]).bit_length() + 1) // 2


SHIFTS = ((16, 0x0000FFFF0000FFFF), (8, 0x00FF00FF00FF00FF), (4, 0x0F0F0F0F0F0F0F0F),
          (2, 0x3333333333333333), (1, 0x5555555555555555))


def spread(bits):
    """A zero between each two bits."""
    for shift, mask in SHIFTS:
        bits = (bits | bits << np.uint64(shift)) & np.uint64(mask)
    return bits


def gathered(bits):
    """Every other bit."""
    bits = bits & np.uint64(0x5555555555555555)
    for (shift, _), mask in zip(SHIFTS[::-1], [m for _, m in SHIFTS[-2::-1]] + [0xFFFFFFFF]):
        bits = (bits | bits >> np.uint64(shift)) & np.uint64(mask)
    return bits
