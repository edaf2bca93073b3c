#!/usr/bin/env python3
"""Do two certificates together prove a homeomorphism from A to B? python3 check_compose.py A.cert B.cert SHELL A B

It follows certs/FORMAT.md, section 7; check.py judges each certificate.
"""
import os
import sys
import check
from check import Stop, need

def checked(name, cert, *inputs):
    """The certificate, valid for its inputs; the message of an error begins with its name."""
    try:
        try: data = check.read_file(cert)
        except OverflowError: raise Stop("limit", "size", "") from None
        except (OSError, ValueError): raise Stop("malformed", "usage", "no certificate") from None
        found = check.Certificate(data)
        check.check_claims(check.bind(found, *check.sound_inputs(list(inputs), found.mesh is not None)), found)
        return found
    except Stop as stop:
        kind, code, why = stop.args
        raise Stop(kind, code, f"{name}: {why}") from None
def run(paths):  # the exit code and the text to print
    try:
        need(len(paths) == 5, "usage", "check_compose.py A.cert B.cert SHELL A B", "malformed")
        a_cert, b_cert, shell, a, b = paths
        both = checked("A", a_cert, shell, a), checked("B", b_cert, shell, b)
        need(both[0].shell[0] == both[1].shell[0], "shells", "the certificates are about different shells")
        need(both[0].order == both[1].order, "orders", "the certificates are about different vertex orders")
        for name, cert in zip("AB", both):
            need(cert.claims.get("bijection") == "certified", "not-certified", f"{name}: `bijection` is not certified")
        return 0, "valid\ncomposition certified"
    except Stop as stop:
        kind, code, why = stop.args
        return ["", "invalid", "malformed", "limit"].index(kind), f"{kind} {code} : {why}"
    except Exception as error:  # a last resort: never an answer, never `valid`
        return 3, f"limit internal : {type(error).__name__}"

if __name__ == "__main__":
    status, answer = run(sys.argv[1:])
    try: print(answer, flush=True)
    finally: os._exit(status)  # a closed pipe must not change the exit code
