"""Holds tables of measured numbers on the pages to the CSV files beside them.   tables.py ROOT

Every number of such a table is that of its file, as far as it is printed. Seconds, speed and memory
are those of a machine with nothing else to do; they are told on the page and not held. A picture of
the gallery beside which a CSV lies was drawn from it, to the last bit of the file.
"""

import csv
import hashlib
import math
import re
import statistics
import sys
from decimal import Decimal
from pathlib import Path

ROOT = Path(sys.argv[1])
NUMBER = re.compile(r"(?<![\w.^/-])(\d{1,3}(?: \d{3})+|\d+(?:\.\d+)?(?:e[-+]?\d+)?)( %)?(?![\w^])")
failed = []
held = 0


def read(name):
    lines = (line for line in (ROOT / name).read_text().splitlines() if not line.startswith("#"))
    return list(csv.DictReader(lines))


def printed(cell):
    """Numbers of a cell: value, half a unit of the last digit that is printed, both as they are."""
    for digits, percent in NUMBER.findall(cell):
        number = Decimal(digits.replace(" ", ""))
        rounded = number.normalize() if " " in digits else number  # thousands are
        last = rounded.as_tuple().exponent
        unit = 0.01 if percent else 1
        yield float(number) * unit, 0.5 * 10.0 ** last * unit


def hold(where, cell, values):
    """values: a number for each of the cell's; None: not held."""
    global held
    numbers = list(printed(cell))
    if len(numbers) != len(values):
        failed.append(f"{where}: {cell.strip()!r} has {len(numbers)} numbers, not {len(values)}")
        return
    for (number, half), value in zip(numbers, values):
        if value is None:
            continue
        held += 1
        if not abs(number - float(value)) <= half * (1 + 1e-9):
            failed.append(f"{where}: {cell.strip()!r}, but the file has {value}")


def table(page, header, which=0):
    """Rows of cells of a table whose first line begins so: the first, or another."""
    lines = (ROOT / page).read_text().splitlines()
    first = [n for n, line in enumerate(lines) if line.startswith(header)]
    if len(first) <= which:
        sys.exit(f"{page}: {len(first)} tables begin with {header}")
    rows = []
    for line in lines[first[which] + 2:]:
        if not line.startswith("|"):
            return rows
        rows.append(line.strip("|\n").split("|"))
    return rows


def hold_table(page, header, expected):
    """expected: a row for each of the table's, of a list for each cell; None: not held."""
    rows = table(page, header)
    if len(rows) != len(expected):
        failed.append(f"{page}: {len(rows)} rows below {header}, not {len(expected)}")
    for cells, wanted in zip(rows, expected):
        if len(cells) != len(wanted):
            failed.append(f"{page}: {len(cells)} cells, not {len(wanted)}: {cells[0].strip()}")
        for cell, values in zip(cells, wanted):
            if values is not None:
                hold(f"{page}: {cells[0].strip()}", cell, values)


def order(h, e):
    """The slope that fits best, both on logarithmic scales."""
    x, y = [math.log(float(v)) for v in h], [math.log(float(v)) for v in e]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def what_a_digit_costs():
    """The sweep of the cylinder: cases/README.md, the front page's own table of it, and two rows there."""
    rows = read("plots/gallery/cylinder_re550_quick/sweep.csv")
    errors = ("drag_max", "drag_rms", "bubble_max", "separation_max_deg", "wall_vorticity_rms",
              "routes_max")
    fine = [row for row in rows if float(row["accuracy"]) <= 0.01]
    fits = [[order([row["accuracy"] for row in fine], [row[name] for row in fine])]
            for name in errors]
    fits[errors.index("separation_max_deg")] = []  # has none
    hold_table("cases/README.md", "| accuracy | drag, largest",
               [[[row["accuracy"]], *([row[name]] for name in errors), [row["particles"]], None]
                for row in rows] + [[None, *fits, [], []]])
    drag = {row["accuracy"]: [row["drag_rms"], row["drag_max"]] for row in rows}
    hold_table("README.md", "| accuracy | largest error of the drag",
               [[[row["accuracy"]], [row["drag_max"]], [row["drag_rms"]], None] for row in rows])
    front = table("README.md", "| | accurate to | in |")
    for cells, accuracy in zip(front, ("0.003", "0.01")):
        if f"`accuracy={accuracy}`" not in cells[0]:
            failed.append(f"README.md: {cells[0]} is not that of accuracy={accuracy}")
        hold(f"README.md: {cells[0].strip()}", cells[1], drag[accuracy])


