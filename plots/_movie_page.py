"""The page of a movie: the flow, the drag below or beside it. What never changes is drawn once."""

from itertools import cycle

import numpy as np
from _outline import outline, walls
from _style import EACH, GREY, ORANGE, Broken, Nothing, figure
from _vorticity import scale_bar
from matplotlib.path import Path

HEIGHT = 6.0  # inches, in which letters have their sizes
LEFT, BAR, TOP, BOTTOM = 0.65, 1.05, 0.45, 0.5  # around the flow, in inches
STRIP, GAP, BESIDE = 1.2, 0.55, 3.6  # the drag: its height below, what divides it, its width beside
WIDEST = HEIGHT * 16 / 9
FLAT = 1.1  # width to height from which on the drag stands below


class Page:
    def __init__(self, shown, pixels, with_streamlines):
        self.shown, self.run = shown, shown.run
        self.history = history_of(self.run) if shown.units.body else None
        x0, x1, y0, y1 = shown.window
        width, flow, below = layout((x1 - x0) / (y1 - y0), self.history is not None)
        self.figure = fig = figure(width, HEIGHT)
        fig.set_layout_engine("none")
        fig.set_dpi(pixels / HEIGHT)
        sides = even(width * fig.dpi), pixels  # the canvas rounds down
        fig.set_size_inches(*((side + 0.01) / fig.dpi for side in sides))
        self.axes = axes = place(fig, flow)
        axes.set(xlim=(x0, x1), ylim=(y0, y1))
        units = "/R" if shown.units.body else ""
        axes.set_xlabel(f"$x{units}$", labelpad=1)
        axes.set_ylabel(f"$y{units}$", labelpad=1)
        axes.grid(False)
        self.moving = [(axes, shown.add(axes))]
        self._scale(flow, width)
        self.lines = shown.streamlines(axes) if with_streamlines else None
        if self.lines:
            self.moving.append((axes, self.lines.lines))
        self._body()
        self._time()
        if self.history:
            self._history(below)
        self._title(width)
        fig.canvas.draw()
        self.still = fig.canvas.copy_from_bbox(fig.bbox)

    @property
    def size(self):
        return self.figure.canvas.get_width_height()

    def _scale(self, flow, width):
        left, bottom, across, up = flow
        bar = place(self.figure, (left + across + 0.15, bottom + 0.1 * up, 0.16, 0.8 * up))
        picture = self.moving[0][1]
        ends = {(True, False): "min", (False, True): "max"}
        beyond = ends.get((picture.norm.vmin != 0, picture.norm.vmax != 0), "both")
        scale_bar(self.figure, picture, self.shown.label, beyond, cax=bar)
        bar.grid(False)

    def _body(self):
        self.body = None
        if self.shown.units.body:
            self.body = self.axes.add_patch(outline(self.run, self.shown.times[0]))
            self.body.set_animated(True)
            self.moving.append((self.axes, self.body))

    def _time(self):
        times = [self.shown.units.time(t) for t in self.shown.times]
        apart = (times[-1] - times[0]) / (len(times) - 1)
        self.digits = int(np.clip(np.ceil(-np.log10(apart)), 0, 4))
        self.time = self.axes.text(
            0.015, 0.97, "", transform=self.axes.transAxes, va="top", fontsize=13, animated=True,
            zorder=5, bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 3})
        self.moving.append((self.axes, self.time))
        for spine in self.axes.spines.values():  # above the picture
            spine.set_animated(True)
            self.moving.append((self.axes, spine))

    def _history(self, below):
        axes = place(self.figure, below)
        T, curves = self.history
        axes.set(xlim=(0, T[-1]), ylim=limits(T, curves))
        axes.set_xlabel("time  $T = Ut/R$", labelpad=1)
        axes.locator_params(axis="y", nbins=5)
        self.now = axes.axvline(0, color=GREY, lw=0.8, animated=True)
        self.moving.append((axes, self.now))
        self.drawn = []
        for label, values, look in curves:
            axes.plot(T, values, lw=0.8, **{**look, "alpha": 0.35})
            line, = axes.plot([], [], lw=1.6, label=label, animated=True, **look)
            dot, = axes.plot([], [], "o", ms=4.5, color=look["color"], animated=True)
            self.drawn.append((values, line, dot))
            self.moving += [(axes, line), (axes, dot)]
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.08), borderaxespad=0, handlelength=1.3,
                    handletextpad=0.5, labelspacing=0.25, fontsize=10)

    def _title(self, width):
        text = self.figure.text(0.5, 1 - 0.24 / HEIGHT, self.run.scene.get("title", ""),
                                ha="center", va="center", fontsize=12)
        wide = text.get_window_extent().width / self.figure.dpi
        text.set_fontsize(12 * min(1, 0.96 * width / max(wide, 1e-9)))

    def drawn_at(self, k):
        """The k-th picture, as RGBA."""
        field = self.shown.field(k)
        self.shown.show(field)
        if self.lines:
            self.lines.show(field)
        if self.body:
            self._move_body(field["time"])
        T = self.shown.units.time(field["time"])
        self.time.set_text(f"${'T' if self.body else 't'} = {T:.{self.digits}f}$")
        if self.history:
            self._mark(T)
        canvas = self.figure.canvas
        canvas.restore_region(self.still)
        for axes, artist in self.moving:
            axes.draw_artist(artist)
        return canvas.buffer_rgba()

    def _move_body(self, t):
        corners = walls(self.run, t)
        if len(corners) == 1:
            self.body.set_xy(corners[0])
        else:
            self.body.set_path(Path.make_compound_path(*(Path(c, closed=True) for c in corners)))

    def _mark(self, T):
        times = self.history[0]
        past = times <= T + 1e-9
        self.now.set_xdata([T, T])
        for values, line, dot in self.drawn:
            line.set_data(times[past], values[past])
            dot.set_data([T], [np.interp(T, times, values, left=np.nan)])


