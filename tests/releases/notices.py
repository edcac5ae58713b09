"""Does same.py notice?    python3 notices.py PROGRAM

On a short scene, a velocity and a neighbor list: the program is the same as itself, and as one that
calls it and then changes the seconds that it says it took. It differs from one that changes a last
digit or a last bit of anything else. Ends with exit code 1 if not.
"""

import pathlib
import sys
import tempfile

import same

DOCTORED = """#!/usr/bin/python3 -B
import pathlib, subprocess, sys
import h5py

def last_digit(column):
    table = pathlib.Path("run/report.csv")
    *rows, last = [line.split(",") for line in table.read_text().splitlines()]
    at = rows[0].index(column)
    last[at] = last[at][:-1] + ("1" if last[at].endswith("0") else "0")
    table.write_text("".join(",".join(row) + "\\n" for row in [*rows, last]))

def last_bit(path, name):
    with h5py.File(path, "r+") as file:
        values = file[name][()]
        values.view("u1")[0] ^= 1
        file[name][...] = values

ran = subprocess.run(["{program}", *sys.argv[1:]])
{change}
sys.exit(ran.returncode)
"""
SCENE = ["run", str(same.CASES / "lamb_oseen.toml"), "time.end=0.04", "output.fields=[0.04]",
         "output.frames=0.04", "--out", "run"]
CHANGES = [  # by what, in what is left by which words, and whether that is another result
    ("last_digit('circulation')", SCENE, True),
    ("last_digit('blobs')", SCENE, True),
    ("last_bit('run/frames.h5', 'frame_000002/x')", SCENE, True),
    ("last_bit('run/fields.h5', 'field_0.04/omega')", SCENE, True),
    ("last_digit('seconds_convect')", SCENE, False),
    ("last_bit('uv.h5', 'v')", ["velocity", "particles.h5", "--out", "uv.h5"], True),
    ("last_bit('pairs.h5', 'index')", ["neighbors", "particles.h5", "--out", "pairs.h5"], True),
]


def doctored(program, change, base):
    path = base / "doctored"
    path.write_text(DOCTORED.format(program=program, change=change))
    path.chmod(0o755)
    return str(path)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        base = pathlib.Path(folder)
        particles = str(base / "particles.h5")
        same.particles(particles, 500, True, 7)
        for change, words, other in [("pass", SCENE, False), *CHANGES]:
            words = [particles if word == "particles.h5" else word for word in words]
            found = same.difference([program, doctored(program, change, base)], words, base)
            wrong += bool(found) != other
            print(f"{'right' if bool(found) == other else 'WRONG'} {change}: {found or 'same'}")
    sys.exit(wrong > 0)


main()
