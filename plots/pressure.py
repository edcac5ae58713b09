"""The pressure around a body beyond that far away, C_p = 2 p/U^2; in free space p itself."""

import numpy as np
from _outline import outline, walls
from _panels import name, windows
from _pressure import FAINT, around_bodies, look, rounded_end
from _streamlines import gone_on
from _style import INK, Nothing, figure, main
from _vorticity import in_units, picture, scale_bar

MOST = 4  # panels
LINES = 10  # of equal pressure to either end of the colours


def draw(run):
    body = "body" in run.scene
    fields = scaled(run, body)
    clip = rounded_end(fields, body)
    paint = look(max(field["p"].max() for field in fields), clip)
    boxes = windows(fields, "p", FAINT * clip, body)
    wide, tall = boxes[0][1] - boxes[0][0], boxes[0][3] - boxes[0][2]
    shared = boxes[0] is boxes[-1]
    columns = min(len(fields), MOST if tall > 0.8 * wide else 2)
    rows = -(-len(fields) // columns)
    each = 9.2 / max(columns, 2)
    fig = figure(1.8 + each * columns, 0.6 + rows * (0.45 + tall / wide * each),
                 run.scene.get("title") if columns > 1 else None)
    fig.get_layout_engine().set(w_pad=0.1)  # numbers at the ends of neighbors stay apart
    grid = fig.subplots(rows, columns, sharex=shared, sharey=shared, squeeze=False)
    for axes, field, box in zip(grid.flat, fields, boxes):
        told = panel(axes, field, paint, clip / LINES)
        if body:
            axes.add_patch(outline(run, field["time"] * run.body[0] / run.speed))
        axes.set_title(f"${'T' if body else 't'} = {field['time']:.3g}$")
        axes.set(xlim=box[:2], ylim=box[2:], aspect="equal")
        axes.grid(False)
    name(grid, len(fields), body)
    scale_bar(fig, told, f"pressure  ${'C_p' if body else 'p'}$, a line every {clip / LINES:.3g}",
              "both" if body else "min", ax=grid, shrink=0.8, aspect=16 * min(rows, 2), pad=0.012)
    return fig


def panel(axes, field, paint, step):
    """Colours, and lines of equal pressure but for that of 0, which far away is anywhere."""
    p = gone_on(np.where(field["fluid"], field["p"], np.nan))
    levels = step * np.r_[np.floor(p.min() / step):0, 1:np.ceil(p.max() / step) + 1]
    axes.contour(field["x"], field["y"], p, levels, colors=INK, linewidths=0.5, alpha=0.6,
                 linestyles="solid")
    return picture(axes, field, p, paint)


def scaled(run, body):
    """The fields to show, of those with a pressure; with a body from its centre, in units of its
    radius and the stream, and p as C_p. `fluid` is where the body is not."""
    all_of = run.fields()
    told = [k for k in range(len(all_of)) if "p" in all_of.told[k]]
    if not told:
        raise Nothing
    if len(told) > MOST:
        told = [told[i] for i in np.linspace(0, len(told) - 1, MOST).round().astype(int)]
    fields = [all_of[k] for k in told]
    if not body:
        return [{**field, "fluid": np.ones(field["p"].shape, bool)} for field in fields]
    length, centre = run.body
    return [around_bodies(field, walls(run, field["time"] * length / run.speed))
            for field in in_units(fields, length, centre, run.speed)]


main("pressure.png", draw)
