#!/usr/bin/env python3
"""Audits every third-party pair, cage and tet map of the test data and prints one table (`just audit-zoo`).

python3 audit_zoo.py HOMEO HOMEO_CHECK DATA OUT [--time-limit SECONDS] [--python-limit SECONDS] [--only WORD]

Both checkers judge every document of every audit. The table goes to standard output and, as zoo.csv and zoo.json, to OUT.
"""
import argparse, csv, json, os, subprocess, sys, time

HERE = os.path.dirname(os.path.abspath(__file__))
PAIRS = [  # name, tool, original, remeshed
    ("fandisk_qem2k", "MeshLab (quadric edge collapse)", "surface/fandisk.obj", "pairs/fandisk_qem2k.obj"),
    ("bunny_igl1000", "libigl (decimate)", "surface/bunny.off", "pairs/bunny_igl1000.obj"),
    ("cheburashka_cgaliso", "CGAL (isotropic remeshing)", "surface/cheburashka.off", "pairs/cheburashka_cgaliso.off"),
    ("turbine_mo10", "meshoptimizer (simplify)", "surface/turbine.off", "pairs/turbine_mo10.obj"),
    ("turbine_mosloppy10", "meshoptimizer (sloppy)", "surface/turbine.off", "pairs/turbine_mosloppy10.obj"),
    ("armadillo_acvd3000", "pyacvd (clustering)", "surface/armadillo.off", "pairs/armadillo_acvd3000.obj"),
    ("dino_ftetwild", "fTetWild (boundary)", "surface/dino.off", "pairs/dino_ftetwild.obj"),
    ("skull_author_lowres", "author's low resolution", "surface/skull.obj", "pairs/skull_author_lowres.obj"),
    ("fsaverage5_left", "FreeSurfer (white, pial)", "pairs/white_left.gii.gz", "pairs/pial_left.gii.gz"),
]
CAGES = [  # name, tool, mesh, cage; in thirdparty/cages
    ("gargo_volume_1", "nested-cages", "gargo_1000r_500r_None_Volume_0.off", "gargo_1000r_500r_None_Volume_1.off"),
    ("gargo_volume_2", "nested-cages", "gargo_1000r_500r_None_Volume_1.off", "gargo_1000r_500r_None_Volume_2.off"),
    ("gargo_adaptive_1", "nested-cages", "gargo_1000a_None_Volume_0.off", "gargo_1000a_None_Volume_1.off"),
    ("twocomp", "nested-cages", "twocomp_0.off", "twocomp_1.off"),
    *((f"gargo_lazy{n}", "gpytoolbox (lazy cage)", "gargo_1000r_500r_None_Volume_0.off", f"gargo_lazy{n}.off")
      for n in (1000, 500, 100)),
]
MAPS = [  # name, tool, arguments; in thirdparty/tetmaps (or pairs)
    ("example", "GalaxyMaps", ["example_object.vtk", "example_parameter.vtk"]),
    ("example_rational", "GalaxyMaps", ["example_object.vtk", "example_rational.txt"]),
    ("rockerarm", "GalaxyMaps", ["cub_rockerarm291_object.vtk", "cub_rockerarm291_parameter.vtk"]),
    ("rockerarm_rational", "GalaxyMaps", ["cub_rockerarm291_object.vtk", "cub_rockerarm291_rational.txt"]),
    ("83715_exact", "expansion-cones", ["thingi10k_83715_tet_codomain.ovm"]),
    ("83715_rounded", "expansion-cones",
     ["thingi10k_83715_tet_codomain.ovm", "--b-positions", "vertices"]),
    ("fsaverage5_left_map", "FreeSurfer (white, pial)", ["../../pairs/white_left.gii.gz", "../../pairs/pial_left.gii.gz"]),
]


def timed(command, limit=None, cwd=None):
    """(exit code or None, first line of output, all output, seconds)"""
    start = time.time()
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=cwd, timeout=limit)
        code, text = done.returncode, done.stdout.decode(errors="replace") or done.stderr.decode(errors="replace")
    except subprocess.TimeoutExpired:
        code, text = None, f"no answer in {limit} s"
    return code, text.strip().split("\n")[0], text, time.time() - start


def check(args, folder, documents):
    """Both checkers on documents (lists of file names); (all valid, seconds) for each checker."""
    seconds, verdicts = [0.0, 0.0], [[], []]
    for arguments in documents:
        if arguments[0] == "compose":
            python = "check_compose.py"
            given = arguments[1:]
        else:
            with open(os.path.join(folder, arguments[0]), "rb") as file:
                python = "check_meshes.py" if file.readline() == b"homeo-meshes 1\n" else "check.py"
            given = arguments
        commands = [[args.check, *arguments], [sys.executable, os.path.join(HERE, python), *given]]
        for k, (command, limit) in enumerate(zip(commands, (None, args.python_limit))):
            _, first, _, spent = timed(command, limit, folder)
            seconds[k] += spent
            verdicts[k].append(first)
    words = []
    for found in verdicts:
        odd = sorted({v for v in found if v != "valid"})
        words.append("; ".join(odd) if odd else f"{len(found)} valid")
    return words, seconds