def cylinder_by_sph():
    """The sweep of cylinder_re20_sph: cases/README.md."""
    rows = read("cases/cylinder_re20_sph.csv")
    errors = ("drag_max", "drag_rms", "separation_max_deg", "routes_max")
    fits = [[order([row["accuracy"] for row in rows], [row[name] for row in rows])]
            for name in errors]
    hold_table("cases/README.md", "| accuracy | spacing",
               [[[row["accuracy"]], None, *([row[name]] for name in errors), [row["particles"]], None]
                for row in rows] + [[None, [], *fits, [], []]])
    row = next(row for row in rows if row["accuracy"] == "0.005")
    for cells in table("README.md", "| | accurate to | in |"):
        if cells[0].startswith(" drag at Re = 20 by SPH"):
            hold("README.md: SPH", cells[1], [row["drag_rms"], row["drag_max"]])


def cylinder_in_box():
    """The sweep of cylinder_re20_box: cases/README.md."""
    hold_table("cases/README.md", "| spacing | its cases",
               [[[row["sph.spacing"]], None, None, None, [row["drag_max"]], None,
                 [row["separation_max_deg"]], [row["particles"]], None]
                for row in read("cases/cylinder_re20_box.csv")])


def hold_signed(where, cell, value):
    """A number that may have a minus."""
    hold(where, cell.replace("-", " "), [abs(float(value))])
    if cell.strip().startswith("-") != (float(value) < 0):
        failed.append(f"{where}: {cell.strip()!r}, but the file has {value}")


def foil_that_plunges():
    """Means of its last two periods: cases/README.md."""
    page, told = "cases/README.md", ("k", "accuracy", "steps", "edge", "drag_impulse", "drag_wall",
                                     "rise", "particles", "processor_seconds")
    runs, rows = read("cases/plunging_naca0012.csv"), table(page, "| k | accuracy | steps")
    if len(rows) != len(runs):
        failed.append(f"{page}: {len(rows)} runs of a foil that plunges, not {len(runs)}")
    for cells, run in zip(rows, runs):
        for cell, name in zip(cells, told):
            hold_signed(f"{page}: {name} of a foil that plunges", cell, run[name])


METHODS = "cases/methods.md"


def held_against_the_reference():
    """One scene by both methods: cases/methods.md."""
    rows = sorted(read("cases/methods.csv") + read("cases/methods_thin.csv"),
                  key=lambda row: float(row["flow.reynolds"]))
    errors = ("drag_max", "drag_rms", "separation_max_deg")
    hold_table(METHODS, "| Re | accuracy | method",
               [[[row["flow.reynolds"]], None, [], *([row[name]] for name in errors),
                 [row["particles"]], [row["processor_seconds"]]] for row in rows])


def accuracy_by_second():
    """The medians of runs by turns: cases/methods.md."""
    same = {}
    for row in read("plots/gallery/methods/sweep.csv"):
        same.setdefault((row["accuracy"], row["method"]), []).append(row)
    ordered = sorted(same, key=lambda key: -float(key[0]))
    told = ("drag_max", "drag_rms", "separation_max_deg", "particles", "processor_seconds")
    hold_table(METHODS, "| accuracy | method",
               [[[key[0]], [], *([statistics.median(float(row[name]) for row in same[key])]
                                 for name in told)] for key in ordered])


