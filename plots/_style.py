"""What the figures share: a look, and a way to read the folder that a run leaves."""

import sys
import tomllib
from collections.abc import Sequence
from contextlib import contextmanager
from functools import cached_property
from itertools import cycle
from pathlib import Path

import matplotlib
import numpy as np
from _replaced import Refused, printable, refuse, replaced
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

# Okabe & Ito 2008: told apart by readers of every kind of colour vision.
BLUE, ORANGE, GREEN, RED, SKY, GREY = ("#0072b2", "#e69f00", "#009e73", "#d55e00", "#56b4e9",
                                       "#999999")
INK = "#222222"

EACH = ({"color": BLUE, "ls": "-"}, {"color": RED, "ls": (0, (4, 1.5))},  # of several bodies
        {"color": GREEN, "ls": (0, (6, 1.5, 1, 1.5))}, {"color": ORANGE, "ls": (0, (1.5, 1))})

matplotlib.rcParams.update({
    "figure.dpi": 150, "savefig.dpi": 150, "figure.constrained_layout.use": True,
    "font.family": "STIXGeneral", "mathtext.fontset": "stix", "font.size": 11,
    "axes.titlesize": 11.5, "axes.labelsize": 11.5, "figure.titlesize": 13,
    "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK, "axes.linewidth": 0.7,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True,
    "axes.grid": True, "grid.color": "#e4e4e4", "grid.linewidth": 0.6,
    "xtick.color": INK, "ytick.color": INK, "xtick.direction": "out", "ytick.direction": "out",
    "xtick.labelsize": 10, "ytick.labelsize": 10,
    # Fonts go along: in PDF as TrueType, text that can be searched and edited; in SVG as outlines, for a
    # page looks the same where STIX is not installed.
    "pdf.fonttype": 42, "svg.fonttype": "path", "svg.hashsalt": "vortree",
    "lines.linewidth": 1.4, "legend.frameon": False, "legend.fontsize": 10,
})


class Broken(Exception):
    """A file that is there but cannot be used; the message is one line that says why."""


class Nothing(Exception):
    """The folder lacks what the figure shows; the message, if any, says which file."""


def read_csv(path):
    """Columns of a CSV file by name. Lines that begin with # are notes; a last line that a kill has
    cut short is left out."""
    try:
        text = path.read_text()
    except (OSError, UnicodeDecodeError) as error:
        raise Broken(f"{path}: {getattr(error, 'strerror', None) or 'not a text file'}") from None
    lines = [(n, line) for n, line in enumerate(text.splitlines(), 1)
             if line.strip() and not line.startswith("#")]
    if not lines:
        raise Broken(f"{path}: has no header line")
    names = lines[0][1].split(",")
    if not text.endswith("\n") and lines[-1][1].count(",") + 1 < len(names):
        lines.pop()
    rows = []
    for n, line in lines[1:]:
        try:
            rows.append([float(word or "nan") for word in line.split(",")])
        except ValueError:
            raise Broken(f"{path}:{n}: not a row of numbers: {line[:60]}") from None
        if len(rows[-1]) != len(names):
            raise Broken(f"{path}:{n}: {len(rows[-1])} numbers under {len(names)} names")
    return Table(path, dict(zip(names, np.array(rows).reshape(-1, len(names)).T)))


class Table(dict):
    def __init__(self, path, columns):
        super().__init__(columns)
        self.path = path

    def __missing__(self, name):
        raise Broken(f"{self.path}: has no column \"{name}\"")


