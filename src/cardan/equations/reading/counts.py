"""Operation counts of functions, by owner."""

from __future__ import annotations

from math import hypot
from typing import TYPE_CHECKING

from ...errors import counted
from ...ir.function import Function, count
from ...ir.routine import Routine
from .chain_pattern import chain_pattern
from .loop_report import loop_lines
from .typesetting import text_of

if TYPE_CHECKING:
    from ..record import EquationRecord


# cycles per operation where nothing waits, and per unit of the critical path
SIDE_BY_SIDE, IN_TURN = 0.35, 2.3


class Counts(dict[str, int]):
    """Operator -> number of operations of a function at every call.

    Attributes:
        blocks: Body, joint or force element -> the same for its part; what several of them use
            is under "shared", what nobody owns under "".
        prepared: Number of operations that parameters alone determine, done once for them.
        critical_path: Cost of the longest chain of dependent operations, an addition being 1; 0
            where a routine of the kernels computes it.
        rewrites: Rewrites of the system graph it was derived from.
    """

    def __init__(self, function: Function, rewrites: tuple[str, ...] = ()) -> None:
        self.rewrites = rewrites
        if isinstance(function, Routine):
            # the kernels compute it, and say what that costs
            super().__init__(function.counts)
            self.blocks = {owner: dict(function.counts) for owner in function.owners}
            self.prepared, self.critical_path = 0, 0.0
            return
        # the program and the sections of the C that is written from it
        from ...ir.owners import Owners
        from ...passes import optimize

        self.rewrites = rewrites
        if isinstance(function, Routine):
            # of the kernels, whose loops are no graph: they say how many operations they take
            super().__init__(function.counts)
            self.blocks = {function.owners[0]: dict(function.counts)} if function.owners else {}
            self.prepared, self.critical_path = 0, 0.0
            return
        staged = optimize(function)
        super().__init__(staged.operations())
        graph, owners = staged.function.graph, Owners(staged.function.graph, function.owners)
        nodes: dict[str, list[int]] = {}
        for i in staged.body():
            nodes.setdefault(owners.of(i).section, []).append(i)
        counted = {name: count(graph, some) for name, some in nodes.items()}
        order = (*function.owners, *counted)
        self.blocks = {name: counted[name] for name in dict.fromkeys(order) if counted.get(name)}
        self.prepared = sum(staged.prepare_operations().values())
        self.critical_path = staged.critical_path()

    @property
    def total(self) -> int:
        """Number of all operations."""
        return sum(self.values())

    @property
    def cycles(self) -> float:
        """Predicted cycles of a call: operations side by side, and one after the other.

        Measured on arms, legged robots and chains, gcc -O2, to a fifth.
        """
        return hypot(SIDE_BY_SIDE * self.total, IN_TURN * self.critical_path)


# letters of a line
WIDTH = 100


def overview(equations: EquationRecord) -> str:
    """Formalism, sizes, names and counts on one screen."""
    s = equations.system
    lines = [
        f"equations of '{s.name}' by {equations.method}"
        + (f" ({equations.reason})" if equations.reason else ""),
        f"  {counted(sum(len(b.parts) for b in s.bodies), 'body', 'bodies')}, "
        f"{counted(s.nq, 'coordinate')}, {counted(s.nu, 'speed')}, "
        f"{counted(len(s.parameters), 'parameter')}, {counted(len(s.inputs), 'input')}",
        "  q: " + _row(equations.coordinates),
        "  u: " + _row(equations.speeds),
        *loop_lines(equations),
        f"  {'':18}  mul   add   div  trig  all",
    ]
    for name, counts in equations.operations.items():
        trig = counts.get("sin", 0) + counts.get("cos", 0)
        add = counts.get("add", 0) + counts.get("sub", 0)
        row = (counts.get("mul", 0), add, counts.get("div", 0), trig, counts.total)
        lines.append(f"  {name:18}" + "".join(f"{n:6d}" for n in row))
    for name, (now, before) in equations.gain.items():
        lines.append(f"  {name}: {before - now} operations less than with all parameters free")
    pattern = chain_pattern(s)
    if pattern:
        lines.append(f"  chain of n = {len(s.bodies)} equal links:")
        for about, line in pattern:
            text = f"    {text_of(line):44}  {about}"
            lines += [text] if len(text) <= WIDTH else [f"    {text_of(line)}", f"{'':50}{about}"]
    return "\n".join(lines)


def _row(names: tuple[str, ...]) -> str:
    listing = ", ".join(names[:10])
    return listing + (f", ... ({len(names)})" if len(names) > 10 else "")
