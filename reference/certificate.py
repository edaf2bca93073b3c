"""Reads a certificate file: section 2 of certs/FORMAT.md, and "Certificate file" of its section 3.

A *tag* is an integer that names a point: 3 * vertex + layer (b 0, m 1, t 2) for a shell name, ~v for mesh vertex v.
"""
import functools, re

DIGITS = 4000
ascending = lambda items: all(a < b for a, b in zip(items, items[1:]))
distinct = lambda items: len(set(items)) == len(items)
class Stop(Exception): pass  # the first failure: kind (`invalid`, `malformed`, `limit`), code, explanation
def need(condition, code, why="", kind="invalid"):
    if not condition: raise Stop(kind, code, why)

CLAIMS = ["positivity", "section", "bijection", "section-all-orders", "disjoint-mesh", "disjoint-bottom",
          "disjoint-top", "i2", "disjoint-prisms"]
ID, W, NAME = "(?:0|[1-9][0-9]{0,9})", "(?:0|[1-9][0-9]*)", "[bmt](?:0|[1-9][0-9]{0,9})"
number = lambda text: int(text[:DIGITS + 2])  # numbers that are cut short are over the limit of digits
numbers = lambda text: tuple(map(number, text.split(" ")))
tag = lambda text: ~int(text[1:]) if text[0] == "g" else 3 * int(text[1:]) + "bmt".index(text[0])
tags = lambda text: tuple(map(tag, text.split(",")))
FIELDS = {  # kind: regular expression and value of a field
    **dict.fromkeys("IVTPGCD", (ID, int)),  # any, shell vertex, triangle, prism, mesh vertex, `v`, `c` line
    "K": ("|".join(CLAIMS), str), "R": ("certified|refuted", str), "H": ("[0-9a-f]{64}", str),
    "A": (rf"(?!0 0 0\b){W} {W} {W}", numbers), "B": (rf"(?!0 0 0 0\b){W} {W} {W} {W}", numbers),  # weights
    "J": ("0|-?[1-9][0-9]{0,9}", int),  # INT, and VALUE as (odd, exponent):
    "X": (r"0|-?(?:[1-9][0-9]*)?[13579](?:\*2\^-?[1-9][0-9]{0,4})?",
          lambda text: tuple(map(number, (text + "*2^0").split("*2^")[:2]))),
    "S": (f"{ID}(?:,{ID}){{0,2}}", lambda text: tuple(map(int, text.split(",")))),  # TIDS
    "N": (f"{NAME}(?:,{NAME})*", tags), "Q": (f"{NAME}(?:,{NAME}){{3}}", tags),  # NAMES, TET, and PLANE:
    "L": ("(?:p:POINT,|[ln]:)POINT,POINT".replace("POINT", "[bmtg]" + ID), lambda text: (text[0], tags(text[2:])))}
@functools.lru_cache(None)
def grammar(spec):  # A line's expression, a group for each field, and its fields (kind, how often if not once)
    words = [(word[0], word[1:]) if word[0] in FIELDS else ("", word) for word in spec.split(" ")]
    field = lambda one, times: f"((?: (?:{one})){times})" if times else f" ({one})"
    parts = [field(FIELDS[kind][0], rest) if kind else " " + rest for kind, rest in words]
    return re.compile(("\n" + "".join(parts)[1:] + "(?=\n)").encode()), [word for word in words if word[0]]

