"""What a step of SPH costs a particle, phase by phase, by finer and finer particles and by ways to
find their neighbors."""

import numpy as np
from _phases import phases
from _style import INK, Nothing, Run, figure, main
from _sweep import folder_of, keys_of, number, read, title

SHOWN = ({"sph.spacing", "neighbors.method"}, {"sph.spacing"}, {"neighbors.method"})
NAMES = {"qcg": "QCG", "linked-list": "linked\nlist"}
BAR, GAP = 0.8, 0.6  # widths


def draw(run):
    _, rows = read(run.file("sweep.csv"))
    keys = keys_of(rows)
    if set(keys) not in SHOWN or len(rows) < 2:
        raise Nothing
    done = [row for row in rows if number(row["steps"]) > 0]
    runs = [(row, Run(run.folder / folder_of(row, keys))) for row in done]
    # What is measured at t = 0 and after the first step does not tell of steps.
    runs = [(row, one) for row, one in runs if one.report["t"].size > 2]
    if len(runs) < 2 or any(one.particle != "particle" for _, one in runs):
        raise Nothing
    fig = figure(max(7.4, 2.2 + 0.95 * len(runs)), 4.6, title(runs[0][1]))
    axes = fig.subplots()
    places, groups = arrange([row.get("sph.spacing", "") for row, _ in runs])
    for k, (at, (row, one)) in enumerate(zip(places, runs)):
        bar(axes, at, one.report, with_words=k == 0)
        if "neighbors.method" in row:
            axes.text(at, -0.015, NAMES.get(row["neighbors.method"], row["neighbors.method"]),
                      ha="center", va="top", fontsize=9, linespacing=1.0,
                      transform=axes.get_xaxis_transform())
    axes.set_xticks([np.mean(places[some]) for some in groups],
                    [words(runs[some.start][1]) for some in groups])
    axes.tick_params(axis="x", length=0, pad=26 if "neighbors.method" in keys else 6)
    axes.set_ylabel("microseconds by the clock, a particle and step")
    axes.grid(axis="x", visible=False)
    axes.set_xlim(places[0] - 0.7, places[-1] + 0.7)
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles[::-1], labels[::-1], loc="center left", bbox_to_anchor=(1.01, 0.5))
    return fig


def arrange(names):
    """Places of the bars, and slices of those that stand together."""
    places, groups = [0.0], [slice(0, 1)]
    for k in range(1, len(names)):
        same = names[k] == names[k - 1] and names[k] != ""
        places.append(places[-1] + (1 if same else 1 + GAP if names[k] else 1))
        groups[-1:] = [slice(groups[-1].start, k + 1)] if same else [groups[-1], slice(k, k + 1)]
    return np.array(places), groups


def bar(axes, at, report, with_words):
    steps = report["particles"][1:].sum()
    height = 0
    for name, label, colour in phases(report):
        spent = 1e6 * report[f"seconds_{name}"][1:].sum() / steps
        axes.bar(at, spent, BAR, bottom=height, color=colour, lw=0,
                 label=label if with_words else None)
        height += spent
    axes.text(at, height, f"{height:.1f}", ha="center", va="bottom", fontsize=10, color=INK)


def words(run):
    count = f"{int(run.report['particles'].max()):,}".replace(",", " ")
    if "body" not in run.scene:
        return f"{count}\nparticles"
    return f"$D/{2 * run.body[0] / run.scene['sph']['spacing']:.3g}$\n{count}\nparticles"


main("sweep_cost.png", draw)
