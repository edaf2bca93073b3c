#!/usr/bin/env python3
"""Second, independent checker of certificates about meshes: python3 check_meshes.py CERT A [B]

It follows certs/MESHES.md, version 1, whose sections are cited, and needs only the standard library. Coordinates are
multiplied by one common denominator if it is not too long: decisions are made on integers, else on fractions.
"""
import collections, functools, hashlib, itertools, math, re
from fractions import Fraction
from answer import answer, certificate_bytes, main
from certificate import DIGITS, ascending
from check import Stop, box, chain, cross, det3, dot, meet, meeting, mix, need, plane, sub
from inputs import WRONG, read_file, read_mesh

EXPONENTS, LINES = 2 ** 33, 1000

# ---- section 1: words
FACETS = {3: ((1, 2), (2, 0), (0, 1)), 4: ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))}
def way(facet):  # the same for facets that are the same way round
    return facet if len(facet) == 2 else min(facet, facet[1:] + facet[:1], facet[2:] + facet[:2])
def classes(items, groups):  # for each item the first one of its class; the members of a group are in one class
    first = {x: x for x in items}
    def find(x):
        while first[x] != x: first[x] = x = first[first[x]]
        return x
    for group in groups:
        for x in group[1:]:
            a, b = sorted((find(group[0]), find(x)))
            first[b] = a
    return {x: find(x) for x in first}
def by(key, items):  # lists of the items that have the same key
    found = collections.defaultdict(list)
    for x in items: found[key(x)].append(x)
    return found

