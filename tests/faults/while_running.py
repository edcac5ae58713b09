"""What happens to a run while it runs: to its files, by signals, by limits, by a second run."""

import errno
import os
import random
import resource
import shutil
import signal

import h5py

import contents
from bench import Trial, has_frames, require_clean, require_same, wait_for_end, wait_for_rows
from calls import limited
from scenes import TABLES


def long_run(scene, folder, bench, **more):
    return bench.start(scene, folder, "time.end=1000", **more)


def require_same_to_a_later_end(bench, scene, folder):
    """Goes on for a step, and compares with a run that did so at once. A stop leaves a frame more."""
    with h5py.File(folder / "frames.h5") as file:
        last = max(int(name.split("_")[1]) for name in file if name.startswith("frame_"))
    end = f"time.end={0.02 * max(last + 1, 8)}"
    twin = bench.folder()
    for where, words in ((folder, ["--resume"]), (twin, [])):
        done = bench.run(scene, where, *words, end)
        assert done.code == 0, done
    a, b = contents.contents(folder), contents.contents(twin)
    assert a["report.csv"] == b["report.csv"] and a["fields.h5"] == b["fields.h5"]
    rows = ("rows of", "mark of")  # counted from frame to frame
    wrong = [name for name in b["frames.h5"] if not any(word in name for word in rows)
             and a["frames.h5"].get(name) != b["frames.h5"][name]]
    assert not wrong, wrong


def spoiled_while_running(bench, count, random):
    def remove(path):
        if not path.is_dir():
            return path.unlink()
        for _ in range(100):  # the run may add a file while its folder is emptied
            try:
                return shutil.rmtree(path)
            except OSError as refused:
                if refused.errno != errno.ENOTEMPTY:
                    raise
        raise RuntimeError(f"{path} is filled faster than it is emptied")

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
                end = wait_for_end(process)
                require_clean(end)
                assert end.code == 1, end
                said = [line for line in end.err.splitlines() if "warning: " not in line]
                assert len(said) == 1, end.err
                if folder.exists():
                    folder.chmod(0o777)
                for path in folder.glob("*"):
                    os.chmod(path, 0o666)
                if not has_frames(folder):
                    end = bench.run(scene, folder, "--resume")
                    assert end.code == 2 and name in (None, "frames.h5"), end
                    return "refused with a line"
                require_same_to_a_later_end(bench, scene, folder)
                return "ended with a line, resumed, the same"

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
                require_same_to_a_later_end(bench, scene, folder)
                return "stopped, resumed, the same"

            yield Trial("signals", f"{scene} {sent.name}", act)

        def go_on(scene=scene):
            folder = bench.folder()
            process = bench.start(scene, folder, hangup="ignore")
            wait_for_rows(process, folder, 1)
            process.send_signal(signal.SIGHUP)
            end = wait_for_end(process)
            assert end.code == 0, end
            require_same(bench, scene, folder)
            return "ran to its end"

        yield Trial("signals", f"{scene} SIGHUP under nohup", go_on)
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


KINDS = (spoiled_while_running, signals, limits, two_runs)
