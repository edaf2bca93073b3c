"""Mutants of the rules: FORMAT.md 3.1 to 3.6. Counts and hashes are right again after each edit, so only the rule fails."""
import functools
import re

from make_mutants import after, blocks, drop, lines, off, swap, whole

SQUARE = "0 1 2/0 2 3"
# Claims of certificates given whole.
SECTION = "positivity section bijection"
ALL_ORDERS = SECTION + " section-all-orders"
EVERYTHING = ALL_ORDERS + " disjoint-mesh disjoint-bottom disjoint-top i2"


def add_all(corpus):
    m = functools.partial(corpus.add, facts=True)

    for part in (positivity, carriers, cells, hand_made_overlays, double_cover, degrees, topology, roots, steps, stars,
                 reasons, separation, separation_from_layers, crossings, contacts, separation_from_tets, separation_from_boxes,
                 refuted_for_another_reason, harmless):
        part(m)


def claim(name, verdict):
    """States one verdict, whatever it was."""
    def edit(text):
        old = re.search(f"^claim {name} (certified|refuted)$", text, re.M)[0]
        return lines(old, f"claim {name} {verdict}")(text)
    return edit


def positivity(m):
    def refuted(control, name, answer, what, old, new):
        m(control, name, answer, what, lines(old, new))

    flat = {"top": swap("4.0 0.0 1.0", "4.0 0.0 0.0")}
    m("inside", "volume-zero", "invalid not-positive", "a pillar of length 0: volumes of exactly 0", files=flat)
    m("inside", "volume-negative", "invalid not-positive", "a pillar that points down",
      files={"top": swap("4.0 0.0 1.0", "4.0 0.0 -0.5")})
    m("inside", "inside-out", "invalid not-positive", "bottom and top exchanged, hash right",
      files={"bottom": lambda t: t.replace("-1.0", "1.0"), "top": lambda t: re.sub(" 1.0$", " -1.0", t, flags=re.M)})
    for control in ("bad-tet", "flat-tet"):
        m(control, "positivity-claimed", "invalid not-positive", "positivity claimed in spite of its tets",
          claim("positivity", "certified"), blocks(positivity=None))
    m("bad-tet-unused", "positivity-claimed", "invalid not-positive", "positivity claimed in spite of a tet that the order does not use",
      claim("positivity", "certified"), blocks(positivity=None), drop("claim section-all-orders refuted"), drop("claim i2 refuted"))
    m("bad-tet-unused", "no-order-due", "malformed syntax", "positivity claimed, so the no-order block is due",
      claim("positivity", "certified"), blocks(positivity=None))
    tet = "tet 0 t0,m1,t1,m2 -1*2^3"
    refuted("bad-tet", "determinant-other", "invalid wrong-value", "another determinant", tet, "tet 0 t0,m1,t1,m2 -1*2^4")
    refuted("bad-tet", "determinant-sign", "invalid wrong-value", "the determinant's sign turned", tet, "tet 0 t0,m1,t1,m2 1*2^3")
    refuted("bad-tet", "determinant-zero", "invalid wrong-value", "the determinant called zero", tet, "tet 0 t0,m1,t1,m2 0")
    refuted("bad-tet", "tet-of-other-slabs", "invalid unknown-tet", "four names that are no tet", tet, "tet 0 b0,m1,t1,m2 -1*2^3")
    refuted("bad-tet", "tet-of-other-prism", "invalid unknown-tet", "a tet of the other prism", tet, "tet 1 t0,m1,t1,m2 -1*2^3")
    refuted("bad-tet", "tet-positive", "invalid not-refuted", "a positive tet, with its determinant", tet, "tet 0 b0,b1,b2,m2 1*2^4")
    refuted("flat-tet", "zero-called-negative", "invalid wrong-value", "a volume of exactly 0 called negative",
            "tet 0 m0,m1,t1,m2 0", "tet 0 m0,m1,t1,m2 -1")
    refuted("bad-tet-unused", "last-tet-positive", "invalid not-refuted", "a second tet, which is positive",
            "tet 0 t0,m1,t1,m2 0", "tet 0 t0,m1,t1,m2 0\ntet 1 b0,b2,b3,m3 1*2^4")
    m("bad-tet", "fewer-tets", "valid", "one bad tet is enough", drop("tet 0 t0,m1,t1,t2 -1*2^3"))
    m("bad-tet", "positivity-of-pinched", "invalid unknown-tet", "a tet that vanishes, as its vertex is pinched",
      whole("-positivity disjoint-mesh", "begin positivity\ntet 0 m0,t0,m1,m2 0\nbegin disjoint-mesh\nsep 0 1 l:g0,g2"),
      lines("pinched 0", "pinched 16 0"),
      files={"bottom": swap("0.0 0.0 -1.0", "0.0 0.0 0.0"), "top": swap("0.0 0.0 1.0", "0.0 0.0 0.0")})


