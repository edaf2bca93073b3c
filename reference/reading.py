"""What the Python checker reads: certificates (FORMAT.md section 2, and the file part of 3), OFF, OBJ, HDF5.

Only form is judged here; check.py holds the rules. No number in a file is trusted for an allocation.
"""
import itertools
import math
import re
import struct

LIMIT, DIGITS = 2 ** 30, 4000
CLAIMS = ["positivity", "section", "bijection", "section-all-orders",
          "disjoint-mesh", "disjoint-bottom", "disjoint-top", "i2"]

class Stop(Exception):
    """The first failure: kind (`invalid`, `malformed`, `limit`), code, explanation."""

def need(condition, code, why="", kind="invalid"):
    """Stops with `code` unless the condition holds."""
    if not condition:
        raise Stop(kind, code, why)

def read_file(path, code):
    """All bytes of a file; None when it has more than LIMIT."""
    parts, size = [], 0
    try:
        with open(path, "rb") as file:
            while size <= LIMIT:
                parts.append(file.read(1 << 20))
                size += len(parts[-1])
                if not parts[-1]:
                    return b"".join(parts)
    except (OSError, ValueError) as error:
        raise Stop("malformed", code, f"cannot read {path}: {error}") from None
    return None

# ------------------------------------------------- section 2: the grammar, and its part of section 3
is_id = re.compile("0|[1-9][0-9]{0,9}").fullmatch
is_int = re.compile("0|-?[1-9][0-9]{0,9}").fullmatch
is_weight = re.compile("0|[1-9][0-9]*").fullmatch
is_sha = re.compile("[0-9a-f]{64}").fullmatch
is_value = re.compile(r"(-?)([1-9][0-9]*)(?:\*2\^(-?[1-9][0-9]{0,4}))?").fullmatch
is_name = re.compile("([bmt])(0|[1-9][0-9]{0,9})").fullmatch
ascending = lambda items: all(a < b for a, b in zip(items, items[1:]))
distinct = lambda items: len(set(items)) == len(items)

