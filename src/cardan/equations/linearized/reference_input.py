"""The user's reference motion: names and SymPy expressions, as nodes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ...arguments import UNIT
from ...errors import DerivationError, brief, near
from ...ir.function import live
from ...ir.graph import Graph
from ...ir.rewrite import rebuild
from ...records import dataclass
from ...topology.system import System

# the block of symbols that stand in a reference motion and are not parameters
NOMINAL = "nominal"
SNAP = 1e-15


@dataclass(frozen=True)
class Placeholder:
    """A quantity of the reference that is known in numbers only, with one of them."""

    name: str
    value: float


def entries(values_by_name: Mapping[str, Any], names: Sequence[str], what: str) -> dict[int, Any]:
    """Entry of a block -> its value; several entries by the name of their joint.

    Raises:
        DerivationError: unknown names, texts, or another number of values.
    """
    values_by_entry: dict[int, Any] = {}
    for name, value in values_by_name.items():
        places = places_of(name, names)
        if not places:
            raise DerivationError(f"linearize: there is no {what} '{name}'.{near(name, names)}")
        if isinstance(value, str):
            raise DerivationError(
                f"linearize: '{name}' is {brief(value)}, a text; give a number or an expression of "
                "SymPy, such as sympy.Symbol('alpha')"
            )
        several = isinstance(value, Sequence) or getattr(value, "ndim", 0) > 0
        values = list(value) if several else [value]
        if len(values) != len(places):
            listed = ", ".join(names[k] for k in places)
            raise DerivationError(
                f"linearize: '{name}' has {len(places)} entries ({listed}), not {len(values)}"
            )
        values_by_entry.update(zip(places, values, strict=True))
    return values_by_entry


def check_rotations(system: System, names: Sequence[str], specified: Mapping[int, Any]) -> None:
    """Unit quaternions are named whole, and numbers among them have length 1.

    Args:
        system: With the joints.
        names: Of the coordinates.
        specified: Entry of q -> its value.

    Raises:
        DerivationError: single components, or another length.
    """
    for joint in system.joints:
        first = joint.element.quaternion
        quaternion = range(joint.q + first, joint.q + first + 4) if first is not None else range(0)
        named = [k for k in quaternion if joint.q >= 0 and k in specified]
        if 0 < len(named) < 4:
            raise DerivationError(
                f"linearize: '{names[named[0]]}' is one component of the unit quaternion of "
                f"'{joint.name}', which one component does not determine. Give all of "
                f"'{joint.name}', or none of it"
            )
        values = [specified[k] for k in named]
        if named and all(isinstance(x, (int, float)) for x in values):
            length = math.hypot(*values)
            if abs(length - 1) > UNIT:
                raise DerivationError(
                    f"linearize: the quaternion of '{joint.name}' has length {length:.9g}: a "
                    "rotation has length 1"
                )


def places_of(name: str, names: Sequence[str]) -> list[int]:
    """Entries that a name stands for: ``elbow``, ``ball.x`` or all of ``ball``; also of speeds."""
    joint, dot, part = name.rpartition(".")
    for exact in (name, f"{name}.u", f"{joint}.u.{part}" if dot else name):
        if exact in names:
            return [names.index(exact)]
    for head in (f"{name}.u.", f"{name}."):
        many = [k for k, entry in enumerate(names) if entry.startswith(head)]
        if many:
            return many
    return []


def specified_speeds(
    names: Sequence[str], q: Mapping[str, object], u: Mapping[str, object]
) -> list[int]:
    """Places among the names of speeds of those that have a value, or whose coordinate has."""
    named_values = [
        name for name, value in {**q, **u}.items() if not isinstance(value, Placeholder)
    ]
    return sorted({k for name in named_values for k in places_of(name, names)})


class Symbols:
    """Symbols that may stand in a reference motion, as nodes of a graph.

    Args:
        graph: Where the nodes are.
        known: Symbol by name -> its node, such as those of the parameters.
        values: Numbers for symbols of the reference, by name.
    """

    def __init__(self, graph: Graph, nodes: Mapping[str, int], values: Mapping[str, float]) -> None:
        self.graph = graph
        self.nodes = dict(nodes)
        self.values: dict[str, float | None] = {}
        self._default_values = dict(values)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the block ``nominal``."""
        return tuple(self.values)

    def add(self, name: str, value: float | None = None) -> int:
        """The node of a symbol of the reference."""
        if name not in self.values:
            self.values[name] = self._default_values.pop(name, value)
        return self.graph.var(NOMINAL, self.names.index(name))

    def node(self, value: object) -> int:
        """A number or a SymPy expression as a node."""
        if isinstance(value, (int, float)):
            return self.graph.const(value)
        if isinstance(value, Placeholder):
            return self.add(value.name, value.value)
        import sympy

        from ...ir.forms.sympy_bridge import from_sympy

        expression = sympy.sympify(value, strict=True)
        used = sorted(expression.free_symbols, key=lambda s: s.name)
        symbols = {
            s: self.nodes[s.name] if s.name in self.nodes else self.add(s.name) for s in used
        }
        return from_sympy(self.graph, expression, symbols)

    def unused(self) -> list[str]:
        """Names in ``values`` that stand nowhere."""
        return list(self._default_values)


def substituted(graph: Graph, nodes: Sequence[int], values: Mapping[int, int]) -> list[int]:
    """Nodes at given leaves; sines and cosines of multiples of a right angle are exact."""
    return rebuild(graph, nodes, _rule(graph, values), into=graph)[1]


def _rule(
    graph: Graph, values: Mapping[int, int]
) -> Callable[[Graph, int, Mapping[int, int]], int | None]:
    nodes = graph.nodes

    def rule(target: Graph, i: int, copies: Mapping[int, int]) -> int | None:
        if i in values:
            return values[i]
        if nodes[i][0] in ("sin", "cos"):
            angle = target.value(copies[nodes[i][1]])
            if angle is not None:
                value = getattr(math, nodes[i][0])(angle)
                if abs(value - round(value)) <= SNAP * max(1.0, abs(angle)):
                    return target.const(float(round(value)))
        return None

    return rule


def depends(graph: Graph, nodes: Sequence[int], leaf: int) -> bool:
    """True when expressions contain a leaf."""
    return leaf in set(live(graph, nodes))
