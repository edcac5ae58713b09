"""A flow that is moved step by step."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import Any, Iterator

from numpy.typing import ArrayLike

from ._arrays import Column, places, thread_count
from ._runs import Columns, find_program, overrides


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

    Raises
    ------
    ValueError
        With the program's own sentence, where a key or the scene is refused.
    RuntimeError
        In a step, where the flow cannot go on; it is then what it was before.
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
        try:
            from . import _flow
        except ImportError as error:
            raise ImportError("this package was built without the program; ./vortree python "
                              "builds both") from error
        self._threads = thread_count(threads)
        words = ["output.fields=[]", *overrides(keys)]  # no pictures, no doubts about them
        self._flow = _flow.Flow(os.fspath(_find_scene(scene)), words, self._threads)
        for doubt in self._flow.doubts():
            warnings.warn(doubt, stacklevel=2)

    def step(self, count: int = 1) -> None:
        """So many steps of dt."""
        for _ in range(count):
            self._flow.step(self._threads)

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
    def steps(self) -> int:
        """Steps made so far."""
        return self._flow.steps

    @property
    def last_step(self) -> int:
        """The step that meets time.end; step() goes on beyond."""
        return self._flow.last_step

    @property
    def particles(self) -> Columns:
        """Blobs or particles as frames show them: x, y, u, v, ..., fresh arrays each time."""
        return Columns(self.time, self._flow.columns())

    @property
    def measures(self) -> dict[str, float]:
        """What is measured after each step, by the names of report.csv."""
        return self._flow.measures()

    @property
    def coefficients(self) -> dict[str, float]:
        """Drag, lift and moment of the body by their parts, by the names of report.csv.

        Rates of change told from the steps before, as in the last row of a report; its other rows
        look ahead, too. Empty without a body, and before the second step with a force.
        """
        return self._flow.coefficients()

    @property
    def scene(self) -> dict[str, Any]:
        """The scene with every default written out."""
        import tomllib

        return tomllib.loads(self._flow.scene())

    def velocity(self, x: ArrayLike, y: ArrayLike | None = None) -> tuple[Column, Column]:
        """(u, v) at places of one shape, or of the shape (..., 2); 0 within a body."""
        px, py, shape = places(x, y)
        u, v, _ = self._flow.sample(px, py, self._threads)
        return u.reshape(shape), v.reshape(shape)

    def vorticity(self, x: ArrayLike, y: ArrayLike | None = None) -> Column:
        """omega at such places; 0 within a body."""
        px, py, shape = places(x, y)
        return self._flow.sample(px, py, self._threads)[2].reshape(shape)

    def stream_function(self, x: ArrayLike, y: ArrayLike | None = None) -> Column:
        """psi with u = d psi/dy, v = -d psi/dx; by vortices only.

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

    def __repr__(self) -> str:
        what = self._flow.particle
        return f"Simulation at t = {self.time:g}, step {self.steps} of {self.last_step}, of {what}s"


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
