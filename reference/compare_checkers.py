#!/usr/bin/env python3
"""Looks for files that the two checkers answer differently: python3 compare_checkers.py HOMEO_CHECK [options]

Takes certificates and inputs of certs/corpus or invents small ones (invent.py), changes them at random (bytes, tokens,
lines, coordinates, faces, or as distort.py says; most often with counts and hashes made right again, so that the rules
are reached), and compares exit code, error code and claims of the Rust program HOMEO_CHECK and of check.py. A difference
is made small and printed.
Exit code: 0 none found, 1 differences, 2 usage.
"""
import argparse
import collections
import pathlib
import random
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
CORPUS = HERE.parent / "certs" / "corpus"
sys.path[:0] = [str(HERE), str(CORPUS)]
sys.dont_write_bytecode = True

import check  # noqa: E402  the path is set above
import distort  # noqa: E402
import invent  # noqa: E402
import make_mutants  # noqa: E402

INPUTS = make_mutants.INPUTS
SPECIAL = ["0", "1", "-1", "2", "3", "4", "9999999999", "10000000000", "00", "-0", "1*2^1", "3*2^-1", "1*2^99999", "end", "",
           "m0", "t0", "b1", "m0,m1", "m0,m1,m2,t2", "m0,m1,t1,t2", "l:g0,g1", "n:g0,g2", "p:m0,m1,t2", "9" * 4001]
COORDINATES = ["0.0", "-0.0", "1.0", "-1.0", "0.5", "2.0", "1e-3", "5e-324", "1e308", "1E1", "+.5", "3.", "nan", "0.25", "1e400"]


# ------------------------------------------------- the two answers
class Pair:
    """Runs both checkers on a certificate and its inputs, given as bytes."""

    def __init__(self, program, folder):
        self.program, self.folder, self.cases, self.answers = program, pathlib.Path(folder), 0, collections.Counter()

    def ask(self, case):
        paths = []
        for name, data in zip(["cert", *INPUTS], case):
            if data is not None:
                paths.append(str(self.folder / name))
                pathlib.Path(paths[-1]).write_bytes(data)
        run = subprocess.run([self.program, *paths], capture_output=True, check=False)
        rust = answer(run.returncode, run.stdout.decode("ascii", "replace").rstrip("\n"))
        python = answer(*check.run(paths))
        self.cases += 1
        self.answers[python[1]] += 1
        return rust, python


def answer(status, text):
    head, *claims = text.split("\n")
    return status, head.split(" : ")[0], tuple(claims)


# ------------------------------------------------- changes
def change_bytes(rng, data):
    at = rng.randrange(len(data) + 1)
    kind = rng.randrange(4)
    if kind == 0:
        return data[:at] + bytes([rng.choice(b"\0\t\r\n 0123456789-,:bmtg#*^\x80")]) + data[at:]
    if kind == 1:
        return data[:at] + data[at + rng.choice([1, 1, 2, 9]):]
    if kind == 2 and at < len(data):
        return data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1:]
    return data[:at]


def change_lines(rng, rows, others):
    a, b = rng.randrange(len(rows)), rng.randrange(len(rows))
    kind = rng.randrange(5)
    rows = list(rows)
    if kind == 0:
        del rows[a]
    elif kind == 1:
        rows.insert(b, rows[a])
    elif kind == 2:
        rows[a], rows[b] = rows[b], rows[a]
    elif kind == 3:
        a = min(a, len(rows) - 2)
        rows[a:a + 2] = rows[a + 1:a - 1:-1] if a else rows[1::-1]
    else:
        rows.insert(a, rng.choice(others))
    return rows


def change_number(rng, text):
    """Another value of the first number in a token."""
    start = next((i for i, c in enumerate(text) if c.isdigit()), None)
    if start is None:
        return rng.choice(SPECIAL)
    stop = next((i for i in range(start, len(text)) if not text[i].isdigit()), len(text))
    number = int(text[start:stop][:20]) + rng.choice([-2, -1, 1, 1, 2, 7])
    return text[:start] + str(number) + text[stop:]


def change_token(rng, rows):
    """One token of a line: another number, another layer, the token of a like line, a part left out, twice, or swapped."""
    rows = list(rows)
    at = rng.randrange(len(rows))
    tokens = rows[at].split(" ")
    i = rng.randrange(len(tokens))
    kind = rng.randrange(8)
    like = [t for r in rows if r.split(" ")[0] == tokens[0] for t in [r.split(" ")] if len(t) > i]
    if kind <= 1:
        parts = tokens[i].split(",")
        k = rng.randrange(len(parts))
        parts[k] = change_number(rng, parts[k])
        tokens[i] = ",".join(sorted(parts) if kind and len(parts) > 1 else parts)
    elif kind == 2 and any(c in tokens[i] for c in "bmt"):
        letter = rng.choice([c for c in tokens[i] if c in "bmt"])
        tokens[i] = tokens[i].replace(letter, rng.choice("bmt"), 1)
    elif kind <= 4 and like:
        tokens[i] = rng.choice(like)[i]
    elif kind == 5:
        j = rng.randrange(len(tokens))
        tokens[i], tokens[j] = tokens[j], tokens[i]
    elif kind == 6:
        tokens[i:i + 1] = rng.choice([[], [tokens[i], tokens[i]], [rng.choice(SPECIAL)]])
    else:
        words = {"certified": "refuted", "refuted": "certified", "mesh": "middle", "middle": "mesh"}
        reasons = ["cap", "wall", "boundary", "fold", "lands", "twice", "monodromy"]
        tokens[i] = words.get(tokens[i], rng.choice(reasons) if tokens[i] in reasons else rng.choice(SPECIAL))
    rows[at] = " ".join(tokens)
    return rows


