"""Where the time of a step goes, phase by phase, and what it is by other ways to sum and to merge."""

from _bench import legend_below
from _phases import COLOURS, WORDS
from _style import GREY, INK, Nothing, figure, main
from _table import read_table

VARIANTS = {"fmm": "as the scene has it", "boxes": "velocities box-to-point",
            "direct": "velocities over all pairs", "unmerged": "blobs never merge"}
TEXTS = ("flow", "variant", "phase", "counts")
BEYOND = 1.25  # a bar is cut where it is longer than so many times the longest of the others


def draw(run):
    notes, rows = read_table(run.file("step.csv"), TEXTS, "step")
    rows = [row for row in rows if row["threads"] == 1]
    flows = {}
    for row in rows:
        flows.setdefault(row["flow"], {}).setdefault(row["variant"], []).append(row)
    if not flows:
        raise Nothing
    names = [row["phase"] for row in next(iter(next(iter(flows.values())).values()))
             if row["phase"] != "step"]
    colours = {name: GREY if name == "output" else COLOURS[k % len(COLOURS)]
               for k, name in enumerate(names)}
    bars = sum(map(len, flows.values()))
    fig = figure(8.6, 1.4 + 0.27 * bars + 0.42 * len(flows), "Where the time of a step goes, by one thread")
    panels = fig.subplots(len(flows), 1, squeeze=False,
                          height_ratios=[len(variants) + 0.9 for variants in flows.values()])[:, 0]
    for axes, (flow, variants) in zip(panels, flows.items()):
        panel(axes, flow, variants, colours)
    panels[-1].set_xlabel("milliseconds a step")
    handles = [panels[0].barh(0, 0, color=colour) for colour in colours.values()]
    machine = notes.get("machine", "").split(", Linux")[0]
    legend_below(fig, handles, [WORDS.get(name, name) for name in colours],
                 f"{machine}; commit {notes.get('commit', '')}")
    return fig


def whole(parts):
    return next(row for row in parts if row["phase"] == "step")


def panel(axes, flow, variants, colours):
    """The bars of one flow. What takes many times as long as all others is cut, and says so."""
    totals = sorted(1e3 * whole(parts)["seconds"] for parts in variants.values())
    others = totals[-2] if len(totals) > 1 else totals[-1]
    end = min(totals[-1], BEYOND * others)
    usual = 1e3 * whole(next(iter(variants.values())))["seconds"]
    for place, parts in enumerate(variants.values()):
        bar(axes, place, parts, colours, end, usual)
    axes.set_yticks(range(len(variants)), [VARIANTS.get(name, name) for name in variants])
    axes.set_ylim(len(variants) - 0.4, -0.6)
    axes.set_xlim(0, 1.5 * end)
    axes.grid(axis="y", visible=False)
    axes.tick_params(axis="y", length=0)
    axes.set_title(flow, loc="left", fontweight="bold", fontsize=11)


def bar(axes, place, parts, colours, end, usual):
    left = 0.0
    for row in parts:
        if row["phase"] == "step":
            continue
        width = min(1e3 * row["seconds"], end - left)
        axes.barh(place, width, left=left, height=0.74, color=colours[row["phase"]])
        left += width
    step = whole(parts)
    total = 1e3 * step["seconds"]
    cut = total > end * (1 + 1e-9)
    if cut:
        for at in (0.965, 0.98):
            axes.plot([at * end - 0.006 * end, at * end + 0.006 * end], [place + 0.45, place - 0.45],
                      color="white", lw=2.2)
    blobs = f"{step['blobs']:,.0f}".replace(",", " ")
    times = f"{total:.3g} ms, {total / usual:.0f} times as long; " if cut else ""
    axes.text(left, place, f"  {times}{blobs} blobs, {1e-3 * step['ns']:.3g} µs each",
              va="center", fontsize=9, color=INK)


main("step_phases.png", draw)
