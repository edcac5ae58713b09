"""The drag of each flow of a sweep by every method, beside the reference."""

import numpy as np
from _style import BLUE, GREEN, INK, ORANGE, Nothing, figure, interpolated, main, rms
from _sweep import WORDS, by_method, title

COLOURS = (BLUE, ORANGE, GREEN)
MOST = 4  # panels


def draw(run):
    flows = by_method(run)[:MOST]
    several = [one for _, runs in flows for one in runs.values()]
    known = any(one.reference("drag_reference") for one in several)
    fig = figure(1.4 + 3.4 * len(flows), 5.2 if known else 3.4, title(several[0]))
    grid = fig.subplots(2 if known else 1, len(flows), sharex="col", sharey="row", squeeze=False,
                        height_ratios=[2, 1] if known else None)
    for panels, (words, runs) in zip(grid.T, flows):
        panels[0].set_title(words)
        panels[-1].set_xlabel("time  $T = Ut/R$")
        panel(panels, runs)
    grid[0, 0].set_ylabel("drag coefficient  $C_D$")
    if known:
        grid[1, 0].set_ylabel("deviation  [%]")
    return fig


def panel(panels, runs):
    """Methods over each other, and over what is known."""
    for colour, (method, one) in zip(COLOURS, runs.items()):
        start = one.check.get("drag_from", 0.3)
        report, reference = one.report, one.reference("drag_reference")
        shown = report["T"] >= start - 1e-9
        if np.count_nonzero(shown) < 2:
            raise Nothing
        T, drag = report["T"][shown], report[f"cd_{one.route}"][shown]
        name = WORDS.get(method, method)
        if reference:
            off = 100 * (drag / interpolated(reference["T"], reference["C_D"], T) - 1)
            name += f": {rms(off):.2f} % rms, {np.nanmax(np.abs(off)):.2f} % at most"
            panels[1].plot(T, off, color=colour, lw=1.0)
        panels[0].plot(T, drag, color=colour, lw=1.4, label=name)
    panels[0].set_xlim(start, T[-1])
    if reference:
        dots(panels[0], reference, T)
        panels[1].axhline(0, color=INK, lw=0.6)
    panels[0].legend(loc="upper right", fontsize=9)


def dots(axes, reference, T):
    """Some thirty of its values."""
    listed = np.flatnonzero((reference["T"] >= T[0] - 1e-9) & (reference["T"] <= T[-1] + 1e-9))
    listed = listed[::max(1, listed.size // 30)]
    axes.plot(reference["T"][listed], reference["C_D"][listed], "o", ms=3.4, mfc="white", mec=INK,
              mew=0.8, zorder=3, label="reference")


main("sweep_drag.png", draw)
