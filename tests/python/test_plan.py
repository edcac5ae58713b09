import subprocess

import h5py
import numpy as np
import pytest
import vortree
from clouds import blobs
from vortree._runs import find_program

PI = np.pi


def direct(x, y, gamma, sigma, tx, ty):
    """u, v, du/dx, du/dy, dv/dx, psi, omega by the formulas of the docstrings; sigma > 0."""
    from scipy.special import exp1

    dx, dy = tx[:, None] - x, ty[:, None] - y
    r2, s2, g = dx * dx + dy * dy, sigma * sigma, gamma / (2 * PI)
    q = r2 / s2
    a, b = -np.expm1(-q) / r2, (1 - (1 + q) * np.exp(-q)) / r2
    turn = g * np.exp(-q) / s2
    shear = g * b * (dy * dy - dx * dx) / r2
    return (np.sum(-g * a * dy, 1), np.sum(g * a * dx, 1), np.sum(g * b * 2 * dx * dy / r2, 1),
            np.sum(shear - turn, 1), np.sum(shear + turn, 1),
            -np.sum(g * (0.5 * np.log(r2) + exp1(q) / 2), 1), np.sum(2 * turn, 1))


def off(found, exact):
    return np.linalg.norm(found - exact) / np.linalg.norm(exact)


def by_program(command, folder, columns, *words, **targets):
    with h5py.File(folder / "in.h5", "w") as file:
        for name, values in columns.items():
            file[name] = values
    words = [*words]
    if targets:
        with h5py.File(folder / "at.h5", "w") as file:
            file["x"], file["y"] = targets["x"], targets["y"]
        words += ["--targets", folder / "at.h5"]
    subprocess.run([find_program(), command, folder / "in.h5", "--out", folder / "out.h5", *words],
                   check=True, capture_output=True)
    with h5py.File(folder / "out.h5") as file:
        return {name: part[()] for name, part in file.items()}


@pytest.mark.parametrize("cores", [True, False])
@pytest.mark.parametrize("method", ["fmm", "boxes", "direct"])
@pytest.mark.parametrize("tolerance", [1e-3, 1e-9])
def test_the_same_bits_as_the_program(tmp_path, cores, method, tolerance):
    x, y, gamma, sigma = blobs(3000, 1, cores)
    tx, ty, _, _ = blobs(500, 2)
    columns = {"x": x, "y": y, "gamma": gamma, **({"sigma": sigma} if cores else {})}
    words = ["--method", method, "--tolerance", repr(tolerance)]
    plan = vortree.Plan(x, y, gamma, sigma, method=method, tolerance=tolerance)
    there = by_program("velocity", tmp_path, columns, *words)
    u, v = plan.velocity()
    assert np.array_equal(u, there["u"]) and np.array_equal(v, there["v"])
    there = by_program("velocity", tmp_path, columns, *words, x=tx, y=ty)
    u, v = plan.velocity(tx, ty)
    assert np.array_equal(u, there["u"]) and np.array_equal(v, there["v"])


def test_all_fields_keep_the_tolerance():
    x, y, gamma, sigma = blobs(2000, 3)
    tx, ty, _, _ = blobs(300, 4)
    u, v, ux, uy, vx, psi, omega = direct(x, y, gamma, sigma, tx, ty)
    for tolerance in (1e-4, 1e-10):
        plan = vortree.Plan(x, y, gamma, sigma, tolerance=tolerance)
        assert off(np.concatenate(plan.velocity(tx, ty)), np.concatenate([u, v])) < tolerance
        found = plan.gradient(tx, ty)
        assert off(np.concatenate(found), np.concatenate([ux, uy, vx])) < 2 * tolerance
        assert off(plan.stream_function(tx, ty), psi) < tolerance
        assert off(plan.vorticity(tx, ty), omega) < 10 * tolerance


def test_at_the_blobs_is_at_their_places():
    x, y, gamma, sigma = blobs(700, 5)
    plan = vortree.Plan(x, y, gamma, sigma, tolerance=1e-11)
    for ask in (plan.gradient, plan.stream_function, plan.vorticity):
        assert np.array_equal(ask(), ask(x, y))
    u, v, ux, uy, vx = plan.velocity_and_gradient()
    assert off(np.concatenate([u, v]), np.concatenate(plan.velocity(x, y))) < 4e-11
    assert off(np.concatenate([ux, uy, vx]), np.concatenate(plan.gradient())) < 4e-10


def test_the_mean_of_both_cores_conserves_the_impulse():
    x, y, gamma, sigma = blobs(400, 6)
    plan = vortree.Plan(x, y, gamma, sigma, cores="mean", method="direct")
    u, v = plan.velocity()
    size = np.sum(np.abs(gamma) * np.hypot(u, v))
    assert np.hypot(np.sum(gamma * u), np.sum(gamma * v)) < 400 * 2**-50 * size
    again, _ = plan.velocity(x, y, sigma)
    assert off(again, u) < 400 * 2**-50


