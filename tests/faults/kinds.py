"""The kinds of faults. Each function yields trials."""

import errno
import os
import resource
import shutil
import signal
import subprocess
import time

from bench import (Trial, require_clean, require_recovery, require_same, wait_for_end,
                   wait_for_rows)

TABLES = {"vortex": "energy.csv", "walk": "energy.csv", "exchange": "energy.csv",
          "cylinder": "wall.csv", "foil": "wall.csv"}
CALLS = {"write": errno.ENOSPC, "fsync": errno.EIO, "open": errno.EACCES, "rename": errno.EROFS,
         "link": errno.EIO, "unlink": errno.EPERM, "truncate": errno.ENOSPC, "close": errno.EIO,
         "mkdir": errno.EROFS}


def trials(bench, count, random):
    for kind in (kills_at_random, kills_at_calls, failing_calls, full_disk, damaged_frames,
                 damaged_tables, lost_files, spoiled_while_running, signals, limits, two_runs,
                 other_outputs, odd_outputs):
        yield from kind(bench, count, random)


def kills_at_random(bench, count, random):
    """Up to three times a run, at random moments of wall time."""
    for k in range(count):
        scene = bench.scenes[k % len(bench.scenes)]
        moments = [random.uniform(0.02, 0.4) for _ in range(random.randint(1, 3))]

        def act(scene=scene, moments=moments):
            folder = bench.folder()
            words = []
            for moment in moments:
                process = bench.start(scene, folder, *words)
                try:
                    process.wait(moment)
                except subprocess.TimeoutExpired:
                    process.kill()
                end = wait_for_end(process)
                require_clean(end, (signal.SIGKILL,))
                if end.code == 0:
                    break
                words = ["--resume"] if end.code == -signal.SIGKILL and has_frames(folder) else []
            return require_recovery(bench, scene, folder, end, (signal.SIGKILL,))

        yield Trial("kill at a random moment", f"{scene} after {moments}", act)


def has_frames(folder):
    import h5py
    try:
        with h5py.File(folder / "frames.h5") as file:
            return any(name.startswith("frame_") for name in file)
    except OSError:
        return False


def under(bench, scene, resumed, **faults):
    """A run, or the resuming of a finished one, in which some call fails."""
    folder = bench.copy(scene) if resumed else bench.folder()
    words = ["--resume"] if resumed else []
    end = bench.run(scene, folder, *words, faults=dict(folder=folder, **faults))
    if not resumed and faults.get("calls") in ("write", "fsync", "rename", "truncate"):
        assert end.code == 1, f"a failed {faults['calls']} passed for a success"
    return require_recovery(bench, scene, folder, end, (signal.SIGKILL,))


def places(total, most, random):
    every = range(1, total + 1)
    return every if total <= most else sorted(random.sample(every, most))


def kills_at_calls(bench, count, random):
    for scene in bench.scenes:
        for at in places(bench.calls(scene, "all"), 2 * count, random):
            resumed = random.random() < 0.25
            yield Trial("kill at a call of the system", f"{scene} call {at} {resumed}",
                        lambda s=scene, n=at, r=resumed: under(bench, s, r, calls="all", at=n,
                                                               how="kill"))


def failing_calls(bench, count, random):
    """One call fails, or all from there on: every place of a short run where there is time."""
    for scene in bench.scenes:
        for call, why in CALLS.items():
            total = bench.calls(scene, call)
            for at in places(total, 6 * count if call == "write" else 2 * count, random):
                for lasts in (False, True) if at % 3 == 0 else (False,):
                    more = dict(lasts=1) if lasts else {}
                    resumed = random.random() < 0.2
                    yield Trial(f"failing {call}", f"{scene} {call} {at} of {total}, {more} {resumed}",
                                lambda s=scene, c=call, n=at, w=why, m=more, r=resumed: under(
                                    bench, s, r, calls=c, at=n, how=w, **m))


def full_disk(bench, count, random):
    for k in range(count):
        scene = bench.scenes[k % len(bench.scenes)]
        size = int(10 ** random.uniform(2, 5.9))
        yield Trial("full disk", f"{scene} {size} bytes",
                    lambda s=scene, n=size: under(bench, s, False, bytes=n))
        yield Trial("limit to the size of a file", f"{scene} {size} bytes",
                    lambda s=scene, n=size: limited(bench, s, resource.RLIMIT_FSIZE, n))


def limited(bench, scene, what, most):
    folder = bench.folder()
    end = bench.run(scene, folder,
                    preexec_fn=lambda: resource.setrlimit(what, (most, most)))
    if "error while loading" in end.err:
        return "not even loaded"  # the words of the system's loader
    return require_recovery(bench, scene, folder, end)


def flip(data, random):
    at = random.randrange(len(data))
    data[at] ^= 1 << random.randrange(8)