def carriers(m):
    def v(name, answer, what, new, old="v 1,2 m1,t2", control="two-components"):
        m(control, name, answer, what, lines(old, new))

    v("carrier-no-edge", "invalid mesh-carrier", "two mesh vertices without an edge", "v 1,3 m1,t2")
    v("carrier-no-triangle", "invalid mesh-carrier", "three mesh vertices without a triangle", "v 1,2,3 m1,t2")
    v("carrier-two-prisms", "invalid shell-carrier", "names of no common prism", "v 1,2 m1,t3")
    v("carrier-other-order", "invalid shell-carrier", "an edge that another order has", "v 1,2 t1,m2")
    v("carrier-two-slabs", "invalid shell-carrier", "names of both slabs", "v 1,2 b1,t2")
    v("carrier-in-cap", "invalid cap", "a vertex in the top", "v 1,2 t1,t2")
    v("carrier-in-bottom", "invalid cap", "a vertex in the bottom", "v 2 b2", "v 2 m2,t2")
    v("carrier-of-pinched", "invalid shell-carrier", "a name that a pinched vertex has not", "v 0 t0", "v 0 m0", "pinched")
    v("carrier-in-pinched-cap", "invalid cap", "a top vertex and the pinched one", "v 1,2 m0,t2", control="pinched")
    v("crossing-on-wrong-edge", "invalid no-point", "the crossing of another mesh edge", "v 0,2 m1,t2")
    v("crossing-none", "invalid no-point", "lines that do not meet", "v 0,1 m1,t2")
    v("crossing-not-one", "invalid no-point", "an edge that is the shell's edge", "v 0,1 m0,m1", "v 1 m1", "tetrahedron")
    v("vertex-elsewhere", "invalid no-point", "a mesh vertex that is elsewhere", "v 2 m1,t1", "v 2 m2,t2")
    v("crossing-outside", "invalid outside-carrier", "the lines meet beyond the pillar", "v 0 b0,m0", "v 0 m0,t0")
    v("crossing-at-end", "invalid outside-carrier", "a carrier that is too large: a weight of exactly 0", "v 2,3 m2,t2", "v 2 m2,t2")
    v("wrong-carrier-name", "invalid outside-carrier", "a carrier with a name too many", "v 1 m1,t1,t2", "v 1 m1,t1")


def cells(m):
    t = "two-components"
    m(t, "cell-dropped-first", "invalid boundary", "the first cell is missing", drop("c 0 1 2"))
    m(t, "cell-dropped-corner", "invalid boundary", "the cell at a corner is missing", drop("c 12 16 13"))
    m("tetrahedron", "cell-dropped", "invalid boundary", "a cell of a closed surface is missing", drop("c 1 3 2"))
    m("patch-section", "cell-dropped", "invalid boundary", "an inner cell is missing", drop("c 22 16 9 18"))
    m(t, "cell-doubled", "invalid edge-twice", "a cell twice", after("c 3 7 4", "c 3 7 4"))
    m("tetrahedron", "cell-doubled-turned", "invalid edge-twice", "a cell twice, from another corner", after("c 1 3 2", "c 3 2 1"))
    m(t, "cells-overlap", "invalid edge-twice", "a cell that overlaps another", after("c 5 6 0 2", "c 6 0 2"))
    m(t, "cells-overlap-half", "invalid edge-twice", "both halves of a quadrilateral on the same side",
      lines("c 5 6 0 2", "c 5 6 2\nc 5 0 2"))
    m(t, "cell-turned-over", "invalid area-mesh", "a cell in the other orientation", lines("c 0 1 2", "c 0 2 1"))
    m(t, "cell-not-convex", "invalid area-mesh", "a quadrilateral's corners out of turn", lines("c 5 6 0 2", "c 5 6 2 0"))
    m(t, "cell-of-two-triangles", "invalid cell-mesh", "a cell across a mesh edge", lines("c 0 1 2", "c 0 1 3"))
    m(t, "cell-of-an-edge", "invalid cell-mesh", "a cell on one mesh edge", lines("c 5 6 0 2", "c 0 6 1"))
    m(t, "cell-of-two-tets", "invalid cell-shell", "a cell across two tets", lines("c 5 6 0 2", "c 5 6 0 1 2"))
    m(t, "component-dropped", "invalid isolated", "the cells of a component are missing, its vertices are not",
      drop("\n".join(["c 9 10 11", "c 11 10 12 13", "c 14 15 9 11", "c 12 16 13", "c 17 11 13", "c 17 14 11"])),
      lines("d mesh 6 0", "d mesh 0 0"), lines("d middle 6 0", "d middle 0 0"))
    m(t, "cell-other-diagonal", "valid", "a quadrilateral as two triangles, by its other diagonal",
      lines("c 5 6 0 2", "c 5 6 2\nc 6 0 2"), lines("d mesh 6 0", "d mesh 7 0"), lines("d middle 6 0", "d middle 7 0"))
    m(t, "cell-turned", "valid", "a cell from another corner", lines("c 5 6 0 2", "c 0 2 5 6"))
    m(t, "cells-reordered", "valid", "two cells swapped", lines("c 3 7 4\nc 8 2 4", "c 8 2 4\nc 3 7 4"))


