"""From unsorted points to a tree: what each way spends on what, and how near the floor it is."""

import numpy as np
from _bench import legend_below, power
from _style import INK, Nothing, figure, main
from _trees import BUILDERS, PARTS, USUAL, Table, words


def draw(run):
    table = Table(run, "trees.csv")
    n = shown(table)
    rows = [row for row in table.select(n=n, n_ctrl=USUAL)]
    threads = sorted({row["threads"] for row in rows})
    sets = list(dict.fromkeys(row["set"] for row in rows))
    fig = figure(9.6, 2.0 + 0.24 * len(sets) * (len(BUILDERS) + 1.2),
                 f"{power(n)} points to a tree, $N_\\mathrm{{ctrl}} = {USUAL}$")
    panels = np.atleast_1d(fig.subplots(1, len(threads), sharey=True, sharex=True))
    limit = 1.35 * max(each(row) for row in rows if row["builder"] not in
                       ("printed", "printed_known"))
    for axes, count in zip(panels, threads):
        axes.set_title("one thread" if count == 1 else f"{count:.0f} threads")
        place, places, labels = 0.0, [], []
        for name in sets:
            place += 1.2
            axes.text(0, place - 0.85, f" {words(name)}", fontweight="bold", va="center")
            for builder in BUILDERS:
                found = [row for row in rows if row["set"] == name and
                         row["builder"] == builder and row["threads"] == count]
                if not found:
                    continue
                bar(axes, found[0], place, limit)
                places.append(place)
                labels.append(BUILDERS[builder][0])
                place += 1.0
        axes.set_yticks(places, labels, fontsize=9)
        axes.set_ylim(place, -0.2)
        axes.set_xlim(0, limit)
        axes.set_xlabel("time for each point  [ns]")
        axes.grid(axis="y", visible=False)
        axes.tick_params(axis="y", length=0)
    handles = [panels[0].barh(0, 0, color=colour) for _, colour in PARTS.values()]
    handles.append(panels[0].plot([], [], "|", color=INK, ms=10, mew=1.6)[0])
    legend_below(fig, handles, [name for name, _ in PARTS.values()] + ["28 bytes a point, at the "
                 "memory's speed"], table.where)
    return fig


def each(row):
    return 1e9 * row["ready"] / row["n"]


def shown(table):
    """The largest number up to 10^6."""
    some = [n for n in table.values("n", n_ctrl=USUAL, builder="reverse", set="uniform") if n <= 1e6]
    if not some:
        raise Nothing
    return some[-1]


def bar(axes, row, place, limit):
    left = 0.0
    for name, (_, colour) in PARTS.items():
        width = 1e9 * (row[name] if np.isfinite(row[name]) else 0.0) / row["n"]
        axes.barh(place, width, left=left, height=0.8, color=colour)
        left += width
    axes.plot(1e9 * row["floor"] / row["n"], place, "|", color=INK, ms=9, mew=1.6)
    if left > limit:
        axes.text(limit, place, f"{left:.0f} ns \u2192 ", ha="right", va="center", color="white",
                  fontweight="bold", fontsize=9)
    else:
        axes.text(left, place, f"  {left:.0f}", va="center", fontsize=9)


main("trees_phases.png", draw)
