"""A run of the program upon a draw, and whether how it ended is one of the ways it may end."""

import csv
import dataclasses
import math
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

import h5py
import numpy as np

SCENE = Path(__file__).parent / "sph.toml"
PATIENCE = 300  # seconds; a trial takes one or two on an idle machine
FACTOR = 3      # by which a force may be off that of vortices, which are a per cent off
VOLUME = 0.1    # which particles may lack of the box, or have too much
FASTEST = 12    # at the ends of a body ten times as long as thick potential flow has 11


class Fault(AssertionError):
    pass


@dataclasses.dataclass
class End:
    code: int  # negative: the signal
    out: str
    err: str

    def lines(self):
        return [line.removeprefix("vortree: ") for line in self.err.splitlines()]

    def doubts(self):
        """Warnings of the flow, not of times that no step meets."""
        return [line for line in self.lines() if line.startswith("warning: ")
                and not line.startswith(("warning: time.end =", "warning: output."))]

    def said(self):
        """What is neither a warning nor where the run has got to."""
        return [line for line in self.lines()
                if not line.startswith(("warning: ", "going on from", "step "))
                or "last good frame" in line]


@dataclasses.dataclass
class Outcome:
    kind: str    # refused, well, stopped, fault
    warned: bool = False
    poor: str = ""  # what is off, though warned of
    why: str = ""
    doubts: list = dataclasses.field(default_factory=list)


class Campaign:
    def __init__(self, program, root, plain=True):
        self.program, self.root, self.plain = program, root, plain
        self.known = {}

    def command(self, draw, folder, *words, threads=1):
        return [str(self.program), "run", str(SCENE), *draw.words(), "--out", str(folder),
                "--threads", str(threads), *words]

    def call(self, command):
        # No figures; and the program need not start itself anew.
        environment = {**os.environ, "VORTREE_SHARE": str(self.root), "OMP_WAIT_POLICY": "passive"}
        environment.pop("OMP_NUM_THREADS", None)
        try:
            done = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL,
                                  capture_output=True, text=True, timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            raise Fault(f"did not end within {PATIENCE} s") from None
        return End(done.returncode, done.stdout, done.stderr)

    def judge(self, draw, other_threads=False):
        """throws Fault for an end that it must not have."""
        folder = self.root / "run"
        shutil.rmtree(folder, ignore_errors=True)
        end = self.call(self.command(draw, folder))
        require_words(end)
        warned = bool(end.doubts())
        if end.code == 2:
            require(not (folder / "report.csv").exists(), "refused, and yet something ran")
            return Outcome("refused", warned, why=end.said()[-1])
        require_frames(folder)
        if end.code == 1:
            self.require_same_stop(draw, folder, end)
            return Outcome("stopped", warned, why=end.said()[-1], doubts=end.doubts())
        poor = absurd(draw, folder, self.force_of_plain(draw))
        if poor:
            require(warned, f"{poor}, without a warning")
        if other_threads:
            self.require_same_by_two(draw, folder)
        return Outcome("well", warned, poor, doubts=end.doubts())

    def require_same_stop(self, draw, folder, end):
        """The last good frame goes on, into the same wall."""
        again = self.call(self.command(draw, folder, "--resume"))
        require(again.code == 1, f"stopped; resumed, it ends with {again.code}: {again.err}")
        require(again.said()[-1] == end.said()[-1],
                f"stopped; resumed, it says {again.said()[-1]}, not {end.said()[-1]}")
        require_frames(folder)

    def require_same_by_two(self, draw, folder):
        other = self.root / "other"
        shutil.rmtree(other, ignore_errors=True)
        end = self.call(self.command(draw, other, threads=2))
        require(end.code == 0, f"two threads end with {end.code}: {end.err}")
        require(rows_of(folder) == rows_of(other), "two threads give another report.csv")
        one, two = frames_of(folder), frames_of(other)
        wrong = [name for name in one if one[name] != two.get(name)]
        require(not wrong and len(one) == len(two), f"two threads give other frames: {wrong[:3]}")

    def force_of_plain(self, draw):
        """The same flow by vortices: T and size of the force at each time; none where unknown."""
        if not self.plain or not draw.plain or draw.end < 0.2:
            return None
        key = tuple(sorted((name, str(value)) for name, value in draw.plain.items()))
        if key not in self.known:
            folder = self.root / "plain"
            shutil.rmtree(folder, ignore_errors=True)
            words = dataclasses.replace(draw, keys={**draw.plain, "time.end": 2}).words()
            end = self.call([str(self.program), "run", str(SCENE), "method=vortex",
                             "accuracy=0.05", *words, "--out", str(folder), "--threads", "1"])
            self.known[key] = force_of(folder, "impulse") if end.code == 0 else None
        return self.known[key]


