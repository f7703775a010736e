"""The numbers that kernels of trees read, of all bodies: loops where many are alike."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ...ir.function import Block, Function, Output
from ...ir.graph import ZERO
from ...ir.recursion import Recursion
from ...records import dataclass
from ...topology.system import System
from ..kinematics.kinematics import Kinematics
from ..recursion.angle_sweep import angles_first
from ..recursion.recursion_boundary import Cuts
from ..recursion.representatives import Representatives
from ..recursion.steps import recursion
from ..recursion.sweeps import LEFT_OUT, Sweeps
from .body_numbers import body_names
from .tree_table import TreeTable


@dataclass(frozen=True)
class Names:
    """Names of a function and of what it reads.

    Attributes:
        symbol: C name.
        about: One line for the reader.
        inputs: All input blocks, in ABI order.
        entries: Of every block.
        owners: Joints, bodies and forces, in order.
    """

    symbol: str
    about: str
    inputs: tuple[Block, ...]
    entries: dict[str, tuple[str, ...]]
    owners: tuple[str, ...]


# numbers of a body of a system
Numbers = Callable[[int], list[int]]


def numbers_of_bodies(
    system: System,
    names: Names,
    table: TreeTable,
    numbers: Callable[[Kinematics, Cuts | None, Sequence[int]], Numbers],
    labels_of: tuple[Sequence[str], Sequence[str]],
    loops: bool | None,
    alike: Representatives | None,
) -> Function | Recursion:
    """Numbers of all bodies, as loops where many of them are alike."""
    if loops is not False:
        for few in (alike, None) if alike is not None else (None,):
            k = Kinematics(few.system if few else system)
            cuts = Cuts(k.graph, every=True)
            numbering = few.numbers if few else range(len(system.bodies))
            function = _function(k, names, table, numbers(k, cuts, numbering), labels_of, numbering)
            homes = _homes(table, numbering)
            firsts = [np.array(table.start[:-1])]
            looped = recursion(Sweeps(cuts, function, homes, k.system, few), firsts)
            if looped is not None:
                if loops or _pays(looped):
                    return angles_first(looped)
                break
    k = Kinematics(system)
    every = range(len(system.bodies))
    return _function(k, names, table, numbers(k, None, every), labels_of, every)


def _pays(looped: Recursion) -> bool:
    """True when bodies are alike enough: a third of them saves what calls of steps cost."""
    visits = sum(len(sweep) for sweep in looped.sweeps)
    return 3 * len(looped.steps) <= 2 * visits


def _function(
    k: Kinematics,
    names: Names,
    table: TreeTable,
    numbers: Numbers,
    labels_of: tuple[Sequence[str], Sequence[str]],
    numbering: Sequence[int],
) -> Function:
    """Numbers of the bodies of a system, at the places of those of the complete system."""
    nodes, entries = [ZERO] * table.start[-1], [""] * table.start[-1]
    for i in range(len(k.system.bodies)):
        number = numbering[i]
        start, end = table.start[number], table.start[number + 1]
        nodes[start:end] = numbers(i)
        assert len(nodes) == table.start[-1]
        joint = k.system.joints[i]
        parts = [c.name for c in joint.element.speeds] if joint.u >= 0 else []
        labels = body_names(k.owner(i), joint.name, parts, *labels_of)
        labels += [f"{joint.name}.number {n}" for n in range(end - start - len(labels))]
        entries[start:end] = labels
    output = Output("numbers", (len(nodes),), tuple(nodes), tuple(entries))
    return Function(names.symbol, k.graph, names.inputs, (output,), names.owners, names.about)


def _homes(table: TreeTable, numbering: Sequence[int]) -> list[int]:
    """Body at whose visit each number is computed."""
    homes = [LEFT_OUT] * table.start[-1]
    for i, number in enumerate(numbering):
        start, end = table.start[number], table.start[number + 1]
        homes[start:end] = [i] * (end - start)
    return homes
