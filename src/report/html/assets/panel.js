// Texts beside the view. All of them are set as text, never as HTML.

const byId = (id) => document.getElementById(id);

function element(name, text, parent) {
  const e = document.createElement(name);
  if (text !== undefined) e.textContent = text;
  if (parent) parent.append(e);
  return e;
}

const KIND_COLOURS = [[213, 94, 0], [190, 60, 150], [0, 114, 178], [225, 190, 0], [0, 158, 115], [220, 0, 50]];

/** Violations of one triangle that are described. */
const SHOWN = 20;

function swatch(colour, parent) {
  const e = element("span", undefined, parent);
  e.className = "swatch";
  e.style.background = `rgb(${colour.join()})`;
}

/** Entries of a definition list. */
function list(parent) {
  const dl = element("dl", undefined, parent);
  return (term, text) => { element("dt", term, dl); element("dd", text, dl); };
}

function point(entry, name, p) {
  entry(`${name}, exactly`, p.exact.join("\n"));
  entry(`${name}, rounded`, p.approximate.join(", "));
  entry(`${name}, weights on the corners`, p.weights.join(" : "));
}

/** One violation with everything that the report says of it. */
function describe(parent, scene, findings, i) {
  const f = findings;
  const head = element("h4", undefined, parent);
  swatch(KIND_COLOURS[f.kind[i]], head);
  head.append(scene.kinds[f.kind[i]]);
  const entry = list(parent);
  entry("mesh", "AB"[f.mesh[i]]);
  if (f.triangle[i] !== NONE) entry("triangle", String(f.triangle[i]));
  if (f.other[i] !== NONE) entry("other triangle", String(f.other[i]));
  if (f.prism[i] !== NONE) entry("prism", String(f.prism[i]));
  const d = f.details[i];
  if (!d) {
    entry("witness, about", spot(scene.frame, f.at, i).join(", "));
    element("p", "Exact values of this one are in the JSON report only.", parent).className = "note";
    return;
  }
  if (d.text) entry("says", d.text);
  if (d.tet) entry("tet", d.tet);
  if (d.value) {
    entry("n · V, exactly", d.value[0]);
    entry("n · V, rounded", d.value[1] === null ? "beyond doubles" : String(d.value[1]));
  }
  if (typeof d.share === "number") entry("share of area", String(d.share));
  point(entry, "witness", d.point);
  if (d.other) point(entry, `witness on triangle ${d.other[0]}`, d.other[1]);
  if (d.middle) point(entry, "middle point of both", d.middle);
}

/** Coordinates of the view in those of the file, about. */
function spot(frame, points, i) {
  const size = Math.max(...frame.centre.map(Math.abs)) / frame.half;
  // Positions of the view have seven digits, relative to the size of the scene.
  const digits = Math.min(17, 7 + Math.max(0, Math.ceil(Math.log10(size))));
  return frame.centre.map((c, k) => Number((c + frame.half * points[3 * i + k]).toPrecision(digits)));
}

/** A triangle with its corners and all violations at it. */
function describeTriangle(parent, scene, layer, name, triangle, focus) {
  const isMesh = name === "A" || name === "B";
  const s = layer.surfaces[name];
  parent.replaceChildren();
  parent.dataset.surface = name;
  parent.dataset.triangle = triangle;
  element("b", isMesh ? `${name}, triangle ${triangle}` : `prism ${triangle} (${name} triangle)`, parent);
  const found = isMesh ? layer.findings.of(name === "A" ? 0 : 1, triangle) : layer.findings.ofPrism(triangle);
  if (!found.length) element("p", "no violation here", parent);
  const first = focus === undefined ? [] : [focus];
  const order = first.concat(found.filter((i) => i !== focus));
  for (const i of order.slice(0, SHOWN)) describe(parent, scene, layer.findings, i);
  if (order.length > SHOWN) element("p", `and ${order.length - SHOWN} more violations`, parent);
  const entry = list(parent);
  for (const v of s ? s.faces.subarray(3 * triangle, 3 * triangle + 3) : []) {
    entry(`vertex ${v}, about`, spot(scene.frame, s.points, v).join(", "));
  }
}

/** Buttons for regions; `choose(region)` when one is pressed. */
function listRegions(parent, scene, findings, choose) {
  parent.replaceChildren();
  element("p", findings.regionCount ? `${findings.count} in ${findings.regionCount} regions` : "none", parent);
  for (const region of findings.regions) {
    const b = element("button", undefined, parent);
    b.type = "button";
    swatch(KIND_COLOURS[region.kind], b);
    b.append(`${"AB"[region.mesh]}: ${scene.kinds[region.kind]}, ${region.violations} places, ${region.triangles} triangles, ${region.prisms} prisms`);
    b.addEventListener("click", () => choose(region));
  }
  if (findings.regionCount > findings.regions.length) element("p", "The smaller regions are in the JSON report only.", parent);
}
