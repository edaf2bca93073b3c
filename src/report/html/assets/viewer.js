// The view's state, and what is drawn of it.

const NUMBERS = ["A", "B", "bottom", "middle", "top"];
const BASES = { A: [0.72, 0.78, 0.86], B: [0.88, 0.8, 0.66], bottom: [0.25, 0.45, 0.85], middle: [0.6, 0.6, 0.6], top: [0.85, 0.4, 0.25] };

/** Above so many triangles edges are not smoothed: software renderers take four times as long for it. */
const SMOOTH = 100000;

class Viewer {
  constructor(canvas, scene) {
    this.scene = scene;
    this.canvas = canvas;
    this.renderer = new Renderer(canvas, scene.triangles < SMOOTH);
    this.camera = new Camera();
    this.opacity = { A: 1, B: 1, bottom: 0, middle: 0, top: 0 };
    this.hidden = new Set();
    this.options = { split: false, edges: true, witnesses: true, checker: false, slide: 0, axis: "", flip: false, offset: 0 };
    this.chosen = null;
    this.items = {};
    this.pending = false;
    window.addEventListener("resize", () => this.redraw());
  }

  /** Shows a layer. */
  show(index) {
    for (const item of Object.values(this.items)) this.renderer.free(item);
    if (this.dots) this.renderer.free(this.dots);
    this.layer = this.scene.layers[index]();
    this.chosen = null;
    this.items = {};
    for (const [name, s] of Object.entries(this.layer.surfaces)) {
      this.items[name] = this.renderer.upload(s.corners, s.carried, this.marks(name, s.count));
    }
    const f = this.layer.findings;
    this.dots = this.renderer.upload(f.at, new Float32Array(3), this.dotMarks());
    this.redraw();
  }

  /** Colours of corners: those of violations that are not hidden. */
  marks(name, count) {
    const out = new Uint8Array(12 * count);
    const f = this.layer.findings;
    const paint = (triangle, kind) => {
      if (triangle >= count) return;
      for (let k = 0; k < 3; k++) out.set([...KIND_COLOURS[kind], 255], 12 * triangle + 4 * k);
    };
    const mesh = NUMBERS.indexOf(name);
    for (let i = f.count - 1; i >= 0; i--) {
      if (this.hidden.has(f.kind[i])) continue;
      if (name === "middle" && f.triangle[i] === NONE) paint(f.prism[i], f.kind[i]);
      if (f.mesh[i] !== mesh) continue;
      paint(f.other[i], f.kind[i]);
      paint(f.triangle[i], f.kind[i]);
    }
    return out;
  }

  dotMarks() {
    const f = this.layer.findings;
    const out = new Uint8Array(4 * f.count);
    for (let i = 0; i < f.count; i++) if (!this.hidden.has(f.kind[i])) out.set([...KIND_COLOURS[f.kind[i]], 255], 4 * i);
    return out;
  }

  /** Shows a kind of violation, or does not. */
  toggle(kind, visible) {
    if (visible) this.hidden.delete(kind); else this.hidden.add(kind);
    for (const [name, item] of Object.entries(this.items)) this.renderer.remark(item, this.marks(name, item.count / 3));
    this.renderer.remark(this.dots, this.dotMarks());
    this.redraw();
  }

  redraw() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => { this.pending = false; this.draw(); });
  }

  /** The clipped half-space: `plane.xyz . x > plane.w`. */
  plane() {
    const { axis, flip, offset } = this.options;
    if (axis === "") return [0, 0, 0, 1];
    const normal = axis === "view" ? this.camera.axes().back : [0, 1, 2].map((i) => Number(i === Number(axis)));
    const s = flip ? -1 : 1;
    const centre = axis === "view" ? dot(normal, this.camera.target) : 0;
    return [...normal.map((x) => s * x), s * (centre + offset)];
  }

  /** One pane, or A's and B's. */
  panes() {
    const { width, height } = this.canvas;
    if (!this.options.split) return [{ x: 0, width, height, names: NUMBERS }];
    const half = Math.max(1, Math.floor(width / 2));
    return ["A", "B"].map((name, i) => ({ x: i * half, width: half, height, names: NUMBERS.filter((n) => n === name || n.length > 1) }));
  }

  view(pane) {
    const { edges, slide } = this.options;
    return { camera: this.camera.matrix(pane.width / pane.height), eye: this.camera.eye(), plane: this.plane(), edges, checker: 6,
      slide: this.layer.carried ? slide : 0 };
  }

  surfaces(pane) {
    const names = pane.names.filter((n) => this.items[n] && (this.opacity[n] > 0 || n === "middle"));
    return names.map((name) => ({
      name,
      number: NUMBERS.indexOf(name),
      gpu: this.items[name],
      base: [...BASES[name], this.opacity[name]],
      checker: this.options.checker && this.layer.carried && name.length === 1,
      // Where A and B coincide, B is seen.
      nearer: name === "B" ? 2e-5 : 0,
      chosen: this.chosen && this.chosen.name === name ? this.chosen.triangle : -1,
    }));
  }

  draw() {
    const scale = this.renderer.resize();
    this.renderer.begin();
    for (const pane of this.panes()) {
      const view = this.view(pane);
      this.renderer.draw(pane, view, this.surfaces(pane));
      const f = this.layer.findings;
      if (this.options.witnesses) this.renderer.points(view, this.dots, 0, f.count, 5 * scale);
      if (this.chosen && this.chosen.violation !== undefined) this.renderer.points(view, this.dots, this.chosen.violation, 1, 13 * scale);
    }
    if (this.afterwards) this.afterwards();
  }

  /** `{name, triangle}` at a place of the canvas (CSS pixels), or null. Bottom and top are looked through. */
  pickAt(x, y) {
    const scale = this.renderer.resize();
    const panes = this.panes();
    const pane = [...panes].reverse().find((p) => x * scale >= p.x) || panes[0];
    const items = this.surfaces(pane).filter((s) => s.name !== "bottom" && s.name !== "top");
    const hit = this.renderer.at(pane, this.view(pane), items, x * scale - pane.x, pane.height - y * scale);
    return hit && { name: NUMBERS[hit[1]], triangle: hit[0] };
  }
}
