// Puts the page together.

function wire(viewer, scene) {
  const option = (id, key, value) => byId(id).addEventListener("input", (e) => { viewer.options[key] = value(e.target); viewer.redraw(); });
  for (const id of ["split", "edges", "witnesses", "checker", "flip"]) option(id, id, (t) => t.checked);
  for (const id of ["slide", "offset"]) option(id, id, (t) => Number(t.value));
  option("axis", "axis", (t) => t.value);
  byId("whole").addEventListener("click", () => { viewer.camera.reset(); viewer.redraw(); });
  for (const name of NUMBERS) {
    const label = element("label", NUMBERS.indexOf(name) < 2 ? name : `${name} of the shell`, byId("opacity"));
    label.id = `opacity-${name}`;
    const slider = element("input", undefined, label);
    Object.assign(slider, { type: "range", min: 0, max: 1, step: 0.05 });
    slider.addEventListener("input", () => { viewer.opacity[name] = Number(slider.value); viewer.redraw(); });
  }
  scene.kinds.forEach((kind, i) => {
    const label = element("label", undefined, byId("legend"));
    const box = element("input", undefined, label);
    Object.assign(box, { type: "checkbox", checked: true });
    swatch(KIND_COLOURS[i], label);
    label.append(kind);
    box.addEventListener("input", () => viewer.toggle(i, box.checked));
  });
  listen(viewer.canvas, {
    turn: (dx, dy) => { viewer.camera.turn(dx, dy); viewer.redraw(); },
    move: (dx, dy) => { viewer.camera.move(dx, dy, viewer.canvas.clientHeight); viewer.redraw(); },
    zoom: (factor) => { viewer.camera.zoom(factor); viewer.redraw(); },
    click: (x, y) => choose(viewer, scene, viewer.pickAt(x, y)),
  });
}

/** Selects a triangle: `{name, triangle, violation}`, or nothing. */
function choose(viewer, scene, hit) {
  viewer.chosen = hit;
  const panel = byId("selected");
  if (hit) {
    if (hit.violation === undefined && hit.name.length === 1) {
      [hit.violation] = viewer.layer.findings.of(NUMBERS.indexOf(hit.name), hit.triangle);
    }
    describeTriangle(panel, scene, viewer.layer, hit.name, hit.triangle, hit.focus);
  } else {
    panel.textContent = "Nothing there.";
    delete panel.dataset.triangle;
  }
  viewer.redraw();
}

function chooseRegion(viewer, scene, region) {
  const f = viewer.layer.findings;
  const i = region.first;
  viewer.camera.look(region.centre, region.radius);
  const hit = f.triangle[i] === NONE ? { name: "middle", triangle: f.prism[i] } : { name: "AB"[f.mesh[i]], triangle: f.triangle[i] };
  choose(viewer, scene, { ...hit, violation: i, focus: i });
}

/** Shows a layer, with the controls as they suit it. */
function open(viewer, scene, index) {
  viewer.show(index);
  const { findings, carried, surfaces } = viewer.layer;
  const bad = [0, 1].map((m) => findings.mesh.includes(m));
  const shell = surfaces.bottom ? 0.1 : 0;
  const faint = (mesh) => (bad[1 - mesh] && !bad[mesh] ? 0.25 : 1);
  viewer.opacity = { A: faint(0), B: faint(1), bottom: shell, middle: 0, top: shell };
  Object.assign(viewer.options, { checker: carried, split: carried || (bad[0] && bad[1]) });
  for (const id of ["checker", "split"]) byId(id).checked = viewer.options[id];
  for (const id of ["checker-row", "slide-row", "map-note"]) byId(id).hidden = !carried;
  for (const name of NUMBERS) {
    byId(`opacity-${name}`).hidden = !surfaces[name];
    byId(`opacity-${name}`).querySelector("input").value = viewer.opacity[name];
  }
  byId("selected").textContent = "Nothing. Click a triangle, or choose a region.";
  listRegions(byId("regions"), scene, findings, (region) => chooseRegion(viewer, scene, region));
}

/** Says in the document, after the first drawing, that pixels were drawn. */
function tellWhenReady(viewer) {
  viewer.afterwards = () => {
    viewer.afterwards = null;
    document.documentElement.dataset.pixels = viewer.renderer.drawn();
    document.documentElement.dataset.ready = "yes";
  };
}

try {
  const scene = readScene(byId("scene").textContent);
  const viewer = new Viewer(byId("view"), scene);
  scene.titles.forEach((title, i) => { element("option", title, byId("layer")).value = i; });
  wire(viewer, scene);
  tellWhenReady(viewer);
  // The certified try comes last; where there is none, so does the last shell.
  const last = scene.titles.length - 1;
  byId("layer").value = last;
  byId("layer").addEventListener("input", (e) => open(viewer, scene, Number(e.target.value)));
  open(viewer, scene, last);
  window.homeo = { viewer, scene };
} catch (error) {
  byId("trouble").textContent = error.message;
  byId("trouble").hidden = false;
  document.documentElement.dataset.ready = "no";
}
