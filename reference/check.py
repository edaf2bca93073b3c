#!/usr/bin/env python3
"""Second, independent checker of homeo certificates: python3 check.py CERT INPUT...

It follows certs/FORMAT.md (version 1), whose sections are cited below, and needs only the standard library.
Every decision is made on Python integers: all coordinates are multiplied by one common power of two. A *tag*
is an integer that names a point: 3 * vertex + layer (b 0, m 1, t 2) for a shell name, ~v for mesh vertex v.
Exit codes: 0 valid, 1 invalid, 2 malformed, 3 limit reached.
"""
import functools
import hashlib
import itertools
import math
import re
import struct
import sys

LIMIT, DIGITS = 2 ** 30, 4000
ascending = lambda items: all(a < b for a, b in zip(items, items[1:]))
distinct = lambda items: len(set(items)) == len(items)

class Stop(Exception):
    """The first failure: kind (`invalid`, `malformed`, `limit`), code, explanation."""

def need(condition, code, why="", kind="invalid"):
    """Stops with `code` unless the condition holds."""
    if not condition:
        raise Stop(kind, code, why)

def read_file(path, code, size, kind):
    """All bytes of a file, else `malformed code`; `kind size` if there are more than LIMIT."""
    try:
        with open(path, "rb") as file:
            data = b"".join(itertools.islice(iter(lambda: file.read(1 << 20), b""), LIMIT // 2 ** 20 + 1))
    except (OSError, ValueError):
        raise Stop("malformed", code, f"cannot read {path!a}") from None
    need(len(data) <= LIMIT, size, f"{path!a} is too large", kind)
    return data

# ------------------------------------------------- section 2, and "Certificate file" of section 3
CLAIMS = "positivity section bijection section-all-orders disjoint-mesh disjoint-bottom disjoint-top i2".split()
ID, W = "(?:0|[1-9][0-9]{0,9})", "(?:0|[1-9][0-9]*)"
NAME, POINT = "[bmt]" + ID, "[bmtg]" + ID
number = lambda text: int(text[:DIGITS + 2])  # numbers that are cut short are over the limit
numbers = lambda text: tuple(map(number, text.split(" ")))
tag = lambda text: ~int(text[1:]) if text[0] == "g" else 3 * int(text[1:]) + "bmt".index(text[0])
tags = lambda text: tuple(map(tag, text.split(",")))
FIELDS = {  # kind: regular expression and meaning of a field
    **dict.fromkeys("IVTPGCD", (ID, int)),  # any ID; V shell vertex, T triangle, P prism, C `v` line, D `c` line
    "K": ("|".join(CLAIMS), str), "R": ("certified|refuted", str), "H": ("[0-9a-f]{64}", str),
    "A": (rf"(?!0 0 0\b){W} {W} {W}", numbers), "B": (rf"(?!0 0 0 0\b){W} {W} {W} {W}", numbers),  # weights
    "J": ("0|-?[1-9][0-9]{0,9}", int),  # INT
    "X": (r"0|-?(?:[1-9][0-9]*)?[13579](?:\*2\^-?[1-9][0-9]{0,4})?",  # VALUE
          lambda text: tuple(map(number, (text + "*2^0").split("*2^")[:2]))),
    "S": (f"{ID}(?:,{ID}){{0,2}}", lambda text: tuple(map(int, text.split(",")))),  # TIDS
    "N": (f"{NAME}(?:,{NAME})*", tags), "Q": (f"{NAME}(?:,{NAME}){{3}}", tags),  # NAMES, TET
    "L": (f"(?:p:{POINT},{POINT}|[ln]:{POINT}),{POINT}", lambda text: (text[0], tags(text[2:])))}  # PLANE

@functools.lru_cache(None)
def grammar(spec):
    """A line's expression, a group for each field, and its fields; after a kind may stand a number of times."""
    words = [(word[0], word[1:]) if word[0] in FIELDS else ("", word) for word in spec.split(" ")]
    parts = [(rf"((?: (?:{FIELDS[kind][0]})){rest})" if rest else f" ({FIELDS[kind][0]})") if kind else " " + rest
             for kind, rest in words]
    return re.compile(("\n" + "".join(parts)[1:] + "(?=\n)").encode()), [word for word in words if word[0]]

class Certificate:
    """Reads a certificate: `claims`, `shell`, `mesh`, `order`, `pinched`, `blocks` are what it says."""

    def __init__(self, data):
        self.data, self.at, self.row, self.bound, self.blocks, counts = data, 19, 1, {}, {}, []
        self.ok(not re.search(rb"[^\n\x20-\x7e]", data), "bytes")
        self.ok(data == b"end\n" or data.endswith(b"\nend\n"), "truncated")
        self.ok(data.startswith(b"homeo-certificate 1\n"), "magic")
        claims = self.many("claim K R")
        self.ok(ascending([CLAIMS.index(name) for name, _ in claims]))
        self.claims = dict(claims)
        present = self.plan()
        self.shell = self.line("shell H I I")
        self.mesh = None if list(self.claims) == ["positivity"] else self.line("mesh H I I")
        self.bound = dict(zip("VPGT", self.shell[1:] + (self.mesh or [0, 0, 0])[1:]))
        other = lambda f: len(f[0]) == self.shell[1] and distinct(f[0]) and f[0] != list(range(len(f[0])))
        self.order, = self.line("order list V+", other) if self.ahead("order list") else [self.line("order id")]
        self.pinched = self.line("pinched I V*", lambda f: ascending(f[1]))
        for name in filter(present.get, present):
            self.line("begin " + name)
            start = self.row
            self.blocks[name] = self.block(name, self.claims.get(name) == "certified")
            counts.append(self.row - start)
        self.ok(self.line("counts I*") == [counts], "counts")
        self.line("end")
        self.ok(self.at == len(data) - 1)

    def ok(self, condition, code="syntax", kind="malformed"):
        need(condition, code, f"line {self.row}", kind)

    def ahead(self, words):
        return re.compile(f"\n{words}[ \n]".encode()).match(self.data, self.at)

    def line(self, spec, good=lambda fields: True):
        """The fields of the next line, checked for syntax, then digits, then range."""
        pattern, kinds = grammar(spec)
        match, self.row, fields, items = pattern.match(self.data, self.at), self.row + 1, [], []
        self.ok(match)
        self.at = match.end()  # the LF that ends the line
        for (kind, rest), text in zip(kinds, match.groups()):
            texts = text.decode().split(" ")[1:] if rest else [text.decode()]
            values = [FIELDS[kind][1](x) for x in texts]
            fields.append(values if rest else values[0])
            items += [(kind, value) for value in values]
        self.ok(all(ascending(value) for kind, value in items if kind in "NQS") and good(fields))
        self.ok(not re.search(rb"(?<![0-9])[0-9]{%d}" % (DIGITS + 1), match[0]), "digits", "limit")
        self.ok(all(self.in_range(*item) for item in items), "range")
        return fields

    def in_range(self, kind, value):
        points = value if kind in "NQ" else value[1] if kind == "L" else [~v for v in value] if kind == "S" else ()
        return (all(-self.bound["G"] <= p < 3 * self.bound["V"] for p in points)
                and (kind not in self.bound or value < self.bound[kind]))

    def many(self, spec, least=1, good=lambda fields, previous: True):
        """`least` or more lines that start with the first word of spec."""
        lines, word = [], spec.split(" ")[0]
        while len(lines) < least or self.ahead(word):
            lines.append(self.line(spec, lambda fields: good(fields, lines[-1] if lines else [])))
        return lines

    def plan(self):
        """Checks that the claims fit together; the blocks, each with whether it is present."""
        said, refuted = self.claims.get, lambda *names: any(self.claims.get(x) == "refuted" for x in names)
        parts = {"section-all-orders": ("positivity", "section"),
                 "i2": ("section-all-orders", "disjoint-bottom", "disjoint-top")}
        self.ok(said("section") == said("bijection"), "claims")
        for name in filter(said, parts):
            self.ok(all(map(said, parts[name])) and (refuted(name) or not refuted(*parts[name])), "claims")
        return {"positivity": refuted("positivity"), "overlay": said("section") == "certified",
                "no-section": refuted("section"),
                "no-order": refuted("section-all-orders") and not refuted("positivity", "section"),
                **{name: said(name) for name in CLAIMS[4:7]},
                "i2": said("i2") and not (refuted("i2") and refuted(*parts["i2"]))}

    def block(self, name, certified):
        """The fact lines of a block."""
        if name == "positivity":
            return self.many("tet P Q X")
        if name == "overlay":
            return self.overlay()
        if name in ("no-section", "no-order"):
            return self.line("first V+", lambda f: distinct(f[0])) if name == "no-order" else [[]], self.witness()
        other, good = ("T", lambda f: f[0] < f[1]) if name == "disjoint-mesh" else ("P", lambda f: True)
        if certified:
            spec, key = ("contact-sep T P Q L+", 3) if name == "i2" else (f"sep T {other} L+", 2)
            return self.many(spec, 0, lambda f, previous: good(f) and previous[:key] < f[:key])
        return self.many("contact T P Q A B X" if name == "i2" else f"cross T {other} A A", 1, lambda f, _: good(f))

    def overlay(self):
        vertices, named = {}, []
        while not vertices or self.ahead("v"):
            fact = tuple(self.line("v S N"))
            self.ok(fact not in vertices, "duplicate")
            vertices[fact] = None
        self.bound["C"] = len(vertices)
        cells = [cell for cell, in self.many("c C{3,}", 1, lambda f, _: distinct(f[0]))]
        self.bound["D"] = len(cells)
        for spec in ("d mesh D I", "d middle D I"):
            named.append([])
            while not named[-1] or self.ahead(spec[:-4]):
                named[-1].append(tuple(self.line(spec)))
                self.ok(named[-1][-1][1] < len(cells[named[-1][-1][0]]) - 2, "range")
        return list(vertices), cells, named

    def witness(self):
        """A no-lift witness: its word and facts."""
        for words, fields in (("topology components", " I I"), ("topology euler", " J J"), ("tet", " P Q X")):
            if self.ahead(words):
                return words, self.line(words + fields)
        leg, roots = lambda: (*self.line("start Q"), self.many("step T A Q", 0)), []
        while not roots or self.ahead("root"):
            roots.append((*self.line("root T A"), []))
            branches = roots[-1][-1]
            while self.ahead("branch"):
                names, = self.line("branch N", lambda f: not branches or branches[-1][0] < f[0])
                legs = [leg()]
                legs += [leg()] if self.ahead("start") else []
                reasons = "twice monodromy" if len(legs) > 1 else "cap wall boundary fold lands"
                branches.append((names, legs, next(filter(self.ahead, reasons.split()), "cap")))
                self.line(branches[-1][2] if self.ahead(branches[-1][2]) else "reason")
        return "roots", roots

# ------------------------------------------------- "Inputs" of section 3; section 5 (OFF, OBJ), section 6 (HDF5)
DECIMAL = rb"\s+([+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
INDEX = rb"\s+0*([0-9]{1,10})"
OFF_HEAD = re.compile(rb"\s*OFF" + 2 * INDEX + rb"\s+[0-9]+(?!\S)").match
OFF_ROWS = re.compile(3 * DECIMAL + rb"(?!\S)").match, re.compile(rb"\s+3" + 3 * INDEX + rb"(?!\S)[^\n]*").match
OBJ_ROWS = (re.compile(rb"\s*v" + 3 * DECIMAL + rb"(?!\S)").match,
            re.compile(rb"\s*f" + 3 * (INDEX + rb"(?:/\S*)?") + rb"\s*").fullmatch)
WRONG = ArithmeticError, AttributeError, LookupError, TypeError, ValueError, struct.error  # what bad data raise

def read_mesh(data):
    """(points, triangles) of an OFF or OBJ file."""
    data, tables = data.replace(b"\v", b"?"), ([], [])  # \v is not white space here
    text = re.sub(rb"#[^\n]*", b"", data)
    off = text.lstrip().startswith(b"OFF")
    head = match = OFF_HEAD(text) if off else None
    for k, row in enumerate(OFF_ROWS if off else OBJ_ROWS):
        for _ in range(int(head[k + 1]) if off else 0):
            match = row(text, match.end())
            tables[k].append(match.groups())
        for line in () if off else re.finditer(rb"^[ \t\f\r]*" + b"vf"[k:k + 1] + rb"(?!\S).*", data, re.MULTILINE):
            tables[k].append(row(line[0]).groups())
    first = 0 if off else 1
    return checked([tuple(map(float, p)) for p in tables[0]], [tuple(int(v) - first for v in f) for f in tables[1]])

def checked(points, faces):
    """A mesh that has a vertex, finite coordinates and no index out of range."""
    finite = all(math.isfinite(x) for p in points for x in p)
    need(points and finite and all(0 <= v < len(points) for f in faces for v in f), "input", "mesh", "malformed")
    return points, faces

class Hdf5:
    """The n x 3 datasets of the root group of an HDF5 file."""

    def __init__(self, data):
        self.data, self.objects, done = data, {}, set()
        signature, sizes, base, root = self.get("<9s4x2s9xQ32xQ", 0)
        self.ok((signature, sizes, base) == (b"\x89HDF\r\n\x1a\n\0", b"\x08\x08", 0))
        tree, heap = struct.unpack_from("<QQ", self.messages(root)[0x11])
        magic, size, start = self.get("<5s3xQ8xQ", heap)
        self.ok(magic == b"HEAP\0" and start + size <= len(data))
        names, todo = data[start:start + size], [tree]
        for node in todo:
            magic, version, count = self.get("<4sBxH", node)
            self.ok(node not in done and (magic == b"SNOD" or (magic, version) == (b"TREE", 0)))
            done.add(node)
            for k in range(count):
                if magic == b"TREE":
                    todo += self.get("<Q", node + 32 + 16 * k)
                else:
                    start, where = self.get("<QQ", node + 8 + 40 * k)
                    name = names[start:names.index(b"\0", start)]
                    self.ok(name not in self.objects)
                    self.objects[name] = where

    def ok(self, condition):
        need(condition, "input", "HDF5", "malformed")

    def get(self, layout, at):
        return struct.unpack_from(layout, self.data, at)

    def messages(self, at):
        """The first message of each type of an object header, its continuation blocks included."""
        version, left, size = self.get("<BxH4xI", at)
        self.ok(version == 1)
        found, todo, done = {}, [(at + 16, size)], set()
        for at, size in todo:
            end = at + size
            self.ok(at not in done and end <= len(self.data))
            done.add(at)
            while left and at + 8 <= end:
                kind, length, flags = self.get("<HHB", at)
                at, left = at + 8 + length, left - 1
                self.ok(at <= end and not (flags & 2 and kind in (1, 3, 8, 0x11)))
                found.setdefault(kind, self.data[at - length:at])
                if kind == 0x10:
                    todo.append(struct.unpack_from("<QQ", self.data[at - length:at]))
        return found

    def rows(self, name, code):
        """The rows of a dataset of triples (code d: doubles, i: integers of 4 bytes)."""
        found, size = self.messages(self.objects[name]), struct.calcsize(code)
        space, n, three = struct.unpack_from("<2s6xQQ", found[1])
        kind, order, bytes_each, form = struct.unpack_from("<BB2xI12s", found[3].ljust(20 if code == "i" else 0, b"\0"))
        layout, where, length = struct.unpack_from("<2sQQ", found[8])
        ieee = struct.pack("<HHBBBBI", 0, 64, 52, 11, 0, 52, 1023)
        good = (kind & 15, order & 65, form) == (1, 0, ieee) if code == "d" else \
            (kind & 15, order & 1, form[:4]) == (0, 0, b"\0\0\x20\0")
        self.ok(0xB not in found and (space, three) == (b"\1\2", 3) and good and bytes_each == size)
        self.ok(layout == b"\3\1" and length == 3 * n * size and (n == 0 or where + length <= len(self.data)))
        return list(struct.iter_unpack("<3" + code, self.data[where:where + length] if n else b""))

    def mesh(self, points, faces):
        return checked(self.rows(points, "d"), self.rows(faces, "i"))

def read_inputs(paths, mesh_needed):
    """(the three layers' points, prisms, mesh points, triangles) from one to four files."""
    try:
        need(1 <= len(paths) <= 4, "input", "one to four input files", "malformed")
        files = [read_file(path, "input", "input", "malformed") for path in paths]
        shell = Hdf5(files[0]) if len(files) <= 2 else None
        layers = [shell.mesh(x, b"mF") for x in (b"mbase", b"mV", b"mtop")] if shell else map(read_mesh, files[:3])
        points, faces = zip(*layers)
        need(len(set(map(len, points))) == 1 and faces[0] == faces[1] == faces[2], "input", "layers", "malformed")
        mesh = read_mesh(files[-1]) if len(files) in (2, 4) else None
        if mesh_needed and not mesh:
            mesh = shell.mesh(b"ref.V", b"ref.F")
        return points, faces[0], *(mesh or ([], []))
    except WRONG as error:
        raise Stop("malformed", "input", type(error).__name__) from None

# ------------------------------------------------- section 1: words
sub = lambda a, b: (a[0] - b[0], a[1] - b[1], a[2] - b[2])
dot = lambda a, b: a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
det3 = lambda a, b, c: dot(a, cross(b, c))
det = lambda a, b, c, d: det3(sub(b, a), sub(c, a), sub(d, a))
sides = lambda a, b, c: ((a, b), (b, c), (c, a))
fan = lambda c: [(c[0], c[i], c[i + 1]) for i in range(1, len(c) - 1)]
box = lambda points: (*map(min, zip(*points)), *map(max, zip(*points)))
meet = lambda a, b: all(a[k] <= b[k + 3] and b[k] <= a[k + 3] for k in (0, 1, 2))
proportional = lambda a, b: a.keys() == b.keys() and all(  # {argument: positive weight} as functions
    a[k] * sum(b.values()) == b[k] * sum(a.values()) for k in a)

def plane(a, b, c):
    """(n, h): n . x - h is det[b-a, c-a, x-a]."""
    n = cross(sub(b, a), sub(c, a))
    return n, dot(n, a)

def projected(weights):
    """For {name: weight}, the sums over the names of each vertex."""
    return {v: sum(x for n, x in weights.items() if n // 3 == v) for v in {n // 3 for n in weights}}

def meeting(A, B, left, right, found):
    """Adds to found[i] all j of which the closed boxes A[i], B[j] meet: halves `right`, prunes `left`."""
    hull = box([B[j][:3] for j in right] + [B[j][3:] for j in right])
    left = [i for i in left if meet(A[i], hull)]
    if len(right) <= 4 or not left:
        for i in left:
            found[i].update(j for j in right if meet(A[i], B[j]))
        return
    axis = max(range(3), key=lambda k: hull[k + 3] - hull[k])
    right, half = sorted(right, key=lambda j: B[j][axis] + B[j][axis + 3]), len(right) // 2
    meeting(A, B, left, right[:half], found)
    meeting(A, B, left, right[half:], found)

class Complex:
    """Oriented triangles, found by vertex (`at`), directed edge and vertex set; boundary simplices, components."""

    def __init__(self, faces):
        self.faces, self.at, self.edge, self.component, self.count = faces, {}, {}, {}, 0
        for i, f in enumerate(faces):
            for v, w in sides(*f):
                self.edge[v, w] = i
                self.at.setdefault(v, []).append(i)
        self.find = {frozenset(f): i for i, f in enumerate(faces)}
        self.rim = {frozenset(s) for a, b in self.edge if (b, a) not in self.edge for s in ((a, b), (a,), (b,))}
        for start in range(len(faces)):
            todo = [start] if start not in self.component else []
            self.count += len(todo)
            for i in todo:
                if i not in self.component:
                    self.component[i] = self.count - 1
                    todo += [self.edge[b, a] for a, b in sides(*faces[i]) if (b, a) in self.edge]

    def euler(self):
        return len(self.at) - len(set(map(frozenset, self.edge))) + len(self.faces)

    def manifold(self):
        """No repeated corner, directed edge or triangle; the triangles at a vertex are one path or cycle."""
        n = len(self.faces)
        if not n or any(len(set(f)) < 3 for f in self.faces) or len(self.edge) < 3 * n or len(self.find) < n:
            return False
        for v, around in self.at.items():
            link = {f[f.index(v) - 2]: f[f.index(v) - 1] for f in (self.faces[i] for i in around)}
            here = next(iter(link.keys() - set(link.values())), next(iter(link)))
            while here in link:
                here = link.pop(here)
            if link:
                return False
        return True

ORDERS = {}  # for each order of a prism's corners its three tets: (four (corner, 0 lo | 1 hi), pillar's corner)
for u, v, w in itertools.permutations(range(3)):
    tets = ((u, 0), (v, 0), (w, 0), (w, 1)), ((u, 0), (v, 0), (v, 1), (w, 1)), ((u, 0), (u, 1), (v, 1), (w, 1))
    positive = [det(*((c == 1, c == 2, h) for c, h in tet)) > 0 for tet in tets]  # in the straight unit prism
    ORDERS[u, v, w] = [((p, q, r, s) if good else (p, q, s, r), pillar)
                       for (p, q, r, s), good, pillar in zip(tets, positive, (w, v, u))]
ALL12 = list({frozenset(t): (t, pillar) for three in ORDERS.values() for t, pillar in three}.values())

class Case:
    """Shell and mesh in integers (times `unit`): points `X` by tag, names `N` by vertex, complexes `M` and `T`."""

    def __init__(self, layers, prisms, points, triangles):
        self.unit = max(x.as_integer_ratio()[1] for p in itertools.chain(*layers, points) for x in p)
        scale = lambda p: tuple(n * (self.unit // d) for n, d in map(float.as_integer_ratio, p))
        self.X = [scale(p) for triple in zip(*layers) for p in triple] + [scale(p) for p in points[::-1]]
        self.pinned = [v for v, (b, m, t) in enumerate(zip(*layers)) if b == m == t]
        self.pin, self.pins = set(self.pinned), {3 * v + 1 for v in self.pinned}
        self.N = [(3 * v + 1,) * 3 if v in self.pin else (3 * v, 3 * v + 1, 3 * v + 2) for v in range(len(layers[0]))]
        self.M, self.T = Complex(prisms), Complex(triangles)
        self.corners = [self.at(~v for v in f) for f in triangles]
        self.planes = [plane(*c) for c in self.corners]
        self.prism_boxes = [box(self.at(n for v in f for n in self.N[v])) for f in prisms]

    def at(self, tags):
        return [self.X[t] for t in tags]

    def tets(self, prism, chosen=ALL12):
        """{names: (names in positive order, V)} of a prism, in both slabs."""
        corners, found = self.M.faces[prism], {}
        for slab, (t, pillar) in itertools.product((0, 1), chosen):
            if corners[pillar] not in self.pin:
                order = [self.N[corners[c]][slab + h] for c, h in t]
                lo, hi = self.at(self.N[corners[pillar]][slab:slab + 2])
                found[tuple(sorted(order))] = order, sub(hi, lo)
        return found

    def decomposition(self, order):
        """S_< by prism, for all vertices, smallest first."""
        rank = {v: i for i, v in enumerate(order)}
        chosen = lambda f: ORDERS[tuple(sorted(range(3), key=lambda c: rank[f[c]]))]
        return [self.tets(j, chosen(f)) for j, f in enumerate(self.M.faces)]

    def volume(self, tet):
        return det(*self.at(tet[0]))

    def dot(self, f, tet):
        return dot(self.planes[f][0], tet[1])

    def clear(self, f, prism):
        """Whether f has a positive dot with both halves of all unpinched pillars of the prism."""
        heights = [[dot(self.planes[f][0], self.X[n]) for n in self.N[v]]
                   for v in self.M.faces[prism] if v not in self.pin]
        return all(b < m < t for b, m, t in heights)

    def mix(self, points, weights):
        """The weighted point as (x, y, z, w)."""
        return tuple(sum(w * p[k] for w, p in zip(weights, points)) for k in range(3)) + (sum(weights),)

    def equals(self, scaled, value):
        """Whether an integer that stands for scaled / unit^3 is the file's value odd * 2^exponent."""
        return scaled << max(-value[1], 0) == value[0] * self.unit ** 3 << max(value[1], 0)

    def cap(self, names):
        """Section 3.2.2: all names are `t` or pinched, or all `b` or pinched, but not one pinched name."""
        free = {n % 3 for n in names if n not in self.pins}
        return free in ({0}, {2}) or not free and len(names) > 1

# ------------------------------------------------- section 3, binding; 3.1, positivity
def sha(layers, faces):
    tables = [struct.pack(f"<{3 * len(points)}d", *itertools.chain(*points)) for points in layers]
    return hashlib.sha256(b"".join(tables) + struct.pack(f"<{3 * len(faces)}I", *itertools.chain(*faces))).hexdigest()

def bind(cert, layers, prisms, points, triangles):
    """The inputs are those that the certificate names, and fit to be judged."""
    need(cert.shell == [sha(layers, prisms), len(layers[0]), len(prisms)], "hash", "shell")
    need(cert.mesh in (None, [sha([points], triangles), len(points), len(triangles)]), "hash", "mesh")
    case = Case(layers, prisms, points, triangles if cert.mesh else [])
    pins = [sum(v in case.pin for v in f) for f in prisms]
    need(case.M.manifold() and max(pins) < 3, "shell-conditions")
    need(not cert.mesh or case.T.manifold() and all(any(n) for n, _ in case.planes), "mesh-conditions")
    need(cert.pinched == [8 * sum(pins), case.pinned], "pinched")
    return case

def check_tet(case, fact, tets):
    prism, names, value = fact
    need(names in tets, "unknown-tet", f"prism {prism}")
    need(case.equals(case.volume(tets[names]), value), "wrong-value", f"prism {prism}")
    need(case.volume(tets[names]) <= 0, "not-refuted", f"prism {prism}")

def check_positive(case, decomposition):
    for prism, tets in enumerate(decomposition):
        need(all(case.volume(tet) > 0 for tet in tets.values()), "not-positive", f"prism {prism}")

# ------------------------------------------------- section 3.2: the overlay
def null_vector(columns):
    """The integer solution x of sum x_i column_i = 0 if the solutions are a line, else None.

    Each column is followed by the unit vector that names it, and then reduced by the ones before it."""
    basis, found = [], []
    for i, column in enumerate(columns):
        row = [*column, *(int(i == j) for j in range(len(columns)))]
        for pivot, other in basis:
            row = [other[pivot] * x - row[pivot] * y for x, y in zip(row, other)]
        common = math.gcd(*row)
        row = [x // common for x in row]
        pivot = next((k for k in range(4) if row[k]), None)
        (found if pivot is None else basis).append((pivot, row))
    return found[0][1][4:] if len(found) == 1 else None

def holders(case, S, names):
    """The tets of S that hold all the names, as (prism, names)."""
    return [(j, t) for j in case.M.at.get(names[0] // 3, ()) for t in S[j] if set(names) <= set(t)]

def overlay_vertex(case, S, ids, names, at):
    """The point of a `v` line as (weights on mesh vertices, weights on shell vertices, names)."""
    need(any(set(ids) <= set(case.T.faces[f]) for f in case.T.at.get(ids[0], ())), "mesh-carrier", at)
    need(holders(case, S, names), "shell-carrier", at)
    need(not case.cap(names), "cap", at)
    solution, n = null_vector([p + (1,) for p in case.at([~i for i in ids] + list(names))]) or [0], len(ids)
    total = sum(solution[:n])
    need(total, "no-point", at)
    solution = [x * total for x in solution[:n]] + [-x * total for x in solution[n:]]
    need(min(solution) > 0, "outside-carrier", at)
    return dict(zip(ids, solution)), projected(dict(zip(names, solution[n:]))), set(names)

def overlay_cell(case, S, points, at):
    """(f, prism) of a `c` line."""
    over = [c.find.get(frozenset().union(*(p[k] for p in points))) for k, c in enumerate((case.T, case.M))]
    need(over[0] is not None, "cell-mesh", at)
    names = set().union(*(p[2] for p in points))
    need(over[1] is not None and any(names <= set(t) for t in S[over[1]]), "cell-shell", at)
    return over

def check_overlay(case, S, facts):
    """The complex K as (its points, its cells (f, prism, fan in f), its boundary edges)."""
    check_positive(case, S)
    vertices, lines, named = facts
    points = [overlay_vertex(case, S, *v, f"v line {i}") for i, v in enumerate(vertices)]
    cells, images = [], {}
    for k, c in enumerate(lines):
        over, at = overlay_cell(case, S, [points[i] for i in c], f"c line {k}"), f"c line {k}"
        in_f, in_j = (fan([[points[i][s].get(v, 0) for v in complex_.faces[over[s]]] for i in c])
                      for s, complex_ in enumerate((case.T, case.M)))
        for i, (a, b) in enumerate(zip(in_f, in_j)):
            need(det3(*a) > 0, "area-mesh", at)
            need(det3(*b) > 0, "area-middle", at)
            images.setdefault((0, over[0]), {})[k, i] = a
            images.setdefault((1, over[1]), {})[k, i] = b
        cells.append((*over, in_f))
    edges = [e for c in lines for triangle in fan(c) for e in sides(*triangle)]
    need(distinct(edges), "edge-twice")
    rim = sorted({(a, b) for a, b in edges} - {(b, a) for a, b in edges})
    for a, b in rim:
        ends = [points[a][k].keys() | points[b][k].keys() for k in (0, 1)]
        need(ends[0] in case.T.rim and ends[1] in case.M.rim, "boundary", f"{a} {b}")
    need(len(set(itertools.chain(*lines))) == len(points), "isolated")
    for side, over in enumerate((case.T, case.M)):
        found = [over.component[cells[cell][side]] for cell, _ in named[side]]
        need(found == list(range(over.count)), "degree-component")
    for side, name in [(side, name) for side in (0, 1) for name in named[side]]:
        over = images[side, cells[name[0]][side]]
        a, b, c = map(sum, over[name])
        x = [p * b * c + q * a * c + r * a * b for p, q, r in zip(*over[name])]  # the centroid
        for other, (p, q, r) in over.items():
            inside = min(det3(x, q, r), det3(p, x, r), det3(p, q, x)) >= 0
            need(not inside or other == name, "degree", f"cells {name[0]} {other[0]}")
    return points, cells, rim

# ------------------------------------------------- section 3.3: all orders
def cut(case, polygon, names, corners):
    """Cuts a polygon (barycentric rows on three corners) with a closed tet."""
    for k in range(4):
        p, *face = case.at(names[k:] + names[:k])
        n, h = plane(*face)
        sign = 1 if dot(n, p) >= h else -1
        values, kept = [sign * (dot(n, c) - h) for c in corners], []
        side = [(row, dot(values, row)) for row in polygon]
        for (p, x), (q, y) in zip(side, side[1:] + side[:1]):
            kept += [p] if x >= 0 else []
            if x * y < 0:
                new = [abs(y) * s + abs(x) * t for s, t in zip(p, q)]
                kept.append([s // math.gcd(*new) for s in new])
        polygon = kept
    return polygon

def check_all_orders(case, points, cells, rim):
    wall = lambda u, w, s: (*case.N[u][s:s + 2], *case.N[w][s:s + 2])
    volume = lambda names: det(*case.at(names))  # of a wall, 0 if u or w is pinched
    for a, b in rim:
        names, (u, w) = points[a][2] | points[b][2], points[a][1].keys() | points[b][1].keys()
        flat = [x for x in (wall(u, w, 0), wall(u, w, 1)) if not volume(x)] + [(3 * u + 1, 3 * w + 1)]
        need(any(names <= set(x) for x in flat), "all-orders-boundary", f"edge {a} {b}")
    for number_, (f, j, rows) in enumerate(cells):
        for side in ((), *sides(*case.M.faces[j])):
            q, corners = case.M.edge.get(side[::-1]) if side else j, case.corners[f]
            if q is None or case.clear(f, q):
                continue
            walls = [x for x in (wall(*side, 0), wall(*side, 1)) if volume(x)] if side else []
            pieces = [cut(case, p, x, corners) for x in walls for p in rows] if side else rows
            for names in [names for names, tet in case.tets(q).items() if case.dot(f, tet) <= 0]:
                flat = (not any(det3(*t) for t in fan(cut(case, p, names, corners))) for p in pieces)
                need(all(flat), "all-orders", f"cell {number_}, prism {q}")

# ------------------------------------------------- section 3.4: the no-lift witness
class Witness:
    """A no-lift witness for S_<; `stars` remembers which shell edges have an injective star."""

    def __init__(self, case, S, word, facts):
        self.case, self.S, self.stars = case, S, {}
        if word == "tet":
            check_tet(case, facts, S[facts[0]])
        elif word == "roots":
            self.roots(facts)
        else:
            values = [x.euler() if word == "topology euler" else x.count for x in (case.T, case.M)]
            need(values == facts, "wrong-value")
            need(values[0] != values[1], "not-refuted")

    def tet(self, names):
        """The prism of a tet of S, and whether the tet is positive."""
        prism = self.case.M.find.get(frozenset(n // 3 for n in names))
        need(prism is not None and names in self.S[prism], "unknown-tet")
        return prism, self.case.volume(self.S[prism][names]) > 0

    def coordinates(self, x, prism, names):
        """{name: positive coordinate} of x = (x, y, z, w) in a tet; {} outside or in a bad tet."""
        order = self.S[prism][names][0]
        a, b, c, d = ([x[3] * p - q for p, q in zip(point, x)] for point in self.case.at(order))
        values = det3(b, c, d), -det3(a, c, d), det3(a, b, d), -det3(a, b, c)
        inside = min(values) >= 0 and self.case.volume((order,)) > 0
        return {n: v for n, v in zip(order, values) if v} if inside else {}

    def injective_star(self, edge):
        """Whether S's tets around an edge are positive and their open wedges disjoint."""
        if edge not in self.stars:
            positive, wedges, (p, q) = True, [], self.case.at(edge)
            for prism, names in holders(self.case, self.S, edge):
                r, s = self.case.at(n for n in names if n not in edge)
                wedges.append((r, s) if det(p, q, r, s) > 0 else (s, r))
                positive &= self.case.volume(self.S[prism][names]) > 0
            before = lambda x, y: (all(det(p, q, x[0], z) <= 0 for z in y)
                                   or all(det(p, q, z, x[1]) <= 0 for z in y))
            pairs = itertools.combinations(wedges, 2)
            self.stars[edge] = positive and all(before(x, y) or before(y, x) for x, y in pairs)
        return self.stars[edge]

    def roots(self, facts):
        case, landed = self.case, set()
        for f, weights, branches in facts:
            x, carriers = case.mix(case.corners[f], weights), set()
            for prism, b in enumerate(case.prism_boxes):
                if all(b[k] * x[3] <= x[k] <= b[k + 3] * x[3] for k in range(3)):
                    carriers |= {tuple(sorted(self.coordinates(x, prism, names))) for names in self.S[prism]}
            need(carriers - {()} == {names for names, _, _ in branches}, "wrong-branches", f"root on {f}")
            for names, legs, reason in branches:
                ends = [self.leg(f, weights, names, *leg) for leg in legs]
                need(self.holds(reason, *ends[0], *ends[-1]), "not-refuted", f"root on {f}, {reason}")
                landed |= {case.M.component[ends[0][3]]} if reason == "lands" else set()
        need(distinct([case.T.component[f] for f, _, _ in facts]), "wrong-branches")
        need(len(landed) < len(facts), "not-refuted")

    def leg(self, f, weights, branch, tet, steps):
        """Walks a leg; its last station as (f, weights in T, coordinates in the tet, prism, tet)."""
        (prism, positive), faces = self.tet(tet), self.case.T.faces
        need(positive and set(branch) <= set(tet), "wrong-step")
        here = self.coordinates(self.case.mix(self.case.corners[f], weights), prism, tet)
        for g, weights, new in steps:
            next_prism, positive = self.tet(new)
            x, used = self.case.mix(self.case.corners[g], weights), {v for v, w in zip(faces[g], weights) if w}
            before, after = self.coordinates(x, prism, tet), self.coordinates(x, next_prism, new)
            good = positive and used <= set(faces[f]) and before and before.keys() == after.keys()
            star = len(here) > 2 or len(here) == 2 and self.injective_star(tuple(sorted(here)))
            need(good and star, "wrong-step", f"step on {g}")
            f, prism, tet, here = g, next_prism, new, after
        return f, {v: w for v, w in zip(faces[f], weights) if w}, here, prism, tet

    def holds(self, reason, f, on_mesh, here, prism, tet, _, mesh2, here2, *others):
        """Whether the reason holds at the last station (of a second leg: mesh2, here2)."""
        case, (n, h), same_point = self.case, self.case.planes[f], proportional(on_mesh, mesh2)
        on_rim, on_wall = {*on_mesh} in case.T.rim, {*projected(here)} in case.M.rim
        flat = len(here) == 4 or len(here) == 3 and all(dot(n, p) == h for p in case.at(here))
        return {"cap": case.cap(here), "wall": on_wall and not on_rim, "boundary": on_rim and not on_wall,
                "fold": len(on_mesh) == 3 and case.dot(f, self.S[prism][tet]) <= 0 and flat, "lands": True,
                "twice": not same_point and proportional(projected(here), projected(here2)),
                "monodromy": same_point and here.keys() != here2.keys()}[reason]

# ------------------------------------------------- sections 3.5 and 3.6: separation and contact
def separates(case, planes, A, B):
    """Section 3.5, for planes (n, h) and simplices given by their tags."""
    common, pinched = set(A) & set(B), {case.X[n] for n in B if n in case.pins}
    for (x, y, z), h in planes:
        a, b = ([x * p[0] + y * p[1] + z * p[2] - h for p in case.at(s)] for s in (A, B))
        if not (max(a, default=0) <= 0 <= min(b, default=0) or max(b, default=0) <= 0 <= min(a, default=0)):
            return False
        A, B = [t for t, value in zip(A, a) if not value], [t for t, value in zip(B, b) if not value]
    return any(set(s) == common or len(s) == 1 and case.X[s[0]] in pinched for s in (A, B))

def listed_planes(case, f, planes):
    """The planes of a `sep` or `contact-sep` line as (n, h); a name that does not exist separates nothing."""
    for kind, points in planes:
        need(all(p < 0 or p in case.N[p // 3] for p in points), "not-separated", "no such name")
        a, b, *c = case.at(points)
        n = sub(b, a)
        if kind != "n":
            n = cross(n, sub(c[0], a) if c else case.planes[f][0])
        yield n, dot(n, a)

def check_contacts(case, name, facts, certified):
    """Sections 3.5 and 3.6: B is a mesh triangle, a bottom or top triangle, or a tet, with its dot if it has one."""
    T, N, i2 = [tuple(~v for v in f) for f in case.T.faces], case.N, name == "i2"
    layer = T if name == "disjoint-mesh" else [tuple(N[v][2 * (name == "disjoint-top")] for v in f) for f in case.M.faces]
    others = lambda f, j: {t: case.dot(f, x) for t, x in case.tets(j).items()} if i2 else {layer[j]: 0}
    facts = [(f, j, *rest) if i2 else (f, j, layer[j], *rest) for f, j, *rest in facts]
    for f, j, B, *rest in facts if not certified else ():
        dots, (u, w), at = others(f, j), rest[:2], f"{f} {j}"
        need(B in dots, "unknown-tet", at)
        x, y = case.mix(case.corners[f], u), case.mix(case.at(B), w)
        need(all(x[k] * y[3] == y[k] * x[3] for k in range(3)), "wrong-point", at)
        need(not i2 or case.equals(dots[B], rest[2]), "wrong-value", at)
        a, b = ({t for t, z in zip(*pair) if z} for pair in ((T[f], u), (B, w)))
        need(dots[B] <= 0 and a != b and not (len(b) == 1 and b <= case.pins), "not-refuted", at)
    meets, listed, mesh_boxes = [set() for _ in T], {fact[:3]: fact[3] for fact in facts}, list(map(box, case.corners))
    boxes = case.prism_boxes if i2 else [box(case.at(B)) for B in layer]
    lines = [[] for _ in T]
    for f, j, B in listed if certified else ():
        lines[f].append((j, B))
    meeting(mesh_boxes, boxes, list(range(len(T) if certified else 0)), list(range(len(boxes))), meets)
    for f, A in enumerate(T):
        found = set()
        for j in meets[f]:
            if j > f if layer is T else not i2 or not case.clear(f, j):
                for B, d in others(f, j).items():
                    if d <= 0 and meet(mesh_boxes[f], box(case.at(B))):
                        faces = [plane(*case.at(three)) for three in itertools.combinations(B, 3)]
                        if not any(separates(case, [h], A, B) for h in (case.planes[f], *faces)):
                            found.add((j, B))
        for j, B in sorted(found.union(lines[f])):
            need((j, B) in found, "superfluous", f"{f} {j}")
            need((f, j, B) in listed, "missing-separation", f"{f} {j}")
            planes = list(listed_planes(case, f, listed[f, j, B]))
            need(separates(case, planes, A, B), "not-separated", f"{f} {j}")

# ------------------------------------------------- all claims in order
def check_claims(case, cert):
    order, blocks = cert.order or range(len(case.N)), cert.blocks
    S = case.decomposition(order) if "section" in cert.claims else None
    for name, verdict in cert.claims.items():
        certified = verdict == "certified"
        if name == "positivity" and certified:
            check_positive(case, map(case.tets, range(len(case.M.faces))))
        elif name == "positivity":
            for fact in blocks[name]:
                check_tet(case, fact, case.tets(fact[0]))
        elif name == "section" and certified:
            K = check_overlay(case, S, blocks["overlay"])
        elif name == "section":
            Witness(case, S, *blocks["no-section"][1])
        elif name == "section-all-orders" and certified:
            check_all_orders(case, *K)
        elif name == "section-all-orders" and "no-order" in blocks:
            (first,), witness = blocks["no-order"]
            Witness(case, case.decomposition(dict.fromkeys([*first, *order])), *witness)
        elif name in blocks:
            check_contacts(case, name, blocks[name], certified)

def run(paths):
    """The exit code and the text to print."""
    try:
        getattr(sys, "set_int_max_str_digits", int)(0)  # the grammar has limits of its own
        need(paths, "usage", "check.py CERT INPUT...", "malformed")
        cert = Certificate(read_file(paths[0], "usage", "size", "limit"))
        check_claims(bind(cert, *read_inputs(paths[1:], cert.mesh is not None)), cert)
        return 0, "\n".join(["valid"] + [f"{name} {verdict}" for name, verdict in cert.claims.items()])
    except Stop as stop:
        kind, code, why = stop.args
        return {"invalid": 1, "malformed": 2, "limit": 3}[kind], f"{kind} {code}" + (" : " + why if why else "")
    except Exception as error:  # a last resort: never an answer, never `valid`
        return 3, f"limit internal : {type(error).__name__}"

if __name__ == "__main__":
    status, answer = run(sys.argv[1:])
    print(answer)
    sys.exit(status)
