"""The paper's figure 15: time and memory of QCG, around a cylinder and around an airfoil."""

from _neighbors import Bench, columns, signed, slope
from _style import BLUE, Nothing, RED, figure, main, note

SETS = ((("cyl:1:100", "cyl:2:100", "cyl:3:100", "cyl:4:100", "cyl:5:100"), BLUE, "o",
         "cylinder, 1 to 5 sizes (I-M)"),
        (("foil:5:150", "foil:6:150", "foil:7:150"), RED, "s", "airfoil, 5 to 7 sizes (N, O, R)"))


def draw(run):
    bench = Bench(run)
    fig = figure(7.2, 5.0, "QCG: time (lines) and memory (dotted) of a search")
    axes = fig.subplots()
    memory = axes.twinx()
    memory.grid(False)
    memory.spines["right"].set_visible(True)
    for sets, colour, marker, words in SETS:
        rows = bench.select(method="qcg", set=sets)
        if len(rows) < 2:
            raise Nothing
        n, seconds = columns(rows, "fastest")
        axes.plot(n, 1e3 * seconds, color=colour, marker=marker, ms=5, label=words)
        memory.plot(n, 1e-6 * columns(rows, "bytes")[1], color=colour, marker=marker, ms=5, ls=":",
                    mfc="white")
    axes.set(xscale="log", yscale="log", xlabel="particles", ylabel="time  [ms]")
    memory.set(yscale="log", ylabel="memory, list included  [MB]")
    n, seconds = columns(bench.select(method="qcg", set=SETS[0][0]), "fastest")
    slope(axes, [n[0], 1.6e5], 0.6e3 * seconds[0], 1, "$O(N)$")
    axes.legend(loc="upper left")
    signed(fig, bench)
    return fig


main("neighbors_bodies.png", draw)
