"""The corpora of certs/, for the tests of both checkers."""
import pathlib
import subprocess
import sys

CERTS = pathlib.Path(__file__).resolve().parent.parent / "certs"


def rows(table, of_control=()):
    """Control, mutant, input files, exit code and error code of each row of a table below certs/."""
    head, *lines = (CERTS / table).read_text("ascii").splitlines()
    assert head == "control\tmutant\tinputs\texit\tcode\twhat"
    for line in lines:
        control, mutant, inputs, status, code, _ = line.split("\t")
        yield control, mutant, {"control": list(of_control), "none": []}.get(inputs, inputs.split(" ")), int(status), code


def code(text):
    """The error code of a checker's answer, `-` for none."""
    return (text.split("\n")[0].split(" : ")[0].split(" ") + ["-"])[1]


def regenerated(script):
    """Exit code and errors of a generator below certs/ that only compares."""
    run = subprocess.run([sys.executable, str(CERTS / script), "--check"], capture_output=True, text=True, check=False)
    return run.returncode, run.stderr
