"""Mutants: the answers are stated by hand from MESHES.md."""
import hashlib
import re

from controls import SQUARE, annulus, cone, octahedron, solid_torus, square, tetra, torus
from corpus_files import BIG, about
from make import Mesh, Q, after, crossed, drop, swap


def add_all(corpus):
    form(corpus)
    claims(corpus)
    numbers(corpus)
    lines(corpus)
    inputs(corpus)
    complex_files(corpus)
    conditions(corpus)
    planes(corpus)
    rays(corpus)
    positions(corpus)
    witnesses(corpus)


def first(pattern, new):
    """Replaces the first place that fits."""
    def edit(text):
        found = re.sub(pattern, new, text, count=1, flags=re.M)
        assert found != text, pattern
        return found
    return edit


def form(corpus):
    m = about(corpus.mutant, "nested-tetrahedra", facts=False)

    m("empty", "malformed truncated", "an empty file", lambda t: "")
    m("cut", "malformed truncated", "the last bytes are missing", lambda t: t[:-9])
    m("no-final-newline", "malformed truncated", "the last byte is not LF", lambda t: t[:-1])
    m("text-after-end", "malformed truncated", "a line after the end", after("end", "claim nested certified"))
    m("two-ends", "malformed syntax", "two end lines", after("end", "end"))
    m("crlf", "malformed bytes", "lines end in CR LF", lambda t: t.replace("\n", "\r\n"))
    m("bytes-before-truncated", "malformed bytes", "a NUL byte and no end", swap("begin a", "begin\0a"), drop("end"))
    m("not-ascii", "malformed bytes", "a byte above 0x7f", swap("begin rays", "begin r\xe4ys"))
    m("truncated-before-magic", "malformed truncated", "no magic and no end", drop("homeo-meshes 1"), drop("end"))
    m("version-2", "malformed magic", "another version", swap("homeo-meshes 1", "homeo-meshes 2"))
    m("no-magic", "malformed magic", "the first line is missing", drop("homeo-meshes 1"))
    m("magic-with-space", "malformed magic", "a space after the magic", swap("homeo-meshes 1", "homeo-meshes 1 "))
    m("double-space", "malformed syntax", "two spaces", swap("begin rays", "begin  rays"))
    m("trailing-space", "malformed syntax", "a space at the end of a line", swap("begin rays", "begin rays "))
    m("empty-line", "malformed syntax", "an empty line", swap("begin rays", "\nbegin rays"))
    m("comment", "malformed syntax", "a comment", swap("begin rays", "# rays\nbegin rays"))
    m("missing-block", "malformed syntax", "a block is missing", drop("begin between"))
    m("blocks-swapped", "malformed syntax", "two blocks in another order", swap("begin b\nbegin between", "begin between\nbegin b"))
    m("block-twice", "malformed syntax", "a block twice", after("begin b", "begin b"))
    m("counts-other", "malformed counts", "another count", swap("counts 0 0 0 2", "counts 0 0 0 1"))
    m("counts-fewer", "malformed counts", "a count is missing", swap("counts 0 0 0 2", "counts 0 0 0"))
    m("counts-more", "malformed counts", "a count too many", swap("counts 0 0 0 2", "counts 0 0 0 2 0"))
    m("counts-zeros", "malformed syntax", "a count with a leading zero", swap("counts 0 0 0 2", "counts 0 0 0 02"))
    m("no-counts", "malformed syntax", "no counts line", drop("counts 0 0 0 2"))
    m("counts-of-no-block", "malformed counts", "a count where there is no block", swap("counts", "counts 0"), control="manifold-surface")
    m("block-of-no-claim", "malformed syntax", "a block that the claim does not have", swap("counts", "begin a\ncounts 0"), control="manifold-surface")
    m("magic-alone", "malformed syntax", "nothing but the magic and the end", lambda t: "homeo-meshes 1\nend\n")


