#!/usr/bin/python3
"""Writes runs/accuracy/accuracy.csv: how far drag and lift are off the references, by accuracy.

    cases/accuracy.py [CASE ...]     runs all cases, or those named, and tells all that lie there
    cases/accuracy.py --table        runs nothing
    cases/accuracy.py --page         prints the tables of accuracy.md from plots/gallery/accuracy
    plots/gallery/remake accuracy/   the figure, and with its table to where they are kept

Runs CASE with each of its accuracies into runs/accuracy/CASE/ACCURACY, by one thread. A row for
each quantity and each T from which it counts: the largest deviation and the T at which it is, root
mean square and mean, particles at the end, seconds of the processor. Drag is relative to the
reference's at the same time, lift to the reference's largest; of a circle at rest, which has none,
to the drag at the same time. Of a vortex in free space the quadrupole is what its [check] has.
"""

import csv
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
from _kept import write

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "plots"))
from _style import Run, interpolated  # noqa: E402

RUNS = ROOT / "runs" / "accuracy"
KEPT = ROOT / "plots" / "gallery" / "accuracy" / "accuracy.csv"
STARTS = (0.2, 0.5)  # T, from which deviations count
NAMES = ("case", "accuracy", "quantity", "from", "to", "largest", "at", "rms", "mean", "particles",
         "processor_seconds")


def circle(reynolds, T, *accuracies):
    return "cylinder", T, accuracies, [f"flow.reynolds={reynolds}"]


# Scene, end T, accuracies, more of the command line. What is dear has few, or ends early.
CASES = {
    "circle_re1": circle(1, 1, 0.02, 0.01, 0.005, 0.0025),
    "circle_re40": circle(40, 3, 0.02, 0.01, 0.005, 0.0025),
    "circle_re200": circle(200, 3, 0.02, 0.01, 0.005, 0.0025),
    "circle_re550": circle(550, 3, 0.04, 0.02, 0.01, 0.005, 0.0025),
    "circle_re1000": circle(1000, 3, 0.04, 0.02, 0.01, 0.005, 0.0025),
    "circle_re3000": circle(3000, 2, 0.04, 0.02, 0.01, 0.005, 0.0025),
    "circle_re9500": circle(9500, 1.5, 0.04, 0.02, 0.01, 0.005),
    "ellipse_re400": ("ellipse_re400", 3, (0.02, 0.01, 0.005, 0.0025), []),
    "plunging_cylinder": ("plunging_cylinder", 3, (0.02, 0.01, 0.005, 0.0025), []),
    "gaussian_ellipse": ("gaussian_ellipse", None, (0.04, 0.02, 0.01, 0.005), []),
}


def run(case):
    scene, T, accuracies, more = CASES[case]
    if T:
        more = [*more, f"time.end={T / 2}", f"output.frames={T / 2}"]
    for accuracy in accuracies:
        # One that misses its [check] says so by its exit code, and is told all the same.
        subprocess.run([ROOT / "vortree", "run", scene, *more, f"accuracy={accuracy}",
                        "output.fields=[]", "--threads", "1", "--overwrite", "--out",
                        RUNS / case / str(accuracy)], cwd=ROOT)


def deviations(one):
    """(quantity, T, deviation) of what a run has a reference for."""
    report, reference = one.report, one.reference("drag_reference")
    T, drag, lift = report["T"], report["cd_impulse"], report["cl_impulse"]
    known = interpolated(reference["T"], reference["C_D"], T)
    yield "drag", T, drag / known - 1
    if "C_L" in reference:
        known = interpolated(reference["T"], reference["C_L"], T)
        yield "lift", T, (lift - known) / np.abs(known[T >= STARTS[0] - 1e-9]).max()
    else:
        yield "lift", T, lift / known


def of_body(one):
    for quantity, T, off in deviations(one):
        for start in STARTS:
            here, counted = T[T >= start - 1e-9], off[T >= start - 1e-9]
            most = np.argmax(np.abs(counted))
            yield (quantity, start, f"{T[-1]:g}", f"{abs(counted[most]):.3e}", f"{here[most]:.3f}",
                   f"{np.sqrt(np.mean(counted ** 2)):.3e}", f"{np.mean(counted):.3e}")


def of_vortex(one, summary):
    off = summary["check"]["quadrupole_max"]["reached"]
    yield "quadrupole", 0, f"{one.report['t'][-1]:g}", f"{off:.3e}", "", "", ""


