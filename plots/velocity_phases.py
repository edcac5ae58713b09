"""Where the time of a sum goes, and how near the machine's floor its parts are."""

import numpy as np
from _bench import SETS, Bench, legend_below, power
from _style import BLUE, GREEN, GREY, INK, ORANGE, RED, SKY, Nothing, figure, main

NEAR = ("near sums and evaluation", BLUE)
PHASES = {"plan": ("plan", GREY), "tree": ("sort and tree", GREEN),
          "upward": ("multipoles upward", SKY), "far": ("far: translations", ORANGE),
          "near": NEAR, "evaluate": NEAR, "spread": ("spread", "#cc79a7"),
          "transform": ("transforms", RED), "gather": ("gather", "#c8b900")}
FLOORS = {"tree": ("sort", "tree_floor"), "near": ("near", "near_floor"),
          "evaluate": ("near", "near_floor")}
TOLERANCES = (1e-3, 1e-6, 1e-12)


def draw(run):
    bench = Bench(run)
    rows = chosen(bench)
    fig = figure(8.6, 1.9 + 0.235 * len(rows) + 0.2 * len(bench.sets),
                 f"{power(rows[0]['n'])} vortices, one thread: where the time goes")
    axes = fig.subplots()
    place, places, previous = -0.7, [], None
    for row in rows:
        place += 1.0 if row["set"] == previous else 1.8
        if row["set"] != previous:
            axes.text(0.0, place - 0.9, f" {SETS[row['set']]}", fontweight="bold", va="center")
        previous = row["set"]
        places.append(place)
        bar(axes, row, place)
    axes.set_yticks(places, [f"{row['method']}  {power(row['tolerance'])}" for row in rows])
    axes.set_ylim(place + 0.7, -0.5)
    axes.set_xlim(0, 1.22 * max(1e9 * row["seconds"] / row["n"] for row in rows))
    axes.set_xlabel("time for each vortex  [ns]")
    axes.grid(axis="y", visible=False)
    axes.tick_params(axis="y", length=0)
    used = {PHASES.get(name, (name, INK)): None for row in rows for name in row["phases"]}
    handles = [axes.barh(0, 0, color=colour) for words, colour in used]
    handles.append(axes.plot([], [], "|", color=INK, ms=10, mew=1.6)[0])
    legend_below(fig, handles, [words for words, colour in used] + ["machine's floor"],
                 bench.where)
    return fig


def chosen(bench):
    """One thread, the largest number for which several tolerances were asked."""
    for n in reversed(bench.values("n")):
        rows = [row for row in bench.select(n=n, threads=1) if row["tolerance"] in TOLERANCES]
        if len({row["tolerance"] for row in rows}) > 1:
            return sorted(rows, key=lambda row: (bench.sets.index(row["set"]),
                                                 bench.methods.index(row["method"]),
                                                 -row["tolerance"]))
    raise Nothing


def bar(axes, row, place):
    left, each, words = 0.0, 1e9 / row["n"], []
    for name, seconds in row["phases"].items():
        axes.barh(place, each * seconds, left=left, height=0.78,
                  color=PHASES.get(name, (name, INK))[1])
        word, floor = FLOORS.get(name, (None, None))
        if word and np.isfinite(row[floor]) and seconds > 0:
            axes.plot(left + each * row[floor], place, "|", color=INK, ms=10, mew=1.6)
            words.append(f"{word} {100 * row[floor] / seconds:.0f} %")
        left += each * seconds
    axes.text(left, place, "  " + ", ".join(words), va="center", fontsize=9)


main("velocity_phases.png", draw)
