#!/usr/bin/env python3
"""Looks for certificates about meshes that the two checkers answer differently: python3 compare_meshes.py HOMEO_CHECK [options]

Takes the certificates of certs/corpus-meshes with their inputs, changes them at random (tokens, lines, coordinates, cells;
most often with counts and hashes made right again, so that the rules are reached), and compares exit code, error code and
claim of the Rust program and of check_meshes.py. Exit code: 0 none found, 1 differences.
"""
import argparse
import collections
import hashlib
import pathlib
import random
import re
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
CORPUS = HERE.parent / "certs" / "corpus-meshes"
sys.path[:0] = [str(HERE), str(CORPUS)]
sys.dont_write_bytecode = True

import subprocess  # noqa: E402

import check_meshes  # noqa: E402
import compare_checkers as other  # noqa: E402
import make  # noqa: E402

NUMBERS = ["0", "1", "-1", "3", "1*2^1", "-1*2^-1", "1/3", "-2/7", "5", "3*2^-2", "1*2^-1074", "2", "1/2", "7*2^40"]
TOKENS = ["0", "1", "2", "7", "a", "b", "ab", "-1", "a0", "b0", "l:a0,a1", "n:b0,b2", "p:a0,a1,a2", "0,1", "1,2,3", "9" * 4001, ""]


class Case:
    def __init__(self, cert, inputs):
        self.cert, self.inputs = cert, inputs  # text; {letter: complex file's text}


def load():
    cases = []
    for line in (CORPUS / "table.tsv").read_text("ascii").splitlines()[1:]:
        control, mutant, names, status, _, _ = line.split("\t")
        names = names.split(" ")
        if status not in "01" or not all((CORPUS / control / name).exists() for name in names):
            continue
        cert, inputs = (CORPUS / control / f"{mutant}.cert").read_text("ascii"), {}
        for x, name in zip("ab", names):
            data = (CORPUS / control / name).read_bytes()
            if not data.startswith(b"homeo-complex"):
                points, cells = check_meshes.read_mesh(data)
                data = "".join(check_meshes.canonical(points, cells)).encode()
            inputs[x] = data.decode("ascii")
        cases.append((f"{control}/{mutant}", Case(cert, inputs)))
    return cases


def change_complex(rng, text):
    """A coordinate, a point, a cell's corner or order, a cell dropped or added."""
    rows = text.split("\n")
    n, head = int(rows[3].split()[1]), 4
    m, base = int(rows[head + n].split()[1]), head + n + 1
    kind = rng.random()
    if kind < 0.35:
        at = head + rng.randrange(n)
        tokens = rows[at].split(" ")
        tokens[rng.randrange(len(tokens))] = rng.choice(NUMBERS + tokens + rows[head + rng.randrange(n)].split(" "))
        rows[at] = " ".join(tokens)
    elif kind < 0.6:
        rows[head + rng.randrange(n)] = rows[head + rng.randrange(n)]
    elif m and kind < 0.75:
        at = base + rng.randrange(m)
        tokens = rows[at].split(" ")
        i, j = rng.randrange(len(tokens)), rng.randrange(len(tokens))
        if rng.random() < 0.5:
            tokens[i], tokens[j] = tokens[j], tokens[i]
        else:
            tokens[i] = str(rng.randrange(n))
        rows[at] = " ".join(tokens)
    elif m and kind < 0.9:
        del rows[base + rng.randrange(m)]
        rows[base - 1] = f"cells {m - 1}"
    elif m:
        rows.insert(base, rows[base + rng.randrange(m)])
        rows[base - 1] = f"cells {m + 1}"
    return "\n".join(rows)


