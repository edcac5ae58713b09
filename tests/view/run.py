"""The page that `vortree view` makes, in a Chromium that draws by software.

    tests/view/run.py PROGRAM [KEEP]

KEEP: a folder in which runs, pages and pictures stay. Without Chromium there is nothing to open the
page by: exit code 77, a test that is skipped.
"""

import contextlib
import http.client
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import browser

if not browser.program():
    print("no chromium: the page is not opened")
    sys.exit(77)

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "plots"))
sys.dont_write_bytecode = True

import numpy as np  # noqa: E402
from _movie_page import history_of  # noqa: E402
from _style import Run  # noqa: E402
from _view_cells import childless  # noqa: E402
from _view_cores import vorticity  # noqa: E402
from _view_frames import Frames  # noqa: E402
from _vorticity import in_units  # noqa: E402
from matplotlib.image import imread  # noqa: E402

CIRCLE = """
title = "A <circle> & its wake"
accuracy = 0.05
[flow]
reynolds = 100
stream = [1.0, 0.0]
[body]
radius = 0.5
[time]
end = 0.6
[velocity]
capacity = 8
[output]
frames = 0.1
fields = [0.3, 0.6]
window = [-1.0, -1.0, 2.0, 1.0]
field_spacing = 0.05
"""

def run(program, folder, scene, *words):
    path = folder.with_suffix(".toml")
    path.write_text(scene)
    call(program, "run", path, "--out", folder, "--overwrite", *words)
    return folder


def call(*words):
    """Without figures."""
    made = subprocess.run(words, capture_output=True, text=True,
                          env={**os.environ, "VORTREE_SHARE": str(Path(words[0]).parent)})
    assert made.returncode == 0, made.stderr


def page_of(program, folder):
    subprocess.run([program, "view", folder], check=True, capture_output=True)
    return folder / "view.html"


def check_fields(folder, within):
    """The Gaussians of the frames add up to the pictures that the program made itself, from which
    flow.png is drawn; off by `within` of the largest."""
    told, frames, compared = Run(folder), Frames(Run(folder)), 0
    fields, units = told.fields(), frames.units
    for time, field in zip(fields.times, fields):
        same = [k for k, t in enumerate(frames.times) if abs(t - time) < 1e-9]
        if not same or time == 0:
            continue
        field = in_units([field], units.length, units.centre, units.speed)[0]
        X, Y = np.meshgrid(field["x"], field["y"])
        some = np.flatnonzero(field["omega"].ravel() != 0)[::7]
        sums = vorticity(frames.acting(same[0]).parts(), X.ravel()[some], Y.ravel()[some])
        wanted = field["omega"].ravel()[some]
        off = np.abs(sums - wanted).max() / np.abs(wanted).max()
        print(f"  a picture at t = {time:g}: off by {off:.1e} of the largest")
        assert some.size > 100 and off < within
        compared += 1
    assert compared


def grid(box, count=12):
    """Places in a box that lie in no pattern of the pixels."""
    x0, x1, y0, y1 = box
    X, Y = np.meshgrid(np.linspace(x0, x1, count + 2)[1:-1] + 0.0137 * (x1 - x0) / count,
                       np.linspace(y0, y1, count + 2)[1:-1])
    return np.c_[X.ravel(), Y.ravel()]


def bound(parts, at, pixel):
    """How far a sum of the page may be off: gamma and sigma are rounded to 2^-14 of themselves,
    places to half a step and then to single floats, as is what is computed of them; what is farther
    than 3.7 sigma is left out, and each addition rounds."""
    x, y, gamma, sigma = parts
    least = 0.7 * pixel
    assert sigma.min() > least, "blobs are drawn wider than they are: zoom in"
    q = np.hypot(at[:, :1] - x, at[:, 1:] - y) / sigma
    each = np.abs(gamma / (np.pi * sigma**2)) * np.exp(-q**2)
    step = max(np.ptp(x), np.ptp(y)) / 2**24
    place = step + 2**-22 * (np.abs(np.r_[x, y]).max() + 2000 * pixel)
    single = 2**-22 * (4 + q**2 + np.count_nonzero(each > 1e-7 * each.max(), axis=1)[:, None] / 4)
    relative = 3 * 2**-14 + 2 * q**2 * 2**-14 + 2 * q * place / sigma + single
    return (each * relative).sum(1) + np.where(q > 3.7 * (1 - 2**-10), each, 0).sum(1)


