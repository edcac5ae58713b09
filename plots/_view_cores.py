"""How the blobs of a frame act: as round Gaussians, of which some blobs are two."""

import numpy as np
from _outline import is_circle

# As in the program: src/vortex/cores/halves.hpp, src/vortex/cores/folded_core.hpp.
ROUND, THINNEST, SUPPORT = 2e-3, 1e-3, 4.0
CHUNK = 2_000_000  # distances held at once
SMOOTH = 0.3  # radians between two edges of an outline that is bent there, and has no corner


class Acting:
    """x, y, gamma, sigma of each blob's first Gaussian; of those blobs that are two, `owner` is the
    number of the blob and x2, y2 the place of the second, which has the same gamma and sigma."""

    def __init__(self, x, y, gamma, sigma, owner, x2, y2):
        self.x, self.y, self.gamma, self.sigma = x, y, gamma, sigma
        self.owner, self.x2, self.y2 = owner, x2, y2

    def parts(self):
        """x, y, gamma, sigma of all Gaussians."""
        k = self.owner
        return (np.r_[self.x, self.x2], np.r_[self.y, self.y2], np.r_[self.gamma, self.gamma[k]],
                np.r_[self.sigma, self.sigma[k]])


def halves(x, y, gamma, sigma, xx, xy):
    """In free space: strained blobs are two halves (src/vortex/cores/halves.hpp)."""
    size = np.hypot(xx, xy)
    two = np.flatnonzero(2 * size >= ROUND * sigma**2)
    dx = np.sqrt(np.maximum(size + xx, 0))[two]
    dy = np.copysign(np.sqrt(np.maximum(size - xx, 0)), xy)[two]
    made = Acting(x.copy(), y.copy(), gamma.copy(), sigma.copy(), two, x[two] - dx, y[two] - dy)
    made.x[two] += dx
    made.y[two] += dy
    made.gamma[two] /= 2
    made.sigma[two] = np.sqrt(np.maximum(sigma**2 - 2 * size, THINNEST * sigma**2))[two]
    return made


def folded(x, y, gamma, sigma, xx, xy, walls):
    """Beside walls: a blob near one and its mirror image in it (src/vortex/wall/vorticity.hpp)."""
    height, foot, normal, bend = nearest(np.c_[x, y], SUPPORT * sigma, walls)
    c, s = normal[:, 0] ** 2 - normal[:, 1] ** 2, 2 * normal[:, 0] * normal[:, 1]
    across = sigma**2 / 2 + xx * c + xy * s
    along = np.maximum(sigma**2 - across, 1e-300)
    followed = bend * np.clip(3 - 2 * np.abs(bend) * np.sqrt(8 * along), 0, 1)
    height = height + followed / 2 * (along - across)
    two = np.flatnonzero(height < SUPPORT * sigma)
    up = height[two, None] * normal[two]
    made = Acting(x.copy(), y.copy(), gamma, sigma, two, *(foot[two] - up).T)
    made.x[two], made.y[two] = (foot[two] + up).T
    return made


def nearest(places, within, walls):
    """Distance from the nearest wall, the point there, its outward normal and curvature; infinitely
    far where no wall is `within`. walls: as walls_of() gives them."""
    n = len(places)
    distance, bend, foot, normal = np.full(n, np.inf), np.zeros(n), *np.zeros((2, n, 2))
    for wall in walls:
        near = np.flatnonzero(np.hypot(*(places - wall.centre).T) < wall.radius + within)
        found = wall.nearest(places[near])
        nearer = found[0] < distance[near]
        for all_of, some in zip((distance, foot, normal, bend), found):
            all_of[near[nearer]] = some[nearer]
    return distance, foot, normal, bend


def walls_of(run, corners):
    """Of each body, by its corners where it is now; a circle is one, not a polygon."""
    return [Circle(one) if is_circle(run, k) else Polygon(one)
            for k, one in zip(run.numbers, corners)]


