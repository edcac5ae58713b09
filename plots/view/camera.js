// What of the plane is seen, and how wheel, fingers and mouse move it.

const NEAREST = 1e-5, FARTHEST = 1e5;  // plane units across

export class Camera {
  x = 0;
  y = 0;
  unit = 1;  // of the plane a CSS pixel wide

  constructor(element, changed) {
    Object.assign(this, { element, changed });
    this.box = [-1, 1, -1, 1];
  }

  get width() { return this.element.clientWidth * this.unit; }
  get height() { return this.element.clientHeight * this.unit; }

  /** So that a box x0, x1, y0, y1 is just seen. */
  fit(box) {
    const [x0, x1, y0, y1] = this.box = box;
    this.x = (x0 + x1) / 2;
    this.y = (y0 + y1) / 2;
    this.unit = Math.max((x1 - x0) / this.element.clientWidth,
                         (y1 - y0) / this.element.clientHeight);
    this.untouched = true;
    this.changed();
  }

  /** The box again, unless someone has moved what is seen. */
  refit() { this.untouched ? this.fit(this.box) : this.changed(); }

  toPlane(px, py) {
    return [this.x + (px - this.element.clientWidth / 2) * this.unit,
            this.y - (py - this.element.clientHeight / 2) * this.unit];
  }

  toPixel(x, y) {
    return [(x - this.x) / this.unit + this.element.clientWidth / 2,
            (this.y - y) / this.unit + this.element.clientHeight / 2];
  }

  /** About a pixel, which stays where it is. */
  zoom(factor, px = this.element.clientWidth / 2, py = this.element.clientHeight / 2) {
    const [x, y] = this.toPlane(px, py), across = this.element.clientWidth;
    this.unit = Math.min(Math.max(this.unit / factor, NEAREST / across), FARTHEST / across);
    const [newX, newY] = this.toPlane(px, py);
    this.pan((x - newX) / this.unit, (newY - y) / this.unit);
  }

  /** By pixels, of what is seen to the right and down. */
  pan(px, py) {
    this.x += px * this.unit;
    this.y -= py * this.unit;
    this.untouched = false;
    this.changed();
  }
}

/** Wheel and fingers zoom, dragging moves; picked(px, py) where someone has only touched. */
export function listen(camera, picked) {
  const { element } = camera, down = new Map();
  let moved = 0;
  const at = (event) => {
    const frame = element.getBoundingClientRect();
    return [event.clientX - frame.left, event.clientY - frame.top];
  };
  const middle = () => {
    const all = [...down.values()], n = all.length;
    return [all.reduce((s, p) => s + p[0], 0) / n, all.reduce((s, p) => s + p[1], 0) / n];
  };
  const apart = () => {
    const [a, b] = [...down.values()];
    return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  };
  element.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode ? 20 : 1;
    camera.zoom(Math.exp(-0.0015 * lines * event.deltaY), ...at(event));
  }, { passive: false });
  element.addEventListener("pointerdown", (event) => {
    if (event.button > 0) return;
    element.setPointerCapture(event.pointerId);
    if (!down.size) moved = 0;
    down.set(event.pointerId, at(event));
  });
  element.addEventListener("pointermove", (event) => {
    if (!down.has(event.pointerId)) return;
    const [x, y] = middle(), wide = apart();
    down.set(event.pointerId, at(event));
    const [newX, newY] = middle();
    moved += Math.hypot(newX - x, newY - y) + Math.abs(apart() - wide);
    if (moved < 4) return;
    camera.pan(x - newX, y - newY);
    if (wide && apart()) camera.zoom(apart() / wide, newX, newY);
  });
  const up = (event) => {
    const place = down.get(event.pointerId);
    down.delete(event.pointerId);
    if (place && event.type === "pointerup" && moved < 4 && !down.size) picked(...place);
  };
  element.addEventListener("pointerup", up);
  element.addEventListener("pointercancel", up);
  element.addEventListener("dblclick", (event) => camera.zoom(2, ...at(event)));
}
