"""Whose the values are: the section they stand in, and what they were made for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from .graph import Graph, Origin

SHARED = "shared"


class Owner(NamedTuple):
    """Whose a value is.

    Attributes:
        section: Owner whose section it stands in, or the quantity of nobody; "shared" where there
            are several.
        quantity: What it is, or what it was made for.
    """

    section: str
    quantity: str


class Owners:
    """Owners of the nodes of a graph: by label, else the first in graph numbering.

    Args:
        graph: The graph.
        owners: Names of the owners in graph numbering.
    """

    def __init__(self, graph: Graph, owners: Sequence[str]) -> None:
        self._graph = graph
        self._rank = {name: k for k, name in enumerate(owners)}
        self._alone: dict[Origin, Owner] = {}
        self._several: dict[Origin, Owner] = {}

    def of(self, i: int) -> Owner:
        """Owner of a node. Nodes of several owners stand in the section "shared"."""
        graph, owners = self._graph, self._alone
        origin = graph.labels.get(i)
        if origin is None:
            origin = graph.origins[i]
            if i in graph.shared:
                origin, several = self._first(i)
                owners = self._several if several else owners
        owner = owners.get(origin)
        if owner is None:
            name, quantity = origin
            section = name or quantity if owners is self._alone else SHARED
            owner = owners[origin] = Owner(section, quantity)
        return owner

    def _first(self, i: int) -> tuple[Origin, bool]:
        """First origin of a node in graph numbering, and whether owners differ."""
        last = len(self._rank)
        origins = {*self._graph.shared[i], self._graph.origins[i]}
        ranked = sorted(
            origins, key=lambda o: (o[0] == "", self._rank.get(o[0], last), not o[1], o)
        )
        return ranked[0], len({owner for owner, _ in ranked if owner}) > 1
