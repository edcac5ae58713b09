// The page: its state, when it is drawn, and what a test may ask of it (window.vortree).

import { Blobs, REACH } from "vortree/blobs.js";
import { Camera, listen } from "vortree/camera.js";
import { controls, tell } from "vortree/controls.js";
import { Data, NotYet } from "vortree/data.js";
import { colourTexture, contextOf } from "vortree/gl.js";
import { History } from "vortree/history.js";
import { aboutPicked, Plane } from "vortree/plane.js";
import { nearest, Particles, VALUES } from "vortree/particles.js";
import { drawBar, Scale } from "vortree/scale.js";

const SETTLED = 160;  // milliseconds without a change, after which the flow is drawn finely
const LOOK = 2000;  // milliseconds between two looks at a run that goes on
const PICK = 14;  // pixels
const by = (id) => document.getElementById(id);

class Page {
  state = { k: 0, playing: false, log: false, gain: 1, cells: false, picked: -1, what: "",
            colours: "" };
  frame = null;  // the one that is drawn
  drawn = 0;  // pictures, since the page was opened
  #asked = 0;
  #changed = 0;
  #due = false;
  #filled = "";
  #barred = "";

  constructor(data) {
    this.data = data;
    this.gl = contextOf(by("field"));
    this.blobs = data.run.particle === "blob" ? new Blobs(this.gl) : null;
    this.particles = new Particles(this.gl);
    this.camera = new Camera(by("plane"), () => this.redraw());
    this.plane = new Plane(by("plane"), this.camera);
    this.history = new History(by("history"), (t) => this.goTo(this.#nearestTo(t)));
    this.textures = {};
    for (const [name, { bytes }] of Object.entries(data.run.colours)) {
      const all = Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0));
      this.textures[name] = { bytes: all, texture: colourTexture(this.gl, all) };
    }
    listen(this.camera, (x, y) => this.#pick(x, y));
    this.state.what = Object.keys(data.run.shown)[0];
    controls(this);
    new ResizeObserver(() => this.camera.refit()).observe(by("flow"));
    this.camera.fit(data.run.window);
    this.#fitColours();
  }

  get ratio() { return Math.min(window.devicePixelRatio || 1, 2); }

  get scale() {
    const { what, colours, log, gain } = this.state, shown = this.data.run.shown[what];
    const [low, high] = shown.plain ? shown.ends : shown.ends.map((end) => end * gain);
    return new Scale(low, high, shown.signs, this.textures[colours].bytes, log && !shown.plain);
  }

  get time() {
    const { frames, letters, digits } = this.data.run, about = frames[this.state.k];
    return about ? `${letters.time} = ${about.time.toFixed(digits)}` : "";
  }

  set(changes) {
    const begins = changes.playing && !this.state.playing;
    Object.assign(this.state, changes);
    this.#fitColours();
    if (begins) this.#play();
    this.redraw();
  }

  #fitColours() {
    const { colours, shown } = this.data.run, { state } = this;
    if (colours[state.colours]?.signs === shown[state.what].signs) return;
    state.colours = Object.keys(colours).find((n) => colours[n].signs === shown[state.what].signs);
  }

  step(by_) { return this.goTo(this.state.k + by_); }

  /** Resolved when the frame is drawn. */
  async goTo(k) {
    const last = this.data.run.frames.length - 1;
    k = Math.max(Math.min(k, last), 0);
    if (k !== this.state.k) Object.assign(this.state, { k, picked: -1 });
    await this.#show();
  }

  async #show() {
    const { k } = this.state, ask = ++this.#asked;
    if (!this.data.run.frames.length) return this.redraw();
    const frame = await this.data.frame(k);
    if (ask !== this.#asked) return;
    if (frame !== this.frame) this.#filled = "";
    this.frame = frame;
    this.redraw();
    for (const ahead of [k + 1, k + 2]) if (this.data.run.frames[ahead]) this.data.frame(ahead);
    await new Promise((done) => requestAnimationFrame(done));  // after the one that draws
  }

