# SPDX-License-Identifier: MIT
"""Searches for rule sets that Python scores, and genomes for other optimisers."""
from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _stigc
from ._rules import RuleSet, StigcError, _numbers


class Genome:
    """A rule set as a search changes it (docs/search.md). It never changes; equal ones are equal."""

    def __init__(self, genome: Union[str, _stigc.Genome]) -> None:
        """From its text; ValueError where that is none."""
        self._genome = _stigc.Genome(genome) if isinstance(genome, str) else genome

    @property
    def text(self) -> str:
        """A line for the genome and one for each rule, as files of results have it."""
        return self._genome.text()

    @property
    def rules(self) -> RuleSet:
        """The rule set that it stands for."""
        return RuleSet(self._genome.rules())

    def encode(self) -> NDArray[np.int32]:
        """(rules, 3 + neighbours), 26 neighbours on the cubic lattice and 20 on the hexagonal one:
        the colour placed, the least and the greatest height (inclusive; the least and the greatest
        int32: no bound), and for each neighbour the states that it may have, as bits: 0 empty,
        1 to 15 the colours, 16 the floor."""
        return self._genome.encode()

    def with_rules(self, rows: ArrayLike) -> "Genome":
        """Its lattice, floor, colours, start and symmetry with rules as :meth:`encode` gives them;
        ValueError where they are none: each asks for a brick beside its site."""
        return Genome(self._genome.with_rules(np.asarray(rows, dtype=np.int32)))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Genome) and self._genome == other._genome

    def __hash__(self) -> int:
        return hash(self._genome)

    def __repr__(self) -> str:
        return f"Genome({self.text!r})"


class Candidate:
    """What a search has made and measured."""

    def __init__(self, candidate: _stigc.Candidate) -> None:
        #: Number of its evaluation, from 0 on.
        self.id: int = candidate.id
        #: "drawn", "mutated", "mended" or "crossed".
        self.origin: str = candidate.origin
        #: Ids of none, one or two.
        self.parents: list[int] = candidate.parents
        self.genome = Genome(candidate.genome)
        #: By the plan, until it is told another.
        self.score: float = candidate.score
        #: Each objective's value by its name.
        self.measures: dict[str, float] = candidate.measures
        #: (bricks, 4): x, y, z (cells) and colour, from 1 on; sorted by cell.
        self.bricks: NDArray[np.int32] = candidate.bricks

    @property
    def rules(self) -> RuleSet:
        """The rule set, for every other function of this module."""
        return self.genome.rules


class Search:
    """A search (docs/search.md) that asks for scores.

    ``plan`` is a file, or the text of one. Candidates are made by the plan's method from what was
    told before, and measured by its objectives; its own score is there to begin with. With
    ``output`` results go into that file, batch by batch, for ``stigc archive``; the same plan and
    file go on where it ends. The same scores give the same search, on any number of ``threads``
    (0: all).

    :raises StigcError: where the plan or the file is wrong."""

    def __init__(
        self,
        plan: Union[str, "os.PathLike[str]"],
        output: Optional[Union[str, "os.PathLike[str]"]] = None,
        threads: int = 0,
    ) -> None:
        name = os.fspath(plan)
        file = None if output is None else os.fspath(output)
        # The text of a plan has lines.
        own = f"plan@python-{next(_numbers)}.yaml"
        self._text = _stigc.MemoryFile(own, name) if "\n" in name else None
        path = self._text.path if self._text else name
        self._search = _stigc.Search(path, file, threads)
        if not self._search.ready:
            raise StigcError(1, self._search.codes, self._search.problem)

    def ask(self, count: Optional[int] = None) -> list[Candidate]:
        """The next candidates, as many as the plan's batch has without ``count``. Asking again
        before :meth:`tell` forgets those asked for before."""
        count = self._search.batch if count is None else count
        if count < 1:
            raise ValueError("ask for one candidate or more")
        return [Candidate(one) for one in self._search.ask(count)]

    def tell(self, scores: ArrayLike) -> None:
        """(candidates,): scores, higher is better, of those asked for last, in their order;
        ValueError where one is missing or not finite. RuntimeError where they cannot be written."""
        self._search.tell(np.asarray(scores, dtype=np.float64).tolist())

    def best(self, most: int = 10) -> list[Candidate]:
        """The best of each structure so far, by falling score."""
        return [Candidate(one) for one in self._search.best(most)]

    @property
    def evaluated(self) -> int:
        """Candidates that were told of."""
        return self._search.evaluated

    @property
    def structures(self) -> int:
        """Different structures that they built."""
        return self._search.structures

    @property
    def content_hash(self) -> str:
        """Of all that was found: equal for equal searches."""
        return self._search.content_hash

    def draw(self, seed: int) -> Genome:
        """A genome of which every rule can fire, by the plan's settings."""
        return Genome(self._search.draw(seed))

    def mutate(self, genome: Genome, seed: int) -> Genome:
        """One to four rules changed, mostly such as never fire."""
        return Genome(self._search.mutate(genome._genome, seed))

    def cross(self, early: Genome, late: Genome, seed: int) -> Genome:
        """Rules that fire early in the one and late in the other."""
        return Genome(self._search.cross(early._genome, late._genome, seed))

    def measure(self, genomes: Sequence[Genome]) -> list[Candidate]:
        """Genomes from anywhere, run and measured as the plan says; the search goes on without
        them. Each depends on its genome alone."""
        return [Candidate(one) for one in self._search.measure([g._genome for g in genomes])]
