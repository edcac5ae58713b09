"""How far drag and lift are off the references: by the accuracy that was asked for, by seconds."""

import csv

import matplotlib
import numpy as np
from _style import GREY, INK, ORANGE, RED, Broken, figure, main
from matplotlib.ticker import FuncFormatter, NullFormatter, NullLocator

SIDES = ("drag", "lift")
MARKS = {"circle": "o", "ellipse": "s", "plunging": "D", "gaussian": "^"}
LOOKS = {"circle": None, "ellipse": RED, "plunging": ORANGE, "gaussian": GREY}
WORDS = {"ellipse_re400": "ellipse at 20 degrees, Re = 400", "gaussian_ellipse":
         "vortex in free space (quadrupole)", "plunging_cylinder": "circle that plunges, Re = 200"}
ROWS = (("largest", "accuracy", "largest deviation"), ("rms", "accuracy", "root mean square"),
        ("rms", "processor_seconds", "root mean square"))


def draw(run):
    cases = read(run.file("accuracy.csv"))
    fig = figure(8.6, 9.6)
    *grid, bottom = fig.subplots(len(ROWS) + 1, 2, height_ratios=[4] * len(ROWS) + [1])
    share(grid)
    for (error, across, label), pair in zip(ROWS, grid):
        for axes, side in zip(pair, SIDES):
            for case, lines in cases.items():
                curve(axes, case, [line for line in lines if line["quantity"] in (
                    side, "quadrupole" if side == "drag" else "")], across, error)
            finish(axes, across)
        pair[0].set_ylabel(f"{label}, T from 0.2 on")
    grid[0][0].set_title("drag, relative to that at the time")
    grid[0][1].set_title("lift, relative to its largest\n(circle at rest: to the drag)")
    for axes in bottom:
        axes.axis("off")
    fig.legend(*grid[0][0].get_legend_handles_labels(), loc="lower center", ncol=4, fontsize=9)
    return fig


def share(grid):
    """One scale of errors for all, one of accuracies or seconds for a row."""
    for left, right in grid:
        right.sharex(left)
        for axes in (left, right):
            if axes is not grid[0][0]:
                axes.sharey(grid[0][0])
        right.tick_params(labelleft=False)


def read(path):
    """Lines that count from T = 0.2 on, or from the start in free space, of each case."""
    try:
        with path.open() as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        cases = {row["case"]: [] for row in rows}
        for row in rows:
            if float(row["from"]) in (0, 0.2):
                cases[row["case"]].append(row)
    except (OSError, UnicodeDecodeError, KeyError, ValueError):
        raise Broken(f"{path}: no table of accuracies") from None
    return cases


def curve(axes, case, lines, across, error):
    """A vortex in free space has its largest deviation alone."""
    if not lines or not lines[0][error]:
        return
    colour, marker = LOOKS[case.partition("_")[0]], MARKS[case.partition("_")[0]]
    reynolds = case.partition("_re")[2]
    at = [float(line[across]) for line in lines]
    off = [float(line[error]) for line in lines]
    axes.plot(at, off, color=colour or circle(reynolds), marker=marker, ms=5, lw=1.3,
              label=WORDS.get(case, f"circle, Re = {reynolds}"))


def circle(reynolds):
    """From dark to bright by the Reynolds number, which goes up by a factor of three or so."""
    known = (1, 40, 200, 550, 1000, 3000, 9500)
    return matplotlib.colormaps["viridis"](0.95 * np.interp(float(reynolds), known,
                                                            np.linspace(0, 1, len(known))))


def finish(axes, across):
    axes.set(xscale="log", yscale="log")
    axes.yaxis.set_major_formatter(FuncFormatter(lambda y, _: f"{100 * y:g} %"))
    axes.grid(which="minor", lw=0.3)
    if across == "accuracy":
        ticks = [0.0025, 0.005, 0.01, 0.02, 0.04]
        axes.set_xticks(ticks, labels=[f"{100 * tick:g} %" for tick in ticks])
        axes.xaxis.set_minor_locator(NullLocator())
        axes.plot([0.0022, 0.045], [0.0022, 0.045], color=INK, lw=0.9, ls=(0, (5, 3)),
                  label="error = accuracy", zorder=1)
        axes.set_xlabel("accuracy asked for")
    else:
        axes.xaxis.set_major_formatter(FuncFormatter(lambda s, _: f"{s:g}"))
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.set_xlabel("seconds of one processor")


main("accuracy.png", draw)
