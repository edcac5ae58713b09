"""The paper's figure 12: with the linked list time explodes as sizes are added, with QCG it grows
like the number of particles."""

from _neighbors import METHODS, Bench, columns, signed, slope
from _style import Nothing, figure, main

UNIFORM = ("cyl:1:100", "cyl:1:200", "cyl:1:400")
ADAPTIVE = ("cyl:1:100", "cyl:2:100", "cyl:3:100", "cyl:4:100", "cyl:5:100")
LINES = (("linked-list", UNIFORM, "linked list, one size (A-C)", "-", ("A, D", "B", "C")),
         ("linked-list", ADAPTIVE, "linked list, 1 to 5 sizes (D-H)", "--", ("", "E", "F", "G", "H")),
         ("qcg", ADAPTIVE, "QCG, 1 to 5 sizes (I-M)", "-", tuple("IJKLM")),
         ("level-grids", ADAPTIVE, "one grid a level, 1 to 5 sizes", "-", ()),
         ("uniform-grid", ADAPTIVE, "one grid with vector tests, 1 to 5 sizes", "--", ()))


def draw(run):
    bench = Bench(run)
    if len(bench.select(method="qcg", set=ADAPTIVE)) < 3:
        raise Nothing
    fig = figure(9.4, 5.0, "Particles around a cylinder, cases of Khorasanizade & Sousa, table 1")
    panels = fig.subplots(1, 2)
    for axes, name, scale, title, unit in (
            (panels[0], "fastest", 1e3, "time for one search", "[ms]"),
            (panels[1], "bytes", 1e-6, "memory, list included", "[MB]")):
        axes.set(xscale="log", yscale="log", xlabel="particles", ylabel=f"{title}  {unit}")
        for line in LINES:
            draw_line(axes, bench, name, scale, *line)
    n, seconds = columns(bench.select(method="qcg", set=ADAPTIVE), "fastest")
    slope(panels[0], [n[0], 3e5], 0.55e3 * seconds[0], 1, "$O(N)$")
    slope(panels[0], [n[0], 3.5e4], 2e3 * seconds[0], 2, "$O(N^2)$")
    handles, labels = panels[0].get_legend_handles_labels()
    signed(fig, bench, handles, labels, 2)
    return fig


def draw_line(axes, bench, name, scale, method, sets, words, style, letters):
    _, colour, marker = METHODS[method]
    rows = bench.select(method=method, set=sets)
    n, values = columns(rows, name)
    axes.plot(n, scale * values, color=colour, marker=marker, ms=5, ls=style,
              mfc="white" if sets is UNIFORM else colour, label=words)
    letter = dict(zip(sets, letters))
    above = -13 if method == "qcg" else 5  # where no other line runs
    for row in rows:
        words = letter.get(row["set"])
        if words:
            axes.annotate(words, (row["n"], scale * row[name]), textcoords="offset points",
                          xytext=(0, above) if len(words) == 1 else (-6, -3), fontsize=8.5,
                          ha="center" if len(words) == 1 else "right", color=colour)


main("neighbors_levels.png", draw)
