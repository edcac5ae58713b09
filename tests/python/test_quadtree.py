import numpy as np
import pytest
import vortree
from clouds import KINDS, places


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("capacity", [1, 10, 1000])
def test_cells_hold_their_points_and_split_where_they_are_crowded(kind, capacity):
    x, y = places(kind, 500, np.random.default_rng(1))
    tree = vortree.Quadtree(x, y, capacity=capacity)
    cells, order, (x0, y0, side) = tree.cells, tree.order, tree.domain
    assert tree == vortree.Quadtree(x, y, capacity=capacity, builder="forward", threads=2)
    assert np.array_equal(np.sort(order), np.arange(500)) and len(tree) == 500
    own, (cx, cy) = tree.sides(), tree.centres()
    # Codes are rounded by 2^-20 of a cell of level 31, centres and distances from them once each.
    slack = side * 2.0**-51 + 2 * np.spacing(max(abs(x).max(), abs(y).max()))
    for c, cell in enumerate(cells):
        inside = order[cell["first"]:cell["last"]]
        assert (abs(x[inside] - cx[c]) <= own[c] / 2 + slack).all()
        assert (abs(y[inside] - cy[c]) <= own[c] / 2 + slack).all()
        assert np.isclose(cx[c], x0 + (cell["i"] + 0.5) * own[c], rtol=1e-15, atol=slack)
        assert np.isclose(cy[c], y0 + (cell["j"] + 0.5) * own[c], rtol=1e-15, atol=slack)
        children = cells[cell["first_child"]:cell["last_child"]]
        if children.size:
            assert (children["parent"] == c).all() and inside.size > capacity
            assert sum(children["last"] - children["first"]) == inside.size
        else:
            assert inside.size <= capacity or cell["level"] == 31
    leaves = cells[tree.childless]
    assert leaves["first"].tolist() == [0, *leaves["last"][:-1]] and leaves["last"][-1] == 500
    assert tree.depth == cells["level"].max() and (np.diff(tree.keys.astype(float)) >= 0).all()


def test_rows_of_points_are_points():
    x, y = places("uniform", 100, np.random.default_rng(2))
    assert vortree.Quadtree(np.stack([x, y], 1)) == vortree.Quadtree(x, y)
    assert vortree.Quadtree(x, y) != vortree.Quadtree(y, x)
    assert vortree.Quadtree(x, y) != 3
    empty = vortree.Quadtree([], [])
    assert len(empty) == 0 and empty.cells.size == 0 and empty.depth == -1
    assert vortree.Quadtree(x, y, capacity=1, finest_level=2).depth == 2


def test_views_keep_their_tree_and_cannot_be_written():
    order = vortree.Quadtree(*places("uniform", 10000, np.random.default_rng(3))).order
    assert not order.flags.writeable and not order.flags.owndata
    assert np.array_equal(np.sort(order), np.arange(10000))
    with pytest.raises(ValueError, match="read-only"):
        order[0] = 1


@pytest.mark.parametrize("given, said", [
    (dict(capacity=0), r"n_ctrl|capacity"),
    (dict(capacity=-1), r"capacity is -1"),
    (dict(capacity=2.5), r"capacity is 2.5"),
    (dict(finest_level=32), r"finest"),
    (dict(builder="sideways"), r'builder is "sideways"'),
    (dict(x=[0, np.nan]), r"x\[1\] is nan"),
    (dict(y=[1]), r"y has the shape"),
])
def test_wrong_input_is_refused_in_one_sentence(given, said):
    with pytest.raises(ValueError, match=said):
        vortree.Quadtree(**{"x": [0, 1], "y": [0, 0], **given})
