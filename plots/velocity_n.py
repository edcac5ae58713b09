"""Time for each vortex stays nearly the same however many there are; where the direct sum loses."""

import numpy as np
from _bench import SETS, Bench, legend_below, look, nanoseconds
from _style import Nothing, figure, main, note

TOLERANCE = 1e-6


def draw(run):
    bench = Bench(run)
    threads = [int(t) for t in bench.values("threads")]
    if len(bench.values("n")) < 2:
        raise Nothing
    fig = figure(8.6, 7.2, "Tolerance $10^{-6}$: time against number")
    panels = fig.subplots(2, 2, sharex=True, sharey=True).ravel()
    fastest = min(nanoseconds(bench.select(method=method)).min() for method in bench.methods)
    panels[0].set_ylim(fastest / 2.5, 4e4)
    for axes, name in zip(panels, SETS):
        panel(axes, bench, name, threads)
    for axes in panels[2:]:
        axes.set_xlabel("vortices  $n$")
    for axes in panels[::2]:
        axes.set_ylabel("time for each vortex  [ns]")
    note(panels[0], "dotted: from here on faster\nthan the direct sum", 0.02, 0.99)
    handles, labels = panels[-1].get_legend_handles_labels()
    legend_below(fig, handles, labels, bench.where)
    return fig


def panel(axes, bench, name, threads):
    axes.set_title(SETS[name])
    axes.set(xscale="log", yscale="log")
    direct = line(bench, name, "direct", 1)
    crossings = []
    for method in bench.methods:
        words, colour, marker = look(method)
        for count in threads:
            rows = line(bench, name, method, count)
            if not rows:
                continue
            several = count > 1
            axes.plot([row["n"] for row in rows], nanoseconds(rows), marker=marker, ms=4,
                      color=colour, ls="--" if several else "-", lw=1.0 if several else 1.5,
                      mfc="white" if several else colour, mew=0.9,
                      label=f"{words}, {count} threads" if several else words)
        if method != "direct":
            at = crossing(line(bench, name, method, 1), direct)
            if at:
                crossings.append((at, colour))
    for step, (at, colour) in enumerate(crossings):  # labels one above the other
        axes.axvline(at[0], color=colour, lw=0.8, ls=":")
        axes.text(at[0], 1.15 * 1.7**step * axes.get_ylim()[0], f" {float(f'{at[0]:.2g}'):,.0f}", color=colour,
                  fontsize=9.5, va="bottom")


def line(bench, name, method, threads):
    tolerance = float("nan") if method == "direct" else TOLERANCE
    return sorted(bench.select(set=name, method=method, threads=threads, tolerance=tolerance),
                  key=lambda row: row["n"])


def crossing(rows, direct):
    """(n, time) from which on the method wins, by straight lines between measurements."""
    common = sorted({row["n"] for row in rows} & {row["n"] for row in direct})
    pick = lambda which: np.log(nanoseconds([row for row in which if row["n"] in common]))
    gain, own = pick(direct) - pick(rows), pick(rows)
    for i in reversed(range(len(common) - 1)):
        if gain[i] <= 0 < gain[i + 1]:
            part = gain[i] / (gain[i] - gain[i + 1])
            mean = lambda a: np.exp(a[i] + part * (a[i + 1] - a[i]))
            return mean(np.log(common)), mean(own)
    return None


main("velocity_n.png", draw)