def hand_made_overlays(m):
    """Overlays of a mesh of four vertices, given whole."""
    def overlay(*v):
        points = "\n".join("v " + x for x in v)
        return lambda tail: f"begin overlay\n{points}\n{tail}\nd mesh 0 0\nd middle 0 0"

    plain = overlay("0 m0", "1 m1", "2 m2", "3 m3")
    ground = off("0 0 0/4 0 0/4 4 0/0 4 0", SQUARE)
    m("boundary", "overlay-by-hand", "valid", "the middle itself as the mesh: the control of the overlays given whole",
      whole(SECTION, plain("c 0 1 2\nc 0 2 3")), files={"mesh": ground})
    m("boundary", "mesh-upside-down", "invalid area-middle", "a mesh in the other orientation",
      whole(SECTION, plain("c 0 2 1\nc 0 3 2")), files={"mesh": off("0 0 0/4 0 0/4 4 0/0 4 0", "0 2 1/0 3 2")})
    upright = overlay("0 m0", "1 m0,m1,t1,t2", "2 m1,t1,t2", "3 m3")
    m("boundary", "dot-zero", "invalid area-middle", "an upright mesh triangle: its dot and its area in the middle are exactly 0",
      whole(SECTION, upright("c 0 1 2\nc 0 2 3")), files={"mesh": off("0 0 0/2 1 .4375/4 2 .75/0 4 0", SQUARE)})
    small = overlay(*(f"{i} m0,m1,m2,t2" for i in range(4)))
    m("boundary", "mesh-too-small", "invalid boundary", "a mesh that ends inside a prism",
      whole(SECTION, small("c 0 1 2\nc 0 2 3")),
      files={"mesh": off("2.5 1 .0625/3 1 .0625/3 1.5 .0625/2.5 1.5 .0625", SQUARE)})
    m("boundary", "mesh-edge-on-inner-wall", "invalid boundary", "a boundary edge of the mesh on an inner edge of the middle",
      whole(SECTION, "begin overlay\nv 0 m0\nv 1 m1\nv 2 m2\nc 0 1 2\nd mesh 0 0\nd middle 0 0"),
      files={"mesh": off("0 0 0/4 0 0/4 4 0", "0 1 2")})
    m("flat-tet", "section-not-positive", "invalid not-positive", "section claimed over a tet of volume exactly 0",
      whole("-positivity section bijection", "begin positivity\ntet 0 m0,m1,t1,t2 0\n" + plain("c 0 1 2\nc 0 2 3")))
    closed = overlay("0 m0", "1 m1", "2 m2", "3 m3")
    m("pinched-edge", "section-claimed", "invalid cap", "a section claimed whose mesh runs along an edge between two pinched vertices",
      whole(SECTION, closed("c 0 1 2\nc 0 3 1\nc 0 2 3\nc 1 3 2")))
    cut = overlay("0 m0", "1 m1", "2 m2,t2", "3 m3,t3", "2,3 m2,t3")("c 0 1 2\nc 0 2 4\nc 0 4 3")
    raised = off("0 0 0/4 0 0/4 4 .5/0 4 .5", SQUARE)
    bent = {"mesh": raised, "top": swap("4.0 0.0 1.0", "3.5 0.5 1.0")}
    m("boundary", "wall-straight", "valid", "a mesh edge on a straight wall", whole(ALL_ORDERS, cut), files={"mesh": raised})
    m("boundary", "wall-bent", "invalid all-orders-boundary", "a mesh edge on a bent wall", whole(ALL_ORDERS, cut), files=bent)
    m("boundary", "wall-bent-one-order", "valid", "the same without section-all-orders", whole(SECTION, cut), files=bent)
    m("boundary-wall", "all-orders-claimed", "invalid all-orders", "section-all-orders claimed though a flipped boundary wall leaves the mesh out",
      claim("section-all-orders", "certified"), blocks(no_order=None), drop("claim i2 refuted"))
    m("closed-tet", "all-orders-claimed", "invalid all-orders", "section-all-orders claimed though one order has none",
      claim("section-all-orders", "certified"), blocks(no_order=None), drop("claim i2 refuted"))


def double_cover(m):
    """`twice` with a section claimed: the overlay of one turn of the ring, pulled back to the mesh that goes round twice."""
    def pulled_back(text):
        facts = re.search("^begin overlay\n((?:v .*\n)*)((?:c .*\n)*)", RING, re.M)
        vertices = [line.split()[1:] for line in facts[1].splitlines()]
        number, rows, out = {}, [], []

        def lift(ids, turn, wraps):
            """Corners 0 and 1 of a triangle across the seam belong to the next turn."""
            return sorted((i + 16 * turn + (16 if wraps and i < 2 else 0)) % 32 for i in ids)

        for turn in (0, 1):
            for line in facts[2].splitlines():
                corners = [vertices[int(c)] for c in line.split()[1:]]
                used = {int(i) for tids, _ in corners for i in tids.split(",")}
                wraps = bool(used & {0, 1}) and bool(used & {14, 15})
                cell = []
                for tids, names in corners:
                    ids = lift(map(int, tids.split(",")), turn, wraps)
                    key = f"v {','.join(map(str, ids))} {names}"
                    if key not in number:
                        number[key] = len(number)
                        rows.append(key)
                    cell.append(str(number[key]))
                out.append("c " + " ".join(cell))
        body = "\n".join(["begin overlay", *rows, *out, "d mesh 0 0", "d middle 0 0"])
        return whole(SECTION, body)(text)

    from make_mutants import HERE
    RING = (HERE / "ring/control.cert").read_text("ascii")
    m("twice", "double-cover", "invalid degree", "a section claimed for a mesh that covers the middle twice", pulled_back)


def degrees(m):
    t = "two-components"
    c = "invalid degree-component"
    m(t, "degree-mesh-missing", c, "no cell named for a component of the mesh", drop("d mesh 6 0"))
    m(t, "degree-middle-missing", c, "no cell named for a component of the middle", drop("d middle 6 0"))
    m(t, "degree-mesh-other", c, "a cell of another component", lines("d mesh 6 0", "d mesh 5 0"))
    m(t, "degree-middle-other", c, "a cell of another component", lines("d middle 6 0", "d middle 0 0"))
    m(t, "degree-swapped", c, "components out of order", lines("d mesh 0 0\nd mesh 6 0", "d mesh 6 0\nd mesh 0 0"))
    m(t, "degree-more", c, "a component too many", after("d middle 6 0", "d middle 6 0"))
    m(t, "degree-other-cell", "valid", "another cell of the component", lines("d mesh 6 0", "d mesh 7 1"))


def topology(m):
    w, n = "invalid wrong-value", "invalid not-refuted"
    facts = "begin no-section\ntopology "
    m("components", "components-other", w, "another number of components", lines("topology components 2 1", "topology components 3 1"))
    m("components", "components-swapped", w, "the numbers swapped", lines("topology components 2 1", "topology components 1 2"))
    m("euler", "euler-other", w, "another Euler number", lines("topology euler 0 1", "topology euler -1 1"))
    m("euler", "euler-of-middle", w, "another Euler number of the middle", lines("topology euler 0 1", "topology euler 0 2"))
    m("euler", "euler-giant", w, "an Euler number of ten digits", lines("topology euler 0 1", "topology euler 0 -9999999999"))
    m("euler", "components-equal", n, "numbers of components, which are equal", lines("topology euler 0 1", "topology components 1 1"))
    m("boundary", "euler-equal", n, "Euler numbers, which are equal", blocks(no_section="topology euler 1 1"))
    m("components", "euler-too", "valid", "Euler numbers in place of the components", lines(facts + "components 2 1", facts + "euler 2 1"))
    tet = "begin no-section\ntet 0 m0,m1,t1,t2 0"
    m("flat-tet", "tet-not-selected", "invalid unknown-tet", "a flat tet that the order does not select",
      lines(tet, tet.replace("m0,m1,t1,t2", "t0,m1,t1,t2")))
    m("flat-tet", "tet-value", w, "another determinant", lines(tet, tet.replace("t2 0", "t2 -1")))
    m("flat-tet", "tet-positive", n, "a positive tet", lines(tet, tet.replace("m0,m1,t1,t2 0", "b0,b1,b2,m2 1*2^4")))


