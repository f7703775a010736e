"""Functions whose results a routine of C gives instead of expressions."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import field
from math import prod

from ..records import dataclass
from .function import Function, Output
from .graph import ZERO, Graph


@dataclass(frozen=True)
class Routine(Function):
    """A function that a header of the kernels computes.

    The routine is called as ``call(*sizes, constants, in, out, work)``. Its results have no
    expressions: their nodes only say which of them may be other than 0.

    Attributes:
        call: Name in C.
        headers: Where it stands, those that it includes first.
        sizes: Its first arguments.
        constants: What it reads beside states and data.
        work: Numbers of scratch.
        counts: Operations per call.
    """

    call: str = ""
    headers: tuple[str, ...] = ()
    sizes: tuple[int, ...] = ()
    constants: tuple[float, ...] = field(default=(), repr=False)
    work: int = 0
    counts: Mapping[str, int] = field(default_factory=dict, repr=False)


def result(graph: Graph, name: str, shape: tuple[int, ...], zeros: Collection[int] = ()) -> Output:
    """A result without expressions.

    Args:
        graph: Of the routine.
        name, shape: Of the result.
        zeros: Entries that are 0 at every state.
    """
    some = graph.atom("result of a routine")
    return Output(name, shape, tuple(ZERO if k in zeros else some for k in range(prod(shape))))
