"""What the flow looks like: vorticity, and the streamlines past a body."""

import numpy as np
from _outline import outline
from _streamlines import streamlines
from _style import Nothing, figure, main
from matplotlib.colors import LinearSegmentedColormap

MOST = 4  # panels
COLOURS = LinearSegmentedColormap.from_list("vorticity", [
    "#1f5fa8", "#3d87c0", "#7db6da", "#b9d9ec", "#e1eff7", "#ffffff", "#fdebe1", "#fac9b0",
    "#ef9a7c", "#d75f50", "#b3202f"])


def draw(run):
    body = "body" in run.scene
    circle = body and run.scene["body"].get("shape", "circle") == "circle"
    fields = scaled(run, body)
    clip = scale(fields, body)
    box = window(fields, body, 0.02 * clip)
    columns = min(2, len(fields))
    rows = -(-len(fields) // columns)
    height = 4.6 * (box[3] - box[2]) / (box[1] - box[0])
    fig = figure(1.0 + 5.0 * columns, 0.6 + rows * (0.45 + height), run.scene.get("title"))
    grid = fig.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes, field in zip(grid.flat, fields):
        picture = vorticity(axes, field, circle, clip)
        closed = run.stream.any() and "strouhal" not in run.check and "plunge" not in run.scene
        if circle and closed:  # closed wakes only
            streamlines(axes, field, run.stream / run.speed)
        if body:
            axes.add_patch(outline(run.scene["body"]))
        axes.set_title(f"${'T' if body else 't'} = {field['time']:.3g}$")
        axes.set(xlim=box[:2], ylim=box[2:], aspect="equal")
        axes.grid(False)
    for axes in grid.flat[len(fields):]:
        axes.set_visible(False)
    for axes in grid.flat[max(0, len(fields) - columns):len(fields)]:
        axes.set_xlabel("$x/R$" if body else "$x$")
        axes.tick_params(labelbottom=True)
    for axes in grid[:, 0]:
        axes.set_ylabel("$y/R$" if body else "$y$")
    bar = fig.colorbar(picture, ax=grid, shrink=0.8, aspect=32, pad=0.012,
                       extend="both" if body else "neither")
    bar.set_label("vorticity  $\\omega R/U$" if body else "vorticity  $\\omega$")
    bar.outline.set_linewidth(0.5)
    return fig


def scaled(run, body):
    """The fields to show; with a body from its centre, in units of its radius and the stream."""
    fields = run.fields()
    if len(fields) > MOST:
        fields = [fields[i] for i in np.linspace(0, len(fields) - 1, MOST).round().astype(int)]
    length, centre = run.body if body else (1.0, np.zeros(2))
    speed = run.speed if body else 1.0
    return [{"x": (f["x"] - centre[0]) / length, "y": (f["y"] - centre[1]) / length,
             "u": f["u"] / speed, "v": f["v"] / speed, "omega": f["omega"] * length / speed,
             "time": f["time"] * speed / length} for f in fields]


def scale(fields, body):
    """Where the colours end, in round numbers. With a body the thin layers at the wall go far
    beyond: the scale serves the wake, 0.7 of the typical peak away from the wall."""
    peaks = []
    for field in fields:
        X, Y = np.meshgrid(field["x"], field["y"])
        away = np.hypot(X, Y) > (1.25 if body else 0)
        peaks.append(np.abs(field["omega"][away]).max(initial=0))
    most = 0.7 * np.median(peaks) if body else max(peaks)
    if not 0 < most < np.inf:
        raise Nothing
    steps = np.outer(10.0**np.arange(-9, 10), [1, 1.5, 2, 3, 4, 5, 6, 8]).ravel()
    return float(steps[steps >= 0.9 * most][0])


def window(fields, body, faint):
    """Around all that is not faint, and the body: xlim, ylim."""
    x, y = fields[-1]["x"], fields[-1]["y"]
    rows, columns = np.nonzero(np.max([np.abs(f["omega"]) for f in fields], axis=0) > faint)
    left, right = x[columns.min()], x[columns.max()]
    low, high = y[rows.min()], y[rows.max()]
    pad = 0.6 if body else 0
    return [max(left - pad, x[0]), min(right + pad, x[-1]), max(low - pad, y[0]),
            min(high + pad, y[-1])]


def vorticity(axes, field, circle, clip):
    x, y, omega = field["x"], field["y"], field["omega"].copy()
    if circle:  # the values beside the wall go on inside, so that no pale seam runs along it
        X, Y = np.meshgrid(x, y)
        r = np.hypot(X, Y)
        j, i = np.nonzero((r < 1.02) & (r > 0.8))
        out = 2.06 / r[j, i] - 1
        omega[j, i] = omega[np.abs(y[:, None] - out * Y[j, i]).argmin(0),
                            np.abs(x[:, None] - out * X[j, i]).argmin(0)]
    dx, dy = x[1] - x[0], y[1] - y[0]
    return axes.imshow(omega, cmap=COLOURS, vmin=-clip, vmax=clip, origin="lower",
                       extent=(x[0] - dx / 2, x[-1] + dx / 2, y[0] - dy / 2, y[-1] + dy / 2),
                       interpolation="bicubic")


main("flow.png", draw)
