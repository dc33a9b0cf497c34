import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

from zproof._zproof import Scene, View, _Tensor

_Picture = NDArray[np.float32] | _Tensor

class Table(dict[str, NDArray[Any]]):
    folder: str | None
    outside: dict[tuple[str, str, str], int]
    def __len__(self) -> int: ...
    def rows(self, **wanted: object) -> Table: ...
    def truth(self, *, scene: str | None = None, view: str | None = None) -> NDArray[np.float32]: ...
    def picture(self, method: str, *, scene: str | None = None, view: str | None = None) -> NDArray[np.float32]: ...
    def error(self, method: str, *, scene: str | None = None, view: str | None = None) -> NDArray[np.float32]: ...
    def _repr_html_(self) -> str: ...

class Check:
    outcome: Literal["passed", "failed", "nothing"]
    text: str
    outside: int
    pixels: int
    undecided: int
    slack: float
    worst: tuple[int, int] | None
    permitted_width: NDArray[np.float64]
    causes: list[str]
    chance: dict[str, Any] | None
    power: dict[str, Any] | None
    offsets: dict[str, dict[str, Any]]
    nearer_alternatives: list[str]
    def __init__(self, told: Mapping[str, Any]) -> None: ...
    @property
    def passed(self) -> bool: ...
    def __bool__(self) -> bool: ...

@overload
def truth(
    scene: Scene, view: View, reconstruction: str = "N", *, half_width: Literal[False] = False
) -> NDArray[np.float32]: ...
@overload
def truth(
    scene: Scene, view: View, reconstruction: str = "N", *, half_width: Literal[True]
) -> tuple[NDArray[np.float32], NDArray[np.float32]]: ...
_Method = Callable[[NDArray[np.float64], NDArray[np.float64], list[NDArray[np.float32]]], NDArray[Any]]

def paint(method: _Method, scene: Scene, view: View, *, batch: int = 65536) -> NDArray[np.float32]: ...
def run(
    methods: Iterable[str],
    scene: Scene | str | os.PathLike[str],
    view: View | str | None = None,
    *,
    own: Mapping[str, _Method] | None = None,
    pictures: Mapping[str, _Picture] | None = None,
    claims: Mapping[str, str] | None = None,
    precision: str | None = None,
    truth: str = "N",
    size: tuple[int, int] | None = None,
    flicker: int = 2,
    folder: str | os.PathLike[str] | None = None,
) -> Table: ...
def check(
    picture: _Picture,
    method: str,
    scene: Scene | str | os.PathLike[str],
    view: View | str | None,
    *,
    precision: str | None = None,
    size: tuple[int, int] | None = None,
) -> Check: ...
