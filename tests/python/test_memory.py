"""Who owns what: copies, references, threads, leaks."""

import gc
import multiprocessing
import re
import subprocess
import sys
import threading
import tracemalloc
import warnings
from pathlib import Path

import numpy as np
import pytest
import vortree
from clouds import blobs, places
from vortree._arrays import column


def test_what_is_contiguous_float64_is_not_copied():
    x = np.arange(10.0)
    assert column("x", x) is x and np.shares_memory(column("x", x[2:5]), x)
    for other in (x[::2], x.astype("f4"), x.astype(">f8"), x.tolist()):
        assert not np.shares_memory(column("x", other), x)


def test_a_plan_and_a_search_allocate_no_arrays_for_what_they_are_given():
    n = 200_000
    x, y, gamma, sigma = blobs(n, 1)
    sigma /= 10
    tracemalloc.start()
    try:
        plan, near = vortree.Plan(x, y, gamma, sigma), vortree.Neighbors(x, y, sigma)
        assert tracemalloc.get_traced_memory()[1] < n
        out = (np.empty(n), np.empty(n))
        tracemalloc.reset_peak()
        before = tracemalloc.get_traced_memory()[0]
        plan.velocity(x, y, out=out)
        near.rows(distances=True)
        assert tracemalloc.get_traced_memory()[1] < before + n
    finally:
        tracemalloc.stop()


def test_results_outlive_what_made_them():
    x, y = places("uniform", 20000, np.random.default_rng(2))
    near = vortree.Neighbors(x, y, 0.01)
    rows = near.rows(distances=True)
    pairs = near.query_pairs("ndarray")
    copies = [values.copy() for values in (*rows, pairs)]
    assert all(not values.flags.owndata and values.flags.writeable for values in rows)
    del near
    gc.collect()
    vortree.Neighbors(y, x, 0.02).rows()  # would write over what was given back
    for values, copy in zip((*rows, pairs), copies):
        assert np.array_equal(values, copy)


def test_no_reference_is_kept_or_lost():
    x, y, gamma, sigma = (values.copy() for values in blobs(100, 3))
    out = (np.empty(100), np.empty(100))
    given = (x, y, gamma, sigma, *out)
    before = [sys.getrefcount(values) for values in given]
    plan, near = vortree.Plan(x, y, gamma, sigma), vortree.Neighbors(x, y, sigma)
    for _ in range(10):
        plan.velocity(out=out)
        plan.velocity(x, y)
        near.rows()
        near.query_ball_point(x, y, sigma)
        with pytest.raises(ValueError):
            vortree.Plan(x, y, gamma, -sigma)
    assert [sys.getrefcount(values) for values in given] == before


