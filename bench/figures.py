#!/usr/bin/env python3
"""Runs the benchmarks and makes figures of them. Started by `./dev bench`.

    figures.py ratios [FILTER]     a line per case: zproof's time and each peer's, as multiples of zproof's
    figures.py compare OLD.json    what became slower since OLD.json, beyond the noise of both
    figures.py check [--renew]     instruction counts by callgrind beside bench/instructions.json; 1 where one grew
    figures.py judge-table MACHINE verdicts of the suite beside Embree's rays, into docs/performance-judge.*
    figures.py plot                time and memory over triangles and pixels, as SVG

Every run also writes its JSON into build/bench/. Status: 0, 1 where something is slower, 2 for a wrong word.
"""
import csv
import json
import math
import re
import statistics
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = ROOT / "build/release/bench"
OUT = ROOT / "build/bench"
BASELINE = ROOT / "bench/instructions.json"
JUDGE_PAGE = ROOT / "docs/performance-judge.md"
REPETITIONS = 9
MOST_GROWTH = 1.10  # of instructions


def run_benchmarks(filter_, out):
    """Repetitions of all cases in random order, so that peers meet the same weather."""
    subprocess.run(
        [PROGRAMS / "zproof_bench", f"--benchmark_filter={filter_}", f"--benchmark_repetitions={REPETITIONS}",
         "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.05",
         f"--benchmark_out={out}", "--benchmark_out_format=json"],
        check=True, stdout=subprocess.DEVNULL)
    return samples_of(out)


def samples_of(file):
    """{(topic, case): {who: [milliseconds]}}"""
    samples = {}
    for run in json.loads(Path(file).read_text())["benchmarks"]:
        if run["run_type"] != "iteration":
            continue
        topic, case, who = run["name"].split("/")[:3]
        samples.setdefault((topic, case), {}).setdefault(who, []).append(run["real_time"])
    return samples


def quartiles(values):
    if len(values) < 2:
        return values[0], values[0], values[0]
    low, middle, high = statistics.quantiles(values, n=4)
    return low, middle, high


def ratios(filter_="."):
    OUT.mkdir(parents=True, exist_ok=True)
    for (topic, case), times in run_benchmarks(filter_, OUT / "ratios.json").items():
        low, median, high = quartiles(times["zproof"])
        line = f"{topic + ' ' + case:44} {median:9.2f} ms (middle half {low:.2f} to {high:.2f})"
        for who, theirs in times.items():
            if who != "zproof":
                line += f"   {who} {statistics.median(theirs) / median:.2f} x"
        print(line)
    return 0


def judge_page(rows, machine, times):
    """What the rows of docs/performance-judge.csv come to, as the page beside them."""
    ratios = sorted((verdict / rays, f"`{scene}` / {name}") for scene, name, verdict, rays in rows)
    return f"""# The judge, view by view

What a verdict on each view of the suite costs beside Embree's rays for it, at 1920 x 1080.
[performance.md](performance.md) has the goals. `./dev bench --judge-table MACHINE` writes this page and
[performance-judge.csv](performance-judge.csv), a row per view.

{machine}.
Least times of {times}.

The verdicts on {len(rows)} views take {sum(row[2] for row in rows) / 1000:.1f} s, Embree's rays \
{sum(row[3] for row in rows) / 1000:.1f} s.
The median of verdict / rays is {statistics.median(ratio for ratio, _ in ratios):.2f}. \
It is above 1 on {sum(ratio > 1 for ratio, _ in ratios)} views, at most \
{ratios[-1][0]:.2f}: {ratios[-1][1]}.
"""


def judge_rows(samples):
    """(scene, view, the verdict's least ms, the rays' least ms)"""
    rows = []
    for (_, view), by_who in samples.items():
        scene, _, name = view.partition("-")
        rows.append((scene, name, round(min(by_who["zproof"]), 4), round(min(by_who["Embree's rays"]), 4)))
    return rows


