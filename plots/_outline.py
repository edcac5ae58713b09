"""The outline of a body, as a patch in units of half its length, from its centre."""

import numpy as np
from _style import INK
from matplotlib.patches import Polygon

LOOK = {"facecolor": "#4d4d4d", "edgecolor": INK, "lw": 0.8, "zorder": 3}


def outline(run, time=None):
    """As it is turned at that time."""
    radius, _ = run.body
    c, s = np.cos(angle := run.angle(time)), np.sin(angle)
    x, y = run.outline["x"] / radius, run.outline["y"] / radius
    return Polygon(np.c_[c * x - s * y, s * x + c * y], **LOOK)


def is_circle(run):
    r = np.hypot(run.outline["x"], run.outline["y"])
    return np.ptp(r) < 1e-9 * r.max()


def is_slender(run):
    """A body that fills less than a fifth of the square on its length, as a foil does."""
    x, y = run.outline["x"], run.outline["y"]
    return abs(np.sum(x[:-1] * np.diff(y) - y[:-1] * np.diff(x))) / 2 < 0.8 * run.body[0] ** 2
