"""How the values of a file are called, and where those that come from outside are read."""

from __future__ import annotations

from collections.abc import Sequence

from ..ir.function import Function
from .naming import Names, comment, mangle
from .plan import Owners
from .program import Declare, Place


class Values:
    """Names, units and places of the values of one file.

    Attributes:
        function: Whose values they are.
        owners: Whose the nodes are.
        w: Prepared node -> its place in w.
    """

    def __init__(self, function: Function, prepared: Sequence[int]) -> None:
        self.function = function
        self.owners = Owners(function.graph, function.owners)
        self.w = {node: k for k, node in enumerate(prepared)}
        self._unique = Names((function.name, f"prepare_{function.name}"))
        self._names: dict[int, str] = {}
        self._entries = {
            (block.name, k): entry
            for block in function.inputs
            for k, entry in enumerate(zip(block.entries, block.units, strict=True))
        }
        # prepared values have one name in both stages, given out in the order of w
        for node in prepared:
            self.name(node)

    def name(self, i: int) -> str:
        """The identifier of a node, made when it is first asked for."""
        found = self._names.get(i)
        if found is None:
            found = self._names[i] = self._unique.new(self._base(i))
        return found

    def _base(self, i: int) -> str:
        node = self.function.graph.nodes[i]
        if node[0] != "var":
            return self.owners.base(i)
        block, k = node[1:]
        entry = self.entry(i)[0] or f"{block}_{k}"
        # a coordinate is called like its joint: keep them apart
        return mangle(f"{entry}_q" if block == "q" and "." not in entry else entry)

    def entry(self, i: int) -> tuple[str, str]:
        """(name, unit) of an input entry as the user knows it, ("", "") for other nodes."""
        node = self.function.graph.nodes[i]
        return self._entries.get(node[1:], ("", "")) if node[0] == "var" else ("", "")

    def described(self, i: int) -> str:
        """Text for a comment: the user's name and unit of an input entry, or the identifier."""
        entry, unit = self.entry(i)
        return comment(f"{entry} [{unit}]" if entry and unit else entry or self.name(i))

    def place(self, i: int, prepared: bool) -> Place:
        """Where an outside value is read; in the parameter stage p itself is.

        Args:
            prepared: The reader runs after the parameter stage.
        """
        if prepared and i in self.w:
            return Place("w", self.w[i])
        return Place(*self.function.graph.nodes[i][1:])

    def load(self, i: int, prepared: bool) -> Declare:
        """The statement that gives an outside value its name."""
        place = self.place(i, prepared)
        unit = comment(self.entry(i)[1])
        return Declare(self.name(i), place, unit, place.array in ("w", "p"))
