"""Documents of every verb on every shipped model against those on record (recorded.jsonl beside this file): every field on record must be there, with the same words, counts and numbers. Fields may be added.

    python3 tests/cli/recorded.py build/release/gyromode .             compares
    python3 tests/cli/recorded.py build/release/gyromode . --record    records anew: for a field whose meaning was changed on purpose, with the reason in CHANGELOG.md
"""
import json
import math
import pathlib
import subprocess
import sys

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
RECORD = pathlib.Path(__file__).resolve().parent / "recorded.jsonl"

SPACECRAFT = ["cluster", "geos", "geos_rotated", "ispm", "mms", "themis", "ulysses", "meirovitch_body"]
MATRICES = ["rigid_body", "rigid_body_intermediate", "rigid_body_minor", "rotating_frame", "three_springs", "turned_rotor", "wiresaw"]
ROTORS = ["free_shaft", "jeffcott", "momentum_wheel", "overhung_disc", "simply_supported", "simply_supported_rayleigh", "twin_spool", "two_discs", "two_discs_orthotropic"]
VOLATILE = {"timings", "versions"}
# What is measured of rounding: the order of magnitude is the machine's, not the program's.
MEASURED = {"residual", "error_bound", "bracket", "departure", "breach", "threshold", "symmetry_error", "skew_error", "phase_error", "zero_energy", "remainder_energy", "amplification", "evaluations"}
ROUNDING = 1e-9
SHARED = {"amplitude", "phase", "energy"}  # of two modes at nearly one frequency, and between them known less well


def commands():
    for name in MATRICES + SPACECRAFT:
        model = f"models/{name}.toml"
        yield f"modes {model}"
        yield f"structure {model} --at 0.8"
        yield f"count {model} --below 2"
        yield f"count {model} --window 0.5:40"
        yield f"stability {model}"
    for name in MATRICES:
        yield f"modes models/{name}.toml --shapes"
        yield f"modes models/{name}.toml --lowest 1"
    yield "modes models/geos.toml --shapes --lowest 3"
    yield "modes models/mms.toml --shapes --lowest 1"
    yield "modes models/geos.toml --window 1rpm:60rpm"
    yield "modes models/ispm.toml --method discrete --elements 8 --lowest 5"
    yield "modes models/wiresaw.toml --window 5:60"
    for method in ["quadrature", "general", "first-order", "symmetric-2n"]:
        yield f"modes models/wiresaw.toml --method {method}"
    yield "modes models/turned_rotor.toml --method hidden"
    yield "modes models/rotating_frame.toml --keep x1"
    yield "stability models/three_springs.toml --vary spin=0:12000rpm:7"
    yield "stability models/geos.toml --vary cable[*].length=5:40:4"
    yield "stability models/mms.toml --vary body.inertia[2]=500:3000:3 --vary spin=1rpm:4rpm:2"
    yield "response models/three_springs.toml --force impulse:y=1 --until 0.02 --step 0.004"
    yield "response models/three_springs.toml --force x=1 --frequencies 10Hz:200Hz:6"
    yield "response models/geos.toml --force impulse:theta1=10 --points cable1@1 --until 8 --step 2 --rates"
    for name in ROTORS:
        yield f"modes models/rotors/{name}.toml --lowest 6"
        yield f"critical models/rotors/{name}.toml --lowest 4"
    yield "critical models/rotating_frame.toml --order 2"
    yield "critical models/rotors/two_discs.toml --over bearing[*].kxx,bearing[*].kyy=1e5:1e9:3 --lowest 3"
    yield "campbell models/rotors/two_discs.toml --spin 0:12000rpm:5 --order 0.5,1 --lowest 6"
    yield "campbell models/geos.toml --spin 5rpm:15rpm:3 --below 4"
    yield "response models/rotors/two_discs.toml --unbalance disk2=1e-4@30deg --spin 0:3000rpm:4"


def answer(command):
    result = subprocess.run([str(PROGRAM), *command.split(), "--format", "json"], capture_output=True, text=True, cwd=SOURCE, timeout=300)
    document = json.loads(result.stdout) if result.stdout else None
    if document:
        document = {key: value for key, value in document.items() if key not in VOLATILE}
    return {"command": command, "exit": result.returncode, "document": document}


def is_number(x):
    return isinstance(x, (int, float)) and not isinstance(x, bool)


def sizes(x):
    """The moduli of all numbers in nested lists."""
    if is_number(x):
        return [abs(x)]
    return [s for item in x for s in sizes(item)] if isinstance(x, list) else []


def differences(old, new, path="", key="", scale=0.0):
    if isinstance(old, dict):
        if not isinstance(new, dict):
            return [f"{path}: no object any more"]
        if abs(old.get("amplitude", 1)) < ROUNDING:  # a mode that takes no part has no phase
            old = {"omega": old["omega"]}
        scale = max([0.0, *sizes(old.get("re")), *sizes(old.get("im"))])
        return [d for k, v in old.items() for d in (differences(v, new[k], f"{path}.{k}", key if key in MEASURED else k, scale) if k in new else [f"{path}.{k}: missing"])]
    if isinstance(old, list):
        if not isinstance(new, list) or len(old) != len(new):
            return [f"{path}: {len(old)} entries on record, now {len(new) if isinstance(new, list) else 'none'}"]
        scale = max([scale, *sizes(old)]) if all(is_number(x) or isinstance(x, list) for x in old) else 0.0
        return [d for i, (a, b) in enumerate(zip(old, new)) for d in differences(a, b, f"{path}[{i}]", key, scale)]
    if is_number(old) and is_number(new) and (isinstance(old, float) or key in MEASURED):
        allowed = 100 * ROUNDING if key in SHARED else ROUNDING
        if key in MEASURED:
            same = max(abs(old), abs(new)) <= ROUNDING or (min(old, new) > 0 and abs(math.log10(old / new)) <= 3)
        elif key == "phase":
            same = abs(math.remainder(old - new, 2 * math.pi)) <= allowed
        else:
            same = abs(old - new) <= allowed * max(abs(old), abs(new), scale)
        return [] if same else [f"{path}: {old!r} on record, now {new!r}"]
    return [] if old == new else [f"{path}: {old!r} on record, now {new!r}"]


def main():
    if "--record" in sys.argv:
        RECORD.write_text("".join(json.dumps(answer(c), ensure_ascii=False) + "\n" for c in commands()))
        return 0
    failures = 0
    recorded = [json.loads(line) for line in RECORD.read_text().splitlines()]
    for old in recorded:
        found = differences(old, answer(old["command"]))
        for line in found[:5]:
            print(f"{old['command']}: {line}")
        failures += 1 if found else 0
    print(f"{len(recorded)} documents compared, {failures} differ")
    return 1 if failures or not recorded else 0


if __name__ == "__main__":
    sys.exit(main())