def cut(data, random):
    del data[random.randrange(len(data)):]


def zero(data, random):
    at = random.randrange(len(data))
    data[at:at + 512] = bytes(len(data[at:at + 512]))


def damaged_frames(bench, count, random):
    for k in range(3 * count):
        scene = bench.scenes[k % len(bench.scenes)]
        spoil = (flip, cut, zero)[k // len(bench.scenes) % 3]
        name = "fields.h5" if k % 4 == 3 else "frames.h5"

        def act(scene=scene, spoil=spoil, name=name, seed=random.random()):
            import random as chance
            folder = bench.copy(scene)
            data = bytearray((folder / name).read_bytes())
            spoil(data, chance.Random(seed))
            (folder / name).write_bytes(data)
            end = bench.run(scene, folder, "--resume")
            require_clean(end)
            if end.code == 2:
                return require_recovery(bench, scene, folder, end)
            assert end.code == 0, end
            # Lost frames and pictures are not made again, which is said; all else is.
            lost = " lost" in end.err
            but = ("frames.h5", "frames.xdmf", "fields.h5") if lost else ()
            require_same(bench, scene, folder, but)
            return "told of, the rest the same" if lost else "resumed, the same"

        yield Trial(f"damaged {name}", f"{scene} {spoil.__name__}", act)


def rows_missing(lines, random):
    del lines[random.randrange(1, len(lines))]


def rows_doubled(lines, random):
    at = random.randrange(1, len(lines))
    lines.insert(at, lines[at])


def rows_shuffled(lines, random):
    a, b = random.sample(range(1, len(lines)), 2)
    lines[a], lines[b] = lines[b], lines[a]


def rows_altered(lines, random):
    at = random.randrange(1, len(lines))
    place = random.randrange(len(lines[at]) - 1)
    digit = random.choice("0123456789,.")
    lines[at] = lines[at][:place] + digit + lines[at][place + 1:]


def rows_cut(lines, random):
    del lines[random.randrange(len(lines)):]


def damaged_tables(bench, count, random):
    for k in range(3 * count):
        scene = bench.scenes[k % len(bench.scenes)]
        spoil = (rows_missing, rows_doubled, rows_shuffled, rows_altered, rows_cut)[k % 5]
        table = "report.csv" if k % 3 else TABLES[scene]

        def act(scene=scene, spoil=spoil, table=table, seed=random.random()):
            import random as chance
            folder = bench.copy(scene)
            lines = (folder / table).read_text().splitlines(True)
            spoil(lines, chance.Random(seed))
            (folder / table).write_text("".join(lines))
            end = bench.run(scene, folder, "--resume")
            require_clean(end)
            assert end.code == 0, end
            require_same(bench, scene, folder)
            return "made again" if "made again" in end.err else "resumed, the same"

        yield Trial("damaged tables", f"{scene} {table} {spoil.__name__}", act)


def lost_files(bench, count, random):
    for scene in bench.scenes:
        for name in ("report.csv", TABLES[scene], "frames.xdmf", "summary.json", "fields.h5"):

            def act(scene=scene, name=name):
                folder = bench.copy(scene)
                (folder / name).unlink()
                end = bench.run(scene, folder, "--resume")
                require_clean(end)
                assert end.code == 0, end
                said = len(end.err.splitlines()) > 1
                derived = name in ("frames.xdmf", "summary.json")
                assert said or derived, "not a word"
                require_same(bench, scene, folder, ("fields.h5", "files") if name == "fields.h5"
                             else ())
                return "made again" if name != "fields.h5" else "told of, the rest the same"

            yield Trial("lost files", f"{scene} {name}", act)


def long_run(scene, folder, bench, **more):
    return bench.start(scene, folder, "time.end=1000", **more)


def spoiled_while_running(bench, count, random):
    def remove(path):
        shutil.rmtree(path) if path.is_dir() else path.unlink()

    def empty(path):
        path.write_text("")

    def replace(path):
        text = path.read_text()
        path.with_suffix(".new").write_text(text)
        path.with_suffix(".new").rename(path)

    def read_only(path):
        path.chmod(0o555)

    deeds = [(remove, "report.csv"), (empty, "report.csv"), (replace, "report.csv"),
             (remove, None), (remove, "frames.h5"), (empty, "frames.h5"), (read_only, ".")]
    for scene in bench.scenes:
        for deed, name in deeds + [(remove, TABLES[scene]), (empty, TABLES[scene])]:

            def act(scene=scene, deed=deed, name=name):
                folder = bench.folder()
                # Root may write all; so as nobody.
                who = dict(user=65534, group=65534) if os.geteuid() == 0 else {}
                folder.mkdir()
                folder.chmod(0o777)
                process = long_run(scene, folder, bench, **who)
                wait_for_rows(process, folder, random.randint(4, 9))
                deed(folder / (name or ""))
                time.sleep(0.01)
                end = wait_for_end(process)
                require_clean(end)
                assert end.code == 1, end
                assert len(end.err.splitlines()) == 1, end.err
                if folder.exists():
                    folder.chmod(0o777)
                for path in folder.glob("*"):
                    os.chmod(path, 0o666)
                end = bench.run(scene, folder, "--resume")
                require_clean(end)
                if end.code == 2:  # the frames are gone
                    assert name in (None, "frames.h5"), end
                    return "refused with a line"
                return "ended with a line, resumed"

            yield Trial("spoiled while it runs", f"{scene} {deed.__name__} {name}", act)


def signals(bench, count, random):
    for scene in bench.scenes:
        for sent in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGXCPU):

            def act(scene=scene, sent=sent):
                folder = bench.folder()
                process = long_run(scene, folder, bench)
                wait_for_rows(process, folder, random.randint(2, 6))
                process.send_signal(sent)
                end = wait_for_end(process)
                require_clean(end)
                assert end.code == 1 and "--resume" in end.err, end
                step = int(end.err.split("step ")[1].split(",")[0])
                end = bench.run(scene, folder, "--resume", f"time.end={0.02 * (step + 1)}")
                assert end.code == 0, end
                twin = bench.folder()
                assert bench.run(scene, twin, f"time.end={0.02 * (step + 1)}").code == 0
                # A stop leaves one frame more.
                import contents
                a, b = contents.contents(folder), contents.contents(twin)
                assert a["report.csv"] == b["report.csv"] and a["fields.h5"] == b["fields.h5"]
                assert all(b["frames.h5"][name] == a["frames.h5"].get(name)
                           for name in b["frames.h5"] if "rows of" not in name
                           and "mark of" not in name)
                return "stopped, resumed, the same"

            yield Trial("signals", f"{scene} {sent.name}", act)
        for closed in ("pipe", "descriptors", "full"):

            def act(scene=scene, closed=closed):
                folder = bench.folder()
                if closed == "pipe":
                    process = bench.start(scene, folder)
                    process.stdout.close()
                    process.stderr.close()
                    process.wait(300)
                else:
                    words = {"descriptors": ">&- 2>&- <&-", "full": ">/dev/full 2>/dev/full"}
                    line = " ".join(f"'{w}'" for w in bench.command(scene, folder))
                    bench.call(["sh", "-c", f"{line} {words[closed]}"])
                require_same(bench, scene, folder)
                return "ran to its end"

            yield Trial("nobody listens", f"{scene} {closed}", act)


