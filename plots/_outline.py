"""The outline of a body, or of several, as a patch in units of half the length of the first, from
its centre."""

import numpy as np
from _style import INK
from matplotlib.patches import PathPatch, Polygon
from matplotlib.path import Path

LOOK = {"facecolor": "#4d4d4d", "edgecolor": INK, "lw": 0.8, "zorder": 3}


def walls(run, time=None):
    """The corners of each outline, where it is and as it is turned at that time."""
    radius, _ = run.body
    scaled = [(one["x"] / radius, one["y"] / radius) for one in run.outlines]
    if not run.several:
        return [turned(*scaled[0], run.angle(time))]
    found = []
    for k, (x, y), centre in zip(run.numbers, scaled, centres(run)):
        way, angle = run.place(k, time)
        found.append(centre + way / radius + turned(x - centre[0], y - centre[1], angle))
    return found


def turned(x, y, angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.c_[c * x - s * y, s * x + c * y]


def centres(run):
    """Of each body as the flow begins."""
    radius, first = run.body
    return [(np.array(one.get("centre", [0, 0])) - first) / radius for one in run.bodies]


def outline(run, time=None):
    """All of them, as one patch."""
    corners = walls(run, time)
    if len(corners) == 1:
        return Polygon(corners[0], **LOOK)
    return PathPatch(Path.make_compound_path(*(Path(one, closed=True) for one in corners)), **LOOK)


def discs(run, time=None):
    """Centre and half the length of each body, in the same units; of others than the first what is
    farthest from the centre."""
    farthest = [np.hypot(*(wall - place).T).max() for wall, place in zip(walls(run), centres(run))]
    gone = [run.place(k, time)[0] / run.body[0] for k in run.numbers]
    return list(zip(np.add(centres(run), gone), [1.0, *farthest[1:]]))


def circles(run, time=None):
    """Centre and radius of each body that is a circle, in the same units."""
    return [disc for k, disc in zip(run.numbers, discs(run, time)) if is_circle(run, k)]


def within(field, walls):
    """Which places of a field lie in a body, told by its corners."""
    found = np.zeros((field["y"].size, field["x"].size), bool)
    for wall in walls:
        (left, low), (right, high) = wall.min(0), wall.max(0)
        rows = (field["y"] >= low) & (field["y"] <= high)
        columns = (field["x"] >= left) & (field["x"] <= right)
        X, Y = np.meshgrid(field["x"][columns], field["y"][rows])
        inside = Path(wall).contains_points(np.c_[X.ravel(), Y.ravel()])
        found[np.ix_(rows, columns)] |= inside.reshape(X.shape)
    return found


def is_circle(run, number=1):
    """Whether the body of that number is one."""
    centre, _ = discs(run)[number - 1]
    r = np.hypot(*(walls(run)[number - 1] - centre).T)
    return np.ptp(r) < 1e-9 * (r.max() + np.abs(centre).max())


def is_slender(run):
    """A body that fills less than a fifth of the square on its length, as a foil does."""
    x, y = run.outline["x"], run.outline["y"]
    return abs(np.sum(x[:-1] * np.diff(y) - y[:-1] * np.diff(x))) / 2 < 0.8 * run.body[0] ** 2
