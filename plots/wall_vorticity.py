"""The vorticity on the wall follows the reference, at every time that both have."""

import numpy as np
from _style import BLUE, INK, Nothing, figure, interpolated, main, read_csv

SHARED = 0.02  # in T


def draw(run):
    radius, _ = run.single_body
    wall, reference = read_csv(run.file("wall.csv")), run.reference("wall_vorticity_reference")
    if reference is None:
        raise Nothing
    pairs = shared_times(wall, reference)
    rows = -(-len(pairs) // 5)
    columns = -(-len(pairs) // rows)
    fig = figure(1.0 + 2.1 * columns, 0.9 + 2.2 * rows, run.scene.get("title"))
    grid = fig.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes, (ours, theirs) in zip(grid.flat, pairs):
        panel(axes, wall, reference, ours, theirs, radius / run.speed)
    for axes in grid.flat[len(pairs):]:
        axes.set_visible(False)
    for axes in grid.flat[max(0, len(pairs) - columns):len(pairs)]:
        axes.tick_params(labelbottom=True)
    fig.supxlabel("angle from the rear, upper half  [deg]\n"
                  "in brackets: rms deviation over rms of the reference, largest over its largest",
                  fontsize=11.5)
    fig.supylabel("wall vorticity  $\\omega R/U$", fontsize=11.5)
    handles, labels = grid.flat[0].get_legend_handles_labels()
    grid.flat[0].legend(handles, labels, loc="lower left", handlelength=1.3, borderaxespad=0.2)
    return fig


def shared_times(wall, reference):
    """(rows of the run, rows of the reference) at each time that both have."""
    pairs = []
    for T in np.unique(reference["T"]):
        ours = np.flatnonzero((np.abs(wall["T"] - T) < SHARED) & (wall["angle_deg"] >= 0))
        if ours.size > 3:
            order = np.argsort(wall["angle_deg"][ours])
            pairs.append((ours[order], np.flatnonzero(reference["T"] == T)))
    if not pairs:
        raise Nothing
    return pairs


def panel(axes, wall, reference, ours, theirs, unit):
    angle, value = wall["angle_deg"][ours], unit * wall["vorticity"][ours]
    at, exact = reference["theta_deg"][theirs], reference["omega_R_over_U"][theirs]
    off = interpolated(angle, value, at) - exact
    inside = np.isfinite(off)
    deviation = 100 * np.sqrt(np.sum(off[inside]**2) / np.sum(exact[inside]**2))
    largest = 100 * np.max(np.abs(off[inside])) / np.max(np.abs(exact[inside]))
    axes.axhline(0, color="#bbbbbb", lw=0.7)
    axes.plot(angle, value, color=BLUE, lw=1.5, label="vortree")
    axes.plot(at, exact, color=INK, lw=0.8, ls=(0, (5, 2)), label="reference")
    axes.set_title(f"$T = {wall['T'][ours[0]]:.3g}$  ({deviation:.1f}, {largest:.1f} %)",
                   fontsize=10.5)
    axes.set_xlim(0, 180)
    axes.set_xticks([0, 60, 120, 180])


main("wall_vorticity.png", draw)