class Run:
    """The folder of a run. A file that is not there raises Nothing."""

    def __init__(self, folder):
        self.folder = Path(folder)

    def file(self, name):
        path = self.folder / name
        if not path.exists():
            raise Nothing(f"{path}: no such file; a run leaves it")
        return path

    def hdf5(self, name):
        import h5py
        path = self.file(name)
        try:
            return h5py.File(path, "r", locking=False)
        except OSError:
            raise Broken(f"{path}: not a readable HDF5 file") from None

    @cached_property
    def report(self):
        table = read_csv(self.file("report.csv"))
        if table["t"].size == 0:
            raise Nothing(f"{table.path}: no row yet")
        return table

    @cached_property
    def _attributes(self):
        """Texts are UTF-8, but for names of files that are not."""
        def plain(value):
            return value.decode(errors="surrogateescape") if isinstance(value, bytes) else value

        with self.hdf5("frames.h5") as file:
            return {name: plain(value) for name, value in file.attrs.items()}

    @cached_property
    def scene(self):
        try:
            return tomllib.loads(self._attributes["resolved"])
        except (KeyError, TypeError, tomllib.TOMLDecodeError):
            raise Broken(f"{self.folder / 'frames.h5'}: holds no resolved scene") from None

    @property
    def check(self):
        return self.scene.get("check", {})

    @property
    def sheds(self):
        """Vortices, by which the wake is checked."""
        return bool({"strouhal", "mean_drag_each"} & set(self.check))

    @property
    def route(self):
        """By which route the coefficients are told; the other one is a check."""
        return "wall" if self.scene.get("method") == "sph" else "impulse"

    @property
    def routes(self):
        """Both with their names in figures, the main one first."""
        both = [("impulse", "by impulse"), ("wall", "at the wall")]
        return sorted(both, key=lambda route: route[0] != self.route)

    @property
    def particle(self):
        """What one is called."""
        return "particle" if self.scene.get("method") == "sph" else "blob"

    def columns(self, name):
        """Of the coefficient of that name, of each body by its main route."""
        if self.several:
            return [f"{name}_wall_{k}" for k in self.numbers]
        return [f"{name}_{self.route}"]

    def plot_routes(self, axes, name, shown):
        """The coefficient of that name against the time of a figure: of one body by both routes, of
        each of several at the wall, with their mean by the other route."""
        if self.several:
            return self._plot_each(axes, name, shown)
        for (route, label), (colour, width) in zip(self.routes, ((BLUE, 1.4), (ORANGE, 0.8))):
            axes.plot(*shown(f"{name}_{route}"), color=colour, lw=width, label=label)

    def _plot_each(self, axes, name, shown):
        for k, look in zip(self.numbers, cycle(EACH)):
            axes.plot(*shown(f"{name}_wall_{k}"), lw=1.4, label=f"body {k}", **look)
        x, total = shown(f"{name}_impulse")
        axes.plot(x, total / len(self.bodies), color=INK, lw=0.6, label="mean of all, by impulse")

    @property
    def stream(self):
        return np.array(self.scene["flow"].get("stream", [0.0, 0.0]))

    @property
    def speed(self):
        """Of the stream; without one the greatest of the body's motion, that of an initial flow that
        fills the plane, or 1, as in the program's coefficients."""
        if self.bodies and any("motion" in moved for moved in (self.scene, *self.bodies)):
            return self.report["T"][0] / self.report["t"][0] * self.body[0]
        plunge = self.scene.get("plunge", {"amplitude": 0, "frequency": 0})
        fastest = 2 * np.pi * plunge["frequency"] * plunge["amplitude"]
        initial = self.scene.get("initial", {}).get("speed", 1.0)
        return float(np.hypot(*self.stream)) or fastest or initial

    @property
    def bodies(self):
        """What the scene says of each, in a list."""
        told = self.scene.get("body", [])
        return told if isinstance(told, list) else [told]

    @property
    def several(self):
        return len(self.bodies) > 1

    @property
    def numbers(self):
        """Of the bodies, as in the names of columns."""
        return range(1, len(self.bodies) + 1)

    @property
    def body(self):
        """(radius, centre) of the body, or the first, the radius half of its length D; Nothing in
        free space."""
        if not self.bodies:
            raise Nothing
        length, _ = self._outline
        return length / 2, np.array(self.bodies[0].get("centre", [0, 0]))

    @property
    def single_body(self):
        """The same, of what is told of a single body only: Nothing beside several."""
        if self.several:
            raise Nothing
        return self.body

    @property
    def outline(self):
        """x and y of the body's closed outline, from its centre."""
        return self._outline[1]

    @property
    def outlines(self):
        """The same of each body, from the centre of the first."""
        table = self.outline
        if not self.several:
            return [table]
        rows = [table["body"] == k for k in self.numbers]
        return [{name: table[name][some] for name in ("x", "y")} for some in rows]

    def place(self, number, time):
        """Of one of several bodies then: how far it has gone in the frame of all, and by which angle
        it is turned, in radians."""
        names = [f"body_{what}_{number}" for what in ("x", "y", "angle")]
        if time is None or not set(names) <= set(self.report):
            return np.zeros(2), 0.0
        x, y, angle = (self.at(time, name) for name in names)
        return np.array([x, y]), np.radians(angle)

    def at(self, time, name):
        """A column of the report then; before its first row straight on from the first two."""
        t, values = self.report["t"], self.report[name]
        if time >= t[0] or len(t) < 2:
            return np.interp(time, t, values)
        return values[0] + (time - t[0]) * (values[1] - values[0]) / (t[1] - t[0])

    def angle(self, time):
        """By which the body is turned then, anticlockwise, in radians."""
        if time is None or "motion" not in self.scene or "body_angle" not in self.report:
            return 0.0
        return np.radians(self.at(time, "body_angle"))

    @cached_property
    def _outline(self):
        path = self.file("outline.csv")
        table = read_csv(path)
        mark, _, length = path.read_text().partition("\n")[0].rpartition("=")
        try:
            length = float(length)
        except ValueError:
            length = 0
        if mark != "# D " or not length > 0 or table["x"].size < 3:
            raise Broken(f"{path}: no outline of a body of length D")
        return length, table

    def reference(self, key):
        """The reference file that [check] names, or None: it lies beside the scene file, or, when
        the folder has travelled, among the cases that come with the program."""
        if key not in self.check:
            return None
        reynolds = f"{self.scene['flow'].get('reynolds', 0)!r}".removesuffix(".0")
        written = Path(self.check[key].replace("{reynolds}", reynolds))
        beside = Path(self._attributes.get("scene_path", "")).parent / written
        shipped = Path(__file__).resolve().parent.parent / "cases" / written
        return next((read_csv(path) for path in (beside, shipped) if path.exists()), None)

    def fields(self):
        """Those of fields.h5; Nothing if there are none."""
        return Fields(self)


