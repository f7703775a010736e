"""Functions that a kernel of C assembles from numbers of every body.

Expressions, straight-line or as a recursion, compute what belongs to single bodies of a tree; a
kernel in ``kernels/trees`` goes on from there with loops over a table. What the kernel computes is
told here too, as expressions: for the interpreter, for 40 digits and for languages without it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from typing import TypeAlias

from ...records import dataclass
from ..function import Block, Function, Output
from ..recursion import Recursion
from .kernels import KERNELS
from .table import Tree


@dataclass(frozen=True)
class Assembly:
    """A function that is assembled by a kernel.

    Attributes:
        name: C name.
        inputs: The blocks it may read, in ABI order.
        outputs: Its results; their nodes only say which may be other than 0.
        parts: Gives the numbers of the bodies, its only output; of the same C name.
        kernel: Member of ``KERNELS``.
        tree: The table that the kernel loops over.
        about: One line for the reader of the C.
    """

    name: str
    inputs: tuple[Block, ...] = field(repr=False)
    outputs: tuple[Output, ...] = field(repr=False)
    parts: Function | Recursion
    kernel: str
    tree: Tree = field(repr=False)
    about: str = ""

    @property
    def counts(self) -> Mapping[str, int]:
        """Operations of the kernel per call, by operator."""
        return KERNELS[self.kernel].counts(self.tree)

    def operations(self) -> dict[str, int]:
        """Number of operations per operator, of the parts and of the kernel."""
        total = dict(self.parts.operations())
        for op, n in self.counts.items():
            total[op] = total.get(op, 0) + n
        return total

    def entries_read(self, block: str) -> frozenset[int]:
        """Numbers of the entries of a block that results depend on."""
        return self.straight().entries_read(block)

    def straight(self) -> Function:
        """The same function as straight-line expressions."""
        parts = self.parts if isinstance(self.parts, Function) else self.parts.straight()
        graph = parts.graph
        if isinstance(self.parts, Function):
            graph = graph.fork()
        nodes = KERNELS[self.kernel].expressions(graph, parts.outputs[0].nodes, self.tree)
        outputs, at = [], 0
        for o in self.outputs:
            outputs.append(replace(o, nodes=tuple(nodes[at : at + o.size])))
            at += o.size
        owners = parts.owners
        return Function(self.name, graph, self.inputs, tuple(outputs), owners, self.about)


# what C is written from
Form: TypeAlias = Function | Recursion | Assembly
