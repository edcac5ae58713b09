#!/usr/bin/python3
"""Writes reached.csv anew: what the scenes of this folder came to when they were run.

    ./vortree run SCENE --overwrite     for those that are to be told anew, into runs/SCENE
    cases/reached.py [RUNS]             RUNS: runs/ beside this folder

A row a scene and check: what was asked, what was reached, from the summary.json of its run; and the
particles at the end. Scenes that have no finished run in RUNS keep their rows. Seconds and memory
are the machine's, and are not kept.
"""

import csv
import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
TABLE = HERE / "reached.csv"
NAMES = ("scene", "what", "asked", "reached")
NOTE = "# Written by cases/reached.py from what `./vortree run SCENE` has left of each scene.\n"


def kept():
    if not TABLE.exists():
        return []
    with TABLE.open() as file:
        return [tuple(row.values()) for row in csv.DictReader(line for line in file
                                                              if not line.startswith("#"))]


def rows_of(scene, summary):
    particles = "blobs" if "blobs" in summary else "particles"
    yield scene, particles, "", summary[particles]
    for what, found in summary["check"].items():
        if what != "passed" and found["reached"] is not None:
            yield scene, what, found["asked"], found["reached"]


def main():
    runs = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent / "runs"
    told = {}
    for scene in sorted(path.stem for path in HERE.glob("*.toml")):
        told[scene] = [row for row in kept() if row[0] == scene]
        summary = runs / scene / "summary.json"
        if summary.exists():
            told[scene] = list(rows_of(scene, json.loads(summary.read_text())))
    with TABLE.open("w") as file:
        file.write(NOTE)
        table = csv.writer(file, lineterminator="\n")
        table.writerow(NAMES)
        for rows in told.values():
            table.writerows(rows)


main()
