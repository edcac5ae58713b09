"""Flows by the program, and the folders that its runs leave."""

from __future__ import annotations

import csv
import itertools
import json
import os
import re
import shutil
import signal
import subprocess
import warnings
from pathlib import Path
from typing import Any, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

_Path = str | os.PathLike[str]


def run(scene: _Path, *, out: _Path | None = None, resume: bool = False,
        overwrite: bool = False, threads: int | None = None,
        program: _Path | None = None, **keys: Any) -> "Run | Any":
    """Runs a scene by the program `vortree`, and reads what it leaves.

    A key that takes one value, and is given several, makes a sweep: a run for each, one after the
    other, for every combination of them if there are several such keys.

    Parameters
    ----------
    scene : str or path
        The name of a case (`vortree cases` lists them), or a TOML file.
    out : path, optional
        Folder of the results; None: runs/SCENE.
    resume, overwrite : bool
        Go on with the run that is in that folder, or replace it. Else it is refused.
    threads : int, optional
    program : path, optional
        None: the program beside which this package was built or installed, else the one on PATH.
    **keys
        Instead of what the scene says: accuracy=0.02, flow={"reynolds": 200}, or
        **{"flow.reynolds": 200}. cases/scenes.md has all keys. accuracy=[0.02, 0.01], or an array,
        is a sweep. A key that takes a list, as flow.stream, is swept by a list of lists; a list of
        tables, as probe, is one value.

    Returns
    -------
    Run, or Sweep of lists

    Raises
    ------
    ValueError
        With the program's own sentence, where a key or the scene is refused, or the folder.
    RuntimeError
        With its sentence, where the run broke off. One that ends, but misses its check, is no
        error: Run.passed says so. Nor is a run of a sweep that broke off: it is warned of, and is
        in Sweep.failed.
    FileNotFoundError
        Where there is no program.

    Notes
    -----
    What the program warns of is warned of. Ctrl-C lets it finish its step and save; resume=True
    goes on from there.

    Examples
    --------
    >>> import tempfile, vortree
    >>> folder = tempfile.TemporaryDirectory()
    >>> flow = vortree.run("cylinder", out=folder.name + "/short", accuracy=0.05,
    ...                    flow={"reynolds": 200}, time={"end": 0.1}, output={"fields": [0.1]})
    >>> bool(flow.report["t"][-1] == 0.1), flow.passed
    (True, True)
    >>> bool(flow.frame(-1).x.size == flow.report["blobs"][-1])
    True

    >>> sweep = vortree.run("cylinder", out=folder.name + "/sweep", accuracy=[0.1, 0.05],
    ...                     time={"end": 0.1}, output={"fields": []})
    >>> [case["accuracy"] for case in sweep.cases], sweep.passed
    ([0.1, 0.05], True)
    >>> bool(sweep.table["particles"][1] == sweep[1].report["blobs"].max())
    True
    >>> folder.cleanup()
    """
    folder = Path(out) if out is not None else Path("runs") / Path(scene).stem
    told, swept = dict(_dotted(keys)), False
    words = [os.fspath(program or find_program()), "run", os.fspath(scene)]
    for name, value in told.items():
        several = _several(name, value)
        swept = swept or several is not None
        words.append(f"{name}={_toml(value) if several is None else ','.join(several)}")
    words += ["--out", os.fspath(folder)]
    words += ["--resume"] * bool(resume) + ["--overwrite"] * bool(overwrite)
    words += ["--threads", str(threads)] if threads is not None else []
    code, said = _call(words)
    found = Sweep(folder) if swept and code != 2 else Run(folder)
    if code == 1 and isinstance(found, Sweep) and found.table["steps"].size == len(found):
        for case, failure in found.failed:
            warnings.warn(f"{case}: {failure}", stacklevel=2)
        return found
    if code == 1 and isinstance(found, Run) and found.passed is False:
        return found
    if code != 0:
        raise (ValueError if code == 2 else RuntimeError)(said or f"vortree ended with {code}")
    return found


