"""What a digit costs: error against the swept key, and seconds against error; against that of the
drag alone where there is one, with the seconds that some errors cost."""

import numpy as np
from _style import BLUE, GREEN, GREY, INK, ORANGE, RED, SKY, Nothing, figure, main, note
from _sweep import WORDS as NAMES
from _sweep import keys_of, medians, number, read
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

NOT_ERRORS = {"steps", "particles", "particle_steps", "seconds", "processor_seconds", "blobs_max",
              "lift_max"}
# Shown where nothing else is: drifts of what is kept, and an error that is no share.
SECOND = {"circulation_max", "impulse_max", "second_moment_max", "separation_max_deg",
          "volume_max", "momentum_max"}
WORDS = {"drag_max": "drag, largest", "drag_rms": "drag, rms", "bubble_max": "length of the wake",
         "routes_max": "two drag routes apart", "wall_vorticity_rms": "vorticity at the wall",
         "lift_routes_max": "two lift routes apart", "separation_max_deg": "separation  [deg]",
         "mean_drag_max": "mean drag", "mean_lift_max": "mean lift",
         "strouhal_max": "Strouhal number", "quadrupole_max": "quadrupole",
         "separation_max": "distance of the vortices", "velocity_rms": "velocity, rms",
         "pressure_rms": "pressure, rms"}
CLOCKS = {"seconds": "wall time  [s]", "processor_seconds": "time of one processor  [s]"}
DRAG = ("drag_max", "drag_rms")
GUIDES = (0.01, 0.003, 0.001)  # src/app/commands/sweep/seconds.cpp
LOOKS = [(BLUE, "o"), (ORANGE, "s"), (GREEN, "D"), (RED, "^"), (SKY, "v"), (GREY, "P")]


def draw(run):
    path = run.file("sweep.csv")
    notes, rows = read(path)
    rows = medians(rows)
    keys, clock = keys_of(rows), clock_of(notes)
    errors = [name for name in rows[0] if name not in NOT_ERRORS and name not in keys
              and any(usable(number(row[name])) for row in rows)]
    if not errors:
        raise Nothing
    errors = [name for name in errors if name not in SECOND] or errors
    curves = grouped(rows, keys)
    numeric = all(number(row[keys[-1]]) == number(row[keys[-1]]) for row in rows)
    fig = figure(10.5 if numeric else 6.6, 4.6, title(notes))
    panels = fig.subplots(1, 2 if numeric else 1, squeeze=False)[0]
    if len(curves) > 1:  # one error tells the groups apart
        shown = [(NAMES.get(group, group.replace("_", " ")), members, errors[0])
                 for group, members in curves]
    elif numeric:
        shown = [(said(name), curves[0][1], name) for name in errors[:len(LOOKS)]]
    else:
        shown = [(row[keys[-1]], [row], errors[0]) for row in rows]
    drag = any(error in DRAG for _, _, error in shown)
    for (label, members, error), (colour, marker) in zip(shown, LOOKS):
        e = np.array([number(row[error]) for row in members])
        seconds = np.array([number(row[clock]) for row in members])
        style = {"color": colour, "marker": marker, "ms": 5}
        if numeric:
            h = np.array([number(row[keys[-1]]) for row in members])
            panels[0].plot(h, e, label=f"{label}{slope(keys[-1], h, e)}", **style)
        if not drag or error in DRAG:
            panels[-1].plot(e, seconds, label=label, **style)
        if drag and error in DRAG:
            tell_seconds(panels[-1], seconds, e, colour)
    what = f"error of the {said(errors[0])}" if len(curves) > 1 else "error"
    finish(panels, keys[-1], numeric, what if numeric else said(errors[0]))
    if drag:
        guide(panels[-1])
        if len(curves) == 1 and numeric:
            panels[-1].set_xlabel("error of the drag")
            panels[-1].legend(loc="upper right", fontsize=9, frameon=True, facecolor="white",
                              edgecolor="none", framealpha=1)
    panels[-1].set_ylabel(CLOCKS[clock])
    if numeric:
        at_values(panels[0], sorted({number(row[keys[-1]]) for row in rows}))
    tell_curves(panels[0], len(shown) if numeric else 0)
    fig.text(0.995, 0.005, where(notes), ha="right", va="bottom", fontsize=7.5, color=GREY)
    return fig