def row(kind, name, tool, verdict, size, spent, checked, note):
    words, seconds = checked
    return {"kind": kind, "name": name, "tool": tool, "verdict": verdict, "proof_bytes": size, "audit_seconds": round(spent, 2),
            "rust_checker": words[0], "rust_seconds": round(seconds[0], 2),
            "python_checker": words[1], "python_seconds": round(seconds[1], 2), "note": note}


def audit(args, kind, name, tool, files):
    folder = os.path.join(args.out, name)
    options = ["--cage"] if kind == "cage" else ["--time-limit", str(args.time_limit)] if args.time_limit else []
    command = [args.homeo, "audit", *options, *files, "-o", folder, "-q"]
    code, first, text, spent = timed(command)
    if code not in (0, 1):
        return row(kind, name, tool, "error", 0, spent, (["", ""], [0, 0]), first)
    with open(os.path.join(folder, "audit.json")) as file:
        report = json.load(file)
    documents = [d["arguments"] for d in report["documents"]]
    size = sum(d["bytes"] for d in report["documents"])
    if kind == "cage":
        note = report["reasons"][0][0] if report["reasons"] else f"topological condition: {report['topology']}"
    else:
        tried = [a["name"] for a in report["attempts"]]
        note = f"tries: {', '.join(tried)}" if tried else report["summary"]
        for survey in (report["attempts"] or [{"surveys": []}])[-1]["surveys"]:
            note += f"; {survey['mesh']}: {100 * survey['clean_area_share']:.2f} % clean"
    if report["verdict"] == "bijective":
        documents.append(["compose", "a.cert", "b.cert", "shell.h5", "a.off", "b.off"])
    return row(kind, name, tool, report["verdict"], size, spent, check(args, folder, documents), note)


def tet_map(args, name, tool, arguments):
    folder, data = os.path.join(args.out, name), os.path.join(args.data, "thirdparty/tetmaps")
    os.makedirs(folder, exist_ok=True)
    files = [a if a.startswith("--") or "." not in a else os.path.join(data, a) for a in arguments]
    cert = os.path.join(folder, "map.cert")
    code, first, text, spent = timed([args.homeo, "map", *files, "-o", cert, "--write-inputs", folder, "-q"])
    if code not in (0, 1):
        return row("map", name, tool, "error", 0, spent, (["", ""], [0, 0]), first)
    checked = check(args, folder, [["map.cert", "a.complex", "b.complex"]])
    return row("map", name, tool, ["certified", "refuted"][code], os.path.getsize(cert), spent, checked, first)


def table(rows):
    """A Markdown table."""
    head = "| kind | name | tool | verdict | proof bytes | audit s | checker | s | Python | s | note |"
    lines = ["| " + " | ".join(str(x).replace("|", "/") for x in r.values()) + " |" for r in rows]
    return "\n".join([head, "|---" * 11 + "|", *lines])


def keep(rows, folder):
    """Puts the table between its marks in RESULTS.md, as the programs of benches/ do, and all columns into files beside it."""
    with open(os.path.join(folder, "audit-zoo.json"), "w") as file:
        json.dump(rows, file, indent=1)
    with open(os.path.join(folder, "audit-zoo.csv"), "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    path, marks = os.path.join(folder, "RESULTS.md"), [f"<!-- audit-zoo: {edge} -->" for edge in ("begin", "end")]
    old = "# Results\n"
    if os.path.exists(path):
        with open(path) as file:
            old = file.read()
    text = "## Third-party results\n\nWritten by `just audit-zoo`, never by hand. Seconds hold for one machine and its load."
    new = f"{marks[0]}\n{text}\n\n{table(rows)}\n{marks[1]}"
    if all(mark in old for mark in marks):
        new = old[: old.index(marks[0])] + new + old[old.index(marks[1]) + len(marks[1]) :]
    else:
        new = old.rstrip() + "\n\n" + new + "\n"
    with open(path, "w") as file:
        file.write(new)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("homeo", "check", "data", "out"):
        parser.add_argument(name, type=os.path.abspath)
    parser.add_argument("--time-limit", type=int, help="of each optimisation")
    parser.add_argument("--python-limit", type=int, default=3600, help="of the Python checker for one document")
    parser.add_argument("--results", help="folder of RESULTS.md, where a whole run leaves its table")
    parser.add_argument("--only", default="", help="kinds or names that contain this")
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    cages = os.path.join(args.data, "thirdparty/cages")
    jobs = [("pair", n, t, [os.path.join(args.data, f) for f in (a, b)]) for n, t, a, b in PAIRS]
    jobs += [("cage", n, t, [os.path.join(cages, cage), os.path.join(cages, mesh)]) for n, t, mesh, cage in CAGES]
    jobs += [("map", n, t, files) for n, t, files in MAPS]
    rows = []
    print(table([]), flush=True)
    for kind, name, tool, files in jobs:
        if args.only not in f"{kind} {name}":
            continue
        found = tet_map(args, name, tool, files) if kind == "map" else audit(args, kind, name, tool, files)
        rows.append(found)
        print(table([found]).split("\n")[2], flush=True)
        keep(rows, args.out)
    if args.results and not args.only:
        keep(rows, args.results)
    bad = [r for r in rows if r["verdict"] == "error" or not all(r[k].endswith("valid") for k in ("rust_checker", "python_checker"))]
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
