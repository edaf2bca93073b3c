#!/usr/bin/env python3
"""Writes the corpus of certificates about meshes: python3 make.py [--check]

A control is a folder with `control.cert` and its inputs; a mutant is a named corruption of one, `<mutant>.cert` (and
changed inputs); `table.tsv` says which answer MESHES.md asks for. Shapes and controls are in `controls.py`, mutants with
answers stated by hand in `mutants.py`. Planes and rays are found by trying; nothing here asks a checker. `--check`
writes nothing and fails unless the stored files are the ones that would be written.
"""
import fractions
import hashlib
import itertools
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from corpus_files import EXIT, HEAD, Misfit, recount, stored, swap, write  # noqa: E402  the path is set above

Q = fractions.Fraction


# ------------------------------------------------- geometry, on rationals
def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def value(plane, points, normal, x):
    kind, ids = plane
    a, b = points[ids[0]], points[ids[1]]
    if kind == "p":
        return dot(cross(minus(b, a), minus(points[ids[2]], a)), minus(points[x], a))
    direction = cross(minus(b, a), normal) if kind == "l" else minus(b, a)
    return dot(direction, minus(points[x], a))


def rest(plane, points, normal, A, B):
    """What a plane leaves of two sets of names, or None if it does not separate them."""
    a, b = ([value(plane, points, normal, x) for x in names] for names in (A, B))
    if not (max(a, default=0) <= 0 <= min(b, default=0) or min(a, default=0) >= 0 >= max(b, default=0)):
        return None
    return [x for x, v in zip(A, a) if v == 0], [x for x, v in zip(B, b) if v == 0]


def planes_for(points, A, B):
    """None if the pair needs no planes, else planes that separate it."""
    normal, common = cross(minus(points[A[1]], points[A[0]]), minus(points[A[2]], points[A[0]])), set(A) & set(B)
    done = lambda left: left is not None and common in (set(left[0]), set(left[1]))
    if any(done(rest(("p", face), points, normal, A, B)) for face in (A, B)):
        return None
    names = list(dict.fromkeys([*A, *B]))
    tries = [("n", x) for x in itertools.permutations(names, 2)] + [("l", x) for x in itertools.permutations(names, 2)]
    tries += [("p", x) for x in itertools.combinations(names, 3)]
    first = [(plane, rest(plane, points, normal, A, B)) for plane in tries]
    first = [(plane, left) for plane, left in first if left is not None]
    for plane, left in first:
        if done(left):
            return [plane]
    for plane, left in first:
        for second in tries:
            if done(rest(second, points, normal, *left)):
                return [plane, second]
    raise SystemExit(f"no planes for {A} {B}")


def boxes_meet(points, A, B):
    ranges = [[(min(c), max(c)) for c in zip(*(points[x] for x in face))] for face in (A, B)]
    return all(a[0] <= b[1] and b[0] <= a[1] for a, b in zip(*ranges))


def seps(points, left, right=None):
    """`sep` lines for faces given as {number: names}; names are written as in a plane."""
    for i, j in itertools.product(left, right or left):
        A, B = left[i], (right or left)[j]
        if (right or i < j) and boxes_meet(points, A, B):
            planes = planes_for(points, A, B)
            if planes:
                yield f"sep {i} {j} " + " ".join(f"{kind}:{','.join(ids)}" for kind, ids in planes)


def crossed(o, d, corners):
    """-1, 1: crossed inside, against or along the normal; 0: not met; None: anything else."""
    p, q, r = corners
    n = cross(minus(q, p), minus(r, p))
    slope, height = dot(n, d), dot(n, minus(p, o))
    if slope == 0:
        return 0 if height else None
    at = [x + Q(height, 1) / slope * y for x, y in zip(o, d)]
    inside = [dot(n, cross(minus(b, a), minus(at, a))) for a, b in ((p, q), (q, r), (r, p))]
    if min(inside) < 0 or height * slope < 0:
        return 0
    return (1 if slope > 0 else -1) if min(inside) > 0 and height else None