def place(fig, rectangle):
    """Axes at a rectangle of inches."""
    width, height = fig.get_size_inches()
    left, bottom, across, up = rectangle
    return fig.add_axes((left / width, bottom / height, across / width, up / height))


def even(pixels):
    return 2 * round(pixels / 2)


def layout(aspect, has_history):
    """Width of the page; rectangles of the flow and of the drag, below a flat window, beside a tall
    one; in inches."""
    is_below = has_history and aspect >= FLAT
    beside = BESIDE if has_history and not is_below else 0
    most = HEIGHT - TOP - BOTTOM - (STRIP + GAP if is_below else 0)
    across = min(most * aspect, WIDEST - LEFT - BAR - beside)
    up, width = across / aspect, max(LEFT + across + BAR + beside, 4)
    if is_below:
        strip = HEIGHT - TOP - up - BOTTOM - GAP
        return (width, (LEFT, HEIGHT - TOP - up, across, up),
                (LEFT, BOTTOM, across, min(strip, 2 * STRIP)))
    left = LEFT + (width - LEFT - across - BAR - beside) / 2
    flow = (left, BOTTOM + (most - up) / 2, across, up)
    return width, flow, (left + across + BAR + 0.35, BOTTOM + most / 4, BESIDE - 1.15, most / 2)


def history_of(run):
    """T, and of drag and lift label, values and look of each curve; None if there are none yet."""
    try:
        T = run.report["T"]
        drag, lift = ([run.report[name] for name in run.columns(c)] for c in ("cd", "cl"))
    except (Nothing, Broken):
        return None
    if T.size < 2 or not np.isfinite(drag).any():
        return None
    if run.several:
        return T, [(f"$C_{letter}$ of {k}", values, {**look, "alpha": 1 if letter == "D" else 0.5})
                   for letter, each in (("D", drag), ("L", lift))
                   for k, values, look in zip(run.numbers, each, cycle(EACH))]
    curves = [("drag $C_D$", drag[0], EACH[0])]
    if np.nanmax(np.abs(lift[0])) > 0.01 * np.nanmedian(np.abs(drag[0])):
        curves.append(("lift $C_L$", lift[0], {"color": ORANGE, "ls": "-"}))
    return T, curves


def limits(T, curves):
    """Room for all but the start, when the drag comes down from infinity."""
    late = T >= min(0.3, T[-1] / 10)
    told = np.concatenate([values[late][np.isfinite(values[late])] for _, values, _ in curves])
    low, high = min(0, told.min()), max(0, told.max())
    pad = 0.08 * (high - low) or 1
    return low - (pad if low < 0 else 0), high + pad
