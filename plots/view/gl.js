// What a WebGL 2 context is asked for: programs, discs, textures.

export function contextOf(canvas) {
  const gl = canvas.getContext("webgl2", { antialias: false, alpha: false });
  if (!gl) throw new Error("this browser has no WebGL 2, with which the flow is drawn");
  return gl;
}

export function programOf(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${text}`);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
      throw new Error(gl.getShaderInfoLog(shader) || "the graphics context is lost");
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error(gl.getProgramInfoLog(program) || "the graphics context is lost");
  const places = {};
  for (let k = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; k >= 0; --k) {
    const { name } = gl.getActiveUniform(program, k);
    places[name] = gl.getUniformLocation(program, name);
  }
  return { program, places };
}

const ACROSS = 1024;  // entries in a row of a table

/** For the vertex shader of Discs: the four numbers of the disc that a vertex belongs to, and where
 * around a disc of radius 1 it stands. */
export const ofDisc = `
uniform sampler2D table;
vec4 numbers() {
  int k = gl_VertexID / 3;
  return texelFetch(table, ivec2(k % ${ACROSS}, k / ${ACROSS}), 0);
}
vec2 corner() {
  int k = gl_VertexID % 3;
  return k == 0 ? vec2(-1.7320509, -1) : k == 1 ? vec2(1.7320509, -1) : vec2(0, 2);
}`;

/** Discs, each within a triangle, all in one call: what draws by software takes one for each
 * instance, were they instances. The numbers of each lie in a texture. */
export class Discs {
  constructor(gl) {
    this.gl = gl;
    this.none = gl.createVertexArray();
    this.table = plainTexture(gl);
    this.count = 0;
  }

  /** Four columns, equally long. */
  fill(columns) {
    const { gl } = this;
    this.count = columns[0].length;
    const rows = Math.max(1, Math.ceil(this.count / ACROSS));
    const all = new Float32Array(4 * ACROSS * rows);
    columns.forEach((values, c) => {
      for (let k = 0; k < this.count; ++k) all[4 * k + c] = values[k];
    });
    gl.bindTexture(gl.TEXTURE_2D, this.table);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, ACROSS, rows, 0, gl.RGBA, gl.FLOAT, all);
  }

  /** place: of the uniform `table`. */
  draw(place) {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.table);
    gl.uniform1i(place, 0);
    gl.bindVertexArray(this.none);
    gl.drawArrays(gl.TRIANGLES, 0, 3 * this.count);
    gl.bindVertexArray(null);
  }
}

/** Of which each number is taken as it is. */
export function plainTexture(gl) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return texture;
}

/** Colours in a row, from low to high, told as bytes of red, green and blue. */
export function colourTexture(gl, bytes) {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, bytes.length / 3, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, bytes);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  return texture;
}

/** The place of a value in the colours, as in scale.js: a half for each sign, if there are two. */
export const placeInColours = `
uniform float low, high, faint;  // faint > 0: a logarithmic scale, straight below it
uniform bool signs;
float grown(float value, float end) {
  return faint > 0. ? log(1. + value / faint) / log(1. + end / faint) : value / end;
}
float place(float value) {
  if (!signs) return clamp(grown(max(value - low, 0.), high - low), 0., 1.);
  return 0.5 + 0.5 * sign(value) * min(grown(abs(value), value < 0. ? -low : high), 1.);
}
float texel(float place) { return (0.5 + 255. * place) / 256.; }
`;
