"""Vortices of Taylor and Green decay as viscosity has it: energy, errors, and what is kept."""

import numpy as np
from _style import BLUE, GREEN, INK, ORANGE, Nothing, figure, main, note


def legend_above(axes):
    """In room of its own: three tenths more of a logarithmic axis."""
    low, high = axes.get_ylim()
    axes.set_ylim(low, high * (high / low) ** 0.3)
    axes.legend(loc="upper right")


def draw(run):
    if run.check.get("exact") != "taylor_green" or "initial" not in run.scene:
        raise Nothing
    report, nu = run.report, run.scene["flow"]["nu"]
    length, speed = run.scene["initial"]["wavelength"], run.speed
    t = speed * report["t"] / length
    fig = figure(12.0, 4.2, run.scene.get("title"))
    energy, errors, kept = fig.subplots(1, 3)

    x0, y0, x1, y1 = run.scene["sph"]["box"]
    start = (x1 - x0) * (y1 - y0) * speed**2 / 4
    decay = np.exp(-16 * np.pi**2 * nu * report["t"] / length**2)
    ours = report["energy"] / report["volume"] / start
    energy.plot(t, ours, color=BLUE, lw=2.2, label="vortree")
    energy.plot(t, decay, color=INK, lw=1.0, ls=(0, (5, 3)),
                label=r"exact, $\exp(-16\pi^2\nu t/L^2)$")
    energy.set(ylabel="energy in a unit of volume  [of the start]", ylim=(0, 1.05))
    energy.legend(loc="upper right")
    off = ours / decay - 1
    note(energy, f"{100 * off[-1]:+.2g} % at the end", x=0.03, y=0.05)

    for name, colour in (("velocity", BLUE), ("pressure", ORANGE)):
        error = report[f"{name}_error"]
        errors.semilogy(t, error, color=colour, label=f"{name}, {error[-1]:.2g} at the end")
    errors.set(ylabel="root mean square of the error  [relative]")
    legend_above(errors)

    momentum = np.hypot(report["momentum_x"], report["momentum_y"])
    kept.semilogy(t, np.maximum(np.abs(report["volume"] - 1), 1e-16), color=GREEN,
                  label="volume, off that of the box")
    kept.semilogy(t, np.maximum(momentum, 1e-16), color=BLUE,
                  label="momentum, of all fluid at speed $U$")
    kept.set(ylabel="what should be 0")
    legend_above(kept)
    for axes in (energy, errors, kept):
        axes.set(xlabel="time  $Ut/L$", xlim=(0, t[-1]))
    return fig


main("taylor_green.png", draw)
