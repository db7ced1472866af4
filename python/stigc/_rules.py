# SPDX-License-Identifier: MIT
"""Rule sets as objects, and errors."""
from __future__ import annotations

import itertools
import json
import os
from typing import Any, Union

from . import _stigc

_numbers = itertools.count()


class StigcError(Exception):
    """What the program refuses.

    ``status`` is its exit status: 1 a file is wrong or a property does not hold, 2 an option is
    wrong, 3 the work failed. ``codes`` are those of the diagnostics (``stigc --explain R304`` says
    what one means), ``text`` is what the program says.
    """

    def __init__(self, status: int, codes: list[str], text: str) -> None:
        super().__init__(text.strip() or f"exit status {status}")
        self.status = status
        self.codes = codes
        self.text = text


class RuleSet:
    """A rule set: YAML that is in memory, and need not be in any file. It never changes."""

    def __init__(self, text: str, near: str = "rules.yaml") -> None:
        """``near``: names of other files in it, and messages, are as if it were that file."""
        self.text = text
        self.near = near
        folder, name = os.path.split(near)
        stem, ending = os.path.splitext(name)
        own = os.path.join(folder, f"{stem}@python-{next(_numbers)}{ending}")
        self._file = _stigc.MemoryFile(own, text)

    @classmethod
    def load(cls, path: Union[str, "os.PathLike[str]"]) -> "RuleSet":
        """Reads a file; one that ships is found by its name, as ``rulesets/wall.yaml``."""
        status, out, err, codes = _stigc.run(["fmt", "--quiet", os.fspath(path)])
        if status != 0:
            raise StigcError(status, codes, err)
        return cls(out, os.fspath(path))

    @property
    def path(self) -> str:
        """The name under which commands of this process find it."""
        return self._file.path

    def with_value(self, path: str, value: Any) -> "RuleSet":
        """The same but for one value, as ``with_value("rules.grow.probability", 0.5)``: words of the
        path are keys, names of rules, or numbers from 1 on. ValueError where it leads nowhere."""
        return RuleSet(_stigc.with_value(self.text, path, json.dumps(value)), self.near)

    def __repr__(self) -> str:
        return f"RuleSet(near={self.near!r})"