class Fields(Sequence):
    """The grids of fields.h5 by ascending time, each read when it is asked for: dictionaries of
    time, x, y, u, v, omega and, as far as they are told, the stream function psi and the pressure p.

    told, grids: of each, which of these there are, and ends and sizes of its axes.
    """

    NAMES, MORE = ("x", "y", "u", "v", "omega"), ("psi", "p")

    def __init__(self, run):
        self._run = run
        with self._open() as file:
            found = sorted((float(group.attrs["time"]), name, set(group),
                            tuple(group[axis][end] for axis in ("x", "y") for end in (0, -1))
                            + group["omega"].shape) for name, group in file.items())
        if not found:
            raise Nothing
        self.times, self._groups, self.told, self.grids = zip(*found)

    @contextmanager
    def _open(self):
        with self._run.hdf5("fields.h5") as file:
            try:
                yield file
            except (KeyError, OSError):
                raise Broken(f"{self._run.folder / 'fields.h5'}: a field is damaged") from None

    def __len__(self):
        return len(self.times)

    def __getitem__(self, k):
        with self._open() as file:
            group = file[self._groups[k]]
            return {"time": self.times[k], **{name: group[name][()] for name in self.NAMES},
                    **{name: group[name][()] for name in self.MORE if name in self.told[k]}}


def interpolated(x, y, at):
    """Cubic through the four nearest entries of a table, as the program's own check does it; NaN
    outside the table."""
    if len(x) < 4:
        return np.full(np.shape(at), np.nan)
    first = np.clip(np.searchsorted(x, at, "right") - 2, 0, len(x) - 4)
    nodes = [x[first + i] for i in range(4)]
    total = 0.0
    for i in range(4):
        weight = y[first + i]
        for k in range(4):
            if k != i:
                weight = weight * (at - nodes[k]) / (nodes[i] - nodes[k])
        total = total + weight
    return np.where((at < x[0] - 1e-9) | (at > x[-1] + 1e-9), np.nan, total)


def rms(values):
    return float(np.sqrt(np.nanmean(np.square(values))))


def figure(width, height, title=None):
    made = Figure(figsize=(width, height))
    FigureCanvasAgg(made)
    if title:
        made.suptitle(title)
    return made


def note(axes, text, x=0.985, y=0.94, **more):
    """Words in a corner of the axes, on white."""
    style = {"ha": "right" if x > 0.5 else "left", "va": "top" if y > 0.5 else "bottom",
             "fontsize": 9.5, "linespacing": 1.35,
             "bbox": {"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 2}}
    axes.text(x, y, text, transform=axes.transAxes, **{**style, **more})


FORMATS = ("png", "pdf", "svg")
# Fields, and what has so many parts that as lines it would fill megabytes, are pictures of 300 dots
# an inch on a page of vectors.
VECTORS = {"dpi": 300}
MOST_PARTS, MOST_POINTS = 5000, 50_000


def save(figure, path):
    """The same bytes of the same figure: no date."""
    kind = path.suffix[1:]
    options = {} if kind == "png" else VECTORS
    if kind != "png":
        rasterize_large(figure)
    dates = {"pdf": {"CreationDate": None}, "svg": {"Date": None}}
    with replaced(path) as part:
        figure.savefig(part, format=kind, metadata=dates.get(kind), **options)


def rasterize_large(figure):
    """On a page of vectors: a collection of many parts, a line of many points."""
    for axes in figure.axes:
        for collection in axes.collections:
            parts = max(len(collection.get_paths()), len(collection.get_offsets()),
                        sum(len(path.vertices) for path in collection.get_paths()) // 10)
            if parts > MOST_PARTS:
                collection.set_rasterized(True)
        for line in axes.lines:
            if len(line.get_xdata()) > MOST_POINTS:
                line.set_rasterized(True)


def main(name, draw):
    """Runs a script: draw(run) makes the figure, which goes into the folder as `name`, or as what is
    asked for in its place."""
    if len(sys.argv) < 2 or not set(sys.argv[2:]) <= set(FORMATS):
        sys.exit(f"usage: {sys.argv[0]} DIR [{'|'.join(FORMATS)} ...]   (the folder of a run)")
    run = Run(sys.argv[1])
    if not run.folder.is_dir():
        sys.exit(f"{run.folder}: no such folder")
    for kind in sys.argv[2:] or ["png"]:
        path = (run.folder / name).with_suffix(f".{kind}")
        try:
            save(draw(run), path)  # a layout goes on from the one before it: each begins anew
        except Nothing:
            return
        except Broken as error:
            sys.exit(str(error))
        except Refused as error:
            refuse(error)
        print(printable(path))
