import copy
import gc
import os
import pickle
import shutil
import threading

import numpy as np
import pytest
import vortree

SHORT = {"accuracy": 0.05, "time": {"end": 0.2}, "output": {"fields": []}}
SPH = {"method": "sph", "flow": {"reynolds": 20}, "accuracy": 0.05, "time": {"end": 0.02},
       "output": {"fields": []}, "sph": {"spacing": 0.12}}


@pytest.mark.filterwarnings("ignore:sph.spacing")
@pytest.mark.parametrize("keys", [SHORT, SPH], ids=["vortex", "sph"])
def test_steps_are_those_of_a_run_to_the_bit(tmp_path, keys):
    whole = vortree.run("cylinder", out=tmp_path / "run", **keys)
    flow = vortree.Simulation("cylinder", **keys)
    report = whole.report
    assert flow.steps == 0 and flow.last_step == report["t"].size and flow.coefficients == {}
    for k, now in enumerate(flow):
        assert now.time == report["t"][k]
        for name, value in now.measures.items():
            assert value == report[name][k], name
    for name, values in whole.frame(-1).columns.items():
        assert np.array_equal(flow.particles[name], values)
    for name, value in flow.coefficients.items():
        assert value == report[name][-1], name
    assert flow.scene == whole.scene


def test_a_flow_tells_of_itself_anywhere(tmp_path):
    flow = vortree.Simulation("cylinder", threads=1, **SHORT)
    flow.step(3)
    assert flow.steps == 3 and "step 3 of" in repr(flow)
    x, y = np.meshgrid([1.5, 2.0, 400.0], [0.3, 3.0])
    u, v = flow.velocity(x, y)
    assert u.shape == (2, 3) and np.hypot(u[1, 2] - 1, v[1, 2]) < 1e-4  # the stream far away
    step = 1e-4
    slope = (flow.stream_function(x, y + step) - flow.stream_function(x, y - step)) / (2 * step)
    assert np.abs(slope - u).max() < 1e-3  # step^2 and the tolerance of psi over step
    assert flow.velocity([[0.0, 0.0]])[0] == 0 and flow.vorticity(x, y).shape == (2, 3)


@pytest.mark.parametrize("keys, said", [
    ({"acuracy": 0.1}, "did you mean accuracy?"),
    ({"body": {"shape": "cube"}}, 'body.shape is "cube"'),
    ({"flow.reynolds": -1}, "flow.reynolds"),
    ({"threads": 0}, "threads is 0"),
])
def test_what_is_refused_is_a_value_error_in_the_program_s_words(keys, said):
    with pytest.raises(ValueError, match=said):
        vortree.Simulation("cylinder", **keys)


def test_scenes_are_files_or_cases(tmp_path):
    with pytest.raises(ValueError, match='no scene "cylindre".*lamb_oseen'):
        vortree.Simulation("cylindre")
    (tmp_path / "mine.toml").write_text("[flow]\n")
    with pytest.raises(ValueError, match="mine.toml"):
        vortree.Simulation(tmp_path / "mine.toml")


def test_doubts_are_warned_of():
    with pytest.warns(UserWarning, match="time.dt = 0.2: the vorticity at the wall turns by"):
        vortree.Simulation("cylinder", accuracy=0.05, time={"dt": 0.2, "end": 1})


def test_no_stream_function_by_sph():
    with pytest.warns(UserWarning, match="sph.spacing"):
        flow = vortree.Simulation("cylinder", **SPH)
    with pytest.raises(ValueError, match="tells no stream function"):
        flow.stream_function([1.0], [0.0])


def same(flow, other):
    """To the bit: where it stands, what moves, what is told of it, and what a step makes of it."""
    for _ in range(2):
        if (flow.steps, flow.time, flow.measures) != (other.steps, other.time, other.measures):
            return False
        if flow.coefficients != other.coefficients:
            return False
        ours, theirs = flow.particles.columns, other.particles.columns
        if not all(np.array_equal(ours[name], theirs[name]) for name in ours):
            return False
        flow.step(3), other.step(3)
    return True


