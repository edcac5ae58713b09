"""The paper's figure 3, measured: what a velocity evaluation costs with each way to its tree."""

import numpy as np
from _bench import legend_below
from _style import INK, Nothing, figure, main, note
from _trees import BUILDERS, SETS, USUAL, Table

SHOWN = ("partition", "forward", "printed", "reverse")


def draw(run):
    table = Table(run, "trees.csv")
    measured = [row for row in table.select(n_ctrl=USUAL, threads=1)
                if np.isfinite(row["velocity"]) and row["set"] in SETS]
    if len({row["n"] for row in measured}) < 2:
        raise Nothing
    fig = figure(9.6, 6.2, "Does the reverse quadtree save time?  Evaluations of the velocity to "
                           "$10^{-6}$, $N_\\mathrm{ctrl} = 50$, one thread")
    panels = fig.subplots(2, 3, sharex=True, sharey="row", height_ratios=(3, 2))
    for column, name in enumerate(SETS):
        rows = [row for row in measured if row["set"] == name]
        times(panels[0, column], rows, name)
        ratios(panels[1, column], rows)
    panels[0, 0].set_ylabel("whole evaluation  [s]")
    panels[1, 0].set_ylabel("time / time with\nforward by partition")
    handles, labels = panels[0, 0].get_legend_handles_labels()
    legend_below(fig, handles, labels, table.where)
    return fig


def curve(rows, builder):
    return sorted((row for row in rows if row["builder"] == builder), key=lambda row: row["n"])


def times(axes, rows, name):
    axes.set_title(SETS[name])
    axes.set(xscale="log", yscale="log")
    for builder in SHOWN:
        words, colour, marker = BUILDERS[builder]
        own = curve(rows, builder)
        axes.plot([row["n"] for row in own], [row["velocity"] for row in own], color=colour,
                  marker=marker, ms=4, label=words)


def ratios(axes, rows):
    base = curve(rows, "partition")
    n = np.array([row["n"] for row in base])
    axes.set(xlabel="particles  $n$", xscale="log")
    axes.axhline(1.0, color=INK, lw=0.8)
    for builder in SHOWN[1:]:
        words, colour, marker = BUILDERS[builder]
        own = curve(rows, builder)
        ratio = np.array([a["velocity"] / b["velocity"] for a, b in zip(own, base)])
        axes.plot(n, ratio, color=colour, marker=marker, ms=4)
        if builder == "reverse":
            said = crossover(n, ratio)
            note(axes, said, 0.03, 0.05)
            at = crossing(n, ratio)
            if at:
                axes.axvline(at, color=colour, lw=0.9, ls=":")
    axes.set_ylim(0.45, 1.65)


def crossing(n, ratio):
    """The number from which on the ratio keeps below one, by straight lines; None if it always or
    never does."""
    for i in reversed(range(len(n) - 1)):
        if ratio[i] >= 1 > ratio[i + 1]:
            part = (ratio[i] - 1) / (ratio[i] - ratio[i + 1])
            return float(np.exp(np.log(n[i]) + part * (np.log(n[i + 1]) - np.log(n[i]))))
    return None


def crossover(n, ratio):
    at = crossing(n, ratio)
    if at:
        return f"reverse in one pass saves\ntime from $n$ = {float(f'{at:.1g}'):,.0f} on"
    if np.all(ratio < 1):
        return "reverse in one pass\nsaves time everywhere"
    return "reverse in one pass does\nnot save time for good"


main("trees_figure3.png", draw)
