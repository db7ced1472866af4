# SPDX-License-Identifier: MIT
"""Rules for collective construction, from Python.

    import stigc
    rules = stigc.RuleSet.load("rulesets/staircase.yaml")
    grown = stigc.explore(rules, agents=5, seed=1)
    grown.bricks                    # (6, 4) int32: x, y, z and the brick's number
    stigc.verify(rules)["verdict"]  # "proved"

Functions are the program's commands of the same names: their options are keyword arguments
(``agents_at`` is ``--agents-at``; True is an option without value), and what they return is what the
command prints with ``--json``. What the command line refuses is a :class:`StigcError` with the same
exit status and the same codes. Names of files that ship are known, as on the command line.

Other threads of Python run while a command works, and Ctrl-C interrupts it.
"""
import os

from . import _stigc

_here = os.path.dirname(os.path.abspath(__file__))
# Files that ship are beside the program: in a build tree, or installed.
for _folder in (os.path.join(_here, "..", ".."), os.path.join(_here, *[".."] * 4, "bin")):
    if os.path.exists(os.path.join(_folder, "stigc")):
        _stigc.set_program_folder(os.path.normpath(_folder))
        break

from ._commands import (  # noqa: E402  (after the folder is known)
    Growth,
    Synthesis,
    certify,
    check,
    compile,
    explore,
    read_structure,
    simulate,
    synth,
    validate,
    verify,
    write_structure,
)
from ._rules import RuleSet, StigcError  # noqa: E402
from ._scene import Scene  # noqa: E402
from ._search import Candidate, Genome, Search  # noqa: E402
from ._traces import DepositTrace, PoseTrace, read_trace  # noqa: E402

__version__ = _stigc.version
__all__ = [
    "Candidate",
    "DepositTrace",
    "Genome",
    "Growth",
    "PoseTrace",
    "RuleSet",
    "Scene",
    "Search",
    "StigcError",
    "Synthesis",
    "certify",
    "check",
    "compile",
    "explore",
    "read_structure",
    "read_trace",
    "simulate",
    "synth",
    "validate",
    "verify",
    "write_structure",
]
