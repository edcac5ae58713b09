"""SPH particles, around the body or in a periodic box: how fine they are, and their vorticity."""

import numpy as np
from _colours import COLOURS
from _outline import outline
from _style import Broken, Nothing, figure, main
from matplotlib.colors import BoundaryNorm, TwoSlopeNorm

REACH = 5.0  # of the window from the body's centre, in half its length
WALL = 2  # the last kind that is no node of the outer boundary


def last_frame(run):
    with run.hdf5("frames.h5") as file:
        names = sorted(name for name in file if name.startswith("frame_"))
        if not names or "spacing" not in file[names[-1]]:
            raise Nothing
        frame = file[names[-1]]
        try:
            columns = {name: frame[name][()] for name in ("x", "y", "spacing", "kind", "vorticity")}
        except (KeyError, OSError):
            raise Broken(f"{run.folder / 'frames.h5'}: a frame is damaged") from None
        return float(frame.attrs["time"]), columns


class Window:
    """What is shown, in units of the body's radius or of the wavelength."""

    def __init__(self, run):
        self.body = "body" in run.scene
        if self.body:
            self.unit, self.origin = run.body
            self.x, self.y = (-0.6 * REACH, REACH), (-0.6 * REACH, 0.6 * REACH)
            return
        box = np.array(run.scene["sph"]["box"])
        self.unit, self.origin = run.scene["initial"]["wavelength"], box[:2]
        self.x = self.y = (0, (box[2] - box[0]) / self.unit)


def draw(run):
    time, of = last_frame(run)
    window = Window(run)
    unit, letter = window.unit, "R" if window.body else "L"
    x, y = (of["x"] - window.origin[0]) / unit, (of["y"] - window.origin[1]) / unit
    (low, high), (bottom, top) = window.x, window.y
    shown = (x > low) & (x < high) & (y > bottom) & (y < top) & (of["kind"] <= WALL)
    fig = figure(11.0, 4.6, run.scene.get("title"))
    fine, omega = fig.subplots(1, 2, sharex=True, sharey=True)
    # A dot as wide as the particle's own square.
    points = 72 * (4.1 if window.body else 3.4) / (high - low)
    area = (0.8 * points * of["spacing"][shown] / unit) ** 2
    dots = {"s": area, "lw": 0, "rasterized": True}

    finest = of["spacing"][of["kind"] == WALL] if window.body else of["spacing"]
    level = np.log2(of["spacing"][shown] / finest.min())
    edges = np.arange(-0.5, np.ceil(level.max() + 0.5) + 0.01, 0.5)
    norm = BoundaryNorm(edges, 256)
    told = fine.scatter(x[shown], y[shown], c=level, cmap="viridis", norm=norm, **dots)
    bar(fig, fine, told, r"spacing $\log_2(s/s_0)$")

    w = of["vorticity"][shown] * unit / run.speed
    most = max(np.quantile(np.abs(w), 0.97), 1e-9)
    told = omega.scatter(x[shown], y[shown], c=w, cmap=COLOURS,
                         norm=TwoSlopeNorm(0, -most, most), **dots)
    bar(fig, omega, told, rf"vorticity $\omega {letter}/U$", extend="both")

    for axes in (fine, omega):
        if window.body:
            axes.add_patch(outline(run, time))
        axes.set(xlim=window.x, ylim=window.y, aspect="equal", xlabel=f"$x/{letter}$")
        axes.grid(False)
    fine.set_ylabel(f"$y/{letter}$")
    when = "T" if window.body else "Ut/L"
    fine.set_title(f"{np.count_nonzero(of['kind'] <= WALL)} particles,  ${when} = "
                   f"{run.speed * time / unit:.3g}$")
    return fig


def bar(fig, axes, told, words, **more):
    made = fig.colorbar(told, ax=axes, shrink=0.8, aspect=24, pad=0.02, **more)
    made.set_label(words)
    made.outline.set_linewidth(0.5)


main("particles.png", draw)
