"""What a run has left in its folder, as values that two runs can be compared by: all but seconds."""

import csv
import json
from functools import partial

import h5py
import numpy as np


def rows_of(folder, table):
    with open(folder / table) as file:
        return [{name: value for name, value in row.items() if "seconds" not in name}
                for row in csv.DictReader(file)]


def seconds_of(folder):
    """Which columns of report.csv are wall time."""
    with open(folder / "report.csv") as file:
        return np.array(["seconds" in name for name in next(csv.reader(file))])


def timeless(name, values, seconds):
    """A dataset of a frame without what the clock put in."""
    if name == "state/rows of report.csv":
        values = values.reshape(-1, seconds.size).copy()
        values[:, seconds] = 0
    elif name.startswith(("state/row seconds", "state/total seconds")):
        values = 0 * values
    elif name == "state/mark of report.csv":
        values = values[:1]  # how many rows: bytes and checksum depend on the seconds
    return values


def datasets(file, keep=lambda name, values: values):
    found = {}

    def visit(name, thing):
        if name.endswith("/total processor_seconds"):
            return
        if isinstance(thing, h5py.Dataset):
            inside = name.split("/", 1)[1]
            values = np.asarray(keep(inside, thing[()]))
            found[name] = (values.shape, values.dtype.str, values.tobytes())
        elif name.count("/") == 0:
            for key in ("step", "time"):
                if key in thing.attrs:
                    found[f"{name}.{key}"] = thing.attrs[key]

    file.visititems(visit)
    return found


def summary_of(folder):
    told = json.loads((folder / "summary.json").read_text())
    for name in ("seconds", "processor_seconds", "particle_steps_per_second", "peak_bytes", "scene",
                 "threads", "provenance"):
        told.pop(name, None)
    return told


def contents(folder):
    """By file name; a file that is not there is missing here, too."""
    found = {}
    for table in ("report.csv", "wall.csv", "energy.csv", "probes.csv"):
        if (folder / table).exists():
            found[table] = rows_of(folder, table)
    with h5py.File(folder / "frames.h5") as file:
        found["frames.h5"] = datasets(file, partial(timeless, seconds=seconds_of(folder)))
    if (folder / "fields.h5").exists():
        with h5py.File(folder / "fields.h5") as file:
            found["fields.h5"] = datasets(file)
    for page in ("frames.xdmf", "fields.xdmf", "outline.csv"):
        if (folder / page).exists():
            found[page] = (folder / page).read_text()
    found["summary.json"] = summary_of(folder)
    found["files"] = sorted(path.name for path in folder.iterdir())
    return found


def difference(a, b):
    """In words, the first one; empty if there is none."""
    for name in sorted(set(a) | set(b)):
        if a.get(name) == b.get(name):
            continue
        one, other = a.get(name), b.get(name)
        if isinstance(one, dict) and isinstance(other, dict):
            keys = [key for key in sorted(set(one) | set(other)) if one.get(key) != other.get(key)]
            return f"{name}: {', '.join(keys[:4])}"
        if isinstance(one, list) and isinstance(other, list):
            return f"{name}: {len(one)} and {len(other)} entries: {set(map(str, one)) ^ set(map(str, other))}"[:300]
        return f"{name} differs or is missing"
    return ""
