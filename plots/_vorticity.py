"""Pictures of vorticity: fields in the body's units, where the colours end, how they are painted."""

import numpy as np
from _style import Nothing


def in_units(fields, length=1.0, centre=(0.0, 0.0), speed=1.0):
    """From the body's centre, in units of its radius and the stream."""
    return [{"x": (f["x"] - centre[0]) / length, "y": (f["y"] - centre[1]) / length,
             "u": f["u"] / speed, "v": f["v"] / speed, "omega": f["omega"] * length / speed,
             "time": f["time"] * speed / length,
             **({"psi": f["psi"] / (speed * length)} if "psi" in f else {}),
             **({"p": f["p"] / speed**2} if "p" in f else {})} for f in fields]


def scale(fields):
    """Where the colours end. The thin layers at the wall go far beyond: the scale serves the wake,
    0.7 of the typical peak away from the wall."""
    peaks = []
    for field in fields:
        X, Y = np.meshgrid(field["x"], field["y"])
        peaks.append(np.abs(field["omega"][np.hypot(X, Y) > 1.25]).max(initial=0))
    most = 0.7 * np.median(peaks)
    if not 0 < most < np.inf:
        raise Nothing
    return rounded(0.9 * most)


def rounded(most):
    """The next round number."""
    steps = np.outer(10.0**np.arange(-9, 10), [1, 1.5, 2, 3, 4, 5, 6, 8]).ravel()
    return float(steps[steps >= most * (1 - 1e-9)][0])


def vorticity(axes, field, circle, paint):
    x, y, omega = field["x"], field["y"], field["omega"].copy()
    if circle:  # the values beside the wall go on inside, so that no pale seam runs along it
        X, Y = np.meshgrid(x, y)
        r = np.hypot(X, Y)
        j, i = np.nonzero((r < 1.02) & (r > 0.8))
        out = 2.06 / r[j, i] - 1
        omega[j, i] = omega[np.abs(y[:, None] - out * Y[j, i]).argmin(0),
                            np.abs(x[:, None] - out * X[j, i]).argmin(0)]
    dx, dy = x[1] - x[0], y[1] - y[0]
    return axes.imshow(omega, origin="lower", **paint,
                       extent=(x[0] - dx / 2, x[-1] + dx / 2, y[0] - dy / 2, y[-1] + dy / 2),
                       interpolation="bicubic")
