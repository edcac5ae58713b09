"""The drag keeps to the reference, by both routes: rate of change of impulse, and wall sheet; or
that of each of several bodies."""

import numpy as np
from _style import BLUE, INK, ORANGE, Nothing, figure, interpolated, main, rms


def draw(run):
    run.body
    report, reference = run.report, None if run.several else run.reference("drag_reference")
    start = run.check.get("drag_from", 0.3)  # T; before, C_D comes down from infinity
    shown = report["T"] >= start - 1e-9
    T = report["T"][shown]
    if T.size < 2:
        raise Nothing
    fig = figure(7.2, 5.6 if reference else 4.0, run.scene.get("title"))
    top, bottom = (fig.subplots(2, 1, sharex=True, height_ratios=[2.2, 1]) if reference
                   else (fig.subplots(), None))
    drag = {name: report[f"cd_{route}"][shown] for route, name in run.routes}
    if run.several:
        run.plot_routes(top, "cd", lambda column: (T, report[column][shown]))
    else:
        for (name, values), (colour, width) in zip(drag.items(), ((BLUE, 1.8), (ORANGE, 1.0))):
            top.plot(T, values, color=colour, lw=width, label=name)
    top.set_ylabel("drag coefficient  $C_D = 2F_x\\,/\\,(\\rho U^2 D)$")
    (bottom or top).set_xlabel("time  $T = Ut/R$")
    top.set_xlim(start, T[-1])
    if reference:
        compare(top, bottom, reference, T, drag)
    top.legend(loc="best")
    return fig


def compare(top, bottom, reference, T, drag):
    listed = (reference["T"] >= T[0] - 1e-9) & (reference["T"] <= T[-1] + 1e-9)
    top.plot(reference["T"][listed], reference["C_D"][listed], "o", ms=3.4, mfc="white", mec=INK,
             mew=0.8, zorder=3, label="reference")
    bottom.axhspan(-2, 2, color="#f1f1f1", lw=0)
    bottom.axhspan(-1, 1, color="#e4e4e4", lw=0)
    bottom.axhline(0, color=INK, lw=0.6)
    largest = 2.0
    for line, (name, values) in zip(top.lines, drag.items()):
        deviation = 100 * (values / interpolated(reference["T"], reference["C_D"], T) - 1)
        bottom.plot(T, deviation, color=line.get_color(), lw=line.get_linewidth() * 0.75)
        if np.isfinite(deviation).any():
            most = np.nanmax(np.abs(deviation))
            largest = max(largest, most)
            line.set_label(f"{name}: off by {rms(deviation):.2f} % rms, {most:.2f} % at most")
    bottom.set_ylim(-1.15 * largest, 1.15 * largest)
    bottom.set_ylabel("deviation  [%]")
    bottom.grid(axis="y", visible=False)


main("drag.png", draw)
