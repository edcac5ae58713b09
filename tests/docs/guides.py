"""The guides do what they say: every block of each, in its order, in a folder of its own.

    PYTHONPATH=build/python tests/docs/guides.py PROGRAM [GUIDE ...]

A block of sh runs with `./vortree`; blocks of python share their names and run where the package
can be imported; a block of text is what the one before it has to print, where ... stands for
anything; any other is the file whose name ends the line before it, `NAME`:.
"""

import contextlib
import doctest
import importlib.util
import io
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

project = Path(__file__).resolve().parents[2]
fence = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)
with_package = all(importlib.util.find_spec(name) for name in ("numpy", "vortree"))


def blocks(text):
    """(language, content, file that the line before it names or None)"""
    for found in fence.finditer(text):
        named = re.search(r"`([^`\s]+)`:\s*$", text[: found.start()])
        runs = found[1] in ("sh", "python", "text")
        assert runs or named, f"a block of {found[1]} without a line that names its file"
        yield found[1], found[2], None if runs else named[1]


def run_shell(content):
    done = subprocess.run(["bash", "-eo", "pipefail", "-c", content], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert done.returncode == 0, f"exit code {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout


def run_python(content, names):
    told = io.StringIO()
    with contextlib.redirect_stdout(told):
        exec(content, names)
    return told.getvalue()


def matches(wanted, told):
    return doctest.OutputChecker().check_output(wanted, told, doctest.ELLIPSIS)


def follow_block(language, content, names, before):
    """What a block prints; None if it is none to print, or needs the package that is not there."""
    if language == "sh":
        return run_shell(content)
    if language == "python":
        uses_package = "import vortree" in content or "vortree" in names
        if uses_package and not with_package:
            names["vortree"] = None
            return None
        return run_python(content, names)
    assert before is None or matches(content, before), f"wanted:\n{content}found:\n{before}"
    return before


def follow(guide):
    """How many blocks did something, of how many; an AssertionError names the block that fails."""
    told, names, done, all_blocks = None, {}, 0, list(blocks(guide.read_text()))
    for language, content, file in all_blocks:
        try:
            if file:
                Path(file).write_text(content)
            else:
                told = follow_block(language, content, names, told)
        except Exception as failure:
            raise AssertionError(f"{guide.name}:\n{content}{failure}") from failure
        done += file is not None or told is not None
    assert all_blocks and all_blocks[0][0] != "text", f"{guide.name}: nothing to do at first"
    return f"{done} of {len(all_blocks)} blocks"


def main(program, guides):
    assert not matches("a\n...\nc\n", "a\nb\nd\n")
    for guide in guides:
        with tempfile.TemporaryDirectory() as scratch:
            os.chdir(scratch)
            Path("vortree").symlink_to(Path(program).absolute())
            print(f"{guide.name}: {follow(guide)}", flush=True)
            os.chdir("/")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = Path(sys.argv[1]).absolute()
    guides = [Path(name).absolute() for name in sys.argv[2:]]
    main(program, guides or sorted((project / "cases/guides").glob("*.md")))
