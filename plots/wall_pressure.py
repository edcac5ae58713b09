"""Pressure along the wall as it comes about: by vortices with friction, by SPH with the vorticity of a
body at rest."""

import matplotlib
import numpy as np
from _outline import is_circle
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
    wall = read_csv(run.file("wall.csv"))
    times = np.unique(wall["T"])
    if times.size == 0:
        raise Nothing
    times = times[np.unique(np.linspace(0, times.size - 1, MOST).round().astype(int))]
    if "cp" in wall:
        return two_panels(run, wall, times, coefficients)
    if "pressure" not in wall or "plunge" in run.scene or not np.any(run.stream):
        raise Nothing
    return two_panels(run, wall, times, by_particles)


def two_panels(run, wall, times, columns):
    fig = figure(10.0, 4.2, run.scene.get("title"))
    left, right = fig.subplots(1, 2, sharex=True)
    names = columns(run, wall, times)
    colours = matplotlib.colormaps["viridis"](np.linspace(0.85, 0, times.size))
    for T, colour in zip(times, colours):
        rows = np.flatnonzero(wall["T"] == T)
        place = along(run, wall["angle_deg"][rows])
        order = np.argsort(place)
        for axes, (_, values) in zip((left, right), names):
            axes.plot(place[order], values[rows][order], color=colour, lw=1.3, label=f"$T = {T:.3g}$")
    for axes, (label, _) in zip((left, right), names):
        axes.axhline(0, color="#bbbbbb", lw=0.7)
        axes.set_ylabel(label)
        if is_circle(run):
            axes.set(xlabel="angle from the rear  [deg]", xlim=(-180, 180))
            axes.set_xticks(range(-180, 181, 60))
        else:
            axes.set(xlabel="way along the wall, anticlockwise, of the whole", xlim=(0, 1))
    right.legend()
    return fig


def along(run, angle):
    """Where panels lie, by the angle around a circle, else by how far they are around the body."""
    return angle if is_circle(run) else (np.arange(angle.size) + 0.5) / angle.size


def coefficients(run, wall, times):
    return ("pressure  $C_p$", wall["cp"]), ("friction, anticlockwise  $C_f$", wall["cf"])


def by_particles(run, wall, times):
    radius, _ = run.body
    every = np.unique(wall["T"])
    far = np.interp(wall["T"], every, far_pressure(run, every * radius / run.speed))
    return (("pressure  $C_p$", 2 * (wall["pressure"] - far) / run.speed**2),
            ("vorticity  $\\omega R/U$", radius / run.speed * wall["vorticity"]))


main("wall_pressure.png", draw)