def long_runs():
    rows = read("cases/methods_long.csv")
    ends = [row["time.end"] for row in rows if row["method"] == "vortex"]
    cells = {(row["method"], row["time.end"]): row for row in rows}
    hold_table(METHODS, "| to t |",
               [[[end], *([cells[method, end][name]] for method in ("vortex", "sph")
                          for name in ("particles", "processor_seconds"))] for end in ends])


def what_is_paid_for():
    """Shares of the phases, particles and memory: cases/methods.md."""
    paid = {}
    for row in read("cases/methods_phases.csv"):
        paid.setdefault(row["method"], {})[row["what"]] = float(row["number"])
    for method, told in paid.items():
        phases = {what: number for what, number in told.items() if what.startswith("seconds ")}
        whole = sum(phases.values())
        hold_table(METHODS, f"| by {method} |", [[[], [number / whole], None]
                                                for number in phases.values()])
    both = [paid["vortex"], paid["sph"]]
    hold_table(METHODS, "| Re = 20, `accuracy=0.005` |",
               [[[], *([told["particles"]] for told in both)],
                [[], *([told["steps"]] for told in both)],
                [[], *([told["processor_seconds"]] for told in both)],
                [[], *([1e6 * told["processor_seconds"] / told["particle_steps"]] for told in both)],
                [[], *([1e-6 * told["peak_bytes"]] for told in both)]])


def cost_of_a_particle():
    """By numbers of particles and threads: cases/methods.md."""
    rows = read("cases/methods_cost.csv")
    hold_table(METHODS, "| particles | microseconds",
               [[[one["particles"]], [one["microseconds"]], [two["microseconds"]],
                 [one["pressure"]], [one["neighbors"]], [1e-3 * float(one["bytes"])]]
                for one, two in zip(rows[0::2], rows[1::2])])


ACCURACY = "cases/accuracy.md"


def accuracy_by_case():
    """Lines of accuracy.csv by case, and in it by accuracy, quantity and first T."""
    found = {}
    for row in read("plots/gallery/accuracy/accuracy.csv"):
        of_case = found.setdefault(row["case"], {})
        of_case.setdefault(row["accuracy"], {})[row["quantity"], row["from"]] = row
    return found


def hold_side(where, cell, mean):
    """Too high or too low by so much."""
    hold(where, cell, [abs(float(mean))])
    if cell.strip().endswith("high") != (float(mean) > 0):
        failed.append(f"{where}: {cell.strip()!r}, but the file has {mean}")


def drag_and_lift_off():
    """Each run: cases/accuracy.md."""
    runs = {(case, accuracy): told for case, of_case in accuracy_by_case().items()
            for accuracy, told in of_case.items() if ("drag", "0.2") in told}
    rows = table(ACCURACY, "| flow | T to |")
    if len(rows) != len(runs):
        failed.append(f"{ACCURACY}: {len(rows)} runs, not {len(runs)}")
    for ((case, accuracy), told), cells in zip(runs.items(), rows):
        where = f"{ACCURACY}: {case}, {accuracy}"
        drag, late, lift = told["drag", "0.2"], told["drag", "0.5"], told["lift", "0.2"]
        if f"`{case}`" not in cells[0]:
            failed.append(f"{where}: stands for {cells[0]}")
        hold_side(where, cells[6], drag["mean"])
        for cell, value in zip(cells[1:6] + cells[7:], (
                drag["to"], accuracy, drag["largest"], drag["at"], drag["rms"], late["largest"],
                lift["largest"], lift["rms"], drag["particles"], drag["processor_seconds"])):
            hold(where, cell, [value])


LAW = (("drag", "0.2", "rms"), ("drag", "0.5", "largest"), ("drag", "0.2", "largest"),
       ("lift", "0.2", "rms"), ("lift", "0.2", "largest"))


