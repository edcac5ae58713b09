"""The wakes of a sweep, methods side by side: vorticity, and the particles that carry it."""

import numpy as np
from _colours import COLOURS
from _outline import circles, outline
from _style import figure, main
from _sweep import WORDS, by_method, of_last_frame, title
from _vorticity import in_units, scale, vorticity

MOST = 3  # flows
SIZES = ("sigma", "spacing")  # how wide a particle is, of each method


def draw(run):
    flows = by_method(run)[:MOST]
    methods = list(flows[0][1])
    first = flows[0][1][methods[0]]
    box = window(first)
    tall = (box[3] - box[2]) / (box[1] - box[0])
    fig = figure(5.2 * len(methods), 0.7 + (0.25 + 4.3 * tall) * (len(flows) + 1),
                 title(first))
    grid = fig.subplots(len(flows) + 1, len(methods), sharex=True, sharey=True, squeeze=False)
    for row, (words, runs) in zip(grid, flows):
        side_by_side(fig, row, words, runs, methods)
    most = colours_end(flows[0][1])
    for axes, method in zip(grid[-1], methods):
        dots = particles(axes, *flows[0], method, box, most)
    scale_bar(fig, grid[-1], dots)
    for axes in grid.flat:
        axes.add_patch(outline(first))
        axes.set(xlim=box[:2], ylim=box[2:], aspect="equal")
        axes.grid(False)
    for axes in grid[:, 0]:
        axes.set_ylabel("$y/R$")
    for axes in grid[-1]:
        axes.set_xlabel("$x/R$")
    return fig


def last_field(run):
    radius, centre = run.body
    return in_units([run.fields()[-1]], radius, centre, run.speed)[0]


def window(run):
    field = last_field(run)
    return [field["x"][0], field["x"][-1], field["y"][0], field["y"][-1]]


def colours_end(runs):
    return scale([last_field(run) for run in runs.values()])


def side_by_side(fig, row, words, runs, methods):
    most = colours_end(runs)
    for axes, method in zip(row, methods):
        run = runs[method]
        field = last_field(run)
        picture = vorticity(axes, field, circles(run),
                            {"cmap": COLOURS, "vmin": -most, "vmax": most})
        axes.set_title(f"{WORDS.get(method, method)},  {words},  $T = {field['time']:.3g}$")
    scale_bar(fig, row, picture)


def scale_bar(fig, row, picture):
    bar = fig.colorbar(picture, ax=list(row), shrink=0.8, aspect=16, pad=0.012, extend="both")
    bar.set_label("$\\omega R/U$")
    bar.outline.set_linewidth(0.5)


def particles(axes, words, runs, method, box, most):
    """Dots as wide as their cores or spacings, in the colours of the vorticity there."""
    run = runs[method]
    x, y, size = last_frame(run)
    field = last_field(run)
    shown = (x > box[0]) & (x < box[1]) & (y > box[2]) & (y < box[3])
    omega = field["omega"][np.searchsorted(field["y"], y[shown]),
                           np.searchsorted(field["x"], x[shown])]
    points = 72 * 4.2 / (box[1] - box[0])
    dots = axes.scatter(x[shown], y[shown], s=np.maximum(0.7 * points * size[shown], 0.7) ** 2,
                        c=omega, cmap=COLOURS, vmin=-most, vmax=most, lw=0.2,
                        edgecolors="#777777", rasterized=True)
    axes.set_title(f"{words}: {x.size:,} {run.particle}s, {np.count_nonzero(shown):,} of them here")
    return dots


def last_frame(run):
    """Places and sizes of the particles, in the body's units."""
    radius, centre = run.body
    x, y, width = of_last_frame(run, lambda frame: [frame[name][()] for name in (
        "x", "y", next(size for size in SIZES if size in frame))])
    return (x - centre[0]) / radius, (y - centre[1]) / radius, width / radius


main("sweep_wakes.png", draw)
