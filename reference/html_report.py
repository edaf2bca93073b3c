#!/usr/bin/env python3
"""The page of `homeo audit --html` in headless Chromium: it draws, and a click names the triangle that a ray cast here hits.

python3 html_report.py HOMEO [--keep DIR]

Without Chromium it says SKIPPED and ends with exit code 0. --keep DIR: pages and screenshots stay there.
"""
import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import chromium  # noqa: E402

HOSTILE = os.path.join("<", "script><img src=x onerror=\"document.title='taken'\"><b>'&.off")


def torus(n, m, turn=0.0, bump=0.0, at=0.0):
    """A torus of 2 n m triangles, perhaps with a bump."""
    points, faces = [], []
    for i in range(n):
        for j in range(m):
            u, v = 2 * math.pi * (i + turn) / n, 2 * math.pi * (j + turn) / m
            r = 0.4 + bump * math.exp(-9 * ((u - 1.1) ** 2 + (v - 0.5) ** 2))
            points.append(((1 + r * math.cos(v)) * math.cos(u) + at, r * math.sin(v), (1 + r * math.cos(v)) * math.sin(u)))
    for i in range(n):
        for j in range(m):
            a, b = i * m + j, i * m + (j + 1) % m
            c, d = (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m
            faces += [(a, b, d), (a, d, c)]
    return points, faces


def write(file, mesh, factor=1.0):
    points, faces = mesh
    with open(file, "w") as out:
        out.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        out.writelines(" ".join(repr(factor * x) for x in p) + "\n" for p in points)
        out.writelines("3 %d %d %d\n" % f for f in faces)


def ray(matrix, mesh, frame, x, y):
    """(depth, triangle, smallest weight) where the ray at (x, y) in [-1, 1]^2 first meets a mesh, or None: by definition."""
    points, faces = mesh
    seen = []
    for p in points:
        q = [(p[i] - frame["centre"][i]) / frame["half"] for i in range(3)] + [1.0]
        c = [sum(matrix[4 * k + r] * q[k] for k in range(4)) for r in range(4)]
        seen.append((c[0] / c[3], c[1] / c[3], c[2] / c[3]))
    hits = []
    for t, face in enumerate(faces):
        a, b, c = (seen[v] for v in face)
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if area == 0:
            continue
        w = [((q[0] - x) * (r[1] - y) - (q[1] - y) * (r[0] - x)) / area for q, r in ((b, c), (c, a), (a, b))]
        if min(w) > -0.05:
            hits.append((sum(k * p[2] for k, p in zip(w, (a, b, c))), t, min(w)))
    inside = [h for h in hits if h[2] >= 0]
    # Near an edge the two computations may differ: such places are passed over.
    near = inside and min(inside)
    return None if not near or any(h[2] < 0.05 and h[0] <= near[0] + 1e-3 for h in hits) else near


class Check:
    def __init__(self, homeo, browser, folder):
        self.homeo, self.browser, self.folder, self.failed, self.passed = homeo, browser, folder, 0, 0

    def that(self, what, good):
        self.failed, self.passed = self.failed + (not good), self.passed + bool(good)
        if not good:
            print(f"FAILED: {what}")

    def audit(self, name, a, b, *options):
        """Audits two files; the report and the page."""
        page, report = (os.path.join(self.folder, name + end) for end in (".html", ".json"))
        done = subprocess.run([self.homeo, "audit", a, b, "--html", page, "--json", report, "-q", *options],
                              cwd=self.folder, capture_output=True, text=True)
        self.that(f"{name}: exit code {done.returncode}: {done.stderr}", done.returncode in (0, 1))
        self.open(name, page)
        with open(report) as file:
            return json.load(file), page

    def open(self, name, page):
        start = time.time()
        self.that(f"{name}: ready", self.browser.open(page) == "yes")
        self.that(f"{name}: pixels drawn", int(self.browser.value("document.documentElement.dataset.pixels") or 0) > 2000)
        self.that(f"{name}: {self.browser.complaints()}", not self.browser.complaints())
        self.browser.screenshot(os.path.join(self.folder, name + ".tables.png"))
        self.browser.value("document.querySelector('main').scrollIntoView()")
        print(f"{name}: {os.path.getsize(page)} bytes, drawn after {time.time() - start:.1f} s")

    def panel(self):
        """What the panel says: (surface, triangle), text."""
        v = self.browser.value
        where = v("(({surface, triangle}) => [surface, triangle])(document.getElementById('selected').dataset)")
        return where, v("document.getElementById('selected').innerText")

    def settle(self):
        self.browser.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")

    def clicks(self, name, meshes, wanted):
        """Clicks at random places of every pane and compares with rays."""
        v, tried = self.browser.value, 0
        frame = v("homeo.scene.frame")
        box = v("(({left, top, width, height}) => ({left, top, width, height}))(homeo.viewer.canvas.getBoundingClientRect())")
        panes = v("homeo.viewer.panes().map((p) => ({...p, camera: [...homeo.viewer.view(p).camera]}))")
        dice = random.Random(1)
        for _ in range(400 * wanted):
            pane = dice.choice(panes)
            px, py = dice.randrange(pane["width"]), dice.randrange(pane["height"])
            x, y = 2 * px / pane["width"] - 1, 1 - 2 * py / pane["height"]
            hits = [(m, ray(pane["camera"], meshes[m], frame, x, y)) for m in "AB" if m in pane["names"]]
            if any(h is None for _, h in hits):
                continue
            if len(hits) == 2 and abs(hits[0][1][0] - hits[1][1][0]) < 1e-3:
                continue
            mesh, hit = min(hits, key=lambda h: h[1][0])
            self.browser.click(box["left"] + pane["x"] + px, box["top"] + py)
            where, text = self.panel()
            self.that(f"{name}: at {px} {py}: {where}, a ray hits {mesh} {hit[1]}", where == [mesh, str(hit[1])])
            self.that(f"{name}: the panel's head", text.startswith(f"{mesh}, triangle {hit[1]}"))
            tried += 1
            if tried == wanted:
                return
        self.that(f"{name}: {tried} of {wanted} clicks", False)


    def picture(self):
        """A number that changes with the picture."""
        return self.browser.value(
            "(() => { const { canvas, renderer } = homeo.viewer; homeo.viewer.draw(); const n = canvas.width * canvas.height;"
            " const b = new Uint8Array(4 * n); renderer.gl.readPixels(0, 0, canvas.width, canvas.height, renderer.gl.RGBA,"
            " renderer.gl.UNSIGNED_BYTE, b); return b.reduce((s, x) => (31 * s + x) % 1000003, 0); })()")

    def put(self, control, value):
        """Uses a control as a person would: its value, then the event."""
        key = "checked" if isinstance(value, bool) else "value"
        self.browser.value(f"(() => {{ const c = document.querySelector({json.dumps(control)});"
                           f" c.{key} = {json.dumps(value)}; c.dispatchEvent(new Event('input')); }})()")


def certified(check):
    meshes = {"A": torus(14, 8), "B": torus(20, 11, 0.5)}
    os.mkdir(os.path.join(check.folder, "<"))
    write(os.path.join(check.folder, HOSTILE), meshes["A"])
    write(os.path.join(check.folder, "b.off"), meshes["B"])
    report, _ = check.audit("certified", HOSTILE, "b.off")
    v = check.browser.value
    check.that("bijective", report["verdict"] == "bijective")
    check.that("the title is text", v("document.title").startswith("bijective: </script><img"))
    check.that("no element from a file name", v("document.images.length + document.querySelectorAll('bdi b').length") == 0)
    check.that("the map is shown", v("homeo.viewer.layer.carried && homeo.viewer.options.checker"))
    check.browser.screenshot(os.path.join(check.folder, "certified.png"))
    check.clicks("certified", meshes, 8)
    before = v("homeo.viewer.camera.yaw")
    box = v("(({left, top}) => [left, top])(homeo.viewer.canvas.getBoundingClientRect())")
    check.browser.drag(box[0] + 80, box[1] + 80, 60, 30)
    check.that("a drag turns", abs(v("homeo.viewer.camera.yaw") - before) > 0.1)
    before = v("homeo.viewer.camera.distance")
    check.browser.pinch(box[0] + 200, box[1] + 300, 100, 150)
    check.that("a pinch zooms", abs(v("homeo.viewer.camera.distance") / before - 2 / 3) < 0.01)
    before = check.picture()
    check.put("#slide", 1)
    check.that("down to the middle surface", check.picture() != before)
    check.settle()
    check.browser.screenshot(os.path.join(check.folder, "middle.png"))


def violations(check):
    meshes = {"A": torus(14, 8), "B": torus(20, 11, 0.5, 0.45)}
    for name, mesh in meshes.items():
        write(os.path.join(check.folder, f"{name}.off"), mesh)
    report, _ = check.audit("violations", "A.off", "B.off", "--try", "a")
    v = check.browser.value
    check.that("not certified", report["verdict"] == "not-certified")
    survey = report["attempts"][0]["surveys"][0]
    largest = max(survey["regions"], key=lambda r: len(r["violations"]))
    first = survey["violations"][largest["violations"][0]]
    check.clicks("violations", meshes, 8)
    v("document.querySelector('#regions button').click()")
    check.settle()
    where, text = check.panel()
    check.that(f"a region selects {where}", where == ["B", str(first["triangle"])])
    words = "".join(text.split())
    exact = first["point"]["exact"] + [str(x) for x in first["point"]["weights"]] + [first["text"]]
    check.that("exact texts", all("".join(t.split()) in words for t in exact))
    target = v("homeo.viewer.camera.target.map((x, i) => homeo.scene.frame.centre[i] + x * homeo.scene.frame.half)")
    check.that("the view is there", math.dist(target, first["point"]["approximate"]) < 1.5)
    check.that("other try, other layer", v("document.querySelectorAll('#layer option').length") == len(report["attempts"]))
    check.browser.resize(1000, 640)
    v("document.querySelector('main').scrollIntoView()")
    check.settle()
    check.browser.screenshot(os.path.join(check.folder, "audit.png"))  # docs/audit.png
    check.browser.resize(1200, 1000)
    v("document.getElementById('whole').click()")
    v("document.querySelector('main').scrollIntoView()")
    controls(check)
    check.put("#axis", "2")
    check.settle()
    check.browser.screenshot(os.path.join(check.folder, "violations.png"))


def controls(check):
    """Each control changes the picture, and changes it back."""
    before = check.picture()
    check.that("the same picture twice", check.picture() == before)
    for control, there, back in [("#legend input", False, True), ("#opacity-B input", 0.5, 1), ("#opacity-top input", 0, 0.1),
                                 ("#edges", False, True), ("#witnesses", False, True), ("#split", True, False),
                                 ("#axis", "1", ""), ("#axis", "view", "")]:
        start = check.picture()
        check.put(control, there)
        check.that(f"{control}: {there}", check.picture() != start)
        check.put(control, back)
        check.that(f"{control}: {back} again", check.picture() == start)
    check.put("#axis", "0")
    check.put("#offset", -1)
    hit = "homeo.viewer.pickAt(homeo.viewer.canvas.clientWidth / 2 - 150, homeo.viewer.canvas.clientHeight / 2)"
    check.that("nothing is left of the slice to be clicked", check.browser.value(hit) is None)
    check.put("#flip", True)
    check.that("all is there on its other side", check.browser.value(hit) is not None)
    check.put("#flip", False)
    check.put("#offset", 0)


def far_and_invalid(check):
    sheets = [torus(9, 6), torus(9, 6, 0.0, 0.0, 0.7)]
    both = sheets[0][0] + sheets[1][0], sheets[0][1] + [tuple(v + 54 for v in f) for f in sheets[1][1]]
    write(os.path.join(check.folder, "crossing.off"), both, 1e100)
    write(os.path.join(check.folder, "far.off"), torus(9, 6, 0.0, 0.0, 0.35), 1e100)
    report, _ = check.audit("invalid", "crossing.off", "far.off")
    check.that("invalid input", report["verdict"] == "invalid-input")
    check.clicks("invalid", {"A": ([tuple(1e100 * x for x in p) for p in both[0]], both[1]),
                             "B": ([tuple(1e100 * x for x in p) for p in torus(9, 6, 0, 0, 0.35)[0]], torus(9, 6)[1])}, 4)
    check.browser.value("document.querySelector('#regions button').click()")
    check.settle()
    where, _ = check.panel()
    pairs = report["inputs"][0]["self_intersections"]
    check.that("a pair that intersects", where == ["A", str(pairs[0]["triangles"][0])])
    check.browser.screenshot(os.path.join(check.folder, "invalid.png"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("homeo")
    parser.add_argument("--keep", metavar="DIR")
    args = parser.parse_args()
    path = chromium.find()
    if not path:
        print("SKIPPED: HTML reports are not tested: there is no Chromium")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        if args.keep:
            folder = os.path.abspath(args.keep)
            os.makedirs(folder)
        with chromium.Browser(path, 1200, 1000) as browser:
            check = Check(os.path.abspath(args.homeo), browser, folder)
            for part in (certified, violations, far_and_invalid):
                part(check)
    print(f"{check.passed} passed, {check.failed} failed")
    return int(check.failed > 0)


if __name__ == "__main__":
    sys.exit(main())
