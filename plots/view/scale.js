// The scale of colours: from values to places in a row of colours, and its bar; numbers and lines
// of one look.

export const INK = "#222222", FONT = "STIX Two Text, STIXGeneral, Times New Roman, serif";

/** Draws by the processor: few lines, which cost less so where there is no graphics card. */
export const penOf = (canvas) => canvas.getContext("2d", { willReadFrequently: true });

/** low, high: its ends; signs: whether each sign has a half of the colours; faint: where a
 * logarithmic scale becomes straight, 0 for a linear one. */
export class Scale {
  constructor(low, high, signs, colours, logarithmic) {
    const faint = logarithmic ? Math.max(-low, high) / 100 : 0;
    Object.assign(this, { low, high, signs, colours, faint });
  }

  /** 0 to 1. */
  place(value) {
    const { low, high, signs } = this;
    if (!signs) return Math.min(this.#grown(Math.max(value - low, 0), high - low), 1);
    const part = Math.min(this.#grown(Math.abs(value), value < 0 ? -low : high), 1);
    return 0.5 + 0.5 * Math.sign(value) * part;
  }

  #grown(value, end) {
    return this.faint ? Math.log1p(value / this.faint) / Math.log1p(end / this.faint) : value / end;
  }

  /** Red, green, blue, 0 to 255. */
  colour(value) {
    const at = this.place(value) * 255, k = Math.min(Math.floor(at), 254), part = at - k;
    return [0, 1, 2].map((c) => (1 - part) * this.colours[3 * k + c] +
                                part * this.colours[3 * k + 3 + c]);
  }

  /** To the shaders: see gl.js. */
  give(gl, places) {
    gl.uniform1f(places.low, this.low);
    gl.uniform1f(places.high, this.high);
    gl.uniform1f(places.faint, this.faint);
    gl.uniform1i(places.signs, this.signs ? 1 : 0);
  }

  ticks() {
    const { low, high, signs, faint } = this, parts = faint ? [1, 0.1, 0.01] : [1, 0.5];
    if (signs) return [...parts.map((p) => p * low), 0, ...parts.map((p) => p * high)];
    if (faint) return [0, ...parts.map((p) => p * high)];
    if (low === 0) return [0, 0.25, 0.5, 0.75, 1].map((p) => p * high);
    const step = high - low > 6 ? 2 : high - low > 3 ? 1 : 0.5, all = [];
    for (let v = Math.ceil(low / step) * step; v <= high; v += step) all.push(v);
    return all;
  }
}

export function told(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e5 || size < 1e-3 ? value.toExponential(2) : Number(value.toPrecision(4));
  return `${text}`.replace("-", "\u2212");
}

/** Draws the bar, upright, with its words below. */
export function drawBar(canvas, scale, words, ratio) {
  const width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const pen = penOf(canvas), top = 10, bottom = height - 10, left = 22, wide = 14;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  for (let y = top; y < bottom; ++y) {
    const k = Math.round((1 - (y + 0.5 - top) / (bottom - top)) * 255);
    pen.fillStyle = `rgb(${scale.colours.slice(3 * k, 3 * k + 3).join()})`;
    pen.fillRect(left, y, wide, 1.5);
  }
  pen.strokeStyle = pen.fillStyle = INK;
  pen.lineWidth = 0.7;
  pen.strokeRect(left, top, wide, bottom - top);
  pen.font = `12px ${FONT}`;
  pen.textBaseline = "middle";
  for (const value of scale.ticks()) {
    const y = bottom - scale.place(value) * (bottom - top);
    pen.beginPath();
    pen.moveTo(left + wide, y);
    pen.lineTo(left + wide + 4, y);
    pen.stroke();
    pen.fillText(told(value), left + wide + 7, y);
  }
  pen.translate(10, height / 2);
  pen.rotate(-Math.PI / 2);
  pen.textAlign = "center";
  pen.font = `13px ${FONT}`;
  pen.fillText(words, 0, 0, height - 8);
}