def resident():
    """Resident memory of this process [bytes]."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096


def test_ten_thousand_calls_leave_nothing_behind():
    x, y, gamma, sigma = blobs(300, 4)
    plan = vortree.Plan(x, y, gamma, sigma, threads=1)
    near = vortree.Neighbors(x, y, 0.1, threads=1)
    box = vortree.Neighbors(x, y, 0.1, boxsize=1, threads=1)

    def call(times):
        for k in range(times):
            plan.velocity()
            near.rows(distances=True)
            near.query_ball_point(x[:5], y[:5], 0.1)
            box.rows(distances=True)
            box.query_ball_point(x[:5], y[:5], 0.1)
            if k % 10 == 0:
                near.update(x, y, 0.1)
                box.update(x, y, 0.1)
                vortree.Plan(x, y, gamma, sigma, threads=1).vorticity(x[:5], y[:5])
                vortree.Quadtree(x, y).order
                with pytest.raises(ValueError):
                    plan.velocity([np.nan], [0])

    call(1000)
    gc.collect()
    before = resident()
    call(10_000)
    gc.collect()
    # The smallest thing that could be lost in each call, an array of 300 numbers, would be 24 MB.
    assert resident() - before < 4e6


@pytest.mark.filterwarnings("ignore:splitting.alpha")
def test_a_flow_that_is_asked_and_saved_leaves_nothing_behind(tmp_path):
    flow = vortree.Simulation("lamb_oseen", threads=1)
    path = tmp_path / "state.h5"

    def call(times):
        for k in range(times):
            flow.particles.x, flow.units, flow.measures, flow.coefficients
            flow.velocity([0.5], [0.5])
            if k % 10 == 0:
                flow.save(path)
                vortree.Simulation.restore(path, threads=1)
                with pytest.raises(ValueError):
                    vortree.Simulation.restore(tmp_path / "none.h5")

    call(200)
    gc.collect()
    before = resident()
    call(1000)
    gc.collect()
    # Columns of the 2085 blobs, lost in each call, would be 100 MB, of each flow restored 10 MB.
    assert resident() - before < 4e6


@pytest.mark.filterwarnings("ignore:splitting.alpha")
def test_threads_of_python_save_and_step_one_flow_in_turn(tmp_path):
    flow = vortree.Simulation("lamb_oseen", time={"end": 0.2})
    alone = vortree.Simulation("lamb_oseen", time={"end": 0.2})
    wrong = []

    def save(k):
        for _ in range(5):
            flow.save(tmp_path / f"{k}.h5")
            other = vortree.Simulation.restore(tmp_path / f"{k}.h5")
            if not other.time == other.steps * other.dt:
                wrong.append(k)

    threads = [threading.Thread(target=save, args=(k,)) for k in range(3)]
    for thread in threads:
        thread.start()
    flow.step(5), alone.step(5)
    for thread in threads:
        thread.join()
    assert wrong == [] and np.array_equal(flow.particles.x, alone.particles.x)


def test_threads_of_python_sum_at_once():
    sets = [blobs(4000, seed) for seed in range(4)]
    alone = [vortree.velocity(*one) for one in sets]
    shared = vortree.Plan(*sets[0])
    near = vortree.Neighbors(sets[0][0], sets[0][1], 0.02)
    rows = near.rows(distances=True)
    box = vortree.Neighbors(sets[0][0], sets[0][1], 0.02, boxsize=1)
    around = box.rows(distances=True)
    wrong = []

    def work(k):
        for _ in range(10):
            same = np.array_equal(vortree.velocity(*sets[k], threads=1 + k % 2), alone[k])
            same &= np.array_equal(shared.velocity(), alone[0])
            same &= all(map(np.array_equal, near.rows(distances=True), rows))
            same &= all(map(np.array_equal, box.rows(distances=True), around))
            same &= len(near.query_ball_point(0.5, 0.5, 2)) == 4000
            if not same:
                wrong.append(k)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []


def lets_others_run(work):
    """Is the interpreter free while it works? With this interval none is taken from a thread."""
    begun, ended = threading.Event(), []

    def call():
        begun.set()
        work()
        ended.append(True)

    before = sys.getswitchinterval()
    thread = threading.Thread(target=call)
    try:
        sys.setswitchinterval(1000)
        thread.start()
        begun.wait()
        return not ended
    finally:
        sys.setswitchinterval(before)
        thread.join()


def test_the_interpreter_is_free_while_the_library_works():
    x, y, gamma, sigma = blobs(15000, 5)
    plan = vortree.Plan(x, y, gamma, sigma, method="direct", threads=1)
    near = vortree.Neighbors(x, y, 0.15, threads=1)
    works = [plan.velocity, lambda: plan.gradient(x, y), lambda: near.rows(),
             lambda: near.query_ball_point(x, y, 0.2, output_type="rows"),
             lambda: vortree.Neighbors(x, y, 0.15, boxsize=1, threads=1).rows(),
             lambda: vortree.Plan(*blobs(400_000, 6), threads=1)]
    for work in works:
        # The other may be slow to wake up; once is a proof.
        assert any(lets_others_run(work) for _ in range(5))


def norm_of(k):
    return float(np.linalg.norm(vortree.velocity(*blobs(20000, k), threads=2)))


def test_a_forked_process_sums_by_one_thread_and_does_not_wait_for_those_it_has_not():
    alone = [norm_of(k) for k in range(3)]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # later Pythons doubt it
        with multiprocessing.get_context("fork").Pool(2) as others:
            assert others.map_async(norm_of, range(3)).get(timeout=100) == alone


def test_more_pairs_than_memory_holds_are_refused_before_they_are_listed():
    script = """
import resource, numpy as np, vortree
resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))
near = vortree.Neighbors(np.zeros(24000), np.zeros(24000), 1.0)
for ask in (near.query_pairs,
            lambda: near.query_ball_point(np.zeros(24000), np.zeros(24000), 1)):
    try:
        ask()
    except MemoryError as error:
        print(error)
"""
    said = subprocess.run([sys.executable, "-B", "-c", script], capture_output=True, text=True)
    lines = said.stdout.splitlines()
    assert said.returncode == 0 and len(lines) == 2, said.stderr
    assert all(re.fullmatch(r"neighbors: \d+ pairs and more; at most \d+ may be listed", line)
               for line in lines)


def test_one_call_does_not_set_the_threads_of_the_next():
    from vortree import _core

    x, y, gamma, _ = blobs(100, 7)
    before = _core.threads()
    vortree.velocity(x, y, gamma, threads=before + 3)
    with pytest.raises(ValueError):
        vortree.velocity(x, y, gamma * np.nan, threads=before + 3)
    assert _core.threads() == before
