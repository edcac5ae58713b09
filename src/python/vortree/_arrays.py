"""What the classes of this package take and give: columns of float64."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Shape = tuple[int, ...]
Column = NDArray[np.float64]


def column(name: str, values: Any) -> Column:
    """The values as C-contiguous float64: themselves if they are that, else copied once.

    >>> import numpy as np
    >>> x = np.zeros(3)
    >>> column("x", x) is x
    True
    >>> column("x", [1, 2])
    array([1., 2.])
    """
    if isinstance(values, np.ma.MaskedArray) and np.any(values.mask):
        raise ValueError(f"{name} is masked; every value is needed")
    array = np.asarray(values)
    if array.dtype.kind not in "fiubO":
        raise ValueError(f"{name} is of type {array.dtype}; real numbers were expected")
    try:
        array = np.asarray(array, dtype=np.float64, order="C")
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} holds what is no real number: {error}") from None
    return array if array.flags.aligned else array.copy()


def places(x: Any, y: Any) -> tuple[Column, Column, Shape]:
    """Columns x and y, and the shape of each: of two arrays of one shape, or of one (..., 2)."""
    if y is not None:
        x, y = column("x", x), column("y", y)
        if x.shape != y.shape:
            raise ValueError(f"y has the shape {y.shape}, x has {x.shape}")
        return x, y, x.shape
    both = column("x", x)
    if both.ndim == 0 or both.shape[-1] != 2:
        raise ValueError(f"x has the shape {both.shape}; y, or a shape (..., 2) was expected")
    return both[..., 0].copy(), both[..., 1].copy(), both.shape[:-1]


def points(x: Any, *others: Any) -> tuple[Any, ...]:
    """(x, y, others) of n points: x, y of n values each, or one array of n rows (x, y).

    An array of two dimensions cannot be x alone; then what follows it stands one place earlier.
    """
    if getattr(x, "ndim", None) == 2 or (not hasattr(x, "ndim") and np.ndim(x) == 2):
        return (*places(x, None)[:2], *_one_place_earlier(*others))
    if others[0] is None:
        raise ValueError("y is missing; x has not the shape (n, 2)")
    x, y, shape = places(x, others[0])
    if len(shape) != 1:
        raise ValueError(f"x has the shape {shape}; (n,), or (n, 2) for rows (x, y), was expected")
    return (x, y, *others[1:])


def _one_place_earlier(y: Any, *others: Any) -> tuple[Any, ...]:
    if y is None:
        return others
    given = [y, *(value for value in others if value is not None)]
    if len(given) > len(others):
        raise ValueError("x has two dimensions, as rows (x, y) have; then there is no y")
    return (*given, *[None] * (len(others) - len(given)))


def per_point(name: str, values: Any, n: int) -> Column:
    """One value a point; a single number is that of all."""
    row = column(name, values)
    return np.full(n, row.item()) if row.ndim == 0 else one_row(name, row, n)


def one_row(name: str, values: Any, n: int) -> Column:
    row = column(name, values)
    if row.shape != (n,):
        raise ValueError(f"{name} has the shape {row.shape}; x has {n} values")
    return row


def results(out: Any, count: int, shape: Shape, *inputs: Column) -> tuple[Column, ...]:
    """Arrays to write to: fresh ones, or those of `out` if they fit."""
    if out is None:
        return tuple(np.empty(shape) for _ in range(count))
    arrays = (out,) if count == 1 and isinstance(out, np.ndarray) else tuple(out)
    if len(arrays) != count:
        raise ValueError(f"out has {len(arrays)} arrays; {count} were expected")
    for k, array in enumerate(arrays):
        _check_result(f"out[{k}]" if count > 1 else "out", array, shape)
        for other in (*arrays[:k], *inputs):
            if np.may_share_memory(array, other):
                raise ValueError(f"out[{k}] shares memory with another result or with the input")
    return arrays


def _check_result(name: str, array: Any, shape: Shape) -> None:
    if not isinstance(array, np.ndarray) or array.dtype != np.float64:
        what = getattr(array, "dtype", type(array).__name__)
        raise ValueError(f"{name} is of type {what}; an array of float64 was expected")
    if array.shape != shape:
        raise ValueError(f"{name} has the shape {array.shape}; {shape} was expected")
    if not array.flags.carray:
        raise ValueError(f"{name} must be C-contiguous, aligned and writeable")


def thread_count(threads: int | None) -> int:
    """So many threads of OpenMP; None: as many as it would take (OMP_NUM_THREADS)."""
    if threads is None:
        return 0
    if isinstance(threads, bool) or int(threads) != threads or not 1 <= threads <= 4096:
        raise ValueError(f"threads is {threads}; None or a whole number from 1 to 4096 was "
                         f"expected")
    return int(threads)
