"""zproof: is what a renderer saw through every pixel right? Numpy in, verdict out.

    scene = zproof.load("model.glb")             # or zproof.Scene(positions, triangles)
    view = scene.views["cam"]                    # or zproof.View.perspective(...)
    verdict = zproof.judge(scene, view, id=ids, depth=depths, precision="opengl")
    assert verdict.proven, verdict.explain(verdict.worst.x, verdict.worst.y)

docs/python.md tells the rest.
"""

import os as _os
import sys as _sys

# Where pip installed both into a venv, the program is that of the venv, whatever PATH says.
_program = _os.path.join(_sys.prefix, "bin", "zproof")
if _sys.prefix != _sys.base_prefix and _os.access(_program, _os.X_OK):
    _os.environ.setdefault("ZPROOF_PROGRAM", _program)

from zproof import filters
from zproof._zproof import (
    BACKGROUND_ID,
    CLASS_COLOURS,
    CLASS_NAMES,
    Diagnosis,
    Explanation,
    Finding,
    Frame,
    InputError,
    NearTriangle,
    Scene,
    Verdict,
    View,
    __version__,
    load,
    render,
    trace,
)
from zproof import notebook as _notebook
from zproof.judging import assert_proven, judge, save_all, story_of_worst, summary

__all__ = [
    "BACKGROUND_ID",
    "CLASS_COLOURS",
    "CLASS_NAMES",
    "Diagnosis",
    "Explanation",
    "Finding",
    "Frame",
    "InputError",
    "NearTriangle",
    "Scene",
    "Verdict",
    "View",
    "__version__",
    "assert_proven",
    "filters",
    "judge",
    "load",
    "render",
    "save_all",
    "story_of_worst",
    "summary",
    "trace",
]

_notebook.add_representations()
