"""Do two builds give the same numbers, bit for bit?    python3 same.py OLD NEW [FOLDER]

Runs both programs on eight short scenes and on sets of particles, and compares, but for seconds:
report.csv, wall.csv and energy.csv; every dataset of frames.h5 and fields.h5, what a run resumes
from among them; velocities by each method; neighbor lists by each rule. Prints a line
for each, and ends with exit code 1 if anything differs.
"""

import csv
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import h5py

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"
SCENES = [
    ("cylinder_re550_quick", "time.end=0.3"),
    ("cylinder", "time.end=0.2"),
    ("ellipse", "time.end=0.3"),
    ("naca0012", "time.end=0.05"),
    ("oscillating_cylinder", "time.end=0.3"),
    ("plunging_naca0012", "time.end=0.05"),
    ("lamb_oseen",),
    ("gaussian_ellipse", "time.end=0.5"),
]
VELOCITIES = [
    ("--tolerance", tolerance, "--method", method, "--builder", builder)
    for tolerance in ("1e-3", "1e-9")
    for method in ("fmm", "boxes", "direct")
    for builder in ("reverse", "forward")
]
NEIGHBORS = [("--rule", "max"), ("--rule", "mean"), ("--rule", "own"), ("--rule", "max", "--half")]
# Of a frame's state, what has seconds in it: its numbers stand in the rows of report.csv, too.
TIMED = ("history", "totals", "mark of report.csv", "rows of report.csv")


def call(program, words, folder):
    quiet = {**os.environ, "VORTREE_SHARE": str(folder)}  # no plots there
    ran = subprocess.run([program, *words], cwd=folder, env=quiet, capture_output=True, text=True)
    if ran.returncode == 2:
        sys.exit(f"{program} {' '.join(words)}: {ran.stderr}")


def rows(path):
    """The cells of a table, without its columns of seconds."""
    with open(path, newline="") as file:
        table = list(csv.reader(file))
    kept = [k for k, name in enumerate(table[0]) if not name.startswith("seconds")]
    return [[row[k] for k in kept] for row in table]


def bytes_of(path):
    """What an HDF5 file holds, by name, as bytes."""
    held = {}

    def add(name, item):
        if isinstance(item, h5py.Dataset) and not name.endswith(TIMED):
            held[name] = (str(item.dtype), item.shape, item[()].tobytes())

    with h5py.File(path, "r") as file:
        file.visititems(add)
    return held


def contents(path):
    if path.suffix == ".csv":
        return rows(path)
    return bytes_of(path) if path.suffix == ".h5" else None


def differences(old, new):
    names = {
        path.relative_to(folder)
        for folder in (old, new)
        for path in folder.rglob("*")
        if path.suffix in (".csv", ".h5")
    }
    for name in sorted(names):
        if not (old / name).exists() or not (new / name).exists():
            yield f"{name} is there only once"
            continue
        a, b = contents(old / name), contents(new / name)
        if a == b:
            continue
        if isinstance(a, dict):
            yield f"{name}: " + ", ".join(sorted(k for k in {*a, *b} if a.get(k) != b.get(k))[:5])
        else:
            line = next((k for k, (p, q) in enumerate(zip(a, b)) if p != q), min(len(a), len(b)))
            yield f"{name}: line {line + 1}"


def particles(path, count, cored, seed):
    dice = random.Random(seed)
    columns = {name: [dice.gauss(0, 1) for _ in range(count)] for name in ("x", "y", "gamma")}
    if cored:
        columns["sigma"] = [0.02 * 2 ** dice.uniform(-2, 2) for _ in range(count)]
    columns["reach"] = [0.05 * 2 ** dice.uniform(-2, 2) for _ in range(count)]
    with h5py.File(path, "w") as file:
        for name, values in columns.items():
            file.create_dataset(name, data=values, dtype="f8")


def jobs(folder):
    for scene, *keys in SCENES:
        yield scene, ["run", str(CASES / f"{scene}.toml"), *keys, "--out", "run"]
    for cored in (False, True):
        path = folder / f"particles_{'cored' if cored else 'bare'}.h5"
        particles(path, 20000, cored, 7)
        for words in VELOCITIES:
            title = f"velocity {path.stem} {' '.join(words)}"
            yield title, ["velocity", str(path), "--out", "uv.h5", *words]
    for words in NEIGHBORS:
        yield f"neighbors {' '.join(words)}", ["neighbors", str(path), "--out", "pairs.h5", *words]


def main():
    programs = [str(pathlib.Path(p).resolve()) for p in sys.argv[1:3]]
    base = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else tempfile.mkdtemp())
    base.mkdir(parents=True, exist_ok=True)
    differ = 0
    for number, (title, words) in enumerate(jobs(base)):
        folders = [base / f"{number}_{which}" for which in ("old", "new")]
        for program, folder in zip(programs, folders):
            folder.mkdir()
            call(program, words, folder)
        found = list(differences(*folders))
        differ += bool(found)
        print(f"{'DIFFERS' if found else 'same   '} {title}", *found, sep="\n        ", flush=True)
    sys.exit(differ > 0)


main()