def check_sums(page, frames, k, box):
    page.told(f"vortree.goTo({k})")
    page.told(f"vortree.zoomTo({list(box)})")
    found = np.array(page.told(f"vortree.sums({grid(box).tolist()})"))
    at, sums = found[:, :2], found[:, 2]
    parts = frames.acting(k).parts()
    pixel = page.told("vortree.page.camera.unit")
    exact, most = vorticity(parts, *at.T), bound(parts, at, pixel)
    largest = np.abs(exact).max()
    off = np.abs(sums - exact)
    print(f"  sums in {box}: off by up to {off.max() / largest:.1e} of the largest, "
          f"{(off / np.maximum(most, 1e-300)).max():.2f} of the bound")
    assert largest > 0.1 * np.abs(frames.ends()["vorticity"]).max(), "nothing to see there"
    assert (off <= most + 1e-12 * largest).all()
    return at, exact


def check_colours(page, kept, at, values, inside):
    """A picture of the window against the colours of the field; 2 of 255 for rounding of either,
    and the colours of the pixels around, for a screen's pixel is none of the sum."""
    picture = (255 * imread(kept)[:, :, :3]).round()
    seen = 0
    for (x, y), value in zip(at, values):
        if inside(x, y):
            continue
        px, py = page.told(f"vortree.toPixel({x}, {y})")
        wanted = np.array(page.told(f"vortree.colourOf({value})"))
        window = picture[int(py) - 1:int(py) + 2, int(px) - 1:int(px) + 2].reshape(-1, 3)
        low, high = window.min(0) - 2, window.max(0) + 2
        assert ((wanted >= low) & (wanted <= high)).all(), (x, y, value, wanted, window)
        seen += 1
    assert seen > 50
    print(f"  {seen} places have the colours of the field")


def check_circle(program, folder, kept):
    made = page_of(program, run(program, folder, CIRCLE))
    check_fields(folder, 1e-8)  # cores are cut off at 1e-10 of their peaks, and some overlap
    text = made.read_text()
    assert "://" not in text, "an address in the page"
    told, frames = Run(folder), Frames(Run(folder))
    with browser.Browser() as page:
        page.open(made.resolve().as_uri())
        assert page.told("document.title") == "A <circle> & its wake"
        assert page.told("vortree.count") == len(frames) == 7
        assert page.told("vortree.bits") == 23
        last = len(frames) - 1
        box = (-1.4, 2.2, -1.2, 1.2)
        check_sums(page, frames, 3, (0.6, 1.2, 0.4, 0.8))
        at, values = check_sums(page, frames, last, box)
        time.sleep(1)
        kept.write_bytes(page.picture())
        check_colours(page, kept, at, values, lambda x, y: np.hypot(x, y) < 1.05)
        check_body(page, kept)
        check_cells(page, frames, told, last)
        check_keys(page, frames, told)
        check_pick(page, frames)
        assert page.told("vortree.rate(3)") > 0
        strangers = [one for one in page.asked if not one.startswith(("data:", "file:"))]
        assert not strangers, strangers
        assert sum(one.startswith("file:") for one in page.asked) == 1
        assert not page.errors, page.errors


def check_body(page, kept):
    px, py = page.told("vortree.toPixel(0, 0)")
    grey = (255 * imread(kept)[int(py), int(px), :3]).round()
    assert (grey == 0x4D).all(), grey


