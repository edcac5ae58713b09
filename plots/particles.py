"""SPH particles around the body: how fine they are, and their vorticity."""

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


def draw(run):
    radius, centre = run.body
    time, of = last_frame(run)
    x, y = (of["x"] - centre[0]) / radius, (of["y"] - centre[1]) / radius
    low, high = -0.6 * REACH, REACH
    shown = (x > low) & (x < high) & (np.abs(y) < 0.6 * REACH) & (of["kind"] <= WALL)
    fig = figure(11.0, 4.6, run.scene.get("title"))
    fine, omega = fig.subplots(1, 2, sharex=True, sharey=True)
    # A dot as wide as the particle's own square.
    points = 72 * 4.1 / (high - low)
    area = (0.8 * points * of["spacing"][shown] / radius) ** 2
    dots = {"s": area, "lw": 0, "rasterized": True}

    level = np.log2(of["spacing"][shown] / of["spacing"][of["kind"] == WALL].min())
    edges = np.arange(-0.5, np.ceil(level.max() + 0.5) + 0.01, 0.5)
    norm = BoundaryNorm(edges, 256)
    told = fine.scatter(x[shown], y[shown], c=level, cmap="viridis", norm=norm, **dots)
    bar(fig, fine, told, r"spacing $\log_2(s/s_0)$")

    w = of["vorticity"][shown] * radius / run.speed
    most = max(np.quantile(np.abs(w), 0.97), 1e-9)
    told = omega.scatter(x[shown], y[shown], c=w, cmap=COLOURS,
                         norm=TwoSlopeNorm(0, -most, most), **dots)
    bar(fig, omega, told, r"vorticity $\omega R/U$", extend="both")

    for axes in (fine, omega):
        axes.add_patch(outline(run))
        axes.set(xlim=(low, high), ylim=(-0.6 * REACH, 0.6 * REACH), aspect="equal",
                 xlabel="$x/R$")
        axes.grid(False)
    fine.set_ylabel("$y/R$")
    fine.set_title(f"{np.count_nonzero(of['kind'] <= WALL)} particles,  $T = "
                   f"{run.speed * time / radius:.3g}$")
    return fig


def bar(fig, axes, told, words, **more):
    made = fig.colorbar(told, ax=axes, shrink=0.8, aspect=24, pad=0.02, **more)
    made.set_label(words)
    made.outline.set_linewidth(0.5)


main("particles.png", draw)