FEW = {"accuracy": 0.1, "time": {"end": 0.2}, "output": {"fields": []}}
PAIR = {"accuracy": 0.1, "time": {"end": 0.4}}


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("scene, keys", [
    ("cylinder", FEW), ("cylinder", SPH), ("lamb_oseen", {"time": {"end": 0.2}}),
    ("plunging_cylinder", {"accuracy": 0.1, "time": {"end": 0.3}}), ("side_by_side", PAIR),
    ("passing_cylinders", PAIR),
], ids=["vortex", "sph", "free space", "plunging", "two bodies", "two that move"])
def test_a_flow_that_was_saved_goes_on_to_the_same_bits(tmp_path, scene, keys):
    flow = vortree.Simulation(scene, **keys)
    for steps in (0, 1, 3):
        flow.step(steps)
        flow.save(tmp_path / "state.h5")
        other = vortree.Simulation.restore(tmp_path / "state.h5")
        assert same(flow, other) and other.scene == flow.scene
    assert [path.name for path in tmp_path.iterdir()] == ["state.h5"]


def test_a_run_is_gone_on_with_from_its_last_frame(tmp_path):
    whole = vortree.run("cylinder", out=tmp_path / "whole", **FEW)
    dt = whole.scene["time"]["dt"]
    vortree.run("cylinder", out=tmp_path / "half", **{**FEW, "time": {"end": 0.1, "dt": dt}})
    for path in (tmp_path / "half", tmp_path / "half" / "frames.h5"):
        flow = vortree.Simulation.restore(path, time={"end": 0.2})
        assert 0 < flow.steps < flow.last_step == whole.report["t"].size
        for now in flow:
            pass
        for name, values in whole.frame(-1).columns.items():
            assert np.array_equal(flow.particles[name], values)
        for name, value in flow.coefficients.items():
            assert value == whole.report[name][-1], name


def test_what_the_program_reads_of_a_saved_flow(tmp_path):
    flow = vortree.Simulation("cylinder", **FEW)
    flow.step(2)
    flow.save(tmp_path / "state.h5")
    frames = vortree._runs.Frames(tmp_path / "state.h5")
    assert len(frames) == 1 and frames[0].step == 2
    assert np.array_equal(frames[0].gamma, flow.particles.gamma)


def test_a_scene_of_files_is_found_again_from_anywhere(tmp_path, monkeypatch):
    (tmp_path / "here").mkdir()
    (tmp_path / "there").mkdir()
    angle = np.linspace(0, 2 * np.pi, 41)
    outline = np.stack([0.5 * np.cos(angle), 0.3 * np.sin(angle)], 1)
    np.savetxt(tmp_path / "here" / "oval.txt", outline)
    (tmp_path / "here" / "mine.toml").write_text(
        '[body]\nshape = "points"\nfile = "oval.txt"\n[flow]\nstream = [1.0, 0.0]\nreynolds = 100\n')
    monkeypatch.chdir(tmp_path / "here")
    keys = {"accuracy": 0.1, "time": {"end": 0.3}}
    flow = vortree.Simulation("mine.toml", **keys)
    flow.step(2)
    flow.save("state.h5")
    monkeypatch.chdir(tmp_path / "there")
    assert same(vortree.Simulation.restore("../here/state.h5"), flow)


def test_only_the_end_may_change_on_the_way(tmp_path):
    flow = vortree.Simulation("cylinder", **FEW)
    flow.step()
    flow.save(tmp_path / "state.h5")
    later = vortree.Simulation.restore(tmp_path / "state.h5", time={"end": 0.4})
    assert later.last_step > flow.last_step and same(flow, later)
    with pytest.raises(ValueError, match=r"state.h5: was run with another \[velocity\]"):
        vortree.Simulation.restore(tmp_path / "state.h5", velocity={"tolerance": 1e-9})
    with pytest.raises(ValueError, match="did you mean end"):
        vortree.Simulation.restore(tmp_path / "state.h5", time={"nd": 1})


