# SPDX-License-Identifier: MIT
"""Traces as arrays."""
from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Union

import numpy as np
from numpy.typing import NDArray

from . import _stigc
from ._rules import RuleSet, StigcError


@dataclass
class DepositTrace:
    """A run of the lattice world, as a .stigt has it."""

    #: (deposits, 7): step, agent, x, y, z (cells), brick, rule, as :attr:`Growth.deposits`.
    deposits: NDArray[np.int64]
    #: Steps of the whole run.
    steps: int
    #: The rules that ran.
    rules: RuleSet


@dataclass
class PoseTrace:
    """A run of the physical world, as a .stigp has it: places to 10 µm, turns to 0.007°."""

    #: (frames,): s, since the beginning.
    times: NDArray[np.float64]
    #: (frames, bodies, 7): x, y, z (m) and the quaternion w, x, y, z; NaN of bodies that have left.
    poses: NDArray[np.float64]
    #: Of the bodies, in the order of the second axis.
    names: list[str]
    seed: int
    #: Why it ended: "duration", "asleep", "interrupted" …
    end: str


def read_trace(path: Union[str, "os.PathLike[str]"]) -> Union[DepositTrace, PoseTrace]:
    """Reads what ``stigc explore -o FILE.stigt`` or ``stigc simulate --trace FILE.stigp`` has
    written, by the file's ending.

    :raises StigcError: where it cannot be read, or is no such trace."""
    name = os.fspath(path)
    try:
        if name.endswith(".stigp"):
            return PoseTrace(**_stigc.poses_in(name))
        found = _stigc.deposits_in(name)
    except ValueError as problem:
        raise StigcError(1, [], str(problem)) from None
    return DepositTrace(found["deposits"], found["steps"], RuleSet(found["rules"]))
