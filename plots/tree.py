"""The blobs of the last frame and the quadtree upon them: small cells where blobs are many."""

import numpy as np
from _outline import outline
from _style import INK, Broken, Nothing, figure, main
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.patches import Rectangle
from matplotlib.transforms import Affine2D

USUAL = 50  # blobs that a cell may hold and stay whole, where the scene leaves it to the program
CLOSER = 11  # so many times the close-up enlarges
COLOURS = LinearSegmentedColormap.from_list("vorticity", ["#0f4c94", "#4f93c8", "#c4c4c4",
                                                            "#e07a60", "#a3191f"])


def draw(run):
    time, x, y, gamma, sigma = last_frame(run)
    most = run.scene.get("velocity", {}).get("capacity", 0) or USUAL
    if x.size <= most:
        raise Nothing
    cells, held = childless(x, y, most)
    low, size = np.array([x.min(), y.min()]), np.array([np.ptp(x), np.ptp(y)])
    low, size = low - 0.03 * size.max(), size + 0.06 * size.max()
    dense = held / cells[:, 2]**2
    centre = cells[dense.argmax(), :2] + cells[dense.argmax(), 2] / 2
    near = np.full(2, size.max() / CLOSER)

    wide = min(max(size[0] / size[1], 0.5), 2)
    fig = figure(11.0, 9.6 / (1 + wide) + 1.1, run.scene.get("title"))
    whole, closer = fig.subplots(1, 2, width_ratios=[wide, 1])
    omega = gamma / sigma**2
    blobs = np.array([x, y, omega])[:, np.abs(omega).argsort()]
    most_shown = np.quantile(np.abs(omega), 0.9)
    show(whole, run, time, cells, blobs, most_shown, low, size)
    show(closer, run, time, cells, blobs, most_shown, centre - near / 2, near)
    whole.add_patch(Rectangle(centre - near / 2, *near, fill=False, ec=INK, lw=1.2, zorder=4))
    whole.set_title(f"{x.size:,} blobs at $t = {time:.4g}$: {len(cells):,} cells, "
                    f"none with more than {most}")
    closer.set_title("the densest place (framed on the left)")
    whole.set_ylabel("$y$")
    return fig


def show(axes, run, time, cells, blobs, strong, low, size):
    """Cells and blobs, these in the colours of their vorticity, the strong ones in front."""
    axes.add_collection(LineCollection(edges(cells), colors=INK, linewidths=0.4, alpha=0.7))
    x, y, omega = blobs[:, np.all(np.abs(blobs[:2].T - low - size / 2) < size / 2, axis=1)]
    axes.scatter(x, y, s=min(7, 13000 / max(x.size, 1)), c=omega, cmap=COLOURS, vmin=-strong,
                 vmax=strong, lw=0, zorder=2)
    if "body" in run.scene:
        radius, place = run.body
        body = outline(run, time)
        body.set_transform(Affine2D().scale(radius).translate(*place) + axes.transData)
        axes.add_patch(body)
    axes.set(xlim=(low[0], low[0] + size[0]), ylim=(low[1], low[1] + size[1]), xlabel="$x$",
             aspect="equal")
    axes.grid(False)


def last_frame(run):
    if run.scene.get("method", "vortex") != "vortex":
        raise Nothing
    with run.hdf5("frames.h5") as file:
        frames = [group for name, group in file.items() if name.startswith("frame_")]
        if not frames:
            raise Nothing
        try:
            last = max(frames, key=lambda group: group.attrs["step"])
            return (float(last.attrs["time"]), *(last[name][()] for name in
                                                 ("x", "y", "gamma", "sigma")))
        except (KeyError, OSError):
            raise Broken(f"{run.folder / 'frames.h5'}: its last frame is damaged") from None


def childless(x, y, most):
    """Rows of lower left corner and side of the cells that need not split, and what each holds: the
    smallest square (tree/order/points.hpp), quartered until none holds more than `most`; where points lie
    in one place, to level 31."""
    cells, waiting = [], [(x.min(), y.min(), max(np.ptp(x), np.ptp(y)) * (1 + 2**-20), 0,
                           np.arange(x.size))]
    while waiting:
        x0, y0, side, level, held = waiting.pop()
        if held.size <= most or level == 31:
            cells.append((x0, y0, side, held.size))
            continue
        half = side / 2
        right, above = x[held] >= x0 + half, y[held] >= y0 + half
        for i in (0, 1):
            for j in (0, 1):
                some = held[(right == i) & (above == j)]
                if some.size:
                    waiting.append((x0 + i * half, y0 + j * half, half, level + 1, some))
    cells = np.array(cells)
    return cells[:, :3], cells[:, 3]


def edges(cells):
    x, y, side = cells.T
    return np.stack([np.c_[x, y], np.c_[x + side, y], np.c_[x + side, y + side],
                     np.c_[x, y + side], np.c_[x, y]], axis=1)


main("tree.png", draw)