class Certificate:  # what it says: `claims`, `shell`, `mesh`, `order`, `pinched`, `blocks`
    def __init__(self, data):
        self.data, self.at, self.row, self.bound, self.blocks, counts = data, 19, 1, {}, {}, []
        self.ok(not re.search(rb"[^\n\x20-\x7e]", data), "bytes")
        self.ok(data == b"end\n" or data.endswith(b"\nend\n"), "truncated")
        self.ok(data.startswith(b"homeo-certificate 1\n"), "magic")
        claims = list(self.each("claim K R"))
        self.ok(ascending([CLAIMS.index(name) for name, _ in claims]))
        self.claims = dict(claims)
        present = self.plan()
        self.shell = self.line("shell H I I")
        self.mesh = None if {*self.claims} <= {CLAIMS[0], CLAIMS[8]} else self.line("mesh H I I")
        self.bound = dict(zip("VPGT", self.shell[1:] + (self.mesh or [0, 0, 0])[1:]))
        other = lambda f: len(f[0]) == self.shell[1] and distinct(f[0]) and f[0] != list(range(len(f[0])))
        self.order = self.line("order list V+", other)[0] if self.ahead("order list") else self.line("order id")
        self.pinched = self.line("pinched I V*", lambda f: ascending(f[1]))
        for name in present:
            self.line("begin " + name)
            start = self.row
            self.blocks[name] = self.block(name, self.claims.get(name) == "certified")
            counts.append(self.row - start)
        self.ok(self.line("counts I*") == [counts], "counts")
        self.line("end")
        self.ok(self.at == len(data) - 1)
    def ok(self, condition, code="syntax", kind="malformed"): need(condition, code, f"line {self.row}", kind)
    def ahead(self, words): return re.compile(f"\n{words}[ \n]".encode()).match(self.data, self.at)
    def line(self, spec, good=lambda fields: True):  # the fields of the next line; `at` is the LF before it
        pattern, kinds = grammar(spec)
        match, self.row, fields, items = pattern.match(self.data, self.at), self.row + 1, [], []
        self.ok(match)
        self.at = match.end()
        for (kind, times), text in zip(kinds, match.groups()):
            values = [FIELDS[kind][1](x) for x in (text.decode().split(" ")[1:] if times else [text.decode()])]
            fields.append(values if times else values[0])
            items += [(kind, value) for value in values]
        self.ok(all(ascending(value) for kind, value in items if kind in "NQS") and good(fields))
        self.ok(not re.search(rb"(?<![0-9])[0-9]{%d}" % (DIGITS + 1), match[0]), "digits", "limit")
        self.ok(all(self.in_range(*item) for item in items), "range")
        return fields
    def in_range(self, kind, value):
        points = value if kind in "NQ" else value[1] if kind == "L" else [~v for v in value] if kind == "S" else ()
        return (all(-self.bound["G"] <= p < 3 * self.bound["V"] for p in points)
                and (kind not in self.bound or value < self.bound[kind]))
    def each(self, spec, least=1, good=lambda fields, previous: True):  # lines that start with the first words of spec
        fields, words = [], re.split(" (?=[A-Z])", spec)[0]
        while least > 0 or self.ahead(words):
            fields, least = self.line(spec, lambda found: good(found, fields)), least - 1
            yield fields
    def plan(self):  # checks that the claims fit together; the blocks that must be present, in order
        said, refuted = self.claims.get, lambda *names: any(self.claims.get(x) == "refuted" for x in names)
        self.ok(said("section") == said("bijection"), "claims")
        parts = {"section-all-orders": ("positivity", "section"), "i2": ("section-all-orders", *CLAIMS[5:7])}
        for name in filter(said, parts):
            self.ok(all(map(said, parts[name])) and (refuted(name) or not refuted(*parts[name])), "claims")
        present = {"positivity": refuted("positivity"), "overlay": said("section") == "certified",
                   "no-section": refuted("section"),
                   "no-order": refuted("section-all-orders") and not refuted("positivity", "section"),
                   **{name: said(name) for name in CLAIMS[4:7]},
                   "i2": said("i2") and not (refuted("i2") and refuted(*parts["i2"])),
                   "disjoint-prisms": said("disjoint-prisms")}
        return filter(present.get, present)
    def block(self, name, certified):  # the fact lines of a block
        if name == "positivity": return list(self.each("tet P Q X"))
        if name == "overlay": return self.overlay()
        if name in ("no-section", "no-order"):
            first = self.line("first V+", lambda f: distinct(f[0]))[0] if name == "no-order" else []
            return first, self.witness()
        if name == "disjoint-prisms" and not certified:
            return self.witness() if self.ahead("tet") else ("overlap", list(self.each("overlap Q B Q B")))
        i, j = {"disjoint-mesh": "TT", "disjoint-prisms": "II"}.get(name, "TP")
        spec, least = (f"sep {i} {j} L+", 0) if certified else (f"cross {i} {j} A A", 1)
        if name == "i2": spec = "contact-sep T P Q L+" if certified else "contact T P Q A B X"
        good = lambda f, previous: (i != j or f[0] < f[1]) and (not certified or previous[:-1] < f[:-1])
        return list(self.each(spec, least, good))
    def overlay(self):
        vertices, named = {}, ([], [])
        for ids, names in self.each("v S N"):
            self.ok((ids, names) not in vertices, "duplicate")
            vertices[ids, names] = None
        self.bound["C"] = len(vertices)
        cells = [cell for cell, in self.each("c C{3,}", 1, lambda f, _: distinct(f[0]))]
        self.bound["D"] = len(cells)
        for lines, word in zip(named, ("mesh", "middle")):
            for cell, triangle in self.each(f"d {word} D I"):
                self.ok(triangle < len(cells[cell]) - 2, "range")
                lines.append((cell, triangle))
        return vertices, cells, named
    def witness(self):
        for words, fields in (("topology components", "I I"), ("topology euler", "J J"), ("tet", "P Q X")):
            if self.ahead(words): return words, self.line(f"{words} {fields}")
        return "roots", [(*root, list(self.branches())) for root in self.each("root T A")]
    def branches(self):
        leg = lambda: (*self.line("start Q"), list(self.each("step T A Q", 0)))
        for names, in self.each("branch N", 0, lambda f, previous: previous < f):
            legs = [leg()] + ([leg()] if self.ahead("start") else [])
            reasons = ["twice", "monodromy"] if len(legs) > 1 else ["cap", "wall", "boundary", "fold", "lands"]
            reason = next(filter(self.ahead, reasons), reasons[0])
            self.line(reason)
            yield names, legs, reason
