"""What a movie shows of a flow, picture by picture: a value in the plane, or the blobs."""

import numpy as np
from _colours import COLOURS
from _movie_file import Refused
from _outline import circles, discs, is_circle, walls, within
from _panels import window
from _pressure import around_bodies, look, rounded_end
from _streamlines import OUTSIDE, gone_on
from _style import Broken, Nothing
from _vorticity import gone_inside, in_units, picture, rounded, scale, two_signs
from contourpy import contour_generator
from matplotlib.collections import LineCollection

LEAST = 10  # pictures
SAMPLE = 40  # so many of all tell where the colours end
FASTEST = 0.995  # so much of the plane has a speed with a colour of its own, or less vorticity
FAINT = 0.02  # of that vorticity: where there is less, all along, is no part of the movie
LINES = 24  # of equal stream function in free space
REACH = 5.0  # of a window that no one has asked for, in half the body's length
STRONG = 0.98  # so many blobs in the window have a vorticity with a colour of its own


class Units:
    """The body's radius and the stream's speed, from its centre; those of the scene in free space.
    """

    def __init__(self, run):
        self.run, self.body = run, bool(run.bodies)
        self.length, self.centre = run.body if self.body else (1.0, np.zeros(2))
        self.speed = run.speed if self.body else 1.0

    def time(self, t):
        return t * self.speed / self.length

    def label(self, words, letters, units):
        return f"{words}  ${letters} {units if self.body else ''}$"


class Plane:
    """A value on the grid of fields.h5, as an image."""

    def __init__(self, run, told="omega"):
        self.run, self.units = run, Units(run)
        try:
            self.fields = run.fields()
        except Nothing:
            self.fields = ()
        self.pictures = [k for k in range(len(self.fields)) if told in self.fields.told[k]]
        if len(self.pictures) < LEAST:
            raise Refused(f"{run.folder}: {count(len(self.pictures), 'picture')} of the flow "
                          f"there, and {LEAST} are the least of a movie; a run with "
                          "output.fields_every, output.window and output.field_spacing leaves them")
        if len({self.fields.grids[k] for k in self.pictures}) > 1:
            raise Refused(f"{run.folder}: its pictures are on several grids, as of a run that was "
                          "resumed with another output.window; a movie has one")
        self.times = [self.fields.times[k] for k in self.pictures]
        self.window = self._window()
        self.round = self.units.body and all(is_circle(run, k) for k in run.numbers)

    def field(self, k):
        units = self.units
        made = in_units([self.fields[self.pictures[k]]], units.length, units.centre, units.speed)[0]
        return {**made, "time": self.times[k]}

    def _window(self):
        """Where there is ever vorticity, and the bodies."""
        largest = np.max([np.abs(field["omega"]) for field in self.sample()], axis=0)
        faint = FAINT * np.quantile(largest, FASTEST)
        if not 0 < faint < np.inf:
            raise Refused(f"{self.run.folder}: no vorticity in the pictures")
        return window([{**self.field(0), "omega": largest}], "omega", faint, self.units.body)

    def sample(self):
        for k in np.unique(np.linspace(0, len(self.times) - 1, SAMPLE).round().astype(int)):
            yield self.field(k)

    def walls(self, field):
        return walls(self.run, field["time"]) if self.units.body else []

    def beyond_walls(self, field, values):
        """The values of the fluid go on in the bodies, so that no seam runs along the wall."""
        inside = within(field, self.walls(field))
        return gone_on(np.where(inside, np.nan, values)) if inside.any() else values

    def add(self, axes):
        field = self.field(0)
        self.image = picture(axes, field, self.values(field), self.paint())
        self.image.set_animated(True)
        return self.image

    def show(self, field):
        self.image.set_data(self.values(field))

    def streamlines(self, axes):
        return Streamlines(self, axes)


class Vorticity(Plane):
    @property
    def label(self):
        return self.units.label("vorticity", "\\omega", "R/U")

    def paint(self):
        if self.units.body:
            return even_colours(scale(self.sample(), lambda f: discs(self.run, f["time"])))
        return two_signs(*np.median([(f["omega"].min(), f["omega"].max()) for f in self.sample()],
                                    axis=0))[0]

    def values(self, field):
        if self.round:
            return gone_inside(field, circles(self.run, field["time"]))
        return self.beyond_walls(field, field["omega"])


class Speed(Plane):
    @property
    def label(self):
        return self.units.label("speed", "|u|", "/U")

    def paint(self):
        most = max(np.quantile(self.values(field), FASTEST) for field in self.sample())
        if not 0 < most < np.inf:
            raise Refused(f"{self.run.folder}: nothing moves in the pictures")
        return {"cmap": "viridis", "vmin": 0, "vmax": rounded(most)}

    def values(self, field):
        return np.hypot(field["u"], field["v"])


class Pressure(Plane):
    def __init__(self, run):
        super().__init__(run, "p")

    @property
    def label(self):
        return "pressure  $C_p$" if self.units.body else "pressure  $p$"

    def fluid(self, field):
        if self.units.body:
            return around_bodies(field, self.walls(field))
        return {**field, "fluid": np.ones(field["p"].shape, bool)}

    def paint(self):
        sample = [{name: field[name] for name in ("x", "y", "p", "fluid")}
                  for field in map(self.fluid, self.sample())]
        try:
            end = np.median([rounded_end([field], self.units.body) for field in sample])
        except Nothing:
            raise Refused(f"{self.run.folder}: no pressure in the pictures") from None
        return look(max(field["p"].max() for field in sample), end)

    def values(self, field):
        field = self.fluid(field)
        return gone_on(np.where(field["fluid"], field["p"], np.nan))