class Complex:
    def __init__(self, space, k, points, cells):
        self.space, self.k, self.points, self.cells = space, k, points, cells
        self.full = k == space + 1
    def facet(self, f): return tuple(self.cells[f // self.k][i] for i in FACETS[self.k][f % self.k])
    def facets(self, c): return [self.facet(self.k * c + i) for i in range(self.k)]
    def sets(self, c): return set(map(frozenset, self.facets(c)))
    def at(self, ids): return [self.points[v] for v in ids]
    def star(self, ids): return [c for c, cell in enumerate(self.cells) if set(ids) <= set(cell)]
    def around(self, star, ids):  # classes of cells that are connected around a vertex or an edge
        shared = by(lambda pair: pair[1], [(c, s) for c in star for s in self.sets(c) if s.issuperset(ids)])
        return classes(star, [[c for c, _ in group] for group in shared.values()])
    def components(self):  # the smallest cell of each cell's component
        return self.around(range(len(self.cells)), ())
    def link_is_wrong(self, v, star):
        edges = {u for c in star for u in self.cells[c]} - {v}
        facets = collections.Counter(s for c in star for s in self.sets(c) if v in s)
        return len(edges) - len(facets) + len(star) != (1 if 1 in facets.values() else 2)
    def determinant(self, points):  # of a full complex
        a, *others = points
        return det3(*(sub(p, a) for p in others), *[(0, 0, 1)][self.space - 2:])
    def volume(self, c):  # nonzero unless the cell is flat; of a full complex, the determinant
        points = self.at(self.cells[c])
        return self.determinant(points) if self.full else int(any(plane(*points)[0]))
    def holds(self, c, x):  # whether a closed cell that is not flat holds a point
        points, whole = self.at(self.cells[c]), self.volume(c)
        return whole != 0 and all(self.determinant(points[:i] + [x] + points[i + 1:]) * whole >= 0 for i in range(self.k))
    def centroid(self, f):
        return tuple(Fraction(sum(x), self.k - 1) for x in zip(*self.at(self.facet(f))))
    @functools.cached_property
    def boundary(self):  # facets without their reverse, ascending
        ways = {way(f) for c in range(len(self.cells)) for f in self.facets(c)}
        return [f for f in range(self.k * len(self.cells)) if way(self.facet(f)[::-1]) not in ways]
    def boundary_parts(self):  # the smallest facet of each boundary facet's part
        faces = [(f, face) for f in self.boundary for face in itertools.combinations(sorted(self.facet(f)), self.k - 2)]
        return classes(self.boundary, [[f for f, _ in group] for group in by(lambda pair: pair[1], faces).values()])
    def check_sound(self):
        ways = [way(f) for c in range(len(self.cells)) for f in self.facets(c)]
        good = len(self.cells) > 0 and all(len(set(cell)) == self.k for cell in self.cells)
        good = good and len(set(map(frozenset, self.cells))) == len(self.cells) and len(set(ways)) == len(ways)
        need(good, "mesh-conditions")
        for size in range(1, self.k - 1):
            stars = by(lambda pair: pair[0], ((ids, c) for c, cell in enumerate(self.cells)
                                              for ids in itertools.combinations(sorted(cell), size)))
            for ids, pairs in stars.items():
                star = [c for _, c in pairs]
                need(len(set(self.around(star, ids).values())) == 1, "mesh-conditions", f"around {ids}")
                need(self.k == 3 or size == 2 or not self.link_is_wrong(ids[0], star), "mesh-conditions", f"link of {ids}")
    def check_solid(self):
        self.check_sound()
        self.check_not_flat()
    def check_not_flat(self):
        need(all(self.volume(c) for c in range(len(self.cells))), "mesh-conditions", "a flat cell")
    def topology(self):  # of each component: Euler characteristic and number of boundary loops
        part, parts = self.components(), self.boundary_parts()
        members = by(part.get, range(len(self.cells))).values()
        loops = collections.Counter(part[f // 3] for f in set(parts.values()))
        def euler(cells):
            vertices, edges = {v for c in cells for v in self.cells[c]}, set().union(*(self.sets(c) for c in cells))
            return len(vertices) - len(edges) + len(cells)
        return collections.Counter((euler(cells), loops[cells[0]]) for cells in members)

# ---- section 5: complex files, and other inputs
W, ID = "(?:0|[1-9][0-9]*)", "(?:0|[1-9][0-9]{0,9})"
NUMBER = re.compile(rf"(-?)({W})(?:\*2\^(-?[1-9][0-9]{{0,4}})|/({W}))?")
def fit(condition, why):
    if not condition: raise ValueError(why)
def number(text):  # value, |EXP|
    sign, digits, exponent, den = NUMBER.fullmatch(text).groups()
    fit(max(len(digits), len(den or "")) <= DIGITS, "digits")
    n, e, d = int(digits), int(exponent or 0), int(den or 1)
    if den: fit(d & (d - 1) and n and math.gcd(n, d) == 1, "fraction")  # 0 and 1 are powers of two here
    else: fit(n % 2 or text == "0", "even")
    n = -n if sign else n
    return (Fraction(n, d) if den else n << e if e >= 0 else Fraction(n, 1 << -e)), abs(e)
def read_complex(data):
    rows = iter(data.decode("ascii").split("\n"))
    stated = lambda word: int(re.fullmatch(f"{word} ({ID})", next(rows))[1])
    next(rows)
    space, k = stated("space"), stated("corners")
    fit((space, k) in ((2, 3), (3, 3), (3, 4)), "space and corners")
    points, cells, exponents = [], [], 0
    for _ in range(stated("vertices")):
        values = [number(text) for text in next(rows).split(" ")]
        fit(len(values) == space, "coordinates")
        exponents += sum(e for _, e in values)
        fit(exponents <= EXPONENTS, "exponents")
        points.append((*(x for x, _ in values), 0)[:3])
    for _ in range(stated("cells")):
        cells.append(tuple(int(re.fullmatch(ID, text)[0]) for text in next(rows).split(" ")))
        fit(len(cells[-1]) == k and max(cells[-1]) < len(points), "cell")
    fit(points and list(rows) == ["end", ""], "end")
    return Complex(space, k, points, cells)
def text_of(x):  # NUMBER of a double
    n, d = x.as_integer_ratio()
    e = (n & -n).bit_length() - 1 if n else 0
    return f"{n >> e}*2^{e}" if e else f"{n}*2^{1 - d.bit_length()}" if d > 1 else str(n)
def canonical(points, triangles):  # the complex file of a mesh of doubles
    yield f"homeo-complex 1\nspace 3\ncorners 3\nvertices {len(points)}\n"
    yield from (" ".join(map(text_of, p)) + "\n" for p in points)
    yield f"cells {len(triangles)}\n"
    yield from ("%d %d %d\n" % t for t in triangles)
    yield "end\n"
def read_input(path):  # Complex, hash
    data = read_file(path)
    if data.startswith(b"homeo-complex 1\n"): return read_complex(data), hashlib.sha256(data).hexdigest()
    points, triangles = read_mesh(data)
    fit(points and all(map(math.isfinite, chain(points))), "point")
    fit(all(0 <= v < len(points) for v in chain(triangles)), "index")
    sha = hashlib.sha256()
    for text in canonical(points, triangles): sha.update(text.encode())
    exact = lambda x: int(x) if x.is_integer() else Fraction(*x.as_integer_ratio())
    return Complex(3, 3, [tuple(map(exact, p)) for p in points], triangles), sha.hexdigest()
def scale(complexes):  # makes all coordinates integers, unless that would be too long
    common = 1
    for x in chain(chain(c.points for c in complexes)):
        if common % x.denominator: common = math.lcm(common, x.denominator)
        if common.bit_length() > 2500: return
    for c in complexes: c.points = [tuple(x.numerator * (common // x.denominator) for x in p) for p in c.points]

# ---- section 3: the certificate file
INT = "(?:0|-?[1-9][0-9]{0,9})"
CLAIMS = {"manifold": "a", "embedded": "a", "same-topology": "ab", "nested": "ab", "nested-topology": "ab", "pl-homeomorphism": "ab"}
DEFECTS = {"repeated": "c", "twin": "cc", "direction": "cc", "facet": "Fccc", "vertex": "vcc", "edge": "Ecc", "link": "v", "flat": "c"}
OWN = {"embedded": {"cross": ""}, "nested": {"open": "vw", "cross": "", "winding": ""},
       "pl-homeomorphism": {"sign": "cC", "twice": "fd", "cross": ""}}
Stated = collections.namedtuple("Stated", "sha space k vertices cells")

class Certificate:
    def __init__(self, data):
        self.row, self.inputs, self.blocks = 1, {}, {}
        self.ok(not re.search(rb"[^\n\x20-\x7e]", data), "bytes")
        self.ok(data == b"end\n" or data.endswith(b"\nend\n"), "truncated")
        self.rows = data.decode("ascii").split("\n")[:-1]
        self.ok(self.rows[0] == "homeo-meshes 1", "magic")
        self.claim, verdict = self.line(f"claim ({'|'.join(CLAIMS)}) (certified|refuted)")
        self.certified, both = verdict == "certified", CLAIMS[self.claim]
        self.ok(not self.certified or self.claim != "nested-topology", "claims")
        for x in both:
            sha, *numbers = self.line(f"input {x} ([0-9a-f]{{64}}) ([23]) ([34]) ({ID}) ({ID})")
            self.inputs[x] = Stated(sha, *map(int, numbers))
        self.ok(self.fitting(), "claims")
        counts = []
        for name in self.plan():
            self.line(f"begin {name}")
            self.blocks[name] = list(self.rays() if name == "rays" else self.witness() if name == "witness" else self.planes(name))
            counts.append(str(len(self.blocks[name])))
        self.ok(self.line(f"counts((?: {ID})*)")[0].split() == counts, "counts")
        self.line("end")
        self.ok(self.row == len(self.rows))
    def ok(self, condition, code="syntax", kind="malformed"): need(condition, code, f"line {self.row}", kind)
    def ahead(self): return self.rows[self.row].split(" ") if self.row < len(self.rows) else [""]
    def line(self, pattern):
        text, self.row = " ".join(self.ahead()), self.row + 1
        match = re.fullmatch(pattern, text)
        self.ok(match)
        return match.groups()
    def ranges(self, *values):
        self.ok(all(value < bound for value, bound in values), "range")
    def fitting(self):  # whether the inputs are what the claim is about
        kinds = [(x.space, x.k) for x in self.inputs.values()]
        same = len({x[2:] for x in self.inputs.values()}) == 1
        if self.claim == "same-topology": return all(k == 3 for _, k in kinds)
        if self.claim in ("manifold", "pl-homeomorphism"): return (2, 4) not in kinds and same
        return set(kinds) == {(3, 3)}
    def plan(self):
        if self.claim in ("same-topology", "nested-topology"): return []
        if not self.certified: return ["witness"]
        return {"manifold": [], "embedded": ["a"], "nested": ["a", "b", "between", "rays"]}.get(self.claim, ["a", "b"])
    def planes(self, name):  # (i, j), planes as (kind, ((input, vertex) ..))
        point, last = (f"[{name}]{ID}", "[ab]" + ID)[name == "between"], (-1, -1)
        left, right = (self.inputs[x] for x in ("ab" if name == "between" else name * 2))
        faces = lambda x: x.cells * (x.k if x.space < x.k else 1)
        while self.ahead()[0] == "sep" and (left.space == 3 or name == "between"):
            i, j, planes = self.line(f"sep ({ID}) ({ID})((?: (?:p:{point},{point},{point}|[ln]:{point},{point}))+)")
            pair = int(i), int(j)
            self.ok(last < pair and (name == "between" or pair[0] < pair[1]))
            last, planes = pair, [(p[0], [(q[0], int(q[1:])) for q in p[2:].split(",")]) for p in planes.split()]
            self.ranges((pair[0], faces(left)), (pair[1], faces(right)),
                        *((v, self.inputs[x].vertices) for _, points in planes for x, v in points))
            yield pair, planes
    def ray(self, word, letter="[ab]"):  # input, vertex, direction, triangles
        x, v, *d, cells = self.line(f"{word} ({letter}) ({ID})" + f" ({INT})" * 3 + f"((?: {ID})*)")
        d, cells, (other,) = list(map(int, d)), list(map(int, cells.split())), set("ab") - {x}
        self.ok(any(d) and ascending(cells))
        self.ranges((int(v), self.inputs[x].vertices), *((c, self.inputs[other].cells) for c in cells))
        return x, int(v), d, cells
    def rays(self):
        for x in "ab":
            many = 0
            while many == 0 or self.ahead()[:2] == ["ray", x]:
                yield self.ray("ray", x)
                many += 1
    def witness(self):  # word, input, facts
        words = {**DEFECTS, **OWN.get(self.claim, {})}
        if self.inputs["a"].k == 3: del words["edge"], words["link"]
        for many in range(LINES):
            word = self.ahead()[0]
            if many and word not in words: break
            self.ok(word in words)
            if word == "winding": yield word, "", self.ray(word)
            elif word == "cross": yield word, "", self.cross()
            else: yield self.fact(word, words[word])
    def cross(self):
        k, both = self.inputs["a"].k, "".join(self.inputs) + ("|ab" if self.claim == "nested" else "")
        weights = lambda: f"((?: {W}){{{k}}})"
        x, i, j, *both = self.line(f"cross ({'ab|[ab]' if '|' in both else f'[{both}]'}) ({ID}) ({ID})" + weights() + weights())
        self.ok((x == "ab" or int(i) < int(j)) and all(set(w.split()) != {"0"} for w in both))
        self.ok(max(map(len, chain(w.split() for w in both))) <= DIGITS, "digits", "limit")
        self.ranges((int(i), self.inputs[x[0]].cells), (int(j), self.inputs[x[-1]].cells))
        return x, (int(i), int(j)), [list(map(int, w.split())) for w in both]
    def fact(self, word, kinds):  # ids of kinds c, C (cell, not below), d (cell), v, w (vertex), f (facet), F, E (IDS)
        stars = {"F": self.inputs["a"].k - 1, "E": 2}
        field = lambda kind: f"({ID}(?:,{ID}){{{stars[kind] - 1}}})" if kind in stars else f"({ID})"
        x, *ids = self.line(f"{word} ([{''.join(self.inputs)}]) " + " ".join(map(field, kinds)))
        stated, ids = self.inputs[x], [list(map(int, text.split(","))) for text in ids]
        cells = [i[0] for i, kind in zip(ids, kinds) if kind in "cC"]
        self.ok(ascending(cells) or word == "sign" and cells[0] == cells[1])
        self.ok(all(map(ascending, ids)) and (word not in ("sign", "twice") or stated.space < stated.k))
        bound = {**dict.fromkeys("cCd", stated.cells), **dict.fromkeys("vwFE", stated.vertices), "f": stated.cells * stated.k}
        self.ranges(*((i, bound[kind]) for some, kind in zip(ids, kinds) for i in some))
        return word, x, [some if kind in stars else some[0] for some, kind in zip(ids, kinds)]

# ---- section 4.4: separation
def separates(planes, A, B):  # A, B: {(input, vertex): point}; planes as (normal, height)
    common = A.keys() & B.keys()
    for n, h in planes:
        a, b = ({t: dot(n, p) - h for t, p in s.items()} for s in (A, B))
        low = lambda s: all(value <= 0 for value in s.values())
        high = lambda s: all(value >= 0 for value in s.values())
        if not (low(a) and high(b) or high(a) and low(b)): return False
        A, B = ({t: p for t, p in s.items() if not values[t]} for s, values in ((A, a), (B, b)))
    return common in (A.keys(), B.keys())
def equations(case, planes, normal):
    for kind, points in planes:
        a, b, *c = (case[x].points[v] for x, v in points)
        n = {"p": lambda: cross(sub(b, a), sub(c[0], a)), "l": lambda: cross(sub(b, a), normal), "n": lambda: sub(b, a)}[kind]()
        yield n, dot(n, a)
def check_separation(case, lines, left, right):  # left, right: (input, {number: vertices})
    (x, A), (y, B), same = left, right, left is right
    A, B = ({i: {(z, v): case[z].points[v] for v in face} for i, face in C.items()} for z, C in (left, right))
    numbers, lines = (list(A), list(B)), dict(lines)
    boxes = [[box(list(face.values())) for face in C.values()] for C in (A, B)]
    found = meeting(*boxes, range(len(A)), range(len(B)))
    pairs = {(numbers[0][i], numbers[1][j]) for i, j in found if not same or i < j}
    for pair in sorted(pairs | lines.keys()):
        need(pair in pairs, "superfluous", f"{pair}: boxes")
        a, b = A[pair[0]], B[pair[1]]
        planes = [plane(*a.values()), plane(*b.values())]
        alone = any(separates([p], a, b) for p in planes)
        need(not alone or pair not in lines, "superfluous", f"{pair}")
        need(alone or pair in lines, "missing-separation", f"{pair}")
        need(alone or separates(equations(case, lines[pair], planes[0][0]), a, b), "not-separated", f"{pair}")
def triangles(case, x): return x, dict(enumerate(case[x].cells))
def check_embedded(case, lines, x):
    faces = triangles(case, x)
    check_separation(case, lines, faces, faces)
def share(p, q, r, s, A, B):  # whether the edges A = (p, q), B = (r, s) in the plane share a point that is no common vertex
    wedge = lambda a, b: a[0] * b[1] - a[1] * b[0]
    d, e, f = sub(q, p), sub(s, r), sub(r, p)
    if wedge(d, e):
        t, u = Fraction(wedge(f, e), wedge(d, e)), Fraction(wedge(f, d), wedge(d, e))
        if not (0 <= t <= 1 and 0 <= u <= 1): return False
        return not (t in (0, 1) and u in (0, 1) and A[int(t)] == B[int(u)])
    low, high = max(min(p, q), min(r, s)), min(max(p, q), max(r, s))
    if wedge(d, f) or low > high: return False
    names = [{name for point, name in zip(points, edge) if point == low} for points, edge in (((p, q), A), ((r, s), B))]
    return low != high or not names[0] & names[1]

# ---- section 4.3: rays
def ray_meets(o, d, corners):  # None: not at all; 0: not properly; else the sign of normal . d
    (p, q, r), (n, h) = corners, plane(*corners)
    u, v, f, slope = sub(q, p), sub(r, p), sub(o, p), dot(n, d)
    if slope:  # o + t d = p + x u + y v, all times slope
        sign = 1 if slope > 0 else -1
        t, x, y = -dot(n, f) * sign, det3(f, v, d) * sign, det3(u, f, d) * sign
        z = slope * sign - x - y
        if min(t, x, y, z) < 0: return None
        return sign if min(t, x, y, z) > 0 else 0
    if dot(n, o) != h: return None
    low, high = 0, math.inf  # the part of the ray on the inner side of each edge
    for a, b in ((p, q), (q, r), (r, p)):
        inward = cross(n, sub(b, a))
        height, rise = dot(inward, sub(o, a)), dot(inward, d)
        if rise > 0: low = max(low, Fraction(-height, rise))
        elif rise < 0: high = min(high, Fraction(-height, rise))
        elif height < 0: return None
    return 0 if low <= high else None
def ray_number(case, ray):
    x, v, d, listed = ray
    other, o, met, number = case["ab"[x == "a"]], case[x].points[v], [], 0
    span = (*(-math.inf if k < 0 else y for y, k in zip(o, d)), *(math.inf if k > 0 else y for y, k in zip(o, d)))
    for c, cell in enumerate(other.cells):
        corners = other.at(cell)
        found = ray_meets(o, d, corners) if meet(span, box(corners)) else None
        need(found != 0, "ray", f"triangle {c} is not met properly")
        met += [c] if found else []
        number += found or 0
    need(met == listed, "ray", f"met are {met}")
    return number

# ---- sections 4.1 to 4.4: certified and recomputed claims
def check_closed(*complexes):
    for c in complexes: need(not c.boundary, "not-closed")
def check_nested(case, blocks):
    for x in "ab": case[x].check_solid()
    check_closed(case["a"], case["b"])
    for x in "ab": check_embedded(case, blocks[x], x)
    check_separation(case, blocks["between"], triangles(case, "a"), triangles(case, "b"))
    for x in "ab":
        part = case[x].components()
        at = {v: part[c] for c, cell in enumerate(case[x].cells) for v in cell}
        found = [at.get(v) for y, v, _, _ in blocks["rays"] if y == x]
        need(found == sorted(set(part.values())), "ray-component")
    for ray in blocks["rays"]: need(ray_number(case, ray) == (ray[0] == "a"), "winding")
def check_position(case, lines, x):  # pl-homeomorphism: the positions of one input
    c = case[x]
    if not c.full:
        c.check_not_flat()
        return check_embedded(case, lines, x)
    part, sign = c.components(), {}
    for i in range(len(c.cells)):
        volume = c.volume(i)
        need(volume and sign.setdefault(part[i], volume > 0) == (volume > 0), "sign", f"cell {i}")
    rim = {f: c.facet(f) for f in c.boundary}
    if c.k == 4:
        faces = x, rim
        check_separation(case, lines, faces, faces)
    else:
        boxes, names = [box(c.at(edge)) for edge in rim.values()], list(rim)
        for i, j in meeting(boxes, boxes, range(len(rim)), range(len(rim))):
            A, B = rim[names[i]], rim[names[j]]
            need(i >= j or not share(*c.at(A + B), A, B), "crossing", f"facets {names[i]} {names[j]}")
    centroids = {f: c.centroid(f) for f in set(c.boundary_parts().values())}
    for i, cell in enumerate(c.cells):
        bounds = box(c.at(cell))
        for f, y in centroids.items():
            need(f // c.k == i or not meet(bounds, y + y) or not c.holds(i, y), "twice", f"facet {f}, cell {i}")
def check_certified(case, claim, blocks):
    if claim == "nested": check_nested(case, blocks)
    elif claim == "pl-homeomorphism":
        case["a"].check_sound()
        for x in "ab": check_position(case, blocks[x], x)
    else:
        case["a"].check_solid()
        if claim == "embedded": check_embedded(case, blocks["a"], "a")
def check_topology(case, claim, certified):
    for x in "ab": case[x].check_sound()
    if claim == "nested-topology":
        check_closed(case["a"], case["b"])
        a, b = (sum((2 - euler) * many for (euler, _), many in case[x].topology().items()) for x in "ab")
        need(b > a, "not-refuted", f"twice the genera: {a}, {b}")
    else: need((case["a"].topology() == case["b"].topology()) == certified, "topology" if certified else "not-refuted")

# ---- section 4.5: witnesses
def check_fact(case, word, x, facts):
    if word == "cross":
        x, cells, weights = facts
        points = [mix(case[y].at(case[y].cells[c]), w) for y, c, w in zip((x[0], x[-1]), cells, weights)]
        p, q = points
        need(all(p[i] * q[3] == q[i] * p[3] for i in range(3)), "wrong-point")
        ids = [{v for v, w in zip(case[y].cells[c], some) if w} for y, c, some in zip((x[0], x[-1]), cells, weights)]
        return x == "ab" or ids[0] != ids[1]
    if word == "winding":
        case["ab"[facts[0] == "a"]].check_not_flat()
        need(case[facts[0]].star([facts[1]]), "ray-component")
        return ray_number(case, facts) != (facts[0] == "a")
    c = case[x]
    cell = lambda i: set(c.cells[i])
    if word == "repeated": return len(cell(*facts)) < c.k
    if word == "twin": return cell(facts[0]) == cell(facts[1])
    if word == "direction": return bool(set.intersection(*(set(map(way, c.facets(i))) for i in facts)))
    if word == "facet": return all(set(facts[0]) <= cell(i) for i in facts[1:])
    if word == "flat": return c.volume(*facts) == 0
    if word in ("vertex", "edge"):
        ids, i, j = facts
        ids = ids if word == "edge" else [ids]
        found = c.around(c.star(ids), ids)
        return i in found and j in found and found[i] != found[j]
    if word == "link": return bool(c.star(facts)) and c.link_is_wrong(*facts, c.star(facts))
    if word == "open":
        edges = {f for i in range(len(c.cells)) for f in c.facets(i)}
        return tuple(facts) in edges and tuple(facts[::-1]) not in edges
    if word == "sign":
        part = c.components()
        return part[facts[0]] == part[facts[1]] and c.volume(facts[0]) * c.volume(facts[1]) <= 0
    f, i = facts  # twice
    return not set(c.facet(f)) <= cell(i) and c.holds(i, c.centroid(f))

# ---- section 4
def bind(cert, paths):
    try:
        fit(len(paths) == len(cert.inputs), "number of files")
        read = {x: read_input(path) for x, path in zip(cert.inputs, paths)}
    except (*WRONG, OverflowError, RuntimeError, StopIteration) as error:
        raise Stop("malformed", "input", ascii(error)[:200]) from None
    for x, stated in cert.inputs.items():
        c, sha = read[x]
        need(stated == (sha, c.space, c.k, len(c.points), len(c.cells)), "hash", x)
    case = {x: c for x, (c, _) in read.items()}
    need(cert.claim != "pl-homeomorphism" or case["a"].cells == case["b"].cells, "cells")
    scale(case.values())
    return case
def judge(paths):
    cert = Certificate(certificate_bytes(paths, "check_meshes.py CERT A [B]"))
    case = bind(cert, paths[1:])
    if cert.claim in ("same-topology", "nested-topology"): check_topology(case, cert.claim, cert.certified)
    elif cert.certified: check_certified(case, cert.claim, cert.blocks)
    for fact in cert.blocks.get("witness", ()): need(check_fact(case, *fact), "not-refuted", fact[0])
    return f"valid\n{cert.claim} {('refuted', 'certified')[cert.certified]}"
run = functools.partial(answer, judge)  # the exit code and the text to print

if __name__ == "__main__": main(run)
