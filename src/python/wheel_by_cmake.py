"""What pip asks of a project (PEP 517): a wheel, made by the project's own CMake, and an sdist, the
sources of the wheel alone.

The wheel is for the interpreter that calls, with the compiler, CMake and pybind11 that are there.
The environment's CMAKE_ARGS are further words for CMake, as -DVORTREE_NATIVE=OFF for another machine
than this one. The sdist of the same sources has the same bytes: its times are SOURCE_DATE_EPOCH, or
the first that a zip file can tell.
"""

import base64
import gzip
import hashlib
import io
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# Whatever the wheel is made of.
SOURCES = ("CMakeLists.txt", "LICENSE", "pyproject.toml", "src/vortreeConfig.cmake.in",
           *(f"{part}/**/{name}" for part in ("tree", "fmm")
             for name in ("*.cpp", "*.hpp", "CMakeLists.txt")),
           "src/base/free_memory.[ch]pp", "src/base/memory.[ch]pp", "src/python/*.[ch]pp",
           "src/python/*.py", "src/python/CMakeLists.txt", "src/python/README.md",
           "src/python/vortree/*.py", "src/python/vortree/*.pyi", "src/python/vortree/py.typed")
FIRST_DAY = 315532800  # 1980


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"vortree-{version()}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as scratch:
        write(Path(wheel_directory) / name, build(Path(scratch)))
    return name


def build_sdist(sdist_directory, config_settings=None):
    folder = f"vortree-{version()}"
    files = {"PKG-INFO": metadata().encode(), **{name: (ROOT / name).read_bytes()
                                                 for name in sources()}}
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name in sorted(files):
            archive.addfile(entry(f"{folder}/{name}", files[name]), io.BytesIO(files[name]))
    name = f"{folder}.tar.gz"
    with open(Path(sdist_directory) / name, "wb") as file, \
            gzip.GzipFile("", "wb", 9, file, mtime=moment()) as squeezed:
        squeezed.write(packed.getvalue())
    return name


def sources():
    return sorted({os.fspath(path.relative_to(ROOT)) for pattern in SOURCES
                   for path in ROOT.glob(pattern) if path.is_file()})


def entry(name, content):
    """Nobody's file, of no day in particular."""
    told = tarfile.TarInfo(name)
    told.size, told.mtime, told.mode = len(content), moment(), 0o644
    return told


def moment():
    return int(os.environ.get("SOURCE_DATE_EPOCH", FIRST_DAY))


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
    """The lines of pyproject.toml as a wheel and an sdist tell them."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    lines = ["Metadata-Version: 2.2", f"Name: {project['name']}", f"Version: {version()}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {need}" for need in project["dependencies"]]
    for extra, needs in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}"]
        lines += [f'Requires-Dist: {need}; extra == "{extra}"' for need in needs]
    lines += ["Description-Content-Type: text/markdown", ""]
    return "\n".join([*lines, (ROOT / project["readme"]).read_text()])