def read(folder: _Path) -> "Run | Any":
    """The run whose results are in a folder, or the sweep; it may still be going on.

    Raises
    ------
    FileNotFoundError
        If there is no report.csv, and no sweep.json.
    """
    if (Path(folder) / "sweep.json").exists():
        return Sweep(folder)
    if not (Path(folder) / "report.csv").exists():
        raise FileNotFoundError(f"{folder} holds no run: there is no report.csv")
    return Run(folder)


class Run:
    """What a run has left in its folder, read whenever it is asked for.

    `read` and `run` make it. Frames and fields need h5py.
    """

    def __init__(self, folder: _Path) -> None:
        self.folder = Path(folder)

    @property
    def report(self) -> dict[str, NDArray[Any]]:
        """Columns of report.csv by name, one value a step; pandas.DataFrame takes it as it is."""
        return self.table("report")

    def table(self, name: str) -> dict[str, NDArray[Any]]:
        """Columns of a CSV file of the folder: report, wall, probes, outline, energy."""
        return _read_table(self.folder / f"{name}.csv")

    @property
    def summary(self) -> dict[str, Any]:
        """summary.json, which stands there when the run has ended; else empty."""
        try:
            return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        except FileNotFoundError:
            return {}

    @property
    def passed(self) -> bool | None:
        """Has it passed its [check]? None: not yet ended, or nothing is asked."""
        return self.summary.get("check", {}).get("passed")

    @property
    def scene(self) -> dict[str, Any]:
        """The scene with every default written out."""
        import tomllib

        with _open(self.folder / "frames.h5") as file:
            return tomllib.loads(_text(file.attrs["resolved"]))

    @property
    def frames(self) -> "Frames":
        """All frames, a sequence: blobs or particles at the times of output.frames."""
        return Frames(self.folder / "frames.h5")

    def frame(self, k: int = -1) -> "Frame":
        """The k-th frame, from the first on or, negative, from the last back."""
        return self.frames[k]

    @property
    def fields(self) -> list["Field"]:
        """Velocity and vorticity on a grid, at the times of output.fields; none without those."""
        path = self.folder / "fields.h5"
        if not path.exists():
            return []
        with _open(path) as file:
            groups = sorted(file.values(), key=lambda group: group.attrs["time"])
            return [Field(float(group.attrs["time"]), _datasets(group)) for group in groups]

    def __repr__(self) -> str:
        return f"Run({os.fspath(self.folder)!r})"


class Sweep(Sequence[Run]):
    """The runs of a list, in its order: all combinations of the values, those of the last key varying
    fastest. `run` makes it, and `read`.

    cases    the values of each run by key
    failed   of those that broke off, their values and why
    """

    def __init__(self, folder: _Path) -> None:
        self.folder = Path(folder)
        told = json.loads((self.folder / "sweep.json").read_text(encoding="utf-8"))
        keys = [one["key"] for one in told["lists"]]
        choices = list(itertools.product(*(one["values"] for one in told["lists"])))
        self.cases = [{key: _value(word) for key, word in zip(keys, words)} for words in choices]
        names = [",".join(map("=".join, zip(keys, words))) for words in choices]
        self._folders = [self.folder / name.translate(_IN_NAMES) for name in names]

    def __len__(self) -> int:
        return len(self.cases)

    def __getitem__(self, k: Any) -> Any:
        if isinstance(k, slice):
            return [Run(folder) for folder in self._folders[k]]
        return Run(self._folders[k])

    @property
    def table(self) -> dict[str, NDArray[Any]]:
        """Columns of sweep.csv by name, one value a run: its keys, steps, particles, seconds and, of
        all that was held against an answer, what was reached; NaN where a run has come to no end."""
        text = (self.folder / "sweep.csv").read_text(encoding="utf-8")
        lines = [line for line in text.splitlines() if line and not line.startswith("#")]
        names, *rows = csv.reader(lines, quotechar="'")
        return {name: _column(words) for name, words in zip(names, zip(*rows))}

    @property
    def passed(self) -> bool:
        """Have all come to their ends, and missed no check?"""
        return all(run.summary and run.passed is not False for run in self)

    @property
    def failed(self) -> list[tuple[dict[str, Any], str]]:
        """Values and why, of the runs that broke off."""
        notes = [(case, folder / "failed.txt") for case, folder in zip(self.cases, self._folders)]
        return [(case, note.read_text(encoding="utf-8", errors="replace").strip())
                for case, note in notes if note.exists()]

    def __repr__(self) -> str:
        return f"Sweep({os.fspath(self.folder)!r}): {len(self)} runs"