def claims(corpus):
    m = corpus.mutant

    m("genus", "certified", "malformed claims", "nested-topology cannot be certified", swap("refuted", "certified"))
    m("genus", "claims-before-input", "malformed claims", "a claim that does not exist, before a bad input line",
      swap("refuted", "certified"), swap("input a", "input c"))
    m("genus", "unknown-claim", "malformed syntax", "an unknown claim", swap("nested-topology", "nested-genus"))
    m("genus", "unknown-verdict", "malformed syntax", "an unknown verdict", swap("refuted", "undecided"))
    m("nested-tetrahedra", "two-claims", "malformed syntax", "two claim lines", after("claim nested certified", "claim embedded certified"))
    m("nested-tetrahedra", "one-input", "malformed syntax", "one input line", first("^input b .*\n", ""))
    m("nested-tetrahedra", "inputs-swapped", "malformed syntax", "b before a", first("(input a .*\n)(input b .*\n)", r"\2\1"))
    m("manifold-surface", "two-inputs", "malformed syntax", "an input too many", first("(input) a (.*\n)", r"\1 a \2\1 b \2"))
    m("manifold-surface", "tets-in-the-plane", "malformed claims", "tets in the plane", swap(" 3 3 6 8", " 2 4 6 8"))
    m("manifold-surface", "space-4", "malformed syntax", "a space of dimension 4", swap(" 3 3 6 8", " 4 3 6 8"))
    m("manifold-surface", "segments", "malformed syntax", "cells of two corners", swap(" 3 3 6 8", " 3 2 6 8"))
    m("manifold-surface", "short-hash", "malformed syntax", "a hash with 63 digits", first("input a .", "input a "))
    m("manifold-surface", "capital-hash", "malformed syntax", "a hash in capitals", first("input a [0-9a-f]{64}", lambda f: "input a " + "A" * 64))
    m("embedded-torus", "flat-map", "malformed claims", "embedded is about surfaces", swap(" 3 3 12 24", " 2 3 12 24"))
    m("embedded-torus", "tets", "malformed claims", "embedded is not about tets", swap(" 3 3 12 24", " 3 4 12 24"))
    m("topology-loops", "tets", "malformed claims", "same-topology is not about tets", swap(" 2 3 5 4", " 3 4 5 4"))
    m("nested-tetrahedra", "flat-map", "malformed claims", "nested is about surfaces", first("(input b \\w+) 3 3", r"\1 2 3"))
    m("map-uv", "other-corners", "malformed claims", "inputs that differ in the corners of a cell", first("(input b \\w+) 2 3", r"\1 3 4"))
    m("map-uv", "other-number", "malformed claims", "inputs that differ in the number of cells", first("(input b \\w+ 2 3) 5 4", r"\1 5 5"))
    m("map-uv", "tets-in-the-plane", "malformed claims", "tets in the plane", first("(input a \\w+) 3 3", r"\1 2 4"), first("(input b \\w+) 2 3", r"\1 2 4"))
    m("map-uv", "claims-before-blocks", "malformed claims", "the inputs do not fit, and a block is missing", first("(input b \\w+ 2 3) 5 4", r"\1 5 5"), drop("begin b"))
    # Verdicts turned over.
    m("manifold-surface", "refuted", "malformed syntax", "refuted without a witness", swap("certified", "refuted"))
    m("defect-vertex", "certified", "malformed syntax", "certified with a witness", swap("refuted", "certified"))
    m("defect-vertex", "certified-without", "invalid mesh-conditions", "certified", swap("refuted", "certified"), swap("begin witness\nvertex a 0 0 1\n", ""))
    m("topology-genus", "certified", "invalid topology", "sphere and torus", swap("refuted", "certified"))
    m("topology-loops", "certified", "invalid topology", "a disc and an annulus", swap("refuted", "certified"))
    m("topology-two-and-one", "certified", "invalid topology", "two spheres and one", swap("refuted", "certified"))
    m("topology-components", "refuted", "invalid not-refuted", "the same topology", swap("certified", "refuted"))
    m("genus", "same-genus", "invalid not-refuted", "the cage's genus is not greater", b=tetra(9))
    m("genus", "nested-refuted", "malformed syntax", "another claim without its witness", swap("nested-topology", "nested"))
    bare = swap("begin witness", "begin a\nbegin b\nbegin between\nbegin rays")
    m("nested-one-of-two", "certified", "invalid winding", "a cage around one of two spheres", swap("refuted", "certified"), bare,
      swap("winding a 6 7 2 4", "ray a 0 7 2 4 0\nray a 6 7 2 4\nray b 0 7 2 4"))
    m("nested-turned", "certified", "invalid winding", "a cage turned inside out", swap("refuted", "certified"), bare,
      first("winding(.*)", r"ray\1\nray b 0 7 2 4"))
    m("nested-reverse", "certified", "invalid winding", "the cage inside", swap("refuted", "certified"), bare,
      first("winding(.*)", r"ray a 0 7 2 4\nray\1"))
    m("nested-open", "certified", "invalid not-closed", "a cage with a hole", swap("refuted", "certified"), bare,
      swap("open b 1 2", "ray a 0 7 2 4 0\nray b 0 7 2 4"))
    m("nested-touching", "certified", "invalid missing-separation", "a cage that is touched", swap("refuted", "certified"), bare,
      swap("cross ab 0 0 1 0 0 1 1 1", "ray a 3 7 2 4 0\nray b 0 7 2 4"))
    m("nested-defect", "certified", "invalid mesh-conditions", "a triangle twice", swap("refuted", "certified"), bare,
      swap("twin b 0 4", "ray a 0 7 2 4 0\nray b 0 7 2 4"))


def numbers(corpus):
    m = corpus.mutant

    cross = "cross ab 0 0 1 0 0 1 1 1"
    m("nested-touching", "digits", "limit digits", "a weight of 4001 digits", swap(cross, f"cross ab 0 0 {BIG} 0 0 1 1 1"))
    m("nested-touching", "many-digits", "valid", "weights of 4000 digits", swap(cross, f"cross ab 0 0 {BIG[1:]} 0 0 {BIG[1:]} {BIG[1:]} {BIG[1:]}"))
    m("nested-touching", "digits-before-range", "limit digits", "a weight that is too long, a cell out of range", swap(cross, f"cross ab 9 0 {BIG} 0 0 1 1 1"))
    m("nested-touching", "syntax-before-digits", "malformed syntax", "a weight that is too long, and one that is missing", swap(cross, f"cross ab 0 0 {BIG} 0 0 1 1"))
    m("nested-touching", "weights-zero", "malformed syntax", "weights that are all zero", swap(cross, "cross ab 0 0 0 0 0 1 1 1"))
    m("nested-touching", "weight-negative", "malformed syntax", "a negative weight", swap(cross, "cross ab 0 0 1 0 0 1 -1 1"))
    m("nested-touching", "weight-with-zero", "malformed syntax", "a weight with a leading zero", swap(cross, "cross ab 0 0 01 0 0 1 1 1"))
    m("nested-touching", "weights-four", "malformed syntax", "a weight too many", swap(cross, "cross ab 0 0 1 0 0 1 1 1 0"))
    m("nested-touching", "range-a", "malformed range", "no such cell of a", swap(cross, "cross ab 4 0 1 0 0 1 1 1"))
    m("nested-touching", "range-b", "malformed range", "no such cell of b", swap(cross, "cross ab 0 8 1 0 0 1 1 1"))
    m("nested-touching", "id-with-zero", "malformed syntax", "an id with a leading zero", swap(cross, "cross ab 00 0 1 0 0 1 1 1"))
    m("nested-touching", "id-long", "malformed syntax", "an id of eleven digits", swap(cross, "cross ab 10000000000 0 1 0 0 1 1 1"))
    m("nested-touching", "id-of-ten-digits", "malformed range", "an id of ten digits", swap(cross, "cross ab 9999999999 0 1 0 0 1 1 1"))
    m("nested-torus", "range-facet", "malformed range", "no such triangle", swap("sep 22 23", "sep 22 24"))
    m("map-tets-ring", "range-facet", "malformed range", "no such facet", swap("\nbegin b", "\nsep 47 48 n:a0,a1\nbegin b"))
    m("nested-torus", "range-plane", "malformed range", "no such vertex in a plane", swap("sep 0 1 l:b0,b4", "sep 0 1 l:b0,b12"))
    m("nested-rings", "range-plane-of-a", "malformed range", "no such vertex of a in a plane", first("^begin between\nsep 0 10 l:a0,a3", "begin between\nsep 0 10 l:a0,a12"))
    m("nested-tetrahedra", "range-ray-vertex", "malformed range", "a ray from no vertex", swap("ray a 3 7 2 4 1", "ray a 4 7 2 4 1"))
    m("nested-tetrahedra", "range-ray-triangle", "malformed range", "a ray through no triangle", swap("ray a 3 7 2 4 1", "ray a 3 7 2 4 4"))
    m("defect-vertex", "range-vertex", "malformed range", "no such vertex", swap("vertex a 0 0 1", "vertex a 6 0 1"))
    m("defect-vertex", "range-cell", "malformed range", "no such cell", swap("vertex a 0 0 1", "vertex a 0 0 2"))
    m("defect-facet", "range-ids", "malformed range", "no such vertex in a list", swap("facet a 0,2 ", "facet a 0,6 "))
    m("map-cross-glued", "range-facet", "malformed range", "no such facet", swap("twice b 38 4", "twice b 48 4"))
    m("map-cross-glued", "range-cell", "malformed range", "no such cell", swap("twice b 38 4", "twice b 38 16"))
    m("nested-open", "range-vertex", "malformed range", "no such vertex", swap("open b 1 2", "open b 1 4"))


