"""A package for Debian made of what is built: what it needs, holds, and does where it is unpacked.

    tests/package/run.py BUILD

Without the tools of Debian there is nothing to make it by: exit code 77, a test that is skipped.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def output(*command, **keywords):
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          **keywords)
    assert done.returncode == 0, f"{command[0]}: exit code {done.returncode}\n{done.stdout}"
    return done.stdout


def packed(build, scratch):
    output("cpack", "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", scratch,
           cwd=scratch)
    found = list(scratch.glob("vortree_*.deb"))
    assert len(found) == 1, found
    return found[0]


def check_needs(package, with_python):
    needs = re.split(r", ", output("dpkg-deb", "-f", package, "Depends").strip())
    names = {need.split(" ")[0] for need in needs}
    # What draws figures, and of what the program loads a library of each kind.
    wanted = {"python3", "python3-matplotlib", "python3-h5py", "libc6", "libstdc++6",
              "libfftw3-double3", "libmuparser2v5"}
    assert wanted <= names, f"not among what it needs: {wanted - names}"
    assert names & {"libgomp1", "libomp5", "libomp5-14"}, f"no OpenMP, of GCC or clang: {names}"
    bounds = {need for need in needs if need.startswith("python3 (")}
    assert len(bounds) == 2 * with_python, bounds


def check_content(root, with_python):
    usr = root / "usr"
    for pattern in ("bin/vortree", "include/vortree/fmm/plan.hpp", "lib/**/libvortree_fmm.a",
                    "lib/**/cmake/vortree/vortreeConfig.cmake", "share/vortree/plots/drag.py",
                    "share/vortree/cases/reference/cylinder_drag_re550.csv"):
        assert list(usr.glob(pattern)), f"no {pattern}"
    assert "Redistribution" in (usr / "share/doc/vortree/copyright").read_text()
    assert not list(usr.rglob("__pycache__")) and not list(usr.rglob("gallery"))
    # Debian's Python looks into dist-packages alone.
    found = {path.parent.relative_to(usr).as_posix() for path in usr.rglob("vortree/__init__.py")}
    assert found == ({"lib/python3/dist-packages/vortree"} if with_python else set()), found
    others = [path for path in root.rglob("*") if not os.access(path, os.R_OK)]
    assert not others, others


def check_program(root, scratch):
    """The cases that it finds are those of the package: one of them is told apart."""
    case = root / "usr/share/vortree/cases/cylinder.toml"
    case.write_text(re.sub(r'title = ".*"', 'title = "from the package"', case.read_text()))
    environment = {name: value for name, value in os.environ.items() if name != "VORTREE_SHARE"}
    told = output(root / "usr/bin/vortree", "check", "cylinder", cwd=scratch, env=environment)
    assert 'title = "from the package"' in told, told


def check_python(root, scratch):
    folder = root / "usr/lib/python3/dist-packages"
    told = output("/usr/bin/python3", "-B", "-c", "import vortree; print(vortree.__file__)",
                  cwd=scratch, env={**os.environ, "PYTHONPATH": str(folder)})
    assert told.strip() == str(folder / "vortree/__init__.py"), told


def main(build):
    with_python = bool(list((build / "python/vortree").glob("_core*.so")))
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder).resolve()
        package = packed(build, scratch)
        root = scratch / "root"
        output("dpkg-deb", "-x", package, root)
        check_needs(package, with_python)
        check_content(root, with_python)
        check_program(root, scratch)
        if with_python:
            check_python(root, scratch)
    print("the package is whole")


if __name__ == "__main__":
    missing = [tool for tool in ("cpack", "dpkg-deb", "dpkg-shlibdeps", "file")
               if not shutil.which(tool)]
    if missing:
        print(f"skipped: no {', '.join(missing)}; Debian: cmake dpkg-dev file")
        sys.exit(77)
    main(Path(sys.argv[1]).resolve())
