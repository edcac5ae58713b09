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
