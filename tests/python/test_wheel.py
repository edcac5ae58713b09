import csv
import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from email.parser import Parser
from pathlib import Path

import pytest
import vortree

sys.path.append(str(Path(__file__).resolve().parents[2] / "src" / "python"))
import wheel_by_cmake  # noqa: E402


def test_a_wheel_lists_what_it_holds_and_tells_what_it_needs(tmp_path):
    (tmp_path / "stage" / "vortree").mkdir(parents=True)
    for name in ("__init__.py", "_core.so"):
        (tmp_path / "stage" / "vortree" / name).write_text("pass")
    wheel_by_cmake.write(tmp_path / "some.whl", tmp_path / "stage")
    with zipfile.ZipFile(tmp_path / "some.whl") as wheel:
        names = wheel.namelist()
        about = f"vortree-{vortree.__version__}.dist-info"
        record = [*csv.reader(wheel.read(f"{about}/RECORD").decode().splitlines())]
        told = Parser().parsestr(wheel.read(f"{about}/METADATA").decode())
        assert [line[0] for line in record] == names and "vortree/_core.so" in names
        for name, digest, size in record[:-1]:
            content = wheel.read(name)
            assert digest == "sha256=" + wheel_by_cmake.digest(content)
            assert int(size) == len(content)
        assert wheel.getinfo("vortree/_core.so").external_attr >> 16 == 0o755
    assert (told["Name"], told["Version"]) == ("vortree", vortree.__version__)
    assert "numpy" in told.get_all("Requires-Dist") and "## Velocities" in told.get_payload()


def test_the_package_tells_the_version_of_the_project():
    assert vortree.__version__ == wheel_by_cmake.version()


def test_an_sdist_has_the_same_bytes_whenever_it_is_made(tmp_path, monkeypatch):
    packed = []
    for moment in ("one", "other", "later"):
        (tmp_path / moment).mkdir()
        if moment == "later":
            monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
        name = wheel_by_cmake.build_sdist(tmp_path / moment)
        packed.append((tmp_path / moment / name).read_bytes())
    assert name == f"vortree-{vortree.__version__}.tar.gz"
    assert packed[0] == packed[1] != packed[2]
    with tarfile.open(tmp_path / "later" / name) as archive:
        entries = archive.getmembers()
        told = Parser().parsestr(archive.extractfile(entries[2]).read().decode())
    names = [entry.name.split("/", 1)[1] for entry in entries]
    assert names == sorted(names) and names[2] == "PKG-INFO"
    assert all((entry.mtime, entry.mode, entry.uid, entry.uname) == (1700000000, 0o644, 0, "")
               for entry in entries)
    assert (told["Name"], told["Version"]) == ("vortree", vortree.__version__)
    # Neither tests nor scenes nor the program, and no sources of its bodies and flows.
    tops = {name.split("/")[0] for name in names}
    assert tops == {"CMakeLists.txt", "LICENSE", "PKG-INFO", "pyproject.toml", "fmm", "src", "tree"}
    assert {name.split("/")[1] for name in names if name.startswith("src/")} == {
        "base", "python", "vortreeConfig.cmake.in"}


OFFLINE = """
import socket, sys
def none(*_): raise OSError("the network was asked")
socket.socket.connect = none
sys.path.insert(0, "src/python")
import wheel_by_cmake
wheel_by_cmake.build_sdist("../again")
print(wheel_by_cmake.build_wheel(".."))
"""
SUM = """
import numpy as np, vortree
u, v = vortree.velocity([-1, 1], [0, 0], [2 * np.pi, 2 * np.pi])
assert vortree.Neighbors([0.1, 0.9], [0, 0], 0.3, boxsize=1).query_pairs() == {(0, 1)}
print(vortree.__file__, v.round(6))
"""


@pytest.mark.skipif(not shutil.which("cmake") or not shutil.which("c++"),
                    reason="to build a wheel needs cmake and a compiler")
def test_a_wheel_is_built_from_the_sdist_alone(tmp_path):
    name = wheel_by_cmake.build_sdist(tmp_path)
    with tarfile.open(tmp_path / name) as archive:
        archive.extractall(tmp_path)
    (tmp_path / "again").mkdir()
    # Without optimization: what is built counts, not how fast it is.
    where = {**os.environ, "CMAKE_ARGS": "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DVORTREE_NATIVE=OFF"}
    built = subprocess.run([sys.executable, "-B", "-c", OFFLINE], env=where, text=True,
                           cwd=tmp_path / name.removesuffix(".tar.gz"), capture_output=True)
    assert built.returncode == 0, built.stdout + built.stderr
    assert (tmp_path / "again" / name).read_bytes() == (tmp_path / name).read_bytes()
    wheel = tmp_path / built.stdout.splitlines()[-1]
    with zipfile.ZipFile(wheel) as files:
        files.extractall(tmp_path / "installed")
        assert "vortree/_core" in "".join(files.namelist())
    where = {**os.environ, "PYTHONPATH": os.fspath(tmp_path / "installed")}
    said = subprocess.run([sys.executable, "-B", "-c", SUM], env=where, cwd=tmp_path, text=True,
                          capture_output=True)
    assert said.returncode == 0, said.stderr
    assert said.stdout.startswith(os.fspath(tmp_path / "installed")) and "[-0.5  0.5]" in said.stdout