class Circle:
    def __init__(self, corners):
        low, high = corners.min(0), corners.max(0)
        self.centre = (low + high) / 2
        self.radius = np.hypot(*(corners - self.centre).T).max()

    def nearest(self, places):
        away = places - self.centre
        r = np.hypot(*away.T)
        normal = away / np.maximum(r, 1e-300)[:, None]
        return (r - self.radius, self.centre + self.radius * normal, normal,
                np.full(len(r), 1 / self.radius))


class Polygon:
    def __init__(self, corners):
        first = corners[:-1] if np.allclose(corners[0], corners[-1]) else corners
        x, y = first.T
        if np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y) < 0:
            first = first[::-1]
        self.corners, self.centre = first, first.mean(0)
        self.radius = np.hypot(*(first - self.centre).T).max()
        edge = np.roll(first, -1, 0) - first
        length = np.hypot(*edge.T)
        out = np.c_[edge[:, 1], -edge[:, 0]] / length[:, None]
        before = np.roll(out, 1, 0)
        turn = np.arctan2(before[:, 0] * out[:, 1] - before[:, 1] * out[:, 0],
                          (before * out).sum(1))
        bends = turn / ((length + np.roll(length, 1)) / 2)
        smooth = np.abs(turn) < SMOOTH
        mean = unit(np.where(smooth[:, None], out + before, out))
        self.edge, self.length = edge, length
        self.normals = mean, unit(np.where(np.roll(smooth, -1)[:, None], np.roll(mean, -1, 0), out))
        bends = np.where(smooth, bends, 0)
        self.bends = bends, np.roll(bends, -1)

    def nearest(self, places):
        count = max(1, CHUNK // len(self.corners))
        pieces = [self._nearest(places[k:k + count]) for k in range(0, len(places), count)]
        return [np.concatenate(one) for one in zip(*pieces)] or self._nearest(places)

    def _nearest(self, places):
        if not len(places):
            return np.zeros(0), np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0)
        away = places[:, None] - self.corners
        corner = (away**2).sum(2).argmin(1)
        best = None
        for first in (corner, corner - 1):
            found = self._on_edge(places, first % len(self.corners))
            if best is None:
                best = found
                continue
            nearer = np.abs(found[0]) < np.abs(best[0])
            best = [np.where(nearer if old.ndim == 1 else nearer[:, None], new, old)
                    for new, old in zip(found, best)]
        return best

    def _on_edge(self, places, first):
        """As on an arc between two corners, with normals and curvatures between theirs."""
        a, edge, length = self.corners[first], self.edge[first], self.length[first]
        part = ((places - a) * edge).sum(1) / length**2
        for _ in range(4):
            part = np.clip(part, 0, 1)
            normal = unit(between(part[:, None], *(one[first] for one in self.normals)))
            bend = between(part, *(one[first] for one in self.bends))
            bow = bend * length**2 * part * (1 - part) / 2
            foot = a + part[:, None] * edge + bow[:, None] * normal
            away = places - foot
            height = (away * normal).sum(1)
            astray = away[:, 1] * normal[:, 0] - away[:, 0] * normal[:, 1]
            part = part + astray / length / np.maximum(1 + bend * height, 0.2)
        return [np.where(height < 0, -1.0, 1.0) * np.hypot(*away.T), foot, normal, bend]


def unit(vectors):
    return vectors / np.maximum(np.hypot(*vectors.T), 1e-12)[:, None]


def between(part, a, b):
    return (1 - part) * a + part * b


def vorticity(parts, at_x, at_y):
    """The sum of such Gaussians at some places."""
    x, y, gamma, sigma = parts
    peaks, narrow = gamma / (np.pi * sigma**2), 1 / sigma**2
    count = max(1, CHUNK // max(x.size, 1))
    total = [(peaks * np.exp(-((X[:, None] - x) ** 2 + (Y[:, None] - y) ** 2) * narrow)).sum(1)
             for X, Y in ((at_x[k:k + count], at_y[k:k + count])
                          for k in range(0, at_x.size, count))]
    return np.concatenate(total) if total else np.zeros(0)
