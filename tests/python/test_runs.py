import json
import re
import shutil
import subprocess

import numpy as np
import pytest
import vortree
from vortree import _runs

# A few steps: what the folder holds matters, not the flow.
SHORT = {"accuracy": 0.05, "time": {"end": 0.2}, "output": {"fields": [0.1, 0.2]}}


@pytest.fixture(scope="module")
def flow(tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs") / "cylinder"
    return vortree.run("cylinder", out=folder, threads=1, **SHORT)


def test_the_report_is_that_of_the_file(flow):
    text = (flow.folder / "report.csv").read_text().splitlines()
    rows = np.array([line.split(",") for line in text[1:]], float)
    assert list(flow.report) == text[0].split(",")
    for column, values in zip(rows.T, flow.report.values()):
        assert np.array_equal(values, column, equal_nan=True)
    assert flow.report["t"][-1] == 0.2


def test_frames_and_fields_are_there_at_their_times(flow):
    assert [frame.time for frame in flow.frames] == [0, 0.2]
    last = flow.frame(-1)
    assert last.step == flow.report["t"].size and last.x.size == flow.report["blobs"][-1]
    assert last["gamma"] is last.gamma and last.state["sheet"].size > 0
    assert [frame.step for frame in flow.frames[::-1]] == [last.step, 0]
    assert [field.time for field in flow.fields] == [0.1, 0.2]
    assert flow.fields[0].omega.shape == (flow.fields[0].y.size, flow.fields[0].x.size)
    with pytest.raises(IndexError, match="frame 7 of 2"):
        flow.frame(7)
    with pytest.raises(AttributeError, match="no column mass; there are x, y, gamma"):
        last.mass
    assert "gamma" in dir(last)


def test_blobs_of_a_frame_go_into_a_plan(flow):
    last = flow.frame()
    plan = vortree.Plan(last.x, last.y, last.gamma, last.sigma)
    assert plan.velocity()[0].shape == last.u.shape


def test_summary_and_scene_are_told(flow):
    assert flow.passed is True and flow.summary["steps"] == flow.frame().step
    assert flow.scene["accuracy"] == 0.05 and flow.scene["time"]["end"] == 0.2
    assert sorted(flow.table("wall")) == sorted(vortree.read(flow.folder).table("wall"))


def test_a_run_goes_on_and_is_not_replaced_unasked(flow, tmp_path):
    shutil.copytree(flow.folder, tmp_path / "run")
    with pytest.raises(ValueError, match="holds a run"):
        vortree.run("cylinder", out=tmp_path / "run", **SHORT)
    longer = {**SHORT, "time": {"end": 0.3}}
    again = vortree.run("cylinder", out=tmp_path / "run", resume=True, **longer)
    steps = flow.report["t"].size
    assert again.report["t"].size > steps
    for name in ("t", "blobs", "circulation"):
        assert np.array_equal(again.report[name][:steps], flow.report[name])


def test_what_the_program_refuses_is_a_value_error_in_its_words(tmp_path):
    for keys, said in [({"acuracy": 0.1}, "did you mean accuracy?"),
                       ({"body": {"shape": "cube"}}, 'body.shape is "cube"'),
                       ({"flow.reynolds": -1}, "flow.reynolds")]:
        with pytest.raises(ValueError, match=said):
            vortree.run("cylinder", out=tmp_path / "none", **keys)
    with pytest.raises(ValueError, match='no scene "cylindre"'):
        vortree.run("cylindre", out=tmp_path / "none")
    assert not (tmp_path / "none").exists()


def test_a_check_that_is_missed_is_no_error_and_what_is_warned_of_a_warning(tmp_path):
    with pytest.warns(UserWarning, match="output.fields = 1: beyond the end"):
        flow = vortree.run("cylinder", out=tmp_path / "run", accuracy=0.05, time={"end": 0.1},
                           output={"fields": [1]}, check={"lift_max": 1e-15})
    assert flow.passed is False and flow.summary["check"]["lift_max"]["status"] == "missed"


def test_a_file_that_is_still_written_is_read_to_its_last_line(flow, tmp_path):
    text = (flow.folder / "report.csv").read_text()
    (tmp_path / "report.csv").write_text(text[:-30])
    young = vortree.read(tmp_path)
    assert young.report["t"].size == flow.report["t"].size - 1
    assert young.summary == {} and young.passed is None and young.fields == []
    (tmp_path / "report.csv").write_text("a,b\n1,2\n1\n")
    with pytest.raises(ValueError, match="a row has not 2 values"):
        young.report
    with pytest.raises(FileNotFoundError, match="frames.h5"):
        young.frames


def test_a_folder_without_a_run_and_a_program_that_is_not_there_are_named(tmp_path, monkeypatch):
    with pytest.raises(FileNotFoundError, match="holds no run"):
        vortree.read(tmp_path)
    with pytest.raises(FileNotFoundError):
        vortree.run("cylinder", program=tmp_path / "vortree")


def test_values_are_written_as_toml():
    import tomllib

    values = {"a": 1, "b": 0.1, "c": True, "d": "x, \"y\" ü", "e": [1.5, "z"],
              "f": [{"g": [[1, 2]]}],
              "h": np.float64(0.3), "i": np.arange(3), "j": 1e-300, "k": 2**60}
    text = "\n".join(f"{name} = {_runs._toml(value)}" for name, value in values.items())
    read = tomllib.loads(text)
    assert json.dumps(read) == json.dumps({**values, "h": 0.3, "i": [0, 1, 2]})
    with pytest.raises(ValueError, match="nothing that a scene can hold"):
        _runs._toml(None)


@pytest.mark.filterwarnings("ignore")  # crude: what there is matters, not the flow
def test_lists_are_a_sweep_in_the_order_of_the_list(tmp_path):
    keys = {"time": {"end": 0.1}, "output": {"fields": []}, "check": {"lift_max": 1}}
    sweep = vortree.run("cylinder", out=tmp_path / "sweep", method=["vortex", "sph"],
                        flow={"reynolds": np.array([20.0, 30.0])}, accuracy=0.05, **keys)
    assert [tuple(case.values()) for case in sweep.cases] == [
        ("vortex", 20), ("vortex", 30), ("sph", 20), ("sph", 30)]
    assert list(sweep.table)[:4] == ["method", "flow.reynolds", "steps", "particles"]
    assert sweep.table["method"].tolist() == ["vortex", "vortex", "sph", "sph"]
    assert sweep.table["flow.reynolds"].tolist() == [20, 30, 20, 30]
    for run, case, steps in zip(sweep, sweep.cases, sweep.table["steps"]):
        assert run.scene["method"] == case["method"]
        assert run.scene["flow"]["reynolds"] == case["flow.reynolds"]
        assert run.summary["steps"] == steps == run.report["t"].size
    assert len(sweep[1:3]) == 2 and sweep[-1].folder.name == "method=sph,flow.reynolds=30.0"
    assert sweep.failed == []
    assert len(vortree.read(tmp_path / "sweep")) == 4
    with pytest.raises(ValueError, match="holds a run|is there already"):
        vortree.run("cylinder", out=tmp_path / "sweep", method=["vortex", "sph"],
                    flow={"reynolds": [20.0, 30.0]}, accuracy=0.05, **keys)


def test_a_run_of_a_sweep_that_breaks_off_is_warned_of_and_a_gap(tmp_path):
    (tmp_path / "sweep/accuracy=0.1/report.csv").mkdir(parents=True)
    with pytest.warns(UserWarning, match="report.csv"):
        sweep = vortree.run("cylinder", out=tmp_path / "sweep", accuracy=[0.05, 0.1],
                            time={"end": 0.1}, output={"fields": []})
    assert np.isnan(sweep.table["steps"]).tolist() == [False, True]
    assert [case for case, _ in sweep.failed] == [{"accuracy": 0.1}] and not sweep.passed


def test_lists_of_keys_that_take_lists_are_one_value_and_others_several(tmp_path):
    program = _runs.find_program()
    page = subprocess.run([program, "check", "--keys"], capture_output=True, text=True, check=True)
    names = [line.split("`")[1] for line in page.stdout.splitlines() if line.startswith("| `")]
    tables = ("tracers", "probe", "sph.region")  # lists of tables, never swept
    asked = [name for name in names if not name.startswith(tables)]
    assert len(asked) > 100
    taken = {"plunge.direction"}  # refused for the other keys of its table
    for name in asked:
        said = subprocess.run([program, "check", "cylinder", f"{name}=[[[]]]"],
                              capture_output=True, text=True).stderr
        if "needs the key" not in said and f" {name} is an array; " not in said:
            taken.add(name)
    assert taken == _runs._LISTS
    for value in ([0.1], []):
        with pytest.raises(ValueError, match="makes no sweep"):
            vortree.run("cylinder", out=tmp_path / "none", accuracy=value)
    with pytest.raises(ValueError, match="an array of numbers|number"):
        vortree.run("cylinder", out=tmp_path / "none", output={"fields": ["a"]})
