"""What people get wrong, and the one line that tells them what to do: exit code and words of each."""
import pathlib
import subprocess
import sys
import tempfile

program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
models, files = source / "models", source / "tests" / "formats" / "files"
failures = []
ONE = 'kind = "matrices"\nmass = [[1, 0], [0, 1]]\nstiffness = [[4, 0], [0, 9]]\n'


def said(code, words, *arguments, model=None, files={}):
    with tempfile.TemporaryDirectory() as folder:
        here = pathlib.Path(folder)
        (here / "m.toml").write_text(ONE if model is None else model)
        for name, text in files.items():
            (here / name).parent.mkdir(exist_ok=True)
            (here / name).write_text(text)
        result = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=here, timeout=120)
        kept = (here / "m.toml").read_text() == (ONE if model is None else model)
    what = " ".join(map(str, arguments))
    if result.returncode != code:
        failures.append(f"{what}: exit code {result.returncode}, not {code}: {result.stderr}")
    elif code != 0 and (words not in result.stderr or result.stderr.count("\n") != 1):
        failures.append(f"{what}: {result.stderr!r} does not say {words!r} in one line")
    elif code == 0 and words not in result.stdout + result.stderr:
        failures.append(f"{what}: {(result.stdout + result.stderr)[:200]!r} does not say {words!r}")
    if not kept:
        failures.append(f"{what}: the model was overwritten")


def silent(*arguments, model):
    """No word on stderr."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "m.toml").write_text(model)
        result = subprocess.run([program, *arguments], capture_output=True, text=True, cwd=folder, timeout=120)
    if result.returncode != 0 or result.stderr:
        failures.append(f"{arguments} {model!r}: {result.returncode}, {result.stderr}")


# Verbs and options
said(1, "'m.toml' is no verb: a verb comes first, such as gyromode modes m.toml", "m.toml")
said(1, "'mode' is no verb: did you mean 'modes'?", "mode", "m.toml")
said(1, "'analyse' is no verb: one of modes", "analyse", "m.toml")
said(1, "'--windw' is no option of modes: did you mean '--window'?", "modes", "m.toml", "--windw", "1:2")
said(0, "Usage: gyromode modes", "help", "modes")
said(0, "Usage: gyromode", "help")
said(0, "gyromode 0.", "-V")
said(1, "'0' is no whole number above 0", "modes", "m.toml", "--lowest", "0")
for amount in ("much", "12XB", "-3GB", "5", "0GB", "1e400GB"):
    said(1, f"--memory {amount}: an amount of memory from 1 MB on was expected, such as 12GB or 800MB", "modes", "m.toml", f"--memory={amount}")
said(1, "Directory does not exist: nowhere", "modes", "m.toml", "--scratch", "nowhere")
for amount in ("12GB", "800 MB", "1.5gib", "2e9"):
    said(0, "complete", "modes", "m.toml", "--memory", amount)
said(1, "'five' is no whole number above 0", "modes", "m.toml", "--lowest", "five")
said(1, "'' is no frequency", "modes", "m.toml", "--below", "")
said(0, "complete: found 2", "modes", "m.toml", "--below", "50 Hz")
said(0, "complete: found 2", "modes", "m.toml", "--below", "1MHz")
said(0, "complete: found 0", "modes", "m.toml", "--below", "5mHz")
said(0, "complete: found 2", "modes", "m.toml", "--below", "300RPM")
said(0, "complete: found 2", "modes", "m.toml", "--below", "300 rev/min")
said(1, "would overwrite the input", "modes", "m.toml", "-o", "m.toml", "--format", "table")
said(1, "'.xlsx' is no format that is written: .json, .csv, .md, .html, .svg or .txt", "modes", "m.toml", "-o", "out.xlsx")
said(0, "t,q1,q2", "response", "m.toml", "--force", "impulse:q1=5N", "--until", "1s", "--step", "250ms")
said(1, "'1 parsec' is no time: a number in s, or one with a unit", "response", "m.toml", "--force", "step:q1=1", "--until", "1 parsec", "--step", "1")
said(1, "is no finite number, alone or with N", "response", "m.toml", "--force", "step:q1=5lbf", "--until", "1", "--step", "1")
said(1, "'q9' is no coordinate of the model: did you mean 'q1'?", "response", "m.toml", "--force", "step:q9=1", "--until", "1", "--step", "1")
said(1, "a fraction of the largest entry, from 0 to 2", "modes", "m.toml", "--symmetrise=3")
said(1, "'bogus' is no parameter of the model: one of", "stability", "m.toml", "--vary", "bogus=1:2:3")
said(0, "          10   stable", "stability", models / "rigid_body.toml", "--vary", "spin=30rpm:10rpm:3")
# Labels that the grammar of lists would part, and positions
ODD = 'kind = "matrices"\nlabels = ["a,b", "c=d", "say \\"x\\""]\nmass = [1, 1, 1]\nstiffness = [[4, 1, 0], [1, 9, 1], [0, 1, 16]]\n'
steps = ["--until", "1", "--step", "1"]
for named in ('"a,b"=1', "c=d=1", '"c=d"=1', "#2=1", '"say ""x"""=1', 'say "x"=1', '"a,b"=1,#2=2,#3=3'):
    said(0, "t,", "response", "m.toml", "--force", "step:" + named, *steps, model=ODD)
