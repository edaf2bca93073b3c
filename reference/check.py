#!/usr/bin/env python3
"""Second, independent checker of homeo certificates: python3 check.py CERT INPUT...

It follows certs/FORMAT.md (version 1), section by section, and uses only the standard library: this file
holds the rules (section 3), reading.py the files (sections 2, 5, 6), shapes.py the words (section 1).
Every decision is made on Python integers: all coordinates are scaled by one common power of two.
A shell name is the integer 3 * vertex + layer (b 0, m 1, t 2): names are ordered as these integers are.
Exit codes: 0 valid, 1 invalid, 2 malformed, 3 limit reached.
"""
import hashlib
import itertools
import math
import struct
import sys

from reading import Certificate, Stop, distinct, need, read_file, read_inputs
from shapes import Case, box, box_tree, cross, det, det3, dot, meet, meeting, plane, sub

# ------------------------------------------------- section 3: binding
def sha(layers, faces):
    digest = hashlib.sha256()
    for points in layers:
        digest.update(struct.pack(f"<{3 * len(points)}d", *itertools.chain(*points)))
    digest.update(struct.pack(f"<{3 * len(faces)}I", *itertools.chain(*faces)))
    return digest.hexdigest()

def bind(cert, layers, prisms, mesh):
    """Section 3, binding: the inputs are those that the certificate names, and fit to be judged."""
    points, triangles = mesh
    need(cert.shell == [sha(layers, prisms), len(layers[0]), len(prisms)], "hash", "shell")
    if cert.mesh:
        need(cert.mesh == [sha([points], triangles), len(points), len(triangles)], "hash", "mesh")
    case = Case(layers, prisms, points, triangles if cert.mesh else [])
    pins = [sum(v in case.pin for v in f) for f in prisms]
    need(case.M.manifold() and max(pins) < 3, "shell-conditions")
    need(not cert.mesh or case.T.manifold() and all(any(n) for n, _ in case.planes), "mesh-conditions")
    need(cert.pinched == [8 * sum(pins)] + case.pinned, "pinched")
    case.prepare()
    return case

# ------------------------------------------------- section 3.1: positivity
def check_refuted_tet(case, fact, tets):
    prism, names, value = fact
    need(names in tets, "unknown-tet", f"prism {prism}")
    volume = case.volume(tets[names])
    need(case.equals(volume, value), "wrong-value", f"prism {prism}")
    need(volume <= 0, "not-refuted", f"prism {prism}")

def check_positivity(case, facts):
    for fact in facts or ():
        check_refuted_tet(case, fact, case.tets(fact[0]))
    for prism in range(0 if facts else len(case.M.faces)):
        need(all(case.volume(t) > 0 for t in case.tets(prism).values()), "not-positive", f"prism {prism}")

