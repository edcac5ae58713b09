"""Pictures of vorticity: fields in the body's units, where the colours end, how they are painted."""

import numpy as np
from _colours import COLOURS, UPPER
from _style import Nothing
from matplotlib.colors import TwoSlopeNorm


def in_units(fields, length=1.0, centre=(0.0, 0.0), speed=1.0):
    """From the body's centre, in units of its radius and the stream."""
    return [{"x": (f["x"] - centre[0]) / length, "y": (f["y"] - centre[1]) / length,
             "u": f["u"] / speed, "v": f["v"] / speed, "omega": f["omega"] * length / speed,
             "time": f["time"] * speed / length,
             **({"psi": f["psi"] / (speed * length)} if "psi" in f else {}),
             **({"p": f["p"] / speed**2} if "p" in f else {})} for f in fields]


def scale(fields, bodies_of=lambda field: [((0, 0), 1)]):
    """Where the colours end. The thin layers at the wall go far beyond: the scale serves the wake,
    0.7 of the typical peak away from bodies, told by centre and half their length."""
    peaks = []
    for field in fields:
        bodies = bodies_of(field)
        away = np.all([np.hypot(*grid(field, *body)) > 1.25 for body in bodies], axis=0)
        peaks.append(np.abs(field["omega"][away]).max(initial=0))
    most = 0.7 * np.median(peaks)
    if not 0 < most < np.inf:
        raise Nothing
    return rounded(0.9 * most)


def rounded(most):
    """The next round number."""
    steps = np.outer(10.0**np.arange(-9, 10), [1, 1.5, 2, 3, 4, 5, 6, 8]).ravel()
    return float(steps[steps >= most * (1 - 1e-9)][0])


def grid(field, centre, radius):
    """Its places as seen from there, in that unit."""
    return np.meshgrid((field["x"] - centre[0]) / radius, (field["y"] - centre[1]) / radius)


def two_signs(least, most):
    """The look of vorticity from least to most, each sign with a half of the colours of its own, and
    the largest that it tells apart."""
    if -least < 0.01 * most:  # of one sign
        return {"cmap": UPPER, "vmin": 0, "vmax": rounded(most)}, most
    low, high = rounded(max(-least, 0.01 * most)), rounded(max(most, -0.01 * least))
    return {"cmap": COLOURS, "norm": TwoSlopeNorm(0, -low, high)}, min(low, high)


def scale_bar(fig, picture, words, extend, **place):
    bar = fig.colorbar(picture, extend=extend, **place)
    bar.set_label(words)
    bar.outline.set_linewidth(0.5)
    if isinstance(picture.norm, TwoSlopeNorm):  # each sign has a half of its own
        low, high = picture.norm.vmin, picture.norm.vmax
        ticks = (low, low / 2, 0, high / 2, high)
        bar.set_ticks(ticks, labels=[f"{v:.3g}".replace("-", "\N{MINUS SIGN}") for v in ticks])


def gone_inside(field, circles):
    """Its vorticity; beside circles, told by centre and radius, the values go on inside, so that no
    pale seam runs along the wall."""
    omega = field["omega"].copy()
    for circle in circles:
        X, Y = grid(field, *circle)
        r = np.hypot(X, Y)
        j, i = np.nonzero((r < 1.02) & (r > 0.8))
        out = 2.06 / r[j, i] - 1
        omega[j, i] = omega[np.abs(Y[:, :1] - out * Y[j, i]).argmin(0),
                            np.abs(X[:1].T - out * X[j, i]).argmin(0)]
    return omega


def picture(axes, field, values, paint):
    """Of values at the places of a field."""
    x, y = field["x"], field["y"]
    dx, dy = x[1] - x[0], y[1] - y[0]
    return axes.imshow(values, origin="lower", **paint, interpolation="bicubic",
                       extent=(x[0] - dx / 2, x[-1] + dx / 2, y[0] - dy / 2, y[-1] + dy / 2))


def vorticity(axes, field, circles, paint):
    return picture(axes, field, gone_inside(field, circles), paint)