def error_no_more_than_accuracy():
    """In how many runs, and which are not among them: cases/accuracy.md."""
    runs = [(case, accuracy, told) for case, of_case in accuracy_by_case().items()
            for accuracy, told in of_case.items() if ("drag", "0.2") in told]
    for cells, (quantity, start, name) in zip(table(ACCURACY, "| error | kept"), LAW):
        where = f"{ACCURACY}: {cells[0].strip()}"
        over = [(case, accuracy) for case, accuracy, told in runs
                if float(told[quantity, start][name]) > float(accuracy)]
        hold(where, cells[1], [len(runs) - len(over), len(runs)])
        hold(where, cells[2], [accuracy for _, accuracy in over])
        if re.findall("`(.+?)`", cells[2]) != list(dict.fromkeys(case for case, _ in over)):
            failed.append(f"{where}: not kept by {over}")


SLOPES = (("drag", "0.2", "largest"), ("drag", "0.2", "rms"), ("drag", "0.5", "largest"),
          ("drag", "0.5", "rms"), ("lift", "0.2", "largest"), ("lift", "0.2", "rms"))


def slopes_of_accuracy():
    """By accuracy, and of seconds: cases/accuracy.md."""
    rows = {re.search("`(.+?)`", cells[0])[1]: cells for cells in table(ACCURACY, "| flow | drag")}
    found = accuracy_by_case()
    if set(rows) != {case for case in found if case != "gaussian_ellipse"}:
        failed.append(f"{ACCURACY}: slopes of {sorted(rows)}")
    for case, cells in rows.items():
        told = found[case]
        slopes = [order(told, [run[quantity, start][name] for run in told.values()])
                  for quantity, start, name in SLOPES]
        slopes.append(-order(told, [run["drag", "0.2"]["processor_seconds"]
                                    for run in told.values()]))
        for cell, slope in zip(cells[1:], slopes):
            hold(f"{ACCURACY}: slopes of {case}", cell, [slope] if slope >= 0.05 else [])


def quadrupole_by_accuracy():
    told = accuracy_by_case()["gaussian_ellipse"]
    rows = [run["quadrupole", "0"] for run in told.values()]
    errors = [row["largest"] for row in rows]
    hold_table(ACCURACY, "| accuracy | quadrupole",
               [[[row["accuracy"]], [row["largest"]], [row["particles"]],
                 [row["processor_seconds"]]] for row in rows]
               + [[None, [order(told, errors)], [],
                   [-order(told, [row["processor_seconds"] for row in rows])]]])


def vortices_by_sph():
    """The sweeps of taylor_green, uniform and with a finer disc: cases/README.md."""
    uniform, disc = read("cases/taylor_green.csv"), read("cases/taylor_green_disc.csv")
    errors = ("velocity_rms", "pressure_rms", "volume_max", "momentum_max", "energy_max", "particles")
    expected = []
    for degree in ("2", "4"):
        some = [row for row in uniform if row["sph.degree"] == degree]
        finer = [row for row in disc if row["sph.degree"] == degree]
        h = [row["sph.spacing"] for row in some]
        expected += [[[degree], [], *([row[name]] for name in errors),
                      [other["velocity_rms"]], [other["particles"]]]
                     for row, other in zip(some, finer)]
        fits = [[order(h, [row[name] for row in some])] for name in errors[:2]]
        expected.append([[degree], [], *fits, [], [], [], [],
                         [order(h, [row["velocity_rms"] for row in finer])], []])
    hold_table("cases/README.md", "| degree | spacing", expected)


def beside_another_code():
    hold_table("cases/README.md", "| code and scheme",
               [[None, [row["side"]], [row["steps"]], [row["seconds"]],
                 [1e6 * float(row["seconds"]) / float(row["steps"]) / float(row["side"]) ** 2],
                 [row["velocity_rms"]]] for row in read("cases/taylor_green_rivals.csv")])


