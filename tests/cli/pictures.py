"""Pictures of the documentation that the program makes are what it makes: docs/images against the commands of the pages."""
import pathlib
import subprocess
import sys
import tempfile

program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
MADE = {"two_discs.svg": ["campbell", "models/rotors/two_discs.toml", "--spin", "0:12000rpm:61", "--below", "12000rpm", "--order", "1,2"]}
failures = 0
for name, arguments in MADE.items():
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / name
        subprocess.run([program, *arguments, "--quiet", "-o", made], cwd=source, check=True, timeout=120)
        if made.read_text() != (source / "docs" / "images" / name).read_text():
            print(f"docs/images/{name} is not what gyromode {' '.join(arguments)} makes")
            failures += 1
print(f"{len(MADE)} pictures, {failures} differ")
sys.exit(failures != 0)