def lines(corpus):
    def m(control, name, what, *edits, answer="malformed syntax"):
        corpus.mutant(control, name, answer, what, *edits)

    sep, ray = "sep 0 1 l:b0,b4", "ray a 3 7 2 4 1"
    m("nested-torus", "sep-twice", "a pair twice", after(sep, sep))
    m("nested-torus", "sep-order", "pairs in another order", swap(f"{sep}\nsep 0 3 p:b0,b3,b4 n:b0,b3", f"sep 0 3 p:b0,b3,b4 n:b0,b3\n{sep}"))
    m("nested-torus", "sep-turned", "i greater than j", swap(sep, "sep 1 0 l:b0,b4"))
    m("nested-torus", "sep-same", "i equal to j", swap(sep, "sep 0 0 l:b0,b4"))
    m("nested-torus", "sep-without-planes", "no plane", swap(sep, "sep 0 1"))
    m("nested-torus", "plane-kind", "an unknown kind of plane", swap(sep, "sep 0 1 q:b0,b4"))
    m("nested-torus", "plane-points", "a plane through two points", swap(sep, "sep 0 1 p:b0,b4"))
    m("nested-torus", "line-points", "a line through three points", swap(sep, "sep 0 1 l:b0,b4,b5"))
    m("nested-torus", "plane-of-other-input", "a vertex of a in block b", swap(sep, "sep 0 1 l:a0,b4"))
    m("nested-torus", "plane-of-shell", "a mesh vertex as FORMAT names it", swap(sep, "sep 0 1 l:g0,g4"))
    m("nested-rings", "plane-of-other-input", "a vertex of b in block a", swap("begin a\nsep 0 1 l:a0,a4", "begin a\nsep 0 1 l:a0,b4"))
    m("nested-rings", "between-between", "a pair twice in between", first("^(begin between\n)(sep .*\n)", r"\1\2\2"))
    m("nested-tetrahedra", "ray-of-c", "an unknown input", swap(ray, "ray c 3 7 2 4 1"))
    m("nested-tetrahedra", "ray-order", "ray b first", swap(f"{ray}\nray b 0 7 2 4", f"ray b 0 7 2 4\n{ray}"))
    m("nested-tetrahedra", "ray-order-before-range", "ray b first, through no triangle", swap(f"{ray}\nray b", "ray b 3 7 2 4 9\nray b"))
    m("nested-tetrahedra", "ray-without-a", "no ray a", drop(ray))
    m("nested-tetrahedra", "ray-without-b", "no ray b", drop("ray b 0 7 2 4"))
    m("nested-tetrahedra", "ray-without-direction", "a direction that is zero", swap(ray, "ray a 3 0 0 0 1"))
    m("nested-tetrahedra", "ray-minus-zero", "a minus zero", swap(ray, "ray a 3 7 2 -0 1"))
    m("nested-tetrahedra", "ray-long", "a direction of eleven digits", swap(ray, "ray a 3 70000000000 2 4 1"))
    m("nested-tetrahedra", "ray-descending", "triangles in another order", swap(ray, "ray a 3 7 2 4 2 1"))
    m("nested-tetrahedra", "ray-repeated", "a triangle twice", swap(ray, "ray a 3 7 2 4 1 1"))
    m("nested-tetrahedra", "ray-word", "a winding line among the rays", swap(ray, "winding a 3 7 2 4 1"))
    m("map-uv", "sep-in-the-plane", "a line about a flat map", after("begin b", "sep 0 3 n:b0,b1"))
    m("defect-facet", "ids-many", "three vertices of an edge", swap("facet a 0,2 ", "facet a 0,2,4 "))
    m("defect-facet", "ids-one", "one vertex of an edge", swap("facet a 0,2 ", "facet a 0 "))
    m("defect-facet", "ids-descending", "vertices in another order", swap("facet a 0,2 ", "facet a 2,0 "))
    m("defect-facet", "cells-descending", "cells in another order", swap("0 1 2\ncounts", "0 2 1\ncounts"))
    m("defect-facet", "cells-repeated", "a cell twice", swap("0 1 2\ncounts", "0 1 1\ncounts"))
    m("defect-facet", "of-b", "an input that the claim does not have", swap("facet a", "facet b"))
    m("defect-vertex", "edge-of-triangles", "an edge line about triangles", swap("vertex a 0 0 1", "edge a 0,2 0 1"))
    m("defect-vertex", "link-of-triangles", "a link line about triangles", swap("vertex a 0 0 1", "link a 0"))
    m("defect-vertex", "cells-descending", "cells in another order", swap("vertex a 0 0 1", "vertex a 0 1 0"))
    m("defect-edge", "ids-descending", "vertices in another order", swap("edge a 4,5 ", "edge a 5,4 "))
    m("defect-twin", "descending", "cells in another order", swap("twin a 0 2", "twin a 2 0"))
    m("defect-direction", "same", "a cell with itself", swap("direction a 0 2", "direction a 0 0"))
    m("defect-vertex", "cross-of-manifold", "a crossing does not refute manifold", swap("vertex a 0 0 1", "cross a 0 1 1 0 0 1 0 0"))
    m("defect-vertex", "no-witness", "a witness without lines", drop("vertex a 0 0 1"))
    m("defect-vertex", "witness-1001", "a witness of 1001 lines", swap("vertex a 0 0 1\n", "vertex a 0 0 1\n" * 1001))
    m("defect-vertex", "witness-1000", "a witness of 1000 lines", swap("vertex a 0 0 1\n", "vertex a 0 0 1\n" * 1000), answer="valid")
    m("embedded-crossing", "cross-ab", "ab with one input", swap("cross a 0", "cross ab 0"))
    m("embedded-crossing", "cross-turned", "i greater than j", swap("cross a 0 4", "cross a 4 0"))
    m("embedded-crossing", "winding", "a winding does not refute embedded", swap("cross a 0 4 6 1 1 3 3 2", "winding a 0 7 2 4"))
    m("map-folded", "cross-ab", "ab where the inputs are not compared", swap("cross b 0 2", "cross ab 0 2"))
    m("map-folded", "sign-of-surface", "a sign of a surface", swap("cross b 0 2 1 0 1 0 1 0", "sign b 0 0"))
    m("map-folded", "twice-of-surface", "a facet of a surface", swap("cross b 0 2 1 0 1 0 1 0", "twice b 0 1"))
    m("map-folded", "open", "an open surface is no defect", swap("cross b 0 2 1 0 1 0 1 0", "open b 0 1"))
    m("map-flipped", "sign-descending", "cells in another order", swap("sign b 0 3", "sign b 3 0"))


