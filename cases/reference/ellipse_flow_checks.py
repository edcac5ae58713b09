"""Holds ellipse_flow.py against what else is known; prints relative differences in windows of T.

    python3 ellipse_flow_checks.py circle RE END    a sudden stream: cylinder_drag_re{RE}.csv
    python3 ellipse_flow_checks.py stokes           Re = 1 without convection: the exact drag
    python3 ellipse_flow_checks.py start            the ellipse of ellipse_re400.py at T -> 0: the
                                                    layer of first order
"""

import csv
import os
import sys
from dataclasses import replace

import ellipse_flow
import numpy as np
from ellipse_flow import Case, Flow, largest, solve
from ellipse_re400 import ELLIPSE
from scipy.special import kve

BOUNDS = [0.02, 0.05, 0.2, 0.5, 1, 2, 4, 7]


def tell(T, off):
    for a, b in zip(BOUNDS, BOUNDS[1:]):
        if b <= T[-1]:
            print(f"T {a:g} to {b:g}: {largest(T, off, [a, b])}")


def circle(reynolds, end):
    path = os.path.join(os.path.dirname(__file__), f"cylinder_drag_re{reynolds:g}.csv")
    with open(path) as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    known = {round(float(row["T"]), 3): float(row["C_D"]) for row in rows}
    reach = 1 + 0.5 * end + 2.5 * np.sqrt(2 * end / reynolds)
    ours = solve(Case("", reynolds, end, reach, points=(128, 192)), 1.0)[1]
    off = {T: (pressure + friction).real / known[round(T.real, 3)] - 1
           for T, pressure, friction, _ in ours if round(T.real, 3) in known}
    tell(np.array(list(off)).real, np.array(list(off.values())))


def stokes_drag(reynolds, T, terms=40):
    """C_D of unsteady Stokes flow past a circle after a sudden start: of the Laplace transform
    8 pi/Re z K1(z)/(s K0(z)), z^2 = s R^2/nu (Stokes 1851; Basset 1888), by the contour of Abate &
    Valko, Int. J. Numer. Meth. Engng 60 (2004)."""
    t, k = T / 2, np.arange(1, terms)
    angle, scale = k * np.pi / terms, 2 * terms / (5 * t)

    def transform(s):
        z = np.sqrt(s * reynolds) / 2
        return z * kve(1, z) / (s * kve(0, z))

    cot = 1 / np.tan(angle)
    s, bend = scale * angle * (cot + 1j), angle + (angle * cot - 1) * cot
    total = 0.5 * np.exp(scale * t) * transform(scale)
    total += (np.exp(s * t) * transform(s) * (1 + 1j * bend)).sum().real
    return 8 * np.pi / reynolds * scale / terms * total


def stokes():
    """By a stream of 1e-6, so that convection is nothing."""
    ellipse_flow.START = 1e-5  # the layer is thick at this Reynolds number
    weak = 1e-6
    rows = solve(Case("", 1, 2, 15, points=(80, 16), stream=weak), 1.0)[1]
    T = rows[:, 0].real
    exact = np.array([stokes_drag(1, t) for t in T])
    tell(T, (rows[:, 1] + rows[:, 2]).real / weak / exact - 1)


def start():
    """Force sqrt(T) as a cubic in sqrt(T), at T = 0, against the layer that is Rayleigh's locally:
    C sqrt(T) = 2 sqrt(2 nu/pi) oint q q_i ds along i, q the slip of the stream, q_i that of a unit
    stream along i."""
    ellipse_flow.START, ellipse_flow.STRETCH = 2e-6, 6.0
    flow = Flow(replace(ELLIPSE, reach=2, points=(144, 128)))
    roots, values = [], []
    for t in np.geomspace(4e-6, 3.2e-3, 30):
        flow.advance(t)
        roots.append(np.sqrt(2 * t))
        values.append(sum(flow.forces()[:2]) * roots[-1])
    last = slice(-10, None)
    limit = np.linalg.lstsq(np.vander(roots[last], 4), np.array(values[last]), rcond=None)[0][-1]
    along, across = (2 * np.imag(np.conj(e / flow.turn) * flow.zeta[0]) for e in (1, 1j))
    for name, ours, slip in ("drag", limit.real, along), ("lift", limit.imag, across):
        layer = 2 * np.sqrt(2 * flow.nu / np.pi) * 2 * np.pi * np.mean(
            along * slip / np.abs(flow.z_theta))
        print(f"{name}: {ours:.5f}, by the layer {layer:.5f}")


if __name__ == "__main__":
    check = {"circle": circle, "stokes": stokes, "start": start}[sys.argv[1]]
    check(*map(float, sys.argv[2:]))
