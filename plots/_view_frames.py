"""The frames of a run as a page takes them: in the units of its figures, and small."""

import zlib

import numpy as np
from _movie_blobs import window_of
from _movie_shown import Units
from _outline import centres, discs, walls
from _style import Broken, Nothing
from _view_cells import childless
from _view_cores import folded, halves, vorticity, walls_of
from _vorticity import in_units, rounded, scale

USUAL = 50  # blobs that a cell may hold and stay whole, where the scene leaves it to the program
WALL = 2  # the last kind of particles that is no node of the outer boundary
LEVELS = 2**24  # of a position between the least and the greatest of its frame
BITS = 13  # of a gamma, a sigma, a value of a particle, behind the first: 6e-5 of it
SAMPLE, STRONG = 5, 200  # frames that tell where colours end; the blobs of each that tell

# name, how it is packed, and of what there are so many: see `packed`.
BLOBS = (("x", "place", "many"), ("y", "place", "many"), ("gamma", "real", "many"),
         ("sigma", "real", "many"), ("owner", "whole", "seconds"), ("x2", "place", "seconds"),
         ("y2", "place", "seconds"), ("level", "byte", "cells"), ("column", "whole", "cells"),
         ("row", "whole", "cells"))
PARTICLES = (("x", "place", "many"), ("y", "place", "many"), ("u", "real", "many"),
             ("v", "real", "many"), ("pressure", "real", "many"), ("vorticity", "real", "many"),
             ("spacing", "real", "many"))


