"""Changes for compare_checkers.py that know what a shell is: a certificate often stays valid, so that all its rules are reached.

Coordinates are stretched by powers of two (another one for each axis), moved, turned by one unit in the last place, and
put beside far points, whose leading bits take those of the others away. Vertices get other numbers and faces another
order, in the certificate too. Cells of an overlay are turned, divided, fused and dropped, carriers shifted and changed.
Cases are (certificate, bottom, middle, top, mesh), in bytes.
"""
import math
import re

EXPONENTS = [-1000, -600, -300, -70, -53, -30, -3, 0, 0, 0, 1, 20, 27, 39, 41, 53, 79, 81, 125, 127, 300, 600, 1000]


class Off:
    """A regular OFF file: the numbers of its points as words, its faces as numbers."""

    def __init__(self, data):
        rows = data.decode("latin-1").split("\n")
        points, faces = map(int, rows[1].split()[:2])
        self.points = [[float(x) for x in row.split()[:3]] for row in rows[2:2 + points]]
        self.faces = [list(map(int, row.split()[1:4])) for row in rows[2 + points:2 + points + faces]]

    def data(self):
        rows = ["OFF", f"{len(self.points)} {len(self.faces)} 0"]
        rows += [" ".join(map(repr, p)) for p in self.points] + ["3 " + " ".join(map(str, f)) for f in self.faces]
        return ("\n".join(rows) + "\n").encode()


def coordinates(rng, meshes):
    """Some changes of the coordinates of all four meshes."""
    offs = [Off(mesh) for mesh in meshes]
    for _ in range(rng.choice([1, 1, 2, 3])):
        rng.choice([stretch, stretch, move, nudge, nudge, far, shear])(rng, offs)
    return [off.data() for off in offs]


def stretch(rng, offs):
    powers = [rng.choice(EXPONENTS)] * 3 if rng.random() < 0.3 else [rng.choice(EXPONENTS) for _ in range(3)]
    change(offs, lambda p: [math.ldexp(x, k) if math.frexp(x)[1] + k < 1020 else x for x, k in zip(p, powers)])


def move(rng, offs):
    """Along one axis: the points then keep fewer bits of their own."""
    axis, far_away = rng.randrange(3), rng.choice([-1.0, 1.0]) * 2.0 ** rng.choice([3, 20, 40, 49, 50, 51, 52, -20, -60])
    change(offs, lambda p: [x + far_away * (i == axis) for i, x in enumerate(p)])


def shear(rng, offs):
    a, b = rng.sample(range(3), 2)
    factor = rng.choice([-2.0, -1.0, 0.5, 1.0, 3.0, 2.0 ** 20, 2.0 ** -30])
    change(offs, lambda p: [x + factor * p[b] if i == a else x for i, x in enumerate(p)])


def nudge(rng, offs):
    """One to three coordinates by one unit in the last place."""
    for _ in range(rng.choice([1, 2, 3])):
        off = rng.choice(offs)
        point, axis = rng.choice(off.points), rng.randrange(3)
        point[axis] = math.nextafter(point[axis], rng.choice([-math.inf, math.inf]))


def far(rng, offs):
    """A vertex of the mesh that no face uses: other points have few leading bits beside it, or it has bits below theirs."""
    top = math.frexp(max((abs(x) for off in offs for p in off.points for x in p), default=1.0))[1]
    bits = rng.choice([1, 10, 26, 27, 28, 29, 40, 60, 70, 77, 78, 79, 80, 81, 90, 124, 125, 126, 127, 128, 900])
    value = math.ldexp(1.0, min(1020, top + bits) if rng.random() < 0.8 else top - bits)
    offs[3].points.append([rng.choice([0.0, value, -value]) for _ in range(3)])


def change(offs, function):
    new = [[function(p) for p in off.points] for off in offs]
    if all(map(math.isfinite, (x for points in new for p in points for x in p))):
        for off, points in zip(offs, new):
            off.points = points


# ------------------------------------------------- other numbers
def faces(rng, meshes):
    """The prisms, or the mesh's triangles, in another order, each from another corner on."""
    offs = [Off(mesh) for mesh in meshes]
    group = offs[:3] if rng.random() < 0.5 else offs[3:]
    order = list(range(len(group[0].faces)))
    rng.shuffle(order)
    turns = [rng.randrange(3) for _ in order]
    for off in group:
        off.faces = [off.faces[i][turn:] + off.faces[i][:turn] for i, turn in zip(order, turns)]
    return [off.data() for off in offs]


NAMES = re.compile(r"(?<![\w:])[bmt]\d+(?:,[bmt]\d+)*(?!\S)")


def vertices(rng, cert, meshes):
    """Other numbers for the vertices of the shell, or of the mesh; names and lists of ids in the certificate follow."""
    offs = [Off(mesh) for mesh in meshes]
    group = offs[:3] if rng.random() < 0.6 else offs[3:]
    new = list(range(len(group[0].points)))
    if rng.random() < 0.5:
        rng.shuffle(new)
    else:
        i, j = rng.randrange(len(new)), rng.randrange(len(new))
        new[i], new[j] = new[j], new[i]
    for off in group:
        if len(off.points) != len(new):
            return cert, meshes
        points = list(off.points)
        for old, point in enumerate(off.points):
            points[new[old]] = point
        off.points, off.faces = points, [[new[v] for v in face] for face in off.faces]
    text = cert.decode("latin-1")
    at = lambda v: new[v] if v < len(new) else v
    if len(group) == 3:
        text = shell_names(text, new, at)
    else:
        text = re.sub(r"^v (\S+)", lambda m: "v " + ",".join(map(str, sorted(at(int(v)) for v in m[1].split(",")))), text, flags=re.M)
        text = re.sub(r"(?<=[:,])g(\d+)", lambda m: f"g{at(int(m[1]))}", text)
    return text.encode("latin-1"), [off.data() for off in offs]


