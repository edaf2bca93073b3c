// Where the eye is. Matrices are by columns, as WebGL wants them.

const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function multiply(a, b) {
  const out = new Float32Array(16);
  for (let c = 0; c < 4; c++) {
    for (let r = 0; r < 4; r++) {
      for (let k = 0; k < 4; k++) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
    }
  }
  return out;
}

/** An eye that turns around a target. */
class Camera {
  constructor() { this.reset(); }

  reset() { Object.assign(this, { target: [0, 0, 0], distance: 3.6, yaw: 0.6, pitch: 0.35 }); }

  /** Unit vectors to the right, up, and from the target to the eye. */
  axes() {
    const [sy, cy, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    return { right: [cy, 0, -sy], up: [-sy * sp, cp, -cy * sp], back: [sy * cp, sp, cy * cp] };
  }

  eye() { return add(this.target, this.axes().back, this.distance); }

  turn(dx, dy) {
    this.yaw -= dx * 0.008;
    this.pitch = Math.max(-1.57, Math.min(1.57, this.pitch + dy * 0.008));
  }

  /** Moves the target by pixels of a pane of this height. */
  move(dx, dy, height) {
    const { right, up } = this.axes();
    const s = this.distance * 2 * Math.tan(0.35) / height;
    this.target = add(add(this.target, right, -dx * s), up, dy * s);
  }

  zoom(factor) { this.distance = Math.max(1e-4, Math.min(40, this.distance * factor)); }

  look(target, radius) {
    this.target = target;
    this.distance = Math.max(0.02, radius * 5);
  }

  matrix(aspect) {
    const { right, up, back } = this.axes();
    const eye = this.eye();
    const near = this.distance / 100;
    const far = this.distance + 8;
    const f = 1 / Math.tan(0.35);
    const g = aspect < 1 ? f * aspect : f;
    const view = [right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
      -dot(right, eye), -dot(up, eye), -dot(back, eye), 1];
    const lens = [g / aspect, 0, 0, 0, 0, g, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0];
    return multiply(lens, view);
  }
}