class Frames:
    """Those of frames.h5 by ascending time."""

    def __init__(self, run):
        self.run, self.units = run, Units(run)
        self.particles = run.scene.get("method", "vortex") == "sph"
        self.columns = PARTICLES if self.particles else BLOBS
        self.most = run.scene.get("velocity", {}).get("capacity", 0) or USUAL
        with run.hdf5("frames.h5") as file:
            try:
                found = sorted((float(file[name].attrs["time"]), name, file[name]["x"].size)
                               for name in file if name.startswith("frame_"))
            except (KeyError, OSError):
                raise self._damaged() from None
        self.times, self.names, self.sizes = ([one[k] for one in found] for k in range(3))

    def __len__(self):
        return len(self.times)

    def _damaged(self):
        return Broken(f"{self.run.folder / 'frames.h5'}: a frame is damaged")

    def told(self, k):
        """All columns of the file."""
        with self.run.hdf5("frames.h5") as file:
            try:
                frame = file[self.names[k]]
                columns = {name: frame[name][()] for name in frame if hasattr(frame[name], "shape")}
                if "state" in frame:
                    columns.update({name: frame["state"][name][()] for name in
                                    ("covariance_xx", "covariance_xy", "x_in_flow", "y_in_flow")
                                    if name in frame["state"]})
            except (KeyError, OSError):
                raise self._damaged() from None
        return columns

    def walls(self, k):
        return walls(self.run, self.times[k]) if self.units.body else []

    def acting(self, k, told=None):
        """The Gaussians that the blobs are, in the units of the figures."""
        told, units = told or self.told(k), self.units
        length = units.length
        x, y = ((told[name] - c) / length for name, c in zip("xy", units.centre))
        gamma, sigma = told["gamma"] / (length * units.speed), told["sigma"] / length
        xx, xy = (told.get(name, np.zeros(x.size)) / length**2
                  for name in ("covariance_xx", "covariance_xy"))
        if not units.body:
            return halves(x, y, gamma, sigma, xx, xy)
        c, s = np.cos(2 * self.angle(k)), np.sin(2 * self.angle(k))
        return folded(x, y, gamma, sigma, c * xx - s * xy, s * xx + c * xy,
                      walls_of(self.run, self.walls(k)))

    def angle(self, k):
        """By which the axes of the flow, as it is computed, are turned."""
        return float(self.run.angle(self.times[k])) if self.units.body else 0.0

    def cells(self, k, told):
        """Corner and side of the whole, levels, columns, rows: in the axes of the flow, and in the
        units of the figures as seen from there."""
        turn, (x, y) = self.angle(k), (told["x"] - self.units.centre[0],
                                       told["y"] - self.units.centre[1])
        c, s = np.cos(turn), np.sin(turn)
        x, y = c * x + s * y, c * y - s * x
        seen = [told.get(f"{name}_in_flow", places) for name, places in (("x", x), ("y", y))]
        corner, side, *rest = childless(*seen, self.most)
        away = [places[0] - own[0] for places, own in zip((x, y), seen)]
        length = self.units.length
        return [(low + by) / length for low, by in zip(corner, away)], side / length, *rest

    def frame(self, k):
        """What stands beside the columns, and the columns."""
        told, time = self.told(k), self.units.time(self.times[k])
        about = {"time": time, "places": self.places(k)}
        columns = self._particles(told) if self.particles else self._blobs(k, told, about)
        return about, columns

    def _blobs(self, k, told, about):
        made = self.acting(k, told)
        columns = {"x": made.x, "y": made.y, "gamma": made.gamma, "sigma": made.sigma,
                   "owner": made.owner, "x2": made.x2, "y2": made.y2,
                   "level": (), "column": (), "row": ()}
        about.update(many=made.x.size, seconds=made.owner.size, cells=0)
        if made.x.size:
            corner, side, *cells = self.cells(k, told)
            columns.update(zip(("level", "column", "row"), cells))
            about.update(cells=cells[0].size, corner=corner, side=side, turn=self.angle(k))
        return columns

    def _particles(self, told):
        seen = told["kind"] <= WALL
        units, (x, y) = self.units, self.units.centre
        length, speed = units.length, units.speed
        return {"x": (told["x"][seen] - x) / length, "y": (told["y"][seen] - y) / length,
                "u": told["u"][seen] / speed, "v": told["v"][seen] / speed,
                "pressure": told["pressure"][seen] / speed**2 * (2 if units.body else 1),
                "vorticity": told["vorticity"][seen] * length / speed,
                "spacing": told["spacing"][seen] / length}

    def places(self, k):
        """Of each body: where its centre is and by how much it is turned."""
        if not self.units.body:
            return []
        run, time = self.run, self.times[k]
        if not run.several:
            return [[0.0, 0.0, float(run.angle(time))]]
        return [[*(centre + run.place(n, time)[0] / run.body[0]).tolist(),
                 float(run.place(n, time)[1])] for n, centre in zip(run.numbers, centres(run))]

    def outlines(self):
        """Of each body, from its centre, not turned."""
        if not self.units.body:
            return []
        radius = self.run.body[0]
        return [np.c_[one["x"] / radius, one["y"] / radius] - centre
                for one, centre in zip(self.run.outlines, centres(self.run))]

    def window(self):
        def ends():
            for k in (0, len(self) - 1):
                told = self.told(k)
                yield {name: told[name] for name in "xy"}
        return [float(end) for end in window_of(self.run, self.units, ends)]

    def sample(self, count=SAMPLE):
        return np.unique(np.linspace(0, len(self) - 1, count).round().astype(int))

    def ends(self):
        """Where the colours of each quantity end: low and high."""
        if self.particles:
            return self._ends_of_particles()
        return {"vorticity": self._ends_of_blobs(), "alone": self._ends_of_each()}

    def _ends_of_each(self):
        """Of what the vorticity of most blobs alone is."""
        most = [np.quantile(np.abs(one.gamma / (np.pi * one.sigma**2)), 0.9)
                for one in map(self.acting, self.sample()) if one.gamma.size]
        end = rounded(max(np.median(most or [1.0]), 1e-9))
        return [-end, end]

    def _ends_of_blobs(self):
        """As in the figures: by their grids if the run has left any, else by the vorticity at the
        strongest blobs, away from bodies."""
        if self.units.body:
            try:
                run, units = self.run, self.units
                fields = run.fields()
                few = [fields[k] for k in np.unique(np.linspace(0, len(fields) - 1, 4).astype(int))]
                end = scale(in_units(few, units.length, units.centre, units.speed),
                            lambda field: discs(run, field["time"] * units.length / units.speed))
                return [-end, end]
            except Nothing:
                pass
        found = [peaks for k in self.sample() if (peaks := self._peaks(k)).size]
        if not found:
            return [-1.0, 1.0]
        least, most = np.median([(min(one.min(), 0), max(one.max(), 0)) for one in found], axis=0)
        if self.units.body or -least > 0.01 * most > 0 or most <= 0:
            end = rounded((0.63 if self.units.body else 1) * max(-least, most, 1e-9))
            return [-end, end]
        return [0.0, rounded(max(most, 1e-9))]

    def _peaks(self, k):
        parts = self.acting(k).parts()
        x, y, gamma, sigma = parts
        away = np.ones(x.size, bool)
        if self.units.body:
            for centre, radius in discs(self.run, self.times[k]):
                away &= np.hypot(x - centre[0], y - centre[1]) > 1.25 * radius
        some = np.flatnonzero(away)
        some = some[np.abs(gamma / sigma**2)[some].argsort()[-STRONG:]]
        return vorticity(parts, x[some], y[some])

    def _ends_of_particles(self):
        columns = [self._particles(self.told(k)) for k in self.sample(3)]
        spacing = np.concatenate([one["spacing"] for one in columns])
        def end(name, share):
            return rounded(max(np.median([np.quantile(np.abs(one[name]), share)
                                          for one in columns]), 1e-9))
        fast = rounded(max(max(np.quantile(np.hypot(one["u"], one["v"]), 0.99)
                               for one in columns), 1e-9))
        return {"vorticity": [-end("vorticity", 0.97), end("vorticity", 0.97)],
                "pressure": [-end("pressure", 0.98), end("pressure", 0.98)],
                "speed": [0.0, fast], "finest": float(spacing.min()),
                "level": [-0.5, float(np.ceil(2 * np.log2(spacing.max() / spacing.min()) + 1) / 2)]}


