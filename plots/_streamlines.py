"""Streamlines past a body, which show the closed wake behind it."""

import numpy as np
from _style import INK
from contourpy import contour_generator
from matplotlib.collections import LineCollection
from matplotlib.path import Path

OUTSIDE, INSIDE = 0.2, 0.08  # of the closed wake: a line every so many U R
EDGE = 0.06  # of a vortex's own psi: its outermost line
MOST, APART = 7, 0.055  # lines around a vortex, and how far apart they are, at least, on average
BAND, LAYER = 0.3, 0.08  # R: how far the wall is told, and where psi is as the square of that
FINE = 0.01  # R: no grid coarser than that
FAINT = 1e-3  # vortices of less are not told from noise, U R
PEN = {"colors": INK, "alpha": 0.85, "capstyle": "round", "joinstyle": "round"}


def streamlines(axes, field, walls):
    """Lines of equal stream function: those that come from far, the dividing ones, psi as on a
    wall, and around each closed vortex some of its own, so that weak ones are seen, too.

    field: grids in units of the body's radius, from its centre, and of the stream's speed, psi 0 on
    the first wall and constant in each body; walls: the outlines.
    """
    for k, wall in enumerate(walls):
        level = on_wall(field, wall) if k else 0
        x, y, psi, dividing = refined({**field, "psi": field["psi"] - level}, wall)
        lines = contour_generator(x, y, psi)
        if k == 0:
            draw(axes, from_far(lines, psi), 0.6)
        own = [peak for peak in peaks(psi) if nearest((x[peak[1]], y[peak[0]]), walls) == k]
        draw(axes, around_vortices(lines, x, y, psi, own), 0.6)
        draw(axes, contour_generator(x, y, dividing).lines(0), 1.0)


def from_far(lines, psi):
    ladder = np.arange(OUTSIDE / 2, np.abs(psi).max(), OUTSIDE)
    return [line for level in np.r_[-ladder, ladder] for line in lines.lines(level)
            if not closes(line)]


def on_wall(field, wall):
    """psi in the middle of the body, as on its wall."""
    column, row = (np.abs(field[name] - middle).argmin()
                   for name, middle in zip("xy", (wall.min(0) + wall.max(0)) / 2))
    return field["psi"][row, column]


def nearest(place, walls):
    return np.argmin([np.hypot(*(wall - place).T).min() for wall in walls])


def draw(axes, lines, width):
    axes.add_collection(LineCollection(lines, linewidths=width, **PEN), autolim=False)


def closes(line):
    return np.array_equal(line[0], line[-1])


def refined(field, wall):
    """x, y, psi on a grid fine enough for smooth lines, psi 0 within the body, and what changes
    sign with psi up to the wall: beside it psi goes as the square of the distance d, and
    psi/(1 - exp(-(d/c)^2)) is neither small nor steep."""
    x, y, psi = (field[name] for name in ("x", "y", "psi"))
    off = distance(*np.meshgrid(x, y), wall)
    near = off < 0.3 * (x[1] - x[0])
    smooth = gone_on(np.where(near, np.nan, psi / np.where(near, 1, of_wall(off))))
    off = np.minimum(off, BAND)
    while x[1] - x[0] > FINE:
        x, y = halved(x), halved(y)
        smooth, off = (halved(halved(one.T).T) for one in (smooth, off))
    return x, y, smooth * of_wall(off), smooth


def of_wall(off):
    return 1 - np.exp(-(np.maximum(off, 0) / LAYER) ** 2)


def halved(values):
    """With a value more between each two of the last axis, by cubics."""
    left, right = values[..., :-1], values[..., 1:]
    middle = (left + right) / 2
    middle[..., 1:-1] = (9 * (left + right)[..., 1:-1] - left[..., :-2] - right[..., 2:]) / 16
    both = np.empty(values.shape[:-1] + (2 * values.shape[-1] - 1,))
    both[..., ::2], both[..., 1::2] = values, middle
    return both


def gone_on(values):
    """What is not known, from the neighbors that are, for four cells; beyond that 0."""
    for _ in range(4):
        known = np.pad(values, 1, constant_values=np.nan)
        rows, columns = values.shape
        around = np.stack([known[i:i + rows, j:j + columns] for i in range(3) for j in range(3)])
        count = np.isfinite(around).sum(0)
        mean = np.nansum(around, 0) / np.maximum(count, 1)
        values = np.where(np.isfinite(values), values, np.where(count > 0, mean, np.nan))
    return np.nan_to_num(values)


