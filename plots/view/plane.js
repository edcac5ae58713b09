// What is drawn upon the flow: bodies, cells of the quadtree, ticks, the time, what was picked.

import { FONT, INK, penOf, told } from "vortree/scale.js";

const BODY = "#4d4d4d";

export class Plane {
  constructor(canvas, camera) {
    Object.assign(this, { canvas, camera, pen: penOf(canvas) });
  }

  draw({ run, frame, cells, picked, time }, ratio) {
    const { canvas, pen, camera } = this;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    if (frame && cells) this.#cells(frame);
    if (frame) this.#bodies(run, frame);
    if (frame && picked >= 0) this.#mark(frame, picked);
    this.#axis(width, height, run.letters, true);
    this.#axis(width, height, run.letters, false);
    this.#label(time, 10, 10);
  }

  #bodies(run, frame) {
    const { pen, camera } = this;
    pen.fillStyle = BODY;
    pen.strokeStyle = INK;
    pen.lineWidth = 1;
    run.outlines.forEach((corners, k) => {
      const [x, y, turn] = frame.places[k], c = Math.cos(turn), s = Math.sin(turn);
      pen.beginPath();
      for (const [a, b] of corners)
        pen.lineTo(...camera.toPixel(x + c * a - s * b, y + s * a + c * b));
      pen.closePath();
      pen.fill();
      pen.stroke();
    });
  }

  /** In the axes in which the flow is computed, which may be turned. */
  #cells(frame) {
    const { pen, camera } = this, { level, column, row, corner, side } = frame;
    if (!frame.cells) return;
    const turn = frame.turn, c = Math.cos(turn), s = Math.sin(turn);
    const go = (line, x, y) => pen[line](...camera.toPixel(c * x - s * y, s * x + c * y));
    pen.strokeStyle = INK;
    pen.globalAlpha = 0.55;
    pen.lineWidth = 0.6;
    pen.beginPath();
    for (let k = 0; k < level.length; ++k) {
      const wide = side / 2 ** level[k];
      const x = corner[0] + column[k] * wide, y = corner[1] + row[k] * wide;
      go("moveTo", x, y);
      go("lineTo", x + wide, y);
      go("lineTo", x + wide, y + wide);
      go("lineTo", x, y + wide);
      pen.closePath();
    }
    pen.stroke();
    pen.globalAlpha = 1;
  }

  #mark(frame, k) {
    const { pen, camera } = this, [x, y] = camera.toPixel(frame.x[k], frame.y[k]);
    const r = Math.max(6, (frame.sigma ?? frame.spacing)[k] / (frame.sigma ? 1 : 2) / camera.unit);
    for (const [colour, width] of [["#ffffff", 4], [INK, 1.5]]) {
      pen.strokeStyle = colour;
      pen.lineWidth = width;
      pen.beginPath();
      pen.arc(x, y, r, 0, 2 * Math.PI);
      pen.stroke();
    }
  }

  #axis(width, height, letters, across) {
    const { pen, camera } = this, length = across ? width : height;
    const wish = camera.unit * 110, power = 10 ** Math.floor(Math.log10(wish));
    const step = power * [1, 2, 5, 10].find((f) => f * power >= wish);
    const from = across ? camera.x - camera.width / 2 : camera.y - camera.height / 2;
    const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    pen.strokeStyle = INK;
    pen.lineWidth = 0.8;
    for (let k = Math.ceil(from / step); k * step < from + length * camera.unit; ++k) {
      const [px, py] = camera.toPixel(k * step, k * step);
      if (across ? px < 40 || px > width - 40 : py > height - 30 || py < 44) continue;
      pen.beginPath();
      pen.moveTo(...(across ? [px, height] : [0, py]));
      pen.lineTo(...(across ? [px, height - 6] : [6, py]));
      pen.stroke();
      const text = (k * step).toFixed(digits).replace("-", "\u2212");
      across ? this.#haloed(text, px, height - 8, "center", "bottom")
             : this.#haloed(text, 9, py, "left", "middle");
    }
    across ? this.#haloed(letters.x, width - 8, height - 8, "right", "bottom")
           : this.#haloed(letters.y, 9, height - 8, "left", "bottom");
  }

  #haloed(text, x, y, align, baseline) {
    const { pen } = this;
    pen.font = `13px ${FONT}`;
    pen.textAlign = align;
    pen.textBaseline = baseline;
    pen.lineJoin = "round";
    pen.lineWidth = 3;
    pen.strokeStyle = "#ffffff";
    pen.strokeText(text, x, y);
    pen.fillStyle = INK;
    pen.fillText(text, x, y);
    pen.lineWidth = 0.8;
    pen.strokeStyle = INK;
  }

  #label(text, x, y) {
    const { pen } = this;
    pen.font = `17px ${FONT}`;
    pen.textAlign = "left";
    pen.textBaseline = "top";
    pen.fillStyle = "rgba(255, 255, 255, 0.85)";
    pen.fillRect(x - 4, y - 4, pen.measureText(text).width + 8, 25);
    pen.fillStyle = INK;
    pen.fillText(text, x, y);
  }
}

/** Lines on what was picked. */
export function aboutPicked(run, frame, k, values) {
  const { letters } = run, pairs = [[letters.x, frame.x[k]], [letters.y, frame.y[k]]];
  if (frame.gamma) {
    pairs.push([letters.gamma, frame.gamma[k] * (frame.two[k] && !run.outlines.length ? 2 : 1)],
               [letters.sigma, frame.sigma[k]]);
  } else {
    pairs.push([letters.spacing, frame.spacing[k]], [letters.u, frame.u[k]],
               [letters.v, frame.v[k]], [letters.pressure, frame.pressure[k]],
               [letters.vorticity, frame.vorticity[k]]);
  }
  return [`${run.particle} ${k}`, ...pairs.map(([name, value]) => `${name} = ${told(value)}`)];
}
