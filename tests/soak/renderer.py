#!/usr/bin/env python3
"""An honest ray caster that misbehaves at every tenth call, each time in another way.

    renderer.py CASTER FOLDER SCENE CAMERA OUT      FOLDER/calls gets a line for each call: "honest", or the fault
"""
import itertools
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
FAULTY = HERE.parent / "cli" / "faulty_renderer.py"
sys.path.insert(0, str(FAULTY.parent))
import faulty_renderer  # noqa: E402 (its folder is named above)

OF_ITS_OWN = ["talks_without_end", "leaves_a_daemon", "writes_far_too_much"]
# In turn one without a frame and another: the first hundred scenes need the memory for each kind, too.
PAIRS = itertools.zip_longest(faulty_renderer.NO_FRAMES, [*faulty_renderer.WRONG_FRAMES, *OF_ITS_OWN])
FAULTS = [fault for pair in PAIRS for fault in pair if fault]


def misbehave(fault, scene, camera, out):
    if fault == "talks_without_end":
        os.execvp("yes", ["yes"])
    if fault == "leaves_a_daemon":
        subprocess.Popen(["sleep", "100000"], start_new_session=True)
    if fault == "writes_far_too_much":
        with open(out, "wb") as file:
            file.truncate(1 << 34)
    if fault not in OF_ITS_OWN:
        os.execv(sys.executable, [sys.executable, str(FAULTY), fault, scene, camera, out])


def main():
    caster, folder, scene, camera, out = sys.argv[1:]
    log = pathlib.Path(folder) / "calls"
    count = len(log.read_text().splitlines()) if log.exists() else 0
    fault = FAULTS[count // 10 % len(FAULTS)] if count % 10 == 9 else ""
    with open(log, "a") as file:
        print(fault or "honest", file=file)
    if fault:
        misbehave(fault, scene, camera, out)
    else:
        os.execv(caster, [caster, scene, camera, out])


main()