def judge_table(machine):
    OUT.mkdir(parents=True, exist_ok=True)
    samples = run_benchmarks("^judge/", OUT / "judge.json")
    rows = judge_rows(samples)
    with JUDGE_PAGE.with_suffix(".csv").open("w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([("scene", "view", "verdict ms", "rays ms"), *rows])
    JUDGE_PAGE.write_text(judge_page(rows, machine, f"{REPETITIONS} verdicts and frames of rays"))
    return 0


def compare(old):
    """Slower beyond the noise: the middle halves do not meet."""
    before = samples_of(old)
    OUT.mkdir(parents=True, exist_ok=True)
    topics = "|".join(sorted({topic for topic, _ in before}))
    slower = 0
    for key, times in run_benchmarks(f"^({topics})/", OUT / "compare.json").items():
        if "zproof" not in before.get(key, {}):
            continue
        then, now = quartiles(before[key]["zproof"]), quartiles(times["zproof"])
        word = "slower" if now[0] > then[2] else "faster" if now[2] < then[0] else "the same"
        slower += word == "slower"
        print(f"{' '.join(key):44} {then[1]:9.2f} -> {now[1]:9.2f} ms, {now[1] / then[1]:.2f} x: {word}")
    return 1 if slower else 0


def instructions_of(piece):
    out = OUT / "callgrind.out"
    subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}",
                    "--toggle-collect=zproof::bench::counted*", PROGRAMS / "zproof_work", piece],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return int(re.search(r"^(?:summary|totals): (\d+)", out.read_text(), re.M).group(1))


def check(renew=""):
    """Callgrind knows no AVX-512: the processor that it plays has AVX2 at most."""
    OUT.mkdir(parents=True, exist_ok=True)
    pieces = subprocess.run([PROGRAMS / "zproof_work"], check=True, capture_output=True, text=True).stdout.splitlines()
    known = json.loads(BASELINE.read_text()) if BASELINE.exists() else {}
    counts, grown = {}, 0
    for piece in pieces:
        if "AVX-512" in piece:
            continue
        counts[piece] = instructions_of(piece)
        growth = counts[piece] / known.get(piece, counts[piece])
        grown += growth > MOST_GROWTH
        word = "GREW" if growth > MOST_GROWTH else "" if piece in known else "new"
        print(f"{piece:36} {counts[piece] / 1e6:10.2f} M instructions  {growth:6.3f} x  {word}", flush=True)
    if renew == "--renew":
        BASELINE.write_text(json.dumps(counts, indent=2) + "\n")
        return 0
    for gone in sorted(set(known) - set(counts)):
        print(f"{gone:36} is no longer there: figures.py check --renew")
    return 1 if grown or set(known) - set(counts) else 0


TRIANGLES = [(72, 70), (224, 224), (708, 707), (2237, 2236)]  # 10 thousand to 10 million
PIXELS = [(1280, 720), (1920, 1080), (3840, 2160), (7680, 4320)]


def growth(columns, rows, width, height):
    out = subprocess.run([PROGRAMS / "zproof_growth", *map(str, (columns, rows, width, height))],
                         check=True, capture_output=True, text=True).stdout
    return json.loads(out)


def plot():
    OUT.mkdir(parents=True, exist_ok=True)
    stages = ["render_cpu_s", "build_cpu_s", "trace_cpu_s", "judge_cpu_s"]
    by_triangles = [growth(*t, 1920, 1080) for t in TRIANGLES]
    by_pixels = [growth(708, 707, *p) for p in PIXELS]
    both = [growth(*TRIANGLES[-1], *p) for p in PIXELS[2:]]  # most triangles, most pixels
    for row in by_triangles + by_pixels + both:
        row["allowed_mib"] = 3 * row["scene_mib"] + 2 * row["frame_mib"]
        print(f"{row['triangles']:9} triangles {row['width']:5} x {row['height']:4}  "
              + "  ".join(f"{s[:-6]} {row[s]:7.3f} s" for s in stages)
              + f"  {row['mib']:7.0f} MiB (three times the scene, and frames: {row['allowed_mib']:.0f})")
    for row in by_pixels:
        row["megapixels"] = row["width"] * row["height"] / 1e6
    write_chart(OUT / "time-over-triangles.svg", by_triangles, "triangles", stages, "processor seconds, all threads")
    write_chart(OUT / "time-over-pixels.svg", by_pixels, "megapixels", stages, "processor seconds, all threads")
    write_chart(OUT / "memory-over-triangles.svg", by_triangles, "triangles", ["mib", "allowed_mib", "scene_mib"], "MiB")
    (OUT / "growth.json").write_text(json.dumps({"triangles": by_triangles, "pixels": by_pixels, "both": both}, indent=2))
    return 0


