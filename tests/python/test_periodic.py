"""Neighbors in boxes that go around, beside scipy's and beside all pairs of nearest images."""

import numpy as np
import pytest
import vortree
from clouds import KINDS, places
from scipy.spatial import cKDTree
from test_neighbors import RULES, in_order
from test_plan import by_program

BOXES = (1.0, (1.0, 1.0), (1.25, 0.75), (1.0, 0.0), (0.0, 0.8))


def into(values, length):
    """Images in [0, length)."""
    if length == 0:
        return values
    values = np.mod(values, length)
    return np.where(values < length, values, 0.0)


def some(seed):
    """Any kind of cloud in any kind of box, some of its points at the edges, and a radius."""
    rng = np.random.default_rng(seed)
    n = int(rng.integers(2, 300))
    box = BOXES[seed % len(BOXES)]
    lengths = np.broadcast_to(box, 2)
    columns = []
    for values, length in zip(places(KINDS[seed % len(KINDS)], n, rng), lengths):
        values = into(values + rng.random(), length)
        if length:
            values[rng.random(n) < 0.1] = 0.0
            values[rng.random(n) < 0.1] = np.nextafter(length, 0)
        columns.append(values)
    return *columns, box, float(rng.random() * 3 / np.sqrt(n)) + 1e-9


def nearest(values, others, length):
    d = others - np.asarray(values)[:, None]
    return np.minimum(abs(d), np.minimum(abs(d - length), abs(d + length))) if length else abs(d)


def all_near(x, y, box, asked, px=None, py=None):
    """Who is nearer than asked, row by row: all pairs of nearest images, in the rule's own order."""
    lx, ly = np.broadcast_to(box, 2)
    dx = nearest(x if px is None else px, x, lx)
    dy = nearest(y if py is None else py, y, ly)
    return dx * dx + dy * dy < asked * asked


def matrix(near):
    indptr, indices = near.rows()
    found = np.zeros((len(near), len(near)), dtype=int)
    np.add.at(found, (np.repeat(np.arange(len(near)), np.diff(indptr)), indices), 1)
    return found


@pytest.mark.parametrize("seed", range(120))
def test_of_one_reach_they_are_those_of_scipy(seed):
    x, y, box, reach = some(seed)
    near = vortree.Neighbors(x, y, reach, boxsize=box)
    tree = cKDTree(np.stack([x, y], 1), boxsize=box)
    theirs = tree.query_pairs(reach, output_type="ndarray")
    assert np.array_equal(in_order(near.query_pairs("ndarray")), in_order(theirs))
    assert near.query_pairs() == tree.query_pairs(reach)
    ours = near.sparse_distance_matrix()
    theirs = tree.sparse_distance_matrix(tree, reach, output_type="coo_matrix").tocsr()
    assert np.allclose((ours - theirs).data, 0, atol=1e-15)
    assert ours.nnz == theirs.nnz - x.size  # who is not its own neighbor
    # Places anywhere, of which the images in the box count; scipy asks for those itself.
    px, py = places("uniform", 50, np.random.default_rng(seed + 1000))
    theirs = tree.query_ball_point(np.stack([px, py], 1), reach)
    assert [*near.query_ball_point(px, py, reach)] == [sorted(row) for row in theirs]
    lx, ly = np.broadcast_to(box, 2)
    images = vortree.Neighbors(x, y, reach, boxsize=box).query_ball_point(
        px - 2 * lx, py + 3 * ly, reach, return_length=True)
    assert np.mean(images != [len(row) for row in theirs]) < 0.1  # px - 2 lx is rounded


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("box", BOXES)
def test_of_many_reaches_they_are_the_nearest_images(rule, kind, box):
    rng = np.random.default_rng(KINDS.index(kind))
    lengths = np.broadcast_to(box, 2)
    x, y = (into(values, length) for values, length in zip(places(kind, 200, rng), lengths))
    reach = 0.4 * rng.random(200) ** 4
    reach[:20] = 0
    truth = all_near(x, y, box, RULES[rule](reach[:, None], reach)) & ~np.eye(200, dtype=bool)
    near = vortree.Neighbors(x, y, reach, rule=rule, boxsize=box)
    assert np.array_equal(matrix(near), truth)
    if rule != "own":
        half = near.rows(half=True)
        assert half[1].size == np.count_nonzero(truth) / 2
        assert near.query_pairs() == {(i, j) for i, j in np.argwhere(truth).tolist() if i < j}


