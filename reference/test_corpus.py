"""The Python checker over certs/corpus: every control, and every mutant with the answer that mutants.tsv states."""
import unittest

import check
import corpora

CORPUS = corpora.CERTS / "corpus"
INPUTS = ["bottom.off", "middle.off", "top.off", "mesh.off"]


def answer(control, cert, inputs):
    """Exit code, error code (`-` for none) and the claims printed."""
    status, text = check.run([str(CORPUS / control / name) for name in [cert, *inputs]])
    return status, corpora.code(text), text.split("\n")[1:]


def stated(control, cert):
    """The claim lines, read here without the checker."""
    lines = (CORPUS / control / cert).read_text("ascii").splitlines()
    return [line[6:] for line in lines if line.startswith("claim ")]


class Corpus(unittest.TestCase):
    maxDiff = None

    def test_controls(self):
        controls = sorted(path.parent.name for path in CORPUS.glob("*/control.cert"))
        self.assertGreaterEqual(len(controls), 26)
        for control in controls:
            self.assertEqual(answer(control, "control.cert", INPUTS), (0, "-", stated(control, "control.cert")), control)

    def test_mutants(self):
        wrong, corrupted = [], 0
        for control, mutant, inputs, status, code in corpora.rows("corpus/mutants.tsv", INPUTS):
            found = answer(control, f"{mutant}.cert", inputs)
            if found[:2] != (status, code):
                wrong.append(f"{control}/{mutant}: {found[:2]}, but the table says {(status, code)}")
            elif status == 0:
                self.assertEqual(found[2], stated(control, f"{mutant}.cert"), f"{control}/{mutant}")
            corrupted += status != 0
        self.assertEqual(wrong, [])
        self.assertGreaterEqual(corrupted, 60)

    def test_files_are_the_generated_ones(self):
        self.assertEqual(corpora.regenerated("corpus/make_mutants.py"), (0, ""))

    def test_usage(self):
        self.assertEqual(answer("inside", "no-such.cert", INPUTS)[:2], (2, "usage"))
        self.assertEqual(answer("inside", "", INPUTS)[:2], (2, "usage"))
        self.assertEqual(check.run([])[0], 2)
        self.assertEqual(answer("inside", "control.cert", [""])[:2], (2, "input"))


if __name__ == "__main__":
    unittest.main()
