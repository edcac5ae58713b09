"""Calls that fail, kills, and disks that are full."""

import errno
import resource
import signal

from bench import Trial, has_frames, require_clean, require_recovery

CALLS = {"read": errno.EIO, "write": errno.ENOSPC, "fsync": errno.EIO, "open": errno.EACCES,
         "rename": errno.EROFS, "link": errno.EIO, "unlink": errno.EPERM,
         "truncate": errno.ENOSPC, "close": errno.EIO, "mkdir": errno.EROFS,
         "flock": errno.ENOLCK}


def kills_in_a_row(bench, count, random):
    """Up to three times a run, each at any call of the system."""
    total = {scene: bench.calls(scene, "all") for scene in bench.scenes}
    for k in range(count):
        scene = bench.scenes[k % len(bench.scenes)]
        calls = [random.randint(1, total[scene]) for _ in range(random.randint(1, 3))]

        def act(scene=scene, calls=calls):
            folder = bench.folder()
            words = []
            for at in calls:
                faults = dict(calls="all", at=at, how="kill", folder=folder)
                end = bench.run(scene, folder, *words, faults=faults)
                require_clean(end, (signal.SIGKILL,))
                if end.code == 0:
                    break
                words = ["--resume"] if end.code == -signal.SIGKILL and has_frames(folder) else []
            return require_recovery(bench, scene, folder, end, (signal.SIGKILL,))

        yield Trial("kills in a row", f"{scene} at calls {calls}", act)


def under(bench, scene, resumed, **faults):
    """A run, or the resuming of a finished one, in which some call fails."""
    folder = bench.copy(scene) if resumed else bench.folder()
    words = ["--resume"] if resumed else []
    end = bench.run(scene, folder, *words, faults=dict(folder=folder, **faults))
    if faults.get("calls") in ("write", "fsync", "rename", "truncate"):
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
            for resumed in (False, True):
                total = bench.calls(scene, call, resumed)
                most = (3 if call in ("read", "write") else 1) * count * (1 if resumed else 2)
                for at in places(total, most, random):
                    lasts = dict(lasts=1) if random.random() < 0.25 else {}
                    yield Trial(f"failing {call}", f"{scene} {call} {at} of {total} {lasts} "
                                f"{'resumed' if resumed else ''}",
                                lambda s=scene, c=call, n=at, w=why, m=lasts, r=resumed: under(
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


KINDS = (kills_in_a_row, kills_at_calls, failing_calls, full_disk)
