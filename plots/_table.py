"""Reads the table that a bench wrote: its rows, and what its notes say."""

import csv

from _style import Broken, Nothing


def read_table(path, words, bench, finish=lambda row: None):
    """Notes and rows of a table. Columns in `words` stay text, all others are numbers; `finish` may
    turn more of a row into values. A last line cut short by a kill is left out."""
    try:
        text = path.read_text()
    except (OSError, UnicodeDecodeError):
        raise Broken(f"{path}: cannot be read") from None
    lines = text.splitlines()
    notes = dict(line[2:].split(": ", 1) for line in lines
                 if line.startswith("# ") and ": " in line)
    table = list(csv.DictReader(line for line in lines if line and not line.startswith("#")))
    if table and not text.endswith("\n"):
        table.pop()
    try:
        rows = [{name: word if name in words else float(word or "nan")
                 for name, word in row.items()} for row in table]
        for row in rows:
            finish(row)
    except (TypeError, ValueError, KeyError, AttributeError):
        raise Broken(f"{path}: not a table of the {bench} bench") from None
    if not rows:
        raise Nothing
    return notes, rows
