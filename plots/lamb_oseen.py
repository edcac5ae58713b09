"""A lone vortex spreads as the heat equation says: profiles and second moment against the exact."""

import numpy as np
from _style import BLUE, INK, Nothing, figure, main, note


def draw(run):
    if run.check.get("exact") != "lamb_oseen" or "initial" not in run.scene:
        raise Nothing
    report, field = run.report, run.fields()[-1]
    initial, nu = run.scene["initial"], run.scene["flow"]["nu"]
    gamma, t = initial["circulation"], field["time"]
    width = np.sqrt(initial["core"]**2 + 4 * nu * t)
    r, omega, swirl = profiles(field, np.array(initial["centre"]) + t * run.stream, run.stream)

    if not r.size:
        raise Nothing  # pictures of another place
    fig = figure(11.5, 4.8, run.scene.get("title"))
    grid = fig.subplots(2, 3, height_ratios=[2.2, 1], sharex="col")
    radii = np.linspace(0, r.max(), 400)
    compare(grid[:, 0], r, omega, radii, lambda r: vorticity(r, gamma, width),
            f"vorticity  $\\omega$  at $t = {t:.3g}$")
    compare(grid[:, 1], r, swirl, radii, lambda r: velocity(r, gamma, width),
            f"velocity  $u_\\theta$  at $t = {t:.3g}$")
    for axes in grid[1, :2]:
        axes.set_xlabel("distance from the centre  $r$")
    growth(grid[:, 2], report, nu)
    return fig


def profiles(field, centre, stream):
    """Distance from the centre, vorticity and azimuthal velocity at every point of the grid."""
    X, Y = np.meshgrid(field["x"] - centre[0], field["y"] - centre[1])
    r = np.hypot(X, Y)
    turning = X * (field["v"] - stream[1]) - Y * (field["u"] - stream[0])
    inside = r <= min(np.abs(X).max(), np.abs(Y).max())  # no corners: whole circles only
    swirl = np.divide(turning, r, out=np.zeros_like(r), where=r > 0)
    return r[inside], field["omega"][inside], swirl[inside]


def vorticity(r, gamma, width):
    return gamma / (np.pi * width**2) * np.exp(-(r / width)**2)


def velocity(r, gamma, width):
    r = np.where(r > 0, r, 1e-300)
    return -gamma / (2 * np.pi * r) * np.expm1(-(r / width)**2)


def compare(pair, r, values, radii, exact, label):
    top, bottom = pair
    dots = {"ls": "none", "marker": ".", "ms": 2.5, "color": BLUE, "mew": 0, "rasterized": True}
    top.plot(r, values, alpha=0.5, label="vortree, all points of the grid", **dots)
    top.plot(radii, exact(radii), color=INK, lw=1.0, label="exact")
    top.set_ylabel(label)
    top.set_xlim(0, radii[-1])
    top.set_ylim(0, 1.3 * max(values.max(), exact(radii).max()))
    top.legend(loc="upper right", markerscale=4, handlelength=1.2)
    error = 100 * (values - exact(r)) / np.abs(exact(radii)).max()
    bottom.axhline(0, color=INK, lw=0.6)
    bottom.plot(r, error, alpha=0.5, **dots)
    most = np.abs(error).max()
    bottom.set_ylim(-1.5 * most, 1.5 * most)
    bottom.set_ylabel("error  [% of largest]")
    note(bottom, f"largest {most:.2f} %", y=0.97)


def growth(pair, report, nu):
    top, bottom = pair
    t = report["t"] - report["t"][0]
    grown = report["second_moment"] - report["second_moment"][0]
    expected = 4 * nu * report["circulation"][0] * t
    top.plot(report["t"], grown, color=BLUE, lw=2.2, label="vortree")
    top.plot(report["t"], expected, color=INK, lw=1.0, ls=(0, (5, 3)),
             label="exact, $4\\nu\\Gamma t$")
    top.set_ylabel("growth of  $\\int\\omega r^2\\,dA$")
    top.set_xlim(report["t"][0], report["t"][-1])
    top.legend(loc="upper left")
    bottom.axhline(0, color=INK, lw=0.6)
    bottom.plot(report["t"], (grown - expected) / report["second_moment"][0], color=BLUE)
    bottom.set_ylabel("error  [of the moment]")
    for axes in pair:
        axes.ticklabel_format(axis="y", scilimits=(-2, 3), useMathText=True)
    bottom.set_xlabel("time  $t$")


main("lamb_oseen.png", draw)
