import os
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from zproof._zproof import Scene, Verdict, View, _Tensor

# A preset's name, words, a dict of the same keys, or a file.
_Precision = str | os.PathLike[str] | dict[str, Any]

def precision_word(precision: _Precision) -> str: ...
def judge(
    scene: Scene,
    view: View,
    *,
    id: NDArray[np.uint32] | _Tensor | None = None,
    depth: NDArray[np.float32] | _Tensor | None = None,
    precision: _Precision,
    ids: str | os.PathLike[str] = "triangle",
) -> Verdict: ...
def story_of_worst(verdict: Verdict) -> str: ...
def summary(verdict: Verdict) -> str: ...
def assert_proven(
    scene: Scene,
    view: View,
    *,
    id: NDArray[np.uint32] | _Tensor | None = None,
    depth: NDArray[np.float32] | _Tensor | None = None,
    precision: _Precision,
    ids: str | os.PathLike[str] = "triangle",
) -> Verdict: ...
def failure_text(verdict: Verdict) -> str: ...
def save_all(verdicts: Mapping[str, Verdict], folder: str | bytes | os.PathLike[str]) -> None: ...
