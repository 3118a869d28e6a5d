#!/usr/bin/env python3
"""Time and memory of `gyromode modes --lowest N` over the size of a model: cantilevers of bricks, class by a mirror plane.

    bench/large.py --generator BUILD/gyromode_generate --program BUILD/gyromode --folder /tmp/cantilevers --picture large.svg

Generates what is not in the folder, runs each size once, prints a table in Markdown with exponents by least squares, and has gnuplot draw it.
"""
import argparse
import math
import os
import pathlib
import re
import subprocess

# Bricks along x, y, z of 0.1 × 0.104 × 1: three coordinates a node, less the clamped end.
BRICKS = [(11, 12, 24), (18, 18, 36), (24, 25, 50), (36, 37, 75), (48, 50, 136)]
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#777777"]  # told apart by the colour-blind, too
STAGES = {"reading": "read, order, M > 0", "factorisation of K": "factors", "modes": "modes", "counts of the modes at rest": "at rest"}


def generated(generator, folder, bricks):
    place = folder / "x".join(map(str, bricks))
    if not (place / "model.toml").exists():
        subprocess.run([generator, "cantilever", "-o", place, "--bricks", *map(str, bricks), "--size", "0.1", "0.104", "1", "--spin", "150"],
                       check=True, stdout=subprocess.DEVNULL)
    return place / "model.toml"


def measured(program, model, lowest, options):
    run = subprocess.Popen([program, "modes", model, "--lowest", str(lowest), "--verbose", *options], stdout=subprocess.DEVNULL,
                           stderr=subprocess.PIPE, text=True)
    said = run.stderr.read()
    _, status, usage = os.wait4(run.pid, 0)
    if status:
        raise SystemExit(said)
    row = {"n": int(re.search(r"(\d+) coordinates read", said)[1]), "peak": usage.ru_maxrss * 1024 / 1e9}
    for stage in STAGES:
        time = re.search(rf"^gyromode: {stage}(?: \(\d+\))?: ([\d.e+-]+) s$", said, re.M)
        row[stage] = float(time[1]) if time else 0
    row["all"] = sum(row[stage] for stage in STAGES)
    return row


def exponent(rows, key):
    """The slope of log(key) over log(n)."""
    x, y = [math.log(r["n"]) for r in rows], [math.log(r[key]) for r in rows]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def drawn(rows, picture):
    data = "\n".join(" ".join(str(r[k]) for k in ("n", *STAGES, "all", "peak")) for r in rows)
    titles = [*STAGES.values(), "all"]
    curves = ", ".join(f"$d using 1:{k + 2} with linespoints lw 2 lc rgb '{c}' title '{t}, s'" for k, (t, c) in enumerate(zip(titles, COLOURS)))
    script = f"""set terminal svg size 760,480 font 'sans,13' background rgb 'white'
set output '{picture}'
set logscale xy
set xrange [8e3:1.5e6]
set yrange [0.05:1000]
set y2range [0.05:1000]
set format x '10^{{%L}}'
set logscale y2
set key left top
set xlabel 'coordinates'
set ylabel 'seconds'
set y2label 'GB'
set ytics nomirror
set y2tics
set grid
$d << END
{data}
END
plot {curves}, $d using 1:7 axes x1y2 with linespoints lw 2 dt 2 lc rgb '{COLOURS[-1]}' title 'peak memory, GB (right)'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--generator", required=True, type=pathlib.Path)
    options.add_argument("--program", required=True, type=pathlib.Path)
    options.add_argument("--folder", required=True, type=pathlib.Path, help="for the models, some 3 GB")
    options.add_argument("--lowest", type=int, default=20)
    options.add_argument("--sizes", type=int, default=len(BRICKS), help="how many of the sizes, from the smallest")
    options.add_argument("--memory", help="as gyromode --memory")
    options.add_argument("--picture", type=pathlib.Path)
    o = options.parse_args()
    extra = ["--memory", o.memory] if o.memory else []
    rows = [measured(o.program, generated(o.generator, o.folder, b), o.lowest, extra) for b in BRICKS[: o.sizes]]
    keys = [*STAGES, "all", "peak"]
    print("| coordinates | " + " | ".join([*STAGES.values(), "all", "peak, GB"]) + " |")
    print("|---|" + "---|" * len(keys))
    for r in rows:
        print(f"| {r['n']} | " + " | ".join(f"{r[k]:.3g}" for k in keys) + " |")
    if len(rows) > 1:
        print("| exponent | " + " | ".join(f"{exponent(rows, k):.2f}" for k in keys) + " |")
    if o.picture:
        drawn(rows, o.picture)


if __name__ == "__main__":
    main()