def check_cells(page, frames, told, k):
    """The cells of the page are those of the program's own tree, where its Python package is."""
    columns = frames.told(k)
    _, _, *cells = childless(columns["x"], columns["y"], frames.most)
    found = page.told("(({level, column, row}) => [level, column, row].map((c) => [...c]))"
                      "(vortree.page.frame)")
    assert [list(map(int, one)) for one in cells] == found
    try:
        import vortree
    except ImportError:
        print("  cells: no Python package, compared with the figures' own")
        return
    tree = vortree.Quadtree(columns["x"], columns["y"], capacity=frames.most)
    own = tree.cells[tree.cells["first_child"] == tree.cells["last_child"]]
    assert sorted(zip(*found)) == sorted(zip(*(own[n].tolist() for n in ("level", "i", "j"))))
    print(f"  {len(own)} cells, those of the program's tree")
    page.press("c")
    assert page.told("vortree.page.state.cells") is True
    page.press("c")


def check_keys(page, frames, told):
    page.told("vortree.goTo(0)")
    for key, frame in (("ArrowRight", 1), ("ArrowRight", 2), ("ArrowLeft", 1), ("End", 6),
                       ("ArrowRight", 6), ("Home", 0), ("PageDown", 6), ("PageUp", 0)):
        page.press(key)
        assert page.told("vortree.frame") == frame, (key, frame)
    page.told("vortree.goTo(4)")
    T, curves = history_of(told)
    now = frames.units.time(frames.times[4])
    assert abs(page.told("vortree.page.history.now") - now) < 1e-9
    wanted = np.interp(now, T, curves[0][1])
    marked = page.told("vortree.mark()")
    assert abs(marked[0] - now) < 1e-6 and abs(marked[1] - wanted) < 1e-5 * abs(wanted), marked
    wide = page.told("vortree.page.camera.width")
    page.press("+")
    assert page.told("vortree.page.camera.width") < wide
    page.press("?")
    assert page.told("document.getElementById('keys').open") is True
    page.press("?")
    assert page.told("document.getElementById('keys').open") is False
    page.press(" ", "Space")
    end = time.monotonic() + 60
    while page.told("vortree.page.state.playing") and time.monotonic() < end:
        time.sleep(0.2)
    assert page.told("vortree.frame") == 6, "it did not play to its end"
    page.press("l")
    assert page.told("vortree.page.scale.faint") > 0
    page.press("l")
    print("  keys step, zoom, play; the mark stands at the frame's time")


