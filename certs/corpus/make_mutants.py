#!/usr/bin/env python3
"""Writes the mutants of the controls: python3 make_mutants.py [--check]

A mutant is a named corruption of one control, `<control>/<mutant>.cert` (and changed inputs `<mutant>.<input>.off`);
`mutants.tsv` says which answer FORMAT.md asks for. Those answers are stated by hand in `mutants_form.py` (the file and
the inputs), `mutants_rules.py` and `mutants_prisms.py` (the claims); nothing here asks a checker. An edit that no longer fits its control
is an error. `--check` writes nothing and fails unless the stored files are the ones that would be written.
"""
import hashlib
import pathlib
import re
import struct
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import corpus_files  # noqa: E402  the path is set above
from corpus_files import EXIT, HEAD, Misfit, recount, swap  # noqa: E402

INPUTS = ["bottom", "middle", "top", "mesh"]


# ------------------------------------------------- edits of text; each is a function from text to text
def lines(old, new):
    """Replaces the one run of whole lines `old`; an empty `new` drops them."""
    end = new + "\n" if new else ""
    return lambda text: swap(f"\n{old}\n", "\n" + end)(text) if text.count(f"\n{old}\n") else first(old, end)(text)


def first(old, end):
    def edit(text):
        if not text.startswith(old + "\n"):
            raise Misfit(f"no line {old!r}")
        return end + text[len(old) + 1:]
    return edit


def drop(old):
    return lines(old, "")


def after(old, new):
    return lines(old, f"{old}\n{new}")


def cut(count):
    """Keeps all but the last `count` bytes."""
    return lambda text: text[:-count]


def blocks(**new):
    """Replaces the fact lines of blocks (`_` for `-`): text, or None to drop a block that must be there."""
    def edit(text):
        for name, facts in new.items():
            name = name.replace("_", "-")
            found = re.search(f"^begin {name}\n((?!begin |counts).*\n)*", text, re.M)
            if not found:
                raise Misfit(f"no block {name}")
            body = "" if facts is None else f"begin {name}\n" + (facts.strip() + "\n" if facts else "")
            text = text[:found.start()] + body + text[found.end():]
        return text
    return edit


def whole(claims, body):
    """Keeps hashes, order and pinched line of the control; states other claims and other blocks."""
    def edit(text):
        head = re.search("^shell [^\n]*\nmesh [^\n]*\norder [^\n]*\npinched [^\n]*\n", text, re.M)
        if not head:
            raise Misfit("no head")
        stated = "".join(f"claim {c.lstrip('-')} {'refuted' if c[0] == '-' else 'certified'}\n" for c in claims.split())
        return f"homeo-certificate 1\n{stated}{head[0]}{body.strip()}\ncounts\nend\n"
    return edit


# ------------------------------------------------- inputs
def parse_off(text):
    """Points and triangles of a control's OFF file, and of a changed one that is still regular."""
    words = text.split()
    n, k = int(words[1]), int(words[2])
    numbers, faces = words[4:4 + 3 * n], words[4 + 3 * n:4 + 3 * n + 4 * k]
    return list(map(float, numbers)), [int(w) for i, w in enumerate(faces) if i % 4]


def stated(word, layers, faces):
    data = b"".join(struct.pack(f"<{len(p)}d", *p) for p in layers) + struct.pack(f"<{len(faces)}I", *faces)
    return f"{word} {hashlib.sha256(data).hexdigest()} {len(layers[0]) // 3} {len(faces) // 3}"


def rehash(text, off):
    """States hashes and sizes of these inputs."""
    layers = [parse_off(off[name]) for name in INPUTS[:3]]
    text = re.sub("^shell .*$", stated("shell", [p for p, _ in layers], layers[1][1]), text, flags=re.M)
    points, faces = parse_off(off["mesh"])
    return re.sub("^mesh .*$", stated("mesh", [points], faces), text, flags=re.M)


def off(points, faces):
    """An OFF file from text: points and faces separated by `/`."""
    points, faces = [[w.split() for w in part.split("/") if w.strip()] for part in (points, faces)]
    rows = ["OFF", f"{len(points)} {len(faces)} 0"]
    rows += [" ".join(map(repr, map(float, p))) for p in points] + [" ".join(["3", *f]) for f in faces]
    text = "\n".join(rows) + "\n"
    return lambda _: text