class Certificate:
    """Reads a certificate; `claims`, `shell`, `mesh`, `order`, `pinched`, `blocks` hold what it says."""

    def __init__(self, data):
        self.data, self.at, self.row, self.counts, self.blocks = data, 0, 0, [], {}
        self.bound, self.late, self.long = {}, [], False
        need(not re.search(rb"[^\n\x20-\x7e]", data), "bytes", "", "malformed")
        need(data == b"end\n" or data.endswith(b"\nend\n"), "truncated", "", "malformed")
        need(data.startswith(b"homeo-certificate 1\n"), "magic", "", "malformed")
        self.line()
        self.read_head()
        for name in CLAIMS[:1] + ["overlay", "no-section", "no-order"] + CLAIMS[4:]:
            self.read_block(name)
        counts = self.take("counts", [], "I")
        need(counts == self.counts, "counts", f"the blocks have {self.counts} lines", "malformed")
        self.take("end", [])
        self.ok(self.at == len(data))
    # lines and tokens

    def word(self):
        """The first word of the next line (empty after the last line)."""
        return re.compile(b"[^ \n]*").match(self.data, self.at)[0].decode("ascii")

    def line(self):
        end = self.data.find(b"\n", self.at)
        self.ok(end >= 0)
        text, self.at, self.row = self.data[self.at:end].decode("ascii"), end + 1, self.row + 1
        return text

    def ok(self, condition, code="syntax", kind="malformed"):
        need(condition, code, f"line {self.row}", kind)

    def take(self, word, kinds, more=None, check=lambda fields: True):
        """Fields of the next line: `word`, one token for each of `kinds`, then any number of kind `more`."""
        tokens = self.line().split(" ")
        n = len(tokens) - 1
        self.ok(tokens[0] == word and n >= len(kinds) and (more or n == len(kinds)))
        self.late, self.long = [], False
        kinds = itertools.chain(kinds, itertools.repeat(more))
        fields = [self.token(kind, text) for kind, text in zip(kinds, tokens[1:])]
        self.ok(check(fields))
        self.ok(not self.long, "digits", "limit")
        self.ok(all(value < self.bound[kind] for kind, value in self.late), "range")
        return fields

    def token(self, kind, text):
        """Kinds: W weight, J INT, X VALUE, H SHA, N NAMES, 4 TET, S TIDS, L PLANE, I any ID, =literal;
        IDs below a bound: G mesh vertex, V shell vertex, T triangle, P prism, C `v` line, D `c` line."""
        if kind == "W":
            self.ok(is_weight(text))
            return self.number(text)
        if kind in ("N", "4", "S"):
            ids = [self.name(s) if kind != "S" else self.token("G", s) for s in text.split(",")]
            self.ok(ascending(ids) and (kind != "4" or len(ids) == 4) and (kind != "S" or len(ids) <= 3))
            return tuple(ids)
        if kind == "L":
            points = text[2:].split(",")
            self.ok(text[:2] in ("p:", "l:", "n:") and len(points) == (3 if text[0] == "p" else 2))
            point = lambda s: ("g", self.token("G", s[1:])) if s[:1] == "g" else ("s", self.name(s))
            return text[0], [point(s) for s in points]
        if kind == "X":
            match = is_value(text)
            self.ok(text == "0" or match and match[2][-1] in "13579")
            return (int(match[1] + "1") * self.number(match[2]), int(match[3] or 0)) if match else (0, 0)
        if kind[0] == "=" or kind == "H":
            self.ok(is_sha(text) if kind == "H" else text == kind[1:])
            return text
        self.ok((is_int if kind == "J" else is_id)(text))
        if kind not in "IJ":
            self.late.append((kind, int(text)))
        return int(text)

    def number(self, text):
        self.long = self.long or len(text) > DIGITS
        return int(text) if len(text) <= DIGITS else 1

    def name(self, text):
        match = is_name(text)
        self.ok(match)
        self.late.append(("V", int(match[2])))
        return 3 * int(match[2]) + "bmt".index(match[1])

    def many(self, word, one, least=1):
        """Zero (or `least`) or more lines that start with `word`, each read by `one`."""
        items = []
        while len(items) < least or self.word() == word:
            items.append(one())
        return items
    # the head

    def read_head(self):
        pairs = self.many("claim", self.read_claim)
        self.ok(ascending([CLAIMS.index(name) for name, _ in pairs]))
        self.claims = dict(pairs)
        self.check_claims()
        sha, vertices, prisms = self.shell = self.take("shell", "HII")
        self.bound = {"V": vertices, "P": prisms}
        self.mesh = None
        if list(self.claims) != ["positivity"]:
            self.mesh = self.take("mesh", "HII")
            self.bound.update(G=self.mesh[1], T=self.mesh[2])
        listed = self.data.startswith(b"order list ", self.at)
        permutation = lambda f: len(f) - 1 == vertices and distinct(f[1:]) and f[1:] != list(range(vertices))
        self.order = self.take("order", ["=list"], "V", permutation)[1:] if listed else None
        if not listed:
            self.take("order", ["=id"])
        self.pinched = self.take("pinched", "I", "V", lambda f: ascending(f[1:]))

    def read_claim(self):
        tokens = self.line().split(" ")
        self.ok(tokens[0] == "claim" and len(tokens) == 3 and tokens[1] in CLAIMS)
        self.ok(tokens[2] in ("certified", "refuted"))
        return tokens[1:]

    def check_claims(self):
        c = self.claims
        good = c.get("section") == c.get("bijection")
        for name, needs in (("section-all-orders", ("positivity", "section")),
                            ("i2", ("section-all-orders", "disjoint-bottom", "disjoint-top"))):
            if name in c:
                good = good and all(x in c for x in needs)
                good = good and (c[name] == "refuted" or all(c[x] == "certified" for x in needs))
        self.ok(good, "claims")
    # the blocks

    def present(self, name):
        c, refuted = self.claims, lambda *names: any(self.claims.get(x) == "refuted" for x in names)
        if name == "overlay":
            return c.get("section") == "certified"
        if name in ("positivity", "no-section"):
            return refuted({"no-section": "section"}.get(name, name))
        if name == "no-order":
            return refuted("section-all-orders") and not refuted("positivity", "section")
        if name == "i2":
            needs = refuted("section-all-orders", "disjoint-bottom", "disjoint-top")
            return name in c and not (refuted("i2") and needs)
        return name in c

    def read_block(self, name):
        if not self.present(name):
            return
        self.ok(self.line() == "begin " + name)
        start, certified = self.row, self.claims.get(name) == "certified"
        if name == "positivity":
            facts = self.many("tet", self.tet)
        elif name == "overlay":
            facts = self.overlay()
        elif name == "no-section":
            facts = None, self.witness()
        elif name == "no-order":
            facts = self.take("first", "V", "V", distinct), self.witness()
        elif name == "i2" and certified:
            facts = self.many("contact-sep", lambda: self.separation("contact-sep", "TP4L", 3), 0)
        elif name == "i2":
            weighted = lambda f: any(f[3:6]) and any(f[6:10])
            facts = self.many("contact", lambda: self.take("contact", "TP4WWWWWWWX", None, weighted))
        else:
            facts = self.disjoint("TT" if name == "disjoint-mesh" else "TP", certified)
        self.blocks[name] = facts
        self.counts.append(self.row - start)

    def tet(self):
        return self.take("tet", "P4X")

    def overlay(self):
        seen = set()
        vertices = self.many("v", lambda: self.vertex_line(seen))
        self.bound["C"] = len(vertices)
        cells = self.many("c", lambda: self.take("c", "CCC", "C", distinct))
        self.bound["D"] = len(cells)
        named = [[], []]
        for side, word in enumerate(("mesh", "middle")):
            while not named[side] or self.data.startswith(b"d " + word.encode() + b" ", self.at):
                _, cell, triangle = self.take("d", ["=" + word, "D", "I"])
                self.ok(triangle < len(cells[cell]) - 2, "range")
                named[side].append((cell, triangle))
        return vertices, cells, named

    def vertex_line(self, seen):
        fields = tuple(self.take("v", "SN"))
        self.ok(fields not in seen, "duplicate")
        seen.add(fields)
        return fields

    def separation(self, word, kinds, key):
        """One `sep` or `contact-sep` line; its first `key` fields are greater than the line's before."""
        previous = self.before if self.before_row == self.row else []
        check = lambda f: previous < f[:key] and (kinds[:2] == "TP" or f[0] < f[1])
        fields = self.take(word, kinds, "L", check)
        self.before, self.before_row = fields[:key], self.row
        return fields[:key], fields[key:]

    before, before_row = [], -1

    def disjoint(self, kinds, certified):
        if certified:
            return self.many("sep", lambda: self.separation("sep", kinds + "L", 2), 0)
        check = lambda f: any(f[2:5]) and any(f[5:8]) and (kinds == "TP" or f[0] < f[1])
        return self.many("cross", lambda: self.take("cross", kinds + "WWWWWW", None, check))

    def witness(self):
        """A no-lift witness: (word, facts)."""
        if self.word() == "topology":
            euler = self.data.startswith(b"topology euler ", self.at)
            kinds = ["=euler", "J", "J"] if euler else ["=components", "I", "I"]
            return "topology", self.take("topology", kinds)
        if self.word() == "tet":
            return "tet", self.tet()
        return "roots", self.many("root", self.root)

    def root(self):
        head = self.take("root", "TWWW", None, lambda f: any(f[1:]))
        branches = []
        while self.word() == "branch":
            names, = self.take("branch", "N", None, lambda f: not branches or branches[-1][0] < f[0])
            legs = [self.leg()]
            if self.word() == "start":
                legs.append(self.leg())
            reason = self.line()
            one_leg = ("cap", "wall", "boundary", "fold", "lands")
            self.ok(reason in (one_leg if len(legs) == 1 else ("twice", "monodromy")))
            branches.append((names, legs, reason))
        return head, branches

    def leg(self):
        start, = self.take("start", "4")
        step = lambda: self.take("step", "TWWW4", None, lambda f: any(f[1:4]))
        return start, self.many("step", step, 0)

