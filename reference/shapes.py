"""The words of FORMAT.md section 1 for the Python checker: exact vectors, complexes, prisms and their tets.

Every coordinate is an integer: the input's doubles times one common power of two.
"""
import itertools

sub = lambda a, b: (a[0] - b[0], a[1] - b[1], a[2] - b[2])
dot = lambda a, b: a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
det3 = lambda a, b, c: dot(a, cross(b, c))
det = lambda a, b, c, d: det3(sub(b, a), sub(c, a), sub(d, a))

def plane(a, b, c):
    """(n, h): n . x - h is det[b-a, c-a, x-a]."""
    n = cross(sub(b, a), sub(c, a))
    return n, dot(n, a)

def box(points):
    axes = list(zip(*points))
    return tuple(map(min, axes)) + tuple(map(max, axes))

def meet(a, b):
    return a[0] <= b[3] and b[0] <= a[3] and a[1] <= b[4] and b[1] <= a[4] and a[2] <= b[5] and b[2] <= a[5]

def box_tree(boxes, ids):
    """(box of all, ids, children): median splits along the longest side; depth is logarithmic."""
    whole = tuple(f(boxes[i][k] for i in ids) for k, f in enumerate((min, min, min, max, max, max)))
    if len(ids) <= 4:
        return whole, ids, ()
    axis = max(range(3), key=lambda k: whole[k + 3] - whole[k])
    ids, half = sorted(ids, key=lambda i: boxes[i][axis] + boxes[i][axis + 3]), len(ids) // 2
    return whole, (), (box_tree(boxes, ids[:half]), box_tree(boxes, ids[half:]))

def meeting(tree, boxes, query):
    """The ids whose closed box meets the query box."""
    found, todo = [], [tree]
    for whole, ids, children in todo:
        if meet(whole, query):
            found += [i for i in ids if meet(boxes[i], query)]
            todo += children
    return found

class Complex:
    """Oriented triangles with their edges, boundary and components."""

    def __init__(self, faces):
        self.faces, self.at, self.edge, self.simplices = faces, {}, {}, set()
        for i, (a, b, c) in enumerate(faces):
            for e in ((a, b), (b, c), (c, a)):
                self.edge[e] = i
                self.at.setdefault(e[0], []).append(i)
        self.find = {tuple(sorted(f)): i for i, f in enumerate(faces)}
        self.rim = {frozenset(e) for e in self.edge if e[::-1] not in self.edge}
        self.rim |= {frozenset([v]) for e in self.rim for v in e}
        self.count, self.component = 0, [None] * len(faces)
        for start in range(len(faces)):
            todo = [start] if self.component[start] is None else []
            self.count += len(todo)
            for i in todo:
                if self.component[i] is None:
                    self.component[i] = self.count - 1
                    todo += self.neighbours(i)

    def sides(self, i):
        a, b, c = self.faces[i]
        return (a, b), (b, c), (c, a)

    def neighbours(self, i):
        return [self.edge[b, a] for a, b in self.sides(i) if (b, a) in self.edge]

    def euler(self):
        return len(self.at) - len({frozenset(e) for e in self.edge}) + len(self.faces)

    def manifold(self):
        """No repeated corner, directed edge or triangle; the triangles at a vertex are one path or cycle."""
        n = len(self.faces)
        if not n or any(len(set(f)) < 3 for f in self.faces) or len(self.edge) < 3 * n or len(self.find) < n:
            return False
        for v, around in self.at.items():
            turn = {}
            for i in around:
                a, b, c = self.faces[i]
                turn.update([(b, c) if v == a else (c, a) if v == b else (a, b)])
            first = here = next(iter(turn.keys() - set(turn.values())), next(iter(turn)))
            for step in range(1, len(turn) + 1):  # follows the link of v
                here = turn.get(here)
                if here not in turn or here == first:
                    break
            if step < len(turn):
                return False
        return True

def templates():
    """For each order of a prism's corners, its three tets: four (corner, 0 lo | 1 hi), pillar's corner."""
    table = {}
    for u, v, w in itertools.permutations(range(3)):
        even = (v - u) % 3 == 1
        table[u, v, w] = []
        for t, pillar in (((u, 0), (v, 0), (w, 0), (w, 1)), w), (((u, 0), (v, 0), (v, 1), (w, 1)), v), \
                (((u, 0), (u, 1), (v, 1), (w, 1)), u):
            t = t if even != (pillar == v) else t[:2] + (t[3], t[2])
            table[u, v, w].append((t, pillar))
    return table

