"""Do two builds give the same numbers, bit for bit?    python3 same.py [OLD] NEW

Runs both programs on eight short scenes and on sets of particles, and compares all that a run has
left but for seconds (tests/faults/contents.py) and files that OLD does not write, velocities by each
method, and neighbor lists by each rule. Of a frame's state what is there of the flow counts, not how a version books the rest.
Prints a line for each, and ends with exit code 1 if anything differs.

Without OLD that is the program that VORTREE_BASELINE names; where it names none there is nothing to
compare, and the exit code is 77. notices.py asks whether it would notice.
"""

import os
import pathlib
import random
import subprocess
import sys
import tempfile

import h5py

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS / "faults"))
sys.dont_write_bytecode = True
import contents  # noqa: E402

CASES = TESTS.parent / "cases"
NOTHING_TO_COMPARE = 77
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


def call(program, words, folder):
    quiet = {**os.environ, "VORTREE_SHARE": str(folder)}  # no plots there
    ran = subprocess.run([program, *words], cwd=folder, env=quiet, capture_output=True, text=True)
    if ran.returncode == 2:
        sys.exit(f"{program} {' '.join(words)}: {ran.stderr}")


def arrays(path):
    with h5py.File(path, "r") as file:
        return {name: (item.dtype.str, item.shape, item[()].tobytes()) for name, item in file.items()}


def of_the_flow(name):
    """A dataset of a frame that any version keeps under this name."""
    kept = ("covariance_xx", "covariance_xy", "sheet", "wall_vorticity", "x_in_flow", "y_in_flow")
    return "/state/" not in name or name.rsplit("/", 1)[1] in kept


def run_left(folder):
    found = contents.contents(folder)
    found["frames.h5"] = {name: data for name, data in found["frames.h5"].items()
                          if of_the_flow(name)}
    found["summary.json"].pop("method", None)
    return found


def left(folder):
    """What a command has left: a run, or a file of arrays."""
    if (folder / "run").exists():
        return run_left(folder / "run")
    found = {path.name: arrays(path) for path in folder.glob("*.h5")}
    return found or sys.exit(f"{folder}: nothing is left there")


def without_news(old, new):
    """What the earlier program wrote, too: a run may leave more files than it did."""
    if "files" not in old:
        return new
    kept = {name: data for name, data in new.items() if name in old}
    return {**kept, "files": [name for name in new["files"] if name in old["files"]]}


def particles(path, count, cored, seed):
    dice = random.Random(seed)
    columns = {name: [dice.gauss(0, 1) for _ in range(count)] for name in ("x", "y", "gamma")}
    if cored:
        columns["sigma"] = [0.02 * 2 ** dice.uniform(-2, 2) for _ in range(count)]
    columns["reach"] = [0.05 * 2 ** dice.uniform(-2, 2) for _ in range(count)]
    with h5py.File(path, "w") as file:
        for name, values in columns.items():
            file.create_dataset(name, data=values, dtype="f8")


def unchecked(scene, folder):
    """A scene without its [check], which may ask what an earlier program does not know."""
    path = folder / f"{scene}.toml"
    path.write_text((CASES / path.name).read_text().split("\n[check]")[0])
    return str(path)


def jobs(folder):
    for scene, *keys in SCENES:
        yield scene, ["run", unchecked(scene, folder), *keys, "--out", "run"]
    for cored in (False, True):
        path = folder / f"particles_{'cored' if cored else 'bare'}.h5"
        particles(path, 20000, cored, 7)
        for words in VELOCITIES:
            title = f"velocity {path.stem} {' '.join(words)}"
            yield title, ["velocity", str(path), "--out", "uv.h5", *words]
    for words in NEIGHBORS:
        yield f"neighbors {' '.join(words)}", ["neighbors", str(path), "--out", "pairs.h5", *words]


def difference(programs, words, base):
    """In words, the first one; empty if there is none."""
    folders = [pathlib.Path(tempfile.mkdtemp(dir=base)) for _ in programs]
    for program, folder in zip(programs, folders):
        call(program, words, folder)
    old, new = map(left, folders)
    return contents.difference(old, without_news(old, new))


def main():
    programs = sys.argv[1:]
    if len(programs) == 1:
        programs.insert(0, os.environ.get("VORTREE_BASELINE") or sys.exit(NOTHING_TO_COMPARE))
    programs = [str(pathlib.Path(p).resolve()) for p in programs]
    differ = 0
    with tempfile.TemporaryDirectory() as base:
        for title, words in jobs(pathlib.Path(base)):
            found = difference(programs, words, base)
            differ += bool(found)
            print(f"differs {title}: {found}" if found else f"same    {title}", flush=True)
    sys.exit(differ > 0)


if __name__ == "__main__":
    main()
