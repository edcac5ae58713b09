"""Where tracers have come to that a scene releases, in up to four frames, like dye."""

import numpy as np
from _outline import outline
from _style import BLUE, GREEN, ORANGE, RED, SKY, Broken, Nothing, figure, main

MOST = 4  # panels
DYES = (BLUE, RED, GREEN, ORANGE, SKY)


def frames(run):
    """Time, places and number of the set of the tracers, of each frame that has some."""
    if not run.scene.get("tracers"):
        raise Nothing
    found = []
    with run.hdf5("frames.h5") as file:
        try:
            for name in sorted(name for name in file if name.startswith("frame_")):
                state = file[name]["state"]
                if state["tracers x"].size:
                    found.append((float(file[name].attrs["time"]),
                                  *(state[f"tracers {what}"][()] for what in ("x", "y", "set"))))
        except (KeyError, OSError):
            raise Broken(f"{run.folder / 'frames.h5'}: a frame is damaged") from None
    if not found:
        raise Nothing
    shown = np.linspace(0, len(found) - 1, min(MOST, len(found))).round().astype(int)
    return [found[k] for k in shown]


def window(run, shown):
    """What the scene's pictures show, or all tracers of the frames."""
    if "window" in run.scene.get("output", {}):
        x0, y0, x1, y1 = run.scene["output"]["window"]
        return (x0, x1), (y0, y1)
    return tuple((low - 0.1 * (high - low + 1e-9), high + 0.1 * (high - low + 1e-9))
                 for low, high in ((min(of[k].min() for of in shown), max(of[k].max() for of in shown))
                                   for k in (1, 2)))


def draw(run):
    shown = frames(run)
    body = "body" in run.scene
    unit, centre = run.body if body else (1.0, np.zeros(2))
    wide, high = window(run, shown)
    tall = (high[1] - high[0]) / (wide[1] - wide[0])
    columns = min(len(shown), MOST if tall > 0.8 else 2)
    rows = -(-len(shown) // columns)
    fig = figure(11.0, 0.6 + rows * (0.45 + tall * 10.4 / max(columns, 2)), run.scene.get("title"))
    grid = fig.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes, (time, x, y, number) in zip(grid.flat, shown):
        colours = np.array(DYES)[number.astype(int) % len(DYES)]
        axes.scatter((x - centre[0]) / unit, (y - centre[1]) / unit, s=2.5, c=colours, lw=0,
                     rasterized=True)
        if body:
            axes.add_patch(outline(run, time))
        t = time * run.speed / unit if body else time
        axes.set_title(f"${'T' if body else 't'} = {t:.3g}$")
        axes.set(xlim=[(a - centre[0]) / unit for a in wide],
                 ylim=[(a - centre[1]) / unit for a in high], aspect="equal")
        axes.grid(False)
    for axes in list(grid.flat)[len(shown):]:
        axes.set_visible(False)
    for axes in grid[-1]:
        axes.set_xlabel("$x/R$" if body else "$x$")
    for axes in grid[:, 0]:
        axes.set_ylabel("$y/R$" if body else "$y$")
    return fig


main("tracers.png", draw)
