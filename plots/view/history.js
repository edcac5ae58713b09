// Drag and lift against time, the past strong, with a mark at the frame that is shown.

import { FONT, INK, penOf, told } from "vortree/scale.js";

const GREY = "#999999", LEFT = 46, RIGHT = 12, TOP = 24, BOTTOM = 34;

export class History {
  constructor(canvas, chosen) {
    Object.assign(this, { canvas, pen: penOf(canvas) });
    canvas.addEventListener("pointerdown", (event) => chosen(this.#timeAt(event)));
    canvas.addEventListener("pointermove", (event) => event.buttons && chosen(this.#timeAt(event)));
  }

  #timeAt(event) {
    const frame = this.canvas.getBoundingClientRect();
    const part = (event.clientX - frame.left - LEFT) / (frame.width - LEFT - RIGHT);
    return Math.min(Math.max(part, 0), 1) * this.last;
  }

  /** Where a time and a value stand, in CSS pixels. */
  place(t, value) {
    const { canvas, last, ends: [low, high] } = this;
    return [LEFT + (t / last) * (canvas.clientWidth - LEFT - RIGHT),
            TOP + (1 - (value - low) / (high - low)) * (canvas.clientHeight - TOP - BOTTOM)];
  }

  draw(history, now, ratio) {
    const { canvas, pen } = this, { times, curves, ends } = history;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    Object.assign(this, { last: times.at(-1), ends, now });
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.#axes(width, height, history.label);
    pen.save();
    pen.beginPath();
    pen.rect(LEFT, TOP, width - LEFT - RIGHT, height - TOP - BOTTOM);
    pen.clip();
    for (const curve of curves) {
      this.#line(times, curve, Infinity, 0.35 * curve.alpha, 1);
      this.#line(times, curve, now, curve.alpha, 1.8);
    }
    pen.restore();
    this.#mark(times, curves, now, height);
    this.#legend(curves, width);
  }

  #line(times, curve, until, alpha, width) {
    const { pen } = this;
    this.#look(curve, alpha, width);
    pen.beginPath();
    let begun = false;
    for (let k = 0; k < times.length && times[k] <= until + 1e-9; ++k) {
      if (curve.values[k] === null) begun = false;
      else pen[begun ? "lineTo" : "moveTo"](...this.place(times[k], curve.values[k])), begun = true;
    }
    pen.stroke();
    this.#look({ color: INK, dashes: [] }, 1, 0.8);
  }

  #look({ color, dashes }, alpha, width) {
    Object.assign(this.pen, { strokeStyle: color, fillStyle: color, globalAlpha: alpha,
                              lineWidth: width });
    this.pen.setLineDash(dashes);
  }

  #mark(times, curves, now, height) {
    const { pen } = this, [x] = this.place(now, 0);
    this.#look({ color: GREY, dashes: [] }, 1, 1);
    pen.beginPath();
    pen.moveTo(x, TOP);
    pen.lineTo(x, height - BOTTOM);
    pen.stroke();
    this.marked = curves.map((curve) => [now, valueAt(times, curve.values, now)]);
    for (const [k, curve] of curves.entries()) {
      const [, value] = this.marked[k];
      const [, y] = value === null ? [0, -1] : this.place(now, value);
      if (y < TOP - 1 || y > height - BOTTOM + 1) continue;
      this.#look(curve, 1, 1);
      pen.beginPath();
      pen.arc(x, y, 4, 0, 2 * Math.PI);
      pen.fill();
    }
    this.#look({ color: INK, dashes: [] }, 1, 0.8);
  }

  #axes(width, height, label) {
    const { pen } = this, [low, high] = this.ends, bottom = height - BOTTOM;
    pen.font = `13px ${FONT}`;
    this.#look({ color: INK, dashes: [] }, 1, 0.8);
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    for (const value of ticks(low, high, (height - TOP - BOTTOM) / 24)) {
      const [, y] = this.place(0, value);
      pen.strokeStyle = "#e4e4e4";
      pen.beginPath();
      pen.moveTo(LEFT, y);
      pen.lineTo(width - RIGHT, y);
      pen.stroke();
      pen.fillText(told(value), LEFT - 6, y);
    }
    pen.textAlign = "center";
    pen.textBaseline = "top";
    for (const t of ticks(0, this.last, (width - LEFT - RIGHT) / 70))
      pen.fillText(told(t), this.place(t, 0)[0], bottom + 3);
    pen.textAlign = "right";
    pen.fillText(label, width - RIGHT, bottom + 17);
    pen.strokeStyle = INK;
    pen.beginPath();
    pen.moveTo(LEFT, TOP);
    pen.lineTo(LEFT, bottom);
    pen.lineTo(width - RIGHT, bottom);
    pen.stroke();
  }

  /** In a row, smaller if there is little room. */
  #legend(curves, width) {
    const { pen } = this, wide = (curve) => 40 + pen.measureText(curve.label).width;
    const part = Math.min(1, (width - LEFT) / curves.reduce((sum, curve) => sum + wide(curve), 0));
    let x = LEFT + 4;
    pen.font = `${13 * part}px ${FONT}`;
    pen.textAlign = "left";
    pen.textBaseline = "middle";
    for (const curve of curves) {
      this.#look(curve, curve.alpha, 1.8);
      pen.beginPath();
      pen.moveTo(x, 11);
      pen.lineTo(x + 22 * part, 11);
      pen.stroke();
      this.#look({ color: INK, dashes: [] }, 1, 0.8);
      pen.fillText(curve.label, x + 27 * part, 11);
      x += 40 * part + pen.measureText(curve.label).width;
    }
  }
}

/** Between the rows of a table; null outside of it. */
export function valueAt(times, values, t) {
  const k = times.findIndex((time) => time >= t - 1e-9);
  if (k < 0) return null;
  if (k === 0) return Math.abs(times[0] - t) < 1e-9 ? values[0] : null;
  if (values[k] === null || values[k - 1] === null) return values[k];
  const part = Math.min((t - times[k - 1]) / (times[k] - times[k - 1]), 1);
  return values[k - 1] + part * (values[k] - values[k - 1]);
}

/** Round numbers, so many at most. */
function ticks(low, high, most) {
  const wish = (high - low) / Math.max(most, 2), power = 10 ** Math.floor(Math.log10(wish));
  const step = power * [1, 2, 5, 10].find((f) => f * power >= wish * (1 - 1e-9)), all = [];
  for (let k = Math.ceil(low / step); k * step <= high + 1e-9 * step; ++k)
    all.push(Number((k * step).toPrecision(12)));
  return all;
}
