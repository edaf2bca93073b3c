"""The Python checker of certificates about meshes: the corpus, and parts of it against brute force from definitions."""
import itertools
import random
import sys
import unittest
from fractions import Fraction

import check_meshes
import corpora
from check_meshes import Complex

CORPUS = corpora.CERTS / "corpus-meshes"
sys.path.append(str(CORPUS))

import controls  # noqa: E402  the shapes of the corpus


class Corpus(unittest.TestCase):
    maxDiff = None

    def test_table(self):
        wrong, many = [], 0
        for control, mutant, inputs, status, code in corpora.rows("corpus-meshes/table.tsv"):
            cert = CORPUS / control / f"{mutant}.cert"
            found, text = check_meshes.run([str(cert), *(str(CORPUS / control / name) for name in inputs)])
            head, *claims = text.split("\n")
            if (found, corpora.code(text)) != (status, code):
                wrong.append(f"{control}/{mutant}: {found} {head}, but the table says {status} {code}")
            elif status == 0:
                self.assertEqual(["claim " + claim for claim in claims], cert.read_text("ascii").split("\n")[1:2], str(cert))
            many += 1
        self.assertEqual(wrong, [])
        self.assertGreaterEqual(many, 350)

    def test_files_are_the_generated_ones(self):
        self.assertEqual(corpora.regenerated("corpus-meshes/make.py"), (0, ""))

    def test_usage(self):
        self.assertEqual(check_meshes.run([])[0], 2)
        self.assertEqual(check_meshes.run([str(CORPUS / "no-such.cert")]), (2, "malformed usage : check_meshes.py CERT A [B]"))