def change_cert(rng, text):
    rows = text.split("\n")[:-1]
    kind, at = rng.random(), rng.randrange(1, len(rows))
    tokens = rows[at].split(" ")
    i = rng.randrange(len(tokens))
    if kind < 0.3:
        parts = tokens[i].split(",")
        k = rng.randrange(len(parts))
        parts[k] = other.change_number(rng, parts[k])
        tokens[i] = ",".join(parts)
    elif kind < 0.4:
        tokens[i] = rng.choice(TOKENS)
    elif kind < 0.5:
        j = rng.randrange(len(tokens))
        tokens[i], tokens[j] = tokens[j], tokens[i]
    elif kind < 0.6:
        del tokens[i]
    elif kind < 0.7:
        like = [r.split(" ") for r in rows if r.split(" ")[0] == tokens[0]]
        tokens[i] = (rng.choice(like) + tokens)[i]
    elif kind < 0.8 and len(rows) > 3:
        del rows[at]
        return "\n".join(rows) + "\n"
    elif kind < 0.9:
        rows.insert(at, rows[rng.randrange(1, len(rows))])
        return "\n".join(rows) + "\n"
    else:
        swaps = {"a": "b", "b": "a", "certified": "refuted", "refuted": "certified"}
        tokens = [swaps.get(t, t) if rng.random() < 0.5 else t for t in tokens]
    rows[at] = " ".join(tokens)
    return "\n".join(rows) + "\n"


def mutate(rng, case):
    cert, inputs = case.cert, dict(case.inputs)
    for _ in range(rng.choice([1, 1, 2, 3])):
        try:
            if rng.random() < 0.5:
                cert = change_cert(rng, cert)
            else:
                x = rng.choice(sorted(inputs))
                inputs[x] = change_complex(rng, inputs[x])
                if "pl-homeo" in cert and len(inputs) == 2 and rng.random() < 0.9:  # the cells must be the same
                    y = "ab".replace(x, "")
                    cells = inputs[x].split("\ncells ")[1]
                    inputs[y] = inputs[y].split("\ncells ")[0] + "\ncells " + cells
        except (ValueError, IndexError):
            continue
    if rng.random() < 0.9:
        for x, text in inputs.items():
            cert = re.sub(f"^input {x} [0-9a-f]{{64}}(.*) [0-9]+$",
                          lambda f: f"input {x} {hashlib.sha256(text.encode()).hexdigest()}{f[1]} {text.split(chr(10) + 'cells ')[1].split(chr(10))[0]}",
                          cert, flags=re.M)
    if rng.random() < 0.9:
        try:
            cert = make.recount(cert)
        except (IndexError, ValueError):
            pass
    return Case(cert, inputs)


def ask(program, folder, case):
    paths = [str(folder / "cert"), *(str(folder / x) for x in case.inputs)]
    for path, text in zip(paths, [case.cert, *case.inputs.values()]):
        pathlib.Path(path).write_text(text, "latin-1", newline="\n")
    run = subprocess.run([program, *paths], capture_output=True, check=False)
    return other.answer(run.returncode, run.stdout.decode("ascii", "replace").rstrip("\n")), other.answer(*check_meshes.run(paths))


def fits_grammar(cert):
    try:
        check_meshes.Certificate(cert.encode("latin-1"))
    except check_meshes.Stop as stop:
        return stop.args[1] != "syntax"
    except Exception:  # noqa: BLE001  to be found by the comparison
        return True
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program", help="path of the homeo-check program")
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng, cases = random.Random(options.seed), load()
    stop, many, different, answers = time.monotonic() + options.seconds, 0, 0, collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        while time.monotonic() < stop and different < 5:
            name, original = rng.choice(cases)
            case = mutate(rng, original)
            if rng.random() < 0.85 and not fits_grammar(case.cert):
                continue  # most changes break the grammar; a part of those is enough
            rust, python = ask(options.program, pathlib.Path(folder), case)
            many += 1
            answers[python[1]] += 1
            if rust != python:
                different += 1
                print(f"DIFFERENCE, from {name}\n  homeo-check:     {rust}\n  check_meshes.py: {python}\n{case.cert[:2000]}")
                for x, text in case.inputs.items():
                    if text != original.inputs[x]:
                        print(f"  with {x}: {text!r}")
    print(f"seed {options.seed}: {many} cases, {different} differences\n" + ", ".join(f"{a} {n}" for a, n in answers.most_common()))
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
