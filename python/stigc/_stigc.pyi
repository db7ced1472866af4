# SPDX-License-Identifier: MIT
from collections.abc import Callable
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

version: str

def run(words: list[str]) -> tuple[int, str, str, list[str]]: ...
def grow(words: list[str]) -> Growth: ...
def read_structure(
    path: str,
) -> tuple[Optional[NDArray[np.int32]], Optional[str], str]: ...
def set_program_folder(folder: str) -> None: ...
def with_value(text: str, path: str, value: str) -> str: ...

class MemoryFile:
    def __init__(self, path: str, text: str) -> None: ...
    @property
    def path(self) -> str: ...

class Growth:
    status: int
    problem: str
    codes: list[str]
    report: str
    @property
    def bricks(self) -> NDArray[np.int32]: ...
    @property
    def deposits(self) -> NDArray[np.int64]: ...

class Scene:
    def __init__(
        self, path: str, seed: Optional[int], controllers: dict[str, Callable[..., Any]]
    ) -> None: ...
    ready: bool
    problem: str
    codes: list[str]
    time: float
    hash: int
    duration: float
    robot_names: list[str]
    def step(self, seconds: float) -> str: ...
    def poses(self) -> NDArray[np.float64]: ...
    def robot_poses(self) -> dict[str, list[float]]: ...
    def take_lines(self) -> list[tuple[str, str]]: ...