def shell_names(text, new, at):
    def renamed(match):
        names = [(at(int(n[1:])), n[0]) for n in match[0].split(",")]
        return ",".join(f"{layer}{v}" for v, layer in sorted(names))
    text = NAMES.sub(renamed, text)
    text = re.sub(r"\b[pln]:\S+", lambda m: re.sub(r"([bmt])(\d+)", lambda n: f"{n[1]}{at(int(n[2]))}", m[0]), text)
    old = re.search(r"^order list (.*)$", text, re.M)
    order = [at(int(v)) for v in (old[1].split(" ") if old else map(str, range(len(new))))]
    text = re.sub("^order .*$", "order id" if order == sorted(order) else "order list " + " ".join(map(str, order)), text, flags=re.M)

    def pinched(match):
        count, *ids = match[1].split(" ")
        return "pinched " + " ".join([count, *map(str, sorted(at(int(v)) for v in ids))])
    text = re.sub(r"^pinched (.*)$", pinched, text, flags=re.M)
    return re.sub(r"^first (.*)$", lambda m: "first " + " ".join(str(at(int(v))) for v in m[1].split(" ")), text, flags=re.M)


# ------------------------------------------------- the overlay
def overlay(rng, cert):
    """One to three changes of the rows of an overlay; most keep each row within the grammar, some keep the whole valid."""
    rows = cert.decode("latin-1").split("\n")
    start = rows.index("begin overlay") + 1  # ValueError if there is none
    block = [row.split(" ") for row in rows[start:]]
    v, c, d = ([row for row in block if row[0] == word] for word in "vcd")
    stop = start + len(v) + len(c) + len(d)
    for _ in range(rng.choice([1, 1, 2, 3])):
        rng.choice([renumber, turn, divide, fuse, drop, twice, shift, carrier, lift, degree])(rng, v, c, d)
    new = [" ".join(row) for row in [*v, *c, *d]]
    return "\n".join(rows[:start] + new + rows[stop:]).encode("latin-1")


def renumber(rng, v, c, _):
    order = list(range(len(v)))
    rng.shuffle(order)
    v[:] = [v[i] for i in order]
    place = {str(old): str(new) for new, old in enumerate(order)}
    c[:] = [["c", *(place.get(x, x) for x in row[1:])] for row in c]


def turn(rng, _v, c, _d):
    row = rng.choice(c)
    k = rng.randrange(1, len(row))
    row[1:] = row[:0:-1] if rng.random() < 0.2 else row[k:] + row[1:k]


def divide(rng, _v, c, _d):
    """A polygon into two; `d` lines may then be about something else."""
    long = [row for row in c if len(row) > 4]
    if long:
        row = rng.choice(long)
        at = rng.randrange(3, len(row) - 1)
        c.insert(c.index(row) + 1, ["c", row[1], *row[at:]])
        del row[at + 1:]


def fuse(rng, _v, c, _d):
    """Two cells with a common edge into one polygon."""
    one, two = rng.choice(c), rng.choice(c)
    for a, b in zip(one[1:], one[2:] + one[1:2]):
        if one is not two and a in two and b in two:
            i, j = one.index(a), two.index(b)
            if (two[1:] * 2)[j] == a:
                rest = (two[1:] * 2)[j + 1:j + len(two) - 2]
                one[i + 1:i + 1] = rest
                c[:] = [row for row in c if row is not two]
                return


def drop(rng, v, c, d):
    rows = rng.choice([v, c, c, c, d])
    if len(rows) > 1:
        del rows[rng.randrange(len(rows))]


def twice(rng, _, c, d):
    rows = rng.choice([c, c, d])
    rows.insert(rng.randrange(len(rows) + 1), list(rng.choice(rows)))


def shift(rng, v, _c, _d):
    """The carriers on one side, each to the next row."""
    a = rng.randrange(len(v))
    some, side = v[a:a + rng.choice([2, 2, 3, len(v)])], rng.choice([1, 2])
    for row, value in zip(some, [row[side] for row in some[1:] + some[:1]]):
        row[side] = value


def carrier(rng, v, _c, _d):
    """A carrier with an item more or less, or that of another row."""
    row, side = rng.choice(v), rng.choice([1, 2])
    items = row[side].split(",")
    key = (lambda x: (int(x), "")) if side == 1 else (lambda x: (int(x[1:]), x[0]))
    other = rng.choice(v)[side].split(",")
    kind = rng.randrange(3)
    new = {*items, *other} if kind == 0 else set(rng.sample(items, max(1, len(items) - 1))) if kind == 1 else {*other}
    row[side] = ",".join(sorted(new, key=key))


def lift(rng, v, _c, _d):
    """All names of a row, or of all rows, one layer up or down, or with another layer."""
    letters = str.maketrans("bmt", rng.choice(["mtt", "bbm", "mtb", "tmb", "bmm", "mmt"]))
    for row in [rng.choice(v)] if rng.random() < 0.7 else v:
        row[2] = row[2].translate(letters)


def degree(rng, _, c, d):
    row = rng.choice(d)
    row[2] = str(rng.randrange(len(c)))
    row[3] = str(rng.randrange(max(1, len(c[int(row[2])]) - 3)))
