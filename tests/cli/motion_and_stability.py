"""The verbs response and stability --vary, convert --realified and hidden quadrature from outside."""
import csv
import io
import math
import pathlib
import sys
import tempfile
import unittest

from program import MODELS, Program, run

BODY = MODELS / "rigid_body.toml"
SPRINGS = MODELS / "three_springs.toml"
GEOS = MODELS / "geos.toml"


class WithFolder(Program):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def initial(self, text):
        file = self.path / "start.csv"
        file.write_text(text)
        return file

    def rows(self, *arguments):
        result = run(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return list(csv.DictReader(io.StringIO(result.stdout)))


class Response(WithFolder):
    TILT = "label,q,qdot\nθ1,0.1,0\nθ2,0,0.2\n"

    def test_history(self):
        start = self.initial(self.TILT)
        rows = self.rows("response", BODY, "--initial", start, "--until", "10", "--step", "0.5", "--rates")
        self.assertEqual(len(rows), 21)
        self.assertEqual([float(rows[0][k]) for k in ("t", "θ1", "θ2", "θ1 rate", "θ2 rate")], [0, 0.1, 0, 0, 0.2])
        r = self.json("response", BODY, "--initial", start, "--until", "10", "--step", "0.5")
        self.assertEqual(r["schema"], "gyromode/response/1")
        self.assertEqual(len(r["t"]), 21)
        for k, row in enumerate(rows):  # the modes say the same
            q = [0.0, 0.0]
            for m in r["modal"]:
                for i in range(2):
                    x = complex(m["shape"]["re"][i], m["shape"]["im"][i])
                    turn = m["omega"] * r["t"][k] + m["phase"]
                    q[i] += m["amplitude"] * (x * complex(math.cos(turn), math.sin(turn))).real
            self.assertAlmostEqual(q[0], float(row["θ1"]), delta=1e-14)
            self.assertAlmostEqual(q[1], r["q"][k][1], delta=1e-14)
        self.assertAlmostEqual(sum(m["energy"] for m in r["modal"]), r["energy"]["initial"], delta=1e-14)

    def test_times_of_a_file(self):
        times = self.path / "times.txt"
        times.write_text("t\n0\n0.25\n3\n")
        rows = self.rows("response", BODY, "--initial", self.initial(self.TILT), "--times", times)
        self.assertEqual([float(r["t"]) for r in rows], [0, 0.25, 3])
        times.write_text("0\n2\n1\n")
        self.refused(2, ["times.txt:3", "increasing"], "response", BODY, "--initial", self.initial(self.TILT), "--times", times)

    def test_initial_files(self):
        ask = ["--until", "1", "--step", "0.5"]
        self.refused(2, ["1 of 2", "'θ2'"], "response", BODY, "--initial", self.initial("label,q,qdot\nθ1,0,0\n"), *ask)
        self.refused(2, ["start.csv:3", "'θ3'", "did you mean 'θ"], "response", BODY, "--initial", self.initial("label,q,qdot\nθ1,0,0\nθ3,0,0\n"), *ask)
        self.refused(2, ["start.csv:3", "second time"], "response", BODY, "--initial", self.initial("label,q,qdot\nθ1,0,0\nθ1,0,0\n"), *ask)
        self.refused(2, ["start.csv:2", "'abc'", "number"], "response", BODY, "--initial", self.initial("label,q,qdot\nθ1,abc,0\nθ2,0,0\n"), *ask)
        self.refused(2, ["start.csv:2", "not finite"], "response", BODY, "--initial", self.initial("label,q,qdot\nθ1,inf,0\nθ2,0,0\n"), *ask)
        self.refused(2, ["start.csv:1", "'qdot'"], "response", BODY, "--initial", self.initial("label,q\nθ1,0\n"), *ask)
        self.refused(2, ["empty"], "response", BODY, "--initial", self.initial(""), *ask)
        self.refused(2, ["No such file"], "response", BODY, "--initial", self.path / "none.csv", *ask)
        self.refused(2, ["start.csv:2", "4 fields", "point"], "response", BODY, "--initial", self.initial("label,q,qdot\nθ1,1,0,5\nθ2,0,0\n"), *ask)
        self.refused(2, ["start.csv:1", "twice"], "response", BODY, "--initial", self.initial("label,q,q,qdot\nθ1,1,0,5\nθ2,0,0,0\n"), *ask)
        crlf = self.initial("\ufefflabel,qdot,q\r\n\"θ1\",0,0.1\r\n# at rest\r\nθ2,0.2,0\r\n")
        self.assertEqual(float(self.rows("response", BODY, "--initial", crlf, *ask)[0]["θ1"]), 0.1)

    def test_usage(self):
        start = self.initial(self.TILT)
        self.refused(1, ["--until T --step DT"], "response", BODY, "--initial", start)
        self.refused(1, ["--step -1"], "response", BODY, "--initial", start, "--until", "1", "--step", "-1")
        self.refused(1, ["rows"], "response", BODY, "--initial", start, "--until", "1e9", "--step", "1e-3")
        self.refused(1, ["nothing moves"], "response", BODY, "--until", "1", "--step", "1")
        self.refused(1, ["impulse:LABEL=P"], "response", BODY, "--force", "θ1=1", "--until", "1", "--step", "1")
        self.refused(1, ["'θ4'", "did you mean"], "response", BODY, "--force", "impulse:θ4=1", "--until", "1", "--step", "1")
        self.refused(1, ["LABEL=VALUE"], "response", BODY, "--force", "impulse:", "--until", "1", "--step", "1")
        self.refused(1, ["@5Hz"], "response", BODY, "--force", "harmonic:θ1=1", "--until", "1", "--step", "1")
        self.refused(1, ["--points"], "response", BODY, "--initial", start, "--points", "cable1@1", "--until", "1", "--step", "1")
        self.refused(1, ["cable9@1", "has 2"], "response", GEOS, "--force", "impulse:theta1=1", "--points", "cable9@1", "--until", "1", "--step", "1")
        self.refused(3, ["first order"], "response", MODELS / "meirovitch_body.toml", "--initial", start, "--until", "1", "--step", "1")
        self.refused(1, ["grows beyond"], "response", MODELS / "rigid_body_intermediate.toml", "--initial", start, "--until", "1e5", "--step", "1e5")

    def test_resonance(self):
        result = run("response", SPRINGS, "--force", "z=1", "--frequencies", "499:501:3")
        self.assertEqual(result.returncode, 0)
        self.assertIn("ω = 500 rad/s of the grid is a resonance", result.stderr)
        rows = list(csv.DictReader(io.StringIO(result.stdout)))
        at = [r for r in rows if r["resonance"] == "1"]
        self.assertEqual([(float(r["omega"]), r["z re"]) for r in at], [(500, "inf")])
        self.assertTrue(any(r["added"] == "1" for r in rows))
        self.assertEqual(run("response", SPRINGS, "--force", "x=1", "--frequencies", "499:501:3").stderr, "")
        self.refused(1, ["--force LABEL=F"], "response", SPRINGS, "--frequencies", "1:2:3")
        self.refused(1, ["A:B:N"], "response", SPRINGS, "--force", "x=1", "--frequencies", "1:2")
        self.refused(3, ["matrix models"], "response", GEOS, "--force", "theta1=1", "--frequencies", "1:2:3")

    def matrices(self, stiffness, gyroscopic=None, mass="[[1, 0], [0, 1]]"):
        model = self.path / "m.toml"
        model.write_text(f'kind = "matrices"\nmass = {mass}\nstiffness = {stiffness}\n' + (f"gyroscopic = {gyroscopic}\n" if gyroscopic else ""))
        return model

    def test_weak_resonance(self):
        ask = ["--force", "q1=1", "--frequencies", "1.5:2.5:3"]
        model = self.matrices("[[1, 1e-12], [1e-12, 4]]")
        r = self.json("response", model, *ask)
        self.assertEqual(r["resonances"], [2])
        self.assertEqual(r["modes"][0]["driven"], "yes")
        self.assertAlmostEqual(r["modes"][0]["participation"] / (1e-12 / 3), 1, delta=1e-2)
        rows = self.rows("response", model, *ask)
        at = [row for row in rows if row["omega"] == "2"]
        self.assertEqual([(row["resonance"], row["driven"], row["q1 re"]) for row in at], [("1", "yes", "inf")])
        said = run("response", model, *ask, "--format", "table")
        self.assertIn("participation 3.3e-13", said.stderr)
        self.assertIn("resonance, participation 3.3e-13", said.stdout)
        # Exactly not driven: another component.
        model = self.matrices("[[1, 0], [0, 4]]")
        r = self.json("response", model, *ask)
        self.assertEqual((r["resonances"], [m["driven"] for m in r["modes"]], r["modes"][0]["participation"]), ([], ["no"], 0))
        self.assertEqual(run("response", model, *ask).stderr, "")
        # Not driven but by rounding: (1, 1) on the mode (1, −1).
        model = self.matrices("[[2.5, -1.5], [-1.5, 2.5]]")
        result = run("response", model, "--force", "q1=1,q2=1", "--frequencies", "1.5:2.5:3")
        self.assertEqual(result.returncode, 0)
        self.assertIn("cannot be told", result.stderr)
        at = [row for row in csv.DictReader(io.StringIO(result.stdout)) if row["omega"] == "2"]
        self.assertEqual([(row["resonance"], row["driven"]) for row in at], [("0", "undecided")])
        self.assertAlmostEqual(float(at[0]["q1 re"]), -1 / 3, delta=1e-9)

    def test_phases_after_a_long_time(self):
        start = self.initial("label,q,qdot\nq1,1,0\nq2,0,1\n")
        model = self.matrices("[[1, 0.1], [0.1, 4]]")
        for t, code in (("1e3", 0), ("1e12", 4)):
            result = run("response", model, "--initial", start, "--until", t, "--step", t)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertEqual("phases are known to" in result.stderr, code == 4, result.stderr)
            self.assertEqual(len(result.stdout.splitlines()), 3)  # written all the same
        self.assertLess(self.json("response", model, "--initial", start, "--until", "1e3", "--step", "1e3")["phase_error"], 1e-11)

    def test_couplings_left_out(self):
        model = self.matrices("[[1, 1e-3], [1e-3, 4]]")
        leave, without = ["--coupling-tolerance", "0.01"], self.path / "without.toml"
        without.write_text(model.read_text().replace("1e-3", "0"))
        for ask in (["response", "--force", "q1=1", "--frequencies", "0.5:2.5:5"], ["response", "--force", "impulse:q1=1", "--until", "9", "--step", "3"], ["modes", "--shapes"],
                    ["count", "--below", "3"], ["stability"], ["structure", "--at", "1.5"]):
            cut, plain, whole = (self.json(ask[0], m, *ask[1:], *more) for m, more in ((model, leave), (without, []), (model, [])))
            self.assertEqual(cut["model"]["couplings_left_out"], {"up_to": 0.01, "largest": 0.00025})
            self.assertNotIn("couplings_left_out", whole["model"])
            for d in (cut, plain):
                for head in ("model", "timings", "checks", "options"):
                    d.pop(head, None)
                d.get("structure", {}).pop("largest_ignored_coupling", None)
            self.assertEqual(cut, plain, ask)
            self.assertIn("left out, as asked: the largest of them is 0.00025", run(ask[0], model, *ask[1:], *leave).stderr)
        folder = self.path / "matrices"
        self.assertEqual(run("convert", model, "-o", folder, *leave).returncode, 0)
        self.assertNotIn("0.001", (folder / "K.mtx").read_text())
        for none in ("nan", "inf", "-0.01", "0.2", "x", "1e400"):
            self.refused(1, ["--coupling-tolerance", f"'{none}'", "from 0 to 0.1"], "modes", model, f"--coupling-tolerance={none}")
        self.refused(3, ["matrix models"], "convert", GEOS, "-o", folder, *leave)

    def test_couplings_left_out_of_a_map(self):
        model = self.matrices("[[1, 1e-3], [1e-3, 4]]")
        ask = ["stability", model, "--vary", "stiffness[1][1]=1e-7:3:2"]  # without the coupling K > 0 throughout
        self.assertEqual([c["stability"] for c in self.json(*ask)["map"]], ["unstable", "stable"])
        self.assertEqual([c["stability"] for c in self.json(*ask, "--coupling-tolerance", "0.01")["map"]], ["stable", "stable"])

    def test_spacecraft(self):
        r = self.json("response", GEOS, "--force", "impulse:zeta1=273.6", "--points", "cable1@1,cable2@0", "--until", "60", "--step", "30")
        # Pushed at P, which is the mass centre at first: the whole goes on at 1 m/s in a straight line.
        self.assertEqual(r["labels"][6:], [f"cable{n}@{a}.{x}" for n, a in ((1, 1), (2, 0)) for x in "xyz"])
        spin, t = 1.0471975511965976, 60
        shares = max(m["amplitude"] for m in r["modal"])
        self.assertAlmostEqual(r["q"][-1][0], t * math.cos(spin * t), delta=20 * shares + 1e-9)


class Vary(WithFolder):
    def test_critical_values(self):
        r = self.json("stability", SPRINGS, "--vary", "spin=0:12000rpm:25")
        self.assertEqual(len(r["map"]), 25)
        self.assertEqual([c["to"] for c in r["critical"]], ["unstable", "gyroscopically_stabilised"])
        self.assertAlmostEqual(r["critical"][0]["value"], math.sqrt(200000), delta=1e-8)
        self.assertAlmostEqual(r["critical"][1]["value"], 1000, delta=1e-8)
        self.assertEqual(r["critical"][0]["key"], "spin")
        for c in r["critical"]:
            self.assertLessEqual(c["bracket"][0], c["value"])
            self.assertLess(c["bracket"][1] - c["bracket"][0], 1e-10)
        self.assertEqual(r["critical"][0]["motions"]["to"], {"real_pairs": 1, "quadruples": 0, "negative_energy": 0})
        self.assertEqual(r["evaluations"]["cells"], 25)
        self.assertLess(r["evaluations"]["between"], 200)

    def test_chart(self):
        r = self.json("stability", SPRINGS, "--vary", "spin=1000rpm:12000rpm:12", "--vary", "stiffness[0][0]=2e4:1e5:5")
        self.assertEqual(len(r["map"]), 60)
        for c in r["critical"]:
            kx = c["at"]["stiffness[0][0]"]
            exact = math.sqrt(kx / 0.2) if c["from"] == "stable" else 1000
            self.assertAlmostEqual(c["value"], exact, delta=1e-8)
        text = run("stability", SPRINGS, "--vary", "spin=1000rpm:12000rpm:12", "--vary", "stiffness[0][0]=2e4:1e5:5").stdout
        self.assertIn("s stable, g gyroscopically stabilised", text)

    def test_defective_pair_and_rest(self):
        model = self.path / "m.toml"
        model.write_text('kind = "matrices"\nmass = [[1, 0], [0, 1]]\ngyroscopic = [[0, -2], [2, 0]]\nstiffness = [[-1, 0], [0, -1]]\n')
        points = self.json("response", model, "--force", "q1=1", "--frequencies", "0.5:1.5:3")["points"]
        self.assertEqual([p["resonance"] for p in points if not p["added"]], [False, True, False])
        self.assertAlmostEqual(points[0]["re"][0], -20 / 9, delta=1e-12)
        model.write_text('kind = "matrices"\nmass = [[1, 0], [0, 1]]\ngyroscopic = [[0, -1], [1, 0]]\nstiffness = [[1, 0], [0, 0]]\n')
        points = self.json("response", model, "--force", "q1=1", "--frequencies", "0:0.5:2")["points"]
        self.assertTrue(points[0]["resonance"])  # the drift that the force drives

    def test_unlawful_cells(self):
        r = self.json("stability", GEOS, "--vary", "body.inertia[2]=150:250:3")
        self.assertEqual([c["stability"] for c in r["map"]], ["stable", None, None])
        self.assertIn("inertia", r["map"][2]["reason"])
        self.assertEqual(r["critical"], [])

    def test_usage(self):
        self.refused(1, ["'spn'", "did you mean 'spin'"], "stability", SPRINGS, "--vary", "spn=0:1:3")
        self.refused(1, ["'cable[*].lenght'", "cable[*].length"], "stability", GEOS, "--vary", "cable[*].lenght=1:2:3")
        self.refused(1, ["KEY=A:B:N"], "stability", SPRINGS, "--vary", "spin")
        self.refused(1, ["two different finite bounds"], "stability", SPRINGS, "--vary", "spin=2:2:3")
        self.refused(1, ["5xyz"], "stability", SPRINGS, "--vary", "spin=5xyz:9:3")
        self.refused(1, ["5m", "unit that fits 'spin'"], "stability", SPRINGS, "--vary", "spin=5m:20m:3")
        self.refused(1, ["'known.frequencies[0]'"], "stability", SPRINGS, "--vary", "known.frequencies[0]=1:2:3")
        self.refused(1, ["given twice"], "stability", SPRINGS, "--vary", "spin=1:2:3", "--vary", "spin=1:2:3")
        self.refused(1, ["no parameter"], "stability", SPRINGS, "--vary", "title=1:2:3")
        self.refused(1, ["100000 × 50000 = 5000000000 cells", "1000000"], "stability", SPRINGS, "--vary", "spin=1:2:100000", "--vary", "mass[0][0]=1:2:50000")
        self.refused(1, ["1001 × 1000 = 1001000 cells"], "stability", SPRINGS, "--vary", "spin=1:2:1001", "--vary", "mass[0][0]=1:2:1000")
        self.refused(1, ["two for a chart"], "stability", SPRINGS, "--vary", "spin=1:2:3", "--vary", "mass[0][0]=1:2:3", "--vary", "mass[1][1]=1:2:3")

    def test_damping_of_a_singular_stiffness(self):
        # Relative motion in a circular orbit: one oscillation, two zero roots that take the negative eigenvalue of K; with damping at rest in the turning axes one root grows.
        n = 1e-3
        for rate in (n, n * 2.0**30, n * 2.0**-20):
            hill = self.path / "hill.toml"
            hill.write_text(f'''kind = "matrices"
mass = [[1.0, 0.0], [0.0, 1.0]]
gyroscopic = [[0.0, {-2 * rate!r}], [{2 * rate!r}, 0.0]]
stiffness = [[{-3 * rate**2!r}, 0.0], [0.0, 0.0]]
''')
            r = self.json("stability", hill)
            self.assertEqual(r["index_balance"]["zero_negative"], 1)
            self.assertEqual(r["damping"], {"growing_roots": 1, "destabilised": []})
            self.assertIn("that is at rest in these axes leaves 1 root growing, as K has 1 negative", " ".join(run("stability", hill).stdout.split()))

    def test_margins_and_damping(self):
        r = self.json("stability", MODELS / "rigid_body_minor.toml")
        self.assertEqual(r["damping"]["growing_roots"], 2)
        self.assertEqual(len(r["damping"]["destabilised"]), 1)
        self.assertLess(r["margin"]["stiffness"], 0)
        pair = r["margin"]["opposite_pair"]
        self.assertAlmostEqual((pair[1] - pair[0]) / pair[1], r["margin"]["opposite_sign_gap"], delta=1e-12)
        self.assertEqual(max(abs(complex(a, b)) for a, b in zip(r["negative_modes"][0]["shape"]["re"], r["negative_modes"][0]["shape"]["im"])), 1)


class Hidden(WithFolder):
    TURNED = MODELS / "turned_rotor.toml"

    def test_found_and_solved(self):
        auto, general = self.json("modes", self.TURNED), self.json("modes", self.TURNED, "--method", "general")
        self.assertEqual(auto["structure"]["class"], "hidden_quadrature")
        self.assertIn("hidden quadrature", auto["structure"]["path"])
        self.assertEqual(auto["coverage"]["status"], "complete")
        for a, b in zip(auto["modes"], general["modes"], strict=True):
            self.assertAlmostEqual(a["omega"], b["omega"], delta=1e-12 * b["omega"])
        r = self.json("structure", self.TURNED)["reversing_symmetry"][0]
        self.assertTrue(r["found"] and r["breach"] <= r["threshold"])
        self.assertIn("-20° in the planes (x1, y1), (x2, y2)", r["in_words"])
        reflection = r["reflection"]
        square = [[sum(reflection[i][k] * reflection[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
        for i in range(4):
            for j in range(4):
                self.assertAlmostEqual(square[i][j], i == j, delta=1e-14)

    def test_realified(self):
        out = self.path / "m"
        for model in (self.TURNED, SPRINGS, MODELS / "wiresaw.toml"):
            self.assertEqual(run("convert", model, "-o", out, "--realified", "--transformation", "--quiet").returncode, 0)
            self.assertTrue((out / "W.mtx").exists() and (out / "U.mtx").exists())
            # Its eigenvalues at rest (M = 1, K = W) are the frequencies of the model.
            n = int((out / "W.mtx").read_text().split("\n")[2].split()[0])
            (out / "one.mtx").write_text(f"%%MatrixMarket matrix coordinate real symmetric\n{n} {n} {n}\n" + "".join(f"{i} {i} 1\n" for i in range(1, n + 1)))
            w = self.json("modes", "--mass", out / "one.mtx", "--stiffness", out / "W.mtx")
            m = self.json("modes", model)
            for a, b in zip(w["modes"], m["modes"], strict=True):
                self.assertAlmostEqual(a["omega"], b["omega"], delta=1e-11 * m["modes"][-1]["omega"])
        # K indefinite in both groups: real, upper Hessenberg, by a unitary matrix, and why not symmetric.
        whole = run("convert", MODELS / "rigid_body_minor.toml", "-o", self.path / "unitary", "--realified", "--transformation")
        self.assertEqual(whole.returncode, 0)
        self.assertIn("W is not symmetric", whole.stderr)
        for name in ("W", "U", "Q1", "Q2"):
            self.assertTrue((self.path / "unitary" / f"{name}.mtx").exists())
        self.refused(3, ["second order"], "convert", MODELS / "meirovitch_body.toml", "-o", out, "--realified")
        self.refused(1, ["--realified"], "convert", SPRINGS, "-o", out, "--transformation")

    def test_impedance(self):
        at = self.json("structure", self.TURNED, "--at", "200")["at"]
        n = len(at["H_star"])
        h = [[complex(a, b) for a, b in zip(*row)] for row in zip(at["H"]["re"], at["H"]["im"])]
        u = [[complex(a, b) for a, b in zip(*row)] for row in zip(at["transformation"]["re"], at["transformation"]["im"])]
        size = max(abs(x) for row in h for x in row)
        for i in range(n):
            for j in range(n):
                star = sum(u[k][i].conjugate() * h[k][l] * u[l][j] for k in range(n) for l in range(n))
                self.assertAlmostEqual(abs(star - at["H_star"][i][j]), 0, delta=1e-14 * size)
        self.assertEqual((at["by"], at["negative"], at["determinant_sign"]), ("tridiagonal", 1, -1))
        two = self.path / "two.toml"
        two.write_text('kind = "matrices"\nmass = [[1, 0], [0, 1]]\ngyroscopic = [[0, -1.2], [1.2, 0]]\nstiffness = [[4, 0.6], [0.6, 7]]\n')
        at = self.json("structure", two, "--at", "1.3")["at"]
        self.assertEqual(at["by"], "angle")
        self.assertAlmostEqual(math.tan(2 * at["psi"]), 1.2 / (4 - 7), delta=1e-14)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
