# SPDX-License-Identifier: MIT
"""The program's commands as functions."""
from __future__ import annotations

import json
import os
import tempfile
from dataclasses import dataclass
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _stigc
from ._rules import RuleSet, StigcError

Path = Union[str, "os.PathLike[str]"]
Rules = Union[RuleSet, Path]


def _file(given: Rules) -> str:
    return given.path if isinstance(given, RuleSet) else os.fspath(given)


def _word(name: str, value: Any) -> list[str]:
    option = "--" + name.replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [option]
    if isinstance(value, (list, tuple, np.ndarray)):
        # A list of lists is the option given several times.
        if len(value) > 0 and isinstance(value[0], (list, tuple, np.ndarray)):
            return [word for one in value for word in _word(name, one)]
        value = ",".join(str(one) for one in value)
    elif isinstance(value, os.PathLike):
        value = os.fspath(value)
    return [f"{option}={value}"]


def _words(command: str, files: list[str], options: dict[str, Any]) -> list[str]:
    words = [command, *files, "--quiet", "--color=never"]
    for name, value in options.items():
        words += _word(name, value)
    return words


def _json(command: str, files: list[str], options: dict[str, Any]) -> dict[str, Any]:
    """What is printed; a StigcError where there is nothing but complaints."""
    form = {"target": "ir"} if command == "compile" else {"json": True}
    status, out, err, codes = _stigc.run(_words(command, files, {**options, **form}))
    try:
        return json.loads(out)
    except json.JSONDecodeError:
        raise StigcError(status, codes, err) from None


def check(rules: Rules) -> list[str]:
    """The warnings of a rule set, as text; StigcError, with all codes, where it has errors."""
    status, out, err, codes = _stigc.run(_words("check", [_file(rules)], {}))
    if status != 0:
        raise StigcError(status, codes, err or out)
    return [line for line in err.splitlines() if "warning" in line]


class Growth:
    """What :func:`explore` has grown.

    The arrays are views of the run's own memory, which lives as long as they do.
    """

    def __init__(self, run: _stigc.Growth) -> None:
        self._run = run
        #: What ``stigc explore --json`` prints: steps, deposits, measures, hashes and so on.
        self.report: dict[str, Any] = json.loads(run.report)

    @property
    def bricks(self) -> NDArray[np.int32]:
        """(bricks, 4): the cell x, y, z (in cells; on the hexagonal lattice q, r, z) and the number
        of the brick in the rule set, from 1 on; sorted by cell."""
        return self._run.bricks

    @property
    def deposits(self) -> NDArray[np.int64]:
        """(deposits, 7): step (from 1 on), agent (-1: event motion), x, y, z, brick, rule (from 0
        on); in the order of time."""
        return self._run.deposits


def explore(rules: Rules, *, seed: int = 1, **options: Any) -> Growth:
    """Grows a rule set once. Options: ``box``, ``agents``, ``agents_at``, ``motion``, ``moves``,
    ``steps``, ``deposits``, ``run`` … as ``stigc explore --help`` lists them.

    :raises StigcError: where rules or options are wrong."""
    words = _words("explore", [_file(rules)], {"seed": seed, **options})
    run = _stigc.grow(words)
    if run.status != 0:
        raise StigcError(run.status, run.codes, run.problem)
    return Growth(run)


def verify(rules: Rules, **options: Any) -> dict[str, Any]:
    """Does every order of events end alike? ``["verdict"]`` is "proved", "refuted" or "unknown".
    Options: ``box``, ``effort``, ``budget`` (s), ``certificate`` (a file to write) …"""
    return _json("verify", [_file(rules)], options)


def certify(rules: Rules, certificate: Path, **options: Any) -> dict[str, Any]:
    """Checks a certificate by code that shares nothing with :func:`verify`."""
    return _json("certify", [_file(rules), os.fspath(certificate)], options)


@dataclass
class Synthesis:
    """What :func:`synth` has found."""

    #: What ``stigc synth --json`` prints.
    report: dict[str, Any]
    #: None where none was found; the report says why.
    rules: Optional[RuleSet]


def synth(structure: Union[Path, ArrayLike], **options: Any) -> Synthesis:
    """A rule set that builds a structure in every order of events.

    ``structure`` is a file, or an array as :attr:`Growth.bricks` is: (bricks, 4), or (bricks, 3)
    for a shape alone. Options: ``colours``, ``symmetry``, ``robot``, ``robots``, ``effort`` …"""
    with tempfile.TemporaryDirectory() as folder:
        if isinstance(structure, (str, os.PathLike)):
            source = os.fspath(structure)
        else:
            source = os.path.join(folder, "structure.json")
            write_structure(source, structure)
        output = os.path.join(folder, "rules.yaml")
        report = _json("synth", [source], {**options, "output": output})
        if not os.path.exists(output):
            return Synthesis(report, None)
        with open(output, encoding="utf-8") as file:
            return Synthesis(report, RuleSet(file.read()))


def compile(rules: Rules, **options: Any) -> dict[str, Any]:
    """The program of a robot, as ``stigc compile --target ir`` prints it. Options: ``robot``,
    ``block``, ``sides``, ``robots``, ``certificate`` …

    :raises StigcError: with the codes P7xx where this robot cannot build it."""
    return _json("compile", [_file(rules)], options)


def validate(rules: Rules, **options: Any) -> dict[str, Any]:
    """Lets robots build it as physics has it, and judges what they build. Options: ``robots``,
    ``robot``, ``runs``, ``seed``, ``duration`` (s), ``scene``, ``output`` (a folder) …"""
    return _json("validate", [_file(rules)], options)


def simulate(scene: Path, **options: Any) -> dict[str, Any]:
    """Runs a scene to its end. Options: ``duration`` (s), ``seed``, ``trace`` … :class:`Scene` is
    for scenes that are stepped."""
    return _json("simulate", [os.fspath(scene)], options)


def read_structure(path: Path) -> NDArray[np.int32]:
    """A structure file (.vox .json .txt) as (bricks, 4): x, y, z (cells), and the brick's number
    from 1 on."""
    bricks, _, problem = _stigc.read_structure(os.fspath(path))
    if bricks is None:
        raise StigcError(1, [], problem)
    return bricks


_COLOURS = ["#e6194b", "#3cb44b", "#4363d8", "#f58231", "#911eb4", "#46f0f0"]


def write_structure(path: Path, bricks: ArrayLike, lattice: str = "cubic") -> None:
    """Writes an array as :func:`read_structure` gives it, or of cells alone, as .json."""
    rows = np.asarray(bricks, dtype=np.int64)
    if rows.ndim != 2 or rows.shape[1] not in (3, 4):
        raise ValueError(f"bricks are rows of 3 or 4 numbers, not {rows.shape}")
    if rows.shape[1] == 3:
        rows = np.column_stack([rows, np.ones(len(rows), dtype=np.int64)])
    most = int(rows[:, 3].max()) if len(rows) else 1
    text = {
        "stigc_structure": 1,
        "lattice": lattice,
        "bricks": [
            {"symbol": str(k), "name": str(k), "color": _COLOURS[k % len(_COLOURS)]}
            for k in range(1, most + 1)
        ],
        "cells": rows.tolist(),
    }
    with open(path, "w", encoding="utf-8") as file:
        json.dump(text, file)
