"""Streamlines past a body, which show the closed wake behind it."""

import numpy as np
from _style import INK

OUTSIDE, INSIDE = 0.2, 0.08  # of the closed wake: a line every so many U R


def streamlines(axes, field, along):
    """Lines of equal stream function, psi = integral of u dy - v dx, zero on the body.

    field: grids in units of the body's radius, from its centre, and of the stream's speed, the
    velocity zero inside the body; along: direction of the stream.
    """
    x, y, u, v = (field[name] for name in ("x", "y", "u", "v"))
    bottom = np.cumsum(np.r_[0, -(v[0, 1:] + v[0, :-1]) / 2 * np.diff(x)])
    rise = np.cumsum((u[1:] + u[:-1]) / 2 * np.diff(y)[:, None], axis=0)
    psi = bottom + np.vstack([np.zeros_like(bottom), rise])
    X, Y = np.meshgrid(x, y)
    r, downstream = np.hypot(X, Y), along[0] * X + along[1] * Y
    psi -= psi[r < 0.5].mean()
    forward = psi * np.sign(along[0] * Y - along[1] * X)  # negative in the closed wake
    closed = (forward < 0) & (downstream > 0)

    pen = {"colors": INK, "linestyles": "solid", "alpha": 0.85}
    for step, hidden in ((OUTSIDE, closed | (r < 1)), (INSIDE, ~closed | (r < 1))):
        most = np.abs(psi[~hidden]).max(initial=0)
        levels = np.arange(step / 2, most, step)
        if levels.size:
            axes.contour(x, y, np.ma.array(psi, mask=hidden), np.r_[-levels[::-1], levels],
                         linewidths=0.6, **pen)

    # The dividing lines: psi = 0 up to the body and away from the wake, and the edge of the wake,
    # taken a hair inside since the sign of psi on the wall and on the axis is noise.
    hair = np.clip(0.03 * -forward[closed].min(initial=0), 1e-4, 5e-4)
    wake = (forward < -hair) & (downstream > 0)
    end = downstream[wake].max(initial=1)
    outer = np.ma.array(psi, mask=(r < 1) | ((downstream > 0) & (downstream < end - 0.01)))
    axes.contour(x, y, outer, [0], linewidths=1.0, **pen)
    if wake.any():
        axes.contour(x, y, np.where(downstream > 0, forward, 0), [-hair], linewidths=1.0, **pen)