said(0, "t,", "response", "m.toml", "--force", 'harmonic:"a,b"=1@2Hz', *steps, model=ODD)
said(1, "#4 is beyond the 3 coordinates of the model", "response", "m.toml", "--force", "step:#4=1", *steps, model=ODD)
said(1, "'a' where LABEL=VALUE was expected", "response", "m.toml", "--force", "step:a,b=1", *steps, model=ODD)
said(0, "complete: found 3", "modes", "m.toml", "--keep", '"a,b",#2', model=ODD)
said(1, "--keep: 'a' is no coordinate of the model: one of a,b, c=d", "modes", "m.toml", "--keep", "a,b", model=ODD)
# Initial states as spreadsheets write them; times before 0
said(0, "t,q1,q2\n0,0.5,0", "response", "m.toml", "--initial", "start.csv", *steps, files={"start.csv": "\ufefflabel;q;qdot\r\nq1;0.5;0\r\nq2;0;1\r\n"})
said(2, "'0,5' is no number: a finite number was expected, with a decimal point", "response", "m.toml", "--initial", "start.csv", *steps, files={"start.csv": "label;q;qdot\nq1;0,5;0\nq2;0;1\n"})
said(2, "t ≥ 0 was expected", "response", "m.toml", "--force", "step:q1=1", "--times", "t.csv", files={"t.csv": "-1\n0\n"})
# Maps: why there is no model, what changes, in which unit
said(3, "--vary: no point makes a model; at the first M must be positive definite", "stability", "m.toml", "--vary", "mass[0][0]=-3:-1:3")
said(0, "no model at 2 of 4 points: at mass[0][0] = -3 M must be positive definite", "stability", "m.toml", "--vary", "mass[0][0]=-3:3:4")
said(0, "spin [rpm]  what changes", "stability", models / "three_springs.toml", "--vary", "spin=0:12000rpm:25")
said(0, "stable → 1 divergent", "stability", models / "three_springs.toml", "--vary", "spin=0:12000rpm:25")
said(0, "1 divergent → gyroscopically stabilised", "stability", models / "three_springs.toml", "--vary", "spin=0:12000rpm:25")
# Lawful, but probably meant otherwise
TURNING = 'kind = "matrices"\nspin = 2\nmass = [3, 3]\nstiffness = [27, 48]\nstiffness_per_spin2 = [[-3, 0], [0, -3]]\n'
said(0, "softens with the spin, as in turning axes, and there is no gyroscopic_per_spin", "modes", "m.toml", model=TURNING)
said(0, "gyroscopic_per_spin is 0.5 of the Coriolis forces 2ΩM that belong to the softening", "modes", "m.toml", model=TURNING + "gyroscopic_per_spin = [[0, -3], [3, 0]]\n")
silent("modes", "m.toml", model=TURNING + "gyroscopic_per_spin = [[0, -6], [6, 0]]\n")
silent("modes", "m.toml", model=TURNING + 'frame = "fixed"\n')
said(0, "K is indefinite and G = 0: if K holds the softening of turning axes", "modes", "m.toml", model='kind = "matrices"\nmass = [1, 1]\nstiffness = [-2, 3]\n')
said(0, "'u_x [mm]' is in mm: with K in N/mm the masses are in t", "modes", "m.toml", model=ONE + 'labels = ["u_x [mm]", "u_y [mm]"]\n')
said(0, "lower by 31.62 than those known of the model: mm and N with kg", "modes", "m.toml", model=ONE + "known = {frequencies = [63.2456, 94.8683]}\n")
said(0, "higher by 6.283 than those known of the model: Hz given", "modes", "m.toml", model=ONE + "known = {frequencies = [0.31831, 0.477465]}\n")
silent("modes", "m.toml", model=ONE + "known = {frequencies = [2, 3]}\n")
# Rotors and critical speeds
ROTOR = (models / "rotors" / "two_discs.toml").read_text()
said(3, "disk 2: position 2 m is off the shaft, which reaches from 0 to 1.5 m", "modes", "m.toml", model=ROTOR.replace("position = 1.0", "position = 2.0"))
said(3, "'kyx' = 5 must equal 'kxy' = 0: an unsymmetric pair is circulatory", "modes", "m.toml", model=ROTOR.replace("kyy = 1e6", "kyy = 1e6\nkyx = 5"))
said(3, "'cxx' = 10 is damping, which is not served", "modes", "m.toml", model=ROTOR.replace("kyy = 1e6", "kyy = 1e6\ncxx = 10"))
said(3, "material 'stel' is not given: a table [material.stel] was expected: did you mean 'steel'?", "modes", "m.toml", model=ROTOR.replace('material = "steel"', 'material = "stel"', 1))
said(2, "m.toml:12: key 'outer_diameter' is missing", "modes", "m.toml", model=ROTOR.replace('outer_diameter = "50 mm"', "", 1))
said(2, "'elements' = 2.5: a whole number was expected", "modes", "m.toml", model=ROTOR.replace("elements = 6", "elements = 2.5"))
said(2, "'bernoulli' is no theory of shafts: timoshenko, rayleigh or euler", "modes", "m.toml", model=ROTOR.replace("elements = 6", 'elements = 6\ntheory = "bernoulli"'))
said(2, "one of 'shear' (shear modulus) and 'poisson'", "modes", "m.toml", model=ROTOR.replace("shear = 81.2e9", ""))
said(3, "'LP' is no spool of the rotor", "modes", "m.toml", model=ROTOR.replace("kyy = 1e6", 'kyy = 1e6\nto = "LP"'))
said(2, "'z' is no direction: \"x\", \"y\"", "modes", "m.toml", model=ROTOR.replace("[known]", '[[support]]\nposition = 0\nfixed = ["z"]\n[known]'))
said(0, "parts at 1 and 1.00001 m are 1e-05 m apart", "modes", "m.toml", model=ROTOR.replace("[known]", "[[point_mass]]\nposition = 1.00001\nmass = 1\n[known]"))
said(3, "critical speeds need a rotor, or matrices with 'spin'", "critical", "m.toml")
said(1, "--order x: a multiple of the speed was expected", "critical", "m.toml", "--order", "x", model=ROTOR)
said(0, "  2   86.9042", "critical", "m.toml", "--lowest", "4", model=ROTOR)
said(1, "--over bearing[0].kxx=-1:1:3: bounds above 0 were expected", "critical", "m.toml", "--over", "bearing[0].kxx=-1:1:3", model=ROTOR)
said(1, "--over: 'bearing[0].kx' is no parameter of the model: did you mean 'bearing[0].kxx'?", "critical", "m.toml", "--over", "bearing[0].kx=1:2:3", model=ROTOR)
said(1, "'0' is no whole number above 0", "critical", "m.toml", "--lowest", "0", model=ROTOR)
said(1, "such as bearing[*].kxx=1e5:1e8:31", "critical", "m.toml", "--over", "bearing[0].kxx=1:2", model=ROTOR)
said(0, " 825.1338   829.8745", "critical", "m.toml", "--over", "bearing[*].kxx,bearing[*].kyy=1e5:1e7:3", "--below", "2000rpm", model=ROTOR)
said(3, "--over: no value makes a model; at the first", "critical", "m.toml", "--over", "shaft[0].inner_diameter=1:2:3", model=ROTOR)
said(0, "bearing 1: kxx = 1e-07 is lost by rounding beside the shaft's stiffness", "critical", "m.toml", "--lowest", "4", model=ROTOR.replace("kxx = 1e6", "kxx = 1e-7"))
# Campbell diagrams
said(1, "--spin is required", "campbell", "m.toml", model=ROTOR)
said(1, "--spin 0:5: A:B:N was expected", "campbell", "m.toml", "--spin", "0:5", model=ROTOR)
said(1, "a number of points from 2 to 1000000 was expected", "campbell", "m.toml", "--spin", "0:5:0", model=ROTOR)
said(1, "two different frequencies", "campbell", "m.toml", "--spin", "5:5:3", model=ROTOR)
said(0, "0 … 100 rpm, 3", "campbell", "m.toml", "--spin", "100rpm:0rpm:3", model=ROTOR)
said(1, "multiples of the speed were expected, such as 1 or 0.5,1,2", "campbell", "m.toml", "--spin", "0:100:3", "--order", "1,x", model=ROTOR)
said(3, "a sweep over the spin needs a rotor, a spacecraft, or matrices with 'spin'", "campbell", "m.toml", "--spin", "0:100:3")
said(0, "f [Hz] at 0 Hz", "campbell", "m.toml", "--spin", "0:9000rpm:4", "--units", "Hz", model=ROTOR)
said(1, "--units", "campbell", "m.toml", "--spin", "0:100:3", "--units", "rps", model=ROTOR)
# Structures
STRUCTURE = 'kind = "structure"\nmass = "a.mas"\nstiffness = "a.sti"\ndofs = "a.dof"\nspin = 1\n'
FILES = {"a.mas": "1 1 2.0\n2 2 2.0\n", "a.sti": "1 1 9.0\n2 2 8.0\n", "a.dof": "7.1\n7.2\n"}
def of_mesh(code, words, *more, files={}, text=STRUCTURE):
    said(code, words, *more, "m.toml", model=text, files={**FILES, **files})