def test_a_place_may_be_given_in_any_shape():
    x, y, gamma, sigma = blobs(100, 7)
    plan = vortree.Plan(x, y, gamma, sigma)
    tx, ty, _, _ = blobs(12, 8)
    u, v = plan.velocity(tx, ty)
    for shape in ((12,), (3, 4), (2, 3, 2)):
        found = plan.velocity(tx.reshape(shape), ty.reshape(shape))
        assert found[0].shape == shape and np.array_equal(found[1].ravel(), v)
        found = plan.velocity(np.stack([tx, ty], -1).reshape(*shape, 2))
        assert found[0].shape == shape and np.array_equal(found[0].ravel(), u)
    assert plan.velocity(tx[0], ty[0])[0].shape == ()
    assert plan.velocity([], [])[0].shape == (0,)


def test_blobs_may_be_given_in_any_form():
    x, y, gamma, sigma = blobs(100, 9)
    u, v = vortree.Plan(x, y, gamma, sigma).velocity()
    rows = np.stack([x, y], 1)
    wide = np.empty((4, 200))
    wide[:, ::2] = x, y, gamma, sigma
    readonly = x.copy()
    readonly.flags.writeable = False
    shifted = np.frombuffer(b"\0" + x.tobytes(), np.uint8)[1:].view(np.float64)
    for given in [(rows, gamma, sigma), (rows.tolist(), gamma, sigma), tuple(wide[:, ::2]),
                  (x.tolist(), list(y), tuple(gamma), sigma), (readonly, y, gamma, sigma),
                  (x.astype(">f8"), y.astype(np.longdouble), gamma, sigma),
                  (shifted, y, gamma, sigma), (x.astype(object), y, gamma, sigma)]:
        assert np.array_equal(vortree.Plan(*given).velocity()[0], u)
    assert np.array_equal(vortree.Plan(rows, gamma=gamma, sigma=sigma).velocity()[1], v)
    assert np.array_equal(vortree.velocity(rows, gamma, sigma=sigma)[1], v)
    assert np.array_equal(vortree.velocity(x, y, gamma, 0.1)[0],
                          vortree.Plan(x, y, gamma, np.full(100, 0.1)).velocity()[0])
    there = vortree.velocity(x, y, gamma, sigma, at=(y, x))
    assert np.array_equal(there, vortree.velocity(x, y, gamma, sigma, at=np.stack([y, x], 1)))
    whole = vortree.Plan(np.arange(9), np.zeros(9, int), np.ones(9, np.float32)).velocity()
    assert np.array_equal(whole, vortree.Plan(np.arange(9.0), np.zeros(9), np.ones(9)).velocity())
    assert len(vortree.Plan([], [], [])) == 0


def test_the_plan_keeps_nothing_of_what_was_given():
    x, y, gamma, sigma = (values.copy() for values in blobs(300, 10))
    plan = vortree.Plan(x, y, gamma, sigma)
    asks = (plan.velocity, plan.gradient, plan.stream_function, plan.vorticity)
    before = [ask() for ask in asks]
    for values in (x, y, gamma, sigma):
        values[:] = np.nan
    for ask, was in zip(asks, before):
        assert np.array_equal(ask(), was)


def test_any_number_of_threads_and_either_builder_give_the_same_bits():
    x, y, gamma, sigma = blobs(20000, 11)
    one = vortree.Plan(x, y, gamma, sigma, threads=1).velocity()
    for options in ({"threads": 2}, {"threads": 5}, {}, {"builder": "forward"}):
        assert np.array_equal(vortree.Plan(x, y, gamma, sigma, **options).velocity(), one)


def test_results_go_where_they_are_wanted():
    x, y, gamma, sigma = blobs(50, 12)
    plan = vortree.Plan(x, y, gamma, sigma)
    room = np.full((5, 50), np.nan)
    u, v = plan.velocity(out=room[:2])
    assert np.shares_memory(u, room) and np.array_equal(room[1], plan.velocity()[1])
    psi = np.empty(50)
    assert plan.stream_function(out=psi) is psi and plan.vorticity(out=(psi,)) is psi
    assert plan.velocity_and_gradient(out=room)[4].base is room
    assert not np.isnan(room).any()


@pytest.mark.parametrize("out, said", [
    (lambda a: (a,), r"out has 1 arrays; 2 were expected"),
    (lambda a: (a, a), r"out\[1\] shares memory"),
    (lambda a: (a, a[:40].copy()), r"out\[1\] has the shape \(40,\); \(50,\) was expected"),
    (lambda a: (a, a.astype("f4")), r"out\[1\] is of type float32; an array of float64"),
    (lambda a: (a, a.tolist()), r"out\[1\] is of type list"),
    (lambda a: (a, np.empty(100)[::2]), r"out\[1\] must be C-contiguous"),
    (lambda a: (a, np.broadcast_to(0.0, 50)), r"out\[1\] must be C-contiguous"),
])
def test_an_array_that_does_not_fit_is_refused(out, said):
    with pytest.raises(ValueError, match=said):
        vortree.Plan(*blobs(50, 13)).velocity(out=out(np.empty(50)))


