"""What the generators of both corpora share: edits of text, true counts, and writing the files."""
import re
import sys

EXIT = {"valid": 0, "invalid": 1, "malformed": 2, "limit": 3}
HEAD = "control\tmutant\tinputs\texit\tcode\twhat"
BIG = "9" * 4001  # a digit more than the limit


class Misfit(Exception):
    """An edit that does not fit its control any more."""


def swap(old, new):
    """Replaces the one place where `old` stands."""
    def edit(text):
        if text.count(old) != 1:
            raise Misfit(f"{old!r} stands {text.count(old)} times")
        return text.replace(old, new)
    return edit


def recount(text):
    """States the true number of fact lines of each block."""
    counts = []
    for line in text.split("\n"):
        if line.startswith("begin "):
            counts.append(0)
        elif line.startswith("counts"):
            break
        elif counts:
            counts[-1] += 1
    return re.sub("^counts.*$", " ".join(["counts", *map(str, counts)]), text, flags=re.M)


def about(add, control, **given):
    """`add` where the control and these settings need not be said."""
    def m(name, answer, what, *edits, control=control, **more):
        add(control, name, answer, what, *edits, **{**given, **more})
    return m


def stored(here, table):
    """The files of a corpus by path below its directory."""
    found = {str(p.relative_to(here)): p for p in here.glob("*/*") if p.parent.name != "__pycache__"}
    return {**found, **({table: here / table} if (here / table).exists() else {})}


def write(here, table, new, old):
    """Makes the files `old` (by path below `here`) those of `new`; with `--check`, fails unless they are."""
    stale = sorted(old.keys() - new.keys())
    changed = sorted(name for name in new if name not in old or old[name].read_bytes() != new[name])
    if "--check" in sys.argv[1:]:
        if stale or changed:
            raise SystemExit(f"not generated: {stale}; to write again: {changed}")
        return
    for name in stale:
        old[name].unlink()
    for name in changed:
        (here / name).parent.mkdir(exist_ok=True)
        (here / name).write_bytes(new[name])
    print(f"{len(new[table].splitlines()) - 1} rows, {len(changed)} files written, {len(stale)} removed")
