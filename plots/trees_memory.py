"""The paper's claim about storage: bytes for each particle, while a tree is made and when it is."""

import numpy as np
from _bench import legend_below
from _style import Nothing, figure, main
from _trees import BUILDERS, SETS, USUAL, Table, words


def draw(run):
    table = Table(run, "trees.csv")
    rows = [row for row in table.select(threads=1, n_ctrl=USUAL) if np.isfinite(row["peak"])]
    numbers = sorted({row["n"] for row in rows if row["n"] >= 1e5})
    if not numbers:
        raise Nothing
    fig = figure(9.2, 3.9, f"Storage: most on the way to a tree (lines), and what stays (dashed), $N_\\mathrm{{ctrl}} = {USUAL}$")
    panels = fig.subplots(1, len(SETS), sharey=True)
    for axes, name in zip(panels, SETS):
        axes.set_title(words(name))
        axes.set(xscale="log", xlabel="particles  $n$")
        kept = None
        for builder, (label, colour, marker) in BUILDERS.items():
            if builder in ("climb", "printed_known"):
                continue
            own = [row for row in table.line(set=name, builder=builder, threads=1, n_ctrl=USUAL)
                   if row["n"] in numbers]
            n = np.array([row["n"] for row in own])
            axes.plot(n, [row["peak"] / row["n"] for row in own], color=colour, marker=marker, ms=4,
                      label=label)
            kept = n, np.array([row["kept"] / row["n"] for row in own])
        axes.plot(*kept, color="black", ls="--", lw=1, label="the tree")
    panels[0].set_ylim(0)
    panels[0].set_ylabel("bytes for each particle")
    handles, labels = panels[0].get_legend_handles_labels()
    legend_below(fig, handles, labels, table.where)
    return fig


main("trees_memory.png", draw)
