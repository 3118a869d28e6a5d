"""Pictures: those of the documentation are what the program makes (docs/images); and every kind of picture is a well-formed drawing, of which nothing leaves the sheet and no two texts cover each other."""
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
MADE = {
    "two_discs.svg": "campbell models/rotors/two_discs.toml --spin 0:12000rpm:61 --below 12000rpm --order 1,2",
    "two_discs_shapes.svg": "modes models/rotors/two_discs.toml --lowest 4 --units Hz",
    "two_discs_unbalance.svg": "response models/rotors/two_discs.toml --unbalance disk2=72g·mm --spin 0:6000rpm:400",
}
KINDS = [
    *MADE.values(),
    "modes models/ulysses.toml --lowest 4",
    "modes models/rotors/twin_spool.toml --lowest 5",
    "modes models/rotors/simply_supported.toml --lowest 3",
    "modes models/rotors/free_shaft.toml --lowest 3",
    "campbell models/geos.toml --spin 5rpm:15rpm:5 --below 4",
    "campbell models/turned_rotor.toml --spin 0:8000rpm:41",
    "critical models/rotors/two_discs.toml --over bearing[*].kxx,bearing[*].kyy=1e5:1e9:9 --below 20000rpm",
    "critical models/rotors/two_discs.toml --over bearing[*].kxx=1e6:2e6:3 --lowest 2",
    "stability models/three_springs.toml --vary spin=0:12000rpm:25",
    "stability models/three_springs.toml --vary spin=0:100rpm:2",
    "stability models/three_springs.toml --vary spin=0:12000rpm:12 --vary stiffness[0][0]=1e4:9e4:7",
    "response models/three_springs.toml --force x=1 --frequencies 10Hz:200Hz:50",
    "response models/three_springs.toml --force impulse:y=1 --until 0.1 --step 0.001",
    "response models/turned_rotor.toml --unbalance x1=1e-4 --spin 0:6000rpm:50",
    "response models/rotors/jeffcott.toml --unbalance disk1=1e-5",
]
failures = 0


def complain(what, arguments):
    global failures
    failures += 1
    print(f"gyromode {arguments}: {what}")


def drawn(arguments, folder):
    target = pathlib.Path(folder) / "picture.svg"
    result = subprocess.run([program, *arguments.split(), "--quiet", "-o", target], cwd=source, timeout=120, capture_output=True, text=True)
    if result.returncode != 0:
        complain(f"exit {result.returncode}: {result.stderr}", arguments)
        return None
    return target.read_text()


def in_frame(element, clipped, width, height, arguments):
    """Everything that no frame clips is on the sheet."""
    tag = element.tag.split("}")[1]
    if tag in ("style", "clipPath"):
        return
    clipped = clipped or "clip-path" in element.attrib
    places = []
    if tag == "polyline":
        places = [tuple(map(float, p.split(","))) for p in element.attrib["points"].split()]
    elif tag == "rect":
        x, y = float(element.get("x", 0)), float(element.get("y", 0))
        places = [(x, y), (x + float(element.attrib["width"]), y + float(element.attrib["height"]))]
    elif tag == "circle":
        places = [(float(element.attrib["cx"]), float(element.attrib["cy"]))]
    elif tag == "text" and "x" in element.attrib:
        places = [(float(element.attrib["x"]), float(element.attrib["y"]))]
    if not clipped and any(not (-0.5 <= x <= width + 0.5 and -0.5 <= y <= height + 0.5) for x, y in places):
        complain(f"a {tag} leaves the sheet: {places[:3]}", arguments)
    for child in element:
        in_frame(child, clipped, width, height, arguments)


def texts_apart(root, arguments):
    boxes = []
    for t in root.iter("{http://www.w3.org/2000/svg}text"):
        if "x" not in t.attrib:
            continue
        text = "".join(t.itertext())
        size = {"title": 15, "caption": 14}.get(t.get("class"), 12)
        wide, x, y = 0.5 * size * len(text), float(t.attrib["x"]), float(t.attrib["y"])
        left = x - (wide if t.get("text-anchor") == "end" else 0.5 * wide if t.get("text-anchor") == "middle" else 0)
        boxes.append((left, y - 0.8 * size, left + wide, y, text))
        if left + wide > float(root.attrib["width"]) + 1:
            complain(f"'{text}' leaves the sheet", arguments)
    for i, a in enumerate(boxes):
        for b in boxes[:i]:
            if a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]:
                complain(f"'{a[4]}' covers '{b[4]}'", arguments)


with tempfile.TemporaryDirectory() as folder:
    for name, arguments in MADE.items():
        kept = source / "docs" / "images" / name
        text = drawn(arguments, folder)
        if "--record" in sys.argv:
            kept.write_text(text)
        if text != kept.read_text():
            complain(f"docs/images/{name} is another picture", arguments)
    for arguments in KINDS:
        text = drawn(arguments, folder)
        if text is None:
            continue
        root = xml.fromstring(text)
        if re.search(r"\b(nan|inf)\b", re.sub(r"<text.*?</text>", "", text)):
            complain("a number that is none", arguments)
        in_frame(root, False, float(root.attrib["width"]), float(root.attrib["height"]), arguments)
        texts_apart(root, arguments)
print(f"{len(KINDS)} pictures, {failures} failures")
sys.exit(failures != 0)
