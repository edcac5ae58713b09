"""Kirchhoff's ellipse turns at a b/(a + b)^2 of its vorticity and keeps its form."""

import numpy as np
from _style import BLUE, INK, Nothing, figure, main, note


def draw(run):
    initial = run.scene.get("initial", {})
    if initial.get("kind") != "kirchhoff_ellipse" or "body" in run.scene:
        raise Nothing
    report, a, b = run.report, initial["core"], initial["core_across"]
    rate = initial["circulation"] / (np.pi * (a + b)**2)
    q = report["quadrupole_xx"] + 1j * report["quadrupole_xy"]
    t, angle = report["t"], np.unwrap(np.angle(q)) / 2
    fig = figure(10.5, 4.6, run.scene.get("title"))
    (turn, size), (off, none) = fig.subplots(2, 2, sharex=True, height_ratios=[2.2, 1])
    turn.plot(t, np.degrees(angle), color=BLUE, lw=2.2, label="vortree")
    turn.plot(t, np.degrees(rate * t), color=INK, lw=1.0, ls=(0, (5, 3)),
              label="exact, $\\omega ab/(a+b)^2\\,t$")
    turn.set_ylabel("angle of the major axis  [deg]")
    turn.legend(loc="upper left")
    off.plot(t, np.degrees(angle - rate * t), color=BLUE)
    off.axhline(0, color=INK, lw=0.6)
    off.set_ylabel("off by  [deg]")
    note(off, f"mean rate off by {100 * abs(angle[-1] / (rate * t[-1]) - 1):.2f} %", 0.02, 0.2)
    size.plot(t, np.abs(q) / np.abs(q[0]) - 1, color=BLUE)
    size.axhline(0, color=INK, lw=0.6)
    size.set_ylabel("change of  |quadrupole|")
    none.plot(t, report["second_moment"] / report["second_moment"][0] - 1, color=BLUE)
    none.set_ylabel("drift of\nangular impulse")
    for axes in (off, none):
        axes.set_xlabel("time  $t$")
        axes.set_xlim(t[0], t[-1])
    for axes in (size, none):
        axes.ticklabel_format(axis="y", scilimits=(-2, 3), useMathText=True)
    return fig


main("kirchhoff.png", draw)