def roots(m):
    b = "invalid wrong-branches"
    root, branch = "root 0 0 1 1", "branch m0,m1,m2,t2\nstart m0,m1,m2,t2\nboundary"
    extra = "branch m0,m1,t1,t2\nstart m0,m1,t1,t2\nboundary"
    m("boundary", "branch-dropped", b, "the branch left out", drop(branch))
    m("boundary", "branch-added", b, "a branch too many", lines(branch, f"{extra}\n{branch}"))
    m("boundary", "branch-renamed", b, "a branch of another name", lines(branch, extra))
    m("boundary", "branch-face", b, "a carrier without its last name", lines(branch, branch.replace("branch m0,m1,m2,t2", "branch m0,m1,m2")))
    m("boundary", "root-moved", b, "the root in another tet", lines(root, "root 0 1 0 0"))
    m("boundary", "root-moved-inside", "invalid not-refuted", "the root away from the boundary", lines(root, "root 0 1 1 1"))
    m("boundary", "root-on-other-triangle", b, "the root on the other triangle", lines(root, "root 1 0 1 1"))
    m("boundary", "root-scaled", "valid", "the root's weights scaled", lines(root, "root 0 0 7 7"))
    m("touches-cap", "root-moved", b, "the root beside the point that touches", lines("root 0 0 1 0", "root 0 1 1000 0"))
    m("outside", "root-with-branch", b, "a branch of a point that no tet holds",
      after("root 0 1 1 1", "branch m0,m1\nstart m0,m1,m2,t2\nlands"))
    m("fold", "fold-branch-dropped", b, "a false omission: no branch", drop("branch m0,t0,t1,t2\nstart m0,t0,t1,t2\nfold"))
    second = "root 2 1 1 1\nbranch m0,m1,t1,t2\nstart m0,m1,t1,t2\nlands"
    m("lands", "roots-of-one-component", b, "two roots in one component",
      lines(second, "root 1 1 1 1\nbranch m0,m2,m3,t3\nstart m0,m2,m3,t3\nlands"))
    m("lands", "root-dropped", "invalid not-refuted", "one root only, which may land", drop(second))
    m("lands", "roots-turned", "valid", "the roots in another order",
      lambda t: after(second, "root 0 1 1 1\nbranch m0,m1,m2,t2\nstart m0,m1,m2,t2\nlands")(
          drop("root 0 1 1 1\nbranch m0,m1,m2,t2\nstart m0,m1,m2,t2\nlands")(t)))
    m("monodromy", "branch-dropped", b, "one of two branches left out",
      lambda t: t[:t.index("branch m16,m17,m19,t19")] + t[t.index("begin disjoint-mesh"):])
    m("closed-tet", "other-order", b, "the order for which there is a section", lines("first 1 2 0", "first 0"))
    m("closed-tet", "order-first-more", "valid", "the same order, stated in full", lines("first 1 2 0", "first 1 2 0 3"))


def steps(m):
    w, u = "invalid wrong-step", "invalid unknown-tet"
    m("boundary", "start-without-branch", w, "a start tet that lacks a name of the branch",
      lines("start m0,m1,m2,t2", "start m0,m1,t1,t2"))
    m("boundary", "start-not-selected", u, "a start tet that the order does not select", lines("start m0,m1,m2,t2", "start m0,m1,t1,m2"))
    m("closed-tet", "start-not-selected", u, "a start tet of another order", lines("start m0,t0,m1,m2", "start m0,t0,m1,t2"))
    t = "twice"
    m(t, "path-jumps", w, "a step is missing in the middle", drop("step 4 3 3 2 m4,m5,m7,t7"))
    m(t, "path-jumps-on-mesh", w, "a step to a far triangle", lines("step 4 3 3 2 m4,m5,m7,t7", "step 9 3 3 2 m4,m5,m7,t7"))
    m(t, "path-leaves-tet", w, "a point outside the tets", lines("step 4 3 3 2 m4,m5,m7,t7", "step 4 3 3 90 m4,m5,m7,t7"))
    m(t, "path-other-tet", w, "a step into a tet that the point is not in", lines("step 4 3 3 2 m4,m5,m7,t7", "step 4 3 3 2 m2,m3,m5,t5"))
    m(t, "path-unknown-tet", u, "a step into no tet", lines("step 5 3 5 0 m4,m6,m7,t7", "step 5 3 5 0 m4,m6,b7,m7"))
    m(t, "path-of-other-sheet", w, "the far mesh sheet too early", lines("step 4 3 3 2 m4,m5,m7,t7", "step 20 3 3 2 m4,m5,m7,t7"))
    m("touches-cap", "step-from-one-name", w, "a step from a point whose carrier is one name",
      after("start m0,m1,t1,t2", "step 0 0 1 0 m0,m1,t1,t2"))