def three_ways_to_diffuse():
    rows = read("cases/diffusion.csv")
    ways = [rows[k:k + 3] for k in (0, 3, 6)]
    expected = []
    for way in ways:
        errors = [row["quadrupole_max"] for row in way]
        # Cores go with the root of the accuracy, strained ones with the fourth.
        root = 4 if way[0]["diffusion.kind"] == "core_spreading" else 2
        half = [float(row["accuracy"]) ** (1 / root) for row in way]
        expected.append([None, *([error, None] for error in errors), [order(half, errors)]])
    hold_table("cases/README.md", "| quadrupole's error at t = 2", expected)


def reached():
    """{scene: {what: number}}, and the same of what was asked."""
    found, asked = {}, {}
    for row in read("cases/reached.csv"):
        found.setdefault(row["scene"], {})[row["what"]] = row["reached"]
        asked.setdefault(row["scene"], {})[row["what"]] = row["asked"]
    return found, asked


def cylinder_at_550(found, asked):
    names = ("drag_max", "drag_rms", "bubble_max", "separation_max_deg", "routes_max", "lift_max",
             "wall_vorticity_rms")
    scenes = ("cylinder_re550", "cylinder_re550_fine")
    expected = [[None, [asked[scenes[0]][name]], *([found[scene][name]] for scene in scenes)]
                for name in names]
    expected += [[None, [], *([found[scene]["blobs"]] for scene in scenes)]] + [[None] * 4] * 3
    hold_table("README.md", "| | asked | `cylinder_re550`", expected)


# What is told in the third column of the tables of scenes: None for a number that is no deviation.
TOLD = {
    "ellipse": ("routes_max", "lift_routes_max"),
    "ellipse_re400": ("drag_max", "drag_rms", "lift_error_max", "lift_error_rms"),
    "plunging_cylinder": ("drag_max", "drag_rms", "lift_error_max", "lift_error_rms"),
    "naca0012": (None, None, None, None, "lift_routes_max", "routes_max"),
    "naca2412": ("routes_max", "lift_routes_max"),
    "slow_start": ("front_pressure_max", None),
    "oscillating_cylinder": ("morison_drag_max", "morison_mass_max", "routes_max"),
    "spinning_cylinder": ("velocity_max", "lift_max"),
    "spinning_cylinder_re200": ("drag_max", "drag_rms", "lift_error_max", "lift_error_rms"),
    "pitching_ellipse": ("drag_max", "lift_error_max", "lift_error_rms"),
    "pitching_foil": ("routes_max", "lift_routes_max"),
    "plunging_naca0012": ("theodorsen_max", "lift_routes_max"),
    "plunging_naca0012_re252": ("mean_drag_max", "lift_routes_max", "routes_max"),
    "plunging_naca0012_k8": ("mean_drag_max", "lift_routes_max", "routes_max"),
    "side_by_side": ("lift_phases_max_deg", "mean_drag_each_max", "routes_max"),
    "side_by_side_re62": ("strouhal_max", "lift_phases_max_deg", "routes_max"),
    "tandem": ("strouhal_max", "mean_drag_each_max", "routes_max"),
    "passing_cylinders": ("routes_max", "lift_routes_max"),
    "lamb_oseen": ("vorticity_max", "velocity_max"),
    "kirchhoff_ellipse": ("rotation_max", "energy_max"),
    "dipole": ("speed_max", "impulse_max", "energy_max"),
    "gaussian_ellipse": ("quadrupole_max", "separation_max"),
    "corotating_pair": ("merger_max", "separation_max"),
    "tripole": ("quadrupole_max", None),
}


def hold_scene(where, cell, found, scene, told):
    """A scene that nobody has run for reached.csv yet is not held."""
    if scene in found:
        hold(f"{where}: {scene}", cell, [what and found[scene][what] for what in told])


