"""Mutants of `disjoint-prisms`: FORMAT.md 3.7, and what sections 2 and 3 say about its lines."""
import functools

from make_mutants import after, blocks, drop, lines, swap

REFUTED, CERTIFIED = "claim disjoint-prisms refuted", "claim disjoint-prisms certified"


def add_all(corpus):
    m = functools.partial(corpus.add, facts=True)

    for part in (separations, parts, overlaps, flat, alone):
        part(m)


def turned(facts):
    """The opposite verdict, with these facts."""
    def edit(text):
        old, new = (REFUTED, CERTIFIED) if REFUTED in text else (CERTIFIED, REFUTED)
        return blocks(disjoint_prisms=facts)(lines(old, new)(text))
    return edit


def separations(m):
    """Faces of tets of a flat patch; its walls and sheets are flat, so that most neighbours need a plane."""
    one = "sep 0 2 l:b0,m1"
    m("prisms", "sep-dropped", "invalid missing-separation", "the first sep line is missing", drop(one))
    m("prisms", "seps-dropped", "invalid missing-separation", "no sep line at all", blocks(disjoint_prisms=""))
    m("prisms", "sep-plane", "invalid not-separated", "a plane through another side", lines(one, "sep 0 2 l:b0,b1"))
    m("prisms", "sep-normal-zero", "invalid not-separated", "a plane that is none", lines(one, "sep 0 2 n:b0,b0"))
    m("prisms", "sep-two-planes", "valid", "a plane with nothing left to separate", lines(one, one + " l:b0,m1"))
    m("prisms", "sep-of-opposite-sheets", "invalid superfluous", "triangles far apart", lines(one, "sep 0 1 l:b0,m1\n" + one))
    m("prisms", "sep-one-of-itself", "malformed syntax", "a triangle and itself", lines(one, "sep 0 0 l:b0,m1\n" + one))
    m("prisms", "sep-turned", "malformed syntax", "the greater number first", lines(one, "sep 2 0 l:b0,m1"))
    m("prisms", "sep-twice", "malformed syntax", "a line twice", lines(one, one + "\n" + one))
    m("prisms", "sep-beyond-skin", "invalid superfluous", "more triangles than the skin has",
      blocks(disjoint_prisms="sep 0 4000000000 l:b0,m1"))
    m("prisms", "sep-beyond-skin-first", "invalid superfluous", "both triangles are beyond the skin",
      blocks(disjoint_prisms="sep 3999999999 4000000000 l:b0,m1"))
    m("prisms", "sep-id-long", "malformed syntax", "an id of eleven digits", lines(one, "sep 0 10000000000 l:b0,m1"))
    m("prisms", "sep-of-mesh", "malformed range", "a mesh vertex, but there is no mesh", lines(one, "sep 0 2 l:b0,g1"))
    m("prisms", "sep-names", "malformed range", "no such vertex", lines(one, "sep 0 2 l:b0,m9"))
    m("prisms", "refuted-by-nothing", "malformed syntax", "refuted without a fact", turned(""))
    m("prisms", "refuted-by-seps", "malformed syntax", "refuted by what certifies", lines(CERTIFIED, REFUTED))
    m("prisms", "refuted-by-forced-point", "invalid not-refuted", "two tets at their common face",
      turned("overlap b0,b1,b4,m4 1 3 0 2 b0,b1,m1,m4 2 6 0 4"))
    m("prisms", "refuted-by-forced-corner", "invalid not-refuted", "two tets at their common corner",
      turned("overlap b0,b1,b4,m4 0 0 0 2 b0,b1,m1,m4 0 0 0 5"))


def parts(m):
    """What is apart may still lie in another tet."""
    inner = "1.0 0.5 {0}\n3.0 1.0 {0}\n3.0 3.0 {0}\n1.0 3.0 {0}"
    lowered = {part: swap(inner.format(high), inner.format(high - 0.75))
               for part, high in (("bottom", 1.125), ("middle", 1.25), ("top", 1.375))}
    m("patches", "one-in-the-other", "invalid overlap", "the same planes, but one part lies in a tet of the other", files=lowered)
    m("lenses-crossed", "claimed", "invalid overlap", "no two sheets meet but in the pinched rim, and the lenses overlap", turned(""))
    m("patch-in-patch", "claimed-without-planes", "invalid missing-separation", "one part lies in a tet of the other, and no planes",
      turned(""))
    m("stacked-touching", "claimed", "invalid missing-separation", "a shell that stands on another", turned(""))
    m("wound-ring", "claimed", "invalid missing-separation", "a ring that goes around twice", turned(""))
    m("lenses", "refuted", "malformed syntax", "refuted without a fact", lines(CERTIFIED, REFUTED))
    m("lenses", "refuted-at-rim", "invalid not-refuted", "two lenses at their pinched rim",
      turned("overlap m0,m2,b4,m4 1 1 0 0 m0,m2,b5,m5 2 2 0 0"))


