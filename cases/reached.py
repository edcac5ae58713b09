#!/usr/bin/python3
"""Writes reached.csv anew: what the scenes of this folder came to when they were run.

    ./vortree run SCENE --overwrite     for those that are to be told anew, into runs/SCENE
    cases/reached.py [RUNS]             RUNS: runs/ beside this folder

A row a scene and check: what was asked, what was reached, from the summary.json of its run; and the
particles at the end. Scenes that have no finished run in RUNS keep their rows. Seconds and memory
are the machine's, and are not kept.
"""

import json
import sys
from pathlib import Path

from _kept import HERE, read, write

TABLE = "reached.csv"
NAMES = ("scene", "what", "asked", "reached")


def rows_of(scene, summary):
    particles = "blobs" if "blobs" in summary else "particles"
    yield scene, particles, "", summary[particles]
    for what, found in summary["check"].items():
        if what != "passed" and found["reached"] is not None:
            yield scene, what, found["asked"], found["reached"]


def main():
    runs = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent / "runs"
    kept, rows = read(TABLE), []
    for scene in sorted(path.stem for path in HERE.glob("*.toml")):
        summary = runs / scene / "summary.json"
        told = rows_of(scene, json.loads(summary.read_text())) if summary.exists() else None
        rows += told or kept.get(scene, [])
    write(TABLE, "reached.py", NAMES, rows)


main()