# ------------------------------------------------- sections 3 (inputs), 5 and 6: meshes and shells
SPACE = rb"[ \t\n\f\r]"
next_token = re.compile(SPACE + rb"*([^ \t\n\f\r]+)").match
next_face = re.compile(SPACE + rb"*3" + 3 * (SPACE + rb"+([0-9]+)") + rb"(?![^ \t\n\f\r])[^\n]*").match
is_number = re.compile(rb"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:e[+-]?[0-9]+)?").fullmatch
is_index = re.compile(rb"[0-9]+").fullmatch

def bad(condition, why):
    need(not condition, "input", why, "malformed")

def index(text, base=0):
    bad(not is_index(text) or len(text.lstrip(b"0")) > 10, "not an index")
    return int(text.lstrip(b"0") or b"0") - base

def coordinate(text):
    bad(not is_number(text), "not a number")
    return float(text)

def read_mesh(path):
    """(points, triangles) of an OFF or OBJ file; points are triples of floats."""
    data = read_file(path, "input")
    bad(data is None, "too large")
    data = data.replace(b"\v", b"?")
    stripped = re.sub(rb"#[^\n]*", b"", data)
    points, faces = read_off(stripped) if stripped.lstrip(b" \t\n\f\r").startswith(b"OFF") else read_obj(data)
    return checked_mesh(points, faces, path)

