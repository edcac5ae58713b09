"""How many particles the run carries, and where the seconds go."""

import json

import numpy as np
from _phases import phases
from _style import INK, Broken, Nothing, figure, main

MOST_IN_A_LINE = 5  # words of the legend


def particles(report):
    """What the method calls them: their number is the first that it measures."""
    return list(report)[2]


def draw(run):
    report = run.report
    if report["t"].size < 2:
        raise Nothing
    bodied = "body" in run.scene
    time = report["T"] if bodied else report["t"]
    fig = figure(7.2, 5.4, title(run))
    top, bottom = fig.subplots(2, 1, sharex=True)
    what = particles(report)
    thousands = report[what].max() >= 2000
    top.plot(time, report[what] / (1e3 if thousands else 1), color=INK, lw=1.6)
    top.set_ylabel(f"{what}  [thousand]" if thousands else what)
    top.set_ylim(0, None)
    top.set_xlim(time[0], time[-1])

    width = time.size // 20
    layers = np.array([smoothed(report[f"seconds_{phase}"], width) for phase, *_ in phases(report)])
    unit, size = ("s", 1) if layers.sum(axis=0).max() >= 2 else ("ms", 1e3)
    bottom.stackplot(time, size * layers, labels=[name for _, name, _ in phases(report)],
                     colors=[colour for *_, colour in phases(report)], lw=0, step="mid")
    bottom.legend(loc="lower left", bbox_to_anchor=(-0.01, 0.99),
                  ncol=min(len(layers), MOST_IN_A_LINE), handlelength=1.1, columnspacing=1.4)
    averaged = f",\nmean over {2 * (width // 2) + 1} steps" if width > 1 else ""
    bottom.set_ylabel(f"time per step  [{unit}]{averaged}", linespacing=1.3)
    bottom.set_ylim(0, None)
    bottom.set_xlabel("time  $T = Ut/R$" if bodied else "time  $t$")
    return fig


def title(run):
    """From summary.json, which an unfinished run does not have yet."""
    report = run.report
    what = particles(report)
    seconds, threads = report["seconds"][-1], None
    path = run.folder / "summary.json"
    if path.exists():
        try:
            summary = json.loads(path.read_text())
            seconds, threads = summary["seconds"]["total"], summary["threads"]
        except (OSError, ValueError, KeyError, TypeError):
            raise Broken(f"{path}: not the summary of a run") from None
    words = f"{report['t'].size} steps, at most {report[what].max():,.0f} {what}, {seconds:.3g} s"
    return words + (f" on {threads} thread{'s'[:threads > 1]}" if threads else "")


def smoothed(values, width):
    """Mean over the nearest steps, the ends repeated."""
    half = width // 2
    window = np.ones(2 * half + 1) / (2 * half + 1)
    return np.convolve(np.pad(values, half, mode="edge"), window, mode="valid")


main("cost.png", draw)