class Streamlines:
    """Lines of equal stream function at the same values in all pictures."""

    def __init__(self, plane, axes):
        if not all("psi" in plane.fields.told[k] for k in plane.pictures):
            raise Refused(f"{plane.run.folder}: --streamlines needs the stream function psi, which "
                          "pictures of a run by vortices have")
        middle = plane.field(len(plane.times) // 2)["psi"]
        step = OUTSIDE if plane.units.body and plane.run.stream.any() else np.ptp(middle) / LINES
        most = 1.5 * np.abs(middle).max()
        self.levels = np.r_[-np.arange(step / 2, most, step), np.arange(step / 2, most, step)]
        self.lines = LineCollection([], colors="#222222", linewidths=0.6, alpha=0.7, animated=True)
        axes.add_collection(self.lines, autolim=False)

    def show(self, field):
        contours = contour_generator(field["x"], field["y"], field["psi"])
        self.lines.set_segments([line for level in self.levels for line in contours.lines(level)])


class Blobs:
    """The blobs or particles of frames.h5, as dots in the colours of their vorticity."""

    def __init__(self, run):
        self.run, self.units = run, Units(run)
        with run.hdf5("frames.h5") as file:
            found = sorted((float(file[name].attrs["time"]), name) for name in file
                           if name.startswith("frame_"))
        if len(found) < LEAST:
            raise Refused(f"{run.folder}: {count(len(found), 'frame')} there, and {LEAST} are the "
                          "least of a movie of blobs; output.frames says the time between two")
        self.times, self.names = zip(*found)
        self.window = self._window()

    def _window(self):
        asked, units = self.run.scene.get("output", {}).get("window"), self.units
        if asked:
            low, high = (np.subtract(asked[k:k + 2], units.centre) / units.length for k in (0, 2))
            return (low[0], high[0], low[1], high[1])
        if units.body:
            return (-0.6 * REACH, REACH, -0.6 * REACH, 0.6 * REACH)
        ends = [(*np.quantile(f["x"], (0.01, 0.99)), *np.quantile(f["y"], (0.01, 0.99)))
                for f in (self.field(0), self.field(len(self.times) - 1))]
        low, high = np.min(ends, axis=0)[[0, 2]], np.max(ends, axis=0)[[1, 3]]
        pad = 0.08 * np.max(high - low)
        return (low[0] - pad, high[0] + pad, low[1] - pad, high[1] + pad)

    @property
    def label(self):
        words = f"vorticity of a {self.run.particle}"
        return self.units.label(words, "\\omega", "R/U")

    def field(self, k):
        """Places, widths and vorticities, the strong ones last."""
        with self.run.hdf5("frames.h5") as file:
            frame = file[self.names[k]]
            try:
                told = {name: frame[name][()] for name in frame if hasattr(frame[name], "shape")}
            except (KeyError, OSError):
                raise Broken(f"{self.run.folder / 'frames.h5'}: a frame is damaged") from None
        width = told["spacing"] if "spacing" in told else told["sigma"]
        omega = (told["vorticity"] if "vorticity" in told
                 else told["gamma"] / (np.pi * told["sigma"] ** 2))
        units, order = self.units, np.abs(omega).argsort()
        return {"time": self.times[k], "x": ((told["x"] - units.centre[0]) / units.length)[order],
                "y": ((told["y"] - units.centre[1]) / units.length)[order],
                "width": (width / units.length)[order],
                "omega": (omega * units.length / units.speed)[order]}

    def add(self, axes):
        self.dots = axes.scatter([], [], s=[], c=[], lw=0, animated=True, **self.paint())
        low, high = self.window[:2]
        self.points = 72 * axes.get_position().width * axes.figure.get_figwidth() / (high - low)
        return self.dots

    def seen(self, field):
        """The vorticities within the window."""
        (left, right, low, high), x, y = self.window, field["x"], field["y"]
        return field["omega"][(x > left) & (x < right) & (y > low) & (y < high)]

    def paint(self):
        few = np.linspace(0, len(self.times) - 1, LEAST).round().astype(int)
        ends = [np.quantile(omega, (1 - STRONG, STRONG)) for k in few
                if (omega := self.seen(self.field(k))).size]
        least, most = np.median(ends or [(0, 0)], axis=0)
        if not 0 < max(-least, most) < np.inf:
            raise Refused(f"{self.run.folder}: no vorticity in the frames")
        if self.units.body:
            return even_colours(rounded(max(-least, most)))
        return two_signs(least, most)[0]

    def show(self, field):
        self.dots.set_offsets(np.c_[field["x"], field["y"]])
        self.dots.set_sizes(np.maximum(self.points * field["width"], 1.0) ** 2)
        self.dots.set_array(field["omega"])

    def streamlines(self, axes):
        raise Refused("--streamlines goes with pictures of the flow, not with --what blobs")


def even_colours(end):
    return {"cmap": COLOURS, "vmin": -end, "vmax": end}


def count(number, noun):
    return f"{number or 'no'} {noun}{'' if number == 1 else 's'}"


SHOWN = {"vorticity": Vorticity, "speed": Speed, "pressure": Pressure, "blobs": Blobs}
