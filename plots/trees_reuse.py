"""Whether the order of the step before is worth keeping: repairing it against sorting anew."""

import numpy as np
from _bench import legend_below
from _style import BLUE, GREEN, INK, ORANGE, figure, main, note
from _trees import Table, words


def draw(run):
    table = Table(run, "trees_reuse.csv")
    sets = list(dict.fromkeys(row["set"] for row in table.rows))
    threads = table.values("threads")
    fig = figure(2.6 * len(sets) + 1.0, 3.8, "Repairing the order of the step before, against "
                                             "sorting anew: one thread, and several (dashed)")
    panels = np.atleast_1d(fig.subplots(1, len(sets), sharey=True))
    for axes, name in zip(panels, sets):
        axes.set_title(words(name))
        axes.set_xlabel("step  [mean spacings]")
        axes.axhline(1.0, color=INK, lw=0.8)
        axes.axhline(0.6, color=GREEN, lw=0.8, ls=":")
        for stored, colour in (("in_order", BLUE), ("random", ORANGE)):
            for count in threads:
                own = sorted(table.select(set=name, stored=stored, threads=count),
                             key=lambda row: row["step"])
                several = count > 1
                axes.plot(range(len(own)), [row["repaired"] / row["scratch"] for row in own],
                          marker="o", ms=4, color=colour, ls="--" if several else "-",
                          mfc="white" if several else colour,
                          label=f"stored {stored.replace('_', ' ')}, "
                                f"{count:.0f} thread{'s' if several else ''}")
                axes.set_xticks(range(len(own)), [f"{row['step']:g}" for row in own])
    panels[0].set_ylim(0)
    note(panels[0], "dotted: 60 %", 0.98, 0.03)
    panels[0].set_ylabel("time repaired / time anew")
    handles, labels = panels[0].get_legend_handles_labels()
    legend_below(fig, handles, labels, table.where)
    return fig


main("trees_reuse.png", draw)
