"""Line coverage of folders against goals, from the reports of cargo-llvm-cov (--json).

    python3 reference/coverage.py REPORT.json FOLDER=PERCENT... [REPORT.json FOLDER=PERCENT...]...

Prints every file below its folder's goal, then the folder's total. Files of tests count nowhere. Exit 1 if a total is below
its goal, 2 if a report has no lines of a folder.
"""

import json
import os
import re
import sys

TESTS = re.compile(r"(^|/)(tests?|testing)/|(^|[/_])tests?\.rs$")


def lines(report):
    """Path, lines covered, lines in all, of every file that is no test."""
    with open(report, encoding="utf-8") as file:
        files = [f for part in json.load(file)["data"] for f in part["files"]]
    for entry in files:
        path = os.path.relpath(entry["filename"])
        if not TESTS.search(path):
            counts = entry["summary"]["lines"]
            yield path, counts["covered"], counts["count"]


def show(name, covered, count, goal):
    print(f"{name:44} {covered:6} of {count:6} lines  {100 * covered / count:6.2f} %  goal {goal} %")


def main(arguments):
    found, code = [], 0
    for argument in arguments:
        folder, equals, goal = argument.partition("=")
        if not equals:
            found = list(lines(argument))
            continue
        goal = int(goal)
        below = [f for f in found if f[0].startswith(folder + "/")]
        covered, count = (sum(f[i] for f in below) for i in (1, 2))
        if count == 0:
            print(f"{folder}: the report has no lines of it", file=sys.stderr)
            return 2
        for path, some, all_of in sorted(below, key=lambda f: f[1] / max(f[2], 1)):
            if 100 * some < goal * all_of:
                show("  " + path, some, all_of, goal)
        reached = 100 * covered >= goal * count
        show(folder, covered, count, goal)
        if not reached:
            print(f"{folder}: below its goal", file=sys.stderr)
            code = 1
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
