"""What the figures of the neighbor bench share: its table, and a colour for each method."""

import numpy as np
from _style import BLUE, GREEN, GREY, INK, ORANGE, RED, SKY, Broken
from _table import read_table

METHODS = {"qcg": ("QCG", BLUE, "o"), "level-grids": ("one grid a level", SKY, "s"),
           "uniform-grid": ("one grid, vector tests", GREEN, "D"),
           "linked-list": ("linked list (the paper's)", RED, "v"),
           "leaf-quadtree": ("quadtree, one particle a leaf", ORANGE, "^"),
           "r-tree": ("R-tree of Boost", "#cc79a7", "P"), "all-pairs": ("all pairs", GREY, "x")}
WORDS = ("family", "set", "order", "method", "rule", "listing")


class Bench:
    """Rows of neighbors.csv, and what its notes say."""

    def __init__(self, run):
        self.path = run.file("neighbors.csv")
        self.notes, self.rows = read_table(self.path, WORDS, "neighbor")

    def select(self, **wanted):
        """Rows by rule max, both ways, shuffled, one thread, unless it is said otherwise; few
        particles first."""
        wanted = {"rule": "max", "listing": "both", "order": "shuffled", "threads": 1.0, **wanted}
        try:
            rows = [row for row in self.rows if all(row[key] in value if isinstance(value, tuple)
                                                    else row[key] == value
                                                    for key, value in wanted.items())]
        except KeyError as name:
            raise Broken(f"{self.path}: has no column {name}") from None
        return sorted(rows, key=lambda row: row["n"])

    @property
    def where(self):
        machine = self.notes.get("machine", "").split(", Linux")[0]
        commit = self.notes.get("commit", "")
        return f"{machine}; commit {commit}" if commit else machine


def columns(rows, name):
    return np.array([row["n"] for row in rows]), np.array([row[name] for row in rows])


def slope(axes, n, start, exponent, words):
    """A line of a given power of n from a point, with its name at the end."""
    n = np.array(n, dtype=float)
    y = start * (n / n[0]) ** exponent
    axes.plot(n, y, color=INK, lw=0.8, ls="--", alpha=0.6)
    axes.annotate(words, (n[-1], y[-1]), xytext=(3, 0), textcoords="offset points", fontsize=9.5,
                  va="center", color=INK, alpha=0.8)


def signed(fig, bench, handles=(), labels=(), ncol=4):
    """Legend under the panels, and where the numbers come from."""
    lines = -(-len(labels) // ncol)
    room = (0.27 * lines + 0.2) / fig.get_figheight()
    fig.get_layout_engine().set(rect=(0, room, 1, 1 - room))
    if labels:
        fig.legend(handles, labels, loc="lower center", ncol=ncol, handlelength=2.4,
                   bbox_to_anchor=(0.5, 0.16 / fig.get_figheight()))
    fig.text(0.99, 0.04 / fig.get_figheight(), bench.where, ha="right", va="bottom", fontsize=8,
             color=GREY)
