"""A list of cells costs O(N), whatever was once measured: Kollasch & Santoro's experiment again."""

import numpy as np
from _style import BLUE, GREY, Nothing, figure, main, read_csv


def draw(run):
    table = read_csv(run.file("cells.csv"))
    if len(table["n"]) < 4:
        raise Nothing
    fig = figure(8.4, 4.0, "Neighbors by cells and by testing all pairs")
    for axes, dimensions in zip(fig.subplots(1, 2, sharey=True), (2, 3)):
        here = table["dimensions"] == dimensions
        n = table["n"][here]
        axes.plot(n, 1e3 * table["naive"][here], color=GREY, marker="x", label="all pairs")
        axes.plot(n, 1e3 * table["cells"][here], color=BLUE, marker="o", ms=5, label="cells")
        for name, colour in (("naive", GREY), ("cells", BLUE)):
            power = np.polyfit(np.log(n[-4:]), np.log(table[name][here][-4:]), 1)[0]
            axes.annotate(f"$N^{{{power:.2f}}}$", (n[-1], 1e3 * table[name][here][-1]),
                          xytext=(-4, -16), textcoords="offset points", color=colour, ha="right")
        axes.set(xscale="log", yscale="log", xlabel="points", title=f"{dimensions} dimensions")
    fig.axes[0].set_ylabel("time  [ms]")
    fig.axes[0].legend(loc="upper left")
    return fig


main("neighbors_cells.png", draw)
