"""A wake that sheds vortices: drag and lift in time, and the spectrum of the lift."""

from itertools import cycle

import numpy as np
from _style import EACH, GREY, INK, Nothing, figure, main, note


def draw(run):
    check = run.check
    if not run.sheds:
        raise Nothing
    radius, _ = run.body
    report, start = run.report, check.get("shedding_from", 0.0)
    T = report["T"]
    shown = T >= 2
    late = T >= start
    if late.sum() < 100:
        raise Nothing
    fig = figure(11.0, 5.4, run.scene.get("title"))
    grid = fig.add_gridspec(2, 2, width_ratios=[1.75, 1])
    drag, spectrum = fig.add_subplot(grid[0, 0]), fig.add_subplot(grid[:, 1])
    lift = fig.add_subplot(grid[1, 0], sharex=drag)
    t = report["t"] * run.speed / (2 * radius)
    for axes, name, label in ((drag, "cd", "drag  $C_D$"), (lift, "cl", "lift  $C_L$")):
        axes.axvspan(t[late][0], t[-1], color="#f4f4f4", lw=0)
        run.plot_routes(axes, name, lambda column: (t[shown], report[column][shown]))
        axes.set_ylabel(label)
    means = [report[column][late].mean() for column in run.columns("cd")]
    asked, off = asked_drag(run)
    for wanted in asked:
        drag.axhspan(wanted - off, wanted + off, color=GREY, alpha=0.35, lw=0)
    note(drag, "\n".join(words(means, asked, off)))
    settled = [report[column][T >= min(10, T[-1] / 2)] for column in run.columns("cd")]
    low, high = np.min(settled), np.max(settled)
    drag.set_ylim(low - 0.2 * (high - low), high + 0.6 * (high - low))
    drag.legend(loc="lower right", ncol=len(drag.lines))
    lift.set_xlabel("time  $tU/D$")
    lift.set_xlim(t[0], t[-1])

    found = [periodogram(report[column][late], t[1] - t[0]) for column in run.columns("cl")]
    for (frequency, power), look in zip(found, cycle(EACH)):
        spectrum.semilogy(frequency, power / power.max(), **look)
    peaks = [highest(*one) for one in found]
    if "strouhal" in check:
        spectrum.axvline(check["strouhal"], color=INK, lw=0.9, ls=(0, (5, 3)),
                         label=f"asked {check['strouhal']}")
        spectrum.legend(loc="upper right")
    spectrum.set(xlim=(0, 4 * peaks[0]), ylim=(1e-8, 3), xlabel="frequency  $fD/U$",
                 ylabel="power of the lift, of its peak")
    note(spectrum, "\n".join(f"peak at {peak:.4f}" for peak in peaks), y=0.86)
    return fig


def asked_drag(run):
    """Of each body, and how far off it may be."""
    if run.several:
        asked = run.check.get("mean_drag_each", [])
        return asked, run.check.get("mean_drag_each_max", 0) * max(np.abs(asked), default=0)
    asked = [run.check["mean_drag"]] if "mean_drag" in run.check else []
    return asked, run.check.get("mean_drag_max", 0) * sum(asked)


def words(means, asked, off):
    """Of each body, where there are several."""
    for k, mean in enumerate(means):
        which = f" of body {k + 1}:" if len(means) > 1 else ""
        yield f"mean over the grey part{which} {mean:.3f}" + (
            f" (asked {asked[k] - off:.2f} to {asked[k] + off:.2f})" if asked else "")


def highest(frequency, power):
    """Where a parabola through the logarithm of the three highest values has its top."""
    k = min(max(power.argmax(), 1), power.size - 2)
    below, top, above = np.log(power[k - 1:k + 2])
    return frequency[k] + (below - above) / (below - 2 * top + above) / 2 * frequency[1]


def periodogram(signal, dt):
    """Hann's window, zeros appended sixteen times over."""
    n = signal.size
    window = np.sin(np.pi * (np.arange(n) + 0.5) / n)**2
    power = np.abs(np.fft.rfft(window * (signal - signal.mean()), 16 * n))**2
    return np.fft.rfftfreq(16 * n, dt), power


main("shedding.png", draw)
