"""Pressure at the front of a circle that sets off, at once or slowly: how *_front_pressure_*.csv
beside this file were made.

    python3 front_pressure.py RE END OUTDIR [--rise T] [--fine F]

The flow is that of impulsive_cylinder.py, in its units; with --rise its speed is
(1 - cos(pi T/rise))/2. On the way from far upstream to the wall
along the axis, in the frame of the body, momentum says

    p - p_far = U^2/2 + d/dt int (U - u) dr + nu int 1/r d(omega)/d(theta) dr.

The first integral is what the circle, its layers and its wake keep from flowing along the axis, the
second what friction adds; of the first the part beyond the grid is known, for psi_n ~ r^-n. The
same along the axis behind, and the pressure along the wall between both ends, of which
nu d(omega)/dr is the slope in the frame of the body, tell how good it is. Times are left out at
which harmonics are added, for these change the first integral at once. Needs numpy and scipy.
"""

import argparse
import os
import sys

import numpy as np
from impulsive_cylinder import START, Flow
from scipy.interpolate import CubicSpline


def along_axis(flow, values):
    return CubicSpline(flow.r, values).integrate(flow.r[0], flow.r[-1])


def kept(flow, side):
    """int (u - u_far) dr, u along r: at the front, side = -1, and behind, 1."""
    signs = float(side)**flow.n
    return along_axis(flow, flow.psi @ (flow.n * signs) / flow.r) + flow.psi[-1] @ signs


def friction(flow, side):
    return flow.nu * along_axis(flow, flow.past[0][1] @ (flow.n * float(side)**flow.n) / flow.r)


def between_ends(flow):
    """Pressure at the front less that behind, by the wall, in the frame of the body."""
    slope = flow.wall_d1 @ flow.past[0][1][:7]
    return flow.nu * (slope / flow.n) @ (1 - (-1.0)**flow.n)


def coefficients(flow, t):
    """Those of stream, flow along the axis and friction, and how far both ways are apart; or None
    where harmonics were added on the way."""
    step = min(0.01, t / 50)
    flow.advance(t - step)
    harmonics = len(flow.n)
    before = [kept(flow, side) for side in (-1, 1)]
    flow.advance(t)
    rubs, jump = [friction(flow, side) for side in (-1, 1)], between_ends(flow)
    flow.advance(t + step)
    if len(flow.n) != harmonics:
        return None
    jump -= (flow.speed(t + step) - flow.speed(t - step)) / step  # what drives the frame
    rates = [(kept(flow, side) - b) / (2 * step) for side, b in zip((-1, 1), before)]
    off = rates[0] + rubs[0] - rates[1] - rubs[1] - jump
    return flow.speed(t)**2, 2 * rates[0], 2 * rubs[0], 2 * off


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("reynolds", type=float)
    parser.add_argument("end", type=float)
    parser.add_argument("out")
    parser.add_argument("--rise", type=float)
    parser.add_argument("--fine", type=float, default=1.0)
    a = parser.parse_args()

    def speed(t):
        return (1 - np.cos(np.pi * t / a.rise)) / 2 if a.rise else 1.0

    flow = Flow(a.reynolds, a.end, a.fine, speed)
    name = "slow_start" if a.rise else "cylinder"
    law = f"(1 - cos(pi T/{a.rise:g}))/2" if a.rise else "1 from T = 0"
    for t in START * 1.08**np.arange(1, 70):
        flow.advance(t)
    with open(os.path.join(a.out, f"{name}_front_pressure_re{a.reynolds:g}.csv"), "w") as file:
        file.write(f"""\
# Pressure at the front of a circle beyond that far away, symmetric flow, Re = {a.reynolds:g};
# speed {law}.
# Solution made for this project (front_pressure.py). T = U t/R, cp = (p - p_far)/(rho U^2/2) and
# its parts: of the stream, of the flow along the axis as it changes, of friction.
T,cp_front,of_stream,of_change,of_friction
""")
        for t in np.arange(1, round(20 * a.end) + 1) / 20:
            found = coefficients(flow, t)
            if not found:
                continue
            *parts, off = found
            file.write(f"{t:.2f},{sum(parts):.5f}," + ",".join(f"{part:.5f}" for part in parts)
                       + "\n")
            file.flush()
            print(f"T {t:.2f} cp {sum(parts):.5f} off {off:.1e}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
