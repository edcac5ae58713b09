"""Who is near whom, by names of scipy.spatial.cKDTree."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Column, column, per_point, places, points, thread_count


class Neighbors:
    """Neighbors of n particles, each with a reach of its own.

    Particle j is a neighbor of particle i != j if |x_i - x_j| is less than ::

        max(r_i, r_j)    rule "max"
        (r_i + r_j)/2    rule "mean"
        r_i              rule "own", which is not symmetric

    Exact to the last bit, of lengths of any size. Nearer than the reach: where cKDTree counts a
    distance that equals it, this does not.

    Parameters
    ----------
    x, y : array_like, shape (n,)
        Positions [m]. Or one array of shape (n, 2), rows (x, y), in the place of both:
        Neighbors(points, reach).
    reach : array_like, shape (n,), or a number
        Radii of the kernels' supports [m], >= 0.
    rule : "max", "mean" or "own"
    boxsize : array_like, shape (2,), or a number, optional
        Lengths [m] after which all comes again along x and y, as cKDTree has them; a number is that
        of both, along a direction of 0 nothing does. All coordinates are in [0, boxsize) then, and
        how far two points are apart is told by their nearest images: each pair counts once, however
        far a reach goes.
    threads : int, optional
        Threads of OpenMP; None: as many as it would take. Lists do not depend on it.

    Raises
    ------
    ValueError
        For lengths that differ, coordinates that are not finite or not in the box, a reach or a
        boxsize that is negative or not finite, 2^31 particles or more.
    MemoryError
        When asked, if there are more pairs than the free memory holds, with both numbers.

    Notes
    -----
    Particles are placed once, by quadtree cells grid, in O(n); what was given may change later.
    Other threads of Python run on; of several that ask one object each waits for its turn.

    Examples
    --------
    >>> import vortree
    >>> near = vortree.Neighbors([0, 1, 3], [0, 0, 0], reach=[1.5, 1.5, 2.5])
    >>> sorted(near.query_pairs())
    [(0, 1), (1, 2)]
    >>> indptr, indices = near.rows()
    >>> indptr
    array([0, 1, 3, 4])
    >>> vortree.Neighbors([0.1, 0.9], [0, 0], reach=0.3, boxsize=[1, 0]).query_pairs()
    {(0, 1)}
    """

    __slots__ = ("_search", "_threads", "_rule", "_boxsize")

    def __init__(self, x: ArrayLike, y: ArrayLike | None = None, reach: ArrayLike | None = None,
                 *, rule: str = "max", boxsize: ArrayLike | None = None,
                 threads: int | None = None) -> None:
        if rule not in ("max", "mean", "own"):
            raise ValueError(f'rule is "{rule}"; it must be one of "max", "mean", "own"')
        self._rule = rule
        self._threads = thread_count(threads)
        self._boxsize = None if boxsize is None else _lengths(boxsize)
        box = (0.0, 0.0) if self._boxsize is None else self._boxsize
        self._search = _core.Neighbors(*_particles(x, y, reach), *box, self._threads)

    def update(self, x: ArrayLike, y: ArrayLike | None = None,
               reach: ArrayLike | None = None) -> None:
        """Places other particles instead, in the same memory and the same box."""
        self._search.place(*_particles(x, y, reach), self._threads)

    def rows(self, half: bool = False, *, distances: bool = False) -> tuple[NDArray[Any], ...]:
        """Compressed rows (indptr, indices), as scipy.sparse.csr_matrix takes them.

        Parameters
        ----------
        half : bool
            Each pair in one of its two rows only.
        distances : bool
            A third array: |x_i - x_j| of each entry [m], in a box of nearest images.

        Returns
        -------
        indptr : ndarray of int64, shape (n + 1,)
        indices : ndarray of int32
            The neighbors of particle i are indices[indptr[i]:indptr[i + 1]], in no order that
            matters. Both arrays are the library's own memory, not copied.

        Raises
        ------
        ValueError
            half under the rule "own", which is not symmetric.

        Examples
        --------
        >>> import numpy as np, vortree
        >>> near = vortree.Neighbors([0, 1, 3], [0, 0, 0], 1.5)
        >>> indptr, indices, r = near.rows(distances=True)
        >>> indices, r
        (array([1, 0], dtype=int32), array([1., 1.]))
        """
        found: tuple[NDArray[Any], ...] = self._search.rows(self._rule, bool(half),
                                                            bool(distances), self._threads)
        return found if distances else found[:2]

    def query_pairs(self, output_type: str = "set") -> set[tuple[int, int]] | NDArray[np.int64]:
        """All pairs (i, j), i < j, each once.

        Parameters
        ----------
        output_type : "set" or "ndarray"
            A set of tuples, or an array of shape (m, 2), which costs far less.

        Examples
        --------
        >>> import vortree
        >>> vortree.Neighbors([0, 1, 3], [0, 0, 0], 1.5).query_pairs()
        {(0, 1)}
        """
        _check_output(output_type, "set", "ndarray")
        pairs = self._search.pairs(self._rule, self._threads).reshape(-1, 2)
        return pairs if output_type == "ndarray" else set(zip(*pairs.T.tolist()))

    def sparse_distance_matrix(self, output_type: str = "csr_matrix") -> Any:
        """Distances of neighbors as a sparse matrix: |x_i - x_j| in row i, column j.

        Parameters
        ----------
        output_type : "csr_matrix", "coo_matrix", "dok_matrix", "dict" or "ndarray"
            A matrix of scipy.sparse, a dict of (i, j), or records (i, j, v). Of these csr_matrix
            costs least. Those at one place are stored with the distance 0, but for "dok_matrix",
            which has no zeros.

        Examples
        --------
        >>> import vortree
        >>> vortree.Neighbors([0, 1, 3], [0, 0, 0], 1.5).sparse_distance_matrix("dict")
        {(0, 1): 1.0, (1, 0): 1.0}
        """
        _check_output(output_type, "csr_matrix", "coo_matrix", "dok_matrix", "dict", "ndarray")
        indptr, indices, distance = self.rows(distances=True)
        if output_type in ("dict", "ndarray"):
            return _entries(indptr, indices, distance, output_type)
        from scipy.sparse import csr_matrix  # type: ignore[import]

        n = len(self)
        matrix = csr_matrix((distance, indices, indptr), shape=(n, n), copy=False)
        return matrix if output_type == "csr_matrix" else matrix.asformat(output_type[:3])

    def query_ball_point(self, x: ArrayLike, y: ArrayLike | None = None,
                         r: ArrayLike | None = None, *, return_length: bool = False,
                         output_type: str = "list") -> Any:
        """Particles nearer than r to any places: |x_j - x| < r; reaches do not count.

        Parameters
        ----------
        x, y : array_like of one shape
            Places [m]; or x of the shape (..., 2), and then query_ball_point(x, r=r). In a box any
            place stands for its image inside.
        r : array_like of that shape, or a number
            Radii [m], >= 0.
        return_length : bool
            How many there are, instead of who.
        output_type : "list" or "rows"
            Of places that are numbers a list; else an array of that shape of lists, or compressed
            rows (indptr, indices), which cost far less. Ascending.

        Raises
        ------
        ValueError
            For places that are not finite, for radii that are negative or not finite.

        Examples
        --------
        >>> import vortree
        >>> near = vortree.Neighbors([0, 1, 3], [0, 0, 0], 1.5)
        >>> near.query_ball_point(0.5, 0.0, r=0.6)
        [0, 1]
        >>> near.query_ball_point([0.5, 3], [0, 0], 0.6, return_length=True)
        array([2, 1])
        """
        _check_output(output_type, "list", "rows")
        if r is None:
            raise ValueError("r is missing")
        px, py, shape = places(x, y)
        radius = per_point("r", r if np.ndim(r) == 0 else np.ravel(r), px.size)
        indptr, indices = self._search.balls(px, py, radius, self._threads)
        if return_length:
            return np.diff(indptr).reshape(shape)[()]
        return (indptr, indices) if output_type == "rows" else _lists(indptr, indices, shape)

    def __len__(self) -> int:
        return self._search.size

    def __repr__(self) -> str:
        box = "" if self._boxsize is None else ", boxsize ({:g}, {:g})".format(*self._boxsize)
        return f'Neighbors of {len(self)} particles, rule "{self._rule}"{box}'

    @property
    def n(self) -> int:
        """How many particles there are."""
        return self._search.size

    @property
    def rule(self) -> str:
        return self._rule

    @property
    def boxsize(self) -> Column | None:
        """Lengths of the periodic box, shape (2,) [m]; None: the plane."""
        return None if self._boxsize is None else np.array(self._boxsize)

    @property
    def nbytes(self) -> int:
        """Memory kept for the next search [bytes]."""
        return self._search.nbytes


def _particles(x: Any, y: Any, reach: Any) -> tuple[Column, Column, Column]:
    x, y, reach = points(x, y, reach)
    if reach is None:
        raise ValueError("reach is missing")
    return x, y, per_point("reach", reach, x.size)


def _lengths(boxsize: ArrayLike) -> tuple[float, float]:
    lengths = column("boxsize", boxsize)
    if lengths.shape not in ((), (2,)):
        raise ValueError(f"boxsize has the shape {lengths.shape}; a number or two were expected")
    x, y = np.broadcast_to(lengths, 2).tolist()
    return x, y


def _check_output(output_type: str, *known: str) -> None:
    if output_type not in known:
        raise ValueError(f'output_type is "{output_type}"; it must be one of {", ".join(known)}')


def _lists(indptr: NDArray[np.int64], indices: NDArray[np.int32],
           shape: tuple[int, ...]) -> Any:
    numbers, ends = indices.tolist(), indptr.tolist()
    found: list[list[int]] = [numbers[a:b] for a, b in zip(ends, ends[1:])]
    if shape == ():
        return found[0]
    lists = np.empty(len(found), dtype=object)
    for k, row in enumerate(found):
        lists[k] = row
    return lists.reshape(shape)


def _entries(indptr: NDArray[Any], indices: NDArray[Any], distance: Column,
             output_type: str) -> Any:
    row = np.repeat(np.arange(len(indptr) - 1), np.diff(indptr))
    if output_type == "dict":
        return dict(zip(zip(row.tolist(), indices.tolist()), distance.tolist()))
    entries = np.empty(len(row), dtype=[("i", np.intp), ("j", np.intp), ("v", np.float64)])
    entries["i"], entries["j"], entries["v"] = row, indices, distance
    return entries
