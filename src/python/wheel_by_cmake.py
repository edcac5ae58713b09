"""What pip asks of a project (PEP 517): a wheel, made by the project's own CMake.

For the interpreter that calls, with the compiler, CMake and pybind11 that are there. The
environment's CMAKE_ARGS are further words for CMake, as -DVORTREE_NATIVE=OFF for another machine
than this one.
"""

import base64
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"vortree-{version()}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as scratch:
        write(Path(wheel_directory) / name, build(Path(scratch)))
    return name


def version():
    return re.search(r"project\(vortree VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def build(scratch):
    """The folder that holds the package."""
    made, stage = scratch / "build", scratch / "stage"
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    call("cmake", "-S", ROOT, "-B", made, *generator, "-DCMAKE_BUILD_TYPE=Release",
         "-DVORTREE_PROGRAM=OFF", "-DVORTREE_PYTHON=ON", "-DVORTREE_PYTHON_DIR=.",
         f"-DPython_EXECUTABLE={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", "")))
    call("cmake", "--build", made, "--target", "vortree_python", "--parallel")
    call("cmake", "--install", made, "--component", "python", "--prefix", stage)
    return stage


def call(*words):
    subprocess.run([os.fspath(word) for word in words], check=True)


def write(wheel, stage):
    """All files below a folder, with what a wheel tells of itself."""
    about = f"vortree-{version()}.dist-info"
    files = {os.fspath(path.relative_to(stage)): path.read_bytes()
             for path in sorted(stage.rglob("*")) if path.is_file()}
    files[f"{about}/METADATA"] = metadata().encode()
    files[f"{about}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: vortree\nRoot-Is-Purelib: false\n"
                               f"Tag: {tag()}\n").encode()
    files[f"{about}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = [f"{path},sha256={digest(content)},{len(content)}" for path, content in files.items()]
    files[f"{about}/RECORD"] = "\n".join([*record, f"{about}/RECORD,,", ""]).encode()
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path)
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED)


def digest(content):
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def metadata():
    """The lines of pyproject.toml as a wheel tells them."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {version()}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {need}" for need in project["dependencies"]]
    for extra, needs in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}"]
        lines += [f'Requires-Dist: {need}; extra == "{extra}"' for need in needs]
    lines += ["Description-Content-Type: text/markdown", ""]
    return "\n".join([*lines, (ROOT / project["readme"]).read_text()])
