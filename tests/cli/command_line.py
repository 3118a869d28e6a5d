"""The program from outside: exit codes, one-line errors, formats, windows, files that must not be spoilt."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from program import MODELS, Program, run


class Errors(Program):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def model(self, text):
        file = self.path / "m.toml"
        file.write_text(text)
        return file

    def matrices(self, m, k, g=None):
        arguments = []
        for name, text in (("mass", m), ("stiffness", k), ("gyroscopic", g)):
            if text is not None:
                (self.path / f"{name}.mtx").write_text(text)
                arguments += [f"--{name}", self.path / f"{name}.mtx"]
        return arguments

    UNIT = "%%MatrixMarket matrix array real general\n2 2\n1\n0\n0\n1\n"

    def test_usage(self):
        self.refused(1, ["no model"], "modes")
        self.refused(1, ["not both"], "modes", "x.toml", "--mass", "M.mtx")
        self.refused(1, ["--stiffness is missing"], "modes", "--mass", "M.mtx")
        self.refused(1, ["frequency", "5xyz"], "modes", MODELS / "wiresaw.toml", "--below", "5xyz")
        self.refused(1, ["0 ≤ A < B"], "modes", MODELS / "wiresaw.toml", "--window", "5:2")
        self.refused(1, ["window"], "count", MODELS / "wiresaw.toml")
        for number in ("0", "-3", "abc", "1.5"):
            self.refused(1, [f"--lowest: '{number}' is no whole number above 0"], "modes", MODELS / "wiresaw.toml", "--lowest", number)
        self.refused(1, ["'mods' is no verb", "did you mean 'modes'"], "mods", MODELS / "wiresaw.toml")
        self.assertEqual(run().returncode, 1)

    def test_unreadable(self):
        self.refused(2, ["missing.toml", "No such file"], "modes", self.path / "missing.toml")
        self.refused(2, ["directory"], "modes", self.path)
        self.refused(2, ["empty"], "modes", self.model(""))
        self.refused(2, ["m.toml:1", "not TOML"], "modes", self.model("kind = = 1\n"))
        self.refused(2, ["m.toml:2", "did you mean 'stiffness'"], "modes", self.model('kind = "matrices"\nstifness = [[1]]\nmass = [[1]]\n'))
        self.refused(2, ["m.toml:2:9", "title", "a string was expected"], "modes", self.model('kind = "matrices"\ntitle = 3\nmass = [[1]]\nstiffness = [[1]]\n'))
        self.refused(2, ["m.toml:2", "nan"], "modes", self.model('kind = "matrices"\nmass = [[nan]]\nstiffness = [[1]]\n'))
        self.refused(2, ["spin", "5 parsec"], "modes",
                     self.model('kind = "matrices"\nmass = [[1]]\nstiffness = [[1]]\nspin = "5 parsec"\nstiffness_per_spin2 = [[1]]\n'))
        self.refused(2, ["row 2", "2 were expected"], "modes", self.model('kind = "matrices"\nmass = [[1, 0], [0]]\nstiffness = [[1]]\n'))
        self.refused(2, ["2 × 2"], "modes", self.model('kind = "matrices"\nmass = [[1, 0], [0, 1]]\nstiffness = [[1]]\n'))
        self.refused(2, ["square"], "modes", self.model('kind = "matrices"\nmass = [[1, 0]]\nstiffness = [[1]]\n'))
        self.refused(2, ["key 'mass' is missing"], "modes", self.model('kind = "matrices"\nstiffness = [[1]]\n'))
        self.refused(2, ["turbine"], "modes", self.model('kind = "turbine"\n'))
        self.refused(2, ["mass.mtx:3", "abc"], "modes", *self.matrices("%%MatrixMarket matrix coordinate real general\n1 1 1\n1 1 abc\n", self.UNIT))
        self.refused(2, ["order"], "modes", *self.matrices("%%MatrixMarket matrix array real general\n1 1\n1\n", self.UNIT))

    def test_against_a_law(self):
        self.refused(3, ["m.toml: M must be positive definite"], "modes", self.model('kind = "matrices"\nmass = [[-1]]\nstiffness = [[1]]\n'))
        self.refused(3, ["K must satisfy K = Kᵀ", "differ by"], "modes", self.model('kind = "matrices"\nmass = [[1, 0], [0, 1]]\nstiffness = [[1, 2], [0, 1]]\n'))
        self.refused(3, ["G must satisfy G = −Gᵀ"], "modes",
                     self.model('kind = "matrices"\nmass = [[1, 0], [0, 1]]\nstiffness = [[1, 0], [0, 1]]\ngyroscopic = [[0, 3], [-2.5, 0]]\n'))
        self.refused(3, ["symmetric-2n", "positive definite"], "modes", MODELS / "rigid_body_minor.toml", "--method", "symmetric-2n")
        self.refused(3, ["exact", "spacecraft"], "modes", MODELS / "wiresaw.toml", "--method", "exact")
        self.refused(3, ["M, G, K"], "modes", MODELS / "meirovitch_body.toml", "--method", "first-order")

    def test_output_is_kept_where_the_run_fails(self):
        target = self.path / "result.json"
        target.write_text("precious")
        self.assertEqual(run("modes", self.path / "missing.toml", "-o", target).returncode, 2)
        self.assertEqual(target.read_text(), "precious")
        self.refused(2, ["cannot be written"], "modes", MODELS / "wiresaw.toml", "-o", self.path / "no" / "where.json")
        self.assertEqual(run("modes", MODELS / "wiresaw.toml", "-o", target, "--quiet").returncode, 0)
        self.assertEqual(json.loads(target.read_text())["schema"], "gyromode/modes/1")
        self.assertEqual(sorted(p.name for p in self.path.iterdir()), ["result.json"])


class Results(Program):
    def test_modes(self):
        r = self.json("modes", MODELS / "rigid_body.toml", "--shapes")
        self.assertEqual(r["model"]["coordinates"], 2)
        self.assertEqual(r["structure"]["in_phase"], ["θ1"])
        self.assertEqual(r["structure"]["quadrature"], ["θ2"])
        self.assertAlmostEqual(r["modes"][1]["omega"], 3.14159265358979323846 / 3, delta=1e-14)
        self.assertEqual(r["coverage"]["window"], [0.0, None])
        shape = r["modes"][0]["shape"]
        self.assertEqual(max(abs(complex(a, b)) for a, b in zip(shape["re"], shape["im"])), 1.0)
        self.assertTrue(shape["im"][0] == 0 and shape["re"][1] == 0 or shape["re"][0] == 0 and shape["im"][1] == 0)

    def test_windows(self):
        r = self.json("modes", MODELS / "wiresaw.toml", "--window", "1Hz:3Hz")
        self.assertEqual([round(m["frequency_hz"], 2) for m in r["modes"]], [1.5, 2.0, 2.5, 3.0])
        self.assertEqual(r["coverage"]["found"], 4)
        r = self.json("modes", MODELS / "wiresaw.toml", "--lowest", "3")
        self.assertEqual(len(r["modes"]), 3)
        r = self.json("modes", MODELS / "rigid_body.toml", "--below", "10rpm")  # the tilt is at 10 rpm: moved outward
        self.assertEqual(len(r["modes"]), 2)
        self.assertGreater(r["coverage"]["window"][1], r["coverage"]["requested"][1])

    def test_methods_agree(self):
        reference = [m["omega"] for m in self.json("modes", MODELS / "wiresaw.toml")["modes"]]
        for method in ("quadrature", "general", "first-order", "symmetric-2n"):
            found = [m["omega"] for m in self.json("modes", MODELS / "wiresaw.toml", "--method", method)["modes"]]
            for a, b in zip(reference, found, strict=True):
                self.assertAlmostEqual(a, b, delta=1e-11 * a)

    def test_count(self):
        r = self.json("count", MODELS / "rotating_frame.toml", "--window", "0.1:1")
        self.assertEqual((r["count"], r["signed"], r["status"]), (3, 1, "exact"))

    def test_stability(self):
        r = self.json("stability", MODELS / "rigid_body_minor.toml")
        self.assertEqual(r["stability"], "gyroscopically_stabilised")
        self.assertEqual(r["index_balance"]["negative_energy"], 1)
        self.assertEqual(len(r["negative_modes"]), 1)

    def test_structure_at(self):
        r = self.json("structure", MODELS / "rigid_body.toml", "--at", "0.8")
        star = r["at"]["H_star"]
        self.assertEqual(star[0][1], star[1][0])

    def test_formats(self):
        for name, start in (("csv", "omega,"), ("markdown", "## "), ("table", "Travelling")):
            self.assertTrue(run("modes", MODELS / "wiresaw.toml", "--format", name).stdout.startswith(start))

    def test_convert_round_trip(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "matrices"
            self.assertEqual(run("convert", MODELS / "three_springs.toml", "-o", out, "--quiet").returncode, 0)
            r = self.json("modes", "--mass", out / "M.mtx", "--gyroscopic", out / "G.mtx", "--stiffness", out / "K.mtx")
            s = self.json("modes", MODELS / "three_springs.toml")
            self.assertEqual([m["omega"] for m in r["modes"]], [m["omega"] for m in s["modes"]])


class Spacecraft(Program):
    GEOS = MODELS / "geos.toml"

    def test_modes(self):
        r = self.json("modes", self.GEOS, "--below", "400rpm")
        self.assertEqual(r["model"]["kind"], "spacecraft")
        self.assertEqual(r["model"]["frame"], "turning")
        self.assertEqual(r["structure"]["class"], "transcendental")
        self.assertEqual(r["structure"]["in_phase"], ["zeta1", "zeta3", "theta2", "theta3"])
        self.assertEqual(r["structure"]["quadrature"], ["zeta2", "theta1"])
        self.assertEqual((r["coverage"]["status"], r["coverage"]["found"], r["coverage"]["counted"]), ("complete", 112, 112))
        self.assertEqual(r["stability"], "stable")
        rigid = [m["omega"] for m in r["modes"] if m["kind"] == "rigid_body"]
        self.assertEqual(rigid, [0, 0, 1.0471975511965976])
        for m in r["modes"]:
            if m["kind"] == "vibration":
                self.assertLessEqual(m["bracket"][0], m["omega"])
                self.assertGreaterEqual(m["bracket"][1], m["omega"])
                self.assertLess(m["residual"], 1e-13)
                self.assertLess(m["error_bound"], 1e-13 * (1 + m["omega"]))
        self.assertIsNone(r["geometry"])

    def test_lowest_ten_is_the_default(self):
        r = self.json("modes", MODELS / "cluster.toml")
        self.assertEqual(len([m for m in r["modes"] if m["kind"] != "rigid_body"]), 10)
        self.assertEqual([m["kind"] for m in r["modes"]].count("rigid_body"), 3)
        self.assertIn("local", [m["kind"] for m in r["modes"]])
        self.assertEqual(run("modes", MODELS / "cluster.toml").stderr, "")

    def test_infinitely_many(self):
        self.refused(1, ["infinitely many", "--below"], "modes", self.GEOS, "--all")
        self.refused(1, ["infinitely many", "upper end"], "modes", self.GEOS, "--window", "1:")
        self.refused(1, ["infinitely many"], "count", self.GEOS, "--window", "1:")

    def test_methods(self):
        exact = self.json("modes", self.GEOS, "--method", "exact", "--lowest", "4")
        discrete = self.json("modes", self.GEOS, "--method", "discrete", "--elements", "200", "--lowest", "4")
        elastic = lambda r: [m["omega"] for m in r["modes"] if m["kind"] == "vibration"][:3]
        for a, b in zip(elastic(exact), elastic(discrete), strict=True):
            self.assertAlmostEqual(a, b, delta=1e-6 * a)
            self.assertGreater(b, a)
        self.refused(3, ["exact", "discrete"], "modes", self.GEOS, "--method", "quadrature")
        self.refused(1, ["--elements"], "modes", self.GEOS, "--elements", "20")
        self.refused(1, ["--elements"], "modes", MODELS / "wiresaw.toml", "--elements", "20")
        self.refused(3, ["--keep", "matrix models"], "modes", self.GEOS, "--keep", "theta1")
        self.refused(3, ["--keep", "matrix models"], "modes", self.GEOS, "--method", "discrete", "--keep", "theta1")
        self.refused(3, ["--coupling-tolerance", "matrix models"], "modes", self.GEOS, "--coupling-tolerance", "1e-9")
        self.refused(3, ["'hidden'", "'exact' or 'discrete'"], "modes", self.GEOS, "--method", "hidden")
        self.refused(1, ["--at 0"], "structure", self.GEOS, "--at", "0")
        self.refused(1, ["beyond reach"], "count", self.GEOS, "--below", "1e9")

    def test_shapes_and_geometry(self):
        r = self.json("modes", MODELS / "mms.toml", "--lowest", "6", "--shapes")
        points = len(r["geometry"]["points"])
        self.assertEqual(len(r["geometry"]["lines"]), 6)
        for m in r["modes"]:
            self.assertEqual(m["shape"]["labels"], ["zeta1", "zeta2", "zeta3", "theta1", "theta2", "theta3"])
            if m["omega"] > 0:
                self.assertEqual(len(m["displacements"]["re"]), points)
            size = max(abs(complex(a, b)) for a, b in zip(m["shape"]["re"], m["shape"]["im"]))
            self.assertEqual(size, 0 if m["kind"] == "local" else 1)

    def test_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            target = pathlib.Path(folder) / "shapes.svg"
            self.assertEqual(run("modes", MODELS / "ulysses.toml", "--lowest", "3", "-o", target).returncode, 0)
            text = target.read_text()
            self.assertTrue(text.startswith("<svg") and text.rstrip().endswith("</svg>"))
            self.assertEqual(text.count('class="caption"'), 3)
            self.refused(1, ["svg", "spacecraft"], "modes", MODELS / "wiresaw.toml", "-o", target)
            self.refused(1, ["svg", "spacecraft"], "count", self.GEOS, "--below", "3", "--format", "svg")

    def test_count(self):
        r = self.json("count", self.GEOS, "--below", "400rpm")
        self.assertEqual((r["count"], r["signed"], r["zero"], r["status"]), (112, 110, 2, "exact"))
        r = self.json("count", self.GEOS, "--window", "0.5:1.0471975511965976")  # ends on the tilt
        self.assertEqual(r["count"], 1)
        self.assertGreater(r["window"][1], r["requested"][1])

    def test_structure(self):
        r = self.json("structure", self.GEOS, "--at", "0.5")
        self.assertEqual(r["components"], [["zeta1", "zeta2", "theta1", "theta2"], ["zeta3"], ["theta3"]])
        self.assertEqual(len(r["at"]["H"]["re"]), 6)
        self.assertAlmostEqual(r["checks"]["mass"], 273.6, delta=1e-9)
        r = self.json("structure", MODELS / "geos_rotated.toml")
        psi = [0] + [a["psi"] for a in r["effective_axes"]]  # followed from mode to mode
        self.assertTrue(all(abs(b - a) <= 0.7853981633974484 for a, b in zip(psi, psi[1:])), psi)

    def test_unstable(self):
        with tempfile.TemporaryDirectory() as folder:
            model = pathlib.Path(folder) / "middle.toml"
            model.write_text('kind = "spacecraft"\nspin = 1\n[body]\nmass = 10\ninertia = [4, 6, 5]\n')
            r = self.json("stability", model)
            self.assertEqual(r["stability"], "unstable")
            self.assertAlmostEqual(r["unstable"][0]["growth_rate"], 24 ** -0.5, delta=1e-13)
            self.assertTrue(r["index_balance"]["closed"])

    def test_convert(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "matrices"
            self.assertEqual(run("convert", self.GEOS, "-o", out, "--elements", "30", "--quiet").returncode, 0)
            r = self.json("modes", "--mass", out / "M.mtx", "--gyroscopic", out / "G.mtx", "--stiffness", out / "K.mtx", "--below", "1")
            self.assertEqual(r["model"]["coordinates"], 3 + 4 * 30)
            exact = self.json("modes", self.GEOS, "--below", "1")
            for a, b in zip([m["omega"] for m in exact["modes"]][2:], [m["omega"] for m in r["modes"]][1:], strict=True):
                self.assertAlmostEqual(a, b, delta=1e-5)


class Documents(Program):
    def rows(self, model, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "m.toml"
            file.write_text(model)
            result = run("modes", file, *arguments)
            self.assertEqual(result.returncode, 0, result.stderr)
            return result.stdout

    def test_every_row_of_a_csv_has_the_fields_of_its_head(self):
        for model, arguments in (
            ('kind = "matrices"\nmass = [[1, 0], [0, 1]]\nstiffness = [[-3, 0.5], [0.5, 5]]\n', ["--keep", "q1"]),
            ('kind = "matrices"\nmass = [[1, 0], [0, 1]]\nstiffness = [[-3, 0.5], [0.5, 5]]\n', ["--keep", "q1", "--shapes"]),
            ('kind = "matrices"\nmass = [[1, 0], [0, 1]]\nstiffness = [[-1, 0], [0, -2]]\n', ["--shapes"]),
            ('kind = "matrices"\nmass = [[1, 0], [0, 1]]\nstiffness = [[-1, 0], [0, -2]]\n', []),
        ):
            lines = self.rows(model, *arguments, "--format", "csv").strip().split("\n")
            self.assertGreater(len(lines), 1)
            self.assertEqual({line.count(",") for line in lines}, {lines[0].count(",")}, lines)

    def test_blocks_have_a_row_a_mode(self):
        r = json.loads(run("modes", MODELS / "mms.toml", "--lowest", 3, "--shapes", "--schema", 2, "--format", "json").stdout)
        self.assertEqual(r["schema"], "gyromode/modes/2")
        self.assertEqual(len(r["shapes"]["re"]), len(r["modes"]))
        self.assertEqual(len(r["geometry"]["displacements"]), len(r["modes"]))
        self.assertNotIn("shape", r["modes"][-1])
        kept = json.loads(self.rows('kind = "matrices"\nmass = [[1, 0], [0, 1]]\nstiffness = [[-3, 0.5], [0.5, 5]]\n', "--keep", "q1", "--format", "json"))
        self.assertNotIn("shape", kept["unstable"][0])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
