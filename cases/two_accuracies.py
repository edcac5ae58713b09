#!/usr/bin/python3
"""Writes two_accuracies.csv anew: what bodies of all kinds come to at two accuracies.

    ./vortree run SCENE accuracy=COARSE,FINE --overwrite    for those that are to be told anew
    cases/two_accuracies.py [RUNS]                          RUNS: runs/ beside this folder

A row a scene, check and accuracy: what was asked, what was reached, and the seconds of the run, from
the summary.json that the sweep has left of it. Scenes without such runs in RUNS keep their rows.
"""

import json
import sys
from pathlib import Path

from _kept import HERE, read, write

TABLE = "two_accuracies.csv"
NAMES = ("scene", "accuracy", "what", "asked", "reached", "seconds")


def rows_of(scene, folder):
    """Of each accuracy, the coarsest first."""
    runs = sorted(folder.glob("accuracy=*"), key=lambda run: -float(run.name.split("=")[1]))
    for run in runs:
        summary = json.loads((run / "summary.json").read_text())
        for what, found in summary["check"].items():
            if what != "passed" and found["reached"] is not None:
                yield (scene, run.name.split("=")[1], what, found["asked"], found["reached"],
                       summary["seconds"]["total"])


def main():
    runs = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent / "runs"
    told = read(TABLE)
    for scene in sorted(path.stem for path in HERE.glob("*.toml")):
        if list((runs / scene).glob("accuracy=*/summary.json")):
            told[scene] = list(rows_of(scene, runs / scene))
    write(TABLE, "two_accuracies.py", NAMES, [row for scene in sorted(told) for row in told[scene]])


main()