def inputs(corpus):
    m = about(corpus.mutant, "nested-tetrahedra")

    m("no-inputs", "malformed input", "no input file", inputs=[])
    m("one-file", "malformed input", "one file in place of two", inputs=["a.off"])
    m("three-files", "malformed input", "three files in place of two", inputs=["a.off", "b.off", "b.off"])
    m("no-such-file", "malformed input", "a file that does not exist", inputs=["a.off", "c.off"])
    m("files-swapped", "invalid hash", "the files in another order", inputs=["b.off", "a.off"])
    m("moved", "invalid hash", "another coordinate", b=swap("2.125 -2.0 -2.0", "2.25 -2.0 -2.0"))
    m("other-corner-order", "invalid hash", "a triangle with its corners rotated", b=swap("3 1 3 2", "3 3 2 1"))
    m("other-triangle-order", "invalid hash", "triangles in another order", b=swap("3 0 2 3\n3 1 3 2", "3 1 3 2\n3 0 2 3"))
    m("quad", "malformed input", "a face of four corners", b=swap("3 1 3 2", "4 1 3 2 0"))
    m("index", "malformed input", "an index out of range", b=swap("3 1 3 2", "3 1 4 2"))
    m("infinite", "malformed input", "an infinite coordinate", b=swap("2.125 -2.0 -2.0", "1e999 -2.0 -2.0"))
    m("empty-file", "malformed input", "an empty input file", b="")
    m("as-obj", "valid", "the same mesh as an OBJ file", b=lambda text: tetra(2).moved(by=(Q(1, 8), 0, 0)).obj())
    m("as-complex", "valid", "the same mesh as a complex file", b=lambda text: tetra(2).moved(by=(Q(1, 8), 0, 0)).complex_file())
    m("minus-zero", "valid", "a zero written with a minus", control="nested-touching", b=swap("OFF\n6 8 0\n3.0 0.0 0.0", "OFF\n6 8 0\n3.0 -0.0 0e9"))
    m("cells-differ", "invalid cells", "two inputs with other cells", control="map-annulus", b=Mesh(annulus(4, 3).points, [annulus(1, 2).cells[i] for i in (1, 0, 2, 3, 4, 5, 6, 7)]))
    m("corner-order-differs", "invalid cells", "two inputs with the corners of a cell rotated", control="map-uv", b=Mesh(square().points, [(1, 4, 0), *SQUARE[1:]]))
    corpus.mutant("map-uv", "other-space", "invalid hash", "another dimension than stated", swap(" 2 3 5 4", " 3 3 5 4"))
    corpus.mutant("manifold-surface", "other-vertices", "invalid hash", "another number of vertices than stated", swap(" 3 3 6 8", " 3 3 7 8"))
    corpus.mutant("manifold-surface", "other-cells", "invalid hash", "another number of cells than stated", swap(" 3 3 6 8", " 3 3 6 9"))
    # OFF has no dimension: a surface.
    corpus.mutant("manifold-plane", "off-is-space", "invalid hash", "an OFF file for a flat map", a="OFF\n5 4 0\n-2 -2 0\n2 -2 0\n2 2 0\n-2 2 0\n0 0 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n")


