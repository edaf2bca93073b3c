"""Tests of the Python checker on shells written by hand: python3 -m unittest discover -s reference

Every rejected case is one named change of a certificate that is accepted (its control).
"""
import hashlib
import itertools
import os
import random
import struct
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import check  # noqa: E402
import inputs  # noqa: E402

M4 = [(4, 4, 4), (4, -4, -4), (-4, 4, -4), (-4, -4, 4)]
F4 = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
TETRA = ([[tuple(s * x for x in p) for p in M4] for s in (0.75, 1, 1.25)], [f[::-1] for f in F4])
M3 = [(0, 0, 0), (4, 0, 0), (0, 4, 0)]
PRISM = ([[(x, y, z) for x, y, _ in M3] for z in (-1, 0, 1)], [(0, 1, 2)])
M2 = M3 + [(4, 4, 0)]
TWO = ([[(x, y, z) for x, y, _ in M2] for z in (-1, 0, 1)], [(0, 1, 2), (1, 3, 2)])
ALL = "positivity section bijection section-all-orders disjoint-mesh disjoint-bottom disjoint-top i2".split()
IDENTITY = "v 0 m0\nv 1 m1\nv 2 m2\nc 0 1 2\nd mesh 0 0\nd middle 0 0"


def sha(layers, faces):
    data = b"".join(struct.pack("<3d", *p) for layer in layers for p in layer)
    return hashlib.sha256(data + b"".join(struct.pack("<3I", *f) for f in faces)).hexdigest()


def off(points, faces):
    rows = [" ".join(repr(float(x)) for x in p) for p in points] + [" ".join(map(str, (3,) + f)) for f in faces]
    return f"OFF # made by a test\n{len(points)} {len(faces)} 0\n" + "\n".join(rows) + "\n"


def certificate(shell, mesh, claims, blocks, order="order id"):
    """`claims`: names, `-name` for refuted; `blocks`: (name, text of fact lines)."""
    (layers, prisms), lines = shell, ["homeo-certificate 1"]
    lines += [f"claim {c.lstrip('-')} {'refuted' if c[0] == '-' else 'certified'}" for c in claims]
    lines.append(f"shell {sha(layers, prisms)} {len(layers[0])} {len(prisms)}")
    if mesh:
        lines.append(f"mesh {sha([mesh[0]], mesh[1])} {len(mesh[0])} {len(mesh[1])}")
    pins = [v for v, (b, m, t) in enumerate(zip(*layers)) if b == m == t]
    lines += [order, " ".join(map(str, ["pinched", 8 * sum(v in pins for f in prisms for v in f)] + pins))]
    facts = [text.split("\n") if text else [] for _, text in blocks]
    for (name, _), block in zip(blocks, facts):
        lines += ["begin " + name] + block
    return "\n".join(lines + [" ".join(["counts"] + [str(len(b)) for b in facts]), "end"]) + "\n"


def both(*parts):
    return [f"-{c}" if c in parts else c for c in ALL]