def scenes(found):
    """Other bodies, and vortices in free space."""
    told = set()
    for at in (0, 1):
        for cells in table("cases/README.md", "| scene | held against", at):
            scene = re.search("`(.+?)`", cells[0])[1]
            told.add(scene)
            hold_scene("cases/README.md", cells[2], found, scene, TOLD[scene])
    if told != set(TOLD):
        failed.append(f"cases/README.md tells of {sorted(told)}")


# Of the table of bodies at two accuracies: scene and check of each row.
TWICE = (
    ("ellipse_re400", "drag_max"),
    ("ellipse_re400", "lift_error_max"),
    ("plunging_cylinder", "drag_max"),
    ("plunging_cylinder", "lift_error_max"),
    ("spinning_cylinder_re200", "drag_max"),
    ("spinning_cylinder_re200", "lift_error_max"),
    ("pitching_ellipse", "drag_max"),
    ("pitching_ellipse", "lift_error_max"),
    ("pitching_foil", "routes_max"),
    ("pitching_foil", "lift_routes_max"),
    ("naca2412", "routes_max"),
    ("naca2412", "lift_routes_max"),
    ("passing_cylinders", "routes_max"),
    ("passing_cylinders", "lift_routes_max"),
    ("side_by_side", "mean_drag_each_max"),
    ("side_by_side", "lift_phases_max_deg"),
    ("side_by_side_re62", "strouhal_max"),
    ("tandem", "strouhal_max"),
    ("tandem", "mean_drag_each_max"),
)


def bodies_at_two_accuracies():
    rows = read("cases/two_accuracies.csv")
    expected = []
    for scene, what in TWICE:
        coarse, fine = [row for row in rows if (row["scene"], row["what"]) == (scene, what)]
        expected.append([None, None, [coarse["asked"]], [coarse["reached"]],
                         [fine["reached"]], None])
    hold_table("cases/README.md", "| scene | what | asked | coarse", expected)


def wakes_that_shed(found):
    scenes = ("cylinder_re100", "cylinder_re200")
    rows = table("cases/README.md", "| to t = 100")
    for cells, told in zip(rows, ((None, None, "strouhal_max"), None, ("routes_max",),
                                  ("blobs_max",))):
        for scene, cell in zip(scenes, cells[1:]):
            if told:
                hold_scene(f"cases/README.md: {cells[0].strip()}", cell, found, scene, told)


def front_page(found):
    """Two of its rows that are scenes."""
    rows = table("README.md", "| | accurate to | in |")
    for begins, scene, told in (
            (" a cylinder that oscillates", "oscillating_cylinder",
             (None, None, "morison_drag_max", "morison_mass_max")),
            (" Kirchhoff's ellipse", "kirchhoff_ellipse", ("rotation_max", "energy_max"))):
        for cells in (row for row in rows if row[0].startswith(begins)):
            hold_scene("README.md", cells[1], found, scene, told)


def gallery():
    for kept in sorted((ROOT / "plots" / "gallery").rglob("*.csv")):
        mark = hashlib.sha256(kept.read_bytes()).hexdigest().encode()
        for picture in kept.parent.glob("*.png"):
            if mark not in picture.read_bytes():
                failed.append(f"{picture}: was not drawn from the {kept.name} beside it: "
                              "plots/gallery/remake --kept")


what_a_digit_costs()
cylinder_by_sph()
cylinder_in_box()
foil_that_plunges()
held_against_the_reference()
accuracy_by_second()
long_runs()
what_is_paid_for()
drag_and_lift_off()
error_no_more_than_accuracy()
slopes_of_accuracy()
quadrupole_by_accuracy()
cost_of_a_particle()
vortices_by_sph()
beside_another_code()
three_ways_to_diffuse()
found, asked = reached()
cylinder_at_550(found, asked)
scenes(found)
bodies_at_two_accuracies()
wakes_that_shed(found)
front_page(found)
gallery()
print(*failed, f"{held} numbers held, {len(failed)} objections", sep="\n")
sys.exit(bool(failed) or held < 100)
