#!/usr/bin/python3
"""Writes methods_phases.csv anew: what a run by each method has paid, and for what.

    ./vortree run SCENE method=METHOD ... --out RUN       one for each method
    cases/phases.py RUN...

A row for each number of its summary.json: particles at most, steps, particle-steps, bytes of memory
at most, seconds of the processor, and seconds by phase.
"""

import csv
import json
import sys
from pathlib import Path

TABLE = Path(__file__).resolve().parent / "methods_phases.csv"
NAMES = ("method", "what", "number")
NOTE = "# Written by cases/phases.py from what a run by each method has left.\n"
TOLD = ("steps", "particle_steps", "peak_bytes", "processor_seconds")


def rows_of(summary):
    most = next(name for name in summary if name.startswith("largest_") and name.endswith("_count"))
    yield "particles", summary[most]
    for name in TOLD:
        yield name, summary[name]
    for phase, seconds in summary["seconds"].items():
        if phase != "total":
            yield f"seconds {phase}", seconds


def main():
    runs = [json.loads((Path(run) / "summary.json").read_text()) for run in sys.argv[1:]]
    if not runs:
        sys.exit(__doc__)
    with TABLE.open("w") as file:
        file.write(NOTE)
        table = csv.writer(file, lineterminator="\n")
        table.writerow(NAMES)
        for summary in runs:
            table.writerows((summary["method"], *row) for row in rows_of(summary))


main()
