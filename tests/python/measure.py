"""What a call costs, and neighbors beside scipy's cKDTree: the table of src/python/README.md.

    taskset -c 0 ./vortree python tests/python/measure.py

One thread. Both searches by turns, from arrays to the answer; the best of some runs, and the
median of the ratios of neighboring ones.
"""

import statistics
import time

import numpy as np
import vortree
from clouds import places
from scipy.spatial import cKDTree

RUNS, CALLS = 7, 4000


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def of_a_call(work):
    """Median microseconds."""
    return 1e6 * statistics.median(seconds(work) for _ in range(CALLS))


def by_turns(ours, theirs):
    pairs = [(seconds(ours), seconds(theirs)) for _ in range(RUNS)]
    ratio = statistics.median(b / a for a, b in pairs)
    best = [1e3 * min(times) for times in zip(*pairs)]
    return f"| {best[0]:.0f} | {best[1]:.0f} | {ratio:.1f} |"


def matrix_of(tree, reach):
    return tree.sparse_distance_matrix(tree, reach, output_type="coo_matrix")


def calls():
    rng = np.random.default_rng(1)
    nobody = vortree.Plan([], [], [], threads=1)
    x, y = places("uniform", 1000, rng)
    plan = vortree.Plan(x, y, rng.standard_normal(1000), 0.02, threads=1)
    at = np.empty(0)
    print("microseconds of velocity(), median")
    print(f"no blobs {of_a_call(nobody.velocity):.1f}")
    print(f"no blobs, at no places {of_a_call(lambda: nobody.velocity(at, at)):.1f}")
    print(f"1000 blobs {of_a_call(plan.velocity):.0f}")
    print(f"making the plan {of_a_call(lambda: vortree.Plan(x, y, x, 0.02, threads=1)):.0f}")


def searches(n=100_000):
    print(f"\n{n} points, milliseconds: | Neighbors | cKDTree | times as fast |")
    for kind in ("uniform", "clusters"):
        x, y = places(kind, n, np.random.default_rng(2))
        area = 1 if kind == "uniform" else 5e-6
        for about in (6, 20):
            reach = np.sqrt(area * about / np.pi / n)
            rows = np.stack([x, y], 1)

            def near():
                return vortree.Neighbors(x, y, reach, threads=1)

            def tree():
                return cKDTree(rows)

            def box():
                return vortree.Neighbors(x, y, reach, boxsize=1, threads=1)

            def tree_in_box():
                return cKDTree(rows, boxsize=1)

            found = near().rows()[1].size / n
            print(f"{kind}, {found:.1f} neighbors each")
            print("  query_pairs, ndarray", by_turns(
                lambda: near().query_pairs("ndarray"),
                lambda: tree().query_pairs(reach, output_type="ndarray")))
            print("  query_pairs, set", by_turns(
                lambda: near().query_pairs(), lambda: tree().query_pairs(reach)))
            print("  sparse_distance_matrix", by_turns(
                lambda: near().sparse_distance_matrix(), lambda: matrix_of(tree(), reach)))
            print("  query_ball_point, lists", by_turns(
                lambda: near().query_ball_point(y, x, reach),
                lambda: tree().query_ball_point(rows[:, ::-1], reach)))
            print("  in a box: query_pairs, ndarray", by_turns(
                lambda: box().query_pairs("ndarray"),
                lambda: tree_in_box().query_pairs(reach, output_type="ndarray")))
            print("  in a box: sparse_distance_matrix", by_turns(
                lambda: box().sparse_distance_matrix(), lambda: matrix_of(tree_in_box(), reach)))
            print("  in a box: query_ball_point, lists", by_turns(
                lambda: box().query_ball_point(y, x, reach),
                lambda: tree_in_box().query_ball_point(rows[:, ::-1], reach)))
            print("  rows() in a box against rows() of the plane", by_turns(
                lambda: box().rows(), lambda: near().rows()))


if __name__ == "__main__":
    calls()
    searches()
