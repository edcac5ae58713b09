"""The pressure around a body beyond that far away, C_p = 2 p/U^2; in free space p itself."""

import numpy as np
from _colours import COLOURS, LOWER
from _outline import outline, walls
from _panels import name, windows
from _streamlines import gone_on
from _style import INK, Nothing, figure, main
from _vorticity import in_units, rounded
from matplotlib.path import Path

MOST = 4  # panels
LINES = 10  # of equal pressure to either end of the colours
NEAR, SEEN = 3.0, 0.98  # within so many R so much of the fluid has colours of its own
FAINT = 0.03  # of the colours' end: not worth showing


def draw(run):
    body = "body" in run.scene
    fields = scaled(run, body)
    clip = rounded_end(fields, body)
    boxes = windows(fields, "p", FAINT * clip, body)
    wide, tall = boxes[0][1] - boxes[0][0], boxes[0][3] - boxes[0][2]
    shared = boxes[0] is boxes[-1]
    columns = min(len(fields), MOST if tall > 0.8 * wide else 2)
    rows = -(-len(fields) // columns)
    each = 9.2 / max(columns, 2)
    fig = figure(1.8 + each * columns, 0.6 + rows * (0.45 + tall / wide * each),
                 run.scene.get("title") if columns > 1 else None)
    grid = fig.subplots(rows, columns, sharex=shared, sharey=shared, squeeze=False)
    for axes, field, box in zip(grid.flat, fields, boxes):
        picture = panel(axes, field, look(fields, clip), clip / LINES)
        if body:
            axes.add_patch(field["outline"])
        axes.set_title(f"${'T' if body else 't'} = {field['time']:.3g}$")
        axes.set(xlim=box[:2], ylim=box[2:], aspect="equal")
        axes.grid(False)
    name(grid, len(fields), body)
    bar = fig.colorbar(picture, ax=grid, shrink=0.8, aspect=16 * min(rows, 2), pad=0.012,
                       extend="both" if body else "min")
    bar.set_label(f"pressure  ${'C_p' if body else 'p'}$, a line every {clip / LINES:.3g}")
    bar.outline.set_linewidth(0.5)
    return fig


def rounded_end(fields, body):
    """Where the colours end; suction at a sharp edge goes far beyond."""
    ends = []
    for field in fields:
        size, seen = np.abs(field["p"]), field["fluid"]
        if body:
            seen = seen & (np.hypot(*np.meshgrid(field["x"], field["y"])) < NEAR)
        if seen.any():
            ends.append(np.quantile(size[seen], SEEN) if body else size.max())
    if not 0 < max(ends, default=0) < np.inf:
        raise Nothing
    return rounded(max(ends))


def look(fields, clip):
    """Vortices alone only draw fluid together."""
    if max(field["p"].max() for field in fields) < FAINT * clip:
        return {"cmap": LOWER, "vmin": -clip, "vmax": 0}
    return {"cmap": COLOURS, "vmin": -clip, "vmax": clip}


def panel(axes, field, paint, step):
    """Colours, and lines of equal pressure but for that of 0, which far away is anywhere."""
    x, y, p = field["x"], field["y"], gone_on(np.where(field["fluid"], field["p"], np.nan))
    dx, dy = x[1] - x[0], y[1] - y[0]
    levels = step * np.r_[np.floor(p.min() / step):0, 1:np.ceil(p.max() / step) + 1]
    axes.contour(x, y, p, levels, colors=INK, linewidths=0.5, alpha=0.6, linestyles="solid")
    return axes.imshow(p, origin="lower", **paint, interpolation="bicubic",
                       extent=(x[0] - dx / 2, x[-1] + dx / 2, y[0] - dy / 2, y[-1] + dy / 2))


def scaled(run, body):
    """The fields to show, of those with a pressure; with a body from its centre, in units of its
    radius and the stream, and p as C_p. `fluid` is where the body is not."""
    fields = [field for field in run.fields() if "p" in field]
    if not fields:
        raise Nothing
    if len(fields) > MOST:
        fields = [fields[i] for i in np.linspace(0, len(fields) - 1, MOST).round().astype(int)]
    if not body:
        return [{**field, "fluid": np.ones(field["p"].shape, bool)} for field in fields]
    length, centre = run.body
    return [with_body(run, field, length / run.speed)
            for field in in_units(fields, length, centre, run.speed)]


def with_body(run, field, unit):
    time = field["time"] * unit
    X, Y = np.meshgrid(field["x"], field["y"])
    within = np.any([Path(wall).contains_points(np.c_[X.ravel(), Y.ravel()])
                     for wall in walls(run, time)], axis=0).reshape(X.shape)
    return {**field, "p": 2 * field["p"], "outline": outline(run, time), "fluid": ~within}


main("pressure.png", draw)
