// The run that a page shows, and its frames: from the page itself, or from the program that serves
// it while the run goes on.

const MOST = 256e6;  // bytes of unpacked frames that are kept

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function bytesOf(text) {
  const coded = atob(text), bytes = new Uint8Array(coded.length);
  for (let k = 0; k < coded.length; ++k) bytes[k] = coded.charCodeAt(k);
  return bytes;
}

/** Whole numbers whose bytes of one rank stand together, the lowest rank first. */
function whole(planes, count, ranks) {
  const all = new Uint32Array(count);
  for (let rank = 0; rank < ranks; ++rank)
    for (let k = 0, at = rank * count; k < count; ++k) all[k] |= planes[at + k] << (8 * rank);
  return all;
}

const RANKS = { place: 3, real: 4, whole: 4, byte: 1 };

/** Columns of numbers: see `packed` in _view_frames.py. */
function unpacked(bytes, about, columns) {
  const frame = { ...about };
  let at = 0;
  for (const [name, kind, of] of columns) {
    const count = about[of], ranks = RANKS[kind];
    const words = whole(bytes.subarray(at, at + ranks * count), count, ranks);
    at += ranks * count;
    const axis = name[0] === "x" ? 0 : 1;
    if (kind === "place")
      frame[name] = Float32Array.from(words, (k) => about.low[axis] + about.step[axis] * k);
    else frame[name] = kind === "real" ? new Float32Array(words.buffer) : words;
  }
  if (frame.owner) {
    frame.two = new Uint8Array(about.many);
    for (const k of frame.owner) frame.two[k] = 1;
  }
  return frame;
}

/** A run that is served cannot be read now. */
export class NotYet extends Error {}

/** run: title, labels, colours, outlines, history, frames (what stands beside their columns). */
export class Data {
  static async open() {
    const data = new Data();
    const inside = document.getElementById("run");
    data.live = !inside;
    data.run = inside ? JSON.parse(inside.textContent) : await data.#asked();
    return data;
  }

  #kept = new Map();

  async #asked() {
    const answer = await fetch("data/run.json", { cache: "no-store" });
    if (!answer.ok) throw new NotYet(await answer.text());
    return answer.json();
  }

  /** Looks again at a run that goes on; whether there is anything new. */
  async look() {
    const run = await this.#asked();
    if (run.origin !== this.run.origin) this.#kept.clear();
    const isNew = run.mark !== this.run.mark;
    this.run = run;
    return isNew;
  }

  async #bytes(k) {
    if (!this.live) return bytesOf(document.getElementById(`frame-${k}`).textContent);
    const answer = await fetch(`data/frame/${this.run.frames[k].name}`, { cache: "no-store" });
    if (!answer.ok) throw new Error(await answer.text());
    return new Uint8Array(await answer.arrayBuffer());
  }

  /** A promise of frame k; the ones used last are kept. */
  frame(k) {
    const about = this.run.frames[k];
    let promise = this.#kept.get(about.name);
    this.#kept.delete(about.name);
    promise ??= this.#bytes(k).then(inflated)
      .then((bytes) => unpacked(bytes, about, this.run.columns));
    promise.catch(() => this.#kept.delete(about.name));
    this.#kept.set(about.name, promise);
    const each = 60 * Math.max(...this.run.frames.map((f) => f.many), 1);
    while (this.#kept.size > Math.max(8, MOST / each))
      this.#kept.delete(this.#kept.keys().next().value);
    return promise;
  }
}
