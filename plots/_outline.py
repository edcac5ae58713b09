"""The outline of a body, or of several, as a patch in units of half the length of the first, from
its centre."""

import numpy as np
from _style import INK
from matplotlib.patches import PathPatch, Polygon
from matplotlib.path import Path

LOOK = {"facecolor": "#4d4d4d", "edgecolor": INK, "lw": 0.8, "zorder": 3}


def walls(run, time=None):
    """The corners of each outline, as it is turned at that time."""
    radius, _ = run.body
    c, s = np.cos(angle := run.angle(time)), np.sin(angle)
    scaled = ((one["x"] / radius, one["y"] / radius) for one in run.outlines)
    return [np.c_[c * x - s * y, s * x + c * y] for x, y in scaled]


def outline(run, time=None):
    """All of them, as one patch."""
    corners = walls(run, time)
    if len(corners) == 1:
        return Polygon(corners[0], **LOOK)
    return PathPatch(Path.make_compound_path(*(Path(one, closed=True) for one in corners)), **LOOK)


def discs(run):
    """Centre and half the length of each body, in the same units; of others than the first what is
    farthest from the centre."""
    radius, centre = run.body
    places = [(np.array(one.get("centre", [0, 0])) - centre) / radius for one in run.bodies]
    farthest = [np.hypot(*(wall - place).T).max() for wall, place in zip(walls(run), places)]
    return list(zip(places, [1.0, *farthest[1:]]))


def circles(run):
    """Centre and radius of each body that is a circle, in the same units."""
    return [disc for k, disc in zip(run.numbers, discs(run)) if is_circle(run, k)]


def is_circle(run, number=1):
    """Whether the body of that number is one."""
    centre, _ = discs(run)[number - 1]
    r = np.hypot(*(walls(run)[number - 1] - centre).T)
    return np.ptp(r) < 1e-9 * (r.max() + np.abs(centre).max())


def is_slender(run):
    """A body that fills less than a fifth of the square on its length, as a foil does."""
    x, y = run.outline["x"], run.outline["y"]
    return abs(np.sum(x[:-1] * np.diff(y) - y[:-1] * np.diff(x))) / 2 < 0.8 * run.body[0] ** 2