def complex_files(corpus):
    def m(name, answer, what, *edits, control="manifold-tets"):
        def both(text):
            for edit in edits:
                text = edit(text)
            return text
        corpus.mutant(control, name, answer, what, a=both)

    coordinate = swap("1 0 0\n-1 0 0", "1 0 0\n{} 0 0")
    def x(name, answer, what, text):
        m(name, answer, what, coordinate, swap("{}", text))

    x("number-other", "invalid hash", "another coordinate", "-3")
    x("number-even", "malformed input", "an even number without its power of two", "-2")
    x("number-even-mantissa", "malformed input", "an even number times a power of two", "2*2^-1")
    x("number-long", "malformed input", "4001 digits", BIG)
    x("number-4000", "invalid hash", "4000 digits", BIG[1:])
    x("number-long-denominator", "malformed input", "a denominator of 4001 digits", "1/" + BIG)
    x("number-decimal", "malformed input", "a decimal fraction", "-1.0")
    x("number-plus", "malformed input", "a plus sign", "+1")
    x("number-minus-zero", "malformed input", "a minus zero", "-0")
    x("number-exponent-zero", "malformed input", "an exponent that is zero", "1*2^0")
    x("number-exponent-long", "malformed input", "an exponent of six digits", "1*2^100000")
    x("number-exponent-five", "invalid hash", "an exponent of five digits", "-1*2^-99999")
    x("number-zero-exponent", "malformed input", "a zero with an exponent", "0*2^3")
    x("number-half", "malformed input", "a fraction with a power of two below", "-1/2")
    x("number-whole", "malformed input", "a fraction with one below", "-3/1")
    x("number-third", "invalid hash", "a third", "-1/3")
    x("number-two-thirds", "invalid hash", "two thirds", "-2/3")
    x("number-not-lowest", "malformed input", "a fraction not in lowest terms", "-3/9")
    x("number-zero-third", "malformed input", "a zero as a fraction", "0/3")
    x("number-over-zero", "malformed input", "a zero below", "1/0")
    x("number-minus-below", "malformed input", "a minus below", "1/-3")
    x("number-leading-zero", "malformed input", "a leading zero", "-01")
    x("number-both", "malformed input", "a fraction and an exponent", "1/3*2^1")
    x("number-empty", "malformed input", "two spaces", "")
    x("number-letters", "malformed input", "no number", "one")
    m("magic", "malformed input", "another version of the input", swap("homeo-complex 1", "homeo-complex 2"))
    m("plane-of-tets", "malformed input", "tets in the plane", swap("space 3", "space 2"))
    m("corners-5", "malformed input", "cells of five corners", swap("corners 4", "corners 5"))
    m("corners-3", "malformed input", "lines that have a corner too many", swap("corners 4", "corners 3"))
    m("no-end", "malformed input", "no end line", drop("end"))
    m("no-final-newline", "malformed input", "no LF at the end", lambda t: t[:-1])
    m("after-end", "malformed input", "something after the end", lambda t: t + "\n")
    m("crlf", "malformed input", "lines end in CR LF", lambda t: t.replace("\n", "\r\n"))
    m("vertices-more", "malformed input", "a vertex more than there are", swap("vertices 7", "vertices 8"))
    m("vertices-fewer", "malformed input", "a vertex less than there are", swap("vertices 7", "vertices 6"))
    m("vertices-many", "malformed input", "more vertices than a file can hold", swap("vertices 7", "vertices 9999999999"))
    m("vertices-zero", "malformed input", "no vertex", lambda t: "homeo-complex 1\nspace 3\ncorners 4\nvertices 0\ncells 0\nend\n")
    m("cells-more", "malformed input", "a cell more than there are", swap("cells 8", "cells 9"))
    m("cells-leading-zero", "malformed input", "a count with a leading zero", swap("cells 8", "cells 08"))
    m("index", "malformed input", "an index out of range", swap("4 2 0 6", "4 2 0 7"))
    m("index-minus", "malformed input", "a negative index", swap("4 2 0 6", "4 2 0 -6"))
    m("trailing-space", "malformed input", "a space at the end of a line", swap("4 2 0 6", "4 2 0 6 "))
    m("not-ascii", "malformed input", "a byte that is not ASCII", swap("4 2 0 6", "4 2 0 \xb2"))
    m("four-coordinates", "malformed input", "a point of four coordinates", coordinate, swap("{} 0 0", "1 0 0 0"))


def conditions(corpus):
    """Claims about meshes that do not meet the conditions."""
    points = octahedron().points
    def m(name, what, cells, control="manifold-surface", points=points, answer="invalid mesh-conditions"):
        corpus.mutant(control, name, answer, what, a=Mesh(points, cells))

    m("repeated", "a repeated vertex", [(0, 2, 4), (1, 3, 3)])
    m("twin", "the vertices of an earlier triangle", [(0, 2, 4), (0, 4, 2)])
    m("direction", "a directed edge used twice", [(0, 2, 4), (0, 2, 5)])
    m("three-at-an-edge", "an edge of three triangles", [(0, 2, 4), (2, 0, 5), (1, 2, 0)])
    m("bow", "triangles that are not connected around a vertex", [(0, 2, 4), (0, 3, 5)])
    m("flat", "a triangle of zero area", [(0, 2, 6)], points=[*points, (Q(1, 2), Q(1, 2), 0)])
    m("unused-vertices", "vertices that no triangle has", [(0, 2, 4)], answer="valid")
    flat = ([(-2, -2), (2, -2), (2, 2), (-2, 2), (0, -2)], SQUARE)
    m("flat-cell", "a flat triangle in the plane", flat[1], "manifold-plane", flat[0])
    m("turned", "triangles of both orientations of space, apart", [(0, 1, 2), (3, 5, 4)], "manifold-plane",
      [(0, 0), (1, 0), (0, 1), (4, 4), (5, 4), (4, 5)], "valid")
    tets = [*points, (Q(1, 3), Q(1, 3), 9)]
    m("three-at-a-face", "a face of three tets", [(0, 2, 4, 1), (2, 0, 4, 3), (0, 2, 4, 6)], "manifold-tets", tets)
    m("edge", "tets that are not connected around an edge", [(0, 2, 4, 5), (1, 3, 4, 5)], "manifold-tets", tets)
    m("vertex", "tets that are not connected around a vertex", [(0, 2, 4, 6), (6, 1, 3, 5)], "manifold-tets", tets)
    m("flat-tet", "a tet of zero volume", [(0, 1, 2, 3)], "manifold-tets", tets)
    m("one-tet", "one tet", [(0, 2, 4, 6)], "manifold-tets", tets, "valid")
    m("link", "a vertex whose link is a torus", cone(torus()).cells, "manifold-tets", cone(torus()).points)
    m("ring-of-tets", "a solid torus", solid_torus().cells, "manifold-tets", solid_torus().points, "valid")
    corpus.mutant("manifold-tets", "twin", "invalid mesh-conditions", "two tets glued along all of their faces",
                  a=Mesh(tets, [(0, 2, 4, 6), (2, 0, 4, 6)]))
    corpus.mutant("topology-genus", "bow", "invalid mesh-conditions", "a pinched input", a=Mesh(points, [(0, 2, 4), (0, 3, 5)]))
    corpus.mutant("topology-genus", "flat", "valid", "an input with a flat triangle, on which topology does not depend",
                  a=Mesh([*tetra().points[:3], [sum(x) / 2 for x in zip(*tetra().points[:2])]], tetra().cells))
    corpus.mutant("genus", "open", "invalid not-closed", "an open input", a=Mesh(tetra().points, tetra().cells[:3]))
    corpus.mutant("genus", "pinched-and-open", "invalid mesh-conditions", "an input with a defect, the other one open",
                  a=Mesh(tetra().points, tetra().cells[:3]), b=Mesh(points, [(0, 2, 4), (0, 3, 5)]))
    bow = Mesh(square().points, [(4, 0, 1), (4, 2, 3)])
    corpus.mutant("map-annulus", "bow", "invalid mesh-conditions", "a pinched complex", a=bow, b=bow)
    corpus.mutant("map-uv", "flat", "invalid mesh-conditions", "a surface with a flat triangle", a=Mesh([(*p, 0) for p in square((0, -2)).points], SQUARE))
    # A complex file without cells.
    text = "homeo-complex 1\nspace 3\ncorners 4\nvertices 6\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\ncells 0\nend\n"
    line = f"input a {hashlib.sha256(text.encode()).hexdigest()} 3 4 6 0"
    corpus.mutant("manifold-tets", "no-cell", "invalid mesh-conditions", "no cell", first("^input a .*$", line), a=text)