@pytest.mark.parametrize("reach", [0.0, 0.5, np.nextafter(0.5, 1), 0.6, 0.75, 1.0, 10.0])
def test_half_the_box_and_beyond_each_pair_counts_once(reach):
    rng = np.random.default_rng(3)
    x, y = np.round(8 * rng.random((2, 150))) % 8 / 8  # places at half the box are there
    for box in (1.0, (1.0, 0.0)):
        truth = all_near(x, y, box, reach) & ~np.eye(150, dtype=bool)
        assert np.array_equal(matrix(vortree.Neighbors(x, y, reach, boxsize=box)), truth)
        if reach:  # where a distance equals the reach scipy counts it
            theirs = cKDTree(np.stack([x, y], 1), boxsize=box)
            below = reach * (1 - 1e-12) if 8 * reach % 1 == 0 else reach
            near = vortree.Neighbors(x, y, reach, boxsize=box)
            assert near.query_pairs() == theirs.query_pairs(below)


def test_the_edges_are_one_place():
    last = np.nextafter(1, 0)
    near = vortree.Neighbors([0, last, 0.5], [0.3, 0.3, 0.3], 1e-15, boxsize=1)
    assert near.query_pairs() == {(0, 1)}
    assert near.rows(distances=True)[2].tolist() == [1 - last, 1 - last]
    assert near.query_ball_point(-1e-18, 0.3, 1e-15) == [0, 1]


def test_a_box_is_none_if_nothing_goes_around():
    x, y = places("clusters", 300, np.random.default_rng(4))
    plane = vortree.Neighbors(x - 5, y + 5, 0.01)
    for box in (0, (0, 0), None):
        near = vortree.Neighbors(x - 5, y + 5, 0.01, boxsize=box)
        assert all(map(np.array_equal, near.rows(distances=True), plane.rows(distances=True)))


def test_who_moves_stays_in_the_box():
    rng = np.random.default_rng(5)
    near = vortree.Neighbors(rng.random((10, 2)), 0.1, boxsize=(1, 2))
    for n in (100, 3, 1000):
        x, y = rng.random((2, n))
        near.query_ball_point(0, 0, 0.3)
        near.update(x, 2 * y, 0.05)
        again = vortree.Neighbors(x, 2 * y, 0.05, boxsize=(1, 2))
        assert near.query_pairs() == again.query_pairs() == cKDTree(
            np.stack([x, 2 * y], 1), boxsize=(1, 2)).query_pairs(0.05)
        assert near.query_ball_point(0, 0, 0.3) == again.query_ball_point(0, 0, 0.3)
        with pytest.raises(ValueError, match="in the periodic box"):
            near.update([1.0], [0.0], 0.05)
        assert near.query_pairs() == again.query_pairs()
    assert near.boxsize.tolist() == [1, 2] and "boxsize (1, 2)" in repr(near)
    assert vortree.Neighbors([0], [0], 1).boxsize is None


@pytest.mark.parametrize("rule", RULES)
def test_the_same_rows_as_the_program(tmp_path, rule):
    rng = np.random.default_rng(6)
    x, y, reach = *rng.random((2, 1500)), 0.2 * rng.random(1500) ** 3
    there = by_program("neighbors", tmp_path, {"x": x, "y": y, "reach": reach}, "--rule", rule,
                       "--periodic", "1,1.5")
    near = vortree.Neighbors(x, y, reach, rule=rule, boxsize=[1, 1.5])
    assert all(map(np.array_equal, near.rows(), (there["start"], there["index"])))


def test_rows_do_not_depend_on_threads():
    rng = np.random.default_rng(7)
    x, y, reach = *rng.random((2, 5000)), 0.05 * rng.random(5000)
    one, four = (vortree.Neighbors(x, y, reach, boxsize=1, threads=k).rows() for k in (1, 4))
    assert all(map(np.array_equal, one, four))


@pytest.mark.parametrize("given, said", [
    (dict(boxsize=-1), r"the periodic box has the length -1 along x; it must be finite and >= 0"),
    (dict(boxsize=(1, np.inf)), r"length inf along y"),
    (dict(boxsize=[1, 2, 3]), r"boxsize has the shape \(3,\); a number or two were expected"),
    (dict(boxsize="wide"), r"boxsize is of type <U4; real numbers were expected"),
    (dict(x=[0, 1]), r"^x\[1\] is 1; in the periodic box it must be in \[0, 1\)$"),
    (dict(y=[-1e-300, 0]), r"^y\[0\] is -1e-300; in the periodic box it must be in \[0, 1\)$"),
    (dict(x=[0, np.nan]), r"x\[1\] is nan"),
    (dict(y=[0, np.nan], boxsize=(1, 0)), r"y\[1\] is nan"),
    (dict(reach=[0, -1]), r"reach\[1\] is -1"),
])
def test_wrong_boxes_are_refused_in_one_sentence(given, said):
    with pytest.raises(ValueError, match=said):
        vortree.Neighbors(**{"x": [0, 0.5], "y": [0, 0], "reach": 1, "boxsize": 1, **given})
