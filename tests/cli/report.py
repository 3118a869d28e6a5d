"""Pages of results: every verb makes one, it holds the document and fetches nothing, and what is no result is refused by name."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
failures = []
folder = tempfile.TemporaryDirectory()
place = pathlib.Path(folder.name)


def run(*arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=source, timeout=120)


def check(what, found, expected):
    if found != expected:
        failures.append(f"{what}: {found!r} where {expected!r} was expected")


def documents_of(page):
    return json.loads(re.search(r'<script type="application/json" id="documents">(.*?)</script>', page, re.S).group(1))


def without_times(document):
    return {key: value for key, value in document.items() if key != "timings"}


verbs = {
    "modes": ["modes", "models/geos.toml", "--lowest", "5"],
    "count": ["count", "models/geos.toml", "--below", "40rpm"],
    "structure": ["structure", "models/geos_rotated.toml"],
    "stability": ["stability", "models/rotating_frame.toml", "--vary", "spin=0:3:7"],
    "critical": ["critical", "models/rotors/jeffcott.toml"],
    "campbell": ["campbell", "models/rotors/jeffcott.toml", "--spin", "0:3000rpm:5", "--lowest", "2"],
    "response": ["response", "models/three_springs.toml", "--force", "impulse:x=1", "--until", "0.05", "--step", "0.01"],
    "frequency_response": ["response", "models/three_springs.toml", "--force", "x=1", "--frequencies", "10Hz:200Hz:5"],
    "unbalance_response": ["response", "models/rotors/two_discs.toml", "--unbalance", "disk1=1e-4", "--spin", "0:6000rpm:5"],
}
for kind, words in verbs.items():
    page = place / f"{kind}.html"
    result = run(*words, "-o", page)
    check(kind, (result.returncode, result.stdout), (0, ""))
    text = page.read_text()
    [entry] = documents_of(text)
    check(f"schema of {kind}", entry["document"]["schema"], f"gyromode/{kind}/1")
    check(f"{kind} says when", bool(re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", entry["document"]["timings"]["at"])), True)
    for word in ("http-equiv=\"Content-Security-Policy\"", "default-src 'none'"):
        check(f"{kind} has {word}", word in text, True)
    check(f"nothing of {kind} is fetched", re.findall(r"<(?:link|img|iframe|script src)[^>]*", text), [])
check("modes have their shapes", "shape" in documents_of((place / "modes.html").read_text())[0]["document"]["modes"][2], True)

# The same documents by report, several at a time, and to stdout.
files = []
for kind in ("count", "structure"):
    files.append(place / f"{kind}.json")
    run(*verbs[kind], "-o", files[-1])
result = run("report", *files, "-o", place / "both.html")
check("report", (result.returncode, result.stdout, result.stderr), (0, "", ""))
both = documents_of((place / "both.html").read_text())
for entry, file in zip(both, files):
    check(f"{file.name} in the page", without_times(entry["document"]), without_times(json.loads(file.read_text())))
check("to stdout", run("report", files[0]).stdout.startswith("<!doctype html>"), True)

good = json.loads(files[0].read_text())


def refused(words, content, code=2, *arguments):
    file = place / "refused.json"
    file.write_text(content if isinstance(content, str) else json.dumps(content))
    result = run("report", file, *(arguments or ("-o", place / "refused.html")))
    check(words, (result.returncode, words in result.stderr, result.stderr.count("\n"), result.stdout), (code, True, 1, ""))
    if words not in result.stderr:
        failures.append(result.stderr)


refused("refused.json:3: not JSON, or cut off", files[0].read_text()[:40])
refused("not JSON", "")
refused("it has no \"schema\"", {"results": []})
refused("no result of gyromode", [1, 2])
refused("schema 'vega/lite/5' is not one of gyromode", {"schema": "vega/lite/5"})
refused("kind 'mode' is not known: did you mean 'modes'", {**good, "schema": "gyromode/mode/1"})
refused("version '7' of count is not known to this program", {**good, "schema": "gyromode/count/7"})
refused("damaged: a document of kind 'count' has \"negative\", a list", {key: value for key, value in good.items() if key != "negative"})
refused("\"model\", an object with a title", {**good, "model": {"title": 3}})
refused("that ends in .html was expected", good, 1, "-o", place / "x.pdf")
for words, code, arguments in (
    ("no such file", 2, ["report", place / "none.json"]),
    ("a folder", 2, ["report", place]),
    ("results is required", 1, ["report"]),
):
    result = run(*arguments)
    check(words, (result.returncode, words in result.stderr, result.stderr.count("\n")), (code, True, 1))
page = place / "own.html"
page.write_text(files[0].read_text())
result = run("report", page, "-o", page)
check("the input stays", (result.returncode, "would overwrite the input" in result.stderr, page.read_text()), (1, True, files[0].read_text()))

# What a title says cannot end the element that it stands in.
evil = {**good, "model": {**good["model"], "title": "</script><script>alert(1)</script><!--"}}
(place / "evil.json").write_text(json.dumps(evil))
text = run("report", place / "evil.json").stdout
check("the title is escaped", "<script>alert" in text, False)
check("and is whole", documents_of(text)[0]["document"]["model"]["title"], evil["model"]["title"])

for failure in failures:
    print(failure)
sys.exit(1 if failures else 0)