def check_pick(page, frames):
    """A click on a blob tells its circulation."""
    told = frames.acting(6)
    page.told("vortree.goTo(6)")
    page.told("vortree.zoomTo([0.9, 1.5, 0.3, 0.7])")
    middle = np.hypot(told.x - 1.2, told.y - 0.5).argmin()
    page.click(*page.told(f"vortree.toPixel({told.x[middle]}, {told.y[middle]})"))
    assert page.told("vortree.page.state.picked") == middle
    page.told("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    said = page.told("document.getElementById('picked').textContent")
    gamma = f"{told.gamma[middle]:.2}".replace("-", "\N{MINUS SIGN}").split("e")[0]
    assert f"blob {middle}" in said and gamma[:4] in said, (said, gamma)


def check_free_space(program, folder):
    """Strained blobs are two."""
    scene = (ROOT / "cases/tripole.toml").read_text().partition("[check]")[0]
    made = page_of(program, run(program, folder, scene, "time.end=0.5", "output.frames=0.25",
                                "output.fields=[0.5]"))
    check_fields(folder, 1e-8)
    frames = Frames(Run(folder))
    last = len(frames) - 1
    assert frames.acting(last).owner.size > 0
    with browser.Browser() as page:
        page.open(made.resolve().as_uri())
        check_sums(page, frames, last, frames.window())
        assert page.told("document.getElementById('history').hidden") is True
        assert not page.errors, page.errors


def check_turned(program, folder):
    """A body that is turned, by the corners of its outline: they stand 0.012 apart, for which
    curvatures are off by a part of its square."""
    scene = (ROOT / "cases/pitching_ellipse.toml").read_text().partition("[check]")[0]
    run(program, folder, scene, "accuracy=0.08", "time.end=0.6", "output.frames=0.6",
        "output.fields=[0.6]")
    assert abs(Run(folder).angle(0.6)) > 0.1
    check_fields(folder, 1e-4)


def check_particles(program, folder, kept):
    scene = (ROOT / "cases/taylor_green.toml").read_text().partition("[check]")[0]
    made = page_of(program, run(program, folder, scene, "sph.spacing=0.0625", "time.end=0.05",
                                "output.frames=0.05", "output.fields=[]"))
    frames = Frames(Run(folder))
    _, columns = frames.frame(1)
    with browser.Browser() as page:
        page.open(made.resolve().as_uri())
        page.told("vortree.goTo(1)")
        for what in ("pressure", "vorticity"):
            page.told(f"vortree.page.set({{ what: '{what}' }})")
            page.told(f"vortree.zoomTo({frames.window()})")
            time.sleep(1)
            kept.write_bytes(page.picture())
            picture = (255 * imread(kept)[:, :, :3]).round()
            inner = [k for k in range(columns["x"].size)
                     if frames.window()[0] + 0.1 < columns["x"][k] < frames.window()[1] - 0.1
                     and frames.window()[2] + 0.1 < columns["y"][k] < frames.window()[3] - 0.1]
            for k in inner[::7]:
                px, py = page.told(f"vortree.toPixel({columns['x'][k]}, {columns['y'][k]})")
                wanted = page.told(f"vortree.colourOf({columns[what][k]})")
                off = np.abs(picture[int(py), int(px)] - wanted).max()
                assert off <= 3, (what, k, picture[int(py), int(px)], wanted)
        assert not page.errors, page.errors
    print(f"  {len(inner[::7])} particles have the colours of their values")


@contextlib.contextmanager
def served(program, folder):
    server = subprocess.Popen([program, "view", folder, "--live"], stdout=subprocess.PIPE,
                              text=True)
    try:
        line = server.stdout.readline()
        assert line.startswith("http://127.0.0.1:"), line
        yield line.split()[0]
        server.send_signal(signal.SIGINT)
        assert server.wait(30) == 0
    finally:
        server.kill()
        server.wait()


def answer(address, path, host=None):
    name = address.removeprefix("http://").rstrip("/")
    link = http.client.HTTPConnection(name, timeout=60)
    link.request("GET", path, headers={"Host": host or name})
    return link.getresponse().status


def check_live(program, folder):
    """A run that goes on: the page follows it. Others get nothing of it."""
    run(program, folder, CIRCLE, "time.end=0.2")
    with served(program, folder) as address, browser.Browser() as page:
        for path, code in (("/", 200), ("/data/run.json", 200), ("/view/main.js", 200),
                           ("/view/../view.py", 404), ("/frames.h5", 404), ("/view/", 404),
                           ("/data/frame/../frames.h5", 404), ("/data/frame/frame_x", 404)):
            assert answer(address, path) == code, path
        assert answer(address, "/", "elsewhere.example") == 403
        page.open(address)
        assert page.told("[vortree.count, vortree.frame]") == [3, 2]
        call(program, "run", folder.with_suffix(".toml"), "--out", folder, "--resume",
             "time.end=0.4")
        end = time.monotonic() + 90
        while page.told("vortree.count") < 5 and time.monotonic() < end:
            time.sleep(0.5)
        assert page.told("vortree.count") == 5
        page.told("vortree.goTo(4)")
        at, _ = check_sums(page, Frames(Run(folder)), 4, (-1.4, 2.2, -1.2, 1.2))
        assert all(one.startswith((address, "data:")) for one in page.asked), page.asked
        assert not page.errors, page.errors
    print("  the served page follows the run")


def main():
    program = Path(sys.argv[1]).resolve()
    with contextlib.ExitStack() as stack:
        kept = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(
            stack.enter_context(tempfile.TemporaryDirectory()))
        kept.mkdir(exist_ok=True)
        os.environ["MPLBACKEND"] = "Agg"
        for name, check in (("circle", check_circle), ("particles", check_particles)):
            print(name, flush=True)
            check(program, kept / name, kept / f"{name}.png")
        for name, check in (("turned", check_turned), ("free", check_free_space),
                            ("live", check_live)):
            print(name, flush=True)
            check(program, kept / name)


main()