def checked_mesh(points, faces, path):
    bad(not points, f"{path}: no vertex")
    bad(not all(math.isfinite(x) for p in points for x in p), f"{path}: a coordinate is not finite")
    bad(not all(0 <= v < len(points) for f in faces for v in f), f"{path}: index out of range")
    return points, faces

def read_off(data):
    at = 0

    def token():
        nonlocal at
        match = next_token(data, at)
        bad(not match, "the file ends too early")
        at = match.end()
        return match[1]
    bad(token() != b"OFF", "not OFF")
    n, k = index(token()), index(token())
    bad(not is_index(token()), "no number of edges")
    points, faces = [], []
    for _ in range(n):
        points.append((coordinate(token()), coordinate(token()), coordinate(token())))
    for _ in range(k):
        match = next_face(data, at)
        bad(not match, "not a triangle")
        at = match.end()
        faces.append(tuple(index(x) for x in match.groups()))
    return points, faces

def read_obj(data):
    points, faces = [], []
    for line in re.split(b"\n", data):
        tokens = line.split()
        if tokens[:1] == [b"v"]:
            bad(len(tokens) < 4, "a vertex without three coordinates")
            points.append(tuple(coordinate(t) for t in tokens[1:4]))
        elif tokens[:1] == [b"f"]:
            bad(len(tokens) != 4, "a face without just three corners")
            faces.append(tuple(index(t.split(b"/", 1)[0], 1) for t in tokens[1:]))
    return points, faces