of_mesh(0, "complete: found 1", "modes", "--lowest", "1")
of_mesh(2, "a.dof:2: '7' is no coordinate: node.direction was expected", "modes", "--lowest", "1", files={"a.dof": "7.1\n7\n"})
of_mesh(2, "a.dof:2: '7.1' is given a second time (first on line 1)", "modes", "--lowest", "1", files={"a.dof": "7.1\n7.1\n"})
of_mesh(2, "a.mas:2: entry (3, 3) is outside a matrix of order 2, which the others give", "modes", "--lowest", "1", files={"a.mas": "1 1 2.0\n3 3 2.0\n"})
of_mesh(2, "a.sti:2: '2 2' is no entry: row, column and a finite number were expected", "modes", "--lowest", "1", files={"a.sti": "1 1 9.0\n2 2"})
of_mesh(0, "complete: found 1", "modes", "--lowest", "1", files={"a.sti": "1 1 9.0\n1 2 1\n2 1 1\n2 2 8.0\n"})
of_mesh(3, "entry (2, 1) is 2 and entry (1, 2) is 1: a symmetric matrix was expected", "modes", "--lowest", "1", files={"a.sti": "1 1 9.0\n1 2 1\n2 1 2\n2 2 8.0\n"})
of_mesh(2, "gives an entry twice: each entry once was expected", "modes", "--lowest", "1", files={"a.sti": "1 1 9.0\n1 1 1\n2 2 8.0\n"})
of_mesh(0, "dense: 2 coordinates, some 1 MB", "modes", "--dry-run")
OWN_G = STRUCTURE.replace("spin = 1", 'gyroscopic = "a.gyr"')
of_mesh(0, "complete: found 1", "modes", "--lowest", "1", text=OWN_G, files={"a.gyr": "2 1 0.5\n"})
of_mesh(2, "'spin' is for G that is made of M, and 'gyroscopic' gives G by its own file", "modes", text=OWN_G + "spin = 1\n", files={"a.gyr": "2 1 0.5\n"})
of_mesh(2, "a.gyr:1: entry (1, 1) = 2 is on the diagonal of a skew matrix: zero was expected", "modes", text=OWN_G, files={"a.gyr": "1 1 2\n"})
of_mesh(2, "key 'dofs' is missing: a file was expected", "modes", "--lowest", "1", text=STRUCTURE.replace('dofs = "a.dof"\n', ""))
of_mesh(2, "cannot be opened", "modes", "--lowest", "1", text=STRUCTURE.replace("a.sti", "b.sti"))
of_mesh(3, "mass couples 7.y and 7.x", "modes", "--lowest", "1", files={"a.mas": "1 1 2.0\n1 2 0.5\n2 2 2.0\n"})
of_mesh(3, "node 7 has rotations (direction 4)", "modes", "--lowest", "1", files={"a.dof": "7.1\n7.4\n"})
of_mesh(3, "M must be positive definite: its diagonal entry of 7.x is -2", "modes", "--lowest", "1", files={"a.mas": "1 1 -2.0\n2 2 -2.0\n"})
MESH = STRUCTURE + 'coordinates = "a.csv"\n'
def placed(code, words, nodes="node,x,y,z\n7,1,0,0\n", more=""):
    of_mesh(code, words, "modes", "--lowest", "1", files={"a.csv": nodes}, text=MESH + more)
