#!/usr/bin/env python3
"""Second, independent checker of homeo certificates: python3 check.py CERT INPUT...

It follows certs/FORMAT.md, version 1, whose sections are cited, and needs only the standard library. All coordinates
are multiplied by one common power of two: every decision is made on Python integers. certificate.py reads the
certificate and says what a *tag* is; inputs.py reads the input files; answer.py words the answer.
"""
import collections, functools, hashlib, itertools, math, struct
from answer import answer, certificate_bytes, main
from certificate import CLAIMS, Certificate, Stop, distinct, need
from inputs import WRONG, read_inputs

chain = itertools.chain.from_iterable

# ---- section 1: words
sub = lambda a, b: (a[0] - b[0], a[1] - b[1], a[2] - b[2])
dot = lambda a, b: a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
det3 = lambda a, b, c: dot(a, cross(b, c))
det = lambda a, b, c, d: det3(sub(b, a), sub(c, a), sub(d, a))
sides = lambda a, b, c: ((a, b), (b, c), (c, a))
fan = lambda c: [(c[0], c[i], c[i + 1]) for i in range(1, len(c) - 1)]
box = lambda points: (*map(min, zip(*points)), *map(max, zip(*points)))
meet = lambda a, b: (a[0] <= b[3] and b[0] <= a[3] and a[1] <= b[4] and b[1] <= a[4]
                     and a[2] <= b[5] and b[2] <= a[5])
def plane(a, b, c):  # (n, h): n . x - h is det[b-a, c-a, x-a]
    n = cross(sub(b, a), sub(c, a))
    return n, dot(n, a)
def mix(points, weights):  # the weighted point as (x, y, z, w)
    return tuple(sum(w * p[k] for w, p in zip(weights, points)) for k in range(3)) + (sum(weights),)