def test_a_result_must_not_lie_upon_the_places():
    tx, ty, _, _ = blobs(20, 14)
    with pytest.raises(ValueError, match="shares memory"):
        vortree.Plan(*blobs(50, 13)).velocity(tx, ty, out=(tx, np.empty(20)))


def broken(name, k, value):
    columns = dict(zip(("x", "y", "gamma", "sigma"), (a.copy() for a in blobs(20, 15))))
    columns[name][k] = value
    return columns


@pytest.mark.parametrize("name", ["x", "y", "gamma", "sigma"])
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_what_is_not_finite_is_named(name, value):
    with pytest.raises(ValueError, match=rf"{name}\[7\] is {value}; it must be finite"):
        vortree.Plan(**broken(name, 7, value))


@pytest.mark.parametrize("given, said", [
    (dict(y=[0]), r"y has the shape \(1,\), x has \(2,\)"),
    (dict(y=None), r"y is missing"),
    (dict(gamma=None), r"gamma is missing"),
    (dict(gamma=[1, 2, 3]), r"gamma has the shape \(3,\); x has 2 values"),
    (dict(gamma=1), r"gamma has the shape \(\); x has 2 values"),
    (dict(sigma=[0.1]), r"sigma has the shape \(1,\); x has 2 values"),
    (dict(sigma=-1), r"sigma\[0\] is -1; it must be finite and >= 0"),
    (dict(x=np.zeros((2, 3)), y=None), r"x has the shape \(2, 3\)"),
    (dict(x=np.zeros((2, 2)), sigma=0.1), r"x has two dimensions"),
    (dict(x=np.zeros((1, 2, 2)), y=np.zeros((1, 2, 2))), r"\(n, 2\) for rows"),
    (dict(x=["a", "b"]), r"x is of type <U1; real numbers"),
    (dict(x=[1j, 2]), r"x is of type complex128"),
    (dict(x=[None, {}]), r"x holds what is no real number"),
    (dict(x=np.ma.masked_equal([0.0, 1.0], 1.0)), r"x is masked"),
    (dict(tolerance=0), r"tolerance is 0; it must be in \(0, 1\)"),
    (dict(tolerance=np.nan), r"tolerance is nan"),
    (dict(method="magic"), r'method is "magic"; it must be one of "fmm", "boxes", "direct"'),
    (dict(builder="up"), r'builder is "up"; it must be one of "reverse", "forward"'),
    (dict(cores="both"), r'cores is "both"'),
    (dict(order=1000), r"order is 1000; it must be in 0 \.\. 200"),
    (dict(finest_level=40), r"finest_level is 40"),
    (dict(capacity=-1), r"capacity is -1"),
    (dict(threads=0), r"threads is 0"),
    (dict(threads=1.5), r"threads is 1.5"),
    (dict(threads=True), r"threads is True"),
])
def test_wrong_input_is_refused_in_one_sentence(given, said):
    with pytest.raises(ValueError, match=said):
        vortree.Plan(**{"x": [0, 1], "y": [0, 1], "gamma": [1, 1], **given})


@pytest.mark.parametrize("ask, given, said", [
    ("velocity", ([0, 1], [0]), r"y has the shape \(1,\), x has \(2,\)"),
    ("velocity", ([0, np.nan], [0, 0]), r"x\[1\] is nan"),
    ("gradient", ([0.5], [np.inf]), r"y\[0\] is inf"),
    ("stream_function", ([[1, 2, 3]],), r"x has the shape \(1, 3\)"),
    ("vorticity", ([0], [np.nan]), r"y\[0\] is nan"),
    ("velocity", ([0], [0], 0.1), r'with cores="mean" only'),
])
def test_wrong_places_are_refused_in_one_sentence(ask, given, said):
    plan = vortree.Plan([0, 1], [0, 1], [1, 1], 0.1)
    with pytest.raises(ValueError, match=said):
        getattr(plan, ask)(*given)


def test_what_a_plan_tells_of_itself():
    plan = vortree.Plan(*blobs(5000, 16), tolerance=1e-5)
    assert len(plan) == 5000 and plan.method == "fmm" and plan.order > 0 and plan.nbytes > 5000 * 32
    assert repr(plan) == "Plan of 5000 vortices, method fmm, tolerance 1e-05"
    tree = plan.tree
    del plan
    assert np.array_equal(np.sort(tree.order), np.arange(5000))
