"""A flow that is moved step by step."""

from __future__ import annotations

import math
import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator, NoReturn

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Column, places, thread_count
from ._runs import Columns, find_program, overrides

if TYPE_CHECKING:
    from ._flow import Flow


class Probe:
    """Velocity and vorticity in time at some places. `Simulation.add_probe` makes it.

    Attributes
    ----------
    x, y : ndarray
        The places [L], of the shape that was given.
    every : float or None
        Time between two rows [T], each of the nearest step; None: every step.
    """

    def __init__(self, x: Column, y: Column, every: float | None,
                 rows: dict[str, NDArray[Any]] | None = None) -> None:
        self.x, self.y, self.every = x, y, every
        self._rows: dict[str, list[Any]] = {name: [] for name in ("t", "u", "v", "omega")}
        for name, values in (rows or {}).items():
            shape = (-1,) if name == "t" else (-1, x.size)
            self._rows[name] = [*values.reshape(shape)] if values.size else []

    @property
    def t(self) -> Column:
        """Times of the rows [T], shape (m,)."""
        return np.array(self._rows["t"], dtype=np.float64)

    @property
    def u(self) -> Column:
        """Velocity along x [L/T], shape (m, *x.shape); 0 within a body."""
        return self._column("u")

    @property
    def v(self) -> Column:
        """Velocity along y [L/T], shape (m, *x.shape); 0 within a body."""
        return self._column("v")

    @property
    def omega(self) -> Column:
        """Vorticity [1/T], shape (m, *x.shape); 0 within a body."""
        return self._column("omega")

    def __len__(self) -> int:
        return len(self._rows["t"])

    def __repr__(self) -> str:
        return f"Probe of {self.x.size} places, {len(self)} rows"

    def _column(self, name: str) -> Column:
        return np.array(self._rows[name], dtype=np.float64).reshape(len(self), *self.x.shape)

    def _due(self, steps: int, dt: float) -> bool:
        """Is this step the nearest to a multiple of `every`?"""
        if self.every is None:
            return True
        every = self.every / dt
        return _nearest(_nearest(steps / every) * every) == steps

    def _add(self, t: float, **values: Column) -> None:
        self._rows["t"].append(t)
        for name, row in values.items():
            self._rows[name].append(row)

    def _saved(self) -> dict[str, Column]:
        """All of it as rows of numbers; the shape of the places comes first."""
        rows = {name: np.ravel(getattr(self, name)) for name in self._rows}
        every = np.array([self.every or 0.0])
        shape = np.array(self.x.shape, dtype=np.float64)
        return {"shape": shape, "every": every, "x": self.x.ravel(), "y": self.y.ravel(), **rows}

    @classmethod
    def _restored(cls, saved: dict[str, Column]) -> Probe:
        shape = tuple(int(n) for n in saved["shape"])
        rows = {name: saved[name] for name in ("t", "u", "v", "omega")}
        x, y = (saved[name].reshape(shape) for name in "xy")
        return cls(x, y, saved["every"].item() or None, rows)