ORDERS = templates()
ALL12 = list({frozenset(t): (t, pillar) for three in ORDERS.values() for t, pillar in three}.values())

class Case:
    """Shell and mesh with integer coordinates; `P` by name, `G` by mesh vertex; a point is times 2^shift."""

    def __init__(self, layers, prisms, points, triangles):
        every = itertools.chain(*layers, points)
        self.shift = max((x.as_integer_ratio()[1].bit_length() - 1 for p in every for x in p), default=0)
        layers = [[self.scale(p) for p in layer] for layer in layers]
        self.P = [layer[v] for v in range(len(layers[0])) for layer in layers]
        self.G = [self.scale(p) for p in points]
        self.pinned = [v for v, (b, m, t) in enumerate(zip(*layers)) if b == m == t]
        pinned = self.pin = set(self.pinned)
        names = lambda v: (3 * v + 1,) * 3 if v in pinned else (3 * v, 3 * v + 1, 3 * v + 2)
        self.N = [names(v) for v in range(len(layers[0]))]
        self.M, self.T = Complex(prisms), Complex(triangles)
        self.planes = [plane(*(self.G[v] for v in f)) for f in triangles]

    def scale(self, p):
        ratios = [x.as_integer_ratio() for x in p]
        return tuple(n << (self.shift - d.bit_length() + 1) for n, d in ratios)

    def prepare(self):
        P, G = self.P, self.G
        self.mesh_boxes = [box([G[v] for v in f]) for f in self.T.faces]
        self.prism_boxes = [box([P[n] for v in f for n in self.N[v]]) for f in self.M.faces]
        self.cache = {}

    def tets(self, prism, chosen=ALL12):
        """{names: (names in positive order, lo, hi of the pillar)} of a prism in both slabs."""
        corners, N, found = self.M.faces[prism], self.N, {}
        for slab in (0, 1):
            for t, pillar in chosen:
                v = corners[pillar]
                if v not in self.pin:
                    order = [N[corners[c]][slab + h] for c, h in t]
                    found[tuple(sorted(order))] = order, N[v][slab], N[v][slab + 1]
        return found

    def decomposition(self, order):
        """S_< by prism, for a list of all vertices, smallest first."""
        rank = {v: i for i, v in enumerate(order)}
        return [self.tets(j, ORDERS[tuple(sorted(range(3), key=lambda c: rank[f[c]]))])
                for j, f in enumerate(self.M.faces)]

    def volume(self, tet):
        return det(*(self.P[n] for n in tet[0]))

    def sign(self, f, tet):
        """The dot of triangle f with a tet."""
        return dot(self.planes[f][0], sub(self.P[tet[2]], self.P[tet[1]]))

    def clear(self, f, prism):
        """Whether f has a positive dot with both halves of all unpinched pillars of the prism."""
        if (f, prism) not in self.cache:
            P, n = self.P, self.planes[f][0]
            self.cache[f, prism] = all(dot(n, P[a]) < dot(n, P[a + 1]) < dot(n, P[a + 2]) for a, b, c in
                                       (self.N[v] for v in self.M.faces[prism]) if a != b)
        return self.cache[f, prism]

    def faces(self, names):
        """The planes of a tet's four faces, each positive on the fourth corner."""
        p = [self.P[n] for n in names]
        for k in range(4):
            n, h = plane(*p[:k], *p[k + 1:])
            yield (n, h) if dot(n, p[k]) >= h else (tuple(-x for x in n), -h)

    def equals(self, scaled, value):
        """Whether an integer that stands for scaled / 2^(3 shift) is the file's value odd * 2^exp."""
        odd, exp = value[0], value[1] + 3 * self.shift
        return odd << exp == scaled if exp >= 0 else odd == scaled << -exp

    def mix(self, corners, weights):
        """The weighted point as (x, y, z, w)."""
        return tuple(sum(w * p[k] for w, p in zip(weights, corners)) for k in range(3)) + (sum(weights),)

    def same(self, x, y):
        return all(x[k] * y[3] == y[k] * x[3] for k in range(3))

    def cap(self, names):
        free = [n % 3 for n in names if n // 3 not in self.pin]
        return (free or len(names) > 1) and (all(x == 2 for x in free) or all(x == 0 for x in free))
