"""Runs every command of the ```sh blocks of README.md, CONTRIBUTING.md and docs/ that starts with the program, and every ```toml block as a model.

A command is expected to exit 0, or N where its line ends with "# exit code N". Blocks whose commands start with ./ or cmake are setup and left out.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
pages = [source / "README.md", source / "CONTRIBUTING.md", *sorted((source / "docs").rglob("*.md"))]
failures = 0
ran = 0


def blocks(text, language):
    return re.findall(r"^```" + language + r"\n(.*?)^```", text, re.M | re.S)


def run(page, line, folder):
    global failures, ran
    expected = re.search(r"#\s*exit code (\d+)", line)
    wanted = int(expected.group(1)) if expected else 0
    command = line.split("#")[0].strip()
    command = re.sub(r"^(build/release/)?gyromode\b", str(program), command)
    result = subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True, timeout=120)
    ran += 1
    if result.returncode != wanted:
        failures += 1
        print(f"{page.name}: {line}\n  exit {result.returncode}, {wanted} was documented\n  {result.stderr.strip()}")


with tempfile.TemporaryDirectory() as folder:
    shutil.copytree(source / "models", pathlib.Path(folder) / "models")
    for page in pages:
        text = page.read_text()
        for block in blocks(text, "sh"):
            for line in block.splitlines():
                if re.match(r"(build/release/)?gyromode\b|cat ", line.strip()):
                    run(page, line.strip(), folder)
        for number, block in enumerate(blocks(text, "toml")):
            if "kind" not in block or ".mtx" in block:
                continue  # a fragment, or one whose files are described elsewhere
            expected = re.search(r"#\s*exit code (\d+)", block)
            model = pathlib.Path(folder) / f"{page.stem}-{number}.toml"
            model.write_text(block)
            run(page, f"gyromode modes {model.name} # exit code {expected.group(1) if expected else 0}", folder)
print(f"{ran} documented commands, {failures} failed")
sys.exit(1 if failures or ran < 20 else 0)
