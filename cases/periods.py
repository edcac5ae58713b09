#!/usr/bin/python3
"""Writes plunging_naca0012.csv anew: mean forces on a foil that plunges.

    ./vortree run SCENE ... --out RUN       one for each row
    cases/periods.py RUN...

A row a run: k = 2 pi f c/U, what the scene had of accuracy, steps a period and edge; the mean drag
of the last two whole periods by impulse and at the wall, and by how much it rose, by impulse, from
the first of them to the second; particles at most, seconds of the processor.
"""

import csv
import json
import math
import sys
import tomllib
from pathlib import Path

import h5py
from _kept import write

NAMES = ("k", "method", "accuracy", "steps", "edge", "drag_impulse", "drag_wall", "rise",
         "particles", "processor_seconds")


def scene_of(run):
    with h5py.File(run / "frames.h5") as file:
        text = file.attrs["resolved"]
    return tomllib.loads(text if isinstance(text, str) else text.decode())


def mean(rows, name):
    return math.fsum(float(row[name]) for row in rows) / len(rows)


def last_two_periods(run, steps):
    with (run / "report.csv").open() as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    whole = len(rows) // steps * steps
    return rows[whole - 2 * steps:whole - steps], rows[whole - steps:whole]


def row_of(run):
    scene, summary = scene_of(run), json.loads((run / "summary.json").read_text())
    steps = round(1 / (scene["plunge"]["frequency"] * scene["time"]["dt"]))
    before, last = last_two_periods(run, steps)
    most = next(name for name in summary if name.startswith("largest_") and name.endswith("_count"))
    length, speed = scene["body"]["chord"], math.hypot(*scene["flow"]["stream"])
    return (f"{2 * math.pi * scene['plunge']['frequency'] * length / speed:.12g}",
            scene["method"], scene["accuracy"], steps, scene["body"].get("edge", ""),
            mean(before + last, "cd_impulse"), mean(before + last, "cd_wall"),
            mean(last, "cd_impulse") - mean(before, "cd_impulse"),
            summary[most], summary["processor_seconds"])


runs = [Path(name) for name in sys.argv[1:]]
if not runs:
    sys.exit(__doc__)
write("plunging_naca0012.csv", "periods.py", NAMES, [row_of(run) for run in runs])
