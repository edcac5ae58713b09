"""The page that shows a run: what it has to know, and its parts joined into one file."""

import base64
import html
import json
from pathlib import Path

import matplotlib
import numpy as np
from _colours import COLOURS, UPPER
from _movie_page import history_of, limits

PARTS = Path(__file__).resolve().parent / "view"
ROWS = 4000  # of a history, at most
TWO_SIGNS = {"blue\u2013red": COLOURS, "purple\u2013orange": matplotlib.colormaps["PuOr_r"]}
ONE_SIGN = {"white\u2013red": UPPER, "viridis": matplotlib.colormaps["viridis"],
            "cividis": matplotlib.colormaps["cividis"]}
GRADED = {name: ONE_SIGN[name] for name in ("viridis", "cividis", "white\u2013red")}

# What a page may load: nothing; where it is served, what comes from there.
ALONE = ("default-src 'none'; script-src 'unsafe-inline' data:; style-src 'unsafe-inline'; "
         "img-src data:")
SERVED = ("default-src 'none'; script-src 'self' 'unsafe-inline'; style-src 'self'; img-src data:; "
          "connect-src 'self'")


def coded(data):
    return base64.b64encode(data).decode()


def modules():
    return sorted(PARTS.glob("*.js"))


def inside(value):
    """JSON that ends no script."""
    text = json.dumps(value, separators=(",", ":"), allow_nan=False, default=float)
    return text.replace("<", "\\u003c")


def page(title, policy, head):
    text = (PARTS / "index.html").read_text()
    for name, value in (("policy", policy), ("title", html.escape(title)), ("head", head)):
        text = text.replace("{{" + name + "}}", value)
    return text


def imported(place_of):
    """Names by which modules import each other, and the first of them."""
    places = {f"vortree/{one.name}": place_of(one) for one in modules()}
    return (f'<script type="importmap">{inside({"imports": places})}</script>\n'
            '<script type="module">import "vortree/main.js";</script>')


def in_one_file(run, packs):
    """Pieces of a page that needs nothing but itself. packs: the bytes of each frame."""
    def as_data(one):
        return "data:text/javascript;base64," + coded(one.read_bytes())

    head = f"<style>\n{(PARTS / 'style.css').read_text()}</style>\n" + imported(as_data)
    before, after = page(run["title"], ALONE, head).split("</body>")
    yield before
    yield f'<script type="application/json" id="run">{inside(run)}</script>\n'
    for k, pack in enumerate(packs):
        yield f'<script type="text/plain" id="frame-{k}">{coded(pack)}</script>\n'
    yield "</body>" + after


def served(title):
    head = '<link rel="stylesheet" href="view/style.css">\n'
    return page(title, SERVED, head + imported(lambda one: f"./view/{one.name}"))


def about(frames):
    """All that a page knows of a run but its frames."""
    body, run = frames.units.body, frames.run
    ends = frames.ends() if len(frames) else {}
    shown = shown_of(frames, ends)
    apart = np.diff([frames.units.time(t) for t in frames.times])
    digits = int(np.clip(np.ceil(-np.log10(apart.min() + 1e-12)), 0, 4)) if apart.size else 2
    return {
        "title": title_of(run),
        "particle": run.particle, "letters": letters(body), "digits": digits,
        "columns": frames.columns, "shown": shown, "ends": {"finest": ends.get("finest", 1.0)},
        "colours": colours_of(frames.particles),
        "outlines": [one.tolist() for one in frames.outlines()],
        "cells": not frames.particles, "most": frames.most,
        "window": frames.window() if len(frames) else [-3.0, 5.0, -3.0, 3.0],
        "history": history(run) if body else None,
        "rate": float(np.clip(len(frames) / 8, 4, 30)),
    }


def title_of(run):
    return run.scene.get("title", "") or run.folder.resolve().name


def letters(body):
    """As in figures: in units of the body's radius and the stream, or of the scene."""
    def of(letter, unit):
        return letter + unit if body else letter
    return {"x": of("x", "/R"), "y": of("y", "/R"), "time": "T" if body else "t",
            "gamma": of("\u0393", "/RU"), "sigma": of("\u03c3", "/R"), "spacing": of("s", "/R"),
            "u": of("u", "/U"), "v": of("v", "/U"), "pressure": "2p/U\u00b2" if body else "p",
            "vorticity": of("\u03c9", " R/U")}


def shown_of(frames, ends):
    name = letters(frames.units.body)
    whirl = ends.get("vorticity", [-1.0, 1.0])

    def one(words, label, ends, plain=False):
        return {"words": words, "label": label, "ends": ends, "signs": ends[0] < 0 and not plain,
                "plain": plain}

    vorticity = f"vorticity  {name['vorticity']}"
    if not frames.particles:
        return {"sum": one("vorticity", vorticity, whirl),
                "vorticity": one("blobs", f"of each blob alone  {name['vorticity']}",
                                 ends.get("alone", [-1.0, 1.0]))}
    return {"vorticity": one("vorticity", vorticity, whirl),
            "level": one("level", "spacing  log\u2082(s/s\u2080)",
                         ends.get("level", [-0.5, 1.0]), True),
            "pressure": one("pressure", f"pressure  {name['pressure']}",
                            ends.get("pressure", [-1.0, 1.0])),
            "speed": one("speed", "speed  |u|/U" if frames.units.body else "speed  |u|",
                         ends.get("speed", [0.0, 1.0]))}


def colours_of(graded):
    """Rows of 256 colours by name, for two signs and for one; first of each those of the figures.

    graded: where values of one sign are levels and speeds, not vorticity."""
    def row(colours):
        bytes_of = (255 * colours(np.linspace(0, 1, 256))[:, :3] + 0.5).astype(np.uint8)
        return coded(bytes_of.tobytes())

    return {name: {"bytes": row(colours), "signs": signs}
            for signs, some in ((True, TWO_SIGNS), (False, GRADED if graded else ONE_SIGN))
            for name, colours in some.items()}


def history(run):
    told = history_of(run)
    if not told:
        return None
    T, curves = told
    some = np.unique(np.linspace(0, T.size - 1, min(T.size, ROWS)).round().astype(int))
    return {"times": [float(f"{t:.7g}") for t in T[some]], "label": "time  T = Ut/R",
            "ends": [float(end) for end in limits(T, curves)],
            "curves": [{"label": label.replace("$", ""), "color": look["color"],
                        "alpha": look.get("alpha", 1),
                        "dashes": [] if look["ls"] == "-" else [1.6 * d for d in look["ls"][1]],
                        "values": [float(f"{v:.6g}") if np.isfinite(v) else None
                                   for v in values[some]]}
                       for label, values, look in curves]}
