"""QCG costs the same for each particle however many there are, and however many sizes."""

import numpy as np
from _neighbors import METHODS, Bench, columns, signed
from _style import Nothing, figure, main, note

PANELS = {"scaled": "five sizes around a cylinder", "uniform": "one size"}


def draw(run):
    bench = Bench(run)
    if len({row["n"] for row in bench.select(family=("scaled", "uniform"))}) < 2:
        raise Nothing
    fig = figure(9.2, 4.9, "From unsorted particles to finished lists, one thread, fastest of several runs")
    panels = fig.subplots(1, 2, sharey=True)
    for axes, (family, words) in zip(panels, PANELS.items()):
        panel(axes, bench, family, words)
    panels[0].set_ylabel("time for each particle  [ns]")
    handles, labels = panels[0].get_legend_handles_labels()
    signed(fig, bench, handles, labels, 3)
    return fig


def panel(axes, bench, family, words):
    axes.set_title(words)
    axes.set(xscale="log", yscale="log", xlabel="particles")
    for method, (name, colour, marker) in METHODS.items():
        n, seconds = columns(bench.select(family=family, method=method), "fastest")
        axes.plot(n, 1e9 * seconds / n, color=colour, marker=marker, ms=5, label=name)
        if method in ("qcg", "linked-list"):  # labels of the others would lie on these
            power(axes, n, seconds, colour, 5)
    for listing, order, style, name in (("both", "sorted", "--", "QCG, sorted input"),
                                        ("once", "sorted", ":", "QCG, sorted, each pair once")):
        n, seconds = columns(bench.select(family=family, method="qcg", listing=listing,
                                          order=order), "fastest")
        axes.plot(n, 1e9 * seconds / n, color=METHODS["qcg"][1], ls=style, label=name)
        if listing == "both":
            power(axes, n, seconds, METHODS["qcg"][1], -14)
    if family == "scaled":
        note(axes, "some 50 neighbors each", 0.02, 0.02)


def power(axes, n, seconds, colour, above):
    """The exponent of time in n, from ten thousand particles on, at the end of a line."""
    large = n > 9900
    if large.sum() < 3:
        return
    exponent = np.polyfit(np.log(n[large]), np.log(seconds[large]), 1)[0]
    axes.annotate(f"$N^{{{exponent:.2f}}}$", (n[-1], 1e9 * seconds[-1] / n[-1]), xytext=(0, above),
                  textcoords="offset points", ha="center", fontsize=9, color=colour)


main("neighbors_scaled.png", draw)
