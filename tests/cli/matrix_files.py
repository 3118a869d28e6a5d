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

def kept(name, text):
    """A file of that text or bytes in the folder of the case."""
    place = pathlib.Path(case.name) / name
    place.write_bytes(text if isinstance(text, bytes) else text.encode())
    return place


# What was read wrongly in silence once: never again.
case = tempfile.TemporaryDirectory()
TWO = kept("m.csv", "2 0\n0 3\n")
whole = (files / "scipy_v5.mat").read_bytes()
for cut in (8, 40, 120):
    refused("ends within a variable", 2, "--matrices", kept("cut.mat", whole[:-cut]))
refused("names two of its rows 'u'", 2, "--mass", kept("mu.csv", "u,v,u,v\n2,0,0,0\n0,3,0,0\n0,0,4,0\n0,0,0,5\n"), "--stiffness", kept("ku.csv", "u,v,u,v\n2,0,0,0\n0,3,0,0\n0,0,4,0\n0,0,0,5\n"))
check("a heading over a column", len(frequencies("--mass", kept("mh.csv", "mass\n1\n2\n3\n"), "--stiffness", kept("kh.csv", "k\n1\n8\n27\n"))), 3)
XY, YX, PLAIN = kept("xy.csv", "x,y\n2,0\n0,3\n"), kept("yx.csv", "y,x\n300,0\n0,1800\n"), kept("g.csv", "0,1\n-1,0\n")
check("labels in two orders", len(frequencies("--mass", XY, "--stiffness", YX)), 2)
refused("name their rows in different orders, and one has no names", 2, "--mass", XY, "--gyroscopic", PLAIN, "--stiffness", YX)
check("a diagonal as a row of three", len(frequencies("--mass", kept("m1.txt", "1 1 5\n"), "--stiffness", kept("k1.txt", "1 1 9\n"))), 3)
array = (files / "M.npy").read_bytes()
refused("is followed by", 2, "--mass", kept("two.npy", array + array), "--stiffness", "M.npy")
refused("may be sizes or an entry", 2, "--mass", kept("size.txt", "3 3 2\n1 1 4\n2 2 5\n"), "--stiffness", TWO)
check("a size line", frequencies("--mass", kept("sized.txt", "2 2 3\n1 1 2\n2 1 0\n2 2 3\n"), "--stiffness", TWO), frequencies("--mass", TWO, "--stiffness", TWO))
refused("contradict each other", 2, "--mass", TWO, "--stiffness", kept("rsa.hb", "Both triangles                                                          K       \n             3             1             1             1\nRSA                        2             2             4             0\n(8I5)           (8I5)           (4E15.7)            \n    1    3    5\n    1    2    1    2\n  4.0000000E+00  1.0000000E+00  9.9000000E+01  5.0000000E+00\n"))
refused("only one triangle of K is given", 3, "--mass", TWO, "--stiffness", kept("triu.csv", "4 -1\n0 5\n"))
check("pairs once on either side", len(frequencies("--mass", TWO, "--stiffness", kept("mixed.txt", "1 1 4\n1 2 -1\n2 2 5\n"))), 2)
refused("is UTF-16 text", 2, "--mass", kept("excel.csv", "1;2\n".encode("utf-16")), "--stiffness", TWO)
refused("is JSON", 2, "--mass", kept("m.json", '{"M": [1]}'), "--stiffness", TWO)
refused("is a model file, or other TOML", 2, "--mass", source / "models" / "geos.toml", "--stiffness", TWO)
refused("is a table of numbers, no model", 2, TWO)
check("quoted, decimal commas, a mark at the end", frequencies("--mass", kept("mq.csv", '"2,0";0;\n0;"3"\n'), "--stiffness", TWO), frequencies("--mass", TWO, "--stiffness", TWO))
check("as pandas writes it", frequencies("--mass", kept("mp.csv", ",0,1\n0,2,0\n1,0,3\n"), "--stiffness", TWO), frequencies("--mass", TWO, "--stiffness", TWO))
big = kept("long.txt", "".join(f"{i} {i} {i}\n" for i in range(1, 3001)))
check("a long list", len(frequencies("--mass", big, "--stiffness", big, "--lowest", "2")), 3000)
case.cleanup()

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
    for place, more in ((out / "r.toml", []), (out / "r.mat", ["--matrices"])):
        again = run("convert", *more, place, "-o", place)
        check("over its own input", (again.returncode, "would be overwritten" in again.stderr), (1, True))
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
