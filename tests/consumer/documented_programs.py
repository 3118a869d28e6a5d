"""The ```cpp blocks of a page that are programs: written as program_1.cpp … into a folder, or run there, each in the root of the repository and with the output of the ```text block behind it.

    documented_programs.py docs/api.md --write FOLDER
    documented_programs.py docs/api.md --run FOLDER [--update]     the page gets the output that the programs have
"""
import pathlib
import re
import subprocess
import sys

page, what, folder = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
text = page.read_text()
program = re.compile(r"```cpp\n(.*?)```\n(?:\n```text\n(.*?)```\n)?", re.S)
blocks = program.findall(text)

if what == "--write":
    folder.mkdir(parents=True, exist_ok=True)
    for k, (source, _) in enumerate(blocks, 1):
        (folder / f"program_{k}.cpp").write_text(source)
    sys.exit(0)

outputs = []
for k in range(1, len(blocks) + 1):
    run = subprocess.run([folder.resolve() / f"program_{k}"], capture_output=True, text=True, cwd=page.resolve().parent.parent, timeout=120)
    if run.returncode != 0:
        sys.exit(f"program {k} ends with {run.returncode}: {run.stderr}")
    outputs.append(run.stdout)
if "--update" in sys.argv:
    pending = iter(outputs)
    page.write_text(program.sub(lambda m: f"```cpp\n{m.group(1)}```\n\n```text\n{next(pending)}```\n", text))
    sys.exit(0)
wrong = [f"program {k} prints\n{out}where the page has\n{shown}" for k, (out, (_, shown)) in enumerate(zip(outputs, blocks), 1) if out != shown]
sys.exit("\n".join(wrong) if wrong else 0)
