"""Names of the values of a file, and places of those that come from outside."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...ir.function import Function
from ...ir.owners import Owners
from .naming import Names, ValueNames, comment, mangle
from .program import Declare, Place


class Values:
    """Names, units and places of the values of one file.

    Attributes:
        function: Whose values they are.
        owners: Whose the nodes are.
        w: Prepared node -> its place in w.
        names: Identifiers given out so far; input entries and prepared values have theirs.

    Args:
        function: As above.
        order: Its live nodes.
        prepared: What the parameter stage makes, in the order of w.
        where: Place of an entry of a block or of w; by default that entry.
    """

    def __init__(
        self,
        function: Function,
        order: Sequence[int],
        prepared: Sequence[int],
        where: Callable[[str, int], Place] = Place,
    ) -> None:
        self.function = function
        self.where = where
        self.owners = Owners(function.graph, function.owners)
        self._entries = {
            (block.name, k): entry
            for block in function.inputs
            for k, entry in enumerate(zip(block.entries, block.units, strict=True))
        }
        self.namer = ValueNames(function, order, self._input_phrase)
        self.w = {node: k for k, node in enumerate(prepared)}
        self._unique = Names((function.name, f"prepare_{function.name}"))
        self._locals: dict[str, list[str]] = {}
        self.names: dict[int, str] = {}
        # names of the user first; prepared values have one name in both stages
        nodes = function.graph.nodes
        for i in (*(i for i in order if nodes[i][0] == "var"), *prepared):
            self.name(i)

    def name(self, i: int) -> str:
        """The identifier of a node, made when it is first asked for."""
        node = self.function.graph.nodes[i]
        if node[0] != "var":
            return self.named(i)
        if i not in self.names:
            # a coordinate is called like its joint: keep them apart
            suffix = "q" if node[1] == "q" and "." not in self.entry(i)[0] else ""
            self.names[i] = self._unique.new(mangle(self._input_phrase(i)[0], suffix))
        return self.names[i]

    def _input_phrase(self, i: int) -> tuple[str, str]:
        """Words for an input entry, and whose it is."""
        _, block, k = self.function.graph.nodes[i]
        text = self.entry(i)[0] or f"{block}_{k}"
        return mangle(text), mangle(text.partition(".")[0])

    def named(self, i: int) -> str:
        """The identifier of a computed node."""
        name = self.names.get(i)
        if name is None:
            name = self.names[i] = self._unique.new(self.namer.of(i))
        return name

    def local(self, base: str, number: int) -> str:
        """An identifier that belongs to no node: the next of a stage, the same in every stage."""
        names = self._locals.setdefault(base, [])
        while len(names) <= number:
            names.append(self._unique.new(base))
        return names[number]

    def entry(self, i: int) -> tuple[str, str]:
        """(name, unit) of an input entry as the user knows it, ("", "") for other nodes."""
        node = self.function.graph.nodes[i]
        return self._entries.get(node[1:], ("", "")) if node[0] == "var" else ("", "")

    def description(self, i: int) -> str:
        """Text for a comment: the user's name and unit of an input entry, or the identifier."""
        entry, unit = self.entry(i)
        return comment(f"{entry} [{unit}]" if entry and unit else entry or self.name(i))

    def place(self, i: int, prepared: bool) -> Place:
        """Place of an outside value; in the parameter stage p itself.

        Args:
            prepared: The reader runs after the parameter stage.
        """
        if prepared and i in self.w:
            return self.where("w", self.w[i])
        return self.where(*self.function.graph.nodes[i][1:])

    def load(self, i: int, prepared: bool) -> Declare:
        """The statement that gives an outside value its name."""
        place = self.place(i, prepared)
        unit = comment(self.entry(i)[1])
        return Declare(self.name(i), place, unit, place.array in ("w", "p"))
