"""The folder of a sweep: its table, and the runs in it."""

import csv
import statistics

from _style import Broken, Nothing, Run

WORDS = {"flow.reynolds": "Re", "vortex": "vortices", "sph": "SPH"}


def read(path):
    """Notes and rows of sweep.csv; all stays text."""
    try:
        lines = path.read_text().splitlines()
    except (OSError, UnicodeDecodeError):
        raise Broken(f"{path}: cannot be read") from None
    notes = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# ") and ": " in line)
    rows = list(csv.DictReader((line for line in lines if line and not line.startswith("#")),
                               quotechar="'"))
    if not rows:
        raise Nothing
    return notes, rows


def keys_of(rows):
    """What was swept."""
    names = list(rows[0])
    return names[:names.index("steps")]


def number(word):
    try:
        return float(word)
    except (TypeError, ValueError):
        return float("nan")


def medians(rows, key="seed"):
    """Rows that differ in the seed alone as one, with the medians of their numbers."""
    if key not in rows[0]:
        return rows
    swept = [name for name in keys_of(rows) if name != key]
    same = {}
    for row in rows:
        same.setdefault(tuple(row[name] for name in swept), []).append(row)
    return [{name: words[name] if name in swept else statistics.median(
        number(row[name]) for row in group) for name in words if name != key}
        for group in same.values() for words in group[:1]]


def folder_of(row, keys):
    """As the program names it: src/app/commands/sweep/sweep.cpp."""
    name = ",".join(f"{key}={row[key]}" for key in keys)
    return name.translate(str.maketrans('/ "', "___"))


def by_method(run):
    """[(words, {method: its run})] of flows that several methods have computed, in the order of the
    sweep; Nothing if there are none. What differs beside the method and the flow is in the words."""
    _, rows = read(run.file("sweep.csv"))
    keys = keys_of(rows)
    if "method" not in keys:
        raise Nothing
    flows = {}
    for row in rows:
        if number(row["steps"]) > 0:
            same = ", ".join(f"{WORDS.get(k, k)} = {row[k]}" for k in keys
                             if k not in ("method", "seed"))
            flows.setdefault(same, {}).setdefault(row["method"],
                                                  Run(run.folder / folder_of(row, keys)))
    several = [(words, runs) for words, runs in flows.items() if len(runs) > 1]
    if not several:
        raise Nothing
    return several


def of_last_frame(run, pick):
    """pick(group) of the last frame; what is missing there is damage."""
    with run.hdf5("frames.h5") as file:
        names = [name for name in file if name.startswith("frame_")]
        if not names:
            raise Nothing
        try:
            return pick(file[max(names)])
        except (KeyError, OSError, StopIteration):
            raise Broken(f"{run.folder / 'frames.h5'}: a frame is damaged") from None


def title(run):
    """Of the scene, without what it says of its keys."""
    return run.scene.get("title", "").partition(":")[0]
