"""What the flow looks like: vorticity, and the streamlines past a body."""

import numpy as np
from _colours import COLOURS
from _outline import circles, discs, outline, walls
from _panels import name, windows
from _streamlines import integrated_streamlines, streamlines
from _style import Nothing, figure, main
from _vorticity import in_units, scale, scale_bar, two_signs, vorticity

MOST = 4  # panels


def draw(run):
    body = "body" in run.scene
    fields = scaled(run, body)
    unit = run.body[0] / run.speed if body else 1.0
    bodies_of = (lambda field: discs(run, unit * field["time"])) if body else None
    paint, most = colours(fields, bodies_of)
    boxes = windows(fields, "omega", 0.02 * most, body)
    tall = (boxes[0][3] - boxes[0][2]) / (boxes[0][1] - boxes[0][0])
    shared = boxes[0] is boxes[-1]
    columns = min(len(fields), MOST if tall > 0.8 else 2)
    rows = -(-len(fields) // columns)
    fig = figure(11.0 if columns > 1 else 6.5, 0.6 + rows * (0.45 + tall * 9.2 / max(columns, 2)),
                 run.scene.get("title"))
    grid = fig.subplots(rows, columns, sharex=shared, sharey=shared, squeeze=False)
    for axes, field, box in zip(grid.flat, fields, boxes):
        time = unit * field["time"]
        round_ones = circles(run, time) if body else []
        picture = vorticity(axes, field, round_ones, paint)
        even = not {"plunge", "initial"} & set(run.scene)  # on both sides of the stream
        even = even and not any("motion" in one for one in run.bodies)
        closed = run.stream.any() and not run.sheds and even
        if body and closed and "psi" in field:  # closed wakes only
            streamlines(axes, field, walls(run, time))
        elif len(round_ones) == 1 and closed:
            integrated_streamlines(axes, field, run.stream / run.speed)
        if body:
            axes.add_patch(outline(run, time))
        axes.set_title(f"${'T' if body else 't'} = {field['time']:.3g}$"
                       + (f",  largest {field['peak']:.3g}" if "peak" in field else ""))
        axes.set(xlim=box[:2], ylim=box[2:], aspect="equal")
        axes.grid(False)
    name(grid, len(fields), body)
    scale_bar(fig, picture, "vorticity  $\\omega R/U$" if body else "vorticity  $\\omega$"
              if "peak" not in fields[0] else "vorticity, of the largest then",
              "both" if body else "neither", ax=grid, shrink=0.8, aspect=16 * min(len(grid), 2),
              pad=0.012)
    return fig


def scaled(run, body):
    """The fields to show; with a body from its centre, in units of its radius and the stream."""
    fields = run.fields()
    if len(fields) > MOST:
        fields = [fields[i] for i in np.linspace(0, len(fields) - 1, MOST).round().astype(int)]
    length, centre = run.body if body else (1.0, np.zeros(2))
    speed = run.speed if body else 1.0
    return in_units(fields, length, centre, speed)


def colours(fields, bodies_of):
    """The look of the pictures, and the largest vorticity that it tells apart."""
    if bodies_of:
        clip = scale(fields, bodies_of)
        return {"cmap": COLOURS, "vmin": -clip, "vmax": clip}, clip
    for field in relative(fields):
        if not 0 < np.abs(field["omega"]).max(initial=0) < np.inf:
            raise Nothing
    least = min(field["omega"].min() for field in fields)
    most = max(field["omega"].max() for field in fields)
    return two_signs(least, most)


def relative(fields):
    """In free space vorticity may fade so far that one scale serves the first picture only: then
    each is shown relative to its own peak."""
    peaks = [np.abs(field["omega"]).max(initial=0) for field in fields]
    if max(peaks) > 2 * min(peaks) > 0:
        for field, peak in zip(fields, peaks):
            field.update(omega=field["omega"] / peak, peak=peak)
    return fields


main("flow.png", draw)
