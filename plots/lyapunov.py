"""Lagrangian coherent structures: ridges of finite-time Lyapunov exponents, which fluid that is
drawn in leaves as dye does (backward in time) or is parted by (forward); by SPH with the particles
below."""

import numpy as np
from _colours import BLUES, REDS
from _outline import outline
from _style import Broken, Nothing, figure, main
from matplotlib.cm import ScalarMappable
from matplotlib.colors import BoundaryNorm, LinearSegmentedColormap, Normalize, to_rgb
from matplotlib.transforms import Affine2D

MOST = 4  # panels
UNKNOWN = "#ececec"
WALL = 2  # the last kind of particle that is no node of the outer boundary
LOOKS = {"backward": (BLUES[::-1] + ["#0d2f5c"], "attracting (backward)"),
         "forward": (REDS + ["#6d1119"], "repelling (forward)")}


def draw(run):
    fields, count = read(run)
    place = Place(run)
    box = window(fields, place)
    below = particles(run, fields)
    columns = min(len(fields), 2)
    rows = -(-len(fields) // columns)
    tall = (box[3] - box[2]) / (box[1] - box[0])
    width = 4.6 if columns == 2 else 8.0
    fig = figure(11.0, 0.9 + (rows + bool(below)) * (0.36 + tall * width), title(run, fields, count))
    grid = fig.subplots(rows + bool(below), columns, sharex=True, sharey=True, squeeze=False)
    upper = grid[:rows]
    for axes in upper.flat[len(fields):]:
        axes.set_visible(False)
    shown = list(zip(upper.flat, fields))
    ends = {way: scale(fields, way) / place.rate for way in LOOKS if any(way in f for f in fields)}
    for axes, field in shown:
        exponents(axes, field, place, ends)
    bars(fig, upper, ends, place)
    if below:
        last = list(zip(grid[-1], below[::-(-len(below) // columns)]))
        told = [dots(axes, frame, place, width / (box[1] - box[0]), below) for axes, frame in last]
        bar = fig.colorbar(told[-1], ax=list(grid[-1]), shrink=0.9, pad=0.012, aspect=12)
        bar.set_label(r"spacing $\log_2(s/s_0)$")
        bar.outline.set_linewidth(0.5)
        shown += last
    for axes, of in shown:
        axes.set_title(place.words(of["time"]))
        if place.body:
            shift = Affine2D().translate(*place.shift(of["time"]))
            axes.add_patch(outline(run, of["time"])).set_transform(shift + axes.transData)
        axes.set(xlim=box[:2], ylim=box[2:], aspect="equal")
        axes.grid(False)
    for axes in grid[-1]:
        axes.set_xlabel(f"$x{place.letter}$")
    for axes in grid[:, 0]:
        axes.set_ylabel(f"$y{place.letter}$")
    return fig


class Place:
    """From where lengths are counted, and in which units. Pictures are as seen from a body that
    plunges; here it is drawn where it is then."""

    def __init__(self, run):
        self.body = "body" in run.scene
        self.unit, self.origin = run.body if self.body else (1.0, np.zeros(2))
        self.rate = run.speed / self.unit if self.body else 1.0
        self.letter = "/R" if self.body else ""
        self.plunge = run.scene.get("plunge")

    def shift(self, time):
        """Of the body since its mean place, in these units."""
        if not self.plunge:
            return np.zeros(2)
        way = np.array(self.plunge.get("direction", [0.0, 1.0]))
        turn = 2 * np.pi * self.plunge["frequency"] * time
        return self.plunge["amplitude"] * np.cos(turn) * way / np.hypot(*way) / self.unit

    def axes(self, x, y, time):
        dx, dy = self.shift(time)
        return (x - self.origin[0]) / self.unit + dx, (y - self.origin[1]) / self.unit + dy

    def words(self, time):
        if self.plunge:
            return rf"$t/\tau = {time * self.plunge['frequency']:.4g}$"
        return f"$T = {time * self.rate:.3g}$" if self.body else f"$t = {time:.3g}$"


def read(run):
    with run.hdf5("lyapunov.h5") as file:
        try:
            found = [{"time": float(g.attrs["time"]), "x": g["x"][()], "y": g["y"][()],
                      **{way: g[way][()] for way in LOOKS if way in g}} for g in file.values()]
        except (KeyError, OSError):
            raise Broken(f"{run.folder / 'lyapunov.h5'}: damaged") from None
    if not any(np.isfinite(f[way]).any() for f in found for way in LOOKS if way in f):
        raise Nothing
    found.sort(key=lambda field: field["time"])
    count = len(found)
    if count > MOST:
        found = [found[i] for i in np.linspace(0, count - 1, MOST).round().astype(int)]
    return found, count


def title(run, fields, count):
    told = run.scene.get("title", "")
    return told if len(fields) == count else f"{told}  ({len(fields)} of {count} times)".strip()


def scale(fields, way):
    """Where the colours end: all but the sharpest ridges are told apart."""
    known = np.concatenate([f[way][np.isfinite(f[way])] for f in fields if way in f])
    return max(float(np.quantile(known, 0.995)), 1e-9) if known.size else 1.0


def window(fields, place):
    """All that is known at any time."""
    low, high = [], []
    for field in fields:
        known = np.any([np.isfinite(field[way]) for way in LOOKS if way in field], axis=0)
        rows, columns = np.nonzero(known)
        if rows.size:
            x, y = place.axes(field["x"], field["y"], field["time"])
            low.append((x[columns.min()], y[rows.min()]))
            high.append((x[columns.max()], y[rows.max()]))
    (left, bottom), (right, top) = np.min(low, axis=0), np.max(high, axis=0)
    if not (right > left and top > bottom):
        raise Nothing  # a line of places, or one
    return left, right, bottom, top


def exponents(axes, field, place, ends):
    """Each way a colour that multiplies what is below, so that both show where they cross."""
    x, y = place.axes(field["x"], field["y"], field["time"])
    dx, dy = x[1] - x[0], y[1] - y[0]
    paint = np.ones((y.size, x.size, 3))
    for way in ends:
        if way in field:
            values = field[way] / place.rate / ends[way]
            paint *= np.where(np.isfinite(values)[..., None],
                              colours(way)(np.clip(np.nan_to_num(values), 0, 1))[..., :3],
                              to_rgb(UNKNOWN))
    axes.imshow(paint, origin="lower", interpolation="antialiased",
                extent=(x[0] - dx / 2, x[-1] + dx / 2, y[0] - dy / 2, y[-1] + dy / 2))


def colours(way):
    return LinearSegmentedColormap.from_list(way, LOOKS[way][0])


def bars(fig, panels, ends, place):
    for way, end in ends.items():
        bar = fig.colorbar(ScalarMappable(Normalize(0, end), colours(way)), ax=list(panels.flat),
                           shrink=0.8, pad=0.012, aspect=16 * len(panels), extend="max")
        bar.set_label(f"{LOOKS[way][1]}  $\\lambda{' R/U' if place.body else ''}$")
        bar.outline.set_linewidth(0.5)


def particles(run, fields):
    """The frame of each time, if they are SPH particles and all are there."""
    names = ("x", "y", "spacing", "kind")
    if run.particle != "particle":
        return None
    with run.hdf5("frames.h5") as file:
        frames = {float(g.attrs["time"]): g for n, g in file.items() if n.startswith("frame_")}
        found = []
        for field in fields:
            near = min(frames, key=lambda t: abs(t - field["time"]), default=np.inf)
            if abs(near - field["time"]) > 0.5 * run.scene["time"]["dt"]:
                return None
            try:
                found.append({"time": near, **{name: frames[near][name][()] for name in names}})
            except (KeyError, OSError):
                raise Broken(f"{run.folder / 'frames.h5'}: a frame is damaged") from None
    return found


def dots(axes, frame, place, inches, all_frames):
    """A dot as wide as the particle's own square."""
    kept = frame["kind"] <= WALL
    x, y = place.axes(frame["x"][kept], frame["y"][kept], frame["time"])
    finest = min(f["spacing"][f["kind"] <= WALL].min() for f in all_frames)
    widest = max(f["spacing"][f["kind"] <= WALL].max() for f in all_frames)
    edges = np.arange(-0.5, np.ceil(np.log2(widest / finest) + 0.5) + 0.01, 0.5)
    size = (72 * inches * 0.9 * frame["spacing"][kept] / place.unit) ** 2
    return axes.scatter(x, y, s=size, lw=0, c=np.log2(frame["spacing"][kept] / finest),
                        cmap="viridis", norm=BoundaryNorm(edges, 256), rasterized=True)


main("lyapunov.png", draw)
