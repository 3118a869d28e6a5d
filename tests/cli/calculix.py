"""CalculiX's own test 'rotor', from its deck to certified modes: exit code 77 where CalculiX or its tests are not installed."""
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
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    lines = gzip.open(deck, "rt").read().splitlines()
    at = next(k for k, line in enumerate(lines) if line.lower().startswith("*frequency"))
    (folder / "disc.inp").write_text("\n".join([*lines[:at], "*FREQUENCY, SOLVER=MATRIXSTORAGE", " 10,", "*END STEP", ""]))
    subprocess.run(["ccx", "-i", "disc"], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)
    (folder / "disc.toml").write_text(
        'kind = "structure"\nmass = "disc.mas"\nstiffness = "disc.sti"\ndofs = "disc.dof"\ncoordinates = "disc.inp"\n'
        f"spin = {3.0853e8 ** 0.5!r}\naxis = [0, 0, 1]\n")
    done = subprocess.run([program, "modes", "disc.toml", "--below", "2.1e5", "--format", "json", "--quiet"],
                          cwd=folder, capture_output=True, text=True, timeout=300)
    result = json.loads(done.stdout)
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
print(f"{len(modes)} modes of CalculiX's rotor, {failures} failures")
sys.exit(failures > 0)
