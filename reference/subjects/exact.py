"""A subject that is exact: Python's fractions.

    homeo fuzz orient3d --subject "python3 reference/subjects/exact.py"
"""

from fractions import Fraction

from protocol import points, serve, sign


def minus(p, q):
    return [x - y for x, y in zip(p, q)]


def det(rows):
    """Determinant by expansion along the first row."""
    if not rows:
        return 1
    minor = lambda k: det([row[:k] + row[k + 1 :] for row in rows[1:]])
    return sum((-1) ** k * x * minor(k) for k, x in enumerate(rows[0]) if x)


def orient(*p):
    return sign(det([minus(q, p[0]) for q in p[1:]]))


def lifted(*p):
    return sign(det([v + [sum(x * x for x in v)] for v in (minus(q, p[-1]) for q in p[:-1])]))


def dot_sign(a, b, c, d, e):
    return sign(det([minus(b, a), minus(c, a), minus(e, d)]))


def prism_positivity(*p):
    lo, hi = p[:3], p[3:]
    tets = [(*lo, h) for h in hi] + [(l, *hi) for l in lo]
    for u, v, w in [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]:
        tet = (lo[u], lo[v], hi[v], hi[w])
        even = (v - u) % 3 == 1
        tets.append((tet[0], tet[1], tet[3], tet[2]) if even else tet)
    return min(orient(*tet) for tet in tets)


def section_dot(*p):
    return min(dot_sign(*p[:3], p[3 + i], p[6 + i]) for i in range(3))


def exactly(function, dimension=3):
    def answer(case):
        return function(*points([Fraction(x) for x in case], dimension))

    return answer


serve({
    "orient2d": exactly(orient, 2),
    "orient3d": exactly(orient),
    "incircle": exactly(lifted, 2),
    "insphere": exactly(lambda *p: -lifted(*p)),
    "dot_sign": exactly(dot_sign),
    "prism_positivity": exactly(prism_positivity),
    "section_dot": exactly(section_dot),
})
