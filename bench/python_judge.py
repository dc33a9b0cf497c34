#!/usr/bin/python3
"""A verdict on arrays in Python beside the same call in C++, in turns. Started by `./dev bench --python`.

    python_judge.py [SCENE [WIDTH HEIGHT]]

Prints the medians and the ratio of each turn. Status: 0, 1 where Python's median is above 1.2 times C++'s.
"""
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

BUILD = Path(__file__).resolve().parent.parent / "build/release"
TURNS, TIMES = 5, 20
MOST = 1.2

sys.path.insert(0, str(BUILD / "python"))
import numpy  # noqa: E402

import zproof  # noqa: E402


def in_cpp(scene, width, height):
    out = subprocess.run([BUILD / "bench/zproof_api_judge", scene, str(width), str(height), str(TIMES)],
                         check=True, capture_output=True, text=True)
    return [float(line) for line in out.stdout.split()]


def in_python(name, width, height):
    scene = zproof.load(name, size=(width, height))
    view = next(iter(scene.views.values()))
    frame = zproof.render(scene, view)
    ids, depth = numpy.array(frame.id), numpy.array(frame.depth)
    times = []
    for _ in range(TIMES):
        start = time.perf_counter()
        verdict = zproof.judge(scene, view, id=ids, depth=depth, precision="raster,transform=float64")
        assert verdict.proven
        times.append(1e3 * (time.perf_counter() - start))
    return times


def main(scene="closed_surfaces", width="1024", height="1024"):
    cpp, python = [], []
    for _ in range(TURNS):
        cpp += in_cpp(scene, int(width), int(height))
        python += in_python(scene, int(width), int(height))
    medians = statistics.median(cpp), statistics.median(python)
    print(f"{scene}, {width} x {height}: C++ {medians[0]:.2f} ms, Python {medians[1]:.2f} ms, "
          f"ratio {medians[1] / medians[0]:.3f} (at most {MOST})")
    return 0 if medians[1] <= MOST * medians[0] else 1


if __name__ == "__main__":
    os.environ.pop("ZPROOF_ISA", None)
    sys.exit(main(*sys.argv[1:]))
