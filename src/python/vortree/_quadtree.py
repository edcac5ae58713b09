"""The tree of square cells over points."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Column, points, thread_count


class Quadtree:
    """Square cells over n points in Morton order, split where they hold more than `capacity`.

    Parameters
    ----------
    x, y : array_like, shape (n,)
        Positions [m]; or one array of shape (n, 2), rows (x, y).
    capacity : int
        Points of a childless cell at most, unless it lies at the finest level.
    builder : "reverse" or "forward"
        From the leaves up, or from the root down; both build the same tree.
    finest_level : int
        0 to 31: no cell lies below.
    threads : int, optional

    Raises
    ------
    ValueError
        For lengths that differ, coordinates that are not finite, a capacity of 0.

    Examples
    --------
    >>> import numpy as np, vortree
    >>> tree = vortree.Quadtree([0, 1, 1, 1], [0, 0, 1, 0.9], capacity=1)
    >>> tree.cells[["level", "i", "j", "first", "last"]][0].item()
    (0, 0, 0, 0, 4)
    >>> tree == vortree.Quadtree([0, 1, 1, 1], [0, 0, 1, 0.9], capacity=1, builder="forward")
    True
    """

    __slots__ = ("_tree",)
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, x: ArrayLike, y: ArrayLike | None = None, *, capacity: int = 50,
                 builder: str = "reverse", finest_level: int = 31,
                 threads: int | None = None) -> None:
        px, py = points(x, y)
        if int(capacity) != capacity or not 0 <= capacity < 2**32:
            raise ValueError(f"capacity is {capacity}; a whole number from 1 on was expected")
        self._tree = _core.Quadtree(px, py, int(capacity), builder, int(finest_level),
                                    thread_count(threads))

    @classmethod
    def _of(cls, tree: _core.Quadtree) -> Quadtree:
        made = cls.__new__(cls)
        made._tree = tree
        return made

    @property
    def cells(self) -> NDArray[np.void]:
        """Occupied cells, level by level, in Morton order within a level; cell 0 is the root.

        A structured array: `level`; column `i` and row `j` within the level; `parent`, -1 of the
        root; children `first_child`:`last_child`, none if childless; points `first`:`last` of
        `order`. A fresh array each time.
        """
        return self._tree.cells()

    @property
    def order(self) -> NDArray[np.uint32]:
        """order[k] is the number of the k-th point in Morton order. A read-only view."""
        return self._tree.order()

    @property
    def keys(self) -> NDArray[np.uint64]:
        """Morton codes of level 31 of the points in that order, ascending. A read-only view."""
        return self._tree.keys()

    @property
    def childless(self) -> NDArray[np.uint32]:
        """Numbers of the childless cells, in the order of their points. A read-only view."""
        return self._tree.childless()

    @property
    def domain(self) -> tuple[float, float, float]:
        """(x0, y0, side) of the square of level 0 [m]."""
        return self._tree.domain()

    @property
    def depth(self) -> int:
        """The deepest level that has a cell; -1 without points."""
        return self._tree.depth

    def sides(self) -> Column:
        """Sides of the cells, side / 2^level [m]."""
        return np.ldexp(self.domain[2], -self.cells["level"])

    def centres(self) -> tuple[Column, Column]:
        """(x, y) of the middles of the cells [m]."""
        return self._tree.centres()

    def __len__(self) -> int:
        return len(self._tree.order())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Quadtree):
            return NotImplemented
        return self._tree == other._tree

    def __repr__(self) -> str:
        return f"Quadtree of {len(self)} points, {len(self.cells)} cells, depth {self.depth}"
