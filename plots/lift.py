"""Lift and drag in time by both routes, or of each of several bodies, and what is known of them: a
reference, or the means."""

import numpy as np
from _style import GREY, INK, Nothing, figure, interpolated, main, note, rms

KNOWN = {"lift": "C_L", "drag": "C_D"}  # columns of a reference


def draw(run):
    check = run.check
    asked = {"mean_lift", "lift_routes_max", "lift_reference"} & set(check) or run.several
    if not asked or run.sheds:
        raise Nothing
    run.body
    T = run.report["T"]
    shown = T >= check.get("lift_from", check.get("routes_from", 0.5)) - 1e-9
    if shown.sum() < 2:
        raise Nothing
    fig = figure(7.2, 5.6, run.scene.get("title"))
    for axes, force in zip(fig.subplots(2, 1, sharex=True), KNOWN):
        panel(axes, run, force, T, shown)
    axes.set_xlim(T[shown][0], T[-1])
    axes.set_xlabel("time  $T = Ut/R$")
    return fig


def panel(axes, run, force, T, shown):
    short = f"c{force[0]}"
    run.plot_routes(axes, short, lambda column: (T[shown], run.report[column][shown]))
    axes.set_ylabel(f"{force}  ${KNOWN[force]}$")
    if f"mean_{force}" in run.check and not run.several:
        mean(axes, run.check, f"mean_{force}", T, run.report[f"{short}_{run.route}"])
    reference = None if run.several else run.reference(f"{force}_reference")
    if reference:
        compare(axes, reference["T"], reference[KNOWN[force]], force)
    axes.legend(loc="upper right", ncol=1 if reference else max(2, len(axes.lines)))
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + (0.3 if reference else 0.15) * (high - low))


def compare(axes, at, known, force):
    """As [check] does: drag relative to that at the time, lift to the largest."""
    T = axes.lines[0].get_xdata()
    for line in axes.lines[:2]:
        exact = interpolated(at, known, T)
        whole = exact if force == "drag" else np.nanmax(np.abs(exact))
        off = 100 * (line.get_ydata() - exact) / whole
        if np.isfinite(off).any():
            line.set_label(f"{line.get_label()}: off by {rms(off):.2f} % rms, "
                           f"{np.nanmax(np.abs(off)):.2f} % at most")
    listed = np.flatnonzero((at >= T[0] - 1e-9) & (at <= T[-1] + 1e-9))
    listed = listed[::max(1, listed.size // 30)]
    axes.plot(at[listed], known[listed], "o", ms=3.4, mfc="white", mec=INK, mew=0.8, zorder=3,
              label="reference")


def mean(axes, check, known, T, values):
    late = T >= check.get("shedding_from", 0.0)
    if not late.any():
        return
    wanted, off = check[known], check.get(f"{known}_max", 0)
    axes.fill_between([T[late][0], T[-1]], wanted * (1 - off), wanted * (1 + off), color=GREY,
                      alpha=0.35, lw=0)
    axes.plot([T[late][0], T[-1]], 2 * [values[late].mean()], color=INK, lw=0.8, ls=(0, (5, 3)))
    note(axes, f"mean {values[late].mean():.3f} (asked {wanted * (1 - off):.3f} to "
               f"{wanted * (1 + off):.3f})", x=0.02, y=0.06)


main("lift.png", draw)
