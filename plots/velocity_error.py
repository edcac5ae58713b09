"""What accuracy costs: time for each blob against the error that was measured, by every method."""

from _bench import SETS, Bench, legend_below, look, nanoseconds, power
from _style import Nothing, figure, main, note

ROUND = (1e-3, 1e-6, 1e-9, 1e-12)  # tolerances that stand out


def draw(run):
    bench = Bench(run)
    n = thorough(bench)
    fig = figure(8.6, 7.0, f"{power(n)} vortices, one thread: time against measured error")
    panels = fig.subplots(2, 2, sharex=True, sharey=True).ravel()
    for axes, name in zip(panels, SETS):
        panel(axes, bench, name, n)
    for axes in panels[2:]:
        axes.set_xlabel("relative error of the velocity, $L_2$")
    for axes in panels[::2]:
        axes.set_ylabel("time for each vortex  [ns]")
    panels[0].set_xlim(3e-2, 1e-16)
    found = {label: handle for axes in panels
             for handle, label in zip(*axes.get_legend_handles_labels())}
    names = [look(m)[0] for m in bench.methods if look(m)[0] in found]
    legend_below(fig, [found[name] for name in names], names, bench.where)
    return fig


def thorough(bench):
    """The largest number of blobs for which many tolerances were asked."""
    numbers = [n for n in bench.values("n", threads=1)
               if len(bench.values("tolerance", threads=1, n=n)) >= 6]
    if not numbers:
        raise Nothing
    return numbers[-1]


def panel(axes, bench, name, n):
    axes.set_title(SETS[name])
    axes.set(xscale="log", yscale="log")
    for method in bench.methods:
        words, colour, marker = look(method)
        rows = sorted(bench.select(set=name, method=method, n=n, threads=1),
                      key=lambda row: row["tolerance"])
        if not rows:
            continue
        if method == "direct":
            axes.axhline(nanoseconds(rows)[0], color=colour, lw=1.2, ls=(0, (5, 3)))
        axes.plot(errors(rows), nanoseconds(rows), color=colour, marker=".", ms=4.5)
        rows = [row for row in rows if method == "direct" or row["tolerance"] in ROUND]
        axes.plot(errors(rows), nanoseconds(rows), color=colour, marker=marker, ms=6, ls="none")
        axes.plot([], [], color=colour, marker=marker, ms=6, label=words)
    if name == "uniform":
        note(axes, "large: asked for $10^{-3}, 10^{-6}, 10^{-9}, 10^{-12}$", 0.02, 0.99)


def errors(rows):
    return [row["relative_l2"] for row in rows]


main("velocity_error.png", draw)