def stars(m):
    """Steps from a point on an edge: no two tets around it may overlap, and none may be turned over."""
    w, n = "invalid wrong-step", "invalid not-refuted"
    root = "root 0 1 1 0\n"
    above = "branch m0,t0,t1\nstart m0,t0,t1,t2\nlands\n"
    edge = "branch m0,m1\nstart m0,m1,m2,t2\n"
    into = "step 0 1 1 1 m0,m1,m2,t2\n"
    ground = {"mesh": off("0 0 0/4 0 0/4 4 0/0 4 0", SQUARE)}
    m("boundary", "step-from-edge", n, "a good step from an edge; nothing is refuted by landing",
      blocks(no_section=root + edge + into + "lands"), files=ground)
    m("bad-tet", "no-step-from-edge", n, "no step; nothing is refuted by landing", blocks(no_section=root + above + edge + "lands"))
    m("bad-tet", "step-from-edge", w, "a step from an edge of a tet that is turned over", blocks(no_section=root + above + edge + into + "lands"))
    m("flat-tet", "step-from-edge", w, "a step from an edge of a tet of volume exactly 0",
      blocks(no_section=root + edge + into + "lands\nbranch m0,t1\nstart m0,t0,t1,t2\nlands"))
    m("bad-tet", "start-turned-over", w, "a start tet that is turned over",
      blocks(no_section=root + above + edge.replace("start m0,m1,m2,t2", "start m0,m1,t1,t2") + "lands"))
    m("bad-tet", "step-turned-over", w, "a step into a tet that is turned over",
      blocks(no_section="root 0 1 1 1\nbranch m0,m1,m2\nstart m0,m1,m2,t2\nstep 0 1 1 0 m0,m1,t1,t2\nlands"))
    # Tets around a pillar: three blunt wedges side by side, and five right ones, of which the last lies on the first.
    leave = "root 0 1 0 0\nbranch m0,t0\nstart m0,t0,t1,t2\nstep 0 1 1 1 m0,t0,t1,t2\nlands"
    for name, answer, what, rim in [
            ("step-from-pillar", n, "a good step from a pillar; nothing is refuted by landing", "4 0/-2 4/-2 -4/4 0"),
            ("step-from-wound-pillar", w, "a step from a pillar that the prisms wind around more than once", "4 0/0 4/-4 0/0 -4/4 0/0 4")]:
        m("boundary", name, answer, what, whole("-section -bijection", f"begin no-section\n{leave}"), files=cone(rim.split("/")))


def cone(rim):
    """Straight prisms around the origin, and one mesh triangle half way up; the rim closes if it ends where it began."""
    closed = rim[0] == rim[-1]
    rim = rim[:-1] if closed else rim
    count = len(rim)
    faces = "/".join(f"0 {i} {i % count + 1}" for i in range(1, count + closed))
    layers = {part: off("/".join(f"{p} {z}" for p in ["0 0", *rim]), faces) for part, z in (("bottom", -1), ("middle", 0), ("top", 1))}
    return {**layers, "mesh": off("0 0 .5/1 .25 .5/.5 .75 .5", "0 1 2")}


def reasons(m):
    def turned(control, old, news):
        for new in news:
            m(control, f"{old}-is-{new}", "invalid not-refuted", f"the reason {old} turned into {new}", lines(old, new))

    turned("boundary", "boundary", ["wall", "cap", "fold", "lands"])
    turned("cap", "cap", ["fold", "wall", "boundary", "lands"])
    turned("touches-cap", "cap", ["fold", "wall", "lands"])
    turned("wall", "wall", ["boundary", "cap", "fold", "lands"])
    turned("fold", "fold", ["cap", "wall", "boundary", "lands"])
    turned("closed-tet", "fold", ["cap", "wall", "boundary", "lands"])
    turned("twice", "twice", ["monodromy"])
    m("monodromy", "monodromy-is-twice", "invalid not-refuted", "the first reason turned into twice",
      lambda t: t.replace("\nmonodromy\n", "\ntwice\n", 1))
    alone = [
        ("boundary-at-corner", "valid", "a corner of the mesh inside the shell", "1 0 0", "m0,t1,t2", "boundary", "1 .5 .25/3 1 .25/3 3 .25"),
        ("wall-at-corner", "invalid not-refuted", "a corner of the mesh on a wall", "1 0 0", "m0,m1,t1", "wall", "2 0 .25/3 1 .25/2.5 1.5 .25"),
        ("wall-at-pillar", "valid", "a triangle pierced by a pillar of the boundary", "1 1 1", "m1,t1", "wall", "3 -1 .5/6 0 .5/3 1 .5")]
    for name, answer, what, weights, names, reason, mesh in alone:
        m("boundary", name, answer, what,
          whole("-section -bijection", f"begin no-section\nroot 0 {weights}\nbranch {names}\nstart m0,m1,t1,t2\n{reason}"), files={"mesh": off(mesh, "0 1 2")})
    m("boundary", "fold-on-face", "invalid not-refuted", "a steep dot at a face between two tets that the triangle crosses",
      whole("-section -bijection", "begin no-section\nroot 0 1 1 1\nbranch m0,m1,t2\nstart m0,m1,m2,t2\nfold"),
      files={"mesh": off("2 .5 .25/2.5 1.5 .25/3 1 .25", "0 1 2")})
    m("lands", "lands-is-wall", "invalid not-refuted", "the last reason turned into wall",
      swap("start m0,m1,t1,t2\nlands", "start m0,m1,t1,t2\nwall"))
    m("twice", "twice-cut", "invalid not-refuted", "the last step left out", drop("step 16 1 1 2 m0,m1,m3,t3"))
    m("twice", "twice-same-leg", "invalid not-refuted", "both legs end in one point",
      lambda t: re.sub("(start .*\n(step .*\n)*)(start .*\n(step .*\n)*)twice", r"\1\1twice", t))
    m("monodromy", "monodromy-cut", "invalid not-refuted", "a leg that ends before it closes",
      lines("step 0 1 1 2 m16,m17,m19,t19\nmonodromy", "monodromy"))
    m("monodromy", "monodromy-scaled", "valid", "the weights of a leg's end doubled",
      lines("step 0 1 1 2 m16,m17,m19,t19\nmonodromy", "step 0 2 2 4 m16,m17,m19,t19\nmonodromy"))


