"""How many operations a function takes, and on whose account."""

from __future__ import annotations

from ..ir.function import Function, count


class Counts(dict[str, int]):
    """Operator -> number of operations of a function.

    Attributes:
        blocks: Body, joint or force element -> the same for its part; what several of them use
            is under "shared", what nobody owns under "".
    """

    def __init__(self, function: Function) -> None:
        # the sections of the C that is written from it
        from ..codegen.owners import Owners

        super().__init__(function.operations())
        owners = Owners(function.graph, function.owners)
        nodes: dict[str, list[int]] = {}
        for i in function.live():
            nodes.setdefault(owners.of(i).section, []).append(i)
        counted = {name: count(function.graph, some) for name, some in nodes.items()}
        order = (*function.owners, *counted)
        self.blocks = {name: counted[name] for name in dict.fromkeys(order) if counted.get(name)}

    @property
    def total(self) -> int:
        """Number of all operations."""
        return sum(self.values())