def cost_of(seconds, errors, wanted):
    """As the program tells it: seconds where the line between two runs comes down to an error, and
    no dearer run errs more; NaN where runs do not reach it, or all have."""
    good = usable(seconds) & usable(errors)
    order = np.argsort(seconds[good], kind="stable")
    t, e = np.log(seconds[good][order]), np.log(errors[good][order])
    above = np.flatnonzero(e > np.log(wanted))
    if above.size == 0 or above[-1] + 1 == e.size:
        return np.nan
    k = above[-1]
    return float(np.exp(t[k] + (t[k + 1] - t[k]) * (np.log(wanted) - e[k]) / (e[k + 1] - e[k])))


def tell_seconds(axes, seconds, errors, colour):
    """Where a curve passes a guide line, its seconds."""
    for wanted in GUIDES:
        cost = cost_of(seconds, errors, wanted)
        if np.isfinite(cost):
            axes.plot(wanted, cost, "o", ms=9, mfc="none", mec=colour, mew=1.2, zorder=4)
            axes.annotate(f"{cost:.2g} s", (wanted, cost), (7, 6), textcoords="offset points",
                          fontsize=10, color=colour, zorder=5,
                          bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 0.5})


def guide(axes):
    """Lines at errors of round shares, as far as they are among the curves or just beside them."""
    low, high = axes.get_xlim()
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda error, _: f"{100 * error:g} %"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    for wanted in GUIDES:
        if 0.5 * low < wanted < 2 * high:
            axes.axvline(wanted, color=INK, lw=0.8, ls=(0, (4, 3)), zorder=0.9)  # over grids
            axes.text(wanted, 1.0, f"{100 * wanted:g} %", transform=axes.get_xaxis_transform(),
                      ha="center", va="bottom", fontsize=10, color=INK)


def tell_curves(axes, curves):
    """Many curves leave room for a legend below them alone."""
    if curves <= 4:
        return axes.legend(loc="best", fontsize=9)
    low, high = axes.get_ylim()
    axes.set_ylim(low * (low / high) ** (0.08 * curves), high)
    return axes.legend(loc="lower right", fontsize=9)


def clock_of(notes):
    """That of the processor where one thread was at work: it stands while others are served."""
    return "processor_seconds" if notes.get("threads") == "1" else "seconds"


def where(notes):
    """The machine, and whether others were at work on it."""
    machine = notes.get("machine", "").split(", Linux")[0]
    return machine + (f"; load {notes['load'].split()[0]}" if "load" in notes else "")


def usable(value):
    return (0 < value) & (value < np.inf)


def grouped(rows, keys):
    """Runs that differ in the last key alone, under the values of the others."""
    groups = {}
    for row in rows:
        groups.setdefault(", ".join(row[key] for key in keys[:-1]), []).append(row)
    return list(groups.items())


def slope(key, h, e):
    """Between flows that differ there is no order."""
    if key.startswith("flow."):
        return ""
    good = [usable(a) and usable(b) for a, b in zip(h, e)]
    if sum(good) < 2 or np.ptp(np.log(h[good])) == 0:
        return ""
    return f",  order {np.polyfit(np.log(h[good]), np.log(e[good]), 1)[0]:.2f}"


def said(name):
    return WORDS.get(name, name.removesuffix("_max").replace("_", " "))


def title(notes):
    return notes.get("scene", "").strip()


def at_values(axes, values):
    if 0 < values[0] and len(values) <= 8:
        axes.set_xticks(values, labels=[f"{v:g}" for v in values])
        axes.set_xticks([], minor=True)


def finish(panels, key, numeric, error):
    if numeric:
        panels[0].set(xscale="log", yscale="log", xlabel=key, ylabel=error)
    last = panels[-1]
    last.set(xscale="log", yscale="log", xlabel=error)
    last.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    last.yaxis.set_major_formatter(FuncFormatter(lambda seconds, _: f"{seconds:g}"))
    last.yaxis.set_minor_formatter(NullFormatter())
    if not numeric:
        last.legend(loc="best", fontsize=9)
    for axes in panels:
        axes.grid(which="minor", lw=0.3)
        axes.margins(0.08, 0.15)
    note(last, "better: left and down", 0.02, 0.02, color=INK, fontsize=8.5)


main("sweep.png", draw)
