"""CalculiX's own test 'rotor', from its deck to certified modes and over the spin: exit code 77 where CalculiX or its tests are not installed."""
import gzip
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

program = pathlib.Path(sys.argv[1]).resolve()
deck = pathlib.Path("/usr/share/doc/calculix-ccx-test/examples/test/rotor.inp.gz")
if not shutil.which("ccx") or not deck.exists():
    print("CalculiX or its tests are not installed")
    sys.exit(77)
SPIN = 3.0853e8 ** 0.5
MODEL = """kind = "structure"
mass = "{0}.mas"
stiffness = "{0}.sti"
dofs = "{0}.dof"
coordinates = "{0}.inp"
spin = {1!r}
axis = [0, 0, 1]
"""


def stored(folder, job, lines):
    (folder / f"{job}.inp").write_text("\n".join(lines) + "\n")
    subprocess.run(["ccx", "-i", job], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)


def answer(folder, *arguments):
    done = subprocess.run([program, *arguments, "--format", "json", "--quiet"], cwd=folder, capture_output=True, text=True, timeout=300)
    return done, json.loads(done.stdout)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    lines = gzip.open(deck, "rt").read().splitlines()
    step = next(k for k, line in enumerate(lines) if line.lower().startswith("*step"))
    at = next(k for k, line in enumerate(lines) if line.lower().startswith("*frequency"))
    store = ["*FREQUENCY, SOLVER=MATRIXSTORAGE", " 10,", "*END STEP"]
    stored(folder, "disc", [*lines[:at], *store])
    stored(folder, "half", [line.replace("3.0853e8", "0.771325e8") for line in lines[:at]] + store)
    stored(folder, "rest", [*lines[:step], "*STEP", *store])
    (folder / "disc.toml").write_text(MODEL.format("disc", SPIN))
    (folder / "half.toml").write_text(MODEL.format("half", SPIN / 2))
    (folder / "over.toml").write_text(MODEL.format("disc", SPIN) + 'stiffness_at_rest = "rest.sti"\n')
    done, result = answer(folder, "modes", "disc.toml", "--below", "2.1e5")
    half = answer(folder, "modes", "half.toml", "--lowest", "4")[1]["modes"]
    over = answer(folder, "campbell", "over.toml", "--spin", f"0:{SPIN!r}:3", "--lowest", "4")[1]
failures = 0


def expect(condition, what):
    global failures
    if not condition:
        failures += 1
        print(f"not so: {what}")


modes = result["modes"]
negative = [m["omega"] for m in modes if m["energy_sign"] < 0]
expect(done.returncode == 0, f"exit 0, but {done.returncode}: {done.stderr}")
expect(len(modes) == 26, f"26 modes, but {len(modes)}")
expect(result["coverage"]["status"] == "complete", f"complete, but {result['coverage']}")
expect(len(negative) == 1 and abs(negative[0] - 11737.65) < 0.1, f"one of negative energy at 11737.65 rad/s, but {negative}")
expect(result["stability"] == "gyroscopically_stabilised", f"gyroscopically stabilised, but {result['stability']}")
expect(max(m["residual"] for m in modes) < 1e-10, "residuals below 1e-10")
expect("mirror plane" in result["structure"]["path"], f"its mirror plane found, but {result['structure']['path']}")
# K at half the spin from those at rest and at the whole, against that of its own deck; a nonlinear static step is not quite of second order.
expect(over["coverage"] == ["complete"] * 3, f"complete at three spins, but {over['coverage']}")
middle = sorted(b["omega"][1] for b in over["branches"] if b["omega"][1] is not None)
expect(len(middle) == 4 and all(abs(a - b["omega"]) < 1e-5 * b["omega"] for a, b in zip(middle, half)), f"{[m['omega'] for m in half]} at half the spin, but {middle}")
print(f"{len(modes)} modes of CalculiX's rotor, {failures} failures")
sys.exit(failures > 0)
