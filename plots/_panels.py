"""Rows and columns of pictures of a flow: what each shows, and what stands beside it."""

import numpy as np


def name(grid, pictures, body):
    columns = grid.shape[1]
    for axes in grid.flat[pictures:]:
        axes.set_visible(False)
    for axes in grid.flat[max(0, pictures - columns):pictures]:
        axes.set_xlabel("$x/R$" if body else "$x$")
        axes.tick_params(labelbottom=True)
    for axes in grid[:, 0]:
        axes.set_ylabel("$y/R$" if body else "$y$")


def windows(fields, value, faint, body):
    """What each picture shows, as xlim and ylim in a row: all where the value is ever not faint, and
    the body. Vortices that travel far are followed: then each has a window about its own middle."""
    whole = window(fields, value, faint, body)
    own = [window([field], value, faint, body) for field in fields]
    size = np.max([np.subtract(box[1::2], box[::2]) for box in own], axis=0)
    if body or np.all(np.subtract(whole[1::2], whole[::2]) < 3 * size):
        return [whole] * len(fields)
    return [np.ravel([[middle - half, middle + half] for middle, half in
                      zip((np.add(box[1::2], box[::2])) / 2, size / 2)]) for box in own]


def window(fields, value, faint, body):
    x, y = fields[-1]["x"], fields[-1]["y"]
    rows, columns = np.nonzero(np.max([np.abs(f[value]) for f in fields], axis=0) > faint)
    if not rows.size:  # nothing has come about yet
        return [x[0], x[-1], y[0], y[-1]]
    left, right = x[columns.min()], x[columns.max()]
    low, high = y[rows.min()], y[rows.max()]
    pad = 0.6 if body else 0
    return [max(left - pad, x[0]), min(right + pad, x[-1]), max(low - pad, y[0]),
            min(high + pad, y[-1])]
