"""The closed wake grows, and the flow separates, as in the reference."""

import numpy as np
from _outline import is_slender
from _style import BLUE, INK, Nothing, figure, interpolated, main, note, rms

SHORTEST = 0.1  # L/D: of a wake that has hardly begun a relative deviation tells nothing

# column of report.csv, of the reference; label; deviation: its unit, first T that counts, the
# least reference that does, formula
PANELS = (
    ("bubble_length", "L_over_D", "length of the closed wake  $L/D$", "%", "bubble_from", SHORTEST,
     lambda ours, reference: 100 * (ours / reference - 1)),
    ("separation_deg", "sep_deg", "separation angle from the rear  [deg]", "deg", "separation_from",
     0, lambda ours, reference: ours - reference),
)


def draw(run):
    run.single_body
    if is_slender(run) or run.sheds:
        raise Nothing  # no closed wake
    report, reference = run.report, run.reference("drag_reference")
    if reference and not {listed for _, listed, *_ in PANELS} <= set(reference):
        reference = None  # it has forces alone
    T = report["T"]
    if T.size < 2 or not np.any(report["bubble_length"] > SHORTEST):
        raise Nothing
    fig = figure(9.6, 5.0 if reference else 3.8, run.scene.get("title"))
    rows = 2 if reference else 1
    grid = fig.subplots(rows, 2, sharex="col", squeeze=False, height_ratios=[2.6, 1][:rows])
    for (top, *below), panel in zip(grid.T, PANELS):
        column, listed, label, unit, check_from, least, deviation = panel
        top.plot(T, report[column], color=BLUE, lw=1.8, label="vortree")
        top.set_ylabel(label)
        top.set_xlim(0, T[-1])
        most = np.nanmax(report[column])
        if reference:
            known = (reference["T"] <= T[-1] + 1e-9) & (reference[listed] > 0)
            most = max(most, np.max(reference[listed][known], initial=0))
            every = slice(None, None, 2) if known.sum() > 50 else slice(None)
            top.plot(reference["T"][known][every], reference[listed][known][every], "o", ms=3.2,
                     mfc="white", mec=INK, mew=0.7, label="reference")
            counted = T >= run.check.get(check_from, 1.0) - 1e-9
            known = interpolated(reference["T"], reference[listed], T[counted])
            known = np.where(known > least, known, np.nan)
            compare(top, below[0], T[counted], deviation(report[column][counted], known), unit)
        top.set_ylim(0, 1.08 * most or 1)
        (below or [top])[0].set_xlabel("time  $T = Ut/R$")
    grid[0, 0].legend(loc="upper left")
    return fig


def compare(top, below, T, off, unit):
    below.axhline(0, color=INK, lw=0.6)
    below.plot(T, off, color=BLUE, lw=1.2)
    below.set_ylabel(f"deviation  [{unit}]")
    if not np.isfinite(off).any():
        return
    most = np.nanmax(np.abs(off))
    below.set_ylim(-1.25 * most, 1.25 * most)
    note(top, f"deviation for $T \\geq {T[np.isfinite(off)][0]:.3g}$\n"
              f"rms {rms(off):.2f} {unit}, largest {most:.2f} {unit}", y=0.05)


main("wake.png", draw)
