"""A body at incidence: lift and drag in time by both routes, and the means that are known."""

import numpy as np
from _style import GREY, INK, Nothing, figure, main, note


def draw(run):
    check = run.check
    if not {"mean_lift", "lift_routes_max"} & set(check) or "strouhal" in check:
        raise Nothing
    run.body
    T = run.report["T"]
    shown = T >= check.get("routes_from", 0.5) - 1e-9
    if shown.sum() < 2:
        raise Nothing
    fig = figure(7.2, 5.6, run.scene.get("title"))
    for axes, short, name, known in zip(fig.subplots(2, 1, sharex=True), ("cl", "cd"),
                                        ("lift  $C_L$", "drag  $C_D$"), ("mean_lift", "mean_drag")):
        run.plot_routes(axes, short, lambda column: (T[shown], run.report[column][shown]))
        axes.set_ylabel(name)
        if known in check:
            mean(axes, check, known, T, run.report[f"{short}_{run.route}"])
        axes.legend(loc="upper right", ncol=2)
        low, high = axes.get_ylim()
        axes.set_ylim(low, high + 0.15 * (high - low))
    axes.set_xlim(T[shown][0], T[-1])
    axes.set_xlabel("time  $T = Ut/R$")
    return fig


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
