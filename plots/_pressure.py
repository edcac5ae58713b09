"""Pressure: C_p = 2 p/U^2 around bodies, where its colours end, and how it is painted."""

import numpy as np
from _colours import COLOURS, LOWER
from _outline import within
from _style import Nothing
from _vorticity import rounded

NEAR, SEEN = 3.0, 0.98  # within so many R so much of the fluid has colours of its own
FAINT = 0.03  # of the colours' end: not worth showing


def around_bodies(field, walls):
    """Of a field in the body's units: p as C_p, and `fluid`, where no body is."""
    return {**field, "p": 2 * field["p"], "fluid": ~within(field, walls)}


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


def look(highest, clip):
    """Vortices alone only draw fluid together."""
    if highest < FAINT * clip:
        return {"cmap": LOWER, "vmin": -clip, "vmax": 0}
    return {"cmap": COLOURS, "vmin": -clip, "vmax": clip}