def planes(corpus):
    m = about(corpus.mutant, "nested-torus")

    sep = "sep 0 1 l:b0,b4"
    m("missing", "invalid missing-separation", "a pair without its line", drop(sep))
    m("missing-last", "invalid missing-separation", "the last pair without its line", first("^sep 22 23 .*\n", ""))
    m("not-separated", "invalid not-separated", "planes that do not separate", swap(sep, "sep 0 1 n:b0,b4"))
    m("plane-missing", "invalid not-separated", "one of two planes is missing", swap("p:b0,b3,b4 n:b0,b3", "p:b0,b3,b4"))
    m("planes-swapped", "invalid not-separated", "two planes in the other order", swap("p:b0,b3,b4 n:b0,b3", "n:b0,b3 p:b0,b3,b4"))
    m("idle-planes", "valid", "planes that leave everything", swap(sep, "sep 0 1 " + "n:b3,b3 p:b1,b1,b2 " * 50 + "l:b0,b4"))
    m("idle-only", "invalid not-separated", "only planes that leave everything", swap(sep, "sep 0 1 n:b3,b3"))
    m("superfluous-boxes", "invalid superfluous", "a pair whose boxes do not meet", after("sep 0 3 p:b0,b3,b4 n:b0,b3", "sep 0 9 n:b0,b3"))
    m("superfluous-plane", "invalid superfluous", "a pair that the plane of a triangle separates", swap("begin b\n", "begin b\nsep 0 1 n:b0,b1\n"), control="nested-tetrahedra")
    m("superfluous-in-a", "invalid superfluous", "a line about a convex surface", swap("begin a\n", "begin a\nsep 2 3 n:a0,a1\n"), control="nested-tetrahedra")
    m("superfluous-between", "invalid superfluous", "a pair of a and b whose boxes do not meet", swap("begin between\n", "begin between\nsep 0 0 n:a0,a1\n"), control="nested-twice")
    m("missing-in-a", "invalid missing-separation", "a pair of a without its line", swap("begin a\nsep 0 1 l:a0,a4\n", "begin a\n"), control="nested-rings")
    m("missing-between", "invalid missing-separation", "a pair of a and b without its line", swap("sep 0 22 l:a0,a3\n", ""), control="nested-rings")
    m("not-separated-between", "invalid not-separated", "planes that do not separate a and b", swap("sep 0 22 l:a0,a3\n", "sep 0 22 n:a0,a3\n"), control="nested-rings")
    m("embedded-missing", "invalid missing-separation", "a pair without its line", first("^sep 0 1 .*\n", ""), control="embedded-torus")
    m("tets-missing", "invalid missing-separation", "a pair of facets without its line", first("^sep 0 10 l:a0,a5\n", ""), control="map-tets-ring")
    m("tets-missing-in-b", "invalid missing-separation", "a pair of facets of b without its line", first("^sep 0 10 l:b0,b5\n", ""), control="map-tets-ring")
    m("inner-facet", "invalid superfluous", "a line about a facet that is not on the boundary", swap("begin a\n", "begin a\nsep 2 4 n:a0,a1\n"), control="map-tets")
    m("surface-missing", "invalid missing-separation", "a pair of triangles without its line", first("^sep 0 1 .*\n", ""), control="map-surfaces")
    m("embedded-crossing-claimed", "invalid missing-separation", "two surfaces that cross", swap("refuted", "certified"),
      swap("begin witness\ncross a 0 4 6 1 1 3 3 2\n", "begin a\n"), control="embedded-crossing")


def line(mesh, vertex, d, other):
    found = [crossed(mesh.points[vertex], d, [other.points[v] for v in cell]) for cell in other.cells]
    assert None not in found
    return " ".join(map(str, [vertex, *d, *(i for i, x in enumerate(found) if x)]))