def test_what_is_no_flow_is_refused_in_the_library_s_words(tmp_path):
    def refused(path, said):
        with pytest.raises(ValueError, match=said) as error:
            vortree.Simulation.restore(path)
        assert "\n" not in str(error.value)

    refused(tmp_path / "none.h5", "none.h5")
    (tmp_path / "empty").mkdir()
    refused(tmp_path / "empty", "frames.h5")
    (tmp_path / "text.h5").write_text("no HDF5\n" * 100)
    refused(tmp_path / "text.h5", "text.h5")
    flow = vortree.Simulation("cylinder", **FEW)
    with pytest.raises(ValueError, match="nowhere"):
        flow.save(tmp_path / "nowhere" / "state.h5")
    flow.save(tmp_path / "state.h5")
    whole = (tmp_path / "state.h5").read_bytes()
    for share in (0.1, 0.5, 0.95):
        (tmp_path / "cut.h5").write_bytes(whole[: int(share * len(whole))])
        refused(tmp_path / "cut.h5", "cut.h5")
    import h5py

    with h5py.File(tmp_path / "state.h5", "r+") as file:
        file["frame_000000"]["x"][0] += 1
    refused(tmp_path / "state.h5", "no frame to go on from")


def test_an_older_file_stays_until_the_new_one_is_whole(tmp_path):
    flow = vortree.Simulation("cylinder", **FEW)
    flow.save(tmp_path / "state.h5")
    kept = os.stat(tmp_path / "state.h5").st_ino
    flow.step()
    flow.save(tmp_path / "state.h5")
    assert os.stat(tmp_path / "state.h5").st_ino != kept
    assert vortree.Simulation.restore(tmp_path / "state.h5").steps == 1


def test_what_is_no_saved_flow_is_not_replaced(tmp_path):
    flow = vortree.Simulation("cylinder", **FEW)
    (tmp_path / "notes.txt").write_text("mine\n")
    run = vortree.run("cylinder", out=tmp_path / "run", **FEW)
    short = vortree.run("cylinder", out=tmp_path / "short", accuracy=0.1,
                        time={"end": 1e-3}, output={"frames": 1, "fields": []})
    others = [tmp_path / "notes.txt", run.folder / "frames.h5", short.folder / "frames.h5"]
    os.symlink(others[1], tmp_path / "link.h5")
    for path in [*others, tmp_path / "link.h5"]:
        before = path.read_bytes()
        with pytest.raises(ValueError, match="no saved flow: save.. does not replace it") as error:
            flow.save(path)
        assert str(path) in str(error.value) and "\n" not in str(error.value)
        assert path.read_bytes() == before
    flow.save(tmp_path / "notes.h5")
    flow.step()
    flow.save(tmp_path / "notes.h5")
    with pytest.raises(ValueError, match="without ::, and goes on from its last good frame"):
        vortree.Simulation.restore(f"{run.folder}::last")
    assert same(vortree.Simulation.restore(tmp_path / "notes.h5"), flow)


def test_copies_and_pickles_are_refused_with_what_stands_for_them():
    flow = vortree.Simulation("cylinder", **FEW)
    for ask in (copy.copy, copy.deepcopy, pickle.dumps):
        with pytest.raises(TypeError, match=r"save\(path\) writes it"):
            ask(flow)


POINTS, LINE = [[1.0, 0.2], [0.0, 0.0], [2.5, -0.3]], [0.6, 0.0, 3.0, 1.0]


def test_probes_are_those_of_a_run_to_the_bit(tmp_path):
    every = 0.07
    run = vortree.run("cylinder", out=tmp_path / "run", **FEW, probe=[
        {"points": POINTS}, {"line": LINE, "count": 5, "every": every}])
    told = run.table("probes")
    flow = vortree.Simulation("cylinder", **FEW)
    points = flow.add_probe(POINTS)
    along = np.flatnonzero(told["probe"] == 2)[:5]
    line = flow.add_probe(told["x"][along], told["y"][along], every=every)
    for now in flow:
        pass
    for number, probe in enumerate((points, line), 1):
        mine = told["probe"] == number
        assert np.array_equal(np.repeat(probe.t, probe.x.size), told["t"][mine])
        for name in ("u", "v", "omega"):
            ours, theirs = getattr(probe, name), told[name][mine].reshape(len(probe), -1)
            assert np.array_equal(ours[1:], theirs[1:]), name
            # Asked alone and asked together: another order of the same sums, of terms of up to 1.
            assert np.allclose(ours[0], theirs[0], rtol=0, atol=1e-13), name
    assert len(points) == flow.steps + 1 and 1 < len(line) < len(points)
    assert points.u.shape == (len(points), 3) and not points.u[:, 1].any()  # within the body