def overlaps(m):
    line = "overlap b4,m4,m5,m6 1 1 1 0 m0,t0,t1,t2 13 1 6 4"
    c = "patch-in-patch"
    m(c, "overlap-weights", "invalid wrong-point", "other weights", lines(line, line.replace("13 1", "13 2")))
    m(c, "overlap-scaled", "valid", "weights times three", lines(line, "overlap b4,m4,m5,m6 3 3 3 0 m0,t0,t1,t2 13 1 6 4"))
    m(c, "overlap-turned", "valid", "the tets exchanged", lines(line, "overlap m0,t0,t1,t2 13 1 6 4 b4,m4,m5,m6 1 1 1 0"))
    m(c, "overlap-twice", "valid", "the same line twice", after(line, line))
    m(c, "overlap-first-tet", "invalid unknown-tet", "four names that are no tet", lines(line, line.replace("b4,m4,m5,m6", "b4,m4,m5,m7")))
    m(c, "overlap-second-tet", "invalid unknown-tet", "a tet of another order",
      lines(line, line.replace("m0,t0,t1,t2", "t0,m1,t1,t2")))
    m(c, "overlap-names-order", "malformed syntax", "names not ascending", lines(line, line.replace("m0,t0,t1,t2", "t0,m0,t1,t2")))
    m(c, "overlap-no-weights", "malformed syntax", "all weights zero", lines(line, line.replace("1 1 1 0", "0 0 0 0")))
    m(c, "overlap-three-weights", "malformed syntax", "a weight is missing", lines(line, line.replace("1 1 1 0", "1 1 1")))
    m(c, "overlap-range", "malformed range", "no such vertex", lines(line, line.replace("m6", "m8")))
    m(c, "overlap-digits", "limit digits", "a weight with 4001 digits", lines(line, line.replace("13 1 6 4", "13 1 6 " + "4" * 4001)))
    m(c, "overlap-then-tet", "malformed syntax", "a tet line after it", after(line, "tet 0 m0,t0,t1,t2 1"))
    m(c, "overlap-itself", "invalid not-refuted", "a tet and itself",
      lines(line, "overlap b4,m4,m5,m6 1 1 1 0 b4,m4,m5,m6 2 2 2 0"))


def flat(m):
    line, c = "tet 0 m0,m1,t1,t2 0", "prisms-flat"
    m(c, "claimed", "invalid not-positive", "claimed in spite of a flat tet", turned(""))
    m(c, "value", "invalid wrong-value", "another determinant", lines(line, "tet 0 m0,m1,t1,t2 -1"))
    m(c, "positive", "invalid not-refuted", "a positive tet", lines(line, "tet 0 b0,b1,b2,m2 1*2^4"))
    m(c, "other-tet", "invalid unknown-tet", "a tet of another order", lines(line, "tet 0 t0,m1,t1,t2 0"))
    m(c, "tet-twice", "malformed syntax", "one tet line is enough", after(line, line))
    m(c, "tet-then-overlap", "malformed syntax", "both kinds of facts", after(line, "overlap m0,m1,t1,t2 1 0 0 0 m0,m1,t1,t2 0 1 0 0"))
    m(c, "overlap-in-flat-tet", "valid", "a flat tet has a point twice",
      lines(line, "overlap m0,m1,t1,t2 0 0 1 0 m0,m1,t1,t2 0 1 0 0"))


def alone(m):
    """The claim needs no mesh and no other claim, and comes last."""
    sha = "0" * 64
    m("prisms", "mesh-line", "malformed syntax", "a mesh line that no claim needs",
      swap("\norder id\n", f"\nmesh {sha} 9 8\norder id\n"))
    m("lenses", "with-positivity", "invalid not-positive", "the wall of the rim between the lenses is no tet",
      lines(CERTIFIED, "claim positivity certified\n" + CERTIFIED), files={"top": swap("0.0 0.0 -0.5", "0.0 0.0 0.5")})
    m("lenses", "positivity-first", "valid", "two claims without a mesh", lines(CERTIFIED, "claim positivity certified\n" + CERTIFIED))
    m("lenses", "positivity-last", "malformed syntax", "claims not in their order", lines(CERTIFIED, CERTIFIED + "\nclaim positivity certified"))
    m("lenses", "claim-twice", "malformed syntax", "the claim twice", lines(CERTIFIED, CERTIFIED + "\n" + CERTIFIED))
    m("lenses", "no-mesh-for-section", "malformed syntax", "section and bijection, without the mesh line",
      lines(CERTIFIED, "claim section certified\nclaim bijection certified\n" + CERTIFIED))
    m("lenses", "three-files", "valid", "no mesh is given", inputs=["bottom", "middle", "top"])
    m("lenses", "block-missing", "malformed syntax", "no block", blocks(disjoint_prisms=None))
