"""Pressure and vorticity along the wall of a body at rest, as they come about."""

import matplotlib
import numpy as np
from _style import Broken, Nothing, figure, main, read_csv

MOST = 5  # times
OUTER = 3  # the kind of nodes where fluid comes in


def far_pressure(run, times):
    """The pressure far away at each time, by Bernoulli's law from the side where fluid comes in."""
    found = {}
    along = run.stream / run.speed
    with run.hdf5("frames.h5") as file:
        for name in (n for n in file if n.startswith("frame_")):
            try:
                frame = file[name]
                time = float(frame.attrs["time"])
                x, y, u, v, p, kind = (frame[column][()] for column in
                                       ("x", "y", "u", "v", "pressure", "kind"))
            except KeyError:
                continue
            except OSError:
                raise Broken(f"{run.folder / 'frames.h5'}: a frame is damaged") from None
            way = x * along[0] + y * along[1]
            first = (kind == OUTER) & (way < way.min() + 1e-6 * np.ptp(way))
            found[time] = np.mean(p[first] + (u[first]**2 + v[first]**2 - run.speed**2) / 2)
    at = sorted(found)
    return np.interp(times, at, [found[time] for time in at])


def draw(run):
    radius, _ = run.body
    wall = read_csv(run.file("wall.csv"))
    if "pressure" not in wall or "plunge" in run.scene or not np.any(run.stream):
        raise Nothing
    times = np.unique(wall["T"])
    if times.size == 0:
        raise Nothing
    times = times[np.unique(np.linspace(0, times.size - 1, MOST).round().astype(int))]
    far = far_pressure(run, times * radius / run.speed)
    fig = figure(10.0, 4.2, run.scene.get("title"))
    pressure, vorticity = fig.subplots(1, 2, sharex=True)
    colours = matplotlib.colormaps["viridis"](np.linspace(0.85, 0, times.size))
    for T, p, colour in zip(times, far, colours):
        rows = np.flatnonzero(wall["T"] == T)
        rows = rows[np.argsort(wall["angle_deg"][rows])]
        look = {"color": colour, "lw": 1.3, "label": f"$T = {T:.3g}$"}
        angle = wall["angle_deg"][rows]
        pressure.plot(angle, 2 * (wall["pressure"][rows] - p) / run.speed**2, **look)
        vorticity.plot(angle, radius / run.speed * wall["vorticity"][rows], **look)
    pressure.set_ylabel("pressure  $C_p$")
    vorticity.set_ylabel("vorticity  $\\omega R/U$")
    for axes in (pressure, vorticity):
        axes.axhline(0, color="#bbbbbb", lw=0.7)
        axes.set(xlabel="angle from the rear  [deg]", xlim=(-180, 180))
        axes.set_xticks(range(-180, 181, 60))
    vorticity.legend()
    return fig


main("wall_pressure.png", draw)
