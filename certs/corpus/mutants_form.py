"""Mutants of form: the bytes of the certificate, its grammar, the input files and what binds them."""
from corpus_files import BIG, about
from make_mutants import after, blocks, cut, drop, flip, lines, obj, off, swap


def add_all(corpus):
    bytes_and_lines(corpus)
    claims(corpus)
    head(corpus)
    layout(corpus)
    numbers(corpus)
    facts(corpus)
    witnesses(corpus)
    ranges(corpus)
    inputs(corpus)
    conditions(corpus)


def bytes_and_lines(corpus):
    m = about(corpus.add, "two-components")

    m("empty", "malformed truncated", "an empty file", lambda t: "")
    m("cut-in-a-line", "malformed truncated", "the last 200 bytes are missing", cut(200))
    m("cut-after-a-line", "malformed truncated", "the file stops after the claims", lambda t: t[:t.index("shell ")])
    m("cut-half", "malformed truncated", "the second half is missing", lambda t: t[:len(t) // 2])
    m("no-end", "malformed truncated", "the end line is missing", drop("end"))
    m("no-final-newline", "malformed truncated", "the last byte is not LF", cut(1))
    m("text-after-end", "malformed truncated", "a line after the end line", after("end", "claim i2 certified"))
    m("two-ends", "malformed syntax", "two end lines", after("end", "end"))
    m("end-in-the-middle", "malformed syntax", "an end line before the counts line", lines("begin i2", "begin i2\nend"))
    m("crlf", "malformed bytes", "lines end in CR LF", lambda t: t.replace("\n", "\r\n"))
    m("one-cr", "malformed bytes", "one line ends in CR LF", swap("order id\n", "order id\r\n"))
    m("nul", "malformed bytes", "a NUL byte at the end of a line", swap("order id\n", "order id\0\n"))
    m("tab", "malformed bytes", "a tab in place of a space", swap("order id", "order\tid"))
    m("delete-byte", "malformed bytes", "a byte 0x7f", swap("order id", "order id\x7f"))
    m("not-ascii", "malformed bytes", "a byte above 0x7f", swap("order id", "order \xefd"))
    m("byte-order-mark", "malformed bytes", "a byte order mark first", lambda t: "\xef\xbb\xbf" + t)
    m("bytes-before-truncated", "malformed bytes", "a NUL byte, and no end line: bytes come first",
      swap("order id\n", "order id\0\n"), drop("end"))
    m("truncated-before-magic", "malformed truncated", "no magic and no end line", drop("homeo-certificate 1"), drop("end"))
    m("version-2", "malformed magic", "another version", lines("homeo-certificate 1", "homeo-certificate 2"))
    m("no-magic", "malformed magic", "the first line is missing", drop("homeo-certificate 1"))
    m("empty-first-line", "malformed magic", "an empty line first", lambda t: "\n" + t)
    m("magic-with-space", "malformed magic", "a space after the magic", lines("homeo-certificate 1", "homeo-certificate 1 "))
    m("empty-line", "malformed syntax", "an empty line among the facts", after("c 0 1 2", ""))
    m("double-space", "malformed syntax", "two spaces between tokens", lines("c 0 1 2", "c 0  1 2"))
    m("trailing-space", "malformed syntax", "a space at the end of a line", lines("order id", "order id "))
    m("leading-space", "malformed syntax", "a space before a line", lines("order id", " order id"))
    m("unknown-word", "malformed syntax", "an unknown line", after("order id", "comment none"))
    m("upper-case-word", "malformed syntax", "a word in capitals", lines("order id", "ORDER id"))
    m("comment", "malformed syntax", "a comment line", after("order id", "# comment"))


def claims(corpus):
    """Verdicts turned over one by one, in a certified and in a refuted control; claims that do not fit together."""
    def turn(control, name, answer):
        text = corpus.control(control, "control.cert")
        old = f"claim {name} certified" if f"claim {name} certified" in text else f"claim {name} refuted"
        new = old.replace("certified", "REFUTED").replace("refuted", "certified").replace("REFUTED", "refuted")
        corpus.add(control, f"turn-{name}", answer, f"the verdict of {name} turned over", lines(old, new))

    for name in ["positivity", "section", "bijection", "section-all-orders", "disjoint-bottom", "disjoint-top"]:
        turn("inside", name, "malformed claims")
    turn("inside", "disjoint-mesh", "malformed syntax")
    turn("inside", "i2", "malformed syntax")
    for name in ["section", "bijection", "section-all-orders", "i2"]:
        turn("bad-tet", name, "malformed claims")
    for name in ["positivity", "disjoint-mesh", "disjoint-bottom", "disjoint-top"]:
        turn("bad-tet", name, "malformed syntax")

    m = about(corpus.add, "inside")

    m("turn-both-sections", "malformed claims", "section and bijection refuted, section-all-orders certified",
      swap("section certified\nclaim bijection certified", "section refuted\nclaim bijection refuted"))
    m("turn-all-orders-and-i2", "malformed syntax", "section-all-orders and i2 refuted without a witness",
      swap("all-orders certified", "all-orders refuted"), swap("i2 certified", "i2 refuted"))
    m("no-bijection", "malformed claims", "section without bijection", drop("claim bijection certified"))
    m("no-section-claim", "malformed claims", "bijection without section", drop("claim section certified"))
    m("no-positivity", "malformed claims", "section-all-orders without positivity", drop("claim positivity certified"))
    m("no-disjoint-top", "malformed claims", "i2 without disjoint-top", drop("claim disjoint-top certified"))
    m("claim-without-block", "malformed syntax", "a weakened claim: i2 is not claimed, its block stays",
      drop("claim i2 certified"))
    m("claim-unknown", "malformed syntax", "a claim of another name", lines("claim i2 certified", "claim i3 certified"))
    m("verdict-unknown", "malformed syntax", "a claim that is maybe so", lines("claim i2 certified", "claim i2 maybe"))
    m("claim-twice", "malformed syntax", "a claim stated twice", after("claim i2 certified", "claim i2 certified"))
    m("claims-out-of-order", "malformed syntax", "two claims swapped",
      lines("claim disjoint-bottom certified\nclaim disjoint-top certified", "claim disjoint-top certified\nclaim disjoint-bottom certified"))
    m("no-claims", "malformed syntax", "no claim at all", lambda t: t[:20] + t[t.index("shell "):])
    m("weaker", "valid", "i2 and its block left out: a weaker certificate, valid for what it claims",
      drop("claim i2 certified"), drop("begin i2"), lines("counts 39 0 0 0 0", "counts 39 0 0 0"))


def head(corpus):
    m = about(corpus.add, "inside")

    shell, mesh = "3216060", "0afddd6"
    m("hash-upper-case", "malformed syntax", "capital hex digits", lambda t: t.replace(mesh, mesh.upper(), 1))
    m("hash-short", "malformed syntax", "a hash of 63 digits", swap(f"shell {shell}", f"shell {shell[1:]}"))
    m("hash-of-shell", "invalid hash", "one digit of the shell's hash changed", swap(f"shell {shell}", f"shell 4{shell[1:]}"))
    m("hash-of-mesh", "invalid hash", "one digit of the mesh's hash changed", swap(f"mesh {mesh}", f"mesh 1{mesh[1:]}"))
    m("shell-vertex-count", "invalid hash", "one shell vertex too many", swap("dcbd4f 4 2\n", "dcbd4f 5 2\n"))
    m("shell-giant-counts", "invalid hash", "ten-digit numbers of vertices and prisms",
      swap("dcbd4f 4 2\n", "dcbd4f 9999999999 9999999999\n"))
    m("shell-too-giant-count", "malformed syntax", "a number of eleven digits", swap("dcbd4f 4 2\n", "dcbd4f 99999999999 2\n"))
    m("mesh-triangle-count", "invalid hash", "one mesh triangle too many", swap("1db261 6 6\n", "1db261 6 7\n"))
    m("mesh-vertex-count-small", "malformed range", "one mesh vertex too few", swap("1db261 6 6\n", "1db261 5 6\n"))
    m("shell-vertex-count-small", "malformed range", "one shell vertex too few", swap("dcbd4f 4 2\n", "dcbd4f 3 2\n"))
    m("no-mesh-line", "malformed syntax", "the mesh line is missing", lambda t: "".join(l for l in t.splitlines(True) if not l.startswith("mesh ")))
    m("mesh-line-not-due", "malformed syntax", "a mesh line where only positivity is claimed",
      swap("order id", "mesh " + "0" * 64 + " 1 1\norder id"), control="ball-positivity")
    m("order-unknown", "malformed syntax", "an order that is neither id nor a list", lines("order id", "order random"))
    m("order-empty-list", "malformed syntax", "an empty list", lines("order id", "order list"))
    m("order-of-id-listed", "malformed syntax", "the identity given as a list", lines("order id", "order list 0 1 2 3"))
    listed = "order list 8 7 6 5 4 3 2 1 0"
    p = "patch-order"
    m("order-identity", "malformed syntax", "the list is the identity", lines(listed, "order list 0 1 2 3 4 5 6 7 8"), control=p)
    m("order-short", "malformed syntax", "a vertex is missing in the list", lines(listed, "order list 8 7 6 5 4 3 2 1"), control=p)
    m("order-twice", "malformed syntax", "a vertex stands twice in the list", lines(listed, "order list 8 7 6 5 4 3 2 1 1"), control=p)
    m("order-range", "malformed range", "an id that is no vertex", lines(listed, "order list 9 7 6 5 4 3 2 1 0"), control=p)
    m("order-other", "invalid shell-carrier", "another order than the overlay's", lines(listed, "order id"), control=p)
    m("order-other-list", "invalid shell-carrier", "0 and 3 in the other order",
      lines(listed, "order list 8 7 6 5 4 0 2 1 3"), control=p)
    pin = "pinched 48 0"
    for name, line, answer, what in [
            ("pinched-none", "pinched 0", "invalid pinched", "the pinched vertex kept secret"),
            ("pinched-count", "pinched 40 0", "invalid pinched", "another number of vanishing tets"),
            ("pinched-other", "pinched 48 1", "invalid pinched", "another vertex called pinched"),
            ("pinched-more", "pinched 48 0 1", "invalid pinched", "one more vertex called pinched"),
            ("pinched-twice", "pinched 48 0 0", "malformed syntax", "the pinched vertex listed twice"),
            ("pinched-no-count", "pinched", "malformed syntax", "no number of vanishing tets"),
            ("pinched-range", "pinched 48 7", "malformed range", "a pinched vertex that does not exist")]:
        m(name, answer, what, lines(pin, line), control="pinched")
    m("pinched-lie", "invalid pinched", "a false omission: a vertex is called pinched that is not", lines("pinched 0", "pinched 16 0"))


def layout(corpus):
    m = about(corpus.add, "two-components")

    m("block-order", "malformed syntax", "two blocks swapped",
      lines("begin disjoint-bottom\nbegin disjoint-top", "begin disjoint-top\nbegin disjoint-bottom"))
    m("block-missing", "malformed syntax", "a block is missing", drop("begin disjoint-bottom"))
    m("block-twice", "malformed syntax", "a block stands twice", after("begin disjoint-bottom", "begin disjoint-bottom"))
    m("block-not-due", "malformed syntax", "a block of a claim that needs none", lines("begin overlay", "begin positivity\nbegin overlay"))
    m("block-unknown", "malformed syntax", "a block of another name", lines("begin i2", "begin i3"))
    m("block-i2-not-due", "malformed syntax", "an i2 block though section-all-orders is refuted",
      swap("counts 4 1 0 0", "begin i2\ncounts 4 1 0 0 0"), control="boundary")
    m("fact-in-other-block", "malformed syntax", "a sep line in the overlay block",
      drop("sep 0 1 l:g0,g2"), after("d middle 6 0", "sep 0 1 l:g0,g2"))
    m("no-counts", "malformed syntax", "the counts line is missing", drop("counts 34 2 0 0 0"))
    for name, line, answer, what in [
            ("counts-low", "counts 33 2 0 0 0", "malformed counts", "one fact fewer than there are"),
            ("counts-few", "counts 34 2 0 0", "malformed counts", "one block fewer than there are"),
            ("counts-more", "counts 34 2 0 0 0 0", "malformed counts", "one block more than there are"),
            ("counts-giant", "counts 9999999999 2 0 0 0", "malformed counts", "ten-digit number of facts"),
            ("counts-too-giant", "counts 99999999999 2 0 0 0", "malformed syntax", "eleven-digit number of facts"),
            ("counts-2-40", "counts 1099511627776 2 0 0 0", "malformed syntax", "2^40 facts"),
            ("counts-leading-zero", "counts 034 2 0 0 0", "malformed syntax", "a leading zero"),
            ("counts-negative", "counts -34 2 0 0 0", "malformed syntax", "a negative number of facts")]:
        m(name, answer, what, lines("counts 34 2 0 0 0", line))


def numbers(corpus):
    m = corpus.add

    cross = "cross 0 0 2 3 2 2 3 2"
    m("cap", "weight-giant", "limit digits", "a weight of 4001 digits", lines(cross, f"cross 0 0 {BIG} 3 2 2 3 2"))
    m("cap", "weight-giant-out-of-range", "limit digits", "4001 digits, and no such triangle: digits come first",
      lines(cross, f"cross 9 0 {BIG} 3 2 2 3 2"))
    m("cap", "weight-giant-bad-line", "malformed syntax", "4001 digits, and a weight missing: syntax comes first",
      lines(cross, f"cross 0 0 {BIG} 3 2 2 3"))
    m("cap", "weight-long", "valid", "the same point with weights of 4000 digits",
      lines(cross, "cross 0 0 " + " ".join(w + "0" * 3999 for w in "232") + " 2 3 2"))
    m("cap", "weight-negative", "malformed syntax", "a negative weight", lines(cross, "cross 0 0 -2 3 2 2 3 2"))
    m("cap", "weight-plus", "malformed syntax", "a weight with a sign", lines(cross, "cross 0 0 +2 3 2 2 3 2"))
    m("cap", "weight-leading-zero", "malformed syntax", "a weight with a leading zero", lines(cross, "cross 0 0 02 3 2 2 3 2"))
    m("cap", "weights-zero", "malformed syntax", "all weights of a triangle zero", lines(cross, "cross 0 0 2 3 2 0 0 0"))
    m("cap", "id-leading-zero", "malformed syntax", "an id with a leading zero", lines(cross, "cross 00 0 2 3 2 2 3 2"))
    value = "tet 0 m0,m1,t1,m2 -1*2^3"
    for name, to, answer, what in [
            ("value-even", "-2*2^2", "malformed syntax", "an even mantissa"),
            ("value-exponent-zero", "-1*2^0", "malformed syntax", "an exponent of zero"),
            ("value-exponent-zeros", "-1*2^03", "malformed syntax", "a leading zero in the exponent"),
            ("value-exponent-plus", "-1*2^+3", "malformed syntax", "a plus in the exponent"),
            ("value-exponent-long", "-1*2^100000", "malformed syntax", "an exponent of six digits"),
            ("value-minus-zero", "-0", "malformed syntax", "minus zero"),
            ("value-decimal", "-8.0", "malformed syntax", "a decimal fraction"),
            ("value-giant", f"-{BIG}", "limit digits", "a value of 4001 digits"),
            ("value-giant-exponent", "-1*2^99999", "invalid wrong-value", "the largest exponent"),
            ("value-small-exponent", "-1*2^-99999", "invalid wrong-value", "the smallest exponent")]:
        m("bad-tet", name, answer, what, lines(value, f"tet 0 m0,m1,t1,m2 {to}"))


def facts(corpus):
    m = about(corpus.add, "two-components")

    v, c, sep = "v 1,2 m1,t2", "c 0 1 2", "sep 0 1 l:g0,g2"
    m("names-unsorted", "malformed syntax", "names not ascending", lines(v, "v 1,2 t2,m1"))
    m("names-double", "malformed syntax", "a name twice", lines(v, "v 1,2 m1,m1"))
    m("names-leading-zero", "malformed syntax", "a name with a leading zero", lines(v, "v 1,2 m01,t2"))
    m("names-layer", "malformed syntax", "a layer that is none of b, m, t", lines(v, "v 1,2 m1,x2"))
    m("names-comma", "malformed syntax", "a comma too many", lines(v, "v 1,2 m1,t2,"))
    m("mesh-ids-unsorted", "malformed syntax", "mesh ids not ascending", lines(v, "v 2,1 m1,t2"))
    m("mesh-ids-double", "malformed syntax", "a mesh id twice", lines(v, "v 1,1 m1,t2"))
    m("mesh-ids-four", "malformed syntax", "four mesh ids", lines(v, "v 0,1,2,3 m1,t2"))
    m("v-twice", "malformed duplicate", "a v line again", after("v 4 m4,t4", v))
    m("v-after-c", "malformed syntax", "a v line after a c line", after(c, "v 2,3 m2"))
    m("cell-of-two", "malformed syntax", "a cell with two corners", lines(c, "c 0 1"))
    m("cell-repeats", "malformed syntax", "a cell that names a vertex twice", lines("c 2 1 3 4", "c 2 1 3 1"))
    m("no-d-mesh", "malformed syntax", "no d mesh line", drop("d mesh 0 0\nd mesh 6 0"))
    m("no-d-middle", "malformed syntax", "no d middle line", drop("d middle 0 0\nd middle 6 0"))
    m("d-order", "malformed syntax", "a d mesh line after a d middle line",
      lines("d mesh 6 0\nd middle 0 0", "d middle 0 0\nd mesh 6 0"))
    m("sep-no-plane", "malformed syntax", "a sep line without a plane", lines(sep, "sep 0 1"))
    m("sep-turned", "malformed syntax", "a sep line with i > j", lines(sep, "sep 1 0 l:g0,g2"))
    m("sep-same", "malformed syntax", "a sep line with i = j", lines(sep, "sep 1 1 l:g0,g2"))
    m("sep-twice", "malformed syntax", "a sep line twice", after(sep, sep))
    m("sep-order", "malformed syntax", "sep lines not ascending", lines(f"{sep}\nsep 2 3 l:g4,g6", f"sep 2 3 l:g4,g6\n{sep}"))
    m("plane-kind", "malformed syntax", "a plane of unknown kind", lines(sep, "sep 0 1 q:g0,g2"))
    m("plane-points", "malformed syntax", "a plane through two points", lines(sep, "sep 0 1 p:g0,g2"))
    m("plane-point", "malformed syntax", "a point that is no name", lines(sep, "sep 0 1 l:g0,x2"))
    m("cross-without-lines", "malformed syntax", "disjoint-top refuted without a cross line",
      drop("cross 0 0 2 3 2 2 3 2"), control="cap")
    m("tet-of-three", "malformed syntax", "a tet of three names", lines("tet 0 t0,m1,t1,m2 0", "tet 0 t0,m1,t1 0"), control="bad-tet-unused")
    m("tet-of-five", "malformed syntax", "a tet of five names", lines("tet 0 t0,m1,t1,m2 0", "tet 0 t0,m1,t1,m2,t2 0"), control="bad-tet-unused")
    m("tet-swapped", "malformed syntax", "two names of a tet swapped", lines("tet 0 t0,m1,t1,m2 0", "tet 0 m1,t0,t1,m2 0"), control="bad-tet-unused")


def witnesses(corpus):
    m = corpus.add

    m("boundary", "no-leg", "malformed syntax", "a branch without a leg", drop("start m0,m1,m2,t2"))
    m("boundary", "no-reason", "malformed syntax", "a branch without a reason", drop("boundary"))
    m("boundary", "reason-unknown", "malformed syntax", "an unknown reason", lines("boundary", "edge"))
    m("boundary", "reason-of-two-legs", "malformed syntax", "twice after one leg", lines("boundary", "twice"))
    m("boundary", "reason-with-text", "malformed syntax", "a word after the reason", lines("boundary", "boundary 0"))
    m("boundary", "root-without-weights", "malformed syntax", "a root whose weights are all zero", lines("root 0 0 1 1", "root 0 0 0 0"))
    m("boundary", "step-before-start", "malformed syntax", "a step before the start",
      lines("start m0,m1,m2,t2", "step 0 0 1 1 m0,m1,m2,t2\nstart m0,m1,m2,t2"))
    m("boundary", "step-without-weights", "malformed syntax", "a step whose weights are all zero",
      after("start m0,m1,m2,t2", "step 0 0 0 0 m0,m1,m2,t2"))
    m("boundary", "no-root", "malformed syntax", "no witness in the block", blocks(no_section=""))
    m("boundary", "three-legs", "malformed syntax", "three legs",
      lines("start m0,m1,m2,t2\nboundary", "start m0,m1,m2,t2\n" * 3 + "twice"))
    m("boundary", "branches-unsorted", "malformed syntax", "branches not ascending",
      after("boundary", "branch m0,m1\nstart m0,m1,m2,t2\nboundary"))
    m("boundary", "branch-twice", "malformed syntax", "a branch twice",
      after("boundary", "branch m0,m1,m2,t2\nstart m0,m1,m2,t2\nboundary"))
    m("twice", "reason-of-one-leg", "malformed syntax", "cap after two legs", lines("twice", "cap"))
    m("closed-tet", "no-first", "malformed syntax", "the first line is missing", drop("first 1 2 0"))
    m("closed-tet", "first-empty", "malformed syntax", "a first line without ids", lines("first 1 2 0", "first"))
    m("closed-tet", "first-repeats", "malformed syntax", "an id twice in the first line", lines("first 1 2 0", "first 1 2 1"))
    m("euler", "euler-minus-zero", "malformed syntax", "minus zero", lines("topology euler 0 1", "topology euler -0 1"))
    m("euler", "topology-unknown", "malformed syntax", "an unknown topology word", lines("topology euler 0 1", "topology genus 0 1"))
    m("components", "components-negative", "malformed syntax", "a negative number of components",
      lines("topology components 2 1", "topology components -2 1"))
    m("components", "two-witnesses", "malformed syntax", "a second witness in the block",
      after("topology components 2 1", "topology euler 2 1"))


def ranges(corpus):
    def m(control, name, what, *edits):
        corpus.add(control, name, "malformed range", what, *edits)

    t = "two-components"
    m(t, "range-v-mesh", "a v line names no mesh vertex", lines("v 1,2 m1,t2", "v 1,8 m1,t2"))
    m(t, "range-v-shell", "a v line names no shell vertex", lines("v 1,2 m1,t2", "v 1,2 m1,t8"))
    m(t, "range-c", "a c line names no v line", lines("c 0 1 2", "c 0 1 18"))
    m(t, "range-d-cell", "a d line names no cell", lines("d mesh 6 0", "d mesh 12 0"))
    m(t, "range-d-fan", "a d line names no fan triangle", lines("d mesh 6 0", "d mesh 6 1"))
    m(t, "range-sep", "a sep line names no triangle", lines("sep 2 3 l:g4,g6", "sep 2 4 l:g4,g6"))
    m(t, "range-plane-mesh", "a plane through no mesh vertex", lines("sep 2 3 l:g4,g6", "sep 2 3 l:g4,g8"))
    m(t, "range-plane-shell", "a plane through no shell vertex", lines("sep 2 3 l:g4,g6", "sep 2 3 l:g4,m8"))
    m("bad-tet", "range-prism", "a tet of no prism", lines("tet 0 m0,m1,t1,m2 -1*2^3", "tet 2 m0,m1,t1,m2 -1*2^3"))
    m("bad-tet", "range-tet-name", "a tet with no shell vertex", lines("tet 0 m0,m1,t1,m2 -1*2^3", "tet 0 m0,m1,t1,m4 -1*2^3"))
    m("bad-tet", "range-cross-triangle", "a cross line with no triangle", lines("cross 0 0 1 4 1 1 4 1", "cross 2 0 1 4 1 1 4 1"))
    m("bad-tet", "range-cross-prism", "a cross line with no prism", lines("cross 0 0 1 4 1 1 4 1", "cross 0 2 1 4 1 1 4 1"))
    m("boundary", "range-root", "a root on no triangle", lines("root 0 0 1 1", "root 2 0 1 1"))
    m("boundary", "range-branch", "a branch with no shell vertex", lines("branch m0,m1,m2,t2", "branch m0,m1,m2,t4"))
    m("boundary", "range-start", "a start tet with no shell vertex", lines("start m0,m1,m2,t2", "start m0,m1,m2,t4"))
    m("boundary", "range-step", "a step on no triangle", after("start m0,m1,m2,t2", "step 2 0 1 1 m0,m1,m2,t2"))
    m("closed-tet", "range-first", "a first line with no shell vertex", lines("first 1 2 0", "first 1 2 4"))
    m("tetrahedron", "range-contact", "a contact of no triangle",
      lines("contact 0 1 b0,m1,b3,m3 0 1 0 0 1 0 0 -3*2^1", "contact 4 1 b0,m1,b3,m3 0 1 0 0 1 0 0 -3*2^1"))


def inputs(corpus):
    m = about(corpus.add, "inside", bound=False)

    for part in ("bottom", "middle", "top", "mesh"):
        m(f"bit-in-{part}", "invalid hash", f"the lowest bit of a coordinate of {part}.off flipped", files={part: flip(1)})
    m("minus-zero", "invalid hash", "0.0 written as -0.0", files={"mesh": swap("0.0 0.0 0.25", "0.0 -0.0 0.25")})
    m("corners-turned", "invalid hash", "the corners of a triangle in another order", files={"mesh": lines("3 0 1 4", "3 1 4 0")})
    m("triangles-swapped", "invalid hash", "two triangles swapped",
      files={"mesh": lines("3 0 1 4\n3 1 2 4", "3 1 2 4\n3 0 1 4")})
    m("top-for-bottom", "invalid hash", "bottom and top exchanged", inputs=["top", "middle", "bottom", "mesh"])
    m("other-mesh-certificate", "invalid hash", "the certificate of another mesh in the same shell",
      lambda t: corpus.control("wall", "control.cert"))
    m("other-shell-certificate", "invalid hash", "the certificate of another shell",
      lambda t: corpus.control("two-components", "control.cert"))
    m("no-inputs", "malformed input", "no input file", inputs=[])
    m("one-input", "malformed input", "one input that is no HDF5 file", inputs=["middle"])
    m("two-inputs", "malformed input", "two inputs, the first no HDF5 file", inputs=["middle", "mesh"])
    m("three-inputs", "malformed input", "no mesh though one is needed", inputs=["bottom", "middle", "top"])
    m("five-inputs", "malformed input", "five inputs", inputs=["bottom", "middle", "top", "mesh", "mesh"])
    m("positivity-alone", "valid", "positivity needs no mesh", inputs=["bottom", "middle", "top"], control="ball-positivity")
    m("mesh-not-asked-for", "malformed input", "a mesh that is given is read, asked for or not",
      files={"mesh": lambda t: "OFF\n"}, control="ball-positivity")
    for name, what, edit in [
            ("empty-input", "an empty file", lambda t: ""),
            ("cut-input", "the last face is cut", cut(3)),
            ("input-not-a-number", "a coordinate nan", swap("2.0 1.0 0.5", "nan 1.0 0.5")),
            ("input-infinite", "a coordinate beyond the largest double", swap("2.0 1.0 0.5", "1e309 1.0 0.5")),
            ("input-hexadecimal", "a coordinate in base 16", swap("2.0 1.0 0.5", "0x2 1.0 0.5")),
            ("input-index", "an index out of range", lines("3 0 1 4", "3 0 1 6")),
            ("input-quad", "a face with four corners", lines("3 0 1 4", "4 0 1 4 2")),
            ("input-giant", "2^40 vertices", lines("6 6 0", "1099511627776 6 0")),
            ("input-giant-faces", "almost 10^10 faces", lines("6 6 0", "6 9999999999 0")),
            ("input-binary", "a NUL byte in a number", swap("2.0 1.0 0.5", "2.0\0 1.0 0.5")),
            ("input-magic", "a word that only begins with OFF", lines("OFF", "OFFSET"))]:
        m(name, "malformed input", what, files={"mesh": edit})
    m("faces-differ", "malformed input", "the bottom has other triangles than the middle",
      files={"bottom": lines("3 0 2 3", "3 0 3 2")})
    m("vertices-differ", "malformed input", "the top has a vertex more",
      files={"top": off("0 0 1/4 0 1/4 4 1/0 4 1/9 9 9", "0 1 2/0 2 3")})
    m("mesh-as-obj", "valid", "the mesh as OBJ", files={"mesh": obj})
    m("other-spelling", "valid", "other spellings of the same doubles, comments, CR LF",
      files={"mesh": lambda t: t.replace("4.0", "+.4E+1").replace("OFF\n", "# x\nOFF # y\n").replace("\n", "\r\n")})


def conditions(corpus):
    m = corpus.add

    def layers(edit):
        return {"bottom": edit, "middle": edit, "top": edit}

    s, q = "invalid shell-conditions", "invalid mesh-conditions"
    i = "inside"
    m(i, "no-prism", s, "a shell without prisms", files=layers(lambda t: t.replace("4 2 0", "4 0 0")[:t.index("3 0 1 2")]))
    m(i, "prism-corner-twice", s, "a prism with a repeated vertex", files=layers(lines("3 0 2 3", "3 0 2 2")))
    m(i, "prisms-same-direction", s, "two prisms glued in the same direction", files=layers(lines("3 0 2 3", "3 0 3 2")))
    m(i, "prisms-back-to-back", s, "two prisms on the same three vertices", files=layers(lines("3 0 2 3", "3 0 2 1")))
    m("two-components", "three-prisms-on-an-edge", s, "three prisms on an edge", files=layers(lines("3 4 5 6", "3 0 2 6")))
    m("two-components", "shell-bow-tie", s, "two fans of prisms that share one vertex",
      files=layers(lambda t: lines("3 4 5 6\n3 4 6 7", "3 0 5 6\n3 0 6 7")(t)))
    ground = off("0 0 0/4 0 0/4 4 0/0 4 0", "0 1 2/0 2 3")
    m(i, "prism-pinched-flat", s, "a prism with three pinched corners",
      files={"bottom": off("0 0 0/4 0 0/4 4 0/0 4 -1", "0 1 2/0 2 3"), "top": ground})
    m(i, "glued-in-same-direction", q, "an edge of the mesh used twice in the same direction", files={"mesh": lines("3 3 0 5", "3 0 3 5")})
    m(i, "mesh-corner-twice", q, "a mesh triangle with a repeated vertex", files={"mesh": lines("3 3 0 5", "3 3 0 0")})
    m(i, "no-triangle", q, "a mesh without triangles", files={"mesh": lambda t: t.replace("6 6 0", "6 0 0")[:t.index("3 0 1 4")]})
    m(i, "triangle-of-zero-area", q, "a mesh triangle of area exactly 0", files={"mesh": swap("2.0 1.0 0.5", "2.0 0.0 0.25")})
    m("two-components", "mesh-bow-tie", q, "two fans of triangles that share one vertex",
      files={"mesh": lambda t: lines("3 4 5 6\n3 4 6 7", "3 0 5 6\n3 0 6 7")(t)})
    m("two-components", "three-triangles-on-an-edge", q, "three triangles on an edge", files={"mesh": lines("3 4 5 6", "3 0 2 6")})
    m(i, "shell-before-mesh", s, "faulty shell and faulty mesh: the shell comes first",
      files={**layers(lines("3 0 2 3", "3 0 3 2")), "mesh": lines("3 3 0 5", "3 0 3 5")})
    m("pinched", "conditions-before-pinched", q, "a faulty mesh and a lying pinched line: the mesh comes first",
      lines("pinched 48 0", "pinched 0"), files={"mesh": lines("3 0 1 2", "3 0 2 1")})
