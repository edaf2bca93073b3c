"""Both modes of the protocol of `homeo fuzz` (docs/SUBJECTS.md), for subjects in Python."""

import struct
import sys

ARITY = {
    "orient2d": 6, "orient3d": 12, "incircle": 8, "insphere": 15, "dot_sign": 15, "point_in_tet": 15,
    "triangle_triangle": 18, "segment_triangle": 15, "ray_triangle": 15, "prism_positivity": 18, "section_dot": 27,
}


def points(x, dimension=3):
    """Flat coordinates as points."""
    return [x[i : i + dimension] for i in range(0, len(x), dimension)]


def sign(value):
    """-1, 0, 1, or None for NaN."""
    if value != value:
        return None
    return (value > 0) - (value < 0)


def serve(predicates):
    """Answers until the input ends. `predicates` maps names to functions from a list of floats to -1, 0, 1 or None."""
    if "--binary" in sys.argv[1:]:
        serve_binary(predicates)
    else:
        serve_text(predicates)


def serve_text(predicates):
    for line in sys.stdin:
        name, *numbers = line.split()
        answer = "unsupported"
        if name in predicates:
            answer = predicates[name]([float.fromhex(x) for x in numbers])
        print("nan" if answer is None else answer, flush=True)


def serve_binary(predicates):
    source, sink = sys.stdin.buffer, sys.stdout.buffer
    while header := source.readline():
        name, count = header.decode("ascii").split()
        arity = ARITY[name]
        data = source.read(int(count) * arity * 8)
        answers = bytearray()
        for case in struct.iter_unpack(f"<{arity}d", data):
            answer = predicates[name](list(case)) if name in predicates else 3
            answers += struct.pack("b", 2 if answer is None else answer)
        sink.write(answers)
        sink.flush()
