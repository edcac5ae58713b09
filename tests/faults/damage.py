"""Files that are not what they were when the run goes on."""

import random as chance

import old_frames
from bench import Trial, require_clean, require_recovery, require_same
from scenes import TABLES


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
            but = ("frames.h5", "frames.xdmf", "fields.h5", "fields.xdmf") if lost else ()
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
        derived = ["frames.xdmf", "fields.xdmf", "summary.json"]
        if "outline.csv" in bench.whole[scene]["files"]:
            derived.append("outline.csv")
        for name in ("report.csv", TABLES[scene], "fields.h5", *derived):

            def act(scene=scene, name=name):
                folder = bench.copy(scene)
                (folder / name).unlink()
                end = bench.run(scene, folder, "--resume")
                require_clean(end)
                assert end.code == 0, end
                said = len(end.err.splitlines()) > 1
                assert said or name in derived, "not a word"
                require_same(bench, scene, folder, ("fields.h5", "fields.xdmf", "files")
                             if name == "fields.h5" else ())
                return "made again" if name != "fields.h5" else "told of, the rest the same"

            yield Trial("lost files", f"{scene} {name}", act)


def other_version(bench, count, random):
    """Good frames that lack what this version needs to go on."""
    for scene in bench.scenes:

        def act(scene=scene):
            folder = bench.copy(scene)
            old_frames.forget_tables(folder / "frames.h5")
            before = (folder / "frames.h5").read_bytes()
            end = bench.run(scene, folder, "--resume")
            require_clean(end)
            assert end.code == 2 and "another version" in end.err, end
            assert (folder / "frames.h5").read_bytes() == before, "frames were changed"
            return "refused with a line"

        yield Trial("frames of another version", scene, act)


KINDS = (damaged_frames, damaged_tables, lost_files, other_version)
