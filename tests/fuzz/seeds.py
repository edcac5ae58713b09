"""Usage: seeds.py CASES FOLDER   writes the seeds of each fuzz target into FOLDER/TARGET."""
import pathlib
import shutil
import sys

import h5py
import numpy

cases, folder = map(pathlib.Path, sys.argv[1:])
columns = ("x", "y", "gamma", "sigma", "reach")
random = numpy.random.default_rng(1)


def seeds_of(target):
    (folder / target).mkdir(parents=True, exist_ok=True)
    return folder / target


def particles(name, n=5, **ways):
    """A file with every column, made in one of the ways of HDF5; x may be left to the caller."""
    bounds = ways.pop("libver", "earliest")
    file = h5py.File(seeds_of("particles") / name, "w", libver=bounds)
    for column in columns:
        if column != ways.get("without"):
            options = {k: v for k, v in ways.items() if k != "without"}
            file.create_dataset(column, data=random.random(n), **options)
    return file


def external_storage(file):
    creation = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    creation.set_external(b"none.bin", 0, 40)
    space = h5py.h5s.create_simple((5,))
    h5py.h5d.create(file.id, b"x", h5py.h5t.IEEE_F64LE, space, creation)


def virtual(file):
    layout = h5py.VirtualLayout(shape=(5,), dtype="f8")
    layout[:] = h5py.VirtualSource("none.h5", "x", shape=(5,))
    file.create_virtual_dataset("x", layout)


particles("plain.h5")
particles("latest.h5", libver="latest")
particles("packed.h5", n=64, chunks=(16,), compression="gzip", shuffle=True, fletcher32=True)
particles("lzf.h5", n=64, chunks=(64,), compression="lzf")
particles("scaled.h5", n=64, chunks=(64,), scaleoffset=3)
particles("resizable.h5", n=20, chunks=(8,), maxshape=(None,), libver="latest")
particles("float32.h5", dtype="f4")
particles("integers.h5", dtype=">i2")
virtual(particles("virtual.h5", without="x"))
external_storage(particles("raw.h5", without="x"))
particles("link.h5", without="x")["x"] = h5py.ExternalLink("none.h5", "x")
particles("soft.h5", without="x")["x"] = h5py.SoftLink("/y")
particles("huge.h5", without="x").create_dataset("x", (2**40,), chunks=(64,))

rows = random.random((5, 4))
named = {name: random.random(5) for name in columns}
numpy.save(seeds_of("arrays") / "rows.npy", rows)
numpy.save(seeds_of("arrays") / "turned.npy", numpy.asfortranarray(rows.astype(">f4")))
numpy.save(seeds_of("arrays") / "records.npy", numpy.zeros(3, [(name, "<i2") for name in columns]))
numpy.savez(seeds_of("arrays") / "stored.npz", **named)
numpy.savez_compressed(seeds_of("arrays") / "packed.npz", points=rows[:, :2], gamma=named["gamma"], sigma=0.1)
(seeds_of("arrays") / "rows.csv").write_text("# a\nname,x,y,gamma\na,1,2,3\nb,4,-5e-3,+6\n")

frame = {name: random.random(3) for name in ("x", "y", "gamma", "sigma", "u", "v")}
with h5py.File(seeds_of("frames") / "fields.h5", "w") as file:
    group = file.create_group("field_0.5", track_order=True)
    group["x"], group["y"] = [0.0, 1.0], [0.0, 1.0, 2.0]
    for name in ("u", "v", "omega"):
        group[name] = random.random((3, 2))
    group.attrs["time"] = 0.5

for scene in cases.glob("*.toml"):
    shutil.copy(scene, seeds_of("scene"))
for table in (cases / "reference").glob("*.csv"):
    shutil.copy(table, seeds_of("table"))
(seeds_of("table") / "small.csv").write_text("# a\nT,C_D\n0,1.5\n0.1, -2e-3\n,nan\n")
base = (cases / "lamb_oseen.toml").read_text()
for i, lines in enumerate(["flow.nu=1e-3", "velocity.method=boxes\ntime.end=1", "title=a b", "x=[1, 2"]):
    (seeds_of("scene") / f"over{i}").write_text(f"{base}\n---\n{lines}")
lines = ["run\nlamb_oseen\ntime.end=1\n--out\nd\n--resume", "check\ncylinder\nflow.nu=1",
         "velocity\na.h5\n--out\nb.h5\n--tolerance\n1e-6\n--verify\n--threads\n2",
         "neighbors\na\n--out=b\n--rule\nmean\n--half\n--repeat\n3", "cases", "plot\nd", "--help",
         "bench\nvelocity\n--quick\n--largest\n1000", "--version", "run\na\n--", "velocity\n--order=-3"]
for i, text in enumerate(lines):
    (seeds_of("command_line") / f"line{i}").write_text(text)
