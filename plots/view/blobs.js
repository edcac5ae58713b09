// The vorticity of blobs: Gaussians added up in a texture of floats, which then gets its colours.
//
//   omega(x) = sum_j gamma_j / (pi sigma_j^2) exp(-|x - x_j|^2 / sigma_j^2)

import { ofDisc, placeInColours, plainTexture, programOf, Discs } from "vortree/gl.js";

/** Radius within which a blob is drawn, in sigmas: exp(-reach^2) of its peak is left out. */
export const REACH = { fine: 3.7, quick: 3 };  // 1e-6, 1e-4
const LEAST = 0.7;  // pixels of a sigma: a narrower blob is drawn as wide, with all its circulation

const vertex = `
uniform vec2 centre, size;  // of what is seen, and of the sums in pixels
uniform float pixel, reach;
flat out vec4 core;  // place and 1/sigma in pixels; peak
${ofDisc}
void main() {
  vec4 blob = numbers();  // x, y, gamma, sigma
  float s = max(blob.w / pixel, ${LEAST.toFixed(2)}), wide = s * pixel;
  vec2 at = (blob.xy - centre) / pixel;
  core = vec4(at + 0.5 * size, 1. / s, blob.z / (3.14159265358979 * wide * wide));
  gl_Position = vec4((at + reach * s * corner()) / (0.5 * size), 0, 1);
}`;

// By the pixel's own place: what is interpolated between corners is off by a part of a pixel.
const fragment = `
flat in vec4 core;
out vec4 omega;
void main() {
  vec2 q = (gl_FragCoord.xy - core.xy) * core.z;
  omega = vec4(core.w * exp(-dot(q, q)), 0, 0, 1);
}`;

const everywhere = `
void main() { gl_Position = vec4(4. * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1., 0, 1); }`;

const inColours = `
uniform sampler2D sum, colours;
out vec4 colour;
${placeInColours}
void main() {
  float value = texelFetch(sum, ivec2(gl_FragCoord.xy), 0).r;
  colour = vec4(texture(colours, vec2(texel(place(value)), 0.5)).rgb, 1);
}`;

export class Blobs {
  constructor(gl) {
    this.gl = gl;
    if (!gl.getExtension("EXT_color_buffer_float"))
      throw new Error("this browser cannot draw into floats, by which vorticity is added up");
    /** Bits that a sum keeps behind the first. */
    this.bits = gl.getExtension("EXT_float_blend") ? 23 : 10;
    this.adding = programOf(gl, vertex, fragment);
    this.colouring = programOf(gl, everywhere, inColours);
    this.discs = new Discs(gl);
    this.texture = plainTexture(gl);
    this.target = gl.createFramebuffer();
    this.width = this.height = 0;
  }

  /** Of a frame: each blob is one Gaussian, or two of one gamma and sigma. */
  fill(frame) {
    const { x, y, gamma, sigma, owner, x2, y2 } = frame;
    const both = (first, second) => {
      const all = new Float32Array(first.length + owner.length);
      all.set(first);
      all.set(second, first.length);
      return all;
    };
    const again = (values) => Float32Array.from(owner, (k) => values[k]);
    this.discs.fill([both(x, x2), both(y, y2), both(gamma, again(gamma)),
                       both(sigma, again(sigma))]);
  }

  #resize(width, height) {
    if (width === this.width && height === this.height) return;
    const { gl } = this;
    Object.assign(this, { width, height });
    const [inside, kind] = this.bits === 23 ? [gl.R32F, gl.FLOAT] : [gl.R16F, gl.HALF_FLOAT];
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, inside, width, height, 0, gl.RED, kind, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.texture, 0);
  }

  /** view: centre x, y and width of what is seen, in pixels that are square. */
  add(view, width, height, reach) {
    const { gl } = this, { program, places } = this.adding;
    this.#resize(width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.useProgram(program);
    gl.uniform2f(places.centre, view.x, view.y);
    gl.uniform2f(places.size, width, height);
    gl.uniform1f(places.pixel, view.width / width);
    gl.uniform1f(places.reach, reach);
    gl.enable(gl.BLEND);
    gl.blendEquation(gl.FUNC_ADD);
    gl.blendFunc(gl.ONE, gl.ONE);
    this.discs.draw(places.table);
    gl.disable(gl.BLEND);
  }

  /** Onto the canvas, which is as large. */
  paint(scale, colours) {
    const { gl } = this, { program, places } = this.colouring;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, colours);
    gl.activeTexture(gl.TEXTURE0);
    gl.uniform1i(places.sum, 0);
    gl.uniform1i(places.colours, 1);
    scale.give(gl, places);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** The sums, row by row from below. */
  sums() {
    const { gl, width, height } = this, all = new Float32Array(width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.readPixels(0, 0, width, height, gl.RED, gl.FLOAT, all);
    return all;
  }
}