def separation(m):
    t, sep = "two-components", "sep 0 1 l:g0,g2"
    miss, extra, no = "invalid missing-separation", "invalid superfluous", "invalid not-separated"
    m(t, "sep-dropped", miss, "a sep line is missing", drop(sep))
    m(t, "sep-of-far-pair", extra, "a sep line of triangles whose boxes do not meet", after(sep, "sep 0 2 l:g0,g2"))
    m("tetrahedron", "sep-not-needed", extra, "a sep line of a pair that its own plane separates", blocks(disjoint_mesh="sep 0 1 l:g0,g1"))
    m("inside", "sep-bottom-far", extra, "a sep line of a pair with the bottom whose boxes do not meet",
      blocks(disjoint_bottom="sep 0 0 l:g0,g1"))
    m("inside", "sep-top-far", extra, "a sep line of a pair with the top whose boxes do not meet", blocks(disjoint_top="sep 0 0 l:g0,g1"))
    for name, plane, what in [
            ("plane-on-edge", "l:g0,g1", "an upright plane on another edge"), ("plane-across", "n:g0,g2", "a plane across the edge"),
            ("plane-of-both", "p:g0,g1,g2", "the plane that holds both triangles"),
            ("plane-of-a-point", "l:g0,g0", "a plane that is none: all values 0"),
            ("plane-line", "p:g0,g2,g0", "three points on a line: all values 0")]:
        m(t, name, no, what, lines(sep, f"sep 0 1 {plane}"))
    m("closed-tet", "second-plane-missing", no, "the second plane is missing",
      lines("sep 0 3 p:g4,g5,g2 p:g4,g5,g6", "sep 0 3 p:g4,g5,g2"))
    m("twice", "disjoint-claimed", miss, "two turns in one place claimed disjoint",
      claim("disjoint-mesh", "certified"), blocks(disjoint_mesh=""))
    m("bad-tet", "disjoint-top-claimed", miss, "a top that cuts the mesh claimed disjoint", claim("disjoint-top", "certified"), blocks(disjoint_top=""))
    m("touches-cap", "disjoint-top-claimed", miss, "a mesh that touches the top claimed disjoint",
      claim("disjoint-top", "certified"), blocks(disjoint_top=""))
    m(t, "plane-other-points", "valid", "the same plane through shell points", lines(sep, "sep 0 1 p:m0,m2,t0"))
    m(t, "plane-twice", "valid", "the plane twice", lines(sep, f"{sep} l:g0,g2"))
    m("cap", "plane-of-pinched", no, "a plane through a name that a pinched vertex has not",
      whole("disjoint-mesh", "begin disjoint-mesh\nsep 0 1 p:m0,m2,t0"), lines("pinched 0", "pinched 16 0"),
      files={"bottom": swap("0.0 0.0 -1.0", "0.0 0.0 0.0"), "top": swap("0.0 0.0 1.0", "0.0 0.0 0.0"),
             "mesh": off("0 0 .25/4 0 .25/4 4 .25/0 4 .25", SQUARE)})


def separation_from_layers(m):
    """One prism, and a mesh triangle beside its top (bottom) that neither plane alone separates from it."""
    prism = {part: off(f"0 0 {z}/4 0 {z}/0 4 {z}", "0 1 2") for part, z in (("bottom", -1), ("middle", 0), ("top", 1))}
    for layer, z in (("top", 1), ("bottom", -1)):
        files = {**prism, "mesh": off(f"3 3 {z * .5}/3.25 3.25 {z * 1.5}/3.5 3.5 {z * .5}", "0 1 2")}
        x = layer[0]
        for name, answer, what, facts in [
                ("sep", "valid", "an upright plane between a triangle and the", f"sep 0 0 p:{x}1,{x}2,m1"),
                ("no-sep", "invalid missing-separation", "no plane between a triangle and the", ""),
                ("plane-of-edge", "invalid not-separated", "a plane on another edge of the", f"sep 0 0 p:{x}0,{x}1,m0"),
                ("plane-of-far", "invalid not-separated", "a plane beyond both, the triangle and the", f"sep 0 0 n:{x}0,g0"),
                ("cross-beside", "invalid wrong-point", "a crossing claimed beside the", "cross 0 0 1 1 1 0 1 1")]:
            sign = "-" if facts.startswith("cross") else ""
            m("boundary", f"{name}-{layer}", answer, f"{what} {layer}",
              whole(f"{sign}disjoint-{layer}", f"begin disjoint-{layer}\n{facts}".strip()), files=files)


def crossings(m):
    cross = "cross 0 0 2 3 2 2 3 2"
    m("cap", "cross-weights", "invalid wrong-point", "other weights", lines(cross, "cross 0 0 2 3 1 2 3 2"))
    m("cap", "cross-pair", "invalid wrong-point", "another prism", lines(cross, "cross 0 1 2 3 2 2 3 2"))
    m("cap", "cross-scaled", "valid", "weights scaled", lines(cross, "cross 0 0 4 6 4 2 3 2"))
    m("twice", "cross-at-common-vertex", "invalid not-refuted", "triangles that only share a vertex there",
      lines("begin disjoint-mesh", "begin disjoint-mesh\ncross 0 1 1 0 0 1 0 0"))
    m("twice", "cross-on-common-edge", "invalid not-refuted", "triangles that only share an edge there",
      lines("begin disjoint-mesh", "begin disjoint-mesh\ncross 0 1 1 0 1 1 1 0"))
    m("twice", "cross-wrong-second", "invalid wrong-point", "the second line's weights changed",
      lines("cross 0 15 1 1 0 0 1 1", "cross 0 15 1 2 0 0 1 1"))
    m("twice", "cross-order", "valid", "cross lines may stand in any order",
      lines("cross 0 14 0 1 0 0 0 1\ncross 0 15 1 1 0 0 1 1", "cross 0 15 1 1 0 0 1 1\ncross 0 14 0 1 0 0 0 1"))
    pinched = "cross 0 0 1 0 0 1 0 0"
    m("pinched", "cross-at-pinched", "invalid not-refuted", "a mesh that touches the top at a pinched vertex only",
      claim("disjoint-top", "refuted"), claim("i2", "refuted"), blocks(disjoint_top=pinched, i2=None))