def change_input(rng, text):
    """A coordinate or an index of an OFF file."""
    rows = text.split("\n")
    points, faces = map(int, rows[1].split()[:2])
    at = 2 + (rng.randrange(points) if rng.random() < 0.75 or not faces else points + rng.randrange(faces))
    tokens = rows[at].split(" ")
    i = rng.randrange(len(tokens))
    if at >= 2 + points:
        tokens[i] = str(rng.randrange(points)) if i else rng.choice("34")
    else:
        value = float(tokens[i])
        near = [value + rng.choice([-2.0, -1.0, -0.5, 0.125, 0.25, 1.0, 2.0, 1e-9]), -value, value * 2, rng.choice(list(tokens))]
        tokens[i] = str(rng.choice(near)) if rng.random() < 0.85 else rng.choice(COORDINATES)
    rows[at] = " ".join(tokens)
    return "\n".join(rows)


def move_vertex(rng, meshes):
    """A vertex of one input onto a vertex of any input: points that touch, flat tets, pinched vertices."""
    texts = [mesh.decode("latin-1").split("\n") for mesh in meshes]
    place = lambda rows: 2 + rng.randrange(int(rows[1].split()[0]))
    target, source = rng.choice(texts), rng.choice(texts)
    at = place(target)
    target[at] = source[at if rng.random() < 0.5 and at < len(source) else place(source)]
    return ["\n".join(rows).encode("latin-1") for rows in texts]


def scale(rng, meshes):
    """All coordinates times one number, or moved by one: longer numbers, the same shapes."""
    factor, shift = rng.choice([(2.0 ** 60, 0.0), (2.0 ** -300, 0.0), (0.1, 0.0), (1 / 3, 0.0), (-1.0, 0.0), (1.0, 1e6), (1.0, 1e-7)])
    out = []
    for mesh in meshes:
        rows = mesh.decode("latin-1").split("\n")
        for i in range(2, 2 + int(rows[1].split()[0])):
            rows[i] = " ".join(repr(float(x) * factor + shift) for x in rows[i].split())
        out.append("\n".join(rows).encode("latin-1"))
    return out


def mutate(rng, case, others):
    """Some changes of a case (certificate, four inputs); most often with counts and hashes made right again."""
    cert, *meshes = case
    if None not in meshes and rng.random() < 0.5:
        cert, meshes = distorted(rng, cert, meshes)
        if rng.random() < 0.7:
            return fit(rng, (cert, *meshes), 0.98)
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        kind = rng.random()
        try:
            if kind < 0.05:
                cert = change_bytes(rng, cert)
            elif kind < 0.65:
                rows = cert.decode("latin-1").split("\n")[:-1] or [""]
                rows = change_token(rng, rows) if kind < 0.4 else change_lines(rng, rows, others)
                cert = ("\n".join(rows) + "\n").encode("latin-1")
            elif kind < 0.8 and None not in meshes:
                meshes = move_vertex(rng, meshes) if kind < 0.75 else scale(rng, meshes)
            else:
                i = rng.randrange(4)
                if meshes[i] is not None:
                    meshes[i] = change_input(rng, meshes[i].decode("latin-1")).encode("latin-1")
                if rng.random() < 0.03:
                    meshes[i] = change_bytes(rng, meshes[i])
        except (ValueError, IndexError, TypeError):
            continue  # an earlier change has left nothing to change here
    return fit(rng, (cert, *meshes))


def distorted(rng, cert, meshes):
    """One or two changes after which the certificate may still be valid."""
    for _ in range(rng.choice([1, 1, 2])):
        kind = rng.random()
        try:
            if kind < 0.35 and b"\nbegin overlay\n" in cert:
                cert = distort.overlay(rng, cert)
            elif kind < 0.7:
                meshes = distort.coordinates(rng, meshes)
            elif kind < 0.85:
                meshes = distort.faces(rng, meshes)
            else:
                cert, meshes = distort.vertices(rng, cert, meshes)
        except (ValueError, IndexError, OverflowError):
            continue  # an input of the corpus that is no regular file, or nothing is left to change
    return cert, meshes


def fit(rng, case, often=0.9):
    """Makes counts and hashes right, most often."""
    cert, *meshes = case
    if rng.random() < often:
        cert = again(cert, make_mutants.recount)
    if rng.random() < often and None not in meshes:
        text = {name: mesh.decode("latin-1") for name, mesh in zip(INPUTS, meshes)}
        if any(len(t) < 5 for t in text.values()):
            return (cert, *meshes)
        cert = again(cert, lambda c: make_mutants.rehash(c, text))
    return (cert, *meshes)


