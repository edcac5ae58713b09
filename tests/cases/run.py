"""Runs a scene and holds it against its [check]: python3 run.py PROGRAM FOLDER SCENE [key=value ...]

Fails unless the run reaches its end, some of the check is reached and nothing of it is missed, and
says what was reached. In FOLDER; without figures.
"""

import json
import os
import pathlib
import subprocess
import sys


def main():
    program, folder, scene, *keys = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    quiet = {**os.environ, "VORTREE_SHARE": str(folder)}  # no plots there
    command = [program, "run", scene, *keys, "--overwrite", "--out", str(folder / "run")]
    ran = subprocess.run(command, env=quiet, capture_output=True, text=True)
    print(ran.stdout, ran.stderr, sep="")
    if ran.returncode:
        sys.exit(f"exit code {ran.returncode}")
    check = json.loads((folder / "run" / "summary.json").read_text())["check"]
    if check["passed"] is not True:
        sys.exit(f"the check has not passed: {check}")


main()
