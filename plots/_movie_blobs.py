"""A movie of the blobs or particles, from the frames of a run."""

import numpy as np
from _movie_shown import LEAST, Units, count, even_colours
from _replaced import Refused
from _style import Broken
from _vorticity import rounded, two_signs

REACH = 5.0  # of a window that no one has asked for, in half the body's length
STRONG = 0.98  # so many blobs in the window have a vorticity with a colour of its own


def window_of(run, units, ends):
    """What a page shows at first: what the scene asks for, or what lies around the body, or most of
    the blobs in free space at both ends of the run, which ends() gives as fields of x and y."""
    asked = run.scene.get("output", {}).get("window")
    if asked:
        low, high = (np.subtract(asked[k:k + 2], units.centre) / units.length for k in (0, 2))
        return (low[0], high[0], low[1], high[1])
    if units.body:
        return (-0.6 * REACH, REACH, -0.6 * REACH, 0.6 * REACH)
    boxes = [(*np.quantile(f["x"], (0.01, 0.99)), *np.quantile(f["y"], (0.01, 0.99)))
             for f in ends()]
    low, high = np.min(boxes, axis=0)[[0, 2]], np.max(boxes, axis=0)[[1, 3]]
    pad = 0.08 * np.max(high - low)
    return (low[0] - pad, high[0] + pad, low[1] - pad, high[1] + pad)


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
        return window_of(self.run, self.units,
                         lambda: (self.field(0), self.field(len(self.times) - 1)))

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
