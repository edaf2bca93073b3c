// The scene of the page: arrays from base64, looked up by name.

const NONE = 0xffffffff;

/** Base64 to a typed array; both sides are little-endian. */
function decode(text, Type) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return new Type(bytes.buffer);
}

/** Three corners a triangle, so that a corner's number names its triangle. */
function expand(points, faces) {
  const out = new Float32Array(faces.length * 3);
  for (let i = 0; i < faces.length; i++) {
    const v = 3 * faces[i];
    out[3 * i] = points[v];
    out[3 * i + 1] = points[v + 1];
    out[3 * i + 2] = points[v + 2];
  }
  return out;
}

/** A surface: its corners, and where the map takes them. */
function surface(points, faces, carried) {
  const corners = expand(points, faces);
  return { points, faces, count: faces.length / 3, corners, carried: carried ? expand(carried, faces) : corners };
}

/** Violations as arrays; `of(mesh, triangle)` lists those at a triangle, `prism(p)` those of a prism without one. */
function readFindings(raw) {
  const f = {
    count: raw.count,
    mesh: decode(raw.mesh, Uint8Array),
    kind: decode(raw.kind, Uint8Array),
    triangle: decode(raw.triangle, Uint32Array),
    other: decode(raw.other, Uint32Array),
    prism: decode(raw.prism, Uint32Array),
    at: decode(raw.at, Float32Array),
    details: raw.details,
    regions: raw.regions,
    regionCount: raw.region_count,
  };
  const places = new Map();
  const add = (key, i) => { if (places.has(key)) places.get(key).push(i); else places.set(key, [i]); };
  for (let i = 0; i < f.count; i++) {
    if (f.triangle[i] === NONE) add(`prism ${f.prism[i]}`, i);
    else add(`${f.mesh[i]} ${f.triangle[i]}`, i);
    if (f.other[i] !== NONE) add(`${f.mesh[i]} ${f.other[i]}`, i);
  }
  f.of = (mesh, triangle) => places.get(`${mesh} ${triangle}`) || [];
  f.ofPrism = (prism) => places.get(`prism ${prism}`) || [];
  return f;
}

/** The scene; a layer (a try) is decoded when it is first shown. */
function readScene(text) {
  const raw = JSON.parse(text);
  const meshes = raw.meshes.map((m) => ({ points: decode(m.points, Float32Array), faces: decode(m.faces, Uint32Array) }));
  const layers = raw.layers.map((l) => () => {
    const carried = l.carried && l.carried.map((c) => decode(c, Float32Array));
    const out = { findings: readFindings(l.findings), carried: Boolean(carried), surfaces: {} };
    ["A", "B"].forEach((name, i) => {
      out.surfaces[name] = surface(meshes[i].points, meshes[i].faces, carried && carried[i]);
    });
    if (l.shell) {
      const faces = decode(l.shell.faces, Uint32Array);
      for (const name of ["bottom", "middle", "top"]) out.surfaces[name] = surface(decode(l.shell[name], Float32Array), faces);
    }
    return out;
  });
  const triangles = meshes.reduce((n, m) => n + m.faces.length / 3, 0);
  return { triangles, frame: raw.frame, kinds: raw.kinds, certified: raw.certified, titles: raw.layers.map((l) => l.title), layers };
}
