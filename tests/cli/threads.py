"""Answers do not depend on the number of threads of BLAS: every verb over the shipped models, and a satellite whose motion leaves a remainder that is only rounding."""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from program import MODELS, PROGRAM

# A fast-spinning body between wires and soft booms: K has three negative eigenvalues, one motion grows, and finite elements put frequencies over six decades.
REMAINDER = """
kind = "spacecraft"
spin = 3.0
[body]
mass = 209.99784367848983
inertia = [101.44988042071418, 101.92859758046524, 102.71150098648013]
[[cable]]
azimuth = 1.0121707220241356
radius = 0.5
height = 0.0
length = 8.0
line_density = 0.001
tip_mass = 0.05
[[cable]]
azimuth = 4.153763375613929
radius = 0.5
height = 0.0
length = 8.0
line_density = 0.001
tip_mass = 0.05
[[beam]]
root = [0.0, 0.0, 0.9855317610194654]
direction = [0.0, 0.0, 1.0]
length = 2.5226110868142673
line_density = 0.05
bending_stiffness = [1.8222741488593686, 0.45556853721484214]
tip_mass = 0.0
[[beam]]
root = [0.0, 0.0, 0.9070573817594664]
direction = [0.0, 0.0, 1.0]
length = 6.6079083598188735
line_density = 0.05
bending_stiffness = [85.79630008516911, 2144.907502129228]
tip_mass = 0.0
"""

LIMIT = 1e-9


def answer(threads, *arguments):
    """Exit code and document."""
    environment = dict(os.environ, OPENBLAS_NUM_THREADS=str(threads))
    result = subprocess.run([str(PROGRAM), *map(str, arguments), "--format", "json", "--quiet"], capture_output=True, text=True, timeout=300, env=environment)
    return result.returncode, json.loads(result.stdout) if result.stdout else result.stderr


class Threads(unittest.TestCase):
    def near(self, a, b, size, where):
        self.assertTrue(abs(a - b) <= LIMIT * size or (math.isinf(a) and a == b), f"{where}: {a} and {b}")

    def both(self, *arguments):
        (code, one), (other, two) = (answer(n, *arguments) for n in (1, 2))
        self.assertEqual(code, other, arguments)
        return code, one, two

    def assert_same_motion(self, *arguments):
        code, one, two = self.both("response", *arguments)
        if code == 3:  # a first-order model has no such motion
            return None
        for i, label in enumerate(one["labels"]):
            size = max(abs(row[i]) for row in one["q"]) + 1e-2 * max(abs(x) for row in one["q"] for x in row)  # what does not move is rounding of what does
            for k, t in enumerate(one["t"]):
                self.near(one["q"][k][i], two["q"][k][i], size, f"{arguments} {label} t = {t}")
        return one

    def test_modes_count_and_stability(self):
        for model in sorted(MODELS.glob("*.toml")):
            _, one, two = self.both("modes", model)
            self.assertEqual(one["coverage"]["status"], two["coverage"]["status"], model)
            highest = max([m["omega"] for m in one["modes"]], default=0)
            for a, b in zip(one["modes"], two["modes"], strict=True):
                self.near(a["omega"], b["omega"], highest, model)
                self.assertEqual((a["kind"], a["energy_sign"]), (b["kind"], b["energy_sign"]), model)
            _, one, two = self.both("stability", model)
            self.assertEqual((one["stability"], one["index_balance"]), (two["stability"], two["index_balance"]), model)
            for a, b in zip(one["unstable"], two["unstable"], strict=True):
                self.near(a["growth_rate"], b["growth_rate"], a["growth_rate"], model)
            if highest > 0:
                _, one, two = self.both("count", model, "--below", 0.75 * highest)
                self.assertEqual((one["count"], one["negative"]), (two["count"], two["negative"]), model)

    def test_structure(self):
        for model in sorted(MODELS.glob("*.toml")):
            _, one, two = self.both("structure", model)
            self.assertEqual((one["structure"], one["components"]), (two["structure"], two["components"]), model)

    def test_motion(self):
        for model in sorted(MODELS.glob("*.toml")):
            label = self.both("structure", model)[1]["components"][0][0]
            self.assert_same_motion(model, "--force", f"impulse:{label}=1", "--force", f"step:{label}=0.5", "--until", 4, "--step", 1)

    def test_remainder_of_rounding(self):
        with tempfile.TemporaryDirectory() as folder:
            model = pathlib.Path(folder) / "remainder.toml"
            model.write_text(REMAINDER)
            ask = ["--points", "cable1@0.5", "--until", 8, "--step", 1]
            for forces, point in ((["harmonic:zeta3=5@0.9", "impulse:zeta3=-2"], -0.0644333423), (["step:zeta3=1", "impulse:zeta3=1"], 0.1901280483)):
                r = self.assert_same_motion(model, *(x for f in forces for x in ("--force", f)), *ask)
                last = dict(zip(r["labels"], r["q"][-1]))
                self.assertAlmostEqual(last["cable1@0.5.z"], point, delta=1e-9)
                self.assertAlmostEqual(last["theta1"], 0, delta=1e-12)  # a push along the spin axis does not tilt
                self.assertLess(r["departure"], 1e-10)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
