// Particles, or blobs, as discs in the colours of a value of theirs; which is nearest to a place.

import { ofDisc, placeInColours, programOf, Discs } from "vortree/gl.js";

const LEAST = 1.5;  // pixels of a disc's diameter

const vertex = `
uniform vec2 centre, scale;
uniform float least;
uniform sampler2D colours;
out vec2 from;
flat out vec3 colour;
flat out float soft;
${placeInColours}
${ofDisc}
void main() {
  vec4 disc = numbers();  // x, y, width, value
  float r = 0.5 * max(disc.z, least);
  from = corner();
  soft = 0.5 * least / ${LEAST.toFixed(1)} / r;
  colour = texture(colours, vec2(texel(place(disc.w)), 0.5)).rgb;
  gl_Position = vec4((disc.xy - centre + r * from) * scale, 0, 1);
}`;

const fragment = `
in vec2 from;
flat in vec3 colour;
flat in float soft;
out vec4 shown;
void main() {
  float part = smoothstep(1. + soft, 1. - soft, length(from));
  if (part == 0.) discard;
  shown = vec4(colour, part);
}`;

/** What can be shown of each particle, from the columns of its frame. */
export const VALUES = {
  vorticity: (f) => f.vorticity ?? Float32Array.from(f.gamma, (g, k) =>
    g * (f.two[k] ? 2 : 1) / (Math.PI * f.sigma[k] ** 2)),
  level: (f, run) => Float32Array.from(f.spacing, (s) => Math.log2(s / run.ends.finest)),
  pressure: (f) => f.pressure,
  speed: (f) => Float32Array.from(f.u, (u, k) => Math.hypot(u, f.v[k])),
};

export class Particles {
  constructor(gl) {
    this.gl = gl;
    this.drawing = programOf(gl, vertex, fragment);
    this.discs = new Discs(gl);
  }

  fill(frame, values) {
    this.discs.fill([frame.x, frame.y, frame.spacing ?? frame.sigma, values]);
  }

  paint(view, scale, colours) {
    const { gl } = this, { program, places } = this.drawing;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, colours);
    gl.uniform1i(places.colours, 1);
    gl.uniform2f(places.centre, view.x, view.y);
    gl.uniform2f(places.scale, 2 / view.width, 2 / view.height);
    gl.uniform1f(places.least, (LEAST * view.width) / gl.drawingBufferWidth);
    scale.give(gl, places);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE);
    this.discs.draw(places.table);
    gl.disable(gl.BLEND);
  }
}

/** The number of the particle nearest to a place, or -1 if none is within so far. */
export function nearest(frame, x, y, within) {
  let found = -1, least = within * within;
  for (let k = 0; k < frame.x.length; ++k) {
    const square = (frame.x[k] - x) ** 2 + (frame.y[k] - y) ** 2;
    if (square <= least) [found, least] = [k, square];
  }
  return found;
}
