"""Velocities of many vortices: Plan, and velocity() for one call."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Column, one_row, per_point, places, points, results, thread_count
from ._quadtree import Quadtree

_no_cores = np.empty(0)
_no_cores.flags.writeable = False


class Plan:
    """Velocities, gradients, stream function and vorticity of n vortex blobs, at any places.

    Made once for a set of blobs, asked any number of times::

        u_i = sum_j gamma_j/(2 pi) (1 - exp(-r^2/S)) / r^2 (-dy, dx),  (dx, dy) = x_i - x_j

    with S = sigma_j^2 (cores="source") or (sigma_i^2 + sigma_j^2)/2 (cores="mean"); S = 0 is the
    bare vortex 1/r^2, and r = 0 contributes nothing.

    Parameters
    ----------
    x, y : array_like, shape (n,)
        Positions [m]. Or one array of shape (n, 2), rows (x, y), in the place of both:
        Plan(points, gamma, sigma).
    gamma : array_like, shape (n,)
        Circulations [m^2/s], > 0 anticlockwise.
    sigma : array_like, shape (n,), or a number, optional
        Core sizes [m], >= 0: omega = gamma/(pi sigma^2) exp(-r^2/sigma^2). None: bare vortices.
    tolerance : float
        In (0, 1): ||u - u_exact||_2 <= tolerance ||u_exact||_2; where sums cancel, down to 2^-49
        of the norm of the sums of |contributions|.
    method : "fmm", "boxes" or "direct"
        Fast multipoles in O(n), boxes to points in O(n log n), or all pairs. "fmm" gives way to
        "boxes" where wide cores lie among narrow ones: `method` says what sums.
    builder : "reverse" or "forward"
        Which walk builds the tree; both build the same.
    cores : "source" or "mean"
    order, capacity, finest_level : int
        Terms of a series, points of a childless cell at most (0: chosen), and the level below
        which no cell lies. A fixed order keeps no tolerance.
    threads : int, optional
        Threads of OpenMP; None: as many as OMP_NUM_THREADS says, else as there are processors.
        Results are the same, bit for bit, for any number.

    Raises
    ------
    ValueError
        For lengths that differ, values that are not finite, a negative sigma, and options out of
        range, with the number and its place.

    Notes
    -----
    Arrays of float64 that are C-contiguous are read where they are, others copied once; the plan
    keeps nothing of them. Other threads of Python run on while it is made and while it sums, and
    may ask the same plan.

    Examples
    --------
    Two vortices of 2 pi, two apart, and the fluid in their middle:

    >>> import numpy as np, vortree
    >>> plan = vortree.Plan([-1, 1], [0, 0], [2 * np.pi, 2 * np.pi], tolerance=1e-9)
    >>> u, v = plan.velocity()
    >>> v.round(6)
    array([-0.5,  0.5])
    >>> u, v = plan.velocity([0.0], [0.0])
    >>> bool(abs(v[0]) < 1e-9)
    True
    """

    __slots__ = ("_plan", "_threads", "_tolerance", "_mean")

    def __init__(self, x: ArrayLike, y: ArrayLike | None = None,
                 gamma: ArrayLike | None = None, sigma: ArrayLike | None = None, *,
                 tolerance: float = 1e-6, method: str = "fmm", builder: str = "reverse",
                 cores: str = "source", order: int = 0, capacity: int = 0,
                 finest_level: int = 31, threads: int | None = None) -> None:
        px, py, strength, width = points(x, y, gamma, sigma)
        if strength is None:
            raise ValueError("gamma is missing")
        strength = one_row("gamma", strength, px.size)
        width = _no_cores if width is None else per_point("sigma", width, px.size)
        self._threads = thread_count(threads)
        self._tolerance = float(tolerance)
        self._mean = cores == "mean"
        self._plan = _core.Plan(px, py, strength, width, self._tolerance, method, builder, cores,
                                int(order), _whole("capacity", capacity), int(finest_level),
                                self._threads)

    def velocity(self, x: ArrayLike | None = None, y: ArrayLike | None = None,
                 sigma: ArrayLike | None = None, *,
                 out: Any = None) -> tuple[Column, Column]:
        """Velocity (u, v) [m/s] at the blobs themselves, or at places x, y.

        Parameters
        ----------
        x, y : array_like of one shape, optional
            Places [m]; or x of the shape (..., 2). None: the blobs, in the order of the input.
        sigma : array_like of that shape, or a number, optional
            Core sizes of the places [m]; with cores="mean" only.
        out : two arrays of float64 of that shape, optional
            Written to and returned; C-contiguous. None: fresh arrays.

        Returns
        -------
        u, v : ndarray
            Of the shape of x, or (n,).

        Raises
        ------
        ValueError
            For places that are not finite, for shapes that differ, for an `out` that does not fit.

        Examples
        --------
        On a grid, around a vortex with a core:

        >>> import numpy as np, vortree
        >>> plan = vortree.Plan([0], [0], [2 * np.pi], sigma=0.1)
        >>> x, y = np.meshgrid(np.linspace(-1, 1, 5), np.linspace(-1, 1, 3))
        >>> u, v = plan.velocity(x, y)
        >>> u.shape, bool(np.isclose(v[1, 4], 1))
        ((3, 5), True)
        """
        if x is None:
            u, v = results(out, 2, (self._plan.size,))
            self._plan.velocity(u, v, self._threads)
            return u, v
        px, py, shape = places(x, y)
        u, v = results(out, 2, shape, px, py)
        self._plan.velocity_at(px, py, self._cores_of(sigma, px.size), u, v, self._threads)
        return u, v

    def velocity_and_gradient(self, *, out: Any = None) -> tuple[Column, ...]:
        """(u, v, ux, uy, vx) at the blobs themselves, in one sweep.

        As velocity() and gradient(); the gradient's norm errs by ten tolerances at most.

        Examples
        --------
        >>> import vortree
        >>> u, v, ux, uy, vx = vortree.Plan([0, 1], [0, 0], [1, 1]).velocity_and_gradient()
        >>> u.shape, vx.shape
        ((2,), (2,))
        """
        u, v, ux, uy, vx = results(out, 5, (self._plan.size,))
        self._plan.velocity_and_gradient(u, v, ux, uy, vx, self._threads)
        return u, v, ux, uy, vx

    def gradient(self, x: ArrayLike | None = None, y: ArrayLike | None = None,
                 sigma: ArrayLike | None = None, *,
                 out: Any = None) -> tuple[Column, Column, Column]:
        """How the velocity changes: (du/dx, du/dy, dv/dx) [1/s]; dv/dy = -du/dx.

        ::

            du/dx               = sum_j g_j b 2 dx dy / r^2        g_j = gamma_j/(2 pi), q = r^2/S
            (dv/dx + du/dy)/2   = sum_j g_j b (dy^2 - dx^2)/r^2    b = (1 - (1 + q) exp(-q))/r^2
            (dv/dx - du/dy)/2   = sum_j g_j exp(-q)/S              half the vorticity

        Parameters and errors as those of velocity(); the norm of all four errs by the tolerance.

        Examples
        --------
        >>> import numpy as np, vortree
        >>> ux, uy, vx = vortree.Plan([0], [0], [np.pi], sigma=1.0).gradient([0.0], [0.0])
        >>> bool(np.isclose(vx[0] - uy[0], 1))          # the vorticity gamma/(pi sigma^2)
        True
        """
        px, py, shape = self._places(x, y)
        ux, uy, vx = results(out, 3, shape, px, py)
        self._plan.gradient_at(px, py, self._cores_of(sigma, px.size), ux, uy, vx, self._threads)
        return ux, uy, vx

    def stream_function(self, x: ArrayLike | None = None, y: ArrayLike | None = None,
                 sigma: ArrayLike | None = None, *,
                        out: Any = None) -> Column:
        """psi [m^2/s] with u = d psi/dy, v = -d psi/dx.

        ::

            psi = -sum_j gamma_j/(2 pi) (ln r + E1(r^2/S)/2),   E1(q) = int_q^inf exp(-t)/t dt

        Lengths under the logarithm are in the unit of the positions. Bare blobs contribute nothing
        at r = 0. Parameters and errors as those of velocity(); `out` is one array.

        Examples
        --------
        >>> import numpy as np, vortree
        >>> psi = vortree.Plan([0], [0], [2 * np.pi]).stream_function([np.e], [0.0])
        >>> bool(np.isclose(psi[0], -1))
        True
        """
        px, py, shape = self._places(x, y)
        (psi,) = results(out, 1, shape, px, py)
        self._plan.stream_function_at(px, py, self._cores_of(sigma, px.size), psi, self._threads)
        return psi

    def vorticity(self, x: ArrayLike | None = None, y: ArrayLike | None = None, *,
                  out: Any = None) -> Column:
        """omega [1/s], for pictures and checks.

        ::

            omega = sum_j gamma_j / (pi sigma_j^2) exp(-r^2/sigma_j^2)

        Blobs farther than sigma_j sqrt(ln(1/tolerance)) are left out; bare vortices are points
        without extent, and left out, too.

        Examples
        --------
        >>> import numpy as np, vortree
        >>> omega = vortree.Plan([0], [0], [np.pi], sigma=1.0).vorticity([0.0, 1.0], [0.0, 0.0])
        >>> bool(np.allclose(omega, [1, np.exp(-1)]))
        True
        """
        px, py, shape = self._places(x, y)
        (omega,) = results(out, 1, shape, px, py)
        self._plan.vorticity_at(px, py, omega, self._tolerance, self._threads)
        return omega

    def _places(self, x: ArrayLike | None,
                y: ArrayLike | None) -> tuple[Column, Column, tuple[int, ...]]:
        if x is not None:
            return places(x, y)
        px, py = np.empty(self._plan.size), np.empty(self._plan.size)
        self._plan.copy_places(px, py)
        return px, py, px.shape

    def _cores_of(self, sigma: ArrayLike | None, n: int) -> Column:
        if sigma is None:
            return _no_cores
        if not self._mean:
            raise ValueError('sigma of places counts with cores="mean" only')
        return per_point("sigma", np.ravel(sigma) if np.ndim(sigma) else sigma, n)

    def __len__(self) -> int:
        return self._plan.size

    def __repr__(self) -> str:
        return (f"Plan of {len(self)} vortices, method {self.method}, "
                f"tolerance {self._tolerance:g}")

    @property
    def tolerance(self) -> float:
        """What velocities are promised to."""
        return self._tolerance

    @property
    def method(self) -> str:
        """What sums: the method asked for, unless it gave way."""
        return self._plan.method

    @property
    def order(self) -> int:
        """The most terms of any series."""
        return self._plan.order

    @property
    def nbytes(self) -> int:
        """Memory held [bytes]."""
        return self._plan.nbytes

    @property
    def tree(self) -> Quadtree:
        """The tree that sums walk; empty by the method "direct"."""
        return Quadtree._of(self._plan.tree())


def velocity(x: ArrayLike, y: ArrayLike | None = None, gamma: ArrayLike | None = None,
             sigma: ArrayLike | None = None, *,
             at: Any = None, out: Any = None, **options: Any) -> tuple[Column, Column]:
    """Velocity (u, v) of vortex blobs at themselves, or at places: Plan in one call.

    Parameters
    ----------
    x, y, gamma, sigma
        As Plan takes them.
    at : (x, y), or an array of the shape (..., 2), optional
        Where; None: at the blobs.
    out
        As Plan.velocity takes it.
    **options
        tolerance, method, builder, cores, order, capacity, finest_level, threads, as Plan.

    Examples
    --------
    >>> import numpy as np, vortree
    >>> u, v = vortree.velocity([-1, 1], [0, 0], [2 * np.pi, 2 * np.pi], tolerance=1e-9)
    >>> v.round(6)
    array([-0.5,  0.5])
    """
    plan = Plan(x, y, gamma, sigma, **options)
    if at is None:
        return plan.velocity(out=out)
    return plan.velocity(*at, out=out) if isinstance(at, tuple) else plan.velocity(at, out=out)


def _whole(name: str, value: int) -> int:
    if int(value) != value or not 0 <= value < 2**32:
        raise ValueError(f"{name} is {value}; a whole number from 0 to 2^32 - 1 was expected")
    return int(value)
