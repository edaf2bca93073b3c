"""A subject whose faults are told by its arguments: MODE FAULT, MODE being text or binary."""

import struct
import sys
import time
from fractions import Fraction

mode, fault = sys.argv[1:]
answered = 0


def answer(x):
    """For orient2d; case faults are triggered by coordinates, so that they are found again."""
    global answered
    answered += 1
    if fault == "tired" and answered > 10:
        sys.exit(3)
    if x[0] > 0.75:
        if fault == "crash":
            sys.exit(3)
        if fault == "hang":
            time.sleep(60)
        if fault == "drip":
            while True:
                print("1", end="", flush=True)
                time.sleep(0.2)
        if fault == "bad":
            return 77
        if fault == "nan":
            return 2
        if fault == "wrong":
            return 1
    if fault == "partly" and x[0] < 0:
        return 3
    a, b, c, d, e, f = map(Fraction, x)
    det = (c - a) * (f - b) - (d - b) * (e - a)
    return (det > 0) - (det < 0)


if fault == "mute":
    print("no words", file=sys.stderr, flush=True)
    sys.exit(1)
if mode == "text":
    for line in sys.stdin:
        name, *x = line.split()
        said = answer([float.fromhex(v) for v in x]) if name == "orient2d" else 3
        print({2: "nan", 3: "unsupported", 77: "perhaps"}.get(said, said), flush=True)
        if fault == "chatty":
            print("0", flush=True)
else:
    while header := sys.stdin.buffer.readline():
        name, count = header.decode().split()
        cases = struct.iter_unpack("<6d", sys.stdin.buffer.read(int(count) * 48))
        sys.stdout.buffer.write(bytes(answer(x) & 255 for x in cases))
        sys.stdout.buffer.flush()
if fault == "afterthought":
    sys.stdout.write("1\n")