def packed(columns, kinds, about):
    """All columns, deflated; `about` learns what is needed to read them again.

    place  3 bytes: low + step k, k < 2^24; off by at most half a step
    real   4 bytes: a float rounded to 13 bits behind the first, off by at most 6e-5 of it
    whole  4 bytes; byte: one. Bytes of one rank stand together.
    """
    about["many"] = len(columns["x"])
    low, step = [], []
    pieces = []
    for name, kind, _ in kinds:
        values = np.asarray(columns[name])
        if kind == "place" and len(low) < 2:
            both = np.r_[values, columns.get(name + "2", ())]
            low.append(float(both.min(initial=np.inf)) if both.size else 0.0)
            step.append(float(np.ptp(both)) / (LEVELS - 1) if both.size and np.ptp(both) else 1.0)
        if kind == "place":
            axis = 0 if name[0] == "x" else 1
            whole = np.rint((values - low[axis]) / step[axis]).astype("<u4")
            pieces.append(planes(whole, 3))
        elif kind == "real":
            pieces.append(planes(short(values), 4))
        else:
            pieces.append(planes(np.asarray(values, "<u4"), 4 if kind == "whole" else 1))
    about.update(low=low, step=step)
    return zlib.compress(b"".join(pieces), 6)


def planes(words, bytes_each):
    return np.ascontiguousarray(words.view(np.uint8).reshape(-1, 4)[:, :bytes_each].T).tobytes()


def short(values):
    """As single floats with the last bits rounded to zeros."""
    words = np.asarray(values, "<f4").view("<u4")
    drop = 23 - BITS
    return ((words.astype(np.uint64) + (1 << drop - 1)) >> drop << drop).astype("<u4")
