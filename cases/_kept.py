"""Tables that are kept beside this file: of what runs have left, by a script each."""

import csv
import json
import sys
from pathlib import Path


def summaries(usage):
    """The summary.json of each run that the command line names."""
    runs = [json.loads((Path(run) / "summary.json").read_text()) for run in sys.argv[1:]]
    if not runs:
        sys.exit(usage)
    return runs


def write(table, script, names, rows):
    with (Path(__file__).resolve().parent / table).open("w") as file:
        file.write(f"# Written by cases/{script} from what runs have left.\n")
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(names)
        lines.writerows(rows)