def again(cert, repair):
    try:
        return repair(cert.decode("latin-1")).encode("latin-1")
    except Exception:  # noqa: BLE001  a file too far from one that could be repaired stays as it is
        return cert


def fits_grammar(cert):
    try:
        check.Certificate(cert)
    except check.Stop as stop:
        return stop.args[1] != "syntax"
    except Exception:  # noqa: BLE001  to be found by the comparison
        return True
    return True


# ------------------------------------------------- small examples
def minimise(pair, case, original, found, tries=300):
    """Drops lines and gives inputs back while both checkers answer as they did."""
    def same(candidate):
        nonlocal tries
        tries -= 1
        return tries >= 0 and pair.ask(candidate) == found

    for i in range(1, 5):
        candidate = (*case[:i], original[i], *case[i + 1:])
        for cert in (case[0], original[0]):
            if candidate[i] != case[i] and same((cert, *candidate[1:])):
                case = (cert, *candidate[1:])
                break
    size = max(1, case[0].count(b"\n") // 2)
    while size and tries > 0:
        rows, at = case[0].split(b"\n"), 0
        while at < len(rows):
            shorter = b"\n".join(rows[:at] + rows[at + size:])
            for cert in (again(shorter, make_mutants.recount), shorter):
                if same((cert, *case[1:])):
                    case, rows = (cert, *case[1:]), cert.split(b"\n")
                    break
            else:
                at += size
        size //= 2
    return case


def show(case, original, found, name):
    rust, python = found
    print(f"DIFFERENCE, from {name}\n  homeo-check: {rust[0]} {rust[1]}\n  check.py:    {python[0]} {python[1]}")
    for line in case[0].decode("latin-1").split("\n")[:60]:
        print("  | " + line[:200].encode("unicode_escape").decode("ascii"))
    for part, new, old in zip(INPUTS, case[1:], original[1:]):
        if new != old:
            print(f"  with {part}: {new!r}")


# ------------------------------------------------- cases
def load(also=None):
    """Cases to start from: the controls, the accepted rows and the invalid ones, as (name, case); controls come first."""
    cases = []
    for line in (CORPUS / "mutants.tsv").read_text("ascii").splitlines()[1:]:
        control, mutant, inputs, status, _, _ = line.split("\t")
        names = [f"{part}.off" for part in INPUTS] if inputs == "control" else inputs.split(" ")
        if status in "01" and len(names) in (3, 4):
            cases.append((control, mutant, names))
    controls = [(p.parent.name, "control", [f"{part}.off" for part in INPUTS]) for p in CORPUS.glob("*/control.cert")]
    controls += [(p.parent, "control", [f"{part}.off" for part in INPUTS]) for p in pathlib.Path(also).glob("*/control.cert")] if also else []
    found = []
    for control, mutant, names in sorted(controls, key=str) + cases:
        parts = [(CORPUS / control / name).read_bytes() for name in [f"{mutant}.cert", *names]]
        found.append((f"{control}/{mutant}", tuple(parts + [None] * (5 - len(parts)))))
    return found, len(controls)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", help="path of the homeo-check program")
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most", type=int, default=5, help="stop after so many different kinds of difference")
    parser.add_argument("--also", help="a folder of further controls: `*/control.cert` with the four OFF files beside it")
    parser.add_argument("--save", help="a folder for the small examples")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    cases, controls = load(options.also)
    others = sorted({line for name, case in cases[:controls] for line in case[0].decode("latin-1").split("\n")[:400]})
    stop, kinds = time.monotonic() + options.seconds, {}
    with tempfile.TemporaryDirectory() as folder:
        pair = Pair(options.program, folder)
        while time.monotonic() < stop and len(kinds) < options.most:
            name, original = cases[rng.randrange(controls)] if rng.random() < 0.6 else rng.choice(cases)
            if rng.random() < 0.25:
                name, original = "invent.py", invent.invent(rng)
            if name.startswith("ball/") and rng.random() < 0.9:
                continue  # slow
            case = original if name == "invent.py" and rng.random() < 0.5 else mutate(rng, original, others)
            if rng.random() < 0.8 and not fits_grammar(case[0]):
                continue  # most changes break the grammar; a part of those is enough
            found = pair.ask(case)
            key = found[0][:2], found[1][:2]
            if found[0] != found[1] and key not in kinds:
                small = kinds[key] = minimise(pair, case, original, found)
                show(small, original, found, name)
                if options.save:
                    target = pathlib.Path(options.save) / f"difference{len(kinds)}"
                    target.mkdir(parents=True, exist_ok=True)
                    for part, data in zip(["cert", *INPUTS], small):
                        if data is not None:
                            (target / part).write_bytes(data)
    reached = ", ".join(f"{text} {count}" for text, count in pair.answers.most_common())
    print(f"seed {options.seed}: {pair.cases} cases, {len(kinds)} kinds of difference\n{reached}")
    return 1 if kinds else 0


if __name__ == "__main__":
    sys.exit(main())
