"""What a command may write to, and what it leaves there."""

import errno
import os
import signal

import h5py
import numpy

from bench import Trial, require_clean, require_same
from scenes import TABLES


def particles(path, n):
    values = numpy.random.default_rng(1).random((5, n))
    with h5py.File(path, "w") as file:
        for name, column in zip(("x", "y", "gamma", "sigma", "reach"), values):
            file[name] = column / n ** 0.5 if name in ("sigma", "reach") else column
    return path


def numbers(path):
    with h5py.File(path) as file:
        return {name: file[name][()].tobytes() for name in file}


def other_outputs(bench, count, random):
    """velocity and neighbors: the old or the new, whatever fails."""
    source = particles(bench.root / "particles.h5", 500)
    for command in ("velocity", "neighbors"):
        folder = bench.folder()
        folder.mkdir()
        words = [str(bench.program), command, str(source), "--threads", "1", "--out"]
        told = folder / "count"
        new = bench.root / f"{command}.h5"
        assert bench.call([*words, str(new)], dict(calls="all", count=told, folder=bench.root)
                          ).code == 0
        right = numbers(new)
        for at in range(1, int(told.read_text()) + 1):
            for how in (errno.ENOSPC, "kill"):

                def act(words=words, at=at, how=how, right=right):
                    folder = bench.folder()
                    folder.mkdir()
                    out = folder / "out.h5"
                    out.write_bytes(b"old")
                    before = source.read_bytes()
                    end = bench.call([*words, str(out)],
                                     dict(calls="all", at=at, how=how, folder=bench.root))
                    require_clean(end, (signal.SIGKILL,))
                    assert source.read_bytes() == before
                    old = out.read_bytes() == b"old"
                    assert numbers(out) == right if not old else end.code != 0, end
                    again = bench.call([*words, str(out)])
                    assert again.code == 0 and numbers(out) == right, again
                    assert os.listdir(folder) == ["out.h5"], os.listdir(folder)
                    return "the new one" if end.code == 0 else "the old or the new one"

                yield Trial(f"{command}, failing or killed", f"call {at} {how}", act)


def odd_outputs(bench, count, random):
    """What no command may write to."""
    source = particles(bench.root / "source.h5", 50)
    makers = {
        "pipe": os.mkfifo,
        "folder": os.mkdir,
        "device": lambda path: os.symlink("/dev/null", path),
        "input": lambda path: os.link(source, path),
        "link to the input": lambda path: os.symlink(source, path),
    }
    for command in ("velocity", "neighbors"):
        for name, make in makers.items():

            def act(command=command, make=make):
                folder = bench.folder()
                folder.mkdir()
                make(folder / "out")
                kind, before = os.lstat(folder / "out").st_mode, source.read_bytes()
                end = bench.call([str(bench.program), command, str(source), "--out",
                                  str(folder / "out")])
                assert end.code == 2 and len(end.err.splitlines()) == 1, end
                assert os.lstat(folder / "out").st_mode == kind and source.read_bytes() == before
                return "refused with a line"

            yield Trial("odd outputs", f"{command} to a {name}", act)
    for scene in bench.scenes:
        for file in ("frames.h5", "frames.xdmf", "fields.h5", "fields.xdmf", "report.csv",
                     TABLES[scene], "outline.csv", "summary.json"):
            for name, make in makers.items():
                if "input" in name:
                    continue

                def act(scene=scene, file=file, make=make):
                    folder = bench.folder()
                    folder.mkdir()
                    make(folder / file)
                    kind = os.lstat(folder / file).st_mode
                    end = bench.run(scene, folder, "--overwrite")
                    assert end.code == 2 and len(end.err.splitlines()) == 1, end
                    assert os.lstat(folder / file).st_mode == kind
                    return "refused with a line"

                yield Trial("odd outputs", f"{scene} {file} is a {name}", act)

        def links(scene=scene):
            folder, disk = bench.folder(), bench.folder()
            folder.mkdir(), disk.mkdir()
            files = [name for name in bench.whole[scene]["files"]]
            for name in files:
                os.symlink(disk / name, folder / name)
            assert bench.run(scene, folder).code == 0
            for words in (["--overwrite"], ["--resume"]):
                assert bench.run(scene, folder, *words).code == 0
                assert all(os.path.islink(folder / name) for name in files)
                require_same(bench, scene, folder)
                assert sorted(os.listdir(disk)) == files
            return "links followed"

        yield Trial("odd outputs", f"{scene} links for all files", links)


KINDS = (other_outputs, odd_outputs)
