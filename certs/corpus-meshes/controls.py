"""Shapes, and the controls: for each claim and verdict, and each kind of witness, a valid certificate."""
from make import Mesh, Q, between, cross, dot, embedded, minus, ray

TETRA_FACES = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]


def tetra(s=1):
    return Mesh([(s, s, s), (s, -s, -s), (-s, s, -s), (-s, -s, s)], TETRA_FACES)


def octahedron(s=1):
    points = [(s, 0, 0), (-s, 0, 0), (0, s, 0), (0, -s, 0), (0, 0, s), (0, 0, -s)]
    return Mesh(points, [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])


def volume(mesh):
    return sum(dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) for a, b, c in mesh.cells)


RING = [(1, 0), (0, 1), (-1, 0), (0, -1)]


def torus(tube=((6, 0), (10, -3), (10, 3))):
    """Four corners around the axis, three around the tube."""
    points = [(x * r, y * r, z) for x, y in RING for r, z in tube]
    at = lambda i, j: 3 * (i % 4) + j % 3
    cells = [t for i in range(4) for j in range(3) for t in
             ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))]
    mesh = Mesh(points, cells)
    return mesh if volume(mesh) > 0 else mesh.turned()


def solid_torus():
    """Its inside: four prisms of three tets."""
    points, cells = torus().points, []
    for i in range(4):
        (a, b, c), (d, e, f) = ([3 * (j % 4) + k for k in range(3)] for j in (i, i + 1))
        cells += [(a, b, c, f), (a, b, e, f), (a, d, e, f)]
    turn = lambda t: dot(*(lambda p, q, r, s: (minus(q, p), cross(minus(r, p), minus(s, p))))(*(points[v] for v in t)))
    return Mesh(points, [t if turn(t) > 0 else (t[1], t[0], t[2], t[3]) for t in cells])


def cone(surface):
    """Tets from a last vertex, the origin, to the triangles."""
    return Mesh([*surface.points, (0, 0, 0)], [(*c[::-1], len(surface.points)) for c in surface.cells])


def stellated():
    """A tet with another one on each face."""
    core = tetra()
    apexes = [[-2 * x for x in core.points[opposite]] for opposite in (3, 2, 1, 0)]
    return Mesh(core.points + apexes, [(0, 2, 1, 3), *((*face, 4 + i) for i, face in enumerate(TETRA_FACES))])


SQUARE = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
FAN = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]


def square(middle=(0, 0)):
    return Mesh([(-2, -2), (2, -2), (2, 2), (-2, 2), middle], SQUARE)


def annulus(outer, inner):
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    points = [(x * s, y * s) for s in (outer, inner) for x, y in corners]
    return Mesh(points, [t for i in range(4) for j in ((i + 1) % 4,) for t in ((i, j, 4 + j), (i, 4 + j, 4 + i))])


def cross_glued():
    """Two squares, one inside the other, cut along the slit from (-1, 0) to (1, 0) and glued crosswise."""
    points, cells = [(-1, 0), (1, 0), (0, 0), (0, 0)], []  # left and right end, the slit's two middles
    for s, up, low in ((4, 2, 3), (2, 3, 2)):
        a = len(points)
        points += [(-s, -s), (s, -s), (s, s), (-s, s)]
        b, c, d = a + 1, a + 2, a + 3
        cells += [(0, up, d), (up, 1, c), (up, c, d), (a, low, 0), (a, b, low), (b, 1, low), (a, 0, d), (b, c, 1)]
    return Mesh(points, cells)


def lift(mesh, height):
    return Mesh([(x, y, height(x, y)) for x, y in mesh.points], mesh.cells)


def add_all(corpus):
    manifolds(corpus)
    embeddings(corpus)
    topologies(corpus)
    nestings(corpus)
    homeomorphisms(corpus)