def projected(weights):  # for {name: weight}, the sums over the names of each vertex
    return {v: sum(x for n, x in weights.items() if n // 3 == v) for v in {n // 3 for n in weights}}
def proportional(a, b):  # whether two points, given as {vertex: positive weight}, are equal
    return a.keys() == b.keys() and all(a[k] * sum(b.values()) == b[k] * sum(a.values()) for k in a)
def meeting(A, B, left, right):  # (i, j) whose closed boxes A[i], B[j] meet: halves `right`, prunes `left`
    if len(right) <= 4: return [(i, j) for i in left for j in right if meet(A[i], B[j])]
    hull = box([B[j][:3] for j in right] + [B[j][3:] for j in right])
    left, axis = [i for i in left if meet(A[i], hull)], max(range(3), key=lambda k: hull[k + 3] - hull[k])
    right, half = sorted(right, key=lambda j: B[j][axis] + B[j][axis + 3]), len(right) // 2
    return [pair for some in (right[:half], right[half:]) if left for pair in meeting(A, B, left, some)]
def parts(items, near):  # for each item the first one that it is connected with through near(item)
    first = {}
    for start in items:
        todo = [start]
        for item in todo:
            if item not in first:
                first[item] = start
                todo += near(item)
    return first

class Complex:  # oriented triangles by vertex (`at`), directed edge, vertex set (`find`); boundary (`rim`), components
    def __init__(self, faces):
        self.faces, self.at, self.edge = faces, {}, {}
        for i, f in enumerate(faces):
            for v, w in sides(*f):
                self.edge[v, w] = i
                self.at.setdefault(v, []).append(i)
        self.find = {frozenset(f): i for i, f in enumerate(faces)}
        rim = [(a, b) for a, b in self.edge if (b, a) not in self.edge]
        self.rim = {frozenset(s) for a, b in rim for s in ((a, b), (a,), (b,))}
        across = lambda i: [(e, self.edge[e[::-1]]) for e in sides(*faces[i]) if e[::-1] in self.edge]
        self.component = parts(range(len(faces)), lambda i: [j for _, j in across(i)])
        self.count = len(set(self.component.values()))
        self.euler = len(self.at) - len(set(map(frozenset, self.edge))) + len(faces)
        fans = parts([(v, i) for v in self.at for i in self.at[v]],
                     lambda corner: [(corner[0], j) for e, j in across(corner[1]) if corner[0] in e])
        self.manifold = (len(faces) > 0 and all(map(distinct, faces)) and len(self.find) == len(faces)
                         and len(self.edge) == 3 * len(faces) and len(set(fans.values())) == len(self.at))

straight = lambda tet: det(*((c == 1, c == 2, h) for c, h in tet)) > 0  # whether positive in the straight unit prism
turned = lambda tet: tet if straight(tet) else (tet[0], tet[1], tet[3], tet[2])
ORDERS = {}  # order of a prism's corners: its three tets, as (four (corner, 0 lo | 1 hi), pillar's corner)
for u, v, w in itertools.permutations(range(3)):
    a, b, c, d, e, f = itertools.product((u, v, w), (0, 1))  # lo, hi of u, v, w
    ORDERS[u, v, w] = [(turned((a, c, e, f)), w), (turned((a, c, d, f)), v), (turned((a, b, d, f)), u)]
ALL12 = list({frozenset(t): (t, pillar) for three in ORDERS.values() for t, pillar in three}.values())

class Case:  # shell and mesh in integers (times `unit`): points `X` by tag, names `N` by vertex; complexes `M`, `T`
    def __init__(self, layers, prisms, points, triangles):
        self.unit = max(x.as_integer_ratio()[1] for p in chain([*layers, points]) for x in p)
        scale = lambda p: tuple(n * (self.unit // d) for n, d in map(float.as_integer_ratio, p))
        self.X = [scale(p) for triple in zip(*layers) for p in triple] + [scale(p) for p in points[::-1]]
        self.N = [(3 * v + 1,) * 3 if b == m == t else (3 * v, 3 * v + 1, 3 * v + 2)
                  for v, (b, m, t) in enumerate(zip(*layers))]
        self.pins = {b for b, m, t in self.N if b == t}
        self.M, self.T = Complex(prisms), Complex(triangles)
        self.corners = [self.at(~v for v in f) for f in triangles]
        self.planes = [plane(*c) for c in self.corners]
        self.boxes = [box(self.at(n for v in f for n in self.N[v])) for f in prisms]
    def at(self, tags): return [self.X[t] for t in tags]
    def volume(self, tet): return det(*self.at(tet[0]))
    def dot(self, f, tet): return dot(self.planes[f][0], tet[1])
    def tets(self, prism, chosen=ALL12):  # {names: (names in positive order, V)} of a prism, in both slabs
        corners, found = [self.N[v] for v in self.M.faces[prism]], {}
        for slab, (t, pillar) in itertools.product((0, 1), chosen):
            lo, hi = corners[pillar][slab:slab + 2]
            if lo != hi:
                order = [corners[c][slab + h] for c, h in t]
                found[tuple(sorted(order))] = order, sub(self.X[hi], self.X[lo])
        return found
    def decomposition(self, order):  # S_< by prism, for all vertices, smallest first
        rank = {v: i for i, v in enumerate(order)}
        local = lambda f: tuple(sorted(range(3), key=lambda c: rank[f[c]]))
        return [self.tets(j, ORDERS[local(f)]) for j, f in enumerate(self.M.faces)]
    def clear(self, f, prism):  # whether f has a positive dot with both halves of all unpinched pillars of the prism
        pillars = [self.at(self.N[v]) for v in self.M.faces[prism] if 3 * v + 1 not in self.pins]
        return all(b < m < t for b, m, t in ([dot(self.planes[f][0], p) for p in pillar] for pillar in pillars))
    def equals(self, scaled, value):  # whether scaled / unit^3 is the file's value odd * 2^exponent
        return scaled << max(-value[1], 0) == value[0] * self.unit ** 3 << max(value[1], 0)
    def cap(self, names):  # 3.2.2: all names are `t` or pinched, or all `b` or pinched, but not one pinched name
        free = {n % 3 for n in names if n not in self.pins}
        return free in ({0}, {2}) or not free and len(names) > 1

# ---- section 3, inputs and binding
def sha(layers, faces):
    pack = lambda code, rows: struct.pack(f"<{3 * len(rows)}{code}", *chain(rows))
    return hashlib.sha256(b"".join(pack("d", layer) for layer in layers) + pack("I", faces)).hexdigest()
def sound_inputs(paths, mesh_needed):  # points and faces of bottom, middle and top layer and, if read, the mesh
    try: points, faces = zip(*read_inputs(paths, mesh_needed))
    except WRONG as error: raise Stop("malformed", "input", ascii(error)[:200]) from None
    good = all(p and all(map(math.isfinite, chain(p))) and all(0 <= v < len(p) for v in chain(f))
               for p, f in zip(points, faces)) and len(set(map(len, points[:3]))) == 1
    need(good and faces[0] == faces[1] == faces[2], "input", "coordinate, index or connectivity", "malformed")
    return points, faces
def bind(cert, points, faces):  # the inputs are those that the certificate names, and fit to be judged
    layers, prisms, mesh = points[:3], faces[0], [points[3], faces[3]] if cert.mesh else [[], []]
    need(cert.shell == [sha(layers, prisms), len(layers[0]), len(prisms)], "hash", "shell")
    need(cert.mesh in (None, [sha(mesh[:1], mesh[1]), *map(len, mesh)]), "hash", "mesh")
    case = Case(layers, prisms, *mesh)
    pins = [sum(3 * v + 1 in case.pins for v in f) for f in prisms]
    need(case.M.manifold and max(pins) < 3, "shell-conditions")
    need(not cert.mesh or case.T.manifold and all(any(n) for n, _ in case.planes), "mesh-conditions")
    need(cert.pinched == [8 * sum(pins), sorted(n // 3 for n in case.pins)], "pinched")
    return case

# ---- section 3.1: positivity
def check_tet(case, fact, tets):
    prism, names, value = fact
    need(names in tets, "unknown-tet", f"prism {prism}")
    need(case.equals(case.volume(tets[names]), value), "wrong-value", f"prism {prism}")
    need(case.volume(tets[names]) <= 0, "not-refuted", f"prism {prism}")
def check_positive(case, decomposition):
    for prism, tets in enumerate(decomposition):
        need(all(case.volume(tet) > 0 for tet in tets.values()), "not-positive", f"prism {prism}")

# ---- section 3.2: the overlay
def null_vector(columns):  # the integer solution x of sum x_i column_i = 0 if the solutions are a line, else None
    basis, found = [], []  # each column is followed by the unit vector that names it, and reduced by those before it
    for i, column in enumerate(columns):
        row = [*column, *(int(i == j) for j in range(len(columns)))]
        for pivot, other in basis: row = [other[pivot] * x - row[pivot] * y for x, y in zip(row, other)]
        common = math.gcd(*row)
        pivot, row = next((k for k in range(4) if row[k]), None), [x // common for x in row]
        (found if pivot is None else basis).append((pivot, row))
    return found[0][1][4:] if len(found) == 1 else None
def holders(case, S, names):  # the tets of S that hold all the names, as (prism, names)
    return [(j, t) for j in case.M.at.get(names[0] // 3, ()) for t in S[j] if set(names) <= set(t)]
def overlay_vertex(case, S, ids, names):  # 3.2.2: a `v` line as (mesh weights, projected weights, names)
    at, n = f"v line {ids} {names}", len(ids)
    need(any(set(ids) <= set(case.T.faces[f]) for f in case.T.at.get(ids[0], ())), "mesh-carrier", at)
    need(holders(case, S, names), "shell-carrier", at)
    need(not case.cap(names), "cap", at)
    solution = null_vector([p + (1,) for p in case.at([~i for i in ids] + [*names])]) or [0]
    total = sum(solution[:n])
    need(total, "no-point", at)
    solution = [x * total for x in solution[:n]] + [-x * total for x in solution[n:]]
    need(min(solution) > 0, "outside-carrier", at)
    return dict(zip(ids, solution)), projected(dict(zip(names, solution[n:]))), set(names)
def check_overlay(case, S, vertices, lines, named):  # K: points, cells (f, prism, fan in f), boundary edges
    check_positive(case, S)  # 3.2.1
    points, cells, images, edges = [overlay_vertex(case, S, *v) for v in vertices], [], {}, set()
    for k, c in enumerate(lines):  # 3.2.3
        at, (ids, over, names) = f"c line {k}", (set().union(*(points[i][s] for i in c)) for s in range(3))
        f, j = case.T.find.get(frozenset(ids)), case.M.find.get(frozenset(over))
        need(f is not None, "cell-mesh", at)
        need(j is not None and any(names <= set(t) for t in S[j]), "cell-shell", at)
        rows = [fan([[points[i][s].get(v, 0) for v in face] for i in c])
                for s, face in enumerate((case.T.faces[f], case.M.faces[j]))]
        for i, (a, b) in enumerate(zip(*rows)):
            for side, image in enumerate((a, b)):
                need(det3(*image) > 0, ("area-mesh", "area-middle")[side], at)
                images.setdefault((side, (f, j)[side]), {})[k, i] = image
        cells.append((f, j, rows[0]))
    for a, b in (edge for c in lines for triangle in fan(c) for edge in sides(*triangle)):  # 3.2.4
        need((a, b) not in edges, "edge-twice", f"{a} {b}")
        need(not case.cap(points[a][2] | points[b][2]), "cap", f"edge {a} {b}")
        edges.add((a, b))
    rim = sorted(edges - {(b, a) for a, b in edges})
    for a, b in rim:
        need({*points[a][0], *points[b][0]} in case.T.rim and {*points[a][1], *points[b][1]} in case.M.rim,
             "boundary", f"{a} {b}")
    need(len(set(chain(lines))) == len(points), "isolated")  # 3.2.5
    for side, over in enumerate((case.T, case.M)):  # 3.2.6
        found = [over.component[cells[cell][side]] for cell, _ in named[side]]
        need(found == sorted(set(over.component.values())), "degree-component")
    for side, name in [(side, name) for side in (0, 1) for name in named[side]]:
        over = images[side, cells[name[0]][side]]
        a, b, c = map(sum, over[name])
        x = [p * b * c + q * a * c + r * a * b for p, q, r in zip(*over[name])]  # the centroid
        for other, (p, q, r) in over.items():
            inside = min(det3(x, q, r), det3(p, x, r), det3(p, q, x)) >= 0
            need(not inside or other == name, "degree", f"cells {name[0]} {other[0]}")
    return points, cells, rim

# ---- section 3.3: all orders
def cut(case, polygon, names, corners):  # Cuts a polygon (barycentric rows on three corners) with a closed tet
    for k in range(4):
        p, *face = case.at(names[k:] + names[:k])
        n, h = plane(*face)
        values = [(dot(n, c) - h) * (1 if dot(n, p) >= h else -1) for c in corners]
        side, polygon = [(row, dot(values, row)) for row in polygon], []
        for (p, x), (q, y) in zip(side, side[1:] + side[:1]):
            polygon += [p] if x >= 0 else []
            if x * y < 0:
                new = [abs(y) * s + abs(x) * t for s, t in zip(p, q)]
                polygon.append([s // math.gcd(*new) for s in new])
    return polygon
def check_all_orders(case, points, cells, rim):
    walls = lambda u, w: [(*case.N[u][s:s + 2], *case.N[w][s:s + 2]) for s in (0, 1)]
    volume = lambda names: det(*case.at(names))  # of a wall: 0 if u or w is pinched
    for a, b in rim:  # 3.3.1
        names, ends = points[a][2] | points[b][2], {*points[a][1], *points[b][1]}
        flat = [x for x in walls(*ends) if not volume(x)] + [[3 * v + 1 for v in ends]]
        need(any(names <= set(x) for x in flat), "all-orders-boundary", f"edge {a} {b}")
    for (f, j, rows), side in itertools.product(cells, range(-1, 3)):  # 3.3.2
        corners, across = case.corners[f], sides(*case.M.faces[j])[side] if side >= 0 else ()
        q = case.M.edge.get(across[::-1]) if across else j
        if q is not None and case.clear(f, q): continue
        tets = [x for x in walls(*across) if volume(x)] if across else []
        parts = [cut(case, p, x, corners) for x in tets for p in rows] if across else rows
        if q is not None:  # else a boundary side: no prism takes over what stands in its wall tets
            steep = [names for names, tet in case.tets(q).items() if case.dot(f, tet) <= 0]
            parts = [cut(case, p, names, corners) for names in steep for p in parts]
        need(not any(det3(*t) for p in parts for t in fan(p)), "all-orders", f"triangle {f}, prism {j}")

# ---- section 3.4: the no-lift witness; a tet here is (names in positive order, V)
def check_witness(case, S, word, facts):
    if word == "tet": check_tet(case, facts, S[facts[0]])
    elif word == "roots": check_roots(case, S, facts)
    else:
        values = [x.euler if word == "topology euler" else x.count for x in (case.T, case.M)]
        need(values == facts, "wrong-value")
        need(values[0] != values[1], "not-refuted")
def find_tet(case, S, names):  # (prism, tet of S)
    prism = case.M.find.get(frozenset(n // 3 for n in names))
    need(prism is not None and names in S[prism], "unknown-tet")
    return prism, S[prism][names]
def coordinates(case, x, tet):  # {name: positive coordinate} of x = (x, y, z, w); {} outside or if tet is not positive
    a, b, c, d = ([x[3] * p - q for p, q in zip(point, x)] for point in case.at(tet[0]))
    values = det3(b, c, d), -det3(a, c, d), det3(a, b, d), -det3(a, b, c)
    inside = min(values) >= 0 and case.volume(tet) > 0
    return {n: v for n, v in zip(tet[0], values) if v} if inside else {}
def injective_star(case, S, edge):  # whether S's tets around an edge are positive and their open wedges disjoint
    wedges, (p, q) = [], case.at(edge)
    for prism, names in holders(case, S, edge):
        r, s = case.at(n for n in names if n not in edge)
        wedges.append((r, s) if det(p, q, r, s) > 0 else (s, r))
        if case.volume(S[prism][names]) <= 0: return False
    before = lambda x, y: any(all(det(p, q, *z) <= 0 for z in side)
                              for side in ([(x[0], z) for z in y], [(z, x[1]) for z in y]))
    return all(before(x, y) or before(y, x) for x, y in itertools.combinations(wedges, 2))
def all_carriers(case, S, x):  # of a point x = (x, y, z, w) over all tets
    near = [j for j, b in enumerate(case.boxes) if all(b[k] * x[3] <= x[k] <= b[k + 3] * x[3] for k in range(3))]
    return {tuple(sorted(coordinates(case, x, tet))) for j in near for tet in S[j].values()} - {()}
def check_roots(case, S, facts):
    landed = set()
    for f, weights, branches in facts:
        carriers = all_carriers(case, S, mix(case.corners[f], weights))
        need(carriers == {branch[0] for branch in branches}, "wrong-branches", f"root on {f}")
        for names, legs, reason in branches:
            ends = [last_station(case, S, f, weights, names, *leg) for leg in legs]
            need(holds(case, reason, *ends[0], *ends[-1]), "not-refuted", f"root on {f}, {reason}")
            landed |= {case.M.component[ends[0][3]]} if reason == "lands" else set()
    need(distinct([case.T.component[f] for f, _, _ in facts]), "wrong-branches")
    need(len(landed) < len(facts), "not-refuted")
def last_station(case, S, f, weights, branch, start, steps):  # (f, {mesh vertex: weight}, coordinates, prism, tet)
    faces, (prism, tet) = case.T.faces, find_tet(case, S, start)
    here = coordinates(case, mix(case.corners[f], weights), tet)  # {} if the tet is not positive
    need(here and set(branch) <= set(start), "wrong-step")
    for g, weights, names in steps:
        (prism, new), x = find_tet(case, S, names), mix(case.corners[g], weights)
        used = {v for v, w in zip(faces[g], weights) if w}
        before, after = coordinates(case, x, tet), coordinates(case, x, new)
        good = used <= set(faces[f]) and before and before.keys() == after.keys()
        star = len(here) > 2 or len(here) == 2 and injective_star(case, S, tuple(sorted(here)))
        need(good and star, "wrong-step", f"step on {g}")
        f, tet, here = g, new, after
    return f, {v: w for v, w in zip(faces[f], weights) if w}, here, prism, tet
def holds(case, reason, f, on_mesh, here, prism, tet, _, mesh2, here2, *others):  # at the last stations of its legs
    (n, h), same_point = case.planes[f], proportional(on_mesh, mesh2)
    on_rim, on_wall = {*on_mesh} in case.T.rim, {*projected(here)} in case.M.rim
    flat = len(here) == 4 or len(here) == 3 and all(dot(n, p) == h for p in case.at(here))
    return {"cap": case.cap(here), "wall": on_wall and not on_rim, "boundary": on_rim and not on_wall,
            "fold": len(on_mesh) == 3 and case.dot(f, tet) <= 0 and flat, "lands": True,
            "twice": not same_point and proportional(projected(here), projected(here2)),
            "monodromy": same_point and here.keys() != here2.keys()}[reason]

# ---- sections 3.5 and 3.6: separation and contact
def separates(case, planes, A, B):  # section 3.5, for planes (n, h) and simplices given by their tags
    common, pinched = set(A) & set(B), {case.X[n] for n in B if n in case.pins and A[0] < 0}
    for (x, y, z), h in planes:
        a, b = ([x * p[0] + y * p[1] + z * p[2] - h for p in case.at(s)] for s in (A, B))
        if not (max(a, default=0) <= 0 <= min(b, default=0) or max(b, default=0) <= 0 <= min(a, default=0)):
            return False
        A, B = [t for t, value in zip(A, a) if not value], [t for t, value in zip(B, b) if not value]
    return any(set(s) == common or any({case.X[t] for t in s} == {p} for p in pinched) for s in (A, B))
def listed_planes(case, normal, planes):  # as (n, h); a name that does not exist separates nothing
    for kind, points in planes:
        need(all(p < 0 or p in case.N[p // 3] for p in points), "not-separated", "no such name")
        a, b, *c = case.at(points)
        n = sub(b, a) if kind == "n" else cross(sub(b, a), sub(c[0], a) if c else normal)
        yield n, dot(n, a)
def common_point(case, A, u, B, w, at):  # the carriers of the point that these weights give in both simplices
    x, y = mix(case.at(A), u), mix(case.at(B), w)
    need(all(x[k] * y[3] == y[k] * x[3] for k in range(3)), "wrong-point", at)
    return [{t for t, z in zip(*pair) if z} for pair in ((A, u), (B, w))]
def check_contacts(case, name, facts, certified):
    """A is a mesh triangle, B one too, a bottom or top triangle, or a tet (`i2`, with its dot: {B: dot})."""
    T, i2, k = [tuple(~v for v in f) for f in case.T.faces], name == "i2", 2 * (name == "disjoint-top")
    layer = T if name == "disjoint-mesh" else [tuple(case.N[v][k] for v in f) for f in case.M.faces]
    others = lambda f, j: {t: case.dot(f, x) for t, x in case.tets(j).items()} if i2 else {layer[j]: 0}
    facts = [(f, j, *rest) if i2 else (f, j, layer[j], *rest) for f, j, *rest in facts]
    if certified: return check_separations(case, T, case.boxes if i2 else [box(case.at(B)) for B in layer], others,
                                           lambda f, j: i2 and case.clear(f, j) or layer is T and j <= f, facts)
    for f, j, B, u, w, *value in facts:
        dots, at = others(f, j), f"{f} {j}"
        need(B in dots, "unknown-tet", at)
        a, b = common_point(case, T[f], u, B, w, at)
        need(not i2 or case.equals(dots[B], *value), "wrong-value", at)
        pins = [mix(case.at(T[f]), u) == mix(case.at([n]), [sum(u)]) for n in B if n in case.pins]
        need(dots[B] <= 0 and a != b and not any(pins), "not-refuted", at)
def check_separations(case, T, boxes, others, skip, facts):
    lines, meets, own_boxes = [{} for _ in T], [[] for _ in T], [box(case.at(A)) for A in T]
    for f, j, B, planes in facts: lines[f][j, B] = planes
    for f, j in meeting(own_boxes, boxes, range(len(T)), range(len(boxes))): meets[f].append(j)
    for f, A in enumerate(T):
        wanted, own = set(), plane(*case.at(A))  # what the plane of A and those of B, each alone, do not separate
        for j in [j for j in meets[f] if not skip(f, j)]:
            for B in [B for B, value in others(f, j).items() if value <= 0 and meet(own_boxes[f], box(case.at(B)))]:
                planes = itertools.chain([own], (plane(*case.at(x)) for x in itertools.combinations(B, 3)))
                wanted |= set() if any(separates(case, [h], A, B) for h in planes) else {(j, B)}
        for j, B in sorted({*wanted, *lines[f]}):
            need((j, B) in wanted, "superfluous", f"{f} {j}")
            need((j, B) in lines[f], "missing-separation", f"{f} {j}")
            need(separates(case, listed_planes(case, own[0], lines[f][j, B]), A, B), "not-separated", f"{f} {j}")

# ---- section 3.7: the tets share nothing but common faces
def check_prisms(case, S, facts):
    check_positive(case, S)
    count = collections.Counter(face for tets in S for names in tets for face in itertools.combinations(names, 3))
    skin = sorted(face for face, times in count.items() if times == 1)
    need(all(j < len(skin) for _, j, _ in facts), "superfluous", f"the skin has {len(skin)} triangles")
    check_separations(case, skin, [box(case.at(B)) for B in skin], lambda _, j: {skin[j]: 0},
                      lambda i, j: j <= i, [(i, j, skin[j], planes) for i, j, planes in facts])
    at_side = collections.defaultdict(list)
    for i, side in [(i, side) for i, A in enumerate(skin) for side in itertools.combinations(A, 2)]:
        at_side[side].append(i)
    across = lambda i: [at_side[x] for x in itertools.combinations(skin[i], 2) if len(at_side[x]) == 2]
    for i in sorted(set(parts(range(len(skin)), lambda i: chain(across(i))).values())):
        carriers = all_carriers(case, S, mix(case.at(skin[i]), (1, 1, 1)))
        need(carriers == {skin[i]}, "overlap", f"the middle of triangle {i} of the skin")
def check_overlap(case, S, word, facts):
    if word == "tet": check_tet(case, facts, S[facts[0]])
    for k, (A, u, B, w) in enumerate(facts if word == "overlap" else ()):
        need(find_tet(case, S, A) and find_tet(case, S, B), "unknown-tet")
        a, b = common_point(case, A, u, B, w, f"line {k}")
        need(a != b, "not-refuted", f"line {k}")

# ---- all claims in order
def check_claims(case, cert):
    order, blocks = cert.order or range(len(case.N)), cert.blocks
    S, certified = case.decomposition(order), lambda name: cert.claims.get(name) == "certified"
    if certified("positivity"): check_positive(case, map(case.tets, range(len(case.M.faces))))
    for fact in blocks.get("positivity", ()): check_tet(case, fact, case.tets(fact[0]))
    if "overlay" in blocks: K = check_overlay(case, S, *blocks["overlay"])
    if "no-section" in blocks: check_witness(case, S, *blocks["no-section"][1])
    if certified("section-all-orders"): check_all_orders(case, *K)
    if "no-order" in blocks:
        first, witness = blocks["no-order"]
        check_witness(case, case.decomposition(dict.fromkeys([*first, *order])), *witness)
    for name in CLAIMS[4:8]:
        if name in blocks: check_contacts(case, name, blocks[name], certified(name))
    if certified("disjoint-prisms"): check_prisms(case, S, blocks["disjoint-prisms"])
    elif "disjoint-prisms" in blocks: check_overlap(case, S, *blocks["disjoint-prisms"])
def judge(paths):
    cert = Certificate(certificate_bytes(paths, "check.py CERT INPUT..."))
    check_claims(bind(cert, *sound_inputs(paths[1:], cert.mesh is not None)), cert)
    return "\n".join(["valid"] + [f"{name} {verdict}" for name, verdict in cert.claims.items()])
run = functools.partial(answer, judge)  # the exit code and the text to print

if __name__ == "__main__": main(run)
