import csv
import sys
import zipfile
from email.parser import Parser
from pathlib import Path

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
