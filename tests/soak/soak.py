#!/usr/bin/env python3
"""Judges many scenes in one run, with a renderer that misbehaves at every tenth picture, and watches the memory.

    tests/soak/soak.py PROGRAM CASTER MODELS [--scenes 1000]

A hundred scenes, the models in the folder MODELS and scenes drawn at random, are judged again and again. Exit status: 1
where the run does not end with its report, an honest picture is not proven, a faulty one is, a process is left behind,
or the last hundred scenes need over 5 % more memory than the first.
"""
import argparse
import base64
import collections
import json
import pathlib
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "cli"))
import faulty_renderer  # noqa: E402 (its folder is named above)

DISTINCT = 100
ALLOWED_GROWTH = 1.05
LARGEST_MODEL = 500_000  # bytes: the examples look at every triangle at every pixel
# By what the renderer did; a wrong frame that shows nothing may be right. Anything else is no frame.
OUTCOMES = {"honest": ["proven"], "leaves_a_daemon": ["unreadable"],
            **{fault: ["defective", "proven"] for fault in faulty_renderer.WRONG_FRAMES}}


def random_gltf(seed):
    """Triangles at random in one glTF file; 1, 10, 100 or 1000 of them."""
    draw = random.Random(seed)
    count = 3 * draw.choice([1, 10, 100, 1000])
    numbers = [draw.uniform(-1, 1) for _ in range(3 * count)]
    floats = struct.pack(f"<{len(numbers)}f", *numbers)
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": len(floats),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(floats).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": len(floats)}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3",
                       "min": [-1, -1, -1], "max": [1, 1, 1]}]})


def bytes_beside(file):
    return sum(other.stat().st_size for other in file.parent.glob("*.bin"))


def make_scenes(folder, models, count):
    """SCENE-0000 ...: those of place i and i + 100 are the same."""
    real = [file for file in sorted(models.rglob("*.gltf")) if bytes_beside(file) < LARGEST_MODEL][: DISTINCT // 2]
    for i in range(count):
        kind = i % DISTINCT
        if kind < len(real):
            (folder / f"scene-{i:04}").mkdir()
            copy = folder / f"scene-{i:04}" / real[kind].parent.name
            copy.symlink_to(real[kind].parent)
            yield copy / real[kind].name
        else:
            file = folder / f"scene-{i:04}.gltf"
            file.write_text(random_gltf(kind))
            yield file


def workers(pid):
    children = pathlib.Path(f"/proc/{pid}/task/{pid}/children")
    return children.read_text().split() if children.exists() else []


def peak_kib(pid):
    """The largest resident size since forget_peak(); 0 where the process has ended."""
    try:
        found = re.search(r"VmHWM:\s+(\d+)", pathlib.Path(f"/proc/{pid}/status").read_text())
    except (FileNotFoundError, ProcessLookupError):
        return 0
    return int(found[1]) if found else 0


def forget_peak(pid):
    pathlib.Path(f"/proc/{pid}/clear_refs").write_text("5")


def judge(options, folder, scenes):
    """Runs it; returns the exit status and the peak of each hundred scenes."""
    renderer = f"python3 '{HERE / 'renderer.py'}' '{options.caster}' '{folder}' {{scene}} {{camera}} {{out}}"
    command = [options.program, "run", *scenes, "-o", folder / "out", "--oracle", "none", "--width", "48", "--height", "27",
               "--precision", "ray,arithmetic=float64", "--renderer", renderer, "--time-limit", "3", "--progress", "lines"]
    peaks = collections.Counter()
    with subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True) as process:
        begun = 0
        for line in process.stderr:
            place = re.match(r"\[(\d+)/", line)
            if place and int(place[1]) > begun:
                hundred, begun = begun // DISTINCT, int(place[1])
                for worker in workers(process.pid)[:1]:
                    peaks[hundred] = max(peaks[hundred], peak_kib(worker))
                    if begun // DISTINCT > hundred and begun < len(scenes):
                        forget_peak(worker)
    return process.returncode, [peaks[hundred] for hundred in sorted(peaks)]


def faults_of(folder, status, peaks):
    results = json.loads((folder / "out" / "results.json").read_text())
    calls = (folder / "calls").read_text().splitlines()
    seen = [view for view in results["views"] if view["view"]]
    if status != 3:
        yield f"status {status}; expected 3"
    if len(calls) != len(seen):
        yield f"{len(calls)} pictures were asked for, and {len(seen)} views are in the results"
    for call, view in zip(calls, seen):
        expected = OUTCOMES.get(call, ["unreadable"])
        if view["outcome"] not in expected:
            yield f"{view['scene']}/{view['view']}: {call}: {view['outcome']}: {view.get('message', '')}"
    if subprocess.run(["pgrep", "-f", "^sleep 100000$"], capture_output=True).returncode == 0:
        yield "a daemon is left behind"
    if peaks[-1] > ALLOWED_GROWTH * peaks[0]:
        yield "memory grows"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("program", "caster", "models"):
        parser.add_argument(name, type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("--scenes", type=int, default=1000)
    options = parser.parse_args()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="zproof-soak-"))
    scenes = list(make_scenes(folder, options.models, options.scenes))
    status, peaks = judge(options, folder, scenes)
    faults = list(faults_of(folder, status, peaks))
    print("peak of each hundred scenes, KiB:", *peaks)
    print(*faults, sep="\n")
    shutil.rmtree(folder)
    return 1 if faults else 0


sys.exit(main())