def ray(letter, mesh, vertex, other):
    """A `ray` line without its first word."""
    for d in itertools.product((7, 1, -3), (2, -5, 9), (4, -8, 3)):
        found = [crossed(mesh.points[vertex], d, [other.points[v] for v in cell]) for cell in other.cells]
        if None not in found:
            return " ".join(map(str, [letter, vertex, *d, *(i for i, x in enumerate(found) if x)]))
    raise SystemExit("no ray")


# ------------------------------------------------- meshes and their files
def number(x):
    x = Q(x)
    n, d = x.numerator, x.denominator
    if d & (d - 1):
        return f"{n}/{d}"
    twos = (n & -n).bit_length() - d.bit_length() if n else 0
    odd = n // (n & -n) if n else 0
    return f"{odd}*2^{twos}" if twos else str(odd)


class Mesh:
    """Points (of two or three rationals) and cells."""

    def __init__(self, points, cells):
        self.points, self.cells = [tuple(map(Q, p)) for p in points], [tuple(c) for c in cells]

    def complex_file(self):
        rows = ["homeo-complex 1", f"space {len(self.points[0])}", f"corners {len(self.cells[0])}", f"vertices {len(self.points)}"]
        rows += [" ".join(map(number, p)) for p in self.points] + [f"cells {len(self.cells)}"]
        return "\n".join(rows + [" ".join(map(str, c)) for c in self.cells] + ["end", ""])

    def off(self):
        rows = ["OFF", f"{len(self.points)} {len(self.cells)} 0"] + [" ".join(repr(float(x)) for x in p) for p in self.points]
        return "\n".join(rows + [" ".join(map(str, (3, *c))) for c in self.cells] + [""])

    def obj(self):
        rows = ["v " + " ".join(repr(float(x)) for x in p) for p in self.points]
        return "\n".join(rows + ["f " + " ".join(str(v + 1) for v in c) for c in self.cells] + [""])

    def file(self, ending):
        return {"off": self.off, "obj": self.obj, "complex": self.complex_file}[ending]()

    def moved(self, scale=1, by=(0, 0, 0)):
        return Mesh([[x * scale + y for x, y in zip(p, by)] for p in self.points], self.cells)

    def __add__(self, other):
        shift = len(self.points)
        return Mesh(self.points + other.points, self.cells + [tuple(v + shift for v in c) for c in other.cells])

    def turned(self):
        return Mesh(self.points, [c[::-1] if len(c) == 3 else (c[1], c[0], *c[2:]) for c in self.cells])

    def facet(self, f):
        k = len(self.cells[0])
        tables = {3: ((1, 2), (2, 0), (0, 1)), 4: ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))}
        return [self.cells[f // k][i] for i in tables[k][f % k]]

    def rim(self):
        sets = [frozenset(self.facet(f)) for f in range(len(self.cells) * len(self.cells[0]))]
        return [f for f, s in enumerate(sets) if sets.count(s) == 1]


def named(letter, mesh, faces):
    return {i: [f"{letter}{v}" for v in face] for i, face in faces}


def embedded(letter, mesh):
    points = {f"{letter}{v}": p for v, p in enumerate(mesh.points)}
    full = len(mesh.cells[0]) == len(mesh.points[0]) + 1
    if full and len(mesh.cells[0]) == 3:
        return []
    faces = ((f, mesh.facet(f)) for f in mesh.rim()) if full else enumerate(mesh.cells)
    return list(seps(points, named(letter, mesh, faces)))


def between(a, b):
    points = {f"{x}{v}": p for x, mesh in (("a", a), ("b", b)) for v, p in enumerate(mesh.points)}
    return list(seps(points, named("a", a, enumerate(a.cells)), named("b", b, enumerate(b.cells))))


def sha(mesh):
    return hashlib.sha256(mesh.complex_file().encode()).hexdigest()


def certificate(claim, verdict, meshes, blocks):
    rows = ["homeo-meshes 1", f"claim {claim} {verdict}"]
    for x, m in zip("ab", meshes):
        rows.append(f"input {x} {sha(m)} {len(m.points[0])} {len(m.cells[0])} {len(m.points)} {len(m.cells)}")
    for name, facts in blocks:
        rows += [f"begin {name}", *facts]
    rows.append(" ".join(["counts", *(str(len(facts)) for _, facts in blocks)]))
    return "\n".join(rows + ["end", ""])


# ------------------------------------------------- files and table
def drop(old):
    return swap(old + "\n", "")


def after(old, new):
    return swap(f"{old}\n", f"{old}\n{new}\n")


class Corpus:
    def __init__(self):
        self.files, self.rows, self.inputs, self.meshes = {}, [], {}, {}

    def control(self, name, claim, verdict, meshes, *blocks, endings=("complex", "complex")):
        """A control; `meshes` are a and b, `blocks` pairs of a name and fact lines."""
        names = [f"{x}.{ending}" for x, ending in zip("ab"[:len(meshes)], endings)]
        self.files[f"{name}/control.cert"] = certificate(claim, verdict, meshes, blocks)
        self.files.update((f"{name}/{file}", mesh.file(file[2:])) for file, mesh in zip(names, meshes))
        self.inputs[name], self.meshes[name] = names, meshes
        self.rows.append((name, "control", " ".join(names), "0", "-", f"{claim} {verdict}"))

    def mutant(self, control, name, answer, what, *edits, inputs=None, facts=True, **changed):
        """`answer` is what MESHES.md asks for; `changed` are other meshes a, b (their hashes are stated, true) or texts of
        input files; `inputs` other names to give than the control's; `facts`: true counts after the edits."""
        text, names = self.files[f"{control}/control.cert"], list(self.inputs[control])
        try:
            for x, new in changed.items():
                i = "ab".index(x)
                ending = names[i].rsplit(".", 1)[1]
                names[i] = f"{name}.{x}.{ending}"
                if isinstance(new, Mesh):
                    row = certificate("manifold", "certified", [new], []).split("\n")[2].replace("input a", f"input {x}")
                    text = re.sub(f"^input {x} .*$", row, text, flags=re.M)
                    new = new.file(ending)
                elif callable(new):
                    new = new(self.files[f"{control}/{self.inputs[control][i]}"])
                self.files[f"{control}/{names[i]}"] = new
            for edit in edits:
                text = edit(text)
        except Misfit as error:
            raise SystemExit(f"{control}/{name}: {error}")
        text = recount(text) if facts else text
        if text == self.files[f"{control}/control.cert"] and not changed and inputs is None:
            raise SystemExit(f"{control}/{name} changes nothing")
        if f"{control}/{name}.cert" in self.files or not re.fullmatch("[a-z0-9-]+", name):
            raise SystemExit(f"{control}/{name}: bad or double name")
        self.files[f"{control}/{name}.cert"] = text
        kind, _, code = answer.partition(" ")
        self.rows.append((control, name, " ".join(names if inputs is None else inputs) or "none", str(EXIT[kind]), code or "-", what))


def generated():
    import controls
    import mutants
    corpus = Corpus()
    controls.add_all(corpus)
    mutants.add_all(corpus)
    table = [HEAD] + ["\t".join(row) for row in sorted(corpus.rows)]
    return {name: text.encode("latin-1") for name, text in {**corpus.files, "table.tsv": "\n".join(table) + "\n"}.items()}


def main():
    write(HERE, "table.tsv", generated(), stored(HERE, "table.tsv"))


if __name__ == "__main__":
    sys.modules["make"] = sys.modules["__main__"]
    sys.path.insert(0, str(HERE))
    sys.dont_write_bytecode = True
    main()