class Hdf5:
    """Contiguous n x 3 datasets of the root group of a classic HDF5 file."""

    def __init__(self, path):
        self.data, self.path = read_file(path, "input"), path
        bad(self.data is None, "too large")
        bad(self.part(0, 9) != b"\x89HDF\r\n\x1a\n\0" or self.part(13, 2) != b"\x08\x08", "not classic HDF5")
        bad(self.u(24, 8) != 0, "base address")
        group = self.messages(self.u(64, 8)).get(0x11, b"")
        bad(len(group) < 16, "no symbol table")
        tree, heap = struct.unpack("<QQ", group[:16])
        bad(self.part(heap, 5) != b"HEAP\0", "no heap")
        names = self.part(self.u(heap + 24, 8), self.u(heap + 8, 8))
        self.objects, todo, seen = {}, [tree], set()
        for node in todo:
            bad(node in seen, "cyclic group")
            seen.add(node)
            if self.part(node, 4) == b"SNOD":
                for at in range(node + 8, node + 8 + 40 * self.u(node + 6, 2), 40):
                    start = self.u(at, 8)
                    end = names.find(b"\0", start)
                    bad(end < 0, "name outside the heap")
                    bad(names[start:end] in self.objects, "name used twice")
                    self.objects[names[start:end]] = self.u(at + 8, 8)
            else:
                bad(self.part(node, 5) != b"TREE\0", "no tree node")
                todo += [self.u(node + 32 + 16 * i, 8) for i in range(self.u(node + 6, 2))]

    def part(self, at, size):
        bad(at + size > len(self.data), f"{self.path}: truncated")
        return self.data[at:at + size]

    def u(self, at, size):
        return int.from_bytes(self.part(at, size), "little")

    def messages(self, at):
        """The first message of each type of an object header, its continuation blocks included."""
        bad(self.u(at, 1) != 1, "object header version")
        left, found, blocks, seen = self.u(at + 2, 2), {}, [(at + 16, self.u(at + 8, 4))], set()
        for start, size in blocks:
            bad(start in seen or start + size > len(self.data), "bad header block")
            seen.add(start)
            at, end = start, start + size
            while left and at + 8 <= end:
                kind, length, flags = struct.unpack("<HHB", self.part(at, 5))
                bad(at + 8 + length > end or flags & 2 and kind in (1, 3, 8, 0x11), "bad message")
                body, at, left = self.part(at + 8, length), at + 8 + length, left - 1
                found.setdefault(kind, body)
                if kind == 0x10:
                    bad(length < 16, "bad continuation")
                    blocks.append(struct.unpack("<QQ", body[:16]))
        return found

    def rows(self, name, code, size):
        """The rows of a dataset of triples (code d: doubles of 8 bytes, i: integers of 4)."""
        bad(name not in self.objects, f"{self.path}: no dataset {name.decode()}")
        found = self.messages(self.objects[name])
        space, kind, layout = (found.get(m, b"") for m in (1, 3, 8))
        bad(0xB in found or len(space) < 24 or len(kind) < 12 or len(layout) < 18, "dataset not understood")
        n, three = struct.unpack("<QQ", space[8:24])
        bad(space[:2] != b"\1\2" or three != 3, "not an n x 3 dataset")
        ieee = struct.pack("<HHBBBBI", 0, 64, 52, 11, 0, 52, 1023)
        number, order, form = (1, 65, ieee) if code == "d" else (0, 1, b"\0\0\x20\0")
        bad(kind[0] & 15 != number or kind[1] & order or kind[8:8 + len(form)] != form, "number type")
        bad(kind[4:8] != bytes([size, 0, 0, 0]), "number size")
        where, length = struct.unpack("<QQ", layout[2:18])
        bad(layout[:2] != b"\3\1" or length != 3 * n * size, "dataset layout")
        numbers = struct.iter_unpack("<3" + code, self.part(where, length) if n else b"")
        return list(numbers)

    def mesh(self, points, faces):
        return checked_mesh(self.rows(points, "d", 8), self.rows(faces, "i", 4), self.path)

def read_inputs(paths, mesh_needed):
    """(the three layers' points, prisms, (mesh points, triangles)) from one to four files."""
    bad(not 1 <= len(paths) <= 4, "one to four input files")
    if len(paths) <= 2:
        file = Hdf5(paths[0])
        layers = [file.mesh(x, b"mF") for x in (b"mbase", b"mV", b"mtop")]
    else:
        layers = [read_mesh(path) for path in paths[:3]]
    bad(len({len(points) for points, _ in layers}) > 1, "numbers of vertices differ")
    bad(layers[0][1] != layers[1][1] or layers[1][1] != layers[2][1], "connectivities differ")
    mesh = read_mesh(paths[-1]) if len(paths) in (2, 4) else None
    if mesh_needed and not mesh:
        bad(len(paths) == 3, "no mesh is given")
        mesh = file.mesh(b"ref.V", b"ref.F")
    return [points for points, _ in layers], layers[0][1], mesh or ([], [])
