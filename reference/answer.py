"""How the checkers of this directory begin and end: the certificate's bytes, the answer, the exit code."""
import os, sys
from certificate import Stop
from inputs import read_file

KINDS = ["", "invalid", "malformed", "limit"]  # by exit code

def certificate_bytes(paths, usage):  # all bytes of the first file
    try: return read_file(paths[0])
    except OverflowError: raise Stop("limit", "size", "") from None
    except (IndexError, OSError, ValueError): raise Stop("malformed", "usage", usage) from None
def answer(judge, paths):  # the exit code and the text to print: what `judge` returns, or the failure that it raises
    try: return 0, judge(paths)
    except Stop as stop:
        kind, code, why = stop.args
        return KINDS.index(kind), f"{kind} {code}" + (why and f" : {why}")
    except Exception as error:  # a last resort: never an answer, never `valid`
        return 3, f"limit internal : {type(error).__name__}"
def main(run):
    status, text = run(sys.argv[1:])
    try: print(text, flush=True)
    finally: os._exit(status)  # a closed pipe must not change the exit code
