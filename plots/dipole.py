"""Two opposite vortices travel at gamma/(2 pi b), and keep what free space keeps."""

import numpy as np
from _style import (BLUE, GREEN, INK, ORANGE, RED, SKY, Nothing, figure, main, note, read_csv)


def draw(run):
    initial = run.scene.get("initial", {})
    if initial.get("kind") != "dipole" or "body" in run.scene:
        raise Nothing
    report, nu, b = run.report, run.scene["flow"]["nu"], initial["separation"]
    t, gamma = report["t"], initial["circulation"]
    way = report["plus_y"] - report["plus_y"][0]
    core2 = initial["core"]**2 + 4 * nu * t
    speed = gamma / (2 * np.pi * b) * -np.expm1(-b**2 / (2 * core2))
    exact = np.r_[0, np.cumsum(np.diff(t) * (speed[1:] + speed[:-1]) / 2)]
    fig = figure(11.0, 4.8, run.scene.get("title"))
    grid = fig.subplots(2, 2, sharex=True, height_ratios=[1.6, 1])
    top, bottom = grid[:, 0]
    top.plot(t, way / b, color=BLUE, lw=2.2, label="vortree")
    top.plot(t, exact / b, color=INK, lw=1.0, ls=(0, (5, 3)), label="exact, $\\Gamma t/2\\pi b$")
    top.set_ylabel("way travelled, of the distance $b$")
    top.legend(loc="upper left")
    bottom.axhline(0, color=INK, lw=0.6)
    bottom.plot(t, (way - exact) / b, color=BLUE)
    bottom.set_ylabel("off by  [of $b$]")
    note(bottom, f"mean speed off by {100 * abs(way[-1] / exact[-1] - 1):.3f} %", 0.02, 0.06)
    drifts(grid[:, 1], run, report, gamma, b, nu)
    for axes in grid[1]:
        axes.set_xlabel("time  $t$")
        axes.set_xlim(t[0], t[-1])
    return fig


def drifts(pair, run, report, gamma, b, nu):
    top, bottom = pair
    t = report["t"]
    curves = [
        ("circulation", report["circulation"] / gamma, BLUE),
        ("impulse along the way", report["impulse_y"] / report["impulse_y"][0] - 1, ORANGE),
        ("impulse across", report["impulse_x"] / report["impulse_y"][0], GREEN),
        ("separation", report["separation"] / report["separation"][0] - 1, RED),
    ]
    for name, value, colour in curves:
        top.plot(t, np.maximum(np.abs(value - value[0]), 1e-17), color=colour, label=name)
    energy = read_csv(run.file("energy.csv"))
    rate = nu * energy["enstrophy"]
    taken = np.r_[0, np.cumsum(np.diff(energy["t"]) * (rate[1:] + rate[:-1]) / 2)]
    kept = (energy["energy"] + taken) / energy["energy"][0] - 1
    top.plot(energy["t"], np.maximum(np.abs(kept), 1e-17), color=SKY,
             label="energy + dissipated")
    top.set_yscale("log")
    top.set_ylim(1e-17, 10)
    top.set_ylabel("relative drift")
    top.legend(loc="center", bbox_to_anchor=(0.55, 0.45), fontsize=8.5, ncol=2)
    bottom.plot(t, report["blobs"], color=INK)
    bottom.set_ylim(0, None)
    bottom.set_ylabel("blobs")


main("dipole.png", draw)
