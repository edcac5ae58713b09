import numpy as np
import pytest
import scipy.sparse
import vortree
from clouds import KINDS, places
from scipy.spatial import cKDTree
from test_plan import by_program

RULES = {"max": np.maximum, "mean": lambda a, b: (a + b) / 2, "own": lambda a, b: a + 0 * b}


def some(seed):
    """Any kind of cloud, and a radius within which some neighbors lie."""
    rng = np.random.default_rng(seed)
    n = int(rng.integers(2, 400))
    x, y = places(KINDS[seed % len(KINDS)], n, rng)
    return x, y, float(rng.random() * 3 / np.sqrt(n)) + 1e-9


def in_order(pairs):
    return pairs[np.lexsort(pairs.T[::-1])]


@pytest.mark.parametrize("seed", range(120))
def test_of_one_reach_they_are_those_of_scipy(seed):
    x, y, reach = some(seed)
    near, tree = vortree.Neighbors(x, y, reach), cKDTree(np.stack([x, y], 1))
    theirs = tree.query_pairs(reach, output_type="ndarray")
    assert np.array_equal(in_order(near.query_pairs("ndarray")), in_order(theirs))
    assert near.query_pairs() == tree.query_pairs(reach)
    ours = near.sparse_distance_matrix()
    theirs = tree.sparse_distance_matrix(tree, reach, output_type="coo_matrix").tocsr()
    assert np.allclose((ours - theirs).data, 0, atol=1e-15)
    assert ours.nnz == theirs.nnz - x.size  # who is not its own neighbor
    px, py = places("uniform", 50, np.random.default_rng(seed + 1000))
    theirs = tree.query_ball_point(np.stack([px, py], 1), reach)
    ours = near.query_ball_point(px, py, reach)
    assert [*ours] == [sorted(row) for row in theirs]
    assert np.array_equal(near.query_ball_point(px, py, reach, return_length=True),
                          [len(row) for row in theirs])


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("kind", KINDS)
def test_of_many_reaches_they_are_those_of_the_rule(rule, kind):
    rng = np.random.default_rng(KINDS.index(kind))
    x, y = places(kind, 300, rng)
    reach = 0.2 * rng.random(300) ** 4
    r = np.hypot(x[:, None] - x, y[:, None] - y)
    asked = RULES[rule](reach[:, None], reach)
    truth = (r < asked) & ~np.eye(300, dtype=bool)
    # A distance next to the reach may round to either side here.
    assert not (abs(r - asked) < 1e-15)[~np.eye(300, dtype=bool)].any()
    near = vortree.Neighbors(x, y, reach, rule=rule)
    indptr, indices, distance = near.rows(distances=True)
    found = scipy.sparse.csr_matrix((np.ones(indices.size), indices, indptr), shape=(300, 300))
    assert np.array_equal(found.toarray() > 0, truth)
    row = np.repeat(np.arange(300), np.diff(indptr))
    assert np.allclose(distance, r[row, indices], rtol=1e-15, atol=0)
    if rule == "own":
        with pytest.raises(ValueError, match="own"):
            near.rows(half=True)
        with pytest.raises(ValueError, match="own"):
            near.query_pairs()
    else:
        half = near.rows(half=True)
        assert half[1].size == np.count_nonzero(truth) / 2
        assert near.query_pairs() == {(i, j) for i, j in np.argwhere(truth).tolist() if i < j}


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("half", [False, True])
def test_the_same_rows_as_the_program(tmp_path, rule, half):
    if rule == "own" and half:
        return
    rng = np.random.default_rng(5)
    x, y = places("clusters", 2000, rng)
    reach = 1e-3 * rng.random(2000)
    there = by_program("neighbors", tmp_path, {"x": x, "y": y, "reach": reach}, "--rule", rule,
                       *["--half"] * half)
    indptr, indices = vortree.Neighbors(x, y, reach, rule=rule).rows(half)
    assert np.array_equal(indptr, there["start"]) and np.array_equal(indices, there["index"])


def test_rows_are_a_sparse_matrix_as_they_are():
    x, y = places("uniform", 500, np.random.default_rng(6))
    indptr, indices, distance = vortree.Neighbors(x, y, 0.1).rows(distances=True)
    matrix = scipy.sparse.csr_matrix((distance, indices, indptr), copy=False)
    assert np.shares_memory(matrix.data, distance) and (matrix != matrix.T).nnz == 0
    assert (indptr.dtype, indices.dtype) == (np.int64, np.int32)


def test_distances_are_told_of_lengths_of_any_size():
    for unit in (1e-300, 1e-160, 1.0, 1e160, 1e300):
        near = vortree.Neighbors([0, 3 * unit], [0, 4 * unit], 6 * unit)
        assert np.allclose(near.rows(distances=True)[2], 5 * unit, rtol=1e-15, atol=0)


