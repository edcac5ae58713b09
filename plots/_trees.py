"""What the figures of the tree bench share: its tables, and a look for each way to a tree."""

from _style import BLUE, GREEN, GREY, ORANGE, RED, SKY
from _table import read_table

BUILDERS = {"partition": ("forward by partition", ORANGE, "s"),
            "forward": ("forward on sorted codes", RED, "D"),
            "printed": ("reverse as printed", GREY, "^"),
            "printed_known": ("reverse as printed, depth known", "#555555", "v"),
            "climb": ("reverse, families climbing", SKY, "P"),
            "reverse": ("reverse in one pass", BLUE, "o")}
SETS = {"uniform": "uniform", "ringwake": "ring and wake",
        "hard": "hard: clusters down to $10^{-10}$"}
PARTS = {"enclose": ("enclose", GREY), "encode": ("encode", SKY), "sort": ("sort", GREEN),
         "build": ("build", BLUE), "finish": ("order inside cells", ORANGE)}
USUAL = 50
WORDS = ("set", "builder", "stored")


class Table:
    """Rows of a table of the tree bench, and what its notes say."""

    def __init__(self, run, name):
        self.notes, self.rows = read_table(run.file(name), WORDS, "tree")

    def select(self, **wanted):
        return [row for row in self.rows if all(row[key] == value
                                                for key, value in wanted.items())]

    def line(self, **wanted):
        return sorted(self.select(**wanted), key=lambda row: row["n"])

    def values(self, name, **wanted):
        return sorted({row[name] for row in self.select(**wanted)})

    @property
    def where(self):
        machine = self.notes.get("machine", "").split(", Linux")[0]
        commit = self.notes.get("commit", "")
        return f"{machine}; commit {commit}" if commit else machine


def words(name):
    """A set's name for readers."""
    if name.startswith("flow_t"):
        return f"cylinder flow, $t = {float(name[6:]):g}$"
    return SETS.get(name, name)
