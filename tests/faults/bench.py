"""Runs of the program under some fault, and what must hold after them."""

import ctypes
import dataclasses
import os
import select
import shutil
import signal
import subprocess
import threading
from pathlib import Path

import h5py

import contents
import scenes

PATIENCE = 300  # seconds; a trial takes a fraction of one on an idle machine


@dataclasses.dataclass
class Trial:
    kind: str
    what: str
    act: object  # returns a word for how it went; raises AssertionError if it went wrong


@dataclasses.dataclass
class End:
    code: int  # negative: the signal
    out: str
    err: str


class Bench:
    def __init__(self, program, preload, root, all_scenes):
        self.program, self.preload, self.root = program, preload, root
        self.scenes = list(scenes.ALL if all_scenes else scenes.QUICK)
        self.count, self.lock = 0, threading.Lock()
        self.whole = {}
        for name, text in scenes.ALL.items():
            (root / f"{name}.toml").write_text(text)
        for name in self.scenes:
            end = self.run(name, root / f"whole-{name}")
            assert end.code == 0, end
            self.whole[name] = contents.contents(root / f"whole-{name}")

    def folder(self):
        """A fresh one, not made yet."""
        with self.lock:
            self.count += 1
            return self.root / f"t{self.count:05}"

    def command(self, scene, folder, *words):
        return [str(self.program), "run", f"{scene}.toml", "--out", str(folder), "--threads", "1",
                *words]

    def environment(self, **faults):
        wishes = {f"FAULT_{key.upper()}": str(value) for key, value in faults.items()}
        if wishes:
            wishes["LD_PRELOAD"] = str(self.preload)
        # No figures; and the program need not start itself anew, which would count calls twice.
        return {**os.environ, "VORTREE_SHARE": str(self.root), "OMP_WAIT_POLICY": "passive",
                **wishes}

    def call(self, command, faults=None, **more):
        done = subprocess.run(command, cwd=self.root, env=self.environment(**(faults or {})),
                              stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=PATIENCE, **more)
        return End(done.returncode, done.stdout, done.stderr)

    def run(self, scene, folder, *words, faults=None, **more):
        return self.call(self.command(scene, folder, *words), faults, **more)

    def start(self, scene, folder, *words, hangup="default", **more):
        """hangup: "ignore" as nohup does; nohup of the tests themselves must not be the program's."""
        command = ["env", f"--{hangup}-signal=HUP", *self.command(scene, folder, *words)]
        return subprocess.Popen(command, cwd=self.root,
                                env=self.environment(), stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)

    def calls(self, scene, names, resumed=False):
        """How many calls of these names a whole run, or its resuming, makes into its folder."""
        folder, told = self.copy(scene) if resumed else self.folder(), self.folder()
        end = self.run(scene, folder, *["--resume"] * resumed,
                       faults=dict(calls=names, count=told, folder=folder))
        assert end.code == 0, end
        return int(told.read_text())

    def copy(self, scene):
        folder = self.folder()
        shutil.copytree(self.root / f"whole-{scene}", folder)
        return folder


def has_frames(folder):
    try:
        with h5py.File(folder / "frames.h5") as file:
            return any(name.startswith("frame_") for name in file)
    except (OSError, RuntimeError):  # h5py has one or the other for what it cannot read
        return False


IN_MODIFY, IN_MOVED_TO, IN_CREATE = 0x2, 0x80, 0x100  # of sys/inotify.h


def lines_of(file):
    return file.read_text().count("\n") if file.exists() else 0


def wait_for_rows(process, folder, rows):
    """Until report.csv has so many rows, or the run has ended."""
    folder.mkdir(exist_ok=True)
    system = ctypes.CDLL(None, use_errno=True)
    changes, end = system.inotify_init1(os.O_CLOEXEC), os.pidfd_open(process.pid)
    wanted = IN_MODIFY | IN_MOVED_TO | IN_CREATE
    assert system.inotify_add_watch(changes, os.fsencode(folder), wanted) >= 0, ctypes.get_errno()
    while lines_of(folder / "report.csv") <= rows:
        told = select.select([changes, end], [], [], PATIENCE)[0]
        if end in told:
            break
        assert told, f"no row {rows} of {folder}"
        os.read(changes, 4096)
    os.close(changes)
    os.close(end)


def wait_for_end(process):
    out, err = process.communicate(timeout=PATIENCE)
    return End(process.returncode, out, err)


def require_clean(end, sent=()):
    """No signal but those that were sent; one line for a failure."""
    if end.code < 0:
        assert -end.code in sent, f"ended by {signal.Signals(-end.code).name}: {end.err}"
        return
    assert end.code in (0, 1, 2), f"exit code {end.code}: {end.err}"
    lines = end.err.splitlines()
    assert all(line.startswith("vortree: ") for line in lines), end.err
    assert end.code == 0 or lines, "failed without a word"
    for inside in ("std::", "basic_", "terminate", "HDF5-DIAG", "bad_alloc"):
        assert inside not in end.err, end.err


def require_same(bench, scene, folder, but=()):
    found = contents.contents(folder)
    kept = {name: value for name, value in bench.whole[scene].items() if name not in but}
    wrong = contents.difference(kept, {n: v for n, v in found.items() if n not in but})
    assert not wrong, wrong


def require_recovery(bench, scene, folder, end, sent=(), but=()):
    """After a run that ended somehow: goes on, and is then as if nothing had happened."""
    require_clean(end, sent)
    if end.code == 0:
        require_same(bench, scene, folder, but)
        return "did no harm"
    resumed = bench.run(scene, folder, "--resume")
    require_clean(resumed)
    if resumed.code == 0:
        require_same(bench, scene, folder, but)
        return "resumed, the same"
    assert resumed.code == 2, f"--resume: exit code {resumed.code}: {resumed.err}"
    assert len(resumed.err.splitlines()) <= 2, resumed.err  # a warning may come before
    started = bench.run(scene, folder, "--overwrite")
    assert started.code == 0, started
    require_same(bench, scene, folder)
    return "refused with a line"