def rays(corpus):
    m = about(corpus.mutant, "nested-tetrahedra")

    ray = "ray a 3 7 2 4 1"
    m("ray-missing-triangle", "invalid ray", "a triangle that is met is not listed", swap(ray, "ray a 3 7 2 4"))
    m("ray-more-triangles", "invalid ray", "a triangle that is not met is listed", swap(ray, "ray a 3 7 2 4 1 3"))
    m("ray-other-triangle", "invalid ray", "another triangle is listed", swap(ray, "ray a 3 7 2 4 2"))
    m("ray-back", "invalid ray", "the other direction", swap(ray, "ray a 3 -7 -2 -4 1"))
    # From (-1, -1, 1) towards the cage's corner (-15/8, -2, 2).
    m("ray-into-corner", "invalid ray", "a ray into a corner", swap(ray, "ray a 3 -7 -8 8 1"))
    # Corner 0 is (1, 1, 1); the cage's edge 0 1 has the points (17/8, t, t): its middle is (17/8, 0, 0).
    m("ray-into-edge", "invalid ray", "a ray into an edge", swap(ray, "ray a 0 9 -8 -8 0"))
    m("ray-along-face", "valid", "a ray that starts in a face's plane outside of it", swap("ray b 0 7 2 4", "ray b 0 1 0 0"))
    m("ray-from-other-vertex", "valid", "another vertex of the component", swap("ray b 0 7 2 4", "ray b 1 7 -2 -4"))
    m("rays-more", "invalid ray-component", "two rays for one component", after(ray, ray))
    m("rays-swapped", "invalid ray-component", "the rays of two components in another order", control="nested-twice",
      *[swap("ray a 5 7 2 4 9\nray a 6 7 2 4 0", "ray a 6 7 2 4 0\nray a 5 7 2 4 9")])
    m("ray-for-other", "invalid ray-component", "one component twice", swap("ray a 6 7 2 4 0", "ray a 5 7 2 4 9"), control="nested-twice")
    m("ray-component-first", "invalid ray-component", "a bad ray, and a component without one", swap("ray a 5 7 2 4 9", "ray a 5 7 2 4"),
      drop("ray b 7 7 2 4"), control="nested-twice")
    inner, ring = tetra(Q(1, 4)).moved(by=(Q(17, 4), Q(17, 4), 0)), torus()
    long = line(inner, 0, (-9, -10, 1), ring)
    assert len(long.split()) == 7
    m("ray-through-the-ring", "valid", "a ray that leaves, enters and leaves", swap("ray a 0 7 2 4 3", "ray a " + long), control="nested-torus")
    m("ray-through-the-ring-fewer", "invalid ray", "a ray that meets three triangles, two of them listed",
      swap("ray a 0 7 2 4 3", "ray a " + long.rsplit(" ", 1)[0]), control="nested-torus")
    corpus.mutant("nested-tetrahedra", "ray-in-a-plane", "invalid ray", "a ray within the plane of a triangle that it meets",
                  swap(ray, "ray a 0 -1 0 -1"), b=octahedron(4))


def positions(corpus):
    m = about(corpus.mutant, "map-annulus")

    bare = swap("begin witness", "begin a\nbegin b")
    m("inner-folded", "invalid sign", "the inner square turned by half a turn", b=Mesh(annulus(3, -1).points, annulus(3, 1).cells))
    m("certified", "invalid twice", "squares glued crosswise along a slit: positive, with embedded boundary", swap("refuted", "certified"), bare,
      drop("twice b 38 4"), control="map-cross-glued")
    m("certified", "invalid crossing", "a fan that turns more than once", swap("refuted", "certified"), bare, drop("cross b 0 3 0 1 0 1 2 0"), control="map-spiral")
    m("certified", "invalid sign", "a tet turned over", swap("refuted", "certified"), bare, drop("sign b 0 3"), control="map-flipped")
    m("certified", "invalid sign", "a flat triangle", swap("refuted", "certified"), bare, drop("sign b 0 0"), control="map-flat")
    m("certified", "invalid twice", "a tet inside another one", swap("refuted", "certified"), bare, drop("twice b 7 0"), control="map-tets-inside")
    m("certified", "invalid missing-separation", "a folded surface", swap("refuted", "certified"), bare, drop("cross b 0 2 1 0 1 0 1 0"), control="map-folded")
    m("certified", "invalid mesh-conditions", "a pinched complex", swap("refuted", "certified"), bare, drop("vertex a 0 0 1"), control="map-defect")
    m("both-turned", "valid", "an input with all triangles turned over", control="map-one-part-turned",
      b=Mesh([(-x, y) for x, y in (square() + square().moved(by=(9, 0))).points], (square() + square().moved(by=(9, 0))).cells))
    two = square() + square().moved(by=(9, 0))
    m("touching", "invalid crossing", "two squares that share a corner's position", control="map-one-part-turned", b=square() + square().moved(by=(4, 4)))
    m("overlapping", "invalid crossing", "two squares that overlap", control="map-one-part-turned", b=square() + square().moved(by=(3, 1)))
    m("one-inside", "invalid twice", "a square inside another one", control="map-one-part-turned", b=square() + square().moved(Q(1, 3), (Q(1, 7), 0)))
    m("side-by-side", "invalid crossing", "two squares that share a side's position", control="map-one-part-turned", b=square() + square().moved(by=(4, 0)))