def first(text):
    """The first vertex line of an OFF file."""
    return text.split("\n")[2]


def contacts(m):
    t, line = "tetrahedron", "contact 0 1 b0,m1,b3,m3 0 1 0 0 1 0 0 -3*2^1"
    m(t, "i2-claimed", "invalid missing-separation", "i2 claimed, no planes", claim("i2", "certified"), blocks(i2=""))
    m(t, "i2-claimed-with-planes", "invalid not-separated", "i2 claimed, planes that do not separate",
      claim("i2", "certified"), blocks(i2="contact-sep 0 1 b0,m1,b3,m3 n:g0,g1"))
    m("inside", "contact-sep-not-needed", "invalid superfluous", "a contact-sep line of a positive dot",
      blocks(i2="contact-sep 0 0 m0,m1,m2,t2 n:g0,g1"))
    m("inside", "contact-sep-unknown-tet", "invalid superfluous", "a contact-sep line of no tet", blocks(i2="contact-sep 0 0 b0,m1,t1,t2 n:g0,g1"))
    m("inside", "contact-sep-order", "malformed syntax", "contact-sep lines not ascending",
      blocks(i2="contact-sep 0 0 m0,m1,t1,t2 n:g0,g1\ncontact-sep 0 0 m0,t0,t1,t2 n:g0,g1\ncontact-sep 0 0 m0,m1,m2,t2 n:g0,g1"))
    m(t, "contact-unknown-tet", "invalid unknown-tet", "no tet", lines(line, line.replace("b0,m1,b3,m3", "b0,t1,b3,m3")))
    m(t, "contact-weights", "invalid wrong-point", "other weights", lines(line, line.replace("0 1 0 0 1 0 0", "0 1 0 0 1 0 1")))
    m(t, "contact-other-dot", "invalid wrong-value", "another dot", lines(line, line.replace("-3*2^1", "-3*2^2")))
    m(t, "contact-dot-zero", "invalid wrong-value", "the dot called zero", lines(line, line.replace("-3*2^1", "0")))
    m(t, "contact-positive", "invalid not-refuted", "a positive dot, with its value",
      lines(line, "contact 0 0 m0,m1,m2,t2 1 0 0 1 0 0 0 1*2^1"))
    m(t, "contact-no-weights", "malformed syntax", "the tet's weights all zero", lines(line, line.replace("0 1 0 0 1 0 0", "0 1 0 0 0 0 0")))
    m(t, "contact-fewer", "valid", "one contact less", drop(line))
    # Two prisms at a right angle: a pillar of one lies in the plane of the other's triangle.
    roof = {"bottom": off("1 0 -1/4 0 -1/1 4 -1/1 0 -4", SQUARE), "middle": off("0 0 0/4 0 0/0 4 0/0 0 -4", SQUARE),
            "top": off("-1 0 1/4 0 1/-1 4 1/-1 0 -4", SQUARE), "mesh": off("0 0 0/4 0 0/0 4 0/0 0 -4", SQUARE)}
    facts = "v 0 m0/v 1 m1/v 2 m2/v 3 m3/c 0 1 2/c 0 2 3/d mesh 0 0/d middle 0 0".replace("/", "\n")
    empty = f"begin overlay\n{facts}\nbegin disjoint-mesh\nbegin disjoint-bottom\nbegin disjoint-top\nbegin i2\n"
    refuted = EVERYTHING.replace(" i2", " -i2")
    touch = "contact 0 1 m0,m2,m3,t3 1 0 0 1 0 0 0 "
    m("boundary", "contact-of-dot-zero", "valid", "the dot is exactly 0: a contact", whole(refuted, empty + touch + "0"), files=roof)
    m("boundary", "contact-of-dot-one", "invalid wrong-value", "the dot is exactly 0, called 1", whole(refuted, empty + touch + "1"), files=roof)
    m("boundary", "i2-claimed-dot-zero", "invalid missing-separation", "i2 claimed where a dot is exactly 0",
      whole(EVERYTHING, empty), files=roof)
    hip = {part: lambda t, make=make: lines(first(make(t)), "0.0 0.0 0.0")(make(t)) for part, make in roof.items() if part in ("bottom", "top")}
    pinned = {**roof, **hip}
    for name, answer, what, weights in [
            ("contact-at-pinched", "invalid not-refuted", "the dot is 0, but they touch at a pinched vertex only", "1 0 0 1 0 0 0"),
            ("contact-beside-pinched", "valid", "the dot is 0, and they touch at a vertex that is not pinched", "0 0 1 0 1 0 0"),
            ("contact-near-pinched", "valid", "the dot is 0, and they touch on an edge with a pinched end", "1 0 1 1 1 0 0")]:
        m("boundary", name, answer, what, whole(refuted, f"{empty}contact 0 1 m0,m2,m3,t3 {weights} 0"),
          lines("pinched 0", "pinched 16 0"), files=pinned)