def manifolds(corpus):
    def good(name, mesh, ending="complex"):
        corpus.control(name, "manifold", "certified", [mesh], endings=[ending])

    def bad(kind, mesh, line, ending="complex"):
        corpus.control(f"defect-{kind}", "manifold", "refuted", [mesh], ("witness", [line]), endings=[ending])

    good("manifold-surface", octahedron(), "off")
    good("manifold-plane", square((Q(1, 3), 0)))
    good("manifold-tets", cone(octahedron()))
    points = octahedron().points
    bad("repeated", Mesh(points, [(0, 2, 4), (1, 3, 3)]), "repeated a 1")
    bad("twin", Mesh(points, [(0, 2, 4), (2, 4, 1), (4, 2, 0)]), "twin a 0 2", "off")
    bad("direction", Mesh(points, [(0, 2, 4), (2, 1, 4), (0, 2, 5)]), "direction a 0 2", "obj")
    bad("facet", Mesh(points, [(0, 2, 4), (2, 0, 5), (1, 2, 0)]), "facet a 0,2 0 1 2", "off")
    bad("vertex", Mesh(points, [(0, 2, 4), (0, 3, 5)]), "vertex a 0 0 1", "off")
    bad("flat", Mesh([*points, (Q(1, 2), Q(1, 2), 0)], [(0, 4, 2), (0, 2, 6)]), "flat a 1", "off")
    bad("flat-in-the-plane", Mesh([(0, 0), (1, 1), (3, 3), (0, 1)], [(0, 1, 3), (1, 0, 2)]), "flat a 1")
    bad("facet-of-tets", Mesh([*points, (Q(1, 3), Q(1, 3), 9)], [(0, 2, 4, 1), (0, 2, 4, 3), (0, 2, 4, 6)]), "facet a 0,2,4 0 1 2")
    bad("direction-of-tets", Mesh(points, [(0, 2, 4, 1), (2, 4, 0, 3)]), "direction a 0 1")
    bad("edge", Mesh(points, [(0, 2, 4, 5), (1, 3, 4, 5)]), "edge a 4,5 0 1")
    bad("link", cone(torus()), "link a 12")


def embeddings(corpus):
    ring = torus()
    corpus.control("embedded-torus", "embedded", "certified", [ring], ("a", embedded("a", ring)), endings=["off"])
    sheet = lift(square(), lambda x, y: Q(x * y, 3))
    corpus.control("embedded-sheet", "embedded", "certified", [sheet], ("a", embedded("a", sheet)))
    both = tetra() + octahedron(2)
    # Corner (1, 1, 1) of the tetrahedron is outside the octahedron; (3/4, 3/4, 1/2) is a point of both.
    corpus.control("embedded-crossing", "embedded", "refuted", [both],
                   ("witness", ["cross a 0 4 6 1 1 3 3 2"]), endings=["obj"])
    bow = Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)], [(0, 1, 2), (0, 3, 4)])
    corpus.control("embedded-defect", "embedded", "refuted", [bow], ("witness", ["vertex a 0 0 1"]), endings=["off"])


def topologies(corpus):
    def pair(name, verdict, a, b, endings=("complex", "complex")):
        corpus.control(name, "same-topology", verdict, [a, b], endings=endings)

    far = torus().moved(by=(40, 0, 0))
    pair("topology-components", "certified", octahedron() + far, far.turned() + tetra(), ("off", "obj"))
    pair("topology-plane-and-space", "certified", square(), lift(square((1, 1)), lambda x, y: x * x))
    pair("topology-loops", "refuted", square(), annulus(2, 1))
    pair("topology-genus", "refuted", tetra(), torus(), ("off", "off"))
    pair("topology-two-and-one", "refuted", tetra() + tetra().moved(by=(9, 0, 0)), tetra())
    corpus.control("genus", "nested-topology", "refuted", [tetra(Q(1, 4)).moved(by=(Q(17, 4), Q(17, 4), 0)), torus()],
                   endings=("off", "off"))