class Checks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, name, data):
        path = os.path.join(self.folder.name, name)
        with open(path, "wb") as file:
            file.write(data if isinstance(data, bytes) else data.encode())
        return path

    def answer(self, text, shell=PRISM, mesh=None):
        files = [self.write("cert", text)]
        files += [self.write(f"s{k}.off", off(layer, shell[1])) for k, layer in enumerate(shell[0])]
        files += [self.write("mesh.off", off(*mesh))] if mesh else []
        status, text = check.run(files)
        first = text.split("\n")[0].split(" : ")[0]
        self.assertEqual(status, {"valid": 0, "invalid": 1, "malformed": 2, "limit": 3}[first.split(" ")[0]])
        return first

    def reject(self, code, control, old, new, shell=PRISM, mesh=None):
        with self.subTest(code=code, old=old, new=new):
            self.assertEqual(self.answer(control, shell, mesh), "valid")
            self.assertIn(old, control)
            self.assertEqual(self.answer(control.replace(old, new, 1), shell, mesh), code)

    def rejected(self, code, shell, mesh, claims, blocks):
        with self.subTest(code=code, blocks=blocks):
            self.assertEqual(self.answer(certificate(shell, mesh, claims, blocks), shell, mesh), code)

    # ---- files
    def test_file_form(self):
        good = certificate(PRISM, None, ["positivity"], [])
        for code, old, new in [
                ("bytes", "claim", "clai\xe9"), ("bytes", "\n", "\r\n"), ("bytes", "order", "ord\0er"),
                ("truncated", "\nend\n", "\n"), ("truncated", "\nend\n", "\nend"), ("magic", "certificate 1", "certificate 2"),
                ("syntax", "order id", "order  id"), ("syntax", "order id", "order id "), ("syntax", "pinched 0", "pinched 00"),
                ("syntax", "pinched 0", "pinched 1_0"), ("syntax", "counts\nend", "end\nend"), ("counts", "counts", "counts 0"),
                ("syntax", "claim positivity certified\n", ""), ("syntax", "order id", "order list 0 1 2"),
                ("range", "order id", "order list 0 1 3"), ("range", "pinched 0", "pinched 0 3"),
                ("syntax", "pinched 0", "pinched 0 2 1"), ("syntax", "order id", "order list 0 2 1 1"),
                ("syntax", "counts", "begin overlay\ncounts"), ("syntax", "end", "end\nend"),
                ("claims", "claim positivity certified", "claim positivity certified\nclaim section certified"),
                ("claims", "certified", "certified\nclaim i2 refuted")]:
            self.reject("malformed " + code, good, old, new)
        self.assertEqual(self.answer(good.replace("order id", "order list 2 0 1")), "valid")
        self.reject("invalid hash", good, "shell " + good.split("shell ")[1][0], "shell " + "f0"[good.split("shell ")[1][0] == "f"])
        self.reject("invalid pinched", good, "pinched 0", "pinched 8 1")
        for n, code in ((4000, "invalid unknown-tet"), (4001, "limit digits")):
            value = certificate(PRISM, None, ["-positivity"], [("positivity", "tet 0 b0,b1,b2,t2 " + "1" * n)])
            self.assertEqual(self.answer(value), code)

    def test_hostile_files(self):
        good = self.write("good", certificate(PRISM, None, ["positivity"], []))
        layers = [self.write(f"s{k}.off", off(layer, PRISM[1])) for k, layer in enumerate(PRISM[0])]
        first = lambda *files: check.run(list(files))[1].split("\n")[0].split(" : ")[0]
        self.assertEqual(first(good, *layers), "valid")
        self.assertEqual(first(), "malformed usage")
        for name in (self.folder.name, os.path.join(self.folder.name, "nothing")):
            self.assertEqual(first(name, *layers), "malformed usage")
            self.assertEqual(first(good, name, *layers[1:]), "malformed input")
        for count in (0, 5):
            self.assertEqual(first(good, *(layers * 2)[:count]), "malformed input")
        text = off(PRISM[0][0], PRISM[1])
        for bad in ("", "OFF", "OFF 1099511627776 1 0\n0 0 0\n", "OFF 3 1099511627776 0\n", b"\xff" * 1000, b"1" * 10**7,
                    b"OFF " + b"9" * 10**6, text.replace("3 1 0", "03 1 0"), text.replace("3 1 0", "3 01 0"), text.replace("4.0", "nan"), text.replace("4.0", "1e999"),
                    text.replace("4.0", "4_0"), text.replace("3 0 1 2", "3 0 1 3"), text.replace("3 0 1 2", "4 0 1 2 3"),
                    "v 0 0 0\nf 1 2 3\n", "v 0 0\n", "v 0 0 0\nf 0 1 1\n", "v 1e0 inf 0\n", "v 0x1 0 0\n"):
            self.assertEqual(first(good, self.write("bad", bad), *layers[1:]), "malformed input", bad[:40])
        obj = "# x\nvn 1 2\n" + "".join("v %r %r %r 9\n" % p for p in PRISM[0][0]) + "f 1/7 2//3 3\n"
        self.assertEqual(first(good, self.write("o.obj", obj), *layers[1:]), "valid")
        for data in ("", b"\n" * 10**6, b"x" * 10**7 + b"\nend\n", bytes(range(256))):
            self.assertIn(first(self.write("hostile", data), *layers), ("malformed truncated", "malformed magic", "malformed bytes"))

    def test_hdf5(self):
        """A file made here by the layout of FORMAT section 6, then truncated everywhere and with each byte changed."""
        data, points = hdf5(PRISM), PRISM[0]
        good = self.write("good", certificate(PRISM, (PRISM[0][1], PRISM[1]), ["disjoint-mesh"], [("disjoint-mesh", "")]))
        self.assertEqual(check.run([good, self.write("s.h5", data)])[1].split("\n")[0], "valid", points)
        # Names may overlap as long as they are no longer than the heap together: 64 bytes, 29 of them for the datasets.
        extra = [25, 26, 27, 28, 41, 42, 43, 44, 49, 52]
        for n, status in ((9, 0), (10, 0), (11, 2)):
            self.assertEqual(check.run([good, self.write("n.h5", hdf5(PRISM, [*extra, 50][:n]))])[0], status, n)
        at = data.index(b"\x11\x20\x3f\0\x08")  # a double of another version, mantissa or sign bit is no IEEE double
        for i, value in enumerate((0x31, 0x10, 62, 1)):
            changed = data[:at + i] + bytes([value]) + data[at + i + 1:]
            self.assertEqual(check.run([good, self.write("i.h5", changed)])[0], 2, i)
        for n in range(len(data)):
            status, _ = check.run([good, self.write("t.h5", data[:n])])
            self.assertEqual(status, 2)
        for at in range(len(data)):
            for value in (255, data[at] ^ 1):
                status, text = check.run([good, self.write("t.h5", data[:at] + bytes([value]) + data[at + 1:])])
                self.assertTrue(status == 0 or text.startswith(("malformed input", "invalid hash")), (at, value, text))

    def test_command_line(self):
        done = subprocess.run([sys.executable, os.path.join(HERE, "check.py")], capture_output=True)
        self.assertEqual((done.returncode, done.stdout.split(b" : ")[0]), (2, b"malformed usage"))

    # ---- conditions
    def test_conditions(self):
        layers = [[(x, y, z + k) for x, y, z in M2 + [(9, 9, 9), (9, 8, 9)]] for k in (-1, 0, 1)]
        for faces in ([], [(0, 1, 1)], [(0, 1, 2), (0, 1, 3)], [(0, 1, 2), (0, 2, 1)], [(0, 1, 2), (0, 3, 4)]):
            self.rejected("invalid shell-conditions", (layers, faces), None, ["positivity"], [])
            mesh = ([(float(i), i * i, i ** 3) for i in range(6)], faces)
            self.rejected("invalid mesh-conditions", PRISM, mesh, ["disjoint-mesh"], [("disjoint-mesh", "")])
        self.rejected("valid", (layers, [(0, 1, 2), (1, 3, 2)]), None, ["positivity"], [])
        self.rejected("invalid mesh-conditions", PRISM, ([(i, i, i) for i in range(3)], [(0, 1, 2)]),
                      ["disjoint-mesh"], [("disjoint-mesh", "")])
        self.rejected("invalid shell-conditions", ([M3] * 3, PRISM[1]), None, ["positivity"], [])

    # ---- positivity
    def test_positivity(self):
        upside = (PRISM[0][::-1], PRISM[1])
        self.rejected("invalid not-positive", upside, None, ["positivity"], [])
        bad = certificate(upside, None, ["-positivity"], [("positivity", "tet 0 b0,b1,b2,m2 -1*2^4")])
        self.reject("invalid wrong-value", bad, "-1*2^4", "-1*2^5", upside)
        self.reject("invalid unknown-tet", bad, "b0,b1,b2,m2", "b0,b1,b2,t2", upside)
        self.reject("malformed syntax", bad, "-1*2^4", "-2*2^3", upside)
        self.reject("malformed syntax", bad, "-1*2^4", "-1*2^0", upside)
        self.reject("malformed range", bad, "tet 0", "tet 1", upside)
        self.rejected("invalid not-refuted", PRISM, None, ["-positivity"], [("positivity", "tet 0 b0,b1,b2,m2 1*2^4")])
        pinched = ([[p if v else (0, 0, 0) for v, p in enumerate(layer)] for layer in PRISM[0]], PRISM[1])
        self.rejected("valid", pinched, None, ["positivity"], [])

    # ---- overlay
    def test_overlay(self):
        mesh = (PRISM[0][1], PRISM[1])
        claims = ["positivity", "section", "bijection", "section-all-orders"]
        good = certificate(PRISM, mesh, claims, [("overlay", IDENTITY)])
        for code, old, new in [
                ("malformed duplicate", "v 1 m1", "v 0 m0"), ("malformed range", "c 0 1 2", "c 0 1 3"),
                ("malformed range", "d mesh 0 0", "d mesh 0 1"), ("malformed syntax", "c 0 1 2", "c 0 1 1"),
                ("invalid shell-carrier", "v 0 m0", "v 0 b0,t0"), ("invalid cap", "v 0 m0", "v 0 t0"),
                ("invalid no-point", "v 0 m0", "v 0 m1"), ("invalid area-mesh", "c 0 1 2", "c 0 2 1")]:
            self.reject(code, good, old, new, PRISM, mesh)
        more = lambda facts: self.answer(certificate(PRISM, mesh, claims, [("overlay", facts)]), PRISM, mesh)
        self.assertEqual(more(IDENTITY.replace("c 0 1 2", "c 0 2 1")), "invalid area-mesh")
        self.assertEqual(more(IDENTITY.replace("c 0 1 2", "c 0 1 2\nc 1 2 0")), "invalid edge-twice")
        self.assertEqual(more(IDENTITY.replace("c 0", "v 0,1 m0,m1\nc 0")), "invalid no-point")
        self.assertEqual(more(IDENTITY.replace("v 1 m1", "v 1 b1,m1")), "invalid outside-carrier")
        self.assertEqual(more(IDENTITY + "\nd middle 0 0"), "invalid degree-component")

    def test_overlay_edge_in_a_cap(self):
        """No edge between two pinched vertices; one pinched vertex is the control."""
        mesh = (PRISM[0][1], PRISM[1])
        pinch = lambda pins: ([[M3[v] if v in pins else p for v, p in enumerate(layer)] for layer in PRISM[0]], PRISM[1])
        for pins, code in (((0,), "valid"), ((2,), "valid"), ((0, 1), "invalid cap"), ((1, 2), "invalid cap"), ((0, 2), "invalid cap")):
            self.rejected(code, pinch(pins), mesh, ["section", "bijection"], [("overlay", IDENTITY)])
        twice = IDENTITY.replace("c 0 1 2", "c 0 1 2\nc 1 2 0")  # an edge that is in a cap before any occurs twice
        self.rejected("invalid cap", pinch((0, 1)), mesh, ["section", "bijection"], [("overlay", twice)])
        self.rejected("invalid edge-twice", pinch((0,)), mesh, ["section", "bijection"], [("overlay", twice)])

    def test_overlay_with_inner_edges(self):
        """A mesh of four triangles around the middle of the edge that two prisms share."""
        mesh = (M2 + [(2, 2, 0)], [(0, 1, 4), (1, 3, 4), (3, 2, 4), (2, 0, 4)])
        facts = "v 0 m0\nv 1 m1\nv 2 m2\nv 3 m3\nv 4 m1,m2\nc 0 1 4\nc 1 3 4\nc 3 2 4\nc 2 0 4\nd mesh 0 0\nd middle 0 0"
        claims = ["section", "bijection"]
        good = certificate(TWO, mesh, claims, [("overlay", facts)])
        case = lambda old, new: self.answer(certificate(TWO, mesh, claims, [("overlay", facts.replace(old, new))]), TWO, mesh)
        self.assertEqual(self.answer(good, TWO, mesh), "valid")
        self.assertEqual(case("c 0 1 4\n", ""), "invalid boundary")
        self.assertEqual(case("v 4 m1,m2", "v 1,2 m1,m2"), "invalid mesh-carrier")
        self.assertEqual(case("c 0 1 4\n", "c 0 1 3\n"), "invalid cell-mesh")
        self.assertEqual(case("c 0 1 4", "c 1 4 0 2"), "invalid cell-mesh")
        self.assertEqual(case("\nd mesh", "\nd mesh 1 0\nd mesh"), "invalid degree-component")
        self.assertEqual(case("c 0 1 4\nc", "v 0,4 m0,m1,m2\nc 0 1 4\nc"), "invalid no-point")
        flat = ([(0, 0, 0), (4, 0, 0), (0, 4, 0), (4, 4, 0)], [(0, 1, 3), (0, 3, 2)])
        cut = "v 0 m0\nv 1 m1\nv 2 m2\nv 3 m3\nv 0,3 m1,m2\n"
        whole = cut + "c 0 1 4\nc 1 3 4\nc 0 4 2\nc 4 3 2\nd mesh 0 0\nd mesh 2 0\nd middle 0 0"
        self.assertEqual(self.answer(certificate(TWO, flat, claims, [("overlay", whole.replace("d mesh 2 0\n", ""))]),
                                     TWO, flat), "valid")
        crossed = whole.replace("d mesh 2 0\n", "").replace("c 0 1 4\nc 1 3 4", "c 0 1 3")
        self.assertEqual(self.answer(certificate(TWO, flat, claims, [("overlay", crossed)]), TWO, flat), "invalid cell-shell")

    # ---- the closed tetrahedron, all claims
    def test_tetrahedron(self):
        mesh = (M4, TETRA[1])
        facts = "\n".join([f"v {i} m{i}" for i in range(4)] + ["c %d %d %d" % f for f in TETRA[1]] + ["d mesh 0 0", "d middle 1 0"])
        disjoint = [(f"disjoint-{x}", "") for x in ("mesh", "bottom", "top")]
        good = certificate(TETRA, mesh, ALL[:7], [("overlay", facts)] + disjoint)
        self.reject("malformed counts", good, "counts 10", "counts 9", TETRA, mesh)
        for name in ("mesh", "bottom", "top"):
            blocks = [("overlay", facts)] + [(n, "sep 0 1 n:g0,g1" if n.endswith(name) else t) for n, t in disjoint]
            self.rejected("invalid superfluous", TETRA, mesh, ALL[:7], blocks)
        base = [("overlay", facts)] + disjoint
        self.rejected("invalid missing-separation", TETRA, mesh, ALL, base + [("i2", "")])
        self.rejected("invalid superfluous", TETRA, mesh, ALL, base + [("i2", "contact-sep 0 0 b0,b1,b2,m2 n:g0,g1")])
        case = check.Case(*TETRA_INPUT)
        prism, names = open_tet(case)
        tet = ",".join("bmt"[n % 3] + str(n // 3) for n in names)
        self.rejected("invalid not-separated", TETRA, mesh, ALL, base + [("i2", f"contact-sep 0 {prism} {tet} n:g0,g0")])
        shared = next(n for n in names if n % 3 == 1 and n // 3 in TETRA[1][0])
        left, right = [int(v == shared // 3) for v in TETRA[1][0]], [int(n == shared) for n in names]
        dot, shift = case.dot(0, case.tets(prism)[names]), -3 * (case.unit.bit_length() - 1)
        while dot % 2 == 0:
            dot, shift = dot // 2, shift + 1
        value = f"{dot}*2^{shift}" if shift else str(dot)
        fact = " ".join(map(str, ["contact", 0, prism, tet, *left, *right, value]))
        good = certificate(TETRA, mesh, ALL[:7] + ["-i2"], base + [("i2", fact)])
        self.reject("invalid wrong-value", good, " " + value, " 1", TETRA, mesh)
        self.reject("invalid unknown-tet", good, tet, "b0,b1,b2,t2", TETRA, mesh)
        self.reject("malformed syntax", good, " ".join(map(str, right)) + " " + value, "0 0 0 0 " + value, TETRA, mesh)
        self.reject("invalid wrong-point", good, " ".join(map(str, right)) + " " + value, "1 1 1 1 " + value, TETRA, mesh)

    # ---- all orders
    def test_all_orders(self):
        """A bent wall under a boundary edge, and the piece test alone on a triangle that stands upright."""
        claims = ["positivity", "section", "bijection", "section-all-orders"]
        facts = IDENTITY.replace("v 2 m2", "v 2 m2,t2")
        for turned, code in ((0, "valid"), (1, "invalid all-orders-boundary")):
            top = [(turned, turned, 4), (4, 0, 4), (0, 4, 4)]
            shell = ([[(x, y, -4) for x, y, _ in M3], M3, top], PRISM[1])
            mesh = ([(0, 0, 0), (4, 0, 0), (0, 4, 2)], [(0, 1, 2)])
            self.rejected(code, shell, mesh, claims, [("overlay", facts)])
        floats = lambda points: [tuple(map(float, p)) for p in points]
        for third, code in (((1, 2, 0.5), None), ((2, 1, 0.75), "all-orders"), ((2, 0.5, 0.5), "all-orders")):
            points = floats([(1, 1, 0.5), (2, 1, 0.5), third])
            case = check.Case([floats(x) for x in TWO[0]], TWO[1], points, [(0, 1, 2)])
            try:
                check.check_all_orders(case, [], [(0, 0, [[[1, 0, 0], [0, 1, 0], [0, 0, 1]]])], [])
                self.assertIsNone(code)
            except check.Stop as stop:
                self.assertEqual(stop.args[1], code)

    # ---- separations
    def test_disjoint(self):
        points = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (3, 3, -1), (3, 3, 1), (10, 4, 0)]
        mesh, faces = (points, [(0, 1, 2), (3, 4, 5)]), [(0, 1, 2), (3, 4, 5)]
        good = certificate(PRISM, mesh, ["disjoint-mesh"], [("disjoint-mesh", "sep 0 1 l:g1,g2")])
        self.reject("invalid not-separated", good, "l:g1,g2", "l:g0,g1", PRISM, mesh)
        self.reject("malformed syntax", good, "sep 0 1", "sep 1 0", PRISM, mesh)
        self.reject("malformed range", good, "sep 0 1", "sep 0 2", PRISM, mesh)
        self.reject("malformed range", good, "g1,g2", "g1,g6", PRISM, mesh)
        self.rejected("invalid missing-separation", PRISM, mesh, ["disjoint-mesh"], [("disjoint-mesh", "")])
        points = points[:3] + [(1, 1, -1), (1, 1, 1), (10, 4, 0)]
        mesh = (points, faces)
        good = certificate(PRISM, mesh, ["-disjoint-mesh"], [("disjoint-mesh", "cross 0 1 2 1 1 1 1 0")])
        self.reject("invalid wrong-point", good, "2 1 1 1 1 0", "1 1 1 1 1 0", PRISM, mesh)
        self.reject("malformed syntax", good, "2 1 1 1 1 0", "2 1 1 0 0 0", PRISM, mesh)
        pair = (points[:3] + [(4, 4, 0)], [(0, 1, 2), (1, 3, 2)])
        self.rejected("invalid not-refuted", PRISM, pair, ["-disjoint-mesh"], [("disjoint-mesh", "cross 0 1 0 1 0 1 0 0")])
        on_top = ([(x, y, 1) for x, y, _ in M3], [(0, 1, 2)])
        self.rejected("valid", PRISM, on_top, ["-disjoint-top"], [("disjoint-top", "cross 0 0 1 0 0 1 0 0")])

    def test_other_names_at_a_pinched_vertex(self):
        """A point with the coordinates of a pinched vertex is allowed, whatever name it is given."""
        bottom = [(0, 0, 0), (0, 0, 0), (0, 4, -1)]
        shell = ([bottom, M3, [(0, 0, 0), (4, 0, 1), (0, 4, 1)]], [(0, 1, 2)])
        corner = ([(0, 0, 0), (4, 0, 4), (0, 4, 4)], [(0, 1, 2)])
        through = ([(8, -4, 0), (-4, 8, 0), (-4, -4, 0)], [(0, 1, 2)])
        facts = lambda text: [("disjoint-bottom", text)]
        self.rejected("valid", shell, corner, ["disjoint-bottom"], facts(""))
        for weights in ["0 1 0", "1 0 0"]:
            self.rejected("invalid not-refuted", shell, corner, ["-disjoint-bottom"], facts("cross 0 0 1 0 0 " + weights))
        self.rejected("valid", shell, through, ["disjoint-bottom"], facts(""))
        self.rejected("invalid not-refuted", shell, through, ["-disjoint-bottom"], facts("cross 0 0 1 1 1 1 0 0"))
        bottom[1] = (0, 1, 0)
        self.rejected("invalid missing-separation", shell, through, ["disjoint-bottom"], facts(""))

    # ---- witnesses
    def refute(self, code, mesh, facts, shell=PRISM):
        self.rejected(code, shell, mesh, ["-section", "-bijection"], [("no-section", facts)])

    def test_topology_and_tet(self):
        mesh = (M4, TETRA[1])
        self.refute("valid", mesh, "topology euler 2 1")
        self.refute("invalid wrong-value", mesh, "topology euler 2 0")
        self.refute("invalid not-refuted", mesh, "topology components 1 1")
        upside = (PRISM[0][::-1], PRISM[1])
        self.refute("valid", mesh, "tet 0 b0,b1,b2,m2 -1*2^4", upside)
        self.refute("invalid unknown-tet", mesh, "tet 0 b0,b1,m1,b2 -1*2^4", upside)
        self.refute("invalid wrong-value", mesh, "tet 0 b0,b1,b2,m2 -1", upside)
        self.refute("invalid not-refuted", mesh, "tet 0 b0,b1,b2,m2 1*2^4")

    def test_roots(self):
        low = ([(0.5, 0.5, -0.9375), (1.5, 0.5, -0.9375), (0.5, 1.5, -0.9375)], [(0, 1, 2)])
        far = ([(x, y, 9) for x, y, _ in M3], [(0, 1, 2)])
        self.refute("valid", far, "root 0 1 1 1")
        self.refute("invalid wrong-branches", far, "root 0 1 1 1\nbranch m0\nstart m0,m1,m2,t2\ncap")
        self.refute("invalid wrong-branches", far, "root 0 1 1 1\nroot 0 1 1 1")
        tet = "b0,b1,b2,m2"
        branch = f"\nbranch {tet}\nstart {tet}\n"
        self.refute("valid", low, "root 0 1 0 0" + branch + "boundary")
        for reason in ("wall", "cap", "fold", "lands"):
            self.refute("invalid not-refuted", low, "root 0 1 0 0" + branch + reason)
        for reason in ("twice", "reason", "cap 0"):
            self.refute("malformed syntax", low, "root 0 1 0 0" + branch + reason)
        self.refute("invalid wrong-step", low, "root 0 1 0 0" + branch.replace("start " + tet, "start m0,m1,m2,t2") + "boundary")
        self.refute("invalid unknown-tet", low, "root 0 1 0 0" + branch.replace("start " + tet, "start b0,m0,m1,t1") + "boundary")
        self.refute("valid", low, f"root 0 1 1 1{branch[:-1]}\nstep 0 1 0 0 {tet}\nboundary")
        self.refute("invalid wrong-step", low, f"root 0 1 1 1{branch[:-1]}\nstep 0 1 0 0 b0,b1,m1,m2\nboundary")
        self.refute("valid", (low[0], [(0, 2, 1)]), "root 0 1 1 1" + branch + "fold")
        top = ([(0.5, 0.5, 1), (1.5, 0.5, 0.5), (0.5, 1.5, 0.5)], [(0, 1, 2)])
        self.refute("valid", top, "root 0 1 0 0\nbranch t0,t1,t2\nstart m0,t0,t1,t2\ncap")
        wide = ([(-4, 0, 0.0625), (4, -1, 0.0625), (0, 4, 0.0625)], [(0, 1, 2)])
        self.refute("invalid wrong-branches", wide, "root 0 1 1 1")

    def test_twice(self):
        mesh = ([(.5, .5, .25), (1.5, .5, .25), (.5, 1.5, .25), (.75, 1, .26)], [(0, 1, 2), (1, 0, 3)])
        tet = "m0,m1,t1,t2"
        facts = f"root 0 13 5 2\nbranch {tet}\nstart {tet}\nstart {tet}\nstep 1 1 3 0 {tet}\nstep 1 1 3 1 {tet}\ntwice"
        self.refute("valid", mesh, facts)
        self.refute("invalid not-refuted", mesh, facts.replace("1 3 1", "2 3 1"))
        self.refute("invalid not-refuted", mesh, facts.replace("twice", "monodromy"))
        self.refute("invalid wrong-step", mesh, facts.replace(f"step 1 1 3 0 {tet}\n", ""))

    def test_wall_and_lands(self):
        wall = ([(1, -1, 0.125), (3, -1, 0.125), (2, 1, 0.125)], [(0, 1, 2)])
        facts = "root 0 1 1 2\nbranch m0,m1,t1\nstart m0,m1,t1,t2\nwall"
        self.refute("valid", wall, facts)
        self.refute("invalid not-refuted", wall, facts.replace("wall", "boundary"))
        self.refute("invalid wrong-branches", wall, facts.replace("m0,m1,t1\n", "m0,m1,t2\n"))
        pair = ([(1, 1, 0.9375), (2, 1, 0.9375), (1, 2, 0.9375), (1, 1, -0.9375), (2, 1, -0.9375), (1, 2, -0.9375)],
                [(0, 1, 2), (3, 4, 5)])
        up, down = "m0,t0,t1,t2", "b0,b1,b2,m2"
        facts = "\n".join(f"root {k} 1 1 1\nbranch {t}\nstart {t}\nlands" for k, t in enumerate((up, down)))
        self.refute("valid", pair, facts)
        self.refute("invalid not-refuted", pair, facts.split("\nroot 1")[0])
        self.refute("invalid wrong-branches", pair, facts.replace("root 1", "root 0").replace(down, up))

    def test_covered_twice(self):
        """Two abstract prisms in one place: each holds the whole mesh triangle."""
        double, mesh = ([x * 2 for x in PRISM[0]], [(0, 1, 2), (3, 4, 5)]), (M3, [(0, 1, 2)])
        claims, other = ["section", "bijection"], "v 0 m3\nv 1 m4\nv 2 m5\nc"
        facts = IDENTITY.replace("\nc", "\n" + other, 1)
        twice = facts.replace("c 0 1 2", "c 0 1 2\nc 3 4 5") + "\nd middle 1 0"
        self.rejected("invalid isolated", double, mesh, claims, [("overlay", facts)])
        self.rejected("invalid degree-component", double, mesh, claims, [("overlay", IDENTITY)])
        self.rejected("invalid degree", double, mesh, claims, [("overlay", twice)])
        self.rejected("invalid area-middle", PRISM, (M3, [(0, 2, 1)]), claims, [("overlay", IDENTITY.replace("1 2\nd", "2 1\nd"))])

    def test_size(self):
        limit, good = inputs.LIMIT, certificate(PRISM, None, ["positivity"], [])
        try:
            for inputs.LIMIT, code in ((len(good), "limit size"), (10 ** 6, "valid")):
                self.assertEqual(self.answer(good + " " * (code != "valid")), code)
        finally:
            inputs.LIMIT = limit

    def test_damage_is_never_internal(self):
        """Random damage of accepted certificates ends with a code of the format."""
        mesh = ([(.5, .5, .25), (1.5, .5, .25), (.5, 1.5, .25), (.75, 1, .26)], [(0, 1, 2), (1, 0, 3)])
        tet = "m0,m1,t1,t2"
        facts = f"root 0 13 5 2\nbranch {tet}\nstart {tet}\nstart {tet}\nstep 1 1 3 0 {tet}\nstep 1 1 3 1 {tet}\ntwice"
        crossing = ([(0, 0, 0), (4, 0, 0), (0, 4, 0), (3, 3, -1), (3, 3, 1), (10, 4, 0)], [(0, 1, 2), (3, 4, 5)])
        same = (PRISM[0][1], PRISM[1])
        controls = [(mesh, certificate(PRISM, mesh, ["-section", "-bijection"], [("no-section", facts)])),
                    (crossing, certificate(PRISM, crossing, ["disjoint-mesh"], [("disjoint-mesh", "sep 0 1 l:g1,g2")])),
                    (same, certificate(PRISM, same, ALL[:4], [("overlay", IDENTITY)]))]
        draw = random.Random(1)
        for mesh, good in controls:
            self.assertEqual(self.answer(good, PRISM, mesh), "valid")
            for _ in range(1500):
                text = good
                for _ in range(draw.randint(1, 2)):
                    kind, lines = draw.randrange(4), text.split("\n")
                    a, b = draw.randrange(len(lines)), draw.randrange(len(lines))
                    if kind == 0:
                        lines[a] = lines[b]
                    elif kind == 1:
                        lines[a], lines[b] = lines[b], lines[a]
                    elif kind == 2:
                        del lines[a]
                    else:
                        k = draw.randrange(len(lines[a]) + 1)
                        lines[a] = lines[a][:k] + draw.choice("0123459bmtg, -*^") + lines[a][k + draw.randrange(2):]
                    text = "\n".join(lines)
                self.assertNotIn("internal", self.answer(text, PRISM, mesh), text)

    def test_null_vector_by_definition(self):
        """Against the rank and the minors of the system, in fractions."""
        draw, seen = random.Random(2), {None: 0, True: 0}
        for _ in range(3000):
            n = draw.randint(2, 7)
            columns = [tuple(draw.randint(-2, 2) for _ in range(3)) + (draw.choice((1, -1)),) for _ in range(n)]
            answer = check.null_vector(columns)
            line = rank(columns) == n - 1
            self.assertEqual(answer is not None, line)
            seen[line or None] += 1
            if line:
                self.assertTrue(any(answer))
                for row in zip(*columns):
                    self.assertEqual(sum(x * y for x, y in zip(row, answer)), 0)
        self.assertGreater(min(seen.values()), 100)

    def test_meeting_boxes_by_definition(self):
        draw = random.Random(3)
        boxes = []
        for _ in range(300):
            low = [draw.randint(0, 20) for _ in range(3)]
            boxes.append(tuple(low) + tuple(x + draw.randint(0, 4) for x in low))
        found = [[j for i, j in check.meeting(boxes, boxes, range(300), range(300)) if i == k] for k in range(300)]
        for query, met in zip(boxes, found):
            slow = [i for i, b in enumerate(boxes) if all(b[k] <= query[k + 3] and query[k] <= b[k + 3] for k in range(3))]
            self.assertEqual(sorted(met), slow)

    def test_tets_by_definition(self):
        """In the straight unit prism all 24 tets are positive; each order's three fill a slab (volume 3 of 6 sixths)."""
        unit = [[(0., 0., z), (1., 0., z), (0., 1., z)] for z in (-1., 0., 1.)]
        case = check.Case(unit, [(0, 1, 2)], [], [])
        self.assertEqual([case.volume(t) for t in case.tets(0).values()], [1] * 24)
        self.assertEqual(len(case.tets(0)), 24)
        for order in itertools.permutations(range(3)):
            u, v, w = order
            expected = {frozenset(x) for s in (0, 1) for lo, hi in [((s, s + 3, s + 6), (s + 1, s + 4, s + 7))]
                        for x in ((lo[u], lo[v], lo[w], hi[w]), (lo[u], lo[v], hi[v], hi[w]), (lo[u], hi[u], hi[v], hi[w]))}
            self.assertEqual({frozenset(x) for x in case.decomposition(order)[0]}, expected)

    def test_injective_star_by_sampling(self):
        """Wedges around a vertical edge overlap just when some direction lies inside two of them."""
        draw, seen = random.Random(4), set()
        for _ in range(400):
            ring = [(draw.randint(-3, 3), draw.randint(-3, 3)) for _ in range(6)]
            wedges = [(ring[k], ring[k + 1]) for k in (0, 2, 4) if turn(ring[k], ring[k + 1])]
            points = {0: (0, 0, 0), 1: (0, 0, 1)}
            tets = {}
            for k, (r, s) in enumerate(wedges):
                names = (0, 1, 100 + 2 * k, 101 + 2 * k)
                points[names[2]], points[names[3]] = r + (5,), s + (-7,)
                order = names if turn(r, s) > 0 else names[:2] + names[:1:-1]
                tets[names] = (order, 0)
            case = type("C", (), {"at": lambda self, tags: [points[t] for t in tags], "M": type("M", (), {"at": {0: [0]}}),
                                       "volume": lambda self, t: check.det(*(points[n] for n in t[0]))})()
            rays = [r for w in wedges for r in w]
            samples = [(a + c, b + d) for a, b in rays for c, d in rays] + [(3 * a + c, 3 * b + d) for a, b in rays for c, d in rays]
            samples = [(9 * a + c, 9 * b + d) for a, b in samples for c, d in rays]
            inside = lambda x, w: all(turn(p, q) * turn(*w) > 0 for p, q in ((w[0], x), (x, w[1])))
            overlap = any(sum(inside(x, w) for w in wedges) > 1 for x in samples)
            self.assertEqual(check.injective_star(case, [tets], (0, 1)), not overlap, wedges)
            seen.add(overlap)
        self.assertEqual(len(seen), 2)


def open_tet(case):
    """A prism and the least of its tets that mesh triangle 0 may touch, by the definition in section 3.6."""
    A = [~v for v in case.T.faces[0]]
    for prism in range(len(case.M.faces)):
        for names, tet in sorted(case.tets(prism).items()):
            planes = [case.planes[0]] + [check.plane(*case.at(x)) for x in itertools.combinations(names, 3)]
            if case.dot(0, tet) <= 0 and check.meet(check.box(case.at(A)), check.box(case.at(names))):
                if not any(check.separates(case, [h], A, list(names)) for h in planes) and not case.clear(0, prism):
                    return prism, names


def turn(a, b):
    return a[0] * b[1] - a[1] * b[0]


def rank(columns):
    rows, found = [[Fraction(x) for x in c] for c in columns], 0
    for k in range(4):
        pivot = next((r for r in rows if r[k]), None)
        if pivot:
            found += 1
            rows = [[x - r[k] / pivot[k] * y for x, y in zip(r, pivot)] for r in rows if r is not pivot]
    return found


TETRA_INPUT = ([[tuple(map(float, p)) for p in layer] for layer in TETRA[0]], TETRA[1], [tuple(map(float, p)) for p in M4], TETRA[1])


def hdf5(shell, extra=()):
    """A classic HDF5 file with the shell's datasets, its middle surface as the mesh, and names from these places of the heap on."""
    u = lambda n, size: n.to_bytes(size, "little")
    flat = lambda code, rows: b"".join(struct.pack("<3" + code, *r) for r in rows)
    (b, m, t), prisms = shell
    sets = [(b"mF", "i", prisms), (b"mV", "d", m), (b"mbase", "d", b), (b"mtop", "d", t), (b"ref.F", "i", prisms), (b"ref.V", "d", m)]
    message = lambda kind, body: u(kind, 2) + u(len(body), 2) + bytes(4) + body
    header = lambda *messages: u(1, 2) + u(len(messages), 2) + u(1, 4) + u(sum(map(len, messages)), 4) + bytes(4) + b"".join(messages)
    root, tree, heap, snod, names = 96, 136, 184, 216, 472 + 40 * len(extra)
    at, out, table, offsets = names + 64, b"", b"", []
    for name, code, rows in sets:
        size = 8 if code == "d" else 4
        kind = (b"\x11\x20\x3f\0" + u(8, 4) + struct.pack("<HHBBBBI", 0, 64, 52, 11, 0, 52, 1023) if code == "d"
                else b"\x10\x08\0\0" + u(4, 4) + u(0, 2) + u(32, 2)).ljust(24, b"\0")
        space = b"\1\2" + bytes(6) + u(len(rows), 8) + u(3, 8)
        body = lambda where: header(message(1, space), message(3, kind), message(8, b"\3\1" + u(where, 8) + u(3 * size * len(rows), 8)
                                                                             + bytes(6)))
        length = len(body(0))
        offsets.append(at)
        block = body(at + length) + flat(code, rows)
        out, at = out + block, at + len(block)
    heap_data = b"\0" * 8
    for (name, _, _), where in zip(sets, offsets):
        table += u(len(heap_data), 8) + u(where, 8) + bytes(24)
        heap_data += name.ljust(8, b"\0")
    table += b"".join(u(at, 8) + bytes(32) for at in extra)
    file = b"\x89HDF\r\n\x1a\n" + bytes(5) + b"\x08\x08\0" + u(4, 2) + u(16, 2) + bytes(4) + u(0, 8) + b"\xff" * 8 + u(at, 8) + b"\xff" * 8
    file += u(0, 8) + u(root, 8) + u(1, 4) + bytes(4) + u(tree, 8) + u(heap, 8)
    file += header(message(0x11, u(tree, 8) + u(heap, 8)))
    file = file.ljust(tree, b"\0") + b"TREE\0\0" + u(1, 2) + b"\xff" * 16 + u(0, 8) + u(snod, 8) + u(8, 8)
    file = file.ljust(heap, b"\0") + b"HEAP" + bytes(4) + u(64, 8) + u(1, 8) + u(names, 8)
    file = file.ljust(snod, b"\0") + b"SNOD\1\0" + u(len(sets) + len(extra), 2) + table
    return file.ljust(names, b"\0") + heap_data.ljust(64, b"\0") + out


if __name__ == "__main__":
    unittest.main()
