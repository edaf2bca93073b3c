"""Small random shells with certificates for compare_checkers.py: identity overlays, and facts made from check.py's own numbers.

What check.py says about the certificate is not asked here: most facts are true ones, so that many certificates are valid.
"""
import collections
import itertools
import math

import certificate as certificate_file
import check
from test_check import certificate

OCTAHEDRON = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
BALL = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
TEXT = lambda names: ",".join("bmt"[n % 3] + str(n // 3) for n in names)


def surface(rng):
    """(faces, points, directions) of a surface of few triangles, at a good place."""
    kind = rng.randrange(5)
    if kind <= 1:  # a ball or a piece of one
        faces = [f for f in OCTAHEDRON if kind == 0 and rng.random() < 0.9 or rng.random() < 0.7] or OCTAHEDRON
        points, up = [tuple(4.0 * x for x in p) for p in BALL], [tuple(map(float, p)) for p in BALL]
    elif kind == 2:  # a fan, open or closed
        n, closed = rng.randrange(3, 8), rng.random() < 0.6
        rim = [(round(8 * math.cos(2 * math.pi * i / n)), round(8 * math.sin(2 * math.pi * i / n)), 0.0) for i in range(n)]
        points = [(0.0, 0.0, 0.0)] + rim
        faces = [(0, 1 + i, 1 + (i + 1) % n) for i in range(n if closed else n - 1)]
        up = [(0.0, 0.0, 1.0)] * len(points)
    elif kind == 3:  # a strip or a ring
        n, closed = rng.randrange(3, 6), rng.random() < 0.5
        points = [(r * round(4 * math.cos(2 * math.pi * i / n)), r * round(4 * math.sin(2 * math.pi * i / n)), 0.0)
                  for r in (1.0, 2.0) for i in range(n)]
        faces = [f for i in range(n if closed else n - 1) for j in [(i + 1) % n] for f in [(i, n + i, n + j), (i, n + j, j)]]
        up = [(0.0, 0.0, 1.0)] * len(points)
    else:  # two triangles apart, or joined
        points = [(0.0, 0.0, 0.0), (4.0, 0.0, 0.0), (0.0, 4.0, 0.0), (4.0, 4.0, rng.choice([0.0, 1.0])), (9.0, 0.0, 0.0), (9.0, 4.0, 0.0), (13.0, 0.0, 0.0)]
        faces = [(0, 1, 2), rng.choice([(1, 3, 2), (4, 6, 5)])]
        up = [(0.0, 0.0, 1.0)] * len(points)
    new = list(range(len(points)))
    rng.shuffle(new)
    place = {v: i for i, v in enumerate(new)}
    faces = [tuple(place[v] for v in f[k:] + f[:k]) for f in faces for k in [rng.randrange(3)]]
    rng.shuffle(faces)
    return faces, [points[v] for v in new], [up[v] for v in new]


def shaken(rng, points, chance):
    return [tuple(x + rng.choice([-1, 1]) * rng.choice([0.125, 0.25, 0.25, 0.5, 1, 4]) * (rng.random() < chance) for x in p) for p in points]


def geometry(rng):
    """(layers, prisms, mesh points, mesh triangles, vertex order)."""
    faces, points, up = surface(rng)
    some = rng.choice([0.0, 0.0, 0.0, 0.2, 0.4])
    pins = {v for v in range(len(points)) if rng.random() < some}
    height = lambda: rng.choice([0.5, 1.0, 1.0, 2.0])
    layers = [[tuple(x + sign * height() * d * (v not in pins) for x, d in zip(p, up[v])) for v, p in enumerate(points)]
              for sign in (-1, 0, 1)]
    layers[1] = points
    for k in range(3):
        layers[k] = [q if v not in pins else layers[1][v] for v, q in enumerate(shaken(rng, layers[k], rng.choice([0, 0, 0, 0, 0.02, 0.1, 0.3])))]
    for v in pins:
        layers[0][v] = layers[2][v] = layers[1][v]
    if rng.random() < 0.8:  # the middle itself, perhaps moved
        mesh_faces, mesh = list(faces), shaken(rng, layers[1], rng.choice([0, 0, 0, 0.02, 0.1]))
    else:
        mesh_faces, mesh, _ = surface(rng)
        mesh = shaken(rng, mesh, 0.1)
    order = list(range(len(points)))
    if rng.random() < 0.5:
        rng.shuffle(order)
    return layers, faces, mesh, mesh_faces, order


def invent(rng):
    layers, faces, mesh, mesh_faces, order = geometry(rng)
    try:
        case = check.Case([[tuple(map(float, p)) for p in layer] for layer in layers], faces, [tuple(map(float, p)) for p in mesh], mesh_faces)
        claims, blocks = claims_about(rng, case, order, mesh_faces == faces)
    except (KeyError, IndexError, ValueError):
        claims, blocks = ["positivity"], []
    line = "order id" if order == sorted(order) else "order list " + " ".join(map(str, order))
    with_mesh = not {c.lstrip("-") for c in claims} <= {"positivity", "disjoint-prisms"}
    text = certificate((layers, faces), (mesh, mesh_faces) if with_mesh else None, claims, blocks, line)
    return (text.encode(), *[off(p, faces).encode() for p in layers], off(mesh, mesh_faces).encode())


def off(points, faces):
    rows = [" ".join(repr(float(x)) for x in p) for p in points] + [" ".join(map(str, (3, *f))) for f in faces]
    return "\n".join(["OFF", f"{len(points)} {len(faces)} 0", *rows, ""])


def claims_about(rng, case, order, same):
    S = case.decomposition(order)
    kind = rng.randrange(6)
    if kind == 0:
        return positivity(rng, case)
    if kind == 1:
        return prisms(rng, case, S)
    if kind == 2 or not same:
        return no_section(rng, case, S)
    chosen = ["positivity", "section", "bijection"] + ["section-all-orders"] * (rng.random() < 0.8)
    blocks = [("overlay", identity(case))]
    flat = [("disjoint-mesh", 0), ("disjoint-bottom", 0), ("disjoint-top", 0)]
    for name, _ in flat:
        if kind == 3 or rng.random() < 0.5:
            facts = crossing(rng, case, name) if rng.random() < 0.2 else ""
            chosen.append("-" + name if facts else name)
            blocks.append((name, facts or between(rng, case, name)))
    if kind == 3 and chosen[3:] == ["section-all-orders", *[n for n, _ in flat]]:
        facts = contact(rng, case) if rng.random() < 0.5 else ""
        chosen.append("-i2" if facts else "i2")
        blocks.append(("i2", facts or between(rng, case, "i2")))
    if rng.random() < 0.3:
        chosen.append("disjoint-prisms")
        blocks.append(("disjoint-prisms", skin(rng, case, S)))
    return chosen, blocks


def point(tag):
    return TEXT([tag]) if tag >= 0 else f"g{~tag}"


def planes(rng, case, A, B):
    """Planes that separate two simplices, given by their tags, as they are written; `n:` of two points if none is found."""
    normal = check.plane(*case.at(A))[0]
    written = [f"l:{point(a)},{point(b)}" for a, b in itertools.permutations(A, 2)]
    written += ["p:" + ",".join(map(point, three)) for three in itertools.combinations([*A, *(t for t in B if t not in A)], 3)]
    rng.shuffle(written)
    value = dict((text, list(check.listed_planes(case, normal, [(text[0], tuple(map(certificate_file.tag, text[2:].split(","))))]))[0]) for text in written)
    for text in written:
        if check.separates(case, [value[text]], A, B):
            return text
    for one, two in itertools.islice(itertools.permutations(written, 2), 40):
        if check.separates(case, [value[one], value[two]], A, B):
            return f"{one} {two}"
    return f"n:{point(A[0])},{point(B[-1])}"


def separations(rng, case, T, boxes, others, skip, form):
    """A line for each pair that needs one."""
    lines = []
    for f, A in enumerate(T):
        own, wanted = check.box(case.at(A)), []
        for j in range(len(boxes)):
            if skip(f, j) or not check.meet(own, boxes[j]):
                continue
            for B, dot in others(f, j).items():
                alone = [check.plane(*case.at(A)), *(check.plane(*case.at(x)) for x in itertools.combinations(B, 3))]
                if dot <= 0 and check.meet(own, check.box(case.at(B))) and not any(check.separates(case, [h], A, B) for h in alone):
                    wanted.append((j, B))
        lines += [form(f, j, B) + " " + planes(rng, case, A, B) for j, B in sorted(wanted)]
    return "\n".join(lines)


def between(rng, case, name):
    """The lines of `disjoint-mesh`, `-bottom`, `-top`, `i2`."""
    T, i2, k = [tuple(~v for v in f) for f in case.T.faces], name == "i2", 2 * (name == "disjoint-top")
    layer = T if name == "disjoint-mesh" else [tuple(case.N[v][k] for v in f) for f in case.M.faces]
    if i2:
        others = lambda f, j: {t: case.dot(f, x) for t, x in case.tets(j).items()}
        form = lambda f, j, B: f"contact-sep {f} {j} {TEXT(B)}"
        return separations(rng, case, T, case.boxes, others, case.clear, form)
    boxes = [check.box(case.at(B)) for B in layer]
    return separations(rng, case, T, boxes, lambda _, j: {layer[j]: 0}, lambda f, j: layer is T and j <= f, lambda f, j, _: f"sep {f} {j}")


def skin(rng, case, S):
    count = collections.Counter(face for tets in S for names in tets for face in itertools.combinations(names, 3))
    faces = sorted(face for face, times in count.items() if times == 1)
    boxes = [check.box(case.at(B)) for B in faces]
    return separations(rng, case, faces, boxes, lambda _, j: {faces[j]: 0}, lambda i, j: j <= i, lambda i, j, _: f"sep {i} {j}")


def identity(case):
    used = sorted({v for f in case.T.faces for v in f})
    lines = [f"v {v} m{v}" for v in used] + ["c " + " ".join(str(used.index(v)) for v in f) for f in case.T.faces]
    for word, over in (("mesh", case.T), ("middle", case.M)):
        lines += [f"d {word} {i} 0" for i in sorted(set(over.component.values()))]
    return "\n".join(lines)


def value(case, scaled):
    if not scaled:
        return "0"
    zeros = (abs(scaled) & -abs(scaled)).bit_length() - 1
    exponent = zeros - 3 * (case.unit.bit_length() - 1)
    return f"{scaled >> zeros}*2^{exponent}" if exponent else str(scaled >> zeros)


def tet_line(rng, case, tets):
    found = [(j, names, case.volume(tet)) for j, three in enumerate(tets) for names, tet in three.items()]
    bad = [x for x in found if x[2] <= 0]
    j, names, volume = rng.choice(bad if bad and rng.random() < 0.9 else found)
    return f"tet {j} {TEXT(names)} {value(case, volume)}", bool(bad)


def positivity(rng, case):
    fact, bad = tet_line(rng, case, [case.tets(j) for j in range(len(case.M.faces))])
    return (["-positivity"], [("positivity", fact)]) if bad and rng.random() < 0.8 else (["positivity"], [])


def prisms(rng, case, S):
    kind, names = rng.random(), [n for tets in S for n in tets]
    if kind < 0.4:
        return ["disjoint-prisms"], [("disjoint-prisms", skin(rng, case, S))]
    if kind < 0.5:
        return ["-disjoint-prisms"], [("disjoint-prisms", tet_line(rng, case, S)[0])]
    for _ in range(200):
        a, b = rng.choice(names), rng.choice(names)
        i, j = rng.randrange(4), rng.randrange(4)
        if case.X[a[i]] == case.X[b[j]] and (a[i] != b[j] or rng.random() < 0.02):
            break
    w = [["0"] * 4, ["0"] * 4]
    w[0][i] = w[1][j] = "1"
    return ["-disjoint-prisms"], [("disjoint-prisms", " ".join(["overlap", TEXT(a), *w[0], TEXT(b), *w[1]]))]


def weighted(rng, n):
    weights = [rng.choice([0, 0, 1, 1, 1, 2, 3]) for _ in range(n)]
    return weights if any(weights) else [1] * n


def solve(case, A, B):
    """Weights of a point that both simplices have, if there is just one in their hulls and it is inside; else None."""
    found = check.null_vector([p + (1,) for p in case.at([*A, *B])])
    if not found or not sum(found[:len(A)]):
        return None
    found = [x * sum(found[:len(A)]) for x in found]
    first, second = found[:len(A)], [-x for x in found[len(A):]]
    return (first, second) if min(first + second) >= 0 else None


def subsets(rng, tags):
    chosen = [i for i in range(len(tags)) if rng.random() < 0.6]
    return chosen or [rng.randrange(len(tags))]


def common(rng, case, A, B):
    for _ in range(12):
        i, j = subsets(rng, A), subsets(rng, B)
        found = solve(case, [A[k] for k in i], [B[k] for k in j])
        if found:
            weights = [[0] * len(A), [0] * len(B)]
            for at, values, out in zip((i, j), found, weights):
                for k, x in zip(at, values):
                    out[k] = x
            return weights
    return None


def crossing(rng, case, name):
    T = [tuple(~v for v in f) for f in case.T.faces]
    k = 2 * (name == "disjoint-top")
    layer = T if name == "disjoint-mesh" else [tuple(case.N[v][k] for v in f) for f in case.M.faces]
    for _ in range(30):
        i, j = rng.randrange(len(T)), rng.randrange(len(layer))
        if name == "disjoint-mesh" and i >= j:
            continue
        found = common(rng, case, T[i], layer[j])
        if found:
            return " ".join(map(str, ["cross", i, j, *found[0], *found[1]]))
    return ""


def contact(rng, case):
    for _ in range(40):
        f, j = rng.randrange(len(case.T.faces)), rng.randrange(len(case.M.faces))
        tets = case.tets(j)
        names = rng.choice(sorted(tets))
        dot = case.dot(f, tets[names])
        found = common(rng, case, tuple(~v for v in case.T.faces[f]), names)
        if found and (dot <= 0 or rng.random() < 0.05):
            return " ".join(map(str, ["contact", f, j, TEXT(names), *found[0], *found[1], value(case, dot)]))
    return ""


def no_section(rng, case, S):
    head = ["-section", "-bijection"]
    kind = rng.random()
    if kind < 0.15:
        word = rng.choice(["components", "euler"])
        values = [x.count if word == "components" else x.euler for x in (case.T, case.M)]
        return head, [("no-section", " ".join(map(str, ["topology", word, *values])))]
    if kind < 0.25:
        return head, [("no-section", tet_line(rng, case, S)[0])]
    lines = []
    first = sorted(set(case.T.component.values()))
    for component in first if rng.random() < 0.5 else [rng.choice(first)]:
        f = rng.choice([f for f, c in case.T.component.items() if c == component])
        weights = weighted(rng, 3)
        lines.append(" ".join(map(str, ["root", f, *weights])))
        for carrier in sorted(check.all_carriers(case, S, check.mix(case.corners[f], weights))):
            lines += branch(rng, case, S, f, weights, carrier)
    return head, [("no-section", "\n".join(lines))]


def branch(rng, case, S, f, weights, carrier):
    lines = ["branch " + TEXT(carrier)]
    reason = rng.choice(["cap", "wall", "boundary", "fold", "fold", "lands", "twice", "monodromy"])
    for _ in range(1 + (reason in ("twice", "monodromy"))):
        tets = [(j, names) for j, three in enumerate(S) for names in three if set(carrier) <= set(names)]
        j, names = rng.choice(tets)
        lines.append("start " + TEXT(names))
        here, g = carrier, f
        for _ in range(rng.choice([0, 0, 1, 1, 2, 4])):
            step = next_step(rng, case, S, g, j, names)
            if not step:
                break
            g, w, j, names = step
            lines.append(" ".join(map(str, ["step", g, *w, TEXT(names)])))
    return lines + [reason]


def next_step(rng, case, S, f, j, names):
    """A point of a triangle that has corners of `f`, in a face of the tet, and a tet of `S` that has it."""
    near = [g for g, face in enumerate(case.T.faces) if set(face) & set(case.T.faces[f])]
    for _ in range(12):
        g = rng.choice(near)
        used = [i for i, v in enumerate(case.T.faces[g]) if v in case.T.faces[f]]
        corners = subsets(rng, used)
        part = [names[i] for i in subsets(rng, names)]
        found = solve(case, [~case.T.faces[g][used[i] if i < len(used) else used[0]] for i in corners], part)
        if not found or min(found[1]) <= 0:
            continue
        w = [0, 0, 0]
        for i, x in zip(corners, found[0]):
            w[used[i]] = x
        if not any(w):
            continue
        tets = [(k, other) for k, three in enumerate(S) for other in three if set(part) <= set(other)]
        k, other = rng.choice(tets)
        return g, w, k, other
    return None
