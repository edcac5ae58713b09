"""Blobs and particles to try; every set follows from its seed alone."""

import numpy as np

KINDS = ("uniform", "clusters", "duplicates", "line", "ring", "one place")


def places(kind, n, rng):
    """(x, y) of n points in or near the unit square."""
    s, t = rng.random(n), rng.random(n)
    if kind == "uniform":
        return s, t
    if kind == "clusters":
        k = rng.integers(0, 5, n)
        return 0.2 * k + 1e-3 * s, 0.3 * (k % 3) + 1e-3 * t
    if kind == "duplicates":
        return np.floor(7 * s) / 7.1, np.floor(7 * t) / 6.9
    if kind == "line":
        return s, rng.random() * s + 0.1
    if kind == "ring":
        return 0.5 * np.cos(2 * np.pi * s), 0.5 * np.sin(2 * np.pi * s)
    return np.full(n, 0.3), np.full(n, 0.7)


def blobs(n, seed, cores=True):
    rng = np.random.default_rng(seed)
    x, y = places("uniform", n, rng)
    return x, y, rng.standard_normal(n), 0.02 * (0.5 + rng.random(n)) if cores else None