def separation_from_tets(m):
    """Two prisms, one upside down beside the hypotenuse of the other: contacts that upright planes exclude."""
    def layer(a, b):
        return off(f"0 0 {a}/4 0 {a}/0 4 {a}/3 3 {b}/3 3.5 {b}/3.5 3 {b}", "0 1 2/3 4 5")

    files = {"bottom": layer(-1, 1.25), "middle": layer(0, .25), "top": layer(1, -.75), "mesh": layer(0, .25)}
    facts = "\n".join([f"v {i} m{i}" for i in range(6)] + ["c 0 1 2", "c 3 4 5", "d mesh 0 0", "d mesh 1 0", "d middle 0 0", "d middle 1 0"])
    head = f"begin overlay\n{facts}\nbegin disjoint-mesh\nbegin disjoint-bottom\nbegin disjoint-top\nbegin i2\n"
    seps = [f"contact-sep 0 1 {tet} l:g1,g2" for tet in OPEN_BELOW]

    def row(name, answer, what, body):
        m("two-components", name, answer, what, whole(EVERYTHING, head + "\n".join(body)), files=files)

    row("contact-seps", "valid", "upright planes between a triangle and tets of a prism upside down", seps)
    row("contact-sep-first-dropped", "invalid missing-separation", "the first contact-sep line is missing", seps[1:])
    row("contact-sep-last-dropped", "invalid missing-separation", "the last contact-sep line is missing", seps[:-1])
    row("contact-sep-plane", "invalid not-separated", "a plane on another edge of the triangle",
        [seps[0].replace("l:g1,g2", "l:g0,g1"), *seps[1:]])
    row("contact-sep-two-planes", "valid", "a plane with nothing left to separate", [seps[0] + " l:g0,g1", *seps[1:]])
    row("contact-sep-wrong-first", "invalid not-separated", "a wrong plane before the right one",
        [seps[0].replace("l:g1,g2", "l:g0,g1 l:g1,g2"), *seps[1:]])
    row("contact-sep-other-slab", "invalid superfluous", "a tet of the slab that is not near", ["contact-sep 0 1 b3,m3,b4,b5 l:g1,g2", *seps])
    row("contact-sep-own-prism", "invalid superfluous", "a tet of the triangle's own prism", ["contact-sep 0 0 m0,m1,m2,t2 l:g1,g2", *seps])
    row("contact-seps-swapped", "malformed syntax", "two contact-sep lines swapped", [seps[1], seps[0], *seps[2:]])
    row("contact-sep-twice", "malformed syntax", "a contact-sep line twice", [seps[0], *seps])


def separation_from_boxes(m):
    """As above, but only one layer of the other prism (3 4 5) comes near the triangle 0 of the first (0 1 6). Vertex 2 is unused."""
    upright = [("bottom", -1), ("middle", 0), ("top", 1)]
    first, near = "0 0 {0}/4 0 {0}", "3 3 {0}/3 3.5 {0}/3.5 3 {0}"
    wide, narrow = "3 3 {0}/3 6 {0}/6 3 {0}", "4.25 4.25 {0}/4.25 5.25 {0}/5.25 4.25 {0}"
    for layer, height, unused, other in [
            ("bottom", 1, "3.25 3.25", [near, near, near]), ("top", 0, "3.25 3.25", [near, near, near]),
            ("middle", 0, "5 5", [narrow, wide, narrow])]:
        files = {part: off(f"{first.format(z + height)}/{unused} {.5 + .125 * z}/{low.format(.25 - z)}/0 4 {z + height}", "0 1 6/3 4 5")
                 for (part, z), low in zip(upright, other)}
        files["mesh"] = off(f"{first.format(height)}/0 4 {height}/{other[1].format(.25)}", "0 1 2/3 4 5")
        facts = [f"v {i} m{n}" for i, n in enumerate([0, 1, 6, 3, 4, 5])]
        facts += ["c 0 1 2", "c 3 4 5", "d mesh 0 0", "d mesh 1 0", "d middle 0 0", "d middle 1 0"]
        blocks = ["overlay", *facts, "begin disjoint-mesh", "begin disjoint-bottom", "begin disjoint-top", "begin i2"]
        m("two-components", f"no-contact-sep-{layer}", "invalid missing-separation",
          f"a prism of which only the {layer} comes near a triangle, and no plane", whole(EVERYTHING, "begin " + "\n".join(blocks)), files=files)


# The tets that no plane of a face separates from the other prism's triangle (by the definition, tried out on all 24).
OPEN_BELOW = ["m3,t3,m4,m5", "m3,t3,m4,t5", "m3,t3,t4,m5", "m3,t3,t4,t5", "m3,m4,t4,m5", "m3,m4,m5,t5", "t3,m4,t4,t5", "t3,t4,m5,t5"]


def refuted_for_another_reason(m):
    """`section-all-orders` is refuted since `positivity` is: nothing else is asked, not even on a bent wall."""
    files = {"bottom": off("0 0 -1/1 0 -1/0 3 .25", "0 1 2"), "middle": off("0 0 0/1 0 0/0 1 0", "0 1 2"),
             "top": off("0 -.25 1/1 0 1/0 1 1", "0 1 2"), "mesh": off("0 -.125 .5/1 0 .5/0 1 .5/.5 0 .5", "0 3 2/3 1 2")}
    overlay = ("v 0 m0,t0/v 1 m1,t1/v 2 m2,t2/v 3 m0,t1/v 0,2 m0,t2/v 1,2 m1,t2/v 2,3 m0,m1,t2/"
               "c 0 3 4/c 3 6 4/c 4 6 2/c 3 1 5 6/c 6 5 2/d mesh 0 0/d middle 3 1").replace("/", "\n")
    section = f"begin overlay\n{overlay}"
    m("boundary", "all-orders-bent-wall", "invalid not-positive", "all claimed, on a bent wall and with a bad tet", whole(ALL_ORDERS, section), files=files)
    m("boundary", "all-orders-refuted-bent-wall", "valid", "refuted since positivity is",
      whole("-positivity section bijection -section-all-orders", f"begin positivity\ntet 0 m0,m1,b2,m2 -1*2^-2\n{section}"), files=files)


def harmless(m):
    """Weaker certificates: valid, and the answer lists what is left."""
    m("two-components", "section-only", "valid", "section and bijection only",
      lambda t: whole("section bijection", t[t.index("begin overlay"):t.index("begin disjoint-mesh")])(t))
    m("two-components", "disjoint-mesh-only", "valid", "one claim only",
      lambda t: whole("disjoint-mesh", t[t.index("begin disjoint-mesh"):t.index("begin disjoint-bottom")])(t))