def test_every_form_of_the_distances_holds_the_same():
    x, y = places("uniform", 60, np.random.default_rng(7))
    near = vortree.Neighbors(x, y, 0.3)
    whole = near.sparse_distance_matrix().toarray()
    for form in ("coo_matrix", "dok_matrix"):
        found = near.sparse_distance_matrix(form)
        assert found.getformat() == form[:3] and np.array_equal(found.toarray(), whole)
    entries = near.sparse_distance_matrix("ndarray")
    assert np.array_equal(whole[entries["i"], entries["j"]], entries["v"])
    assert near.sparse_distance_matrix("dict") == dict(
        zip(zip(entries["i"].tolist(), entries["j"].tolist()), entries["v"].tolist()))


def test_balls_take_places_of_any_shape():
    x, y = places("uniform", 200, np.random.default_rng(8))
    near = vortree.Neighbors(x, y, 0.1)
    one = near.query_ball_point(0.5, 0.5, 0.2)
    assert one == sorted(np.flatnonzero(np.hypot(x - 0.5, y - 0.5) < 0.2).tolist())
    assert near.query_ball_point([0.5, 0.5], r=0.2) == one
    grid = near.query_ball_point(np.full((2, 3), 0.5), np.full((2, 3), 0.5), 0.2)
    assert grid.shape == (2, 3) and grid[1, 2] == one
    indptr, indices = near.query_ball_point([0.5, 9], [0.5, 9], [0.2, 1], output_type="rows")
    assert indices.tolist() == one and indptr.tolist() == [0, len(one), len(one)]
    assert near.query_ball_point([[x[3], y[3]]], r=0.0, return_length=True).tolist() == [0]


def test_a_distance_that_equals_the_reach_is_not_nearer():
    assert vortree.Neighbors([0, 1], [0, 0], 1).query_pairs() == set()
    assert vortree.Neighbors([0, 1], [0, 0], np.nextafter(1, 2)).query_pairs() == {(0, 1)}


def test_particles_that_moved_are_placed_anew():
    rng = np.random.default_rng(9)
    near = vortree.Neighbors(*places("uniform", 100, rng), 0.1)
    for n in (100, 5, 3000):
        x, y = places("ring", n, rng)
        near.query_ball_point(0, 0, 1)
        near.update(x, y, 0.05)
        again = vortree.Neighbors(np.stack([x, y], 1), 0.05)
        assert len(near) == near.n == n and near.query_pairs() == again.query_pairs()
        assert near.query_ball_point(0, 0, 0.6) == list(range(n))
    near.update(np.zeros((4, 2)), [1, 1, 1, 1])
    assert near.rows()[1].size == 12


def test_what_was_given_may_change_later():
    x, y = places("uniform", 100, np.random.default_rng(10))
    near = vortree.Neighbors(x, y, 0.2)
    before = near.rows(distances=True)
    x[:] = y[:] = np.nan
    for was, now in zip(before, near.rows(distances=True)):
        assert np.array_equal(was, now)
    assert near.query_ball_point(0.5, 0.5, 2) == list(range(100))


def test_nobody_has_no_neighbors():
    near = vortree.Neighbors([], [], [])
    assert near.rows()[0].tolist() == [0] and near.query_pairs("ndarray").shape == (0, 2)
    assert near.query_ball_point(0, 0, 1) == []
    assert near.query_ball_point([], [], 1, return_length=True).shape == (0,)
    assert near.sparse_distance_matrix().shape == (0, 0)


@pytest.mark.parametrize("given, said", [
    (dict(reach=None), r"reach is missing"),
    (dict(reach=[1]), r"reach has the shape \(1,\); x has 2 values"),
    (dict(reach=-1), r"reach\[0\] is -1"),
    (dict(reach=[1, np.nan]), r"reach\[1\] is nan"),
    (dict(x=[0, np.nan]), r"x\[1\] is nan"),
    (dict(y=[0, np.inf]), r"y\[1\] is inf"),
    (dict(y=[0]), r"y has the shape \(1,\), x has \(2,\)"),
    (dict(x=np.zeros((2, 2))), r"x has two dimensions"),
    (dict(rule="least"), r'rule is "least"; it must be one of "max", "mean", "own"'),
])
def test_wrong_input_is_refused_in_one_sentence(given, said):
    right = {"x": [0, 1], "y": [0, 0], "reach": 1, **given}
    with pytest.raises(ValueError, match=said):
        vortree.Neighbors(**right)
    if "rule" not in given:
        near = vortree.Neighbors([0, 1], [0, 0], 2)
        with pytest.raises(ValueError, match=said):
            near.update(**right)
        assert near.query_pairs() == {(0, 1)}


@pytest.mark.parametrize("ask, given, said", [
    ("query_pairs", ("list",), r'output_type is "list"; it must be one of set, ndarray'),
    ("sparse_distance_matrix", ("set",), r'output_type is "set"'),
    ("query_ball_point", (0, 0), r"r is missing"),
    ("query_ball_point", (0, 0, -1), r"radius\[0\] is -1"),
    ("query_ball_point", ([0, np.nan], [0, 0], 1), r"x\[1\] is nan"),
    ("query_ball_point", ([0, 1], [0, 0], [1]), r"r has the shape \(1,\); x has 2 values"),
])
def test_wrong_questions_are_refused_in_one_sentence(ask, given, said):
    with pytest.raises(ValueError, match=said):
        getattr(vortree.Neighbors([0, 1], [0, 0], 1), ask)(*given)
