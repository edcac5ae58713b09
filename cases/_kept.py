"""Tables that are kept beside this file: of what runs have left, by a script each."""

import csv
import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent

def summaries(usage):
    """The summary.json of each run that the command line names."""
    runs = [json.loads((Path(run) / "summary.json").read_text()) for run in sys.argv[1:]]
    if not runs:
        sys.exit(usage)
    return runs


def read(table):
    """Rows of a table as it is kept, by their first column."""
    rows = {}
    if (HERE / table).exists():
        lines = (HERE / table).read_text().splitlines()
        for row in csv.DictReader(line for line in lines if not line.startswith("#")):
            rows.setdefault(next(iter(row.values())), []).append(tuple(row.values()))
    return rows


def write(table, script, names, rows):
    with (HERE / table).open("w") as file:
        file.write(f"# Written by cases/{script} from what runs have left.\n")
        lines = csv.writer(file, lineterminator="\n")
        lines.writerow(names)
        lines.writerows(rows)
