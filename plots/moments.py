"""How a vortex in free space turns and changes form, against a spectral solution."""

import numpy as np
from _style import BLUE, GREY, INK, ORANGE, Nothing, figure, interpolated, main, note

ONSET = 0.22  # core over separation at which two vortices merge


def draw(run):
    reference = run.reference("moments_reference")
    if reference is None:
        raise Nothing
    report, pair = run.report, run.check.get("exact") == "corotating_pair"
    fig = figure(11.5, 5.0, run.scene.get("title"))
    grid = fig.subplots(2, 2, sharex=True, height_ratios=[2.2, 1])
    t = report["t"]
    ours, exact = quadrupole(report), quadrupole(reference)
    shown = reference["t"] <= t[-1] + 1e-9
    size = np.abs(exact).max()
    dots = {"ls": "none", "marker": "o", "ms": 3.4, "mfc": "white", "mec": INK, "mew": 0.8}

    left = grid[:, 0]
    left[0].plot(t, ours.real / size, color=BLUE, label="vortree, $\\int\\omega(x^2-y^2)\\,dA$")
    left[0].plot(t, ours.imag / size, color=ORANGE, label="vortree, $\\int\\omega\\,2xy\\,dA$")
    for part, label in ((exact.real, "spectral"), (exact.imag, None)):
        left[0].plot(reference["t"][shown], part[shown] / size, label=label, zorder=3, **dots)
    left[0].set_ylabel("quadrupole, of its largest")
    left[0].set_ylim(-1.15, 1.65)
    left[0].legend(loc="upper right", ncol=2, fontsize=9)
    off = interpolated(reference["t"], exact, t) - ours
    difference(left[1], t, np.abs(off) / size)

    right = grid[:, 1]
    if pair:
        merging(right, run, report, reference, shown, dots)
    else:
        form(right, t, ours / size, reference["t"][shown], exact[shown] / size, dots)
    for axes in grid[1]:
        axes.set_xlabel("time  $t$")
        axes.set_xlim(t[0], t[-1])
    return fig


def quadrupole(table):
    return table["quadrupole_xx"] + 1j * table["quadrupole_xy"]


def difference(axes, t, off):
    axes.plot(t, 100 * off, color=BLUE)
    axes.set_ylim(0, None)
    axes.set_ylabel("off by  [%]")
    note(axes, f"largest {100 * np.nanmax(off):.2f} %", 0.02, 0.94)


def form(pair, t, ours, times, exact, dots):
    top, bottom = pair
    top.plot(t, np.abs(ours), color=BLUE, label="vortree")
    top.plot(times, np.abs(exact), label="spectral", zorder=3, **dots)
    top.set_ylabel("how elongated:  |quadrupole|")
    top.set_ylim(0, None)
    top.legend(loc="upper right")
    turn = np.unwrap(np.angle(ours)) / (4 * np.pi)
    bottom.plot(t, turn, color=BLUE)
    bottom.plot(times, np.unwrap(np.angle(exact)) / (4 * np.pi), zorder=3, **{**dots, "ms": 2.6})
    bottom.set_ylabel("turns of the axis")


def merging(pair, run, report, reference, shown, dots):
    top, bottom = pair
    initial, nu = run.scene["initial"], run.scene["flow"]["nu"]
    core = np.sqrt(initial["core"]**2 + 4 * nu * report["t"])
    ratio = core / report["separation"]
    top.plot(report["t"], report["separation"], color=BLUE, label="vortree: distance $b$")
    top.plot(reference["t"][shown], reference["separation"][shown], label="spectral", zorder=3,
             **dots)
    top.plot(report["t"], core, color=GREY, label="core $a = (a_0^2 + 4\\nu t)^{1/2}$")
    top.set_ylim(0, 1.25 * initial["separation"])
    top.set_ylabel("distance and core")
    bottom.plot(report["t"], ratio, color=BLUE)
    bottom.axhline(ONSET, color=INK, lw=0.8, ls=(0, (5, 3)))
    bottom.set_ylabel("$a/b$")
    fallen = np.nonzero(report["separation"] < 0.99 * report["separation"][0])[0]
    if fallen.size:
        k = fallen[0]
        for axes in pair:
            axes.axvline(report["t"][k], color=ORANGE, lw=0.9)
        note(bottom, f"$b$ has fallen by 1 % at $a/b = {ratio[k]:.3f}$ (0.22: Meunier et al. 2002)",
             0.02, 0.95)
    top.legend(loc="center", bbox_to_anchor=(0.56, 0.48))


main("moments.png", draw)
