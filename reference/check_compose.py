#!/usr/bin/env python3
"""Do two certificates together prove a homeomorphism from A to B? python3 check_compose.py A.cert B.cert SHELL A B

It follows certs/FORMAT.md, section 7; check.py judges each certificate.
"""
import functools
import check
from answer import answer, certificate_bytes, main
from check import Stop, need

def checked(name, cert, *inputs):
    """The certificate, valid for its inputs; the message of an error begins with its name."""
    try:
        found = check.Certificate(certificate_bytes([cert], "no certificate"))
        check.check_claims(check.bind(found, *check.sound_inputs(list(inputs), found.mesh is not None)), found)
        return found
    except Stop as stop:
        kind, code, why = stop.args
        raise Stop(kind, code, f"{name}: {why}") from None
def judge(paths):
    need(len(paths) == 5, "usage", "check_compose.py A.cert B.cert SHELL A B", "malformed")
    a_cert, b_cert, shell, a, b = paths
    both = checked("A", a_cert, shell, a), checked("B", b_cert, shell, b)
    need(both[0].shell[0] == both[1].shell[0], "shells", "the certificates are about different shells")
    need(both[0].order == both[1].order, "orders", "the certificates are about different vertex orders")
    for name, cert in zip("AB", both):
        need(cert.claims.get("bijection") == "certified", "not-certified", f"{name}: `bijection` is not certified")
    return "valid\ncomposition certified"
run = functools.partial(answer, judge)  # the exit code and the text to print

if __name__ == "__main__": main(run)