def rows(case):
    for accuracy in CASES[case][2]:
        one = Run(RUNS / case / str(accuracy))
        path = one.folder / "summary.json"
        if not path.exists():
            continue
        summary = json.loads(path.read_text())
        told = of_body(one) if "body" in one.scene else of_vortex(one, summary)
        for numbers in told:
            yield (case, accuracy, *numbers, summary["blobs"],
                   f"{summary['processor_seconds']:.3g}")


def percent(number):
    """Of two digits, as far as they are more than a ten-thousandth."""
    of_hundred = 100 * float(number)
    return (f"{of_hundred:#.2g}".rstrip(".") if of_hundred > 1e-3 else f"{of_hundred:.4f}") + " %"


def bias(mean):
    return f"{percent(abs(float(mean)))} {'high' if float(mean) > 0 else 'low'}"


def thousands(count):
    return f"{float(f'{count:.2g}'):,.0f}".replace(",", " ") if count >= 1000 else str(count)


def kept():
    """{case: {accuracy: {(quantity, from): line}}}"""
    found = {}
    with KEPT.open() as file:
        for line in csv.DictReader(line for line in file if not line.startswith("#")):
            of_case = found.setdefault(line["case"], {})
            of_case.setdefault(line["accuracy"], {})[line["quantity"], line["from"]] = line
    return found


LAW = {"drag, rms": ("drag", "0.2", "rms"), "drag, largest from T = 0.5 on":
       ("drag", "0.5", "largest"), "drag, largest": ("drag", "0.2", "largest"),
       "lift, rms": ("lift", "0.2", "rms"), "lift, largest": ("lift", "0.2", "largest")}


def print_law(found):
    """Of each error: in how many runs it is no more than the accuracy, and in which it is."""
    for words, (quantity, start, name) in LAW.items():
        runs = [(case, accuracy, float(told[quantity, start][name]))
                for case, runs in found.items() for accuracy, told in runs.items()]
        over = {}
        for case, accuracy, error in runs:
            if error > float(accuracy):
                over.setdefault(case, []).append(accuracy)
        which = "; ".join(f"`{case}` {', '.join(some)}" for case, some in over.items())
        kept_by = len(runs) - sum(map(len, over.values()))
        print(f"| {words} | {kept_by} of {len(runs)} | {which} |")
    print()


def print_runs(case, runs):
    for accuracy, told in runs.items():
        drag, late, lift = told["drag", "0.2"], told["drag", "0.5"], told["lift", "0.2"]
        cells = (f"`{case}`", drag["to"], accuracy, percent(drag["largest"]), drag["at"],
                 percent(drag["rms"]), bias(drag["mean"]), percent(late["largest"]),
                 percent(lift["largest"]), percent(lift["rms"]), thousands(int(drag["particles"])),
                 f"{float(drag['processor_seconds']):.2g}")
        print("|", " | ".join(cells), "|")


SLOPES = (("drag", "0.2", "largest"), ("drag", "0.2", "rms"), ("drag", "0.5", "largest"),
          ("drag", "0.5", "rms"), ("lift", "0.2", "largest"), ("lift", "0.2", "rms"))


def print_slopes(case, runs):
    columns = [[told[quantity, start][name] for told in runs.values()]
               for quantity, start, name in SLOPES]
    slopes = [fitted(runs, column) for column in columns]
    seconds = fitted(runs, [told["drag", "0.2"]["processor_seconds"] for told in runs.values()])
    told = [f"{slope:.1f}" if slope >= 0.05 else "none" for slope in (*slopes, -seconds)]
    print("|", " | ".join([f"`{case}`", *told]), "|")


def fitted(h, e):
    """The slope that fits best, both on logarithmic scales."""
    return np.polyfit(*([math.log(float(v)) for v in values] for values in (h, e)), 1)[0]


def print_page():
    found = kept()
    vortices = found.pop("gaussian_ellipse", {})
    print_law(found)
    for print_table in (print_runs, print_slopes):
        for case, runs in found.items():
            print_table(case, runs)
        print()
    for accuracy, told in vortices.items():
        line = told["quadrupole", "0"]
        print(f"| {accuracy} | {percent(line['largest'])} | {thousands(int(line['particles']))} "
              f"| {float(line['processor_seconds']):.2g} |")


def main():
    words = sys.argv[1:]
    if set(words) - {"--table", "--page", *CASES}:
        sys.exit(__doc__)
    if "--page" in words:
        return print_page()
    if "--table" not in words:
        for case in words or CASES:
            run(case)
    write(RUNS / "accuracy.csv", "accuracy.py", NAMES, (row for case in CASES for row in rows(case)))


main()