def test_probes_are_added_on_the_way_and_taken_out_again(tmp_path):
    flow = vortree.Simulation("cylinder", **FEW)
    early = flow.add_probe([[1.0, 0.2]])
    flow.step(2)
    x, y = np.meshgrid([1.0, 1.5], [0.2, 0.4, 0.6])
    late = flow.add_probe(x, y)
    x[:] = np.nan  # what was given may change later
    flow.step(2)
    assert late.t.tolist() == early.t[2:].tolist() and late.u.shape == (3, 3, 2)
    assert np.array_equal(late.u[:, 0, 0], early.u[2:, 0])
    assert np.array_equal(late.omega[-1], flow.vorticity(late.x, late.y))
    flow.probes.remove(early)
    flow.step()
    assert (len(early), len(late)) == (5, 4) and "6 places, 4 rows" in repr(late)
    flow.save(tmp_path / "state.h5")
    other = vortree.Simulation.restore(tmp_path / "state.h5")
    flow.step(), other.step()
    (again,) = other.probes
    for name in ("x", "y", "t", "u", "v", "omega"):
        assert np.array_equal(getattr(again, name), getattr(late, name)), name
    assert again.every is None and len(again) == 5


def test_a_probe_is_told_at_the_nearest_steps_whenever_it_was_saved(tmp_path):
    flow = vortree.Simulation("cylinder", **FEW)
    probe = flow.add_probe(1.0, 0.5, every=2.4 * flow.dt)
    flow.step(4)
    flow.save(tmp_path / "state.h5")
    other = vortree.Simulation.restore(tmp_path / "state.h5")
    flow.step(4), other.step(4)
    for one in (probe, other.probes[0]):
        assert np.allclose(one.t / flow.dt, [0, 2, 5, 7]) and one.u.shape == (4,)
        assert one.every == 2.4 * flow.dt


@pytest.mark.parametrize("given, said", [
    ((np.nan, 0.0), "x"), (([1, 2], [0]), r"y has the shape \(1,\)"), ((1.0,), "y, or a shape"),
    ((1.0, 0.0, 0.0), "every is 0"), ((1.0, 0.0, np.inf), "every is inf"),
])
def test_wrong_probes_are_refused_in_one_sentence(given, said):
    flow = vortree.Simulation("cylinder", **FEW)
    with pytest.raises(ValueError, match=said):
        flow.add_probe(*given[:2], every=given[2] if len(given) == 3 else None)
    assert flow.probes == []


def test_columns_have_units_and_several_bodies_their_coefficients():
    flow = vortree.Simulation("side_by_side", **PAIR)
    flow.step(3)
    assert flow.units == {"x": "L", "y": "L", "u": "L/T", "v": "L/T", "gamma": "L^2/T",
                          "sigma": "L"} | {name: unit for name, unit in flow.units.items()
                                           if name not in "x y u v gamma sigma".split()}
    assert set(flow.units) == set(flow.particles.columns)
    told = flow.coefficients
    assert abs(told["cd_wall_1"] + told["cd_wall_2"] - told["cd_wall"]) < 1e-9 * told["cd_wall"]


def test_the_pressure_is_that_of_the_stagnation_point():
    flow = vortree.Simulation("cylinder", **FEW)
    with pytest.raises(ValueError, match="no pressure is told at t = 0"):
        flow.pressure([2.0], [0.0])
    flow.step(5)
    p = flow.pressure([[-0.51, 0.0], [0.0, 0.0], [300.0, 0.0]])
    assert p[0] > 0.4 and p[1] == 0 and abs(p[2]) < 1e-2