placed(0, "complete: found 1")
placed(0, "complete: found 1", nodes="** deck\n*NODE, NSET=all\n7, 1.0, 0.\n*ELEMENT, TYPE=C3D8\n1,7,7\n")
placed(2, "a.csv: has no node 7, which a.dof has coordinates of", nodes="8,1,0,0\n")
placed(2, "a.csv:1: node 7 has 2 coordinates: node,x,y,z was expected", nodes="7,1,0\n")
placed(2, "a.csv:2: 'x' is no coordinate of node 7: a number was expected", nodes="node,x,y,z\n7,x,0,0\n")
placed(2, "a.csv:2: node 7 is given a second time (first on line 1)", nodes="7,1,0,0\n7,1,0,0\n")
placed(2, "has no *NODE block with nodes in it", nodes="*INCLUDE, INPUT=b.inp\n")
placed(2, "'mirror' has 2 numbers: the three of a direction were expected", more="mirror = [0, 1]\n")
placed(2, "'mirror' and 'half_turn' are given: one of them was expected", more="mirror = [0, 1, 0]\nhalf_turn = [1, 0, 0]\n")
placed(3, "mirror plane with normal z, through the axis of the spin does not reverse the spin", more="mirror = [0, 0, 1]\n")
of_mesh(3, "needs the positions of the nodes: give coordinates =", "modes", "--lowest", "1", text=STRUCTURE + "mirror = [0, 1, 0]\n")
# Unbalance
def unbalanced(code, words, what, *more, model=ROTOR):
    said(code, words, "response", "m.toml", "--unbalance", what, *more, model=model)