def distance(X, Y, wall):
    """From the outline, negative within; BAND if farther."""
    at = np.c_[X.ravel(), Y.ravel()]
    far = np.full(len(at), BAND)
    near = np.flatnonzero(np.all((at > wall.min(0) - BAND) & (at < wall.max(0) + BAND), axis=1))
    for some in np.array_split(near, 1 + near.size // 5000):
        far[some] = np.minimum(BAND, to_segments(at[some], wall))
    far[near[Path(wall).contains_points(at[near])]] *= -1
    return far.reshape(X.shape)


def to_segments(at, wall):
    """From points to the two segments beside the nearest corner."""
    corners = wall[:-1]
    nearest = ((at[:, None] - corners) ** 2).sum(2).argmin(1)
    found = np.full(len(at), np.inf)
    for first in (nearest - 1, nearest):
        begin, way = corners[first], wall[first % len(corners) + 1] - corners[first]
        share = np.clip(((at - begin) * way).sum(1) / (way ** 2).sum(1), 0, 1)
        found = np.minimum(found, np.hypot(*(at - begin - share[:, None] * way).T))
    return found


def around_vortices(lines, x, y, psi, peaks):
    """Closed lines at some shares of the psi of each vortex; of one that lies in the outskirts of a
    stronger one, none."""
    found, taken, stronger = [], [], []
    for row, column in peaks:
        centre, peak = (x[column], y[row]), psi[row, column]
        whole = next((p for p in map(Path, loops(lines, EDGE * peak)) if p.contains_point(centre)),
                     None)
        if whole is None or any(edge.contains_point(centre) for edge in taken) \
                or any(whole.contains_point(other) for other in stronger):
            continue
        taken.append(whole)
        stronger.append(centre)
        found.append(whole.vertices)
        count = min(MOST, round(half_width(whole.vertices) / APART))
        inwards = np.arange(1, count) / count  # evenly in space, of a psi that is round at its peak
        for level in peak * (1 - (1 - EDGE) * (1 - inwards) ** 1.5):
            found += [line for line in loops(lines, level) if whole.contains_point(line[0])]
    return found


def loops(lines, level):
    return [line for line in lines.lines(level) if closes(line) and len(line) > 8]


def half_width(loop):
    """Twice the area by the perimeter: a circle's radius."""
    x, y = loop.T
    ahead = np.diff(loop, axis=0)
    return abs(np.sum(x[:-1] * ahead[:, 1] - y[:-1] * ahead[:, 0])) / np.hypot(*ahead.T).sum()


def peaks(psi):
    """Places where |psi| is larger than all around, the largest first."""
    size = np.abs(psi)
    inner = size[1:-1, 1:-1]
    around = [size[1 + i:size.shape[0] - 1 + i, 1 + j:size.shape[1] - 1 + j]
              for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j]
    rows, columns = np.nonzero((inner > np.max(around, axis=0)) & (inner > FAINT))
    order = np.argsort(-inner[rows, columns])
    return [(row + 1, column + 1) for row, column in zip(rows[order], columns[order])]


def integrated_streamlines(axes, field, along):
    """Lines of equal stream function past a circle, of fields that have none: psi = integral of
    u dy - v dx, zero on the body.

    field: grids in units of the body's radius, from its centre, and of the stream's speed, the
    velocity zero inside the body; along: direction of the stream.
    """
    x, y, u, v = (field[name] for name in ("x", "y", "u", "v"))
    bottom = np.cumsum(np.r_[0, -(v[0, 1:] + v[0, :-1]) / 2 * np.diff(x)])
    rise = np.cumsum((u[1:] + u[:-1]) / 2 * np.diff(y)[:, None], axis=0)
    psi = bottom + np.vstack([np.zeros_like(bottom), rise])
    X, Y = np.meshgrid(x, y)
    r, downstream = np.hypot(X, Y), along[0] * X + along[1] * Y
    psi -= psi[r < 0.5].mean()
    forward = psi * np.sign(along[0] * Y - along[1] * X)  # negative in the closed wake
    closed = (forward < 0) & (downstream > 0)

    pen = {"colors": INK, "linestyles": "solid", "alpha": 0.85}
    for step, hidden in ((OUTSIDE, closed | (r < 1)), (INSIDE, ~closed | (r < 1))):
        most = np.abs(psi[~hidden]).max(initial=0)
        levels = np.arange(step / 2, most, step)
        if levels.size:
            axes.contour(x, y, np.ma.array(psi, mask=hidden), np.r_[-levels[::-1], levels],
                         linewidths=0.6, **pen)

    # The dividing lines: psi = 0 up to the body and away from the wake, and the edge of the wake,
    # taken a hair inside since the sign of psi on the wall and on the axis is noise.
    hair = np.clip(0.03 * -forward[closed].min(initial=0), 1e-4, 5e-4)
    wake = (forward < -hair) & (downstream > 0)
    end = downstream[wake].max(initial=1)
    outer = np.ma.array(psi, mask=(r < 1) | ((downstream > 0) & (downstream < end - 0.01)))
    axes.contour(x, y, outer, [0], linewidths=1.0, **pen)
    if wake.any():
        axes.contour(x, y, np.where(downstream > 0, forward, 0), [-hair], linewidths=1.0, **pen)