class Columns:
    """Arrays by name: values["x"] or values.x."""

    def __init__(self, time: float, columns: dict[str, NDArray[Any]]) -> None:
        self.time = time
        self.columns = columns

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self.columns[name]

    def __getattr__(self, name: str) -> NDArray[Any]:
        columns = self.__dict__.get("columns", {})
        if name in columns:
            return columns[name]
        raise AttributeError(f"no column {name}; there are {', '.join(columns)}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.columns]

    def __repr__(self) -> str:
        return f"{type(self).__name__} at t = {self.time:g}: {', '.join(self.columns)}"


class Field(Columns):
    """A picture: x, y along the grid, and u, v, omega, psi of the shape (y.size, x.size)."""


class Frame(Columns):
    """Blobs or particles at one time: x, y, u, v, gamma, ..., one value each.

    step    how many steps were made
    state   whatever else the run needs to go on, tracers too, by name
    """

    def __init__(self, step: int, time: float, columns: dict[str, NDArray[Any]],
                 state: dict[str, NDArray[Any]]) -> None:
        super().__init__(time, columns)
        self.step = step
        self.state = state


class Frames(Sequence[Frame]):
    """The frames of a file, each read when it is asked for."""

    def __init__(self, file: Path) -> None:
        self._file = file
        with _open(file) as frames:
            self._names = sorted(
                (name for name in frames if name.startswith("frame_")),
                key=lambda name: int(name.removeprefix("frame_")))

    def __len__(self) -> int:
        return len(self._names)

    def __getitem__(self, k: Any) -> Any:
        if isinstance(k, slice):
            return [self[i] for i in range(*k.indices(len(self)))]
        if not -len(self) <= k < len(self):
            raise IndexError(f"frame {k} of {len(self)}")
        with _open(self._file) as frames:
            group = frames[self._names[k]]
            state = _datasets(group["state"]) if "state" in group else {}
            return Frame(int(group.attrs["step"]), float(group.attrs["time"]), _datasets(group),
                         state)


def _open(path: Path) -> Any:
    try:
        import h5py
    except ImportError:
        raise ImportError("frames and fields are HDF5: h5py reads them "
                          "(Debian: apt install python3-h5py)") from None
    if not path.exists():
        raise FileNotFoundError(f"{path} does not exist")
    return h5py.File(path, "r", locking=False)


def _datasets(group: Any) -> dict[str, NDArray[Any]]:
    return {name: part[()] for name, part in group.items() if hasattr(part, "dtype")}


def _text(value: Any) -> str:
    return value.decode(errors="surrogateescape") if isinstance(value, bytes) else str(value)


def _read_table(path: Path) -> dict[str, NDArray[Any]]:
    """Lines that begin with # are notes; a last line that is being written is left out."""
    text = path.read_text(encoding="utf-8")
    whole = text[: text.rfind("\n") + 1]
    lines = [line for line in whole.splitlines() if line.strip() and not line.startswith("#")]
    if not lines:
        raise ValueError(f"{path}: has no header line")
    names = lines[0].split(",")
    rows = [[float(word or "nan") for word in line.split(",")] for line in lines[1:]]
    if any(len(row) != len(names) for row in rows):
        raise ValueError(f"{path}: a row has not {len(names)} values, as many as there are names")
    return dict(zip(names, np.array(rows).reshape(-1, len(names)).T.copy()))


def find_program() -> Path:
    """Beside a build folder's python/vortree, or below the prefix of an installation."""
    here = Path(__file__).absolute().parent
    chosen = os.environ.get("VORTREE_PROGRAM")
    beside = [*([Path(chosen)] if chosen else []), here.parent.parent / "bin" / "vortree"]
    beside += [parent / "bin" / "vortree" for parent in here.parents if parent.name != "python"]
    for path in beside:
        if path.is_file() and os.access(path, os.X_OK):
            return path
    found = shutil.which("vortree")
    if found is None:
        raise FileNotFoundError("there is no program vortree, neither beside this package nor on "
                                "PATH; program=... names one")
    return Path(found)


# Keys whose value is a list of numbers; a test holds them against the program's.
_LISTS = {"body.centre", "body.motion.about", "body.points", "check.lift_phases_deg",
          "check.lift_rms_each", "check.mean_drag_each", "check.mean_lift_each", "flow.stream",
          "initial.centre", "merging.box", "motion.about", "output.fields", "output.window",
          "plunge.direction", "sph.box"}
# What the program writes in place of these in the name of a folder.
_IN_NAMES = str.maketrans('/ "', "___")


def _dotted(keys: dict[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    for name, value in keys.items():
        if isinstance(value, dict):
            yield from _dotted(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def _several(name: str, value: Any) -> list[str] | None:
    """The values that a key takes one after the other; None if it is one value.

    >>> _several("accuracy", np.array([0.02, 0.01])), _several("method", ["vortex", "sph"])
    (['0.02', '0.01'], ['vortex', 'sph'])
    >>> _several("flow.stream", [1.0, 0.0]), _several("flow.stream", [[1, 0], [0, 1]])
    (None, ['[1, 0]', '[0, 1]'])
    """
    value = value.tolist() if isinstance(value, np.ndarray) else value
    if not isinstance(value, (list, tuple)) or any(isinstance(one, dict) for one in value):
        return None
    lists = re.sub(r"\[\d+\]", "", name) in _LISTS
    if lists and not any(isinstance(one, (list, tuple)) for one in value):
        return None
    if len(value) < 2:
        raise ValueError(f"{name}: a list of {len(value)} makes no sweep; give the value itself")
    return [_word(one) for one in value]


def _word(value: Any) -> str:
    """As on a command line, where a word needs no quotes, and folders are named by it."""
    plain = isinstance(value, str) and re.fullmatch(r"[A-Za-z][\w-]*", value)
    return str(value) if plain and value not in ("true", "false", "inf", "nan") else _toml(value)


def _value(word: str) -> Any:
    """What a word of a command line is: a value of TOML, or itself."""
    import tomllib

    try:
        return tomllib.loads(f"value = {word}")["value"]
    except tomllib.TOMLDecodeError:
        return word


def _column(words: Sequence[str]) -> NDArray[Any]:
    try:
        return np.array([float(word or "nan") for word in words])
    except ValueError:
        return np.array(words)


def overrides(keys: dict[str, Any]) -> list[str]:
    return [f"{name}={_toml(value)}" for name, value in _dotted(keys)]


def _toml(value: Any) -> str:
    """A value as TOML writes it; text in quotes, so that no comma makes a sweep of it.

    >>> _toml([True, 0.1, "a,b", {"points": np.zeros((1, 2))}])
    '[true, 0.1, "a,b", {points = [[0.0, 0.0]]}]'
    """
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False)
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {_toml(one)}" for key, one in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    raise ValueError(f"{value!r} is nothing that a scene can hold")


def _call(words: list[str]) -> tuple[int, str]:
    """The program's exit code, and the last line that it said; its warnings are warned of."""
    with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          errors="replace", start_new_session=True) as process:
        try:
            _, said = process.communicate()
        except KeyboardInterrupt:
            process.send_signal(signal.SIGINT)
            process.wait()
            raise
    lines = [line.removeprefix("vortree: ") for line in said.splitlines() if line.strip()]
    for line in lines:
        if line.startswith("warning: "):
            warnings.warn(line.removeprefix("warning: "), stacklevel=3)
    plain = [line for line in lines if not line.startswith("warning: ")]
    return process.returncode, plain[-1] if plain else ""
