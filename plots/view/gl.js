// What a WebGL 2 context is asked for: programs, columns of instances, textures.

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

/** Columns of floats, one number of each for each instance of a quad. */
export class Instances {
  constructor(gl, names, program) {
    this.gl = gl;
    this.array = gl.createVertexArray();
    this.buffers = names.map(() => gl.createBuffer());
    this.count = 0;
    gl.bindVertexArray(this.array);
    names.forEach((name, k) => {
      const place = gl.getAttribLocation(program, name);
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[k]);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 1, gl.FLOAT, false, 0, 0);
      gl.vertexAttribDivisor(place, 1);
    });
    gl.bindVertexArray(null);
  }

  fill(columns) {
    const { gl } = this;
    this.count = columns[0].length;
    columns.forEach((values, k) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[k]);
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    });
  }

  draw() {
    this.gl.bindVertexArray(this.array);
    this.gl.drawArraysInstanced(this.gl.TRIANGLE_STRIP, 0, 4, this.count);
    this.gl.bindVertexArray(null);
  }
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
