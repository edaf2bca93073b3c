"""Tests of check_compose.py on shells written by hand: python3 -m unittest discover -s reference"""
import os
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import check_compose  # noqa: E402
import test_check  # noqa: E402
from test_check import IDENTITY, PRISM, certificate, hdf5, off  # noqa: E402

SECTION = ["section", "bijection"]
LOW = ([PRISM[0][0], PRISM[0][1], [(x, y, 2) for x, y, _ in PRISM[0][2]]], PRISM[1])


class Compose(test_check.Checks):
    """Two copies of one middle surface in a straight prism."""

    def files(self, shell=PRISM, other=None, orders=("order id", "order id")):
        mesh = (PRISM[0][1], PRISM[1])
        certs = [certificate(s, mesh, SECTION, [("overlay", IDENTITY)], o) for s, o in zip((shell, other or shell), orders)]
        names = [self.write(f"{k}.cert", text) for k, text in enumerate(certs)]
        meshes = [self.write(f"{k}.off", off(*mesh)) for k in range(2)]
        return names + [self.write("shell.h5", hdf5(shell))] + meshes

    def first(self, files):
        return check_compose.run(files)[1].split("\n")[0].split(" : ")[0]

    def test_two_certificates_on_one_shell(self):
        self.assertEqual(check_compose.run(self.files()), (0, "valid\ncomposition certified"))
        orders = ("order list 2 1 0",) * 2
        self.assertEqual(self.first(self.files(orders=orders)), "valid")

    def test_other_shells_and_orders(self):
        self.assertEqual(self.first(self.files(other=LOW)), "invalid hash")
        self.assertEqual(self.first(self.files(orders=("order id", "order list 2 1 0"))), "invalid orders")

    def test_what_is_no_certificate_of_a_bijection(self):
        files = self.files()
        positive = certificate(PRISM, None, ["positivity"], [])
        self.assertEqual(self.first([self.write("p", positive)] + files[1:]), "invalid not-certified")
        self.assertEqual(self.first([self.write("m", "homeo-meshes 1\nend\n")] + files[1:]), "malformed magic")
        self.assertEqual(self.first(files[:4]), "malformed usage")
        self.assertEqual(self.first(["none"] + files[1:]), "malformed usage")
        swapped = self.files(other=LOW)
        self.assertEqual(self.first([swapped[1], "none"] + swapped[2:]), "invalid hash")

    def test_the_exit_code_survives_a_closed_pipe(self):
        reader, writer = os.pipe()
        os.close(reader)
        script = os.path.join(HERE, "check_compose.py")
        done = subprocess.run([sys.executable, script] + self.files(), stdout=writer, stderr=subprocess.DEVNULL)
        os.close(writer)
        self.assertEqual(done.returncode, 0)

    def test_missing_inputs(self):
        files = self.files()
        self.assertEqual(self.first(files[:2] + ["none"] + files[3:]), "malformed input")


# The cases of the class that lends its helpers are run where they are.
for name in [n for n in dir(test_check.Checks) if n.startswith("test")]:
    setattr(Compose, name, None)

if __name__ == "__main__":
    unittest.main()