def flip(line):
    """Flips the lowest bit of the first coordinate of the vertex `line` (counted from 0)."""
    def edit(text):
        rows = text.split("\n")
        x, *rest = rows[2 + line].split()
        bits = struct.unpack("<Q", struct.pack("<d", float(x)))[0] ^ 1
        rows[2 + line] = " ".join([repr(struct.unpack("<d", struct.pack("<Q", bits))[0]), *rest])
        return "\n".join(rows)
    return edit


def obj(text):
    points, faces = parse_off(text)
    rows = ["v " + " ".join(map(repr, points[i:i + 3])) for i in range(0, len(points), 3)]
    rows += ["f " + " ".join(str(v + 1) for v in faces[i:i + 3]) for i in range(0, len(faces), 3)]
    return "\n".join(rows) + "\n"


# ------------------------------------------------- rows
class Corpus:
    """Collects the files and the table; reads nothing but controls."""

    def __init__(self):
        self.files, self.rows, self.seen = {}, [], set()

    def control(self, name, part):
        return (HERE / name / part).read_bytes().decode("latin-1")

    def add(self, control, mutant, answer, what, *edits, files=None, inputs=None, facts=False, bound=True):
        """`answer` is what FORMAT.md asks for. `facts`: states true counts after the edits; `bound`: and true hashes
        of changed `files`. `inputs`: other files to give than the four."""
        try:
            text = self.control(control, "control.cert")
            meshes = {part: self.control(control, f"{part}.off") for part in INPUTS}
            for edit in edits:
                text = edit(text)
            for part, change in (files or {}).items():
                meshes[part] = change(meshes[part])
            if files and bound:
                text = rehash(text, meshes)
            if facts:
                text = recount(text)
        except (Misfit, ValueError, IndexError, OSError) as error:
            raise SystemExit(f"{control}/{mutant}: the edit does not fit the control: {error}")
        given = [f"{mutant}.{part}.off" if part in (files or {}) else f"{part}.off" for part in INPUTS]
        given = given if inputs is None else [given[INPUTS.index(i)] if i in INPUTS else i for i in inputs]
        self.store(control, mutant, answer, what, text, given, {f"{mutant}.{p}.off": meshes[p] for p in files or {}})

    def store(self, control, mutant, answer, what, text, given, changed):
        same = text == self.control(control, "control.cert")
        key = (control, text, tuple(given) if not changed else mutant)
        if key in self.seen or same and given == [f"{p}.off" for p in INPUTS]:
            raise SystemExit(f"{control}/{mutant} changes nothing")
        if any(self.control(control, name[len(mutant) + 1:]) == data for name, data in changed.items()):
            raise SystemExit(f"{control}/{mutant}: an input that is called changed is not")
        if f"{control}/{mutant}.cert" in self.files or not re.fullmatch("[a-z0-9-]+", mutant) or mutant == "control":
            raise SystemExit(f"{control}/{mutant}: bad or double name")
        self.seen.add(key)
        kind, _, code = answer.partition(" ")
        assert (kind == "valid") == (not code) and "\t" not in what, mutant
        self.files[f"{control}/{mutant}.cert"] = text.encode("latin-1")
        self.files.update((f"{control}/{name}", data.encode("latin-1")) for name, data in changed.items())
        names = "control" if given == [f"{p}.off" for p in INPUTS] else " ".join(given) or "none"
        self.rows.append("\t".join([control, mutant, names, str(EXIT[kind]), code or "-", what]))

    def table(self):
        return "".join(row + "\n" for row in [HEAD, *sorted(self.rows)])


def generated():
    """All files to write, by path below this directory."""
    import mutants_form
    import mutants_prisms
    import mutants_rules
    corpus = Corpus()
    mutants_form.add_all(corpus)
    mutants_rules.add_all(corpus)
    mutants_prisms.add_all(corpus)
    return {**corpus.files, "mutants.tsv": corpus.table().encode("ascii")}


def stored():
    controls = {"control.cert", *(f"{part}.off" for part in INPUTS)}
    return {name: p for name, p in corpus_files.stored(HERE, "mutants.tsv").items() if p.name not in controls}


def main():
    corpus_files.write(HERE, "mutants.tsv", generated(), stored())


if __name__ == "__main__":
    sys.modules["make_mutants"] = sys.modules["__main__"]
    sys.path.insert(0, str(HERE))
    sys.dont_write_bytecode = True
    main()