def nestings(corpus):
    def good(name, a, b, firsts, endings=("off", "off")):
        rays = ["ray " + ray(x, m, v, n) for x, m, n, some in zip("ab", (a, b), (b, a), firsts) for v in some]
        blocks = ("a", embedded("a", a)), ("b", embedded("b", b)), ("between", between(a, b)), ("rays", rays)
        corpus.control(name, "nested", "certified", [a, b], *blocks, endings=endings)

    def bad(name, a, b, line, endings=("off", "off")):
        corpus.control(name, "nested", "refuted", [a, b], ("witness", [line]), endings=endings)

    good("nested-tetrahedra", tetra(), tetra(2).moved(by=(Q(1, 8), 0, 0)), ([3], [0]))
    good("nested-torus", tetra(Q(1, 4)).moved(by=(Q(17, 4), Q(17, 4), 0)), torus(), ([0], [7]))
    good("nested-rings", torus(((8, 0), (9, -1), (9, 1))), torus(), ([0], [0]), ("complex", "off"))
    small, far = octahedron(Q(1, 3)), (20, Q(1, 7), 0)
    two = small + small.moved(by=far)
    good("nested-twice", two, octahedron(3).moved(by=far) + tetra(2), ([5, 6], [2, 7]), ("complex", "complex"))
    cage = octahedron(3)
    bad("nested-one-of-two", two, cage, "winding " + ray("a", two, 6, cage), ("complex", "off"))
    bad("nested-turned", tetra(), tetra(2).turned(), "winding " + ray("a", tetra(), 0, tetra(2)))
    bad("nested-reverse", tetra(2), tetra(), "winding " + ray("b", tetra(), 0, tetra(2)))
    bad("nested-open", tetra(), Mesh(tetra(2).points, TETRA_FACES[:3]), "open b 1 2")
    # The corner (1, 1, 1) lies on the cage's face x + y + z = 3.
    bad("nested-touching", tetra(), octahedron(3), "cross ab 0 0 1 0 0 1 1 1")
    bad("nested-crossing-itself", tetra(Q(1, 9)), tetra() + octahedron(2), "cross b 0 4 6 1 1 3 3 2", ("complex", "off"))
    bad("nested-defect", tetra(), Mesh(tetra(2).points, [*TETRA_FACES, (0, 1, 2)]), "twin b 0 4")


def homeomorphisms(corpus):
    def good(name, a, b, endings=("complex", "complex")):
        corpus.control(name, "pl-homeomorphism", "certified", [a, b], ("a", embedded("a", a)), ("b", embedded("b", b)), endings=endings)

    def bad(name, a, b, line):
        corpus.control(name, "pl-homeomorphism", "refuted", [a, b], ("witness", [line]))

    good("map-uv", lift(square(), lambda x, y: x * y), square((Q(1, 3), Q(-2, 7))), ("off", "complex"))
    good("map-annulus", annulus(3, 1), Mesh([(y, x) for x, y in annulus(4, 3).points], annulus(4, 3).cells))
    good("map-surfaces", torus(), torus().moved(Q(1, 2)), ("off", "off"))
    tets = stellated()
    good("map-tets", tets, Mesh([(x / 3 + Q(1, 7), y / 5, z) for x, y, z in tets.points], tets.cells))
    ring = solid_torus()
    good("map-tets-ring", ring, Mesh([(x / 3 + Q(1, 7), -y, z) for x, y, z in ring.points], ring.cells))
    inner = cone(tetra(2))
    good("map-tets-inner", inner, Mesh([*tetra(3).points, (Q(1, 3), Q(1, 7), Q(-1, 2))], inner.cells))
    two = square() + square().moved(by=(9, 0))
    good("map-one-part-turned", two, Mesh(two.points[:5] + [(30 - x, y) for x, y in two.points[5:]], two.cells))
    glued = cross_glued()
    # The edge 8 9 of the inner square, facet 3 * 12 + 2; its centroid (0, -2) lies in cell 4 of the outer one.
    bad("map-cross-glued", glued, glued, "twice b 38 4")
    tent = Mesh([(0, 0), (2, 0), (1, 2), (-1, 2), (-2, 1), (-2, -1)], FAN)
    spiral = Mesh([(0, 0), (2, 0), (-1, 2), (-1, -2), (3, 0), (-2, 4)], FAN)
    bad("map-spiral", tent, spiral, "cross b 0 3 0 1 0 1 2 0")
    bad("map-flipped", inner, Mesh([*tetra(3).points, (4, 4, 4)], inner.cells), "sign b 0 3")
    bad("map-flat", square(), square((0, -2)), "sign b 0 0")
    pair = Mesh([*tetra().points, *tetra().moved(by=(9, 0, 0)).points], [(0, 2, 1, 3), (4, 6, 5, 7)])
    bad("map-tets-inside", pair, Mesh([*tetra(9).points, *tetra().points], pair.cells), "twice b 7 0")
    sheet = lift(square(), lambda x, y: x * y)
    folded = Mesh([(-2, -2, 0), (2, -2, 0), (2, 2, 0), (-1, -1, 0), (0, 0, 0)], SQUARE)
    # Vertex 3 lies on the edge 0 4, whose triangle 0 does not have it.
    bad("map-folded", sheet, folded, "cross b 0 2 1 0 1 0 1 0")
    defect = Mesh([(0, 0), (1, 0), (0, 1), (-1, 0), (0, -1)], [(0, 1, 2), (0, 3, 4)])
    bad("map-defect", defect, defect.moved(2, (0, 0)), "vertex a 0 0 1")
