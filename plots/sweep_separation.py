"""The wake of a circle by particles finer and finer: where the flow separates, beside what is known.
The shaded sectors have all that is listed in cases/reference/separation_re*.csv."""

from pathlib import Path

import numpy as np
from _outline import is_circle
from _style import BLUE, INK, ORANGE, Nothing, Run, figure, main, read_csv
from _sweep import folder_of, keys_of, number, of_last_frame, read
from matplotlib.patches import Circle, Wedge

MOST = 4  # panels
BOX = (-1.2, 3.3, -1.3, 1.3)  # in radii from the centre
APART = 0.105  # arrows, at least


def draw(run):
    runs = finer_and_finer(run)
    known = literature(runs[0])
    columns = min(len(runs), 2)
    rows = -(-len(runs) // columns)
    T = runs[0].report["T"][-1]
    fig = figure(10.6, 0.6 + 3.35 * rows, f"{runs[0].scene.get('title', '')},  $T = {T:.3g}$")
    grid = fig.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes in grid.flat[len(runs):]:
        axes.set_visible(False)
    for axes, one in zip(grid.flat, runs):
        wake(axes, one)
        sectors(axes, known, separation(one))
        axes.set(xlim=BOX[:2], ylim=BOX[2:], aspect="equal")
        axes.set_title(words(one), fontsize=11)
        axes.grid(False)
    for axes in grid[-1]:
        axes.set_xlabel("$x/R$")
    for axes in grid[:, 0]:
        axes.set_ylabel("$y/R$")
    told = {word: handle for axes in grid.flat
            for handle, word in zip(*axes.get_legend_handles_labels())}
    grid[0, 0].legend(told.values(), told.keys(), loc="upper right", fontsize=8.5, frameon=True, framealpha=1,
                      edgecolor="none", ncols=2, columnspacing=1.2, handlelength=1.6)
    return fig


def finer_and_finer(run):
    """Runs of a sweep that differ in how fine they are alone."""
    _, rows = read(run.file("sweep.csv"))
    keys = keys_of(rows)
    if keys not in (["sph.spacing"], ["accuracy"]) or len(rows) < 2:
        raise Nothing
    done = [row for row in rows if number(row["steps"]) > 0]
    runs = [Run(run.folder / folder_of(row, keys)) for row in done]
    runs = [one for one in runs if one.particle == "particle" and is_circle(one) and one.stream.any()
            and "strouhal" not in one.check and not {"plunge", "motion"} & set(one.scene)]
    if len(runs) < 2:
        raise Nothing
    runs.sort(key=lambda one: -one.scene["sph"]["spacing"])
    return runs[-MOST:]


def literature(run):
    """All angles that are listed for this Reynolds number [degrees]."""
    reynolds = f"{run.scene['flow'].get('reynolds', 0)!r}".removesuffix(".0")
    path = (Path(__file__).resolve().parent.parent / "cases" / "reference"
            / f"separation_re{reynolds}.csv")
    if not path.exists():
        raise Nothing
    return read_csv(path)["sep_deg"]


def separation(run):
    """The angle at the end, the mean of the last tenth of the steps."""
    angles = run.report["separation_deg"]
    return float(angles[-max(1, angles.size // 10):].mean())


def words(run):
    size = 2 * run.body[0] / run.scene["sph"]["spacing"]
    count = f"{int(run.report['particles'][-1]):,}".replace(",", " ")
    angle = separation(run)
    told = rf"$\theta_s = {angle:.1f}\degree$" if angle > 0 else "not separated"
    return rf"$D/{size:.3g}$:  {told},  {count} particles"


def wake(axes, run):
    """Arrows at particles, as many as can be told apart."""
    x, y, u, v = last_frame(run)
    inside = (x > BOX[0]) & (x < BOX[1]) & (y > BOX[2]) & (y < BOX[3])
    # One of each cell of a lattice, the one nearest to its middle.
    column, row = np.floor(x / APART).astype(int), np.floor(y / APART).astype(int)
    off = (x / APART - column - 0.5) ** 2 + (y / APART - row - 0.5) ** 2
    order = np.flatnonzero(inside)[np.argsort(off[inside], kind="stable")]
    _, first = np.unique(np.c_[column, row][order], axis=0, return_index=True)
    at = order[first]
    back = u[at] < 0
    for some, colour, label in ((at[~back], BLUE, "velocity at particles"),
                                (at[back], ORANGE, "... upstream")):
        # Slow fluid would show as dots: lengths go as the fourth root of the speed.
        speed = np.maximum(np.hypot(u[some], v[some]), 1e-12)
        scale = 0.12 * speed ** 0.25 / speed
        axes.quiver(x[some], y[some], scale * u[some], scale * v[some], color=colour, units="xy",
                    scale=1, angles="xy", width=0.011, headwidth=4, headlength=4.5,
                    headaxislength=4, minlength=0, label=label)


def last_frame(run):
    radius, centre = run.body
    x, y, u, v = of_last_frame(run, lambda frame: [frame[name][()][frame["kind"][()] <= 1]
                                                   for name in ("x", "y", "u", "v")])
    return (x - centre[0]) / radius, (y - centre[1]) / radius, u / run.speed, v / run.speed


def sectors(axes, known, angle):
    axes.add_patch(Circle((0, 0), 1, facecolor="#f2f2f2", edgecolor=INK, lw=0.9, zorder=3))
    low, high = known.min(), known.max()
    for side in ((low, high), (-high, -low)):
        axes.add_patch(Wedge((0, 0), 1, *side, facecolor="#9a9a9a", lw=0, zorder=4))
    told = rf"literature, {low:.3g} to {high:.3g}$\degree$"
    axes.fill_between([], [], [], facecolor="#9a9a9a", label=told)
    if angle > 0:
        for side in (1, -1):
            turn = np.radians(side * angle)
            axes.plot([0, np.cos(turn)], [0, np.sin(turn)], color="#d55e00", lw=1.6, zorder=5,
                      label="here" if side == 1 else None)


main("sweep_separation.png", draw)
