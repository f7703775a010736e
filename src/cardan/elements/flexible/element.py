"""Interface of the flexible elements, and the assembly of their functions.

An element couples two ends (:mod:`.ends`). Its functions have local inputs: q, u and udot of the
nodes of its ends one after the other, and its data p, whose names stand in ``common`` (what
section, material and parameters give) and ``geometric`` (what the geometry gives), in this order,
followed by those of ends that are not at a node (:meth:`.Ends.names`).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import Any, ClassVar

from ...ir.derivative import directional
from ...ir.function import Block, Function, Output
from ...ir.graph import Graph
from ...ir.matrix import Matrix
from ...literature import HasSource
from ..formulas import Lines, Shapes
from .element_ends import NODE, Ends


class FlexibleElement(HasSource, ABC):
    """A flexible element between two ends.

    Attributes:
        kind: Name in scenes, and of its kind of element.
        geometric: Names of the data that come from the geometry once and for all.
        formulas: For readers, in Python; empty where they are not written yet.
        symbol_shapes: Of what they read; see :mod:`..formulas`.
    """

    kind: ClassVar[str]
    geometric: ClassVar[tuple[str, ...]] = ()
    formulas: ClassVar[Lines] = ()
    symbol_shapes: ClassVar[Shapes] = {}

    @property
    @abstractmethod
    def common(self) -> tuple[str, ...]:
        """Names of the data that may depend on parameters."""

    @abstractmethod
    def functions(self, ends: Ends) -> dict[str, Function]:
        """Its functions between such ends, by name."""

    @property
    def about(self) -> str:
        """One line for the reader of the C."""
        return " ".join((self.__doc__ or "").split(".")[0].split())

    @property
    def formula_lines(self) -> Lines:
        """Formulas of the element with its options."""
        return self.formulas

    @property
    def carries(self) -> tuple[str, ...]:
        """Names of the data of loads that it carries for all elements beside it."""
        return ()

    @property
    def strain(self) -> str:
        """What of its forces is that of a strain: ``"alone"``, ``"mixed"`` or nothing, ""."""
        return ""

    @property
    def variant(self) -> str:
        """Suffix of the kind's name for the options of the element."""
        return ""

    def name(self, kinds: tuple[str, ...] = (NODE, NODE)) -> str:
        """C name of its kind between such ends."""
        end_kinds = kinds if set(kinds) != {NODE} else ()
        return "_".join(word for word in (self.kind, self.variant, *end_kinds) if word)

    def data(self, kinds: tuple[str, ...] = (NODE, NODE)) -> tuple[str, ...]:
        """Names of the entries of p between such ends."""
        return (*self.common, *self.geometric, *Ends.names(kinds))

    def ends(self, kinds: tuple[str, ...] = (NODE, NODE)) -> Ends:
        """A fresh graph with the two ends in it."""
        return Ends(Graph(), kinds, self.data(kinds))

    def derived(self, kinds: tuple[str, ...] = (NODE, NODE)) -> Mapping[str, Function]:
        """Its functions between such ends.

        Args:
            kinds: Of its ends, see :mod:`.places`; one is not a ground.
        """
        return self.functions(self.ends(kinds))

    def rows(self, stations: object, poses: object) -> Any:
        """The own data of the elements of a beam, (n, len(own)).

        Args:
            stations: Arc lengths of the nodes in the reference shape (n + 1,) [m].
            poses: Unit quaternions of the section axes and positions in ground axes there, those
                of the two ends of every element one after the other, (n, 14).
        """
        import numpy as np

        length = np.diff(np.asarray(stations, dtype=float))
        columns_by_name = {"length": length} | self.shapes(length, np.asarray(poses, dtype=float))
        columns = [columns_by_name[name] for name in self.geometric]
        return np.column_stack(columns) if columns else np.empty((len(length), 0))

    def shapes(self, length: object, poses: object) -> dict[str, Any]:
        """Data by name that come from the reference shape, (n,) each; see :meth:`rows`."""
        return {}

    def function(
        self, ends: Ends, name: str, blocks: Sequence[Block], *outputs: Output
    ) -> Function:
        """A function of the kind."""
        element_name, kind = self.name(ends.kinds), self.kind.replace("_", " ")
        ends.graph.describe(type(self), element_name)
        symbol, owners = f"{element_name}__{name}", ("", kind)
        return Function(symbol, ends.graph, tuple(blocks), outputs, owners, self.about)


def balance(ends: Ends, loads: Matrix) -> Output:
    """Forces that hold the ends (nu)."""
    return Output("balance", (loads.rows,), loads.nodes, ends.speeds, ends.load_units)


def matrix(ends: Ends, name: str, values: Matrix) -> Output:
    """A tangent (nu, nu)."""
    entries = tuple(f"{a},{b}" for a in ends.speeds for b in ends.speeds)
    return Output(name, (values.rows, values.columns), values.nodes, entries)


def energy(kinetic: Matrix | None, potential: Matrix | None) -> Output:
    """Kinetic and potential energy from columns with one entry."""
    nodes = tuple(0 if part is None else part.nodes[0] for part in (kinetic, potential))
    return Output("energy", (2,), nodes, ("kinetic", "potential"), ("J", "J"))


def tangents(ends: Ends, loads: Matrix, *letters: str) -> tuple[Output, ...]:
    """K, C and M of a balance by differentiation, those that are asked for and not zero.

    Args:
        ends: What the balance depends on.
        loads: The balance (nu, 1).
        letters: Of "q" along increments, "u" and "udot".
    """
    g, outputs = ends.graph, list[Output]()
    for letter, name in (("q", "K"), ("u", "C"), ("udot", "M")):
        if letter not in letters:
            continue
        head = "by_" if letter == "q" else f"by_{letter}_"
        labels = [f"{head}{speed}" for speed in ends.speeds]
        columns = directional(g, loads.nodes, ends.directions(letter), labels)
        rows = zip(*columns, strict=True)
        values = Matrix(g, loads.rows, loads.rows, [x for row in rows for x in row])
        if not values.is_zero:
            outputs.append(matrix(ends, name, values))
    return tuple(outputs)