def limits(bench, count, random):
    scene = bench.scenes[0]
    for megabytes in (20, 40, 50, 60, 70, 80, 90, 100, 120, 150, 200):
        yield Trial("limit to memory", f"{megabytes} MB",
                    lambda m=megabytes: limited(bench, scene, resource.RLIMIT_AS, m << 20))
    for number in range(3, 13):
        yield Trial("limit to open files", f"{number}",
                    lambda n=number: limited(bench, scene, resource.RLIMIT_NOFILE, n))


def two_runs(bench, count, random):
    for scene in bench.scenes:
        for words in ([], ["--resume"], ["--overwrite"], ["time.dt=0.01", "--overwrite"]):

            def act(scene=scene, words=words):
                folder = bench.folder()
                process = bench.start(scene, folder, "time.end=0.16", "time.dt=0.02")
                wait_for_rows(process, folder, 0)
                process.send_signal(signal.SIGSTOP)
                if process.poll() is not None:
                    return "too late"
                second = bench.run(scene, folder, *words)
                process.send_signal(signal.SIGCONT)
                first = wait_for_end(process)
                assert second.code == 2 and len(second.err.splitlines()) == 1, second
                assert str(folder) in second.err and str(process.pid) in second.err, second
                assert first.code == 0, first
                require_same(bench, scene, folder)
                return "the second refused, the first whole"

            yield Trial("two runs", f"{scene} {words}", act)

        def again(scene=scene):
            folder = bench.copy(scene)
            end = bench.run(scene, folder)
            assert end.code == 2 and len(end.err.splitlines()) == 1, end
            assert "--resume" in end.err and "--overwrite" in end.err, end
            require_same(bench, scene, folder)
            return "the second refused, the first whole"

        yield Trial("two runs", f"{scene} one after the other", again)


def particles(path, n):
    import h5py
    import numpy as np
    values = np.random.default_rng(1).random((5, n))
    with h5py.File(path, "w") as file:
        for name, column in zip(("x", "y", "gamma", "sigma", "reach"), values):
            file[name] = column / n ** 0.5 if name in ("sigma", "reach") else column
    return path


def numbers(path):
    import h5py
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
        for file in ("frames.h5", "frames.xdmf", "fields.h5", "report.csv", TABLES[scene],
                     "summary.json"):
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
