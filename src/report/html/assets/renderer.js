// WebGL 2: surfaces, points, and which triangle is at a pixel.

const BACKGROUND = [1, 1, 1, 1];

class Renderer {
  constructor(canvas, antialias) {
    const gl = canvas.getContext("webgl2", { antialias, alpha: false });
    if (!gl) throw new Error("This browser offers no WebGL 2. The tables above are complete without the view.");
    this.gl = gl;
    this.canvas = canvas;
    this.fill = this.program(CORNER, FILL);
    this.pick = this.program(CORNER, PICK);
    this.dots = this.program(DOT, ROUND);
    this.target = this.onePixel();
  }

  program(vertex, fragment) {
    const gl = this.gl;
    const id = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(id, shader);
    }
    ["position", "carried", "mark"].forEach((name, i) => gl.bindAttribLocation(id, i, name));
    gl.linkProgram(id);
    if (!gl.getProgramParameter(id, gl.LINK_STATUS)) throw new Error(`WebGL: ${gl.getProgramInfoLog(id)}`);
    return { id, at: (name) => gl.getUniformLocation(id, name) };
  }

  /** A target of one pixel whose colour is four integers. */
  onePixel() {
    const gl = this.gl;
    const target = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    for (const [format, place] of [[gl.RGBA32UI, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]]) {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, 1, 1);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return target;
  }

  /** Arrays for `position`, `carried`, and `mark` (colours of four bytes; alpha 255 where marked). */
  upload(position, carried, mark) {
    const gl = this.gl;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const buffers = [position, carried, mark].map((data, i) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(i);
      if (i === 2) gl.vertexAttribPointer(i, 4, gl.UNSIGNED_BYTE, true, 0, 0);
      else gl.vertexAttribPointer(i, 3, gl.FLOAT, false, 0, 0);
      return buffer;
    });
    return { array, buffers, count: position.length / 3 };
  }

  remark(item, mark) {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, item.buffers[2]);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, mark, this.gl.STATIC_DRAW);
  }

  free(item) {
    this.gl.deleteVertexArray(item.array);
    item.buffers.forEach((b) => this.gl.deleteBuffer(b));
  }

  resize() {
    const scale = Math.min(2, window.devicePixelRatio || 1);
    const [w, h] = [this.canvas.clientWidth, this.canvas.clientHeight].map((x) => Math.max(1, Math.round(x * scale)));
    if (this.canvas.width !== w || this.canvas.height !== h) Object.assign(this.canvas, { width: w, height: h });
    return scale;
  }

  begin() {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.clearColor(...BACKGROUND);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** The common uniforms of a program. */
  use(program, view) {
    const gl = this.gl;
    gl.useProgram(program.id);
    gl.uniformMatrix4fv(program.at("camera"), false, view.camera);
    gl.uniform4fv(program.at("plane"), view.plane);
    gl.uniform1f(program.at("slide"), view.slide);
  }

  /** Draws surfaces into a pane (pixels): opaque ones first. */
  draw(pane, view, items) {
    const gl = this.gl;
    gl.viewport(pane.x, 0, pane.width, pane.height);
    this.use(this.fill, view);
    const at = this.fill.at;
    gl.uniform3fv(at("eye"), view.eye);
    gl.uniform1f(at("edges"), view.edges ? 1 : 0);
    for (const item of [...items].sort((a, b) => (b.base[3] >= 1) - (a.base[3] >= 1))) {
      const opaque = item.base[3] >= 1 || item.base[3] <= 0;
      if (opaque) gl.disable(gl.BLEND); else gl.enable(gl.BLEND);
      gl.depthMask(opaque);
      gl.uniform4fv(at("base"), item.base);
      gl.uniform1f(at("checker"), item.checker ? view.checker : 0);
      gl.uniform1f(at("chosen"), 0);
      gl.uniform1f(at("nearer"), item.nearer || 0);
      gl.bindVertexArray(item.gpu.array);
      gl.drawArrays(gl.TRIANGLES, 0, item.gpu.count);
      if (item.chosen >= 0) {
        gl.uniform1f(at("chosen"), 1);
        gl.uniform1f(at("nearer"), 2e-4);
        gl.drawArrays(gl.TRIANGLES, 3 * item.chosen, 3);
      }
    }
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  points(view, gpu, first, count, size) {
    const gl = this.gl;
    this.use(this.dots, view);
    gl.uniform1f(this.dots.at("size"), size);
    gl.bindVertexArray(gpu.array);
    gl.drawArrays(gl.POINTS, first, count);
  }

  /** `[triangle, surface]` at a pixel of a pane (from its lower left corner), or null: the pane is drawn, one pixel of it. */
  at(pane, view, items, x, y) {
    const gl = this.gl;
    const [w, h] = [pane.width, pane.height];
    const window = [w, 0, 0, 0, 0, h, 0, 0, 0, 0, 1, 0, w - 2 * x, h - 2 * y, 0, 1];
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.target);
    gl.viewport(0, 0, 1, 1);
    gl.disable(gl.BLEND);
    gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.clearBufferfv(gl.DEPTH, 0, [1]);
    this.use(this.pick, { ...view, camera: multiply(window, view.camera) });
    for (const item of items) {
      gl.uniform4fv(this.pick.at("base"), item.base);
      gl.uniform1ui(this.pick.at("surface"), item.number);
      gl.uniform1f(this.pick.at("nearer"), item.nearer || 0);
      gl.bindVertexArray(item.gpu.array);
      gl.drawArrays(gl.TRIANGLES, 0, item.gpu.count);
    }
    const answer = new Uint32Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, answer);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return answer[0] ? [answer[0] - 1, answer[1]] : null;
  }

  /** How many pixels of what was just drawn are not background. */
  drawn() {
    const gl = this.gl;
    const bytes = new Uint8Array(4 * this.canvas.width * this.canvas.height);
    gl.readPixels(0, 0, this.canvas.width, this.canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let count = 0;
    for (let i = 0; i < bytes.length; i += 4) if (bytes[i] < 250 || bytes[i + 1] < 250 || bytes[i + 2] < 250) count++;
    return count;
  }
}
