"""What the figures of the velocity bench share: its table, and a colour for each method."""

import numpy as np
from _style import BLUE, GREEN, GREY, ORANGE, RED
from _table import read_table

METHODS = {"fmm": ("fast multipole method", BLUE, "o"), "boxes": ("box-to-point", ORANGE, "s"),
           "grid": ("Fourier grid", GREEN, "D"), "direct": ("direct sum", GREY, "^")}
SETS = {"uniform": "uniform", "ringwake": "ring and wake", "hard": "hard: clusters down to $10^{-10}$",
        "blobs": "blobs, cores two spacings wide"}
WORDS = ("set", "method", "phases")


class Bench:
    """Rows of velocity.csv, and what its notes say."""

    def __init__(self, run):
        self.path = run.file("velocity.csv")

        def part_phases(row):
            row["phases"] = {name: float(seconds) for name, seconds in
                             (part.split("=") for part in row["phases"].split(";") if part)}

        self.notes, self.rows = read_table(self.path, WORDS, "velocity", part_phases)

    def select(self, **wanted):
        return [row for row in self.rows if all(same(row[key], value)
                                                for key, value in wanted.items())]

    def values(self, name, **wanted):
        return sorted({row[name] for row in self.select(**wanted) if row[name] == row[name]})

    @property
    def sets(self):
        return [name for name in SETS if self.select(set=name)]

    @property
    def methods(self):
        known = [name for name in METHODS if self.select(method=name)]
        return known + sorted({row["method"] for row in self.rows} - set(known))

    @property
    def where(self):
        """Machine, commit, and whether others were at work."""
        machine = self.notes.get("machine", "").split(", Linux")[0]
        commit = self.notes.get("commit", "")
        return f"{machine}; commit {commit}" if commit else machine


def legend_below(fig, handles, labels, where):
    """One row or two under the panels, and where the numbers come from."""
    columns = min(len(labels), 4)
    lines = -(-len(labels) // columns)
    room = (0.30 * lines + 0.25) / fig.get_figheight()
    fig.get_layout_engine().set(rect=(0, room, 1, 1 - room))
    fig.legend(handles, labels, loc="lower center", bbox_to_anchor=(0.5, 0.2 / fig.get_figheight()),
               ncol=columns, handlelength=2.2, columnspacing=1.6)
    fig.text(0.99, 0.06 / fig.get_figheight(), where, ha="right", va="bottom", fontsize=8,
             color=GREY)


def same(one, other):
    return one == other or (isinstance(other, float) and one != one and other != other)


def look(method):
    """Name, colour and marker of a method."""
    return METHODS.get(method, (method, RED, "v"))


def nanoseconds(rows):
    """Of a sum, for each blob."""
    return np.array([1e9 * row["seconds"] / row["n"] for row in rows])


def power(n):
    """n as readers write it: 10^6, 4 x 10^6, 10^-3, 1234."""
    exponent = int(np.floor(np.log10(n) + 1e-9))
    factor = n / 10 ** exponent
    if abs(factor - round(factor)) > 1e-9:
        return f"{n:,.0f}"
    return f"$10^{{{exponent}}}$" if round(factor) == 1 else f"${factor:.0f}\\times10^{{{exponent}}}$"
