# SPDX-License-Identifier: MIT
"""Scenes that Python steps."""
from __future__ import annotations

import os
from typing import Any, Callable, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _stigc
from ._rules import StigcError

#: Takes readings, returns commands; None: all stays as it is.
Controller = Callable[[dict[str, Any]], Optional[dict[str, Any]]]


class Scene:
    """A scene of blocks and robots, run step by step.

    ``controllers`` are functions by the names of robots, called at every tick of their robot with
    what it reads; other robots have the programs that the scene names. SI units throughout.

    Readings: ``tick``, ``time`` (s), ``wheels`` (m/s left and right, of the rims), ``lift`` (m),
    ``magnet_voltage``, ``rangefinders`` (counts, or m where calibrated), ``compasses`` (rad),
    ``joints``, and ``tags``: for each camera a list of ``{"id", "position", "turn"}``, m and
    quaternion w x y z in the camera's frame.

    Commands: ``wheels`` (left, right, m/s), ``lift`` (m, or "stop", "calibrate"), ``discharge``
    ("constructive", "destructive", "disable"), ``cameras`` (bool), ``log`` (a line).

    What a controller raises stops its robot and is raised from :meth:`step`.
    """

    def __init__(
        self,
        path: Union[str, "os.PathLike[str]"],
        seed: Optional[int] = None,
        controllers: Optional[dict[str, Controller]] = None,
    ) -> None:
        self._scene = _stigc.Scene(os.fspath(path), seed, dict(controllers or {}))
        if not self._scene.ready:
            raise StigcError(1, self._scene.codes, self._scene.problem)
        unknown = set(controllers or {}) - set(self._scene.robot_names)
        if unknown:
            raise ValueError(f"the scene has no robot {', '.join(sorted(unknown))}")

    @property
    def robots(self) -> list[str]:
        """Names of the robots."""
        return self._scene.robot_names

    @property
    def time(self) -> float:
        """s, since the beginning."""
        return self._scene.time

    @property
    def duration(self) -> float:
        """s, that the scene's file asks for."""
        return self._scene.duration

    @property
    def hash(self) -> int:
        """Of the state of the world and all programs: equal for equal runs."""
        return self._scene.hash

    def step(self, seconds: float) -> str:
        """Goes on for so long. Empty, or why the run has ended: "script", "diverged", "asleep" …"""
        return self._scene.step(seconds)

    def poses(self) -> NDArray[np.float64]:
        """(bodies, 7): x, y, z (m) and the quaternion w, x, y, z; NaN of bodies that have left."""
        return self._scene.poses()

    def robot_pose(self, name: str) -> NDArray[np.float64]:
        """(7,): as a row of :meth:`poses`."""
        return np.array(self._scene.robot_poses()[name])

    def take_lines(self) -> list[tuple[str, str]]:
        """What robots and blocks have said since the last call: who and what."""
        return self._scene.take_lines()
