"""Matrices from files of any format, by the program: one file or three, names, damping in the container, and back by convert."""
import pathlib
import subprocess
import sys
import tempfile

program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
files = source / "tests" / "formats" / "files"
failures = []


def run(*arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=files, timeout=120)


def frequencies(*arguments):
    result = run("modes", *arguments, "--format", "csv")
    return [line.split(",")[0] for line in result.stdout.splitlines()[1:]] if result.returncode == 0 else result.stderr


def check(what, found, expected):
    if found != expected:
        failures.append(f"{what}: {found!r} where {expected!r} was expected")


def refused(words, code, *arguments):
    result = run("modes", *arguments)
    check(arguments, (result.returncode, words in result.stderr, result.stderr.count("\n")), (code, True, 1))
    if words not in result.stderr:
        failures.append(result.stderr)


expected = frequencies("--matrices", "stored.npz")
check("three modes", len(expected), 3)
for arguments in (
    ["--matrices", "deflated.npz"],
    ["--matrices", "scipy_v4.mat"],
    ["--matrices", "scipy_v5.mat"],
    ["--matrices", "octave_v7.mat"],
    ["--matrices", "scipy_compressed.mat"],
    ["--matrices", "scipy_compressed.mat", "--names", "M=Mass,G=Gyro,K=Stiff"],
    ["--mass", "M.npy", "--gyroscopic", "stored.npz:G", "--stiffness", "K_csr.npz"],
    ["--mass", "M_big_endian.npy", "--gyroscopic", "G_scipy.mtx", "--stiffness", "K_scipy.hb"],
):
    check(arguments, frequencies(*arguments), expected)

refused("holds a damping matrix 'C' that is not 0: damping is not served", 3, "--matrices", "with_damping.mat")
refused("holds no matrix 'Q' for M: it has G, K, M", 2, "--matrices", "stored.npz", "--names", "M=Q")
refused("--names Mass: M=NAME, G=NAME or K=NAME was expected", 1, "--matrices", "stored.npz", "--names", "Mass")
refused("--names goes with --matrices", 1, "--mass", "M.npy", "--stiffness", "K_csr.npz", "--names", "M=M")
refused("holds 3 matrices (G, K, M): one was expected, chosen as stored.npz:NAME", 2, "--mass", "stored.npz", "--stiffness", "K_csr.npz")
refused("holds no mass matrix that is known by its name: it has K_csr", 2, "--matrices", "K_csr.npz")

with tempfile.TemporaryDirectory() as folder:
    names = pathlib.Path(folder) / "job.dof"
    names.write_text("1.1\n1.2\n2.1\n")
    check("labels", all(label in run("modes", "--matrices", "stored.npz", "--labels", names, "--shapes").stdout for label in ("1.1", "1.2", "2.1")), True)
    refused("--labels goes with matrix files; a model file has the key labels", 1, source / "models" / "geos.toml", "--labels", names)
    names.write_text("1.1\n1.2\n")
    refused("job.dof: has 2 labels: 3 were expected, one a coordinate", 2, "--matrices", "stored.npz", "--labels", names)

with tempfile.TemporaryDirectory() as folder:
    out = pathlib.Path(folder)
    model = source / "models" / "turned_rotor.toml"
    expected = frequencies(model)
    for name in ("r.mat", "r.npz", "r.toml"):
        check(name, run("convert", model, "-o", out / name).returncode, 0)
        check(name, frequencies(*([] if name == "r.toml" else ["--matrices"]), out / name), expected)
    for form in ("mtx", "npy", "csv"):
        check(form, run("convert", model, "-o", out / form, "--to", form).returncode, 0)
        check(form, frequencies("--mass", out / form / f"M.{form}", "--gyroscopic", out / form / f"G.{form}", "--stiffness", out / form / f"K.{form}"), expected)
    check("r.txt", run("convert", model, "-o", out / "r.txt").returncode, 1)
    # A list of numbers is a diagonal; K may be left out; a variable of a container; two DMIG files of different rows.
    (out / "lumped.toml").write_text('kind = "matrices"\nmass = [1, 2]\ngyroscopic = [[0, 3], [-3, 0]]\n')
    check("lumped", frequencies(out / "lumped.toml")[-1][:7], "2.12132")
    (out / "of.toml").write_text(f'kind = "matrices"\nmass = "{files}/stored.npz:M"\nstiffness = "{files}/K_csc.npz"\n')
    check("of", len(frequencies(out / "of.toml")), 3)
    (out / "M.pch").write_text("DMIG,M,0,6,2,0\nDMIG,M,1,1,,1,1,10.\n")
    (out / "K.pch").write_text("DMIG,K,0,6,2,0\nDMIG,K,1,1,,1,1,1000.\n,2,1,-1000.\nDMIG,K,2,1,,2,1,3000.\n")
    check("massless rows of DMIG", frequencies("--mass", out / "M.pch", "--stiffness", out / "K.pch")[0][:15], "8.1649658092772")

for failure in failures:
    print(failure)
print(f"{len(failures)} failures with matrix files")
sys.exit(bool(failures))