LABELS = {"mib": "peak", "allowed_mib": "3 scenes, frames", "scene_mib": "scene"}


def grouped(number):
    """12345678 as 12 345 678; what is not whole with a digit behind the point."""
    return f"{number:,.0f}".replace(",", " ") if number == int(number) else f"{number:.1f}"


def label_places(ends):
    """Heights for labels at the lines' ends: where lines end close together, labels stand below one another."""
    places, last = {}, -math.inf
    for name, y in sorted(ends.items(), key=lambda end: end[1]):
        places[name] = last = max(y, last + 13)
    return places


def write_chart(file, rows, x, series, unit):
    """Both axes logarithmic: what grows linearly is a line of slope 1, drawn in grey beside."""
    width, height, margin = 640, 420, 60
    xs = [math.log10(r[x]) for r in rows]
    ys = [math.log10(max(r[s], 1e-6)) for r in rows for s in series]
    left, right, low, high = min(xs), max(xs), math.floor(min(ys)), math.ceil(max(ys))

    def place(px, py):
        return (margin + (px - left) / (right - left) * (width - 2 * margin - 60),
                height - margin - (py - low) / (high - low) * (height - 2 * margin))

    colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7"]
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
             f'<rect width="{width}" height="{height}" fill="white"/>']
    for decade in range(low, high + 1):
        y = place(left, decade)[1]
        parts.append(f'<path d="M{margin} {y:.1f}H{width - margin - 60}" stroke="#ddd"/>'
                     f'<text x="{margin - 6}" y="{y + 4:.1f}" text-anchor="end">{10.0 ** decade:g}</text>')
    for row, px in zip(rows, xs):
        parts.append(f'<text x="{place(px, low)[0]:.1f}" y="{height - margin + 18}" text-anchor="middle">{grouped(row[x])}</text>')
    parts.append(f'<text x="{width / 2}" y="{height - 12}" text-anchor="middle">{x}</text>'
                 f'<text x="14" y="{margin - 20}">{unit}</text>')
    start = place(left, low)
    end = place(min(right, left + high - low), low + min(right - left, high - low))
    parts.append(f'<path d="M{start[0]:.1f} {start[1]:.1f}L{end[0]:.1f} {end[1]:.1f}" stroke="#999" stroke-dasharray="4"/>')
    lines = {name: [place(px, math.log10(max(r[name], 1e-6))) for r, px in zip(rows, xs)] for name in series}
    heights = label_places({name: points[-1][1] for name, points in lines.items()})
    for colour, (name, points) in zip(colours, lines.items()):
        path = "L".join(f"{a:.1f} {b:.1f}" for a, b in points)
        parts.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2"/>'
                     f'<text x="{points[-1][0] + 6:.1f}" y="{heights[name] + 4:.1f}" fill="{colour}">'
                     f'{LABELS.get(name, name.split("_")[0])}</text>')
    Path(file).write_text("\n".join(parts) + "\n</svg>\n")
    print(file)


if __name__ == "__main__":
    commands = {"ratios": ratios, "compare": compare, "check": check, "plot": plot,
                "judge-table": judge_table}
    if len(sys.argv) < 2 or sys.argv[1] not in commands:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    sys.exit(commands[sys.argv[1]](*sys.argv[2:]))