def require(claim, words):
    if not claim:
        raise Fault(words)


def require_words(end):
    """One line for a failure, and none of a library's inside."""
    require(end.code >= 0, f"ended by signal {-end.code}: {end.err}")
    require(end.code in (0, 1, 2), f"exit code {end.code}: {end.err}")
    require(all(line.startswith("vortree: ") for line in end.err.splitlines()), end.err)
    for inside in ("std::", "basic_", "terminate", "HDF5-DIAG", "bad_alloc", "vector"):
        require(inside not in end.err, end.err)
    if end.code == 2:
        require(len(end.said()) == 1, f"refused in {len(end.said())} lines: {end.err}")
    if end.code == 1:
        require(len(end.said()) == 1 and re.match(r"step \d+, t = .*; the last good frame is that "
                                                  r"of step \d+ in ", end.said()[0]),
                f"stopped without step, reason and last frame: {end.err}")


def require_frames(folder):
    """They open, and all in them is finite."""
    with h5py.File(folder / "frames.h5") as file:
        frames = [name for name in file if name.startswith("frame_")]
        require(frames, "no frame")
        for name in frames:
            for column in ("x", "y", "u", "v", "pressure", "vorticity", "spacing"):
                require(np.isfinite(file[name][column][()]).all(),
                        f"{name}: {column} is not finite")


def rows_of(folder):
    with open(folder / "report.csv") as file:
        return [{name: value for name, value in row.items() if "seconds" not in name}
                for row in csv.DictReader(file)]


def frames_of(folder):
    """All that does not tell the time of day."""
    found = {}

    def visit(name, thing):
        clocked = ("seconds", "rows of report", "mark of report")
        if isinstance(thing, h5py.Dataset) and not any(word in name for word in clocked):
            found[name] = np.asarray(thing[()]).tobytes()

    with h5py.File(folder / "frames.h5") as file:
        file.visititems(visit)
    return found


def force_of(folder, route):
    """T and the size of the coefficient of the force."""
    rows = rows_of(folder)
    return (np.array([float(row["T"]) for row in rows]),
            np.array([math.hypot(float(row[f"cd_{route}"]), float(row[f"cl_{route}"]))
                      for row in rows]))


def mean_square(force, start, end):
    T, c = force
    among = c[(T >= start) & (T <= end)]
    return math.sqrt(np.mean(among ** 2)) if among.size else None


def absurd(draw, folder, plain):
    """What no such flow has, in words, or nothing."""
    rows = rows_of(folder)
    for row in rows:
        for name, value in row.items():
            if not math.isfinite(float(value)):
                raise Fault(f"{name} = {value} at t = {row['t']}, told as success")
    volume = max((float(row["volume"]) for row in rows), key=lambda v: abs(v - 1))
    if not -VOLUME < volume - 1 < VOLUME + draw.edge:
        return f"volume = {volume:.3g}"
    with h5py.File(folder / "frames.h5") as file:
        last = file[sorted(name for name in file if name.startswith("frame_"))[-1]]
        speed = np.hypot(last["u"][()], last["v"][()]).max() / draw.speed
    if speed > FASTEST:
        return f"speed = {speed:.3g}"
    if draw.family == "taylor_green":
        # Of what it was at the start. Later on it falls into other vortices, by itself.
        decayed = math.exp(-8 * math.pi ** 2 / draw.keys["flow.reynolds"] * draw.end)
        error = float(rows[-1]["velocity_error"])
        return f"velocity off by {error:.2g}" if error * decayed > 0.3 and draw.end < 2 else ""
    if not plain:
        return ""
    here = mean_square(force_of(folder, "wall"), draw.end / 2, draw.end)
    there = mean_square(plain, draw.end / 2, draw.end)
    if here is None or there is None or there < 0.05:
        return ""
    off = here / there
    return f"force = {off:.3g} of that by vortices" if not 1 / FACTOR < off < FACTOR else ""


def exact_command(campaign, draw):
    command = campaign.command(draw, "runs/fault")
    return shlex.join(command)
