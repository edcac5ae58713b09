"""A movie of a value in the plane, from the pictures of a run, and the streamlines upon it."""

import numpy as np
from _movie_shown import LEAST, Units, count, even_colours
from _outline import circles, discs, is_circle, walls, within
from _panels import window
from _pressure import around_bodies, look, rounded_end
from _replaced import Refused
from _streamlines import OUTSIDE, gone_on
from _style import INK, Nothing
from _vorticity import gone_inside, in_units, picture, rounded, scale, two_signs
from contourpy import contour_generator
from matplotlib.collections import LineCollection

SAMPLE = 40  # so many of all tell where the colours end
FASTEST = 0.995  # so much of the plane has a speed with a colour of its own, or less vorticity
FAINT = 0.02  # of that vorticity: where there is less, all along, is no part of the movie
LINES = 24  # of equal stream function in free space


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
        self.lines = LineCollection([], colors=INK, linewidths=0.6, alpha=0.7, animated=True)
        axes.add_collection(self.lines, autolim=False)

    def show(self, field):
        contours = contour_generator(field["x"], field["y"], field["psi"])
        self.lines.set_segments([line for level in self.levels for line in contours.lines(level)])