  #nearestTo(t) {
    const away = this.data.run.frames.map((frame) => Math.abs(frame.time - t));
    return away.indexOf(Math.min(...away));
  }

  #pick(px, py) {
    if (!this.frame) return;
    const within = PICK * this.camera.unit;
    this.set({ picked: nearest(this.frame, ...this.camera.toPlane(px, py), within) });
  }

  pickMiddle() {
    const { frame, camera } = this;
    if (frame) this.set({ picked: nearest(frame, camera.x, camera.y, Infinity) });
  }

  async #play() {
    const { frames, rate } = this.data.run;
    if (this.state.k === frames.length - 1) await this.goTo(0);
    let due = performance.now();
    while (this.state.playing) {
      due = Math.max(due + 1000 / rate, performance.now());
      await new Promise((done) => setTimeout(done, due - performance.now()));
      if (!this.state.playing) return;
      if (this.state.k === this.data.run.frames.length - 1) return this.set({ playing: false });
      await this.step(1);
    }
  }

  redraw() {
    this.#changed = performance.now();
    if (this.#due) return;
    this.#due = true;
    requestAnimationFrame(() => {
      this.#due = false;
      this.draw(REACH.quick, this.state.playing ? 2 : 1.5);
      this.#settle();
    });
  }

  #settle() {
    clearTimeout(this.settling);
    this.settling = setTimeout(() => {
      if (!this.#due && !this.state.playing) requestAnimationFrame(() => this.draw());
    }, SETTLED);
  }

  /** coarse: pixels of the screen for one of the sum, each way. */
  draw(reach = REACH.fine, coarse = 1) {
    const { state, frame, ratio, data: { run } } = this;
    const canvas = by("field"), fine = state.what === "sum" ? ratio / coarse : ratio;
    const width = Math.max(1, Math.round(canvas.clientWidth * fine));
    const height = Math.max(1, Math.round(canvas.clientHeight * fine));
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const { scale, camera } = this, { texture } = this.textures[state.colours];
    if (frame && state.what === "sum") {
      this.#fill("sum", () => this.blobs.fill(frame));
      this.blobs.add(camera, width, height, reach);
      this.blobs.paint(scale, texture);
    } else if (frame) {
      this.#fill(state.what, () => this.particles.fill(frame, VALUES[state.what](frame, run)));
      this.particles.paint(camera, scale, texture);
    } else {
      this.gl.clearColor(1, 1, 1, 1);
      this.gl.clear(this.gl.COLOR_BUFFER_BIT);
    }
    const { cells, picked } = state;
    this.plane.draw({ run, frame, cells, picked, time: this.time }, ratio);
    this.#bar(scale, run.shown[state.what].label);
    by("history").hidden = !run.history;
    if (run.history) this.history.draw(run.history, run.frames[state.k]?.time ?? 0, ratio);
    by("picked").hidden = state.picked < 0 || !frame;
    if (!by("picked").hidden)
      by("picked").textContent = aboutPicked(run, frame, state.picked).join("\n");
    tell(this);
    ++this.drawn;
  }

  /** Only when it is another. */
  #bar(scale, label) {
    const { clientWidth, clientHeight } = by("bar"), { low, high, faint } = scale;
    const what = [clientWidth, clientHeight, this.ratio, low, high, faint, label,
                  this.state.colours].join();
    if (what === this.#barred) return;
    this.#barred = what;
    drawBar(by("bar"), scale, label, this.ratio);
  }

  #fill(what, fill) {
    if (this.#filled !== what) fill();
    this.#filled = what;
  }

  say(words) {
    by("said").hidden = !words;
    by("said").textContent = words;
  }

  /** Of a run that goes on: what has come since, the last frame if that was shown. */
  async follow() {
    for (;;) {
      await new Promise((done) => setTimeout(done, LOOK));
      try {
        const { k } = this.state, atEnd = k >= this.data.run.frames.length - 1;
        const { origin } = this.data.run, wasEmpty = !this.frame;
        if (await this.data.look()) {
          if (origin !== this.data.run.origin) return location.reload();
          if (wasEmpty) this.camera.refit(this.camera.box = this.data.run.window);
          await this.goTo(atEnd ? Infinity : k);
          this.redraw();
        }
        this.say("");
      } catch (error) {
        this.say("the program that serves this page does not answer");
      }
    }
  }
}

/** What tests ask. Places are those of the plane, as on the axes. */
function forTests(page) {
  return {
    page,
    get frame() { return page.state.k; },
    get count() { return page.data.run.frames.length; },
    get time() { return page.data.run.frames[page.state.k].time; },
    get bits() { return page.blobs?.bits ?? 23; },
    get drawn() { return page.drawn; },
    goTo: (k) => page.goTo(k),
    async zoomTo(box) {
      page.camera.fit(box);
      await new Promise((done) => setTimeout(done, 2 * SETTLED));
      page.draw();
    },
    /** [x, y, sum] at the middles of the pixels in which some places lie. */
    sums(places) {
      page.draw();
      const all = page.blobs.sums(), { width, height } = page.blobs, { camera } = page;
      return places.map(([x, y]) => {
        const pixel = camera.width / width;
        const i = Math.floor((x - camera.x) / pixel + width / 2);
        const j = Math.floor((y - camera.y) / pixel + height / 2);
        return [camera.x + (i + 0.5 - width / 2) * pixel, camera.y + (j + 0.5 - height / 2) * pixel,
                all[j * width + i]];
      });
    },
    /** Time and value at which the first curve of the history is marked. */
    mark: () => page.history.marked[0],
    colourOf: (value) => page.scale.colour(value),
    toPixel: (x, y) => {
      const frame = by("plane").getBoundingClientRect(), [px, py] = page.camera.toPixel(x, y);
      return [frame.left + px, frame.top + py];
    },
    /** Pictures a second, as when it plays: a number of frames drawn one after another. */
    async rate(pictures, fine = false) {
      const frames = [];
      for (let k = 0; k < Math.min(page.data.run.frames.length, 8); ++k)
        frames.push(await page.data.frame(page.data.run.frames.length - 1 - k));
      const begin = performance.now();
      for (let k = 0; k < pictures; ++k) {
        page.frame = frames[k % frames.length];
        page.blobs?.fill(page.frame);
        fine ? page.draw() : page.draw(REACH.quick, 2);
        page.gl.readPixels(0, 0, 1, 1, page.gl.RGBA, page.gl.UNSIGNED_BYTE, new Uint8Array(4));
      }
      return (1000 * pictures) / (performance.now() - begin);
    },
  };
}

async function begin() {
  try {
    const page = new Page(await Data.open());
    window.vortree = forTests(page);
    await page.goTo(Infinity);  // an impulsive start shows little
    if (page.data.live) page.follow();
    return true;
  } catch (error) {
    by("said").hidden = false;
    by("said").textContent = error.message;
    if (error instanceof NotYet) return setTimeout(() => location.reload(), LOOK);
    throw error;
  }
}

window.vortreeReady = begin();