class Geometry(unittest.TestCase):
    def test_numbers(self):
        for text, value in (("0", 0), ("-3", -3), ("5*2^2", 20), ("-1*2^-3", Fraction(-1, 8)), ("-2/3", Fraction(-2, 3))):
            self.assertEqual(check_meshes.number(text)[0], value)
        for text in ("2", "-0", "4*2^1", "1*2^0", "1/2", "2/6", "0/3", "3/1", "1.0", "+1", "01", "1/0", "", "1/3*2^1"):
            with self.assertRaises((ValueError, AttributeError), msg=text):
                check_meshes.number(text)
        rng = random.Random(1)
        for x in [0.0, -0.0, 1.5, 5e-324, -1e308, 2.0 ** 70, 3.0, *(rng.uniform(-9, 9) for _ in range(99))]:
            self.assertEqual(check_meshes.number(check_meshes.text_of(x))[0], Fraction(x))

    def test_rays_against_definition(self):
        """A ray meets a triangle where o + t d is a mean of the corners: here by clipping, there by Cramer's rule."""
        rng, seen = random.Random(2), set()
        point = lambda: tuple(rng.randrange(-2, 3) for _ in range(3))
        for _ in range(3000):
            o, d, corners = point(), point(), [point(), point(), point()]
            p, q, r = corners
            if not any(d) or not any(check_meshes.plane(*corners)[0]):
                continue
            # Unknown t >= 0 and weights; all vertices of {t, u, v >= 0, u + v <= 1} solutions by elimination.
            found = check_meshes.ray_meets(o, d, corners)
            hits = hit_parameters(o, d, corners)
            self.assertEqual(found is None, not hits, (o, d, corners))
            if hits == "line":
                self.assertEqual(found, 0)
            elif hits:
                t, u, v = hits
                self.assertEqual(found != 0, min(t, u, v) > 0 and u + v < 1, (o, d, corners))
            seen.add(found)
        self.assertEqual(seen, {None, 0, 1, -1})

    def test_edges_in_the_plane_against_definition(self):
        rng, many = random.Random(3), [0, 0]
        for _ in range(1200):
            places = [(rng.randrange(4), rng.randrange(4), 0) for _ in range(4)]
            A, B = (0, 1), rng.choice([(2, 3), (1, 2), (2, 0), (0, 2), (2, 1)])
            p, q, r, s = (places[v] for v in A + B)
            if p == q or r == s:
                continue
            # On a fine grid of both edges: lengths are below 5, so crossings have denominators of at most 18.
            cuts = [Fraction(i, n) for n in range(1, 19) for i in range(n + 1)]
            mean = lambda a, b, t: (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
            left, right = ({mean(*ends, t): t for t in cuts} for ends in ((p, q), (r, s)))
            name = lambda t, ends: ends[int(t)] if t in (0, 1) else None
            share = any(not (name(left[x], A) is not None and name(left[x], A) == name(right[x], B)) for x in left.keys() & right.keys())
            self.assertEqual(check_meshes.share(p, q, r, s, A, B), share, (p, q, r, s, A, B))
            many[share] += 1
        self.assertGreater(min(many), 100)

    def test_topology(self):
        grid = lambda n, m: [t for i in range(n) for j in range(m) for t in
                             (((i % n, j % m), ((i + 1) % n, j % m), ((i + 1) % n, (j + 1) % m)),
                              ((i % n, j % m), ((i + 1) % n, (j + 1) % m), (i % n, (j + 1) % m)))]
        names = {v: k for k, v in enumerate(itertools.product(range(3), range(4)))}
        torus = [tuple(names[v] for v in t) for t in grid(3, 4)]
        surface = Complex(3, 3, [(0, 0, 0)] * 12, torus)
        surface.check_sound()
        self.assertEqual(surface.topology(), {(0, 0): 1})
        open_torus = Complex(3, 3, [(0, 0, 0)] * 12, torus[1:])
        self.assertEqual(open_torus.topology(), {(-1, 1): 1})
        tets = Complex(3, 4, [(0, 0, 0)] * 13, [(12, c, b, a) for a, b, c in torus])
        self.assertTrue(tets.link_is_wrong(12, range(24)))
        self.assertFalse(tets.link_is_wrong(0, tets.star([0])))

    def test_flat_maps_against_definition(self):
        """C8 holds just where every two closed cells share no more than the hull of their common vertices."""
        rng, found = random.Random(4), {True: 0, False: 0, "twice": 0, "crossing": 0}
        for shape in (controls.square(), controls.annulus(3, 1), controls.square() + controls.square().moved(by=(5, 0)), controls.cross_glued()):
            for _ in range(250):
                places = list(shape.points)
                for v in rng.sample(range(len(places)), rng.choice([0, 1, 1, 2, 3])):
                    places[v] = [x + rng.randrange(-3, 4) for x in places[v]]
                if len(shape.cells) == 8 and rng.random() < 0.3 and len(places) == 10:  # one square somewhere else, smaller
                    places[5:] = [[x / 3 + rng.randrange(-4, 3), y / 3 + rng.randrange(-2, 3)] for x, y in shape.points[5:]]
                complexes = {"a": Complex(2, 3, [(*p, 0) for p in places], shape.cells)}
                try:
                    check_meshes.check_position(complexes, [], "a")
                    code = None
                except check_meshes.Stop as stop:
                    code = stop.args[1]
                self.assertEqual(code is None, injective(places, shape.cells), (places, shape.cells))
                found[code is None] += 1
                found[code] = found.get(code, 0) + 1
        self.assertGreater(min(found[True], found[False]), 150)
        self.assertGreater(min(found["twice"], found["crossing"]), 20, found)


def injective(places, cells):
    """Clips each triangle by each other one, exactly: the corners of what is left must be in the hull of the common vertices."""
    turn = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    corners = [[tuple(places[v]) for v in cell] for cell in cells]
    if any(turn(*t) == 0 for t in corners):
        return False
    for i, j in itertools.combinations(range(len(cells)), 2):
        left, common = corners[i], [tuple(places[v]) for v in set(cells[i]) & set(cells[j])]
        sign = 1 if turn(*corners[j]) > 0 else -1
        for k in range(3):
            a, b = corners[j][k], corners[j][(k + 1) % 3]
            kept = []
            for p, q in zip(left, left[1:] + left[:1]):
                x, y = sign * turn(a, b, p), sign * turn(a, b, q)
                kept += [p] if x >= 0 else []
                if x * y < 0:
                    kept.append(tuple(u + Fraction(x, x - y) * (v - u) for u, v in zip(p, q)))
            left = kept
        if len(common) == 2:
            (a, b), dot = common, lambda a, b, x: sum((q - p) * (z - p) for p, q, z in zip(a, b, x))
            inside = lambda x: turn(a, b, x) == 0 and dot(a, b, x) >= 0 and dot(b, a, x) >= 0
        else:
            inside = lambda x: x in common
        if not all(map(inside, left)):
            return False
    return True


def hit_parameters(o, d, corners):
    """(t, u, v) of the one common point of a ray and a triangle, "line" if there are more or the ray is in the plane, or ()."""
    p, q, r = corners
    columns = [[x - y for x, y in zip(q, p)], [x - y for x, y in zip(r, p)], [-x for x in d], [x - y for x, y in zip(o, p)]]
    rows = [[Fraction(c[i]) for c in columns] for i in range(3)]
    pivots = []
    for column in range(3):
        row = next((k for k in range(len(pivots), 3) if rows[k][column]), None)
        if row is None:
            continue
        rows[len(pivots)], rows[row] = rows[row], rows[len(pivots)]
        lead = rows[len(pivots)]
        lead[:] = [x / lead[column] for x in lead]
        for k in range(3):
            if k != len(pivots):
                rows[k] = [x - rows[k][column] * y for x, y in zip(rows[k], lead)]
        pivots.append(column)
    if len(pivots) == 3:
        u, v, t = (row[3] for row in rows)
        return (t, u, v) if min(t, u, v) >= 0 and u + v <= 1 else ()
    if rows[2][3]:
        return ()
    # In the plane: u = a - b t, v = c - e t. The constraints are on t alone.
    (a, b), (c, e) = ((row[3], row[2]) for row in rows[:2])
    bounds = [(a, -b), (c, -e), (1 - a - c, b + e), (Fraction(0), Fraction(1))]  # constant + slope * t >= 0
    ends = [-x / y for x, y in bounds if y]
    return "line" if any(all(x + y * t >= 0 for x, y in bounds) for t in ends) else ()


if __name__ == "__main__":
    unittest.main()