unbalanced(1, "'disk1' where PLACE=UNBALANCE was expected, such as disk2=1e-4", "disk1", "--spin", "0:100:3")
unbalanced(1, "'heavy' is no unbalance: a number in kg m, or one with a unit", "disk1=heavy", "--spin", "0:100:3")
unbalanced(1, "'left' is no phase: a number in rad", "disk1=1e-4@left", "--spin", "0:100:3")
unbalanced(1, "unbalance 'disk9': there are 1 to", "disk9=1e-4", "--spin", "0:100:3")
unbalanced(1, "unbalance 'station99': there are stations 1 to", "station99=1e-4", "--spin", "0:100:3")
unbalanced(1, "disk1, point_mass1, bearing1 or station1 was expected, counted from 1: did you mean 'station'?", "statoin1=1e-4", "--spin", "0:100:3")
unbalanced(1, "the rotor has none of these", "point_mass1=1e-4", "--spin", "0:100:3")
unbalanced(1, "the unbalance is zero", "disk1=0", "--spin", "0:100:3")
unbalanced(1, "it goes with --spin A:B:N, and no forces", "disk1=1e-4", "--force", "x1=1", "--frequencies", "1:2:3")
unbalanced(3, "unbalance needs places that go round: a rotor, or matrices with 'orbits'", "x=1", "--spin", "0:100:3", model=None)
unbalanced(0, "0.0001 kg m at disc1 (90° ahead of x)", "disc1=100 g mm@90deg", "--spin", "0:10:3", "--format", "table")
said(1, "--spin goes with --unbalance", "response", "m.toml", "--spin", "0:100:3", model=ROTOR)
said(2, "'y9' is no label of the model", "modes", "m.toml", model=ONE + 'labels = ["x1", "y1"]\norbits = [["x1", "y9"]]\n')
said(2, "'orbits' is an array of pairs of names", "modes", "m.toml", model=ONE + 'orbits = ["q1", "q2"]\n')
said(2, "'q1' is given twice", "modes", "m.toml", model=ONE + 'orbits = [["q1", "q1"]]\n')
said(3, "the model must say frame", "response", "m.toml", "--unbalance", "q1=1", "--spin", "0:1:3",
     model=ONE + 'spin = 1\ngyroscopic_per_spin = [[0, 1], [-1, 0]]\norbits = [["q1", "q2"]]\n')