class Simulation:
    """A flow in memory: the steps of `run`, to the same bits, with nothing written.

    Parameters
    ----------
    scene : str or path
        The name of a case, or a TOML file.
    threads : int, optional
    **keys
        Instead of what the scene says, as run() takes them. What the scene asks of pictures,
        frames, probes, tracers and checks is left to run().

    Attributes
    ----------
    probes : list of Probe
        Those that add_probe has added; what is taken out of it is told no more.

    Raises
    ------
    ValueError
        With the program's own sentence, where a key or the scene is refused.
    RuntimeError
        In a step, where the flow cannot go on; it is then what it was before.
    TypeError
        For copies and pickles: save() and restore() stand for both.
    ImportError
        Where the package was made without the program, as by pip.

    Examples
    --------
    >>> import vortree
    >>> flow = vortree.Simulation("cylinder", accuracy=0.05, time={"end": 0.1})
    >>> for now in flow:
    ...     speed = now.velocity([2.0], [0.0])
    >>> flow.steps == flow.last_step, bool(flow.time == 0.1)
    (True, True)
    >>> flow.particles.x.size == flow.measures["blobs"]
    True
    """

    def __init__(self, scene: str | os.PathLike[str], *, threads: int | None = None,
                 **keys: Any) -> None:
        self._threads = thread_count(threads)
        self._flow = _compiled()(os.fspath(_find_scene(scene)), _words(keys), self._threads)
        self.probes: list[Probe] = []
        self._warn()

    @classmethod
    def restore(cls, path: str | os.PathLike[str], *, threads: int | None = None,
                **keys: Any) -> Simulation:
        """The flow that save() or a run has left; it goes on to the same bits.

        Parameters
        ----------
        path : str or path
            A file of save(), or the folder of a run, or its frames.h5: the last good frame counts.
        threads : int, optional
        **keys
            time={"end": ...} and whatever [output] and [check] have may change on the way; nothing
            else may.

        Raises
        ------
        ValueError
            With the library's own sentence: where there is no such file, or no frame in it, where
            it was written by another version or belongs to another scene, or a key may not change.

        Examples
        --------
        >>> import tempfile, vortree
        >>> flow = vortree.Simulation("cylinder", accuracy=0.05, time={"end": 0.2})
        >>> flow.step(2)
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     flow.save(f"{folder}/two_steps.h5")
        ...     other = vortree.Simulation.restore(f"{folder}/two_steps.h5")
        >>> flow.step(), other.step()
        (None, None)
        >>> other.steps, bool((other.particles.x == flow.particles.x).all())
        (3, True)
        """
        flow = cls.__new__(cls)
        flow._threads = thread_count(threads)
        _require_whole(path)
        file = Path(path) / "frames.h5" if Path(path).is_dir() else Path(path)
        flow._flow = _compiled().restored(os.fspath(file), _words(keys), flow._threads)
        flow.probes = _probes_of(flow._flow.extras())
        flow._warn()
        return flow

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the flow as it is, and its probes, into one HDF5 file, for restore() to go on.

        An older saved flow is replaced at once when all is written; no other file is. It is laid
        out as the frames.h5 of a run with one frame, so that `vortree velocity FILE::last` reads
        it, too.

        Raises
        ------
        ValueError
            Where no file can be written there, or another is there that save() has not written.
        RuntimeError
            Where it could not be written, or a number of the flow is not finite.
        """
        columns = {f"probe {k} {name}": values for k, probe in enumerate(self.probes, 1)
                   for name, values in probe._saved().items()}
        self._flow.save(os.fspath(path), columns)

    def step(self, count: int = 1) -> None:
        """So many steps of dt; probes are told after each."""
        for _ in range(count):
            self._flow.step(self._threads)
            self._tell(self.probes)

    def add_probe(self, x: ArrayLike, y: ArrayLike | None = None, *,
                  every: float | None = None) -> Probe:
        """Velocity and vorticity in time at some places, from now on.

        Parameters
        ----------
        x, y : array_like of one shape
            Places [L]; or x of the shape (..., 2).
        every : float, optional
            Time between two rows [T], > 0, each of the step nearest to a multiple of it; None:
            every step.

        Returns
        -------
        Probe
            Its columns t, u, v, omega grow with the flow; the first row is that of now, if it is
            due. The numbers are those that [[probe]] of a run writes into probes.csv, to the last
            bit where the same probes are due; at a probe's first row it is asked alone, and the
            order of a sum may be another.

        Raises
        ------
        ValueError
            For places that are not finite, or every that is not a finite number > 0.

        Examples
        --------
        >>> import vortree
        >>> flow = vortree.Simulation("cylinder", accuracy=0.05, time={"end": 0.2})
        >>> wake = flow.add_probe([1.0, 2.0], [0.0, 0.0])
        >>> flow.step(3)
        >>> wake.t.shape, wake.u.shape
        ((4,), (4, 2))
        """
        px, py, shape = places(x, y)
        if every is not None and not (math.isfinite(every) and every > 0):
            raise ValueError(f"every is {every}; a finite number > 0 was expected")
        probe = Probe(np.array(px).reshape(shape), np.array(py).reshape(shape),
                      None if every is None else float(every))
        self._tell([probe])
        self.probes.append(probe)
        return probe

    def __iter__(self) -> Iterator[Simulation]:
        """Steps until time.end; this flow after each."""
        while self.steps < self.last_step:
            self.step()
            yield self

    @property
    def time(self) -> float:
        """steps dt [T]"""
        return self._flow.time

    @property
    def dt(self) -> float:
        """Length of a step [T]."""
        return self._flow.dt

    @property
    def steps(self) -> int:
        """Steps made so far."""
        return self._flow.steps

    @property
    def last_step(self) -> int:
        """The step that meets time.end; step() goes on beyond."""
        return self._flow.last_step

    @property
    def particles(self) -> Columns:
        """Blobs or particles as frames show them: x, y, u, v, ..., one value each.

        Fresh arrays of float64 each time, in the scene's own lengths and times: `units`.
        """
        return Columns(self.time, self._flow.columns())

    @property
    def units(self) -> dict[str, str]:
        """Units of the columns of particles by their names, as powers of length L and time T."""
        return self._flow.units()

    @property
    def measures(self) -> dict[str, float]:
        """What is measured after each step, by the names of report.csv."""
        return self._flow.measures()

    @property
    def coefficients(self) -> dict[str, float]:
        """Drag, lift and moment of the body by their parts, by the names of report.csv.

        Of several bodies all together, then each (cd_wall_1, ...). Rates of change told from the
        steps before, as in the last row of a report; its other rows look ahead, too. Empty without
        a body, and before the second step with a force.
        """
        return self._flow.coefficients()

    @property
    def scene(self) -> dict[str, Any]:
        """The scene with every default written out."""
        import tomllib

        return tomllib.loads(self._flow.scene())

    def velocity(self, x: ArrayLike, y: ArrayLike | None = None) -> tuple[Column, Column]:
        """(u, v) [L/T] at places of one shape, or of the shape (..., 2); 0 within a body.

        Raises
        ------
        ValueError
            For places that are not finite, or of two shapes; so do the three below.
        """
        px, py, shape = places(x, y)
        u, v, _ = self._flow.sample(px, py, self._threads)
        return u.reshape(shape), v.reshape(shape)

    def vorticity(self, x: ArrayLike, y: ArrayLike | None = None) -> Column:
        """omega [1/T] at such places; 0 within a body."""
        px, py, shape = places(x, y)
        return self._flow.sample(px, py, self._threads)[2].reshape(shape)

    def stream_function(self, x: ArrayLike, y: ArrayLike | None = None) -> Column:
        """psi [L^2/T] with u = d psi/dy, v = -d psi/dx; by vortices only.

        Raises
        ------
        ValueError
            Of a method that tells none.
        """
        px, py, shape = places(x, y)
        psi = self._flow.stream_function(px, py, self._threads)
        if psi.size != px.size:
            raise ValueError("this method tells no stream function")
        return psi.reshape(shape)

    def pressure(self, x: ArrayLike, y: ArrayLike | None = None) -> Column:
        """Pressure over the density [L^2/T^2] beyond that far away, in a frame at rest.

        0 within a body.

        Raises
        ------
        ValueError
            Where none is told: of a body just set off at once.
        """
        px, py, shape = places(x, y)
        p = self._flow.pressure(px, py, self._threads)
        if p.size != px.size:
            raise ValueError(f"no pressure is told at t = {self.time:g}")
        return p.reshape(shape)

    def __reduce_ex__(self, protocol: Any) -> NoReturn:
        raise TypeError("a Simulation is not copied or pickled; save(path) writes it, and "
                        "Simulation.restore(path) goes on")

    def _warn(self) -> None:
        for doubt in self._flow.doubts():
            warnings.warn(doubt, stacklevel=3)

    def _tell(self, probes: list[Probe]) -> None:
        """Rows of those that are due, by one sum over all their places."""
        due = [probe for probe in probes if probe._due(self.steps, self.dt)]
        if not due:
            return
        x, y = (np.concatenate([getattr(probe, name).ravel() for probe in due]) for name in "xy")
        columns = self._flow.sample(x, y, self._threads)
        ends = np.cumsum([probe.x.size for probe in due])[:-1]
        for probe, u, v, omega in zip(due, *(np.split(column, ends) for column in columns)):
            probe._add(self.time, u=u.copy(), v=v.copy(), omega=omega.copy())

    def __repr__(self) -> str:
        what = self._flow.particle
        return f"Simulation at t = {self.time:g}, step {self.steps} of {self.last_step}, of {what}s"


def _compiled() -> type[Flow]:
    try:
        from . import _flow
    except ImportError as error:
        raise ImportError("this package was built without the program; ./vortree python builds "
                          "both") from error
    return _flow.Flow


def _words(keys: dict[str, Any]) -> list[str]:
    return ["output.fields=[]", *overrides(keys)]  # no pictures, no doubts about them


def _nearest(x: float) -> int:
    """The whole number next to x >= 0, the greater of two."""
    whole = math.floor(x)
    return whole + (x - whole >= 0.5)


def _probes_of(columns: dict[str, Column]) -> list[Probe]:
    found: dict[int, dict[str, Column]] = {}
    for key, values in columns.items():
        _, number, name = key.split(" ")
        found.setdefault(int(number), {})[name] = values
    return [Probe._restored(found[number]) for number in sorted(found)]


def _require_whole(path: str | os.PathLike[str]) -> None:
    """The program takes one frame of a file as FILE::12 or DIR::last; here there is no choice."""
    if "::" in os.fspath(path) and not Path(path).exists():
        raise ValueError(f"{os.fspath(path)}: restore() takes the folder of a run or a file, "
                         "without ::, and goes on from its last good frame")


def _find_scene(scene: str | os.PathLike[str]) -> Path:
    """A file, or a case beside the program, or in the sources that it was built from."""
    if Path(scene).is_file():
        return Path(scene)
    root = find_program().absolute().parents[1]
    folders = [root / "share" / "vortree" / "cases", root.parent / "cases"]
    if os.environ.get("VORTREE_SHARE"):
        folders.insert(0, Path(os.environ["VORTREE_SHARE"]) / "cases")
    for folder in folders:
        for name in (f"{os.fspath(scene)}.toml", os.fspath(scene)):
            if (folder / name).is_file():
                return folder / name
    known = sorted(path.stem for folder in folders for path in folder.glob("*.toml"))
    raise ValueError(f'no scene "{os.fspath(scene)}"; give a TOML file or one of the cases: '
                     + ", ".join(known))