# ------------------------------------------------- section 3.2: the overlay
def one_point(columns):
    """The solution of a homogeneous system when its space is a line, else None (Bareiss's elimination)."""
    rows, pivots, last, n = [list(r) for r in zip(*columns)], [], 1, len(columns)
    for c in range(n):
        k = len(pivots)
        r = next((r for r in range(k, 4) if rows[r][c]), None)
        if r is None:
            continue
        rows[k], rows[r] = rows[r], rows[k]
        p = rows[k][c]
        for i in range(4):
            if i != k:
                q = rows[i][c]
                rows[i] = [(p * x - q * y) // last for x, y in zip(rows[i], rows[k])]
        pivots.append(c)
        last = p
    if len(pivots) != n - 1:
        return None
    free = next(c for c in range(n) if c not in pivots)
    solution = [last] * n
    for k, c in enumerate(pivots):
        solution[c] = -rows[k][free]
    return solution

def holders(case, S, names):
    """The tets of S that hold all the names, as (prism, names)."""
    return [(j, t) for j in case.M.at.get(names[0] // 3, ()) for t in S[j] if set(names) <= set(t)]

def overlay_vertex(case, S, ids, names, at):
    T = case.T
    edge = ids in T.edge or ids[::-1] in T.edge
    need([ids[0] in T.at, edge, ids in T.find][len(ids) - 1], "mesh-carrier", at)
    need(holders(case, S, names), "shell-carrier", at)
    need(not case.cap(names), "cap", at)
    columns = [case.G[i] + (1,) for i in ids] + [tuple(-x for x in case.P[n]) + (-1,) for n in names]
    solution = one_point(columns)
    total = sum(solution[:len(ids)]) if solution else 0
    need(total, "no-point", at)
    common = math.gcd(*solution) if total > 0 else -math.gcd(*solution)
    solution = [x // common for x in solution]
    need(min(solution) > 0, "outside-carrier", at)
    on_mesh, on_middle = dict(zip(ids, solution)), {}
    for n, x in zip(names, solution[len(ids):]):
        on_middle[n // 3] = on_middle.get(n // 3, 0) + x
    return on_mesh, on_middle, frozenset(names)

def rows(weights, corners):
    return [[w.get(x, 0) for x in corners] for w in weights]

class Overlay:
    """The complex K: `cells` as (f, prism, rows in f, rows in the prism), `rim` its boundary edges."""

    def __init__(self, case, S, facts):
        vertices, cells, named = facts
        for j, tets in enumerate(S):
            need(all(case.volume(t) > 0 for t in tets.values()), "not-positive", f"prism {j}")
        self.points = K = [overlay_vertex(case, S, *v, f"v line {i}") for i, v in enumerate(vertices)]
        self.cells = [self.cell(case, S, c, f"c line {i}") for i, c in enumerate(cells)]
        edges = set()
        for c in cells:
            for i in range(1, len(c) - 1):
                for e in ((c[0], c[i]), (c[i], c[i + 1]), (c[i + 1], c[0])):
                    need(e not in edges, "edge-twice", f"{e}")
                    edges.add(e)
        self.rim = [(a, b) for a, b in edges if (b, a) not in edges]
        for a, b in self.rim:
            on_mesh, on_middle = (K[a][k].keys() | K[b][k].keys() for k in (0, 1))
            need(on_mesh in case.T.rim and on_middle in case.M.rim, "boundary", f"{a} {b}")
        need(len(set(itertools.chain(*cells))) == len(K), "isolated")
        for side, over in enumerate((case.T, case.M)):
            found = [over.component[self.cells[cell][side]] for cell, _ in named[side]]
            need(found == list(range(over.count)), "degree-component")
        for side in (0, 1):
            self.degree(side, named[side])

    def cell(self, case, S, cell, at):
        weights = [self.points[i] for i in cell]
        f = case.T.find.get(tuple(sorted(set().union(*(w[0] for w in weights)))))
        need(f is not None, "cell-mesh", at)
        j = case.M.find.get(tuple(sorted(set().union(*(w[1] for w in weights)))))
        names = set().union(*(w[2] for w in weights))
        need(j is not None and any(names <= set(t) for t in S[j]), "cell-shell", at)
        in_f = rows((w[0] for w in weights), case.T.faces[f])
        in_j = rows((w[1] for w in weights), case.M.faces[j])
        for i in range(1, len(cell) - 1):
            need(det3(in_f[0], in_f[i], in_f[i + 1]) > 0, "area-mesh", at)
            need(det3(in_j[0], in_j[i], in_j[i + 1]) > 0, "area-middle", at)
        return f, j, in_f, in_j

    def degree(self, side, named):
        over = {}
        for i, c in enumerate(self.cells):
            over.setdefault(c[side], []).append(i)
        for cell, triangle in named:
            c = self.cells[cell]
            abc = [c[2 + side][i] for i in (0, triangle + 1, triangle + 2)]
            a, b, c = (sum(r) for r in abc)
            centre = [x * b * c + y * a * c + z * a * b for x, y, z in zip(*abc)]
            for other in over[self.cells[cell][side]]:
                r = self.cells[other][2 + side]
                for i in range(1, len(r) - 1):
                    inside = (det3(centre, r[i], r[i + 1]) >= 0 and det3(r[0], centre, r[i + 1]) >= 0
                              and det3(r[0], r[i], centre) >= 0)
                    need(not inside or (other, i - 1) == (cell, triangle), "degree", f"d line of cell {cell}")

# ------------------------------------------------- section 3.3: all orders
def clip(polygon, planes, corners):
    """Cuts a polygon (barycentric rows on three corners) with closed half-spaces."""
    for n, h in planes:
        values = [dot(n, p) - h for p in corners]
        if min(values) >= 0:
            continue
        side, kept = [dot(values, r) for r in polygon], []
        for (p, x), (q, y) in zip(zip(polygon, side), zip(polygon[1:] + polygon[:1], side[1:] + side[:1])):
            kept += [p] if x >= 0 else []
            if x * y < 0:
                new = [abs(y) * s + abs(x) * t for s, t in zip(p, q)]
                common = math.gcd(*new)
                kept.append([s // common for s in new])
        polygon = kept
    return polygon

def check_all_orders(case, K):
    for a, b in K.rim:
        names, (u, w) = K.points[a][2] | K.points[b][2], K.points[a][1].keys() | K.points[b][1].keys()
        walls = [{*case.N[u][s:s + 2], *case.N[w][s:s + 2]} for s in (0, 1)]
        flat = [len(x) < 4 or not det(*(case.P[n] for n in x)) for x in walls]
        good = names <= {3 * u + 1, 3 * w + 1} or any(names <= x and z for x, z in zip(walls, flat))
        need(good, "all-orders-boundary", f"edge {a} {b}")
    for number, (f, j, r, _) in enumerate(K.cells):
        corners = [case.G[v] for v in case.T.faces[f]]
        for side in (None,) + case.M.sides(j):
            q = j if side is None else case.M.edge.get(side[::-1])
            if q is not None and case.clear(f, q):
                continue
            pieces = [[r[0], r[i], r[i + 1]] for i in range(1, len(r) - 1)]
            if side:
                walls = [{*case.N[side[0]][s:s + 2], *case.N[side[1]][s:s + 2]} for s in (0, 1)]
                walls = [x for x in walls if len(x) == 4 and det(*(case.P[n] for n in x))]
                pieces = [clip(p, case.faces(x), corners) for x in map(list, walls) for p in pieces]
            steep = [] if q is None else [t[0] for t in case.tets(q).values() if case.sign(f, t) <= 0]
            # At a boundary side no prism takes over what is in the wall tets.
            parts = pieces if q is None else [clip(p, case.faces(t), corners) for t in steep for p in pieces]
            flat = all(not det3(p[0], p[i], p[i + 1]) for p in parts for i in range(1, len(p) - 1))
            need(flat, "all-orders", f"cell {number}, prism {j if q is None else q}")

# ------------------------------------------------- section 3.4: the no-lift witness
class Witness:
    def __init__(self, case, S, witness):
        self.case, self.S, (word, facts) = case, S, witness
        self.stars = {}
        if word == "tet":
            check_refuted_tet(case, facts, S[facts[0]])
        elif word == "topology":
            values = [x.euler() if facts[0] == "euler" else x.count for x in (case.T, case.M)]
            need(values == facts[1:], "wrong-value")
            need(values[0] != values[1], "not-refuted")
        else:
            self.roots(facts)

    def tet(self, names):
        """Whether a tet of S is positive; stops when it is none of S."""
        prism = self.case.M.find.get(tuple(sorted({n // 3 for n in names})))
        need(prism is not None and names in self.S[prism], "unknown-tet", self.at)
        return self.case.volume(self.S[prism][names]) > 0, prism

    def coordinates(self, x, prism, names):
        """{name: positive coordinate} of x = (x, y, z, w) in a tet; None outside or in a bad tet."""
        order = self.S[prism][names][0]
        if not self.case.volume((order,)) > 0:
            return None
        a, b, c, d = ([x[3] * p - q for p, q in zip(self.case.P[n], x)] for n in order)
        values = det3(b, c, d), -det3(a, c, d), det3(a, b, d), -det3(a, b, c)
        return {n: v for n, v in zip(order, values) if v} if min(values) >= 0 else None

    def point(self, f, weights):
        corners = self.case.T.faces[f]
        return (self.case.mix([self.case.G[v] for v in corners], weights),
                {v: w for v, w in zip(corners, weights) if w})

    def injective_star(self, edge):
        """Whether the open wedges around a shell edge of S's tets are disjoint."""
        if edge not in self.stars:
            positive, wedges, p, q = True, [], *(self.case.P[n] for n in edge)
            for prism, names in holders(self.case, self.S, edge):
                r, s = (self.case.P[n] for n in names if n not in edge)
                wedges.append((r, s) if det(p, q, r, s) > 0 else (s, r))
                positive &= self.case.volume(self.S[prism][names]) > 0
            apart = lambda x, y: (all(det(p, q, x[0], z) <= 0 for z in y)
                                  or all(det(p, q, z, x[1]) <= 0 for z in y))
            pairs = itertools.combinations(wedges, 2)
            self.stars[edge] = positive and all(apart(x, y) or apart(y, x) for x, y in pairs)
        return self.stars[edge]

    def roots(self, facts):
        landed = set()
        for (f, *weights), branches in facts:
            self.at = f"root on triangle {f}"
            x, on_mesh = self.point(f, weights)
            carriers, w = set(), x[3]
            for prism, b in enumerate(self.case.prism_boxes):
                if all(b[k] * w <= x[k] <= b[k + 3] * w for k in range(3)):
                    found = [self.coordinates(x, prism, names) for names in self.S[prism]]
                    carriers |= {tuple(sorted(c)) for c in found if c}
            need(carriers == {names for names, _, _ in branches}, "wrong-branches", self.at)
            for names, legs, reason in branches:
                ends = [self.leg(f, x, on_mesh, names, leg) for leg in legs]
                need(self.holds(reason, ends), "not-refuted", self.at)
                if reason == "lands":
                    landed.add(self.case.M.component[ends[0][3]])
        need(distinct([self.case.T.component[head[0]] for head, _ in facts]), "wrong-branches")
        need(len(landed) < len(facts), "not-refuted")

    def leg(self, f, x, on_mesh, branch, leg):
        """Walks a leg; its last station as (f, point of T, coordinates in the tet, prism, tet)."""
        tet, steps = leg
        positive, prism = self.tet(tet)
        need(positive and set(branch) <= set(tet), "wrong-step", self.at)
        here = self.coordinates(x, prism, tet)
        for g, *weights, new in steps:
            positive, next_prism = self.tet(new)
            x, on_mesh = self.point(g, weights)
            need(positive and on_mesh.keys() <= set(self.case.T.faces[f]), "wrong-step", self.at)
            before, after = self.coordinates(x, prism, tet), self.coordinates(x, next_prism, new)
            need(before and after and before.keys() == after.keys(), "wrong-step", self.at)
            for c in (here, after):
                good = len(c) > 2 or len(c) == 2 and self.injective_star(tuple(sorted(c)))
                need(good, "wrong-step", self.at)
            f, tet, prism, here = g, new, next_prism, after
        return f, on_mesh, here, prism, tet

    def holds(self, reason, ends):
        case, (f, on_mesh, here, prism, tet) = self.case, ends[0]
        on_rim = frozenset(on_mesh) in case.T.rim
        on_wall = frozenset(n // 3 for n in here) in case.M.rim
        if reason == "cap":
            return case.cap(list(here))
        if reason in ("wall", "boundary"):
            return (on_wall, on_rim) == (reason == "wall", reason == "boundary")
        if reason == "fold":
            n, h = case.planes[f]
            flat = len(here) == 3 and all(dot(n, case.P[c]) == h for c in here)
            return len(on_mesh) == 3 and case.sign(f, self.S[prism][tet]) <= 0 and (len(here) == 4 or flat)
        if reason == "lands":
            return True
        same_point = same_map(*(end[1] for end in ends))
        if reason == "monodromy":
            return same_point and ends[0][2].keys() != ends[1][2].keys()
        return not same_point and same_map(*(projected(end[2]) for end in ends))

def projected(coordinates):
    sums = {}
    for n, x in coordinates.items():
        sums[n // 3] = sums.get(n // 3, 0) + x
    return sums

def same_map(a, b):
    x, y = sum(a.values()), sum(b.values())
    return a.keys() == b.keys() and all(a[k] * y == b[k] * x for k in a)

# ------------------------------------------------- sections 3.5 and 3.6: separation and contact
def separates(planes, A, B, harmless):
    """Section 3.5, for lists of (tag, point) and planes (n, h)."""
    for (x, y, z), h in planes:
        a = [x * p[0] + y * p[1] + z * p[2] - h for _, p in A]
        b = [x * p[0] + y * p[1] + z * p[2] - h for _, p in B]
        if not (max(a, default=0) <= 0 <= min(b, default=0) or max(b, default=0) <= 0 <= min(a, default=0)):
            return False
        A, B = [q for q, v in zip(A, a) if not v], [q for q, v in zip(B, b) if not v]
    return harmless(A) or harmless(B)

def listed_planes(case, f, planes):
    """The planes of a `sep` or `contact-sep` line as (n, h); None when a point's name does not exist."""
    found = []
    for kind, points in planes:
        if any(k == "s" and n not in case.N[n // 3] for k, n in points):
            return None
        a, b, *c = (case.G[n] if k == "g" else case.P[n] for k, n in points)
        n = sub(b, a)
        if kind != "n":
            n = cross(n, sub(c[0], a)) if c else cross(n, case.planes[f][0])
        found.append((n, dot(n, a)))
    return found

def pinched_rest(case, vertices):
    pins = {case.P[3 * v] for v in vertices if v in case.pin}
    return lambda rest: not rest or len(rest) == 1 and rest[0][1] in pins

def check_disjoint(case, name, facts, certified):
    layer, on_mesh = 2 * (name == "disjoint-top"), name == "disjoint-mesh"
    G, P, T = case.G, case.P, case.T.faces
    left = [[(v, G[v]) for v in f] for f in T]
    right = left if on_mesh else [[(v, P[3 * v + layer]) for v in f] for f in case.M.faces]
    if not certified:
        for i, j, *w in facts:
            x = case.mix([p for _, p in left[i]], w[:3])
            need(case.same(x, case.mix([p for _, p in right[j]], w[3:])), "wrong-point", f"{i} {j}")
            a, b = ({v for (v, _), z in zip(s, z3) if z} for s, z3 in ((left[i], w[:3]), (right[j], w[3:])))
            need(a != b if on_mesh else len(b) > 1 or not b <= case.pin, "not-refuted", f"{i} {j}")
        return
    boxes = [box([p for _, p in s]) for s in right]
    planes = [plane(*(p for _, p in s)) for s in right]
    tree, listed = box_tree(boxes, list(range(len(boxes)))), {}
    for (i, j), lines in facts:
        listed.setdefault(i, {})[j] = lines
    for i, A in enumerate(left):
        lines, meets = listed.get(i, {}), set(meeting(tree, boxes, case.mesh_boxes[i]))
        for j in sorted(meets.union(lines)):
            if on_mesh and j <= i:
                continue
            need(j in meets, "superfluous", f"{i} {j}")
            B, pair = right[j], f"{i} {j}"
            common = {v for v, _ in A} & {v for v, _ in B}
            harmless = (lambda rest: {v for v, _ in rest} == common) if on_mesh else \
                pinched_rest(case, case.M.faces[j])
            alone = separates([case.planes[i]], A, B, harmless) or separates([planes[j]], A, B, harmless)
            need(not alone or j not in lines, "superfluous", pair)
            need(alone or j in lines, "missing-separation", pair)
            if not alone:
                given = listed_planes(case, i, lines[j])
                need(given is not None and separates(given, A, B, harmless), "not-separated", pair)

def check_contacts(case, facts):
    for f, prism, names, *w, value in facts:
        at, tets = f"{f} {prism}", case.tets(prism)
        need(names in tets, "unknown-tet", at)
        x = case.mix([case.G[v] for v in case.T.faces[f]], w[:3])
        need(case.same(x, case.mix([case.P[n] for n in names], w[3:])), "wrong-point", at)
        need(case.equals(case.sign(f, tets[names]), value), "wrong-value", at)
        used = {n // 3 for n, z in zip(names, w[3:]) if z}
        pinched = sum(z > 0 for z in w[3:]) == 1 and used <= case.pin
        need(case.sign(f, tets[names]) <= 0 and not pinched, "not-refuted", at)

def check_apart(case, facts):
    listed, boxes = {}, case.prism_boxes
    for (f, prism, names), lines in facts:
        listed.setdefault(f, {}).setdefault(prism, {})[names] = lines
    tree = box_tree(boxes, list(range(len(boxes))))
    for f, corners in enumerate(case.T.faces):
        A = [(v, case.G[v]) for v in corners]
        for prism in sorted({*meeting(tree, boxes, case.mesh_boxes[f]), *listed.get(f, ())}):
            lines = listed.get(f, {}).get(prism, {})
            open_tets = {} if case.clear(f, prism) else open_contacts(case, f, prism, A)
            for names in sorted({*lines, *open_tets}):
                at = f"{f} {prism} {names}"
                need(names in open_tets, "superfluous", at)
                need(names in lines, "missing-separation", at)
                given = listed_planes(case, f, lines[names])
                good = given is not None and separates(given, A, *open_tets[names])
                need(good, "not-separated", at)

def open_contacts(case, f, prism, A):
    """{names: (points, harmless)} of the prism's tets that f may touch with a dot that is not positive."""
    found = {}
    for names, tet in case.tets(prism).items():
        if case.sign(f, tet) <= 0:
            B, harmless = [(n, case.P[n]) for n in names], pinched_rest(case, [n // 3 for n in names])
            if meet(case.mesh_boxes[f], box([p for _, p in B])):
                if not any(separates([h], A, B, harmless) for h in (case.planes[f], *case.faces(names))):
                    found[names] = B, harmless
    return found

# ------------------------------------------------- all claims in order
def check_claims(case, cert):
    order = cert.order or range(len(case.N))
    claims, blocks = cert.claims, cert.blocks
    S = case.decomposition(order) if "section" in claims else None
    for name, verdict in claims.items():
        certified = verdict == "certified"
        if name == "positivity":
            check_positivity(case, blocks.get(name))
        elif name == "section" and certified:
            K = Overlay(case, S, blocks["overlay"])
        elif name == "section":
            Witness(case, S, blocks["no-section"][1])
        elif name == "section-all-orders" and certified:
            check_all_orders(case, K)
        elif "no-order" in blocks and name == "section-all-orders":
            first, witness = blocks["no-order"]
            others = dict.fromkeys(first + list(order))
            Witness(case, case.decomposition(list(others)), witness)
        elif name.startswith("disjoint"):
            check_disjoint(case, name, blocks[name], certified)
        elif name == "i2" and name in blocks:
            (check_apart if certified else check_contacts)(case, blocks[name])

def run(paths):
    """The exit code and the text to print."""
    try:
        need(paths, "usage", "check.py CERT INPUT...", "malformed")
        if hasattr(sys, "set_int_max_str_digits"):
            sys.set_int_max_str_digits(0)  # the grammar has limits of its own
        data = read_file(paths[0], "usage")
        need(data is not None, "size", "", "limit")
        cert = Certificate(data)
        case = bind(cert, *read_inputs(paths[1:], cert.mesh is not None))
        check_claims(case, cert)
        return 0, "\n".join(["valid"] + [f"{name} {verdict}" for name, verdict in cert.claims.items()])
    except Stop as stop:
        kind, code, why = stop.args
        why = " : " + why.replace("\n", " ") if why else ""
        return {"invalid": 1, "malformed": 2, "limit": 3}[kind], f"{kind} {code}{why}"
    except Exception as error:  # a last resort: never an answer, never `valid`
        return 3, f"limit internal : {type(error).__name__}"

if __name__ == "__main__":
    status, answer = run(sys.argv[1:])
    print(answer.encode("ascii", "backslashreplace").decode("ascii"))
    sys.exit(status)