said(0, "[0, 50) Hz", "modes", "m.toml", "--below", "50Hz", model=ROTOR)
# The file at fault, of three
WIRES = [str(models / "wiresaw" / f"{m}.mtx") for m in "MGK"]
said(3, "M.mtx: G must satisfy G = −Gᵀ: the diagonal entry (1,1) = 0.5 must be 0, it is 1e+02 % of the largest entry; G is the same matrix as M: was", "modes", "--mass", WIRES[0], "--gyroscopic", WIRES[0], "--stiffness", WIRES[2])
said(3, "(10,9) = 0.18947368421052632 differ by 0.379, 2e+02 % of the largest entry; K is the same matrix as G: was", "modes", "--mass", WIRES[0], "--gyroscopic", WIRES[1], "--stiffness", WIRES[1])

# Tables: digits that are determined, like lines as one, lines of a terminal's width; Markdown that shows labels as they are
TWINS = 'kind = "matrices"\nlabels = ["a_*", "b|c", "<d>"]\nmass = [1, 1, 1]\nstiffness = [4, 4, 0]\n'
said(0, "    1  0                 0                  0   0.0e+00  rigid body\n  2–3  2.0000", "modes", "m.toml", model=TWINS)
said(0, "vibration ×2", "modes", "m.toml", model=TWINS)
said(0, "| # | a\\_\\* | b\\|c | \\<d\\> |", "modes", "m.toml", "--shapes", "--format", "markdown", model=TWINS)
for model in sorted(models.glob("*.toml")):
    silent("modes", str(model), "--lowest", "2", model="")
    for verb in (["modes", model, "--lowest", "3", "--shapes"], ["stability", model], ["structure", model], ["help", "response"]):
        text = subprocess.run([program, *map(str, verb)], capture_output=True, text=True, timeout=120).stdout
        for line in text.splitlines():
            if len(line) > 82 and not line.startswith(("  gyromode ", "  --method")):
                failures.append(f"{verb}: a line of {len(line)} columns: {line}")

# Files
said(2, "is a matrix file (Matrix Market), no model: --mass", "modes", models / "wiresaw" / "M.mtx")
said(2, "is a matrix file (NumPy), no model", "modes", files / "M.npy")
said(2, "is a matrix file (MATLAB), no model", "modes", files / "scipy_v5.mat")
said(2, "the NumPy array is complex", "modes", "--mass", files / "complex.npy", "--stiffness", files / "K_csr.npz")
# Keys by the names that people give them
for key, words in {
    "damping": "damping is not served; leave it out",
    "C": "damping is not served; leave it out",
    "M": "did you mean 'mass'?",
    "K": "did you mean 'stiffness'?",
    "coriolis": "did you mean 'gyroscopic'?",
    "omega": "did you mean 'spin'?",
    "rpm": "did you mean 'spin'?",
    "dofs": "did you mean 'labels'?",
    "symmetrize": "did you mean 'symmetrise'?",
    "stifness": "did you mean 'stiffness'?",
    "colour": "one of ",
}.items():
    said(2, words, "modes", "m.toml", model=ONE + f"{key} = 1\n")
