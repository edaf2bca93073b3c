// Mouse, touch and keys on the canvas.

/** Calls `turn`, `move`, `zoom` with pixels or factors, and `click` with a place in the canvas. */
function listen(canvas, { turn, move, zoom, click }) {
  const down = new Map();
  let travelled = 0;
  let several = false;
  const spread = () => {
    const [p, q] = [...down.values()];
    return { x: (p.x + q.x) / 2, y: (p.y + q.y) / 2, size: Math.hypot(p.x - q.x, p.y - q.y) };
  };
  canvas.addEventListener("pointerdown", (e) => {
    canvas.setPointerCapture(e.pointerId);
    down.set(e.pointerId, { x: e.clientX, y: e.clientY });
    if (down.size === 1) { travelled = 0; several = false; } else several = true;
  });
  canvas.addEventListener("pointermove", (e) => {
    const last = down.get(e.pointerId);
    if (!last) return;
    const [dx, dy] = [e.clientX - last.x, e.clientY - last.y];
    travelled += Math.abs(dx) + Math.abs(dy);
    if (down.size === 2) {
      const before = spread();
      down.set(e.pointerId, { x: e.clientX, y: e.clientY });
      const after = spread();
      move(after.x - before.x, after.y - before.y);
      if (before.size > 0 && after.size > 0) zoom(before.size / after.size);
      return;
    }
    down.set(e.pointerId, { x: e.clientX, y: e.clientY });
    if (down.size > 2 || travelled < 4) return;
    if (e.buttons & 6 || e.shiftKey) move(dx, dy); else turn(dx, dy);
  });
  const up = (e) => {
    if (!down.delete(e.pointerId) || e.type !== "pointerup") return;
    if (travelled < 4 && !several && e.button === 0) {
      const box = canvas.getBoundingClientRect();
      click(e.clientX - box.left, e.clientY - box.top);
    }
  };
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("contextmenu", (e) => e.preventDefault());
  canvas.addEventListener("wheel", (e) => {
    e.preventDefault();
    zoom(Math.exp(Math.max(-200, Math.min(200, e.deltaY)) * 0.0015));
  }, { passive: false });
  canvas.addEventListener("keydown", (e) => {
    const keys = { ArrowLeft: [-20, 0], ArrowRight: [20, 0], ArrowUp: [0, -20], ArrowDown: [0, 20] };
    if (keys[e.key]) turn(...keys[e.key]);
    else if (e.key === "+") zoom(0.85);
    else if (e.key === "-") zoom(1 / 0.85);
    else return;
    e.preventDefault();
  });
}