def witnesses(corpus):
    def m(control, name, what, old, new, answer="invalid not-refuted", **more):
        corpus.mutant(control, name, answer, what, swap(old, new), **more)

    m("defect-repeated", "other", "a cell that repeats nothing", "repeated a 1", "repeated a 0")
    m("defect-repeated", "flat", "a cell with a repeated vertex is flat", "repeated a 1", "flat a 1", "valid")
    m("defect-twin", "other", "cells with other vertices", "twin a 0 2", "twin a 0 1")
    m("defect-direction", "other", "cells that fit together", "direction a 0 2", "direction a 0 1")
    m("defect-direction", "apart", "cells without a common edge", "direction a 0 2", "direction a 1 2")
    m("defect-facet", "other", "an edge of two of the cells", "facet a 0,2 ", "facet a 2,4 ")
    m("defect-vertex", "other", "a vertex of one of the cells", "vertex a 0 0 1", "vertex a 2 0 1")
    m("defect-vertex", "flat", "a cell that is not flat", "vertex a 0 0 1", "flat a 0")
    m("defect-vertex", "second-line", "a line that holds and one that does not", "vertex a 0 0 1", "vertex a 0 0 1\nflat a 0")
    m("defect-flat", "other", "a cell that is not flat", "flat a 1", "flat a 0")
    m("defect-flat-in-the-plane", "other", "a cell that is not flat", "flat a 1", "flat a 0")
    m("defect-facet-of-tets", "other", "a face of two of the tets", "facet a 0,2,4 ", "facet a 0,1,2 ")
    m("defect-direction-of-tets", "turned", "tets that fit together", "direction a 0 1", "direction a 0 1",
      a=Mesh(octahedron().points, [(0, 2, 4, 1), (2, 0, 4, 3)]))
    m("defect-edge", "vertex", "the tets are not connected around a vertex, either", "edge a 4,5 0 1", "vertex a 4 0 1", "valid")
    m("defect-edge", "other", "an edge of one of the tets", "edge a 4,5 0 1", "edge a 0,4 0 1")
    m("defect-edge", "unused-vertex", "a link without tets", "edge a 4,5 0 1", "link a 6",
      a=Mesh([*octahedron().points, (7, 7, 7)], [(0, 2, 4, 5), (1, 3, 4, 5)]))
    m("defect-link", "disc", "a link that is a disc", "link a 12", "link a 3")
    m("defect-link", "connected", "tets that are connected around the vertex", "link a 12", "vertex a 12 0 5")
    m("embedded-crossing", "other-weights", "points that differ", "6 1 1 3 3 2", "6 1 1 3 2 3", "invalid wrong-point")
    m("embedded-crossing", "scaled-weights", "weights times a number", "6 1 1 3 3 2", "12 2 2 9 9 6", "valid")
    m("embedded-crossing", "common-vertex", "a common vertex", "cross a 0 4 6 1 1 3 3 2", "cross a 0 1 1 0 0 1 0 0")
    m("embedded-crossing", "common-edge", "a point of a common edge", "cross a 0 4 6 1 1 3 3 2", "cross a 0 1 1 2 0 1 0 2")
    m("nested-touching", "other-corner", "a corner that does not touch", "0 0 1 0 0 1 1 1", "0 0 0 1 0 1 1 1", "invalid wrong-point")
    m("nested-touching", "across", "a common vertex of one input", "cross ab 0 0 1 0 0 1 1 1", "cross a 0 1 1 0 0 1 0 0")
    m("nested-open", "closed-edge", "an edge with its reverse", "open b 1 2", "open b 0 1")
    m("nested-open", "no-edge", "a directed edge that no triangle has", "open b 1 2", "open b 2 1")
    m("nested-open", "closed-input", "an edge of the closed input", "open b 1 2", "open a 1 2")
    m("nested-one-of-two", "the-good-one", "the sphere with its cage", "winding a 6 7 2 4", "winding a 0 7 2 4 0")
    m("nested-one-of-two", "listed", "a triangle that is not met", "winding a 6 7 2 4", "winding a 6 7 2 4 0", "invalid ray")
    m("nested-one-of-two", "of-b", "a vertex of b outside of a", "winding a 6 7 2 4", "winding b 0 7 2 4")
    m("nested-one-of-two", "unused-vertex", "a vertex that no triangle has", "winding a 6 7 2 4", "winding a 12 7 2 4", "invalid ray-component",
      a=Mesh([*(octahedron(Q(1, 3)) + octahedron(Q(1, 3)).moved(by=(20, Q(1, 7), 0))).points, (9, 9, 9)],
             (octahedron() + octahedron()).cells))
    m("nested-one-of-two", "flat-cage", "a flat triangle in the other input", "winding a 6 7 2 4", "winding a 6 7 2 4", "invalid mesh-conditions",
      b=Mesh([*octahedron(3).points[:5], (3, 0, 0)], octahedron().cells))
    # An open cage: the number means nothing, but then the pair is not nested.
    m("nested-one-of-two", "open-cage", "an open cage", "winding a 6 7 2 4", "winding a 6 7 2 4", "valid", b=Mesh(octahedron(3).points, octahedron().cells[:6]))
    m("map-cross-glued", "own-cell", "the facet's own cell", "twice b 38 4", "twice b 38 12")
    m("map-cross-glued", "other-cell", "a cell that does not hold the centroid", "twice b 38 4", "twice b 38 7")
    m("map-cross-glued", "of-a", "the same of the other input", "twice b 38 4", "twice a 38 4", "valid")
    m("map-cross-glued", "as-cross", "the same as a crossing", "twice b 38 4", "cross b 4 12 1 1 4 1 1 0", "invalid wrong-point")
    m("map-cross-glued", "sign", "cells of one sign", "twice b 38 4", "sign b 0 9")
    m("map-spiral", "of-a", "the crossing of the other input", "cross b 0 3", "cross a 0 3", "invalid wrong-point")
    m("map-spiral", "hub", "the common vertex", "0 1 0 1 2 0", "1 0 0 1 0 0")
    m("map-spiral", "twice", "the centroid of a boundary facet in another cell", "cross b 0 3 0 1 0 1 2 0", "twice b 2 3", "valid")
    m("map-flipped", "other", "cells of one sign", "sign b 0 3", "sign b 0 0")
    m("map-flipped", "of-a", "cells of the other input", "sign b 0 3", "sign a 0 3")
    m("map-flat", "zero-and-other", "a flat cell and another one", "sign b 0 0", "sign b 0 2", "valid")
    m("map-flat", "flat", "the same as a flat cell", "sign b 0 0", "flat b 0", "valid")
    m("map-flat", "flat-a", "the cell in the other input", "sign b 0 0", "flat a 0")
    m("map-tets-inside", "turned-round", "the outer facet is not inside", "twice b 7 0", "twice b 0 1")
    m("map-tets-inside", "of-a", "the facet of the other input", "twice b 7 0", "twice a 7 0")
    m("map-tets-inside", "cross", "a corner inside", "twice b 7 0", "cross b 0 1 5 5 4 4 9 0 0 0", "invalid wrong-point")
    m("map-folded", "of-a", "the same weights on the other input", "cross b 0 2", "cross a 0 2", "invalid wrong-point")
    m("map-folded", "common-edge", "a common vertex", "cross b 0 2 1 0 1 0 1 0", "cross b 0 2 0 0 1 0 0 1")
    m("map-defect", "of-b", "the same of the other input", "vertex a 0 0 1", "vertex b 0 0 1", "valid")
    corpus.mutant("map-one-part-turned", "refuted", "invalid not-refuted", "cells of opposite sign in different components",
                  swap("certified", "refuted"), swap("begin a\nbegin b", "begin witness\nsign b 0 4"))