for key, words in {"wire": "did you mean 'cable'?", "boom": "did you mean 'cable'?", "hub": "did you mean 'body'?", "rpm": "did you mean 'spin'?"}.items():
    said(2, words, "modes", "m.toml", model=f'kind = "spacecraft"\n{key} = 1\n')
craft = (models / "geos.toml").read_text()
said(2, "are written [[cable]], in double brackets", "modes", "m.toml", model=craft.replace("[[cable]]", "[cable]"))
said(2, "tables [[cable]] were expected", "modes", "m.toml", model='kind = "spacecraft"\nspin = 1\n[body]\nmass = 1\ninertia = [1, 1, 1]\n[cable]\nlength = 1\n')
said(3, 'a bare number is in rad, degrees are written "90 deg"', "modes", "m.toml", "--lowest", "2",
     model='kind = "spacecraft"\nspin = 1\n[body]\nmass = 100\ninertia = [10, 11, 15]\n' + "".join(
         f"[[cable]]\nazimuth = {a}\nradius = 0.5\nheight = 0\nlength = 10\nline_density = 0.01\n" for a in (90, 270)))
# Structures over the spin
chain = {f"structure/{name.name}": name.read_text() for name in (models / "structure").iterdir()}
turning = (models / "structure.toml").read_text()
at_rest = 'stiffness_at_rest = "structure/chain_rest.sti"\n'
still = turning.replace(at_rest, "")
needs = "give K of the same mesh at rest, too, by the key 'stiffness_at_rest'"
said(3, needs, "campbell", "m.toml", "--spin", "0:1:3", model=still, files=chain)
said(3, needs, "critical", "m.toml", model=still, files=chain)
said(3, needs, "stability", "m.toml", "--vary", "spin=0:1:3", model=still, files=chain)
said(3, needs, "modes", "m.toml", "--sensitivity=spin", model=still, files=chain)
said(2, "needs 'spin' = that of 'stiffness', not 0", "modes", "m.toml", model=turning.replace("spin = 0.3", "spin = 0"), files=chain)
said(2, "entry (17, 17) is 0: of a structure at rest it is above 0; is the file whole", "modes", "m.toml", model=turning,
     files=chain | {"structure/chain_rest.sti": "".join(chain["structure/chain_rest.sti"].splitlines(keepends=True)[:30])})
said(0, "was 'stiffness' made at that spin?", "modes", "m.toml", model=turning.replace("spin = 0.3", "spin = 0.9"), files=chain)
said(1, "did you mean 'spin'?", "modes", "m.toml", "--sensitivity=speed", model=turning, files=chain)
# Laws
said(3, "'q2' has neither mass nor", "modes", "m.toml", model='kind = "matrices"\nmass = [1, 0]\nstiffness = [1, 0]\n')
said(3, "this is damping", "modes", "m.toml", model=ONE + "gyroscopic = [[0.1, 1], [-1, 0.1]]\n")
said(3, "circulatory", "modes", "m.toml", model=ONE.replace("[[4, 0], [0, 9]]", "[[4, 1], [-1, 9]]"))
said(3, "K must satisfy", "modes", "m.toml", "--strict", model=ONE.replace("[[4, 0], [0, 9]]", "[[4, 1], [1.0000000000000002, 9]]"))
# Formulas
said(2, "'nu' is no parameter: there are mu", "modes", "m.toml", model=ONE.replace("4, 0", '"nu", 0') + "[parameters]\nmu = 1\n")
said(2, "is infinite", "modes", "m.toml", model=ONE.replace("4, 0", '"1/mu", 0') + "[parameters]\nmu = 0\n")
said(0, "of the matrices as symmetrised", "modes", "m.toml", "--symmetrise", model=ONE.replace("[[4, 0], [0, 9]]", "[[4, 1], [1.001, 9]]"))

for failure in failures:
    print(failure)
print(f"{len(failures)} failures of messages")
sys.exit(bool(failures))
