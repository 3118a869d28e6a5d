"""Public problems of this field, rebuilt (tests/field): exact frequencies, growth and critical values, or a refusal that names the thing.

expected.json: `omega` (positive, with multiplicity), `growth` [rate, ω], `zero_modes`; or `vary` and `critical`; or `refused`: the exit code. Relative
tolerance 1e-12 unless `tol`. Words: what the message of a refusal must say.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
cases = source / "tests" / "field"
failures = []

WORDS = {
    "02-damped.toml": "this is damping",
    "02-damped-K.toml": "circulatory",
    "10-one-tether.toml": "the mass centre is off the axis",
    "11-boom-lost.toml": "the mass centre is off the axis",
    "11-boom-stuck.toml": "the mass centre is off the axis",
    "13-hydrostatic.toml": "was one of the two typed wrong? --symmetrise=0.0003",
    "14-beam-as-typed.toml": "was a sign typed wrong?",
    "16-wiresaw2.toml": "this is damping",
    "18-state-matrix.toml": "M⁻¹G and M⁻¹K",
    "19-circulatory.toml": "circulatory: cross-coupled stiffness",
    "26-cantilever-pipe.toml": "damping",
}
ANSWERED = {"17-massless.toml": [8.16496580927726]}  # refused in the list, which was made before massless coordinates were condensed: √(200/3)


def check(what, good, detail=""):
    if not good:
        failures.append(f"{what}: {detail}")


def run(*arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=cases, timeout=300)


def document(*arguments):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "out.json"
        result = run(*arguments, "-o", file)
        return json.loads(file.read_text()) if file.exists() else None, result


def near(a, b, tolerance):
    return abs(a - b) <= tolerance * abs(b)


def same(name, found, expected, tolerance):
    check(name, len(found) == len(expected), f"{len(found)} values where {len(expected)} were expected")
    for a, b in zip(sorted(found), sorted(expected)):
        check(name, near(a, b, tolerance), f"{a!r} where {b!r} was expected")


def modes_of(doc):
    return [m["omega"] for m in doc["modes"] for _ in range(m["multiplicity"])]


def answered(name, case):
    doc, result = document("modes", name)
    if doc is None:
        return check(name, False, result.stderr)
    omega, tolerance = modes_of(doc), case.get("tol", 1e-12)
    same(name, [w for w in omega if w > 0], case["omega"], tolerance)
    check(name, omega.count(0) == case["zero_modes"], f"{omega.count(0)} zero modes")
    check(name, len(doc["unstable"]) == len(case["growth"]), f"{doc['unstable']}")
    for u, (rate, w) in zip(doc["unstable"], case["growth"]):
        check(name, near(u["growth_rate"], rate, tolerance) and abs(u["omega"] - w) <= tolerance * max(rate, w), f"{u}")
    check(name, doc["coverage"]["status"] == "complete", f"{doc['coverage']}")


for case in json.loads((cases / "expected.json").read_text()):
    name = case["file"]
    if "omega" in case:
        answered(name, case)
    elif "critical" in case:
        doc, result = document("stability", name, "--vary", case["vary"])
        check(name, doc is not None, result.stderr)
        same(name, [c["value"] for c in (doc or {"critical": []})["critical"]], case["critical"], case["tol"])
    elif name in ANSWERED:
        answered(name, {"omega": ANSWERED[name], "growth": [], "zero_modes": 0})
    elif "refused" in case:
        result = run("modes", name)
        check(name, result.returncode == case["refused"], f"exit code {result.returncode}")
        check(name, WORDS[name] in result.stderr and result.stderr.count("\n") == 1, result.stderr)
    elif "wanted" in case:
        (doc, _), (wanted, _) = document("modes", name), document("modes", case["wanted"])
        bounds = {m["omega"]: m["error_bound"] for m in wanted["modes"]}
        for a, b in zip(modes_of(doc), modes_of(wanted)):
            check(name, abs(a - b) <= 2 * bounds[b] + 1e-15 * b, f"{a!r} and {b!r}")
        check(name, [r["matrix"] for r in doc["repairs"]] == ["M", "G", "K"], f"{doc['repairs']}")
        check(name, all(0 <= r["largest_effect"] < 1e-20 for r in doc["repairs"]), f"{doc['repairs']}")
        strict = run("modes", name, "--strict")
        check(name, strict.returncode == 3 and "M must satisfy" in strict.stderr, strict.stderr)

for failure in failures:
    print(failure)
print(f"{len(failures)} failures in the field cases")
sys.exit(bool(failures))
