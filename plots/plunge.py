"""The force on a body that plunges goes as known: in fluid at rest with the first harmonic of
Morison's two terms, across a stream as on a flat plate."""

import numpy as np
from _style import GREY, INK, Nothing, figure, main, note

TURN = 2 * np.pi


def draw(run):
    if "plunge" not in run.scene:
        raise Nothing
    radius, _ = run.body
    plunge, check = run.scene["plunge"], run.check
    t, period = run.report["t"], 1 / plunge["frequency"]
    last = t > t[-1] - period * (1 + 1e-9)
    if t[-1] < 2 * period:
        raise Nothing
    phase = (t[last] / period) % 1
    order = np.argsort(phase)
    fig = figure(7.2, 4.6, run.scene.get("title"))
    axes = fig.subplots()
    place = plunge["amplitude"] * np.cos(TURN * phase[order])
    name, label = ("cl", "lift  $C_L$") if run.stream.any() else ("cd", "force along the plunge  $C$")
    run.plot_routes(axes, name, lambda column: (phase[order], run.report[column][last][order]))
    known = (plate if run.stream.any() else morison)(run, check, radius, phase[order])
    if known is not None:
        axes.plot(phase[order], known[0], color=INK, lw=1.0, ls=(0, (5, 3)), label=known[1])
    other = axes.twinx()
    other.plot(phase[order], place / (2 * radius), color=GREY, lw=1.0, ls=":", zorder=0)
    other.set_ylabel("place of the body, in lengths (dotted)", color=GREY)
    other.grid(False)
    axes.set(xlim=(0, 1), xlabel="the last period  $ft$ (mod 1)", ylabel=label)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.25 * (high - low))
    axes.legend(loc="upper center", ncol=3)
    return fig


def morison(run, check, radius, phase):
    """C = -C_D |V| V - pi/2 D C_M dV/dt, V in units of its greatest."""
    if "morison_drag" not in check or "morison_mass" not in check:
        return None
    v, rate = -np.sin(TURN * phase), -TURN * run.scene["plunge"]["frequency"] * np.cos(TURN * phase)
    drag, mass = check["morison_drag"], check["morison_mass"]
    return (-drag * np.abs(v) * v - np.pi * radius * mass * rate / run.speed,
            f"Morison, $C_D = {drag}$, $C_M = {mass}$")


def plate(run, check, radius, phase):
    """Theodorsen's lift of a flat plate: src/exact/theodorsen.hpp."""
    plunge = run.scene["plunge"]
    k = TURN * plunge["frequency"] * radius / run.speed
    delayed = macdonald(1, k) / (macdonald(0, k) + macdonald(1, k))
    lift = plunge["amplitude"] / radius * (np.pi * k * k - TURN * 1j * k * delayed)
    return (lift * np.exp(1j * TURN * phase)).real, "flat plate (Theodorsen)"


def macdonald(n, k):
    """K_n(ik), the integral of exp(-ik cosh t) cosh(nt), down to t = -i pi/2 and on from there."""
    v, dv = (np.arange(2000) + 0.5) * np.pi / 4000, np.pi / 4000
    u, du = (np.arange(40000) + 0.5) / 2000, 1 / 2000
    return (-1j * dv * np.sum(np.exp(-1j * k * np.cos(v)) * np.cos(n * v))
            + du * np.sum(np.exp(-k * np.sinh(u)) * np.cosh(n * (u - 0.5j * np.pi))))


main("plunge.png", draw)
