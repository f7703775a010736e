"""The table of a tree: bodies depth first, speeds level by level, places of their numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ...ir.graph import ZERO, Graph
from ...ir.trees.table import BodyRow, Entry, SpeedRow, Tree, chunks
from ...records import dataclass
from ...topology.system import System


class Widths(NamedTuple):
    """Numbers of a body, and of each of its speeds behind them."""

    body: int
    speed: int


@dataclass(frozen=True)
class TreeTable:
    """Rows of a tree for its kernels.

    Attributes:
        order: Bodies of the system, depth first.
        bodies, speeds: Rows in that order.
        speed_of_slot: Number of a speed in it.
        rotors: Entries of the inertia of rotors.
        changes: Body -> places of the numbers behind those of its rotors.
        start: Place of the first number of every body of the system, and the end of the last.
    """

    order: tuple[int, ...]
    bodies: tuple[BodyRow, ...]
    speeds: tuple[SpeedRow, ...]
    speed_of_slot: Mapping[int, int]
    rotors: tuple[Entry, ...]
    changes: Mapping[int, int]
    start: tuple[int, ...]


def depth_first(system: System) -> list[int]:
    """Bodies, each behind its parent and with all that it carries behind it."""
    children: list[list[int]] = [[] for _ in system.bodies]
    waiting: list[int] = []
    for i in range(len(system.bodies) - 1, -1, -1):
        parent = system.bodies[i].parent
        (children[parent] if parent >= 0 else waiting).append(i)
    order = []
    while waiting:
        body = waiting.pop()
        order.append(body)
        waiting += children[body]
    return order


def tree_table(
    system: System,
    widths: Widths,
    moving_modes: frozenset[int] = frozenset(),
    rotors: Mapping[int, int] = {},
    changes: Mapping[int, int] = {},
) -> TreeTable:
    """The table of a system.

    Args:
        system: The tree.
        widths: Of the numbers.
        moving_modes: Bodies whose columns of S are not fixed to them.
        rotors: Body -> speeds that rotors load.
        changes: Body -> count of further numbers.
    """
    # places in the order of the system, so that those of equal bodies differ by the same amount
    start, behind = [0], list[int]()
    for i in range(len(system.bodies)):
        count = speeds_of(system, i)
        at = start[-1] + widths.body + count * widths.speed
        behind.append(at)
        modes = 6 * count**2 if i in moving_modes else 0
        pairs = rotors.get(i, 0) * (rotors.get(i, 0) + 1) // 2
        start.append(at + modes + pairs + changes.get(i, 0))
    order = depth_first(system)
    number = {body: n for n, body in enumerate(order)}
    bodies, speeds, entries = list[BodyRow](), list[SpeedRow](), list[Entry]()
    last_speed, places, change_places = dict[int, int](), 0, dict[int, int]()
    for i in order:
        parent, count, first = system.bodies[i].parent, speeds_of(system, i), len(speeds)
        inboard = last_speed.get(parent, -1)
        for n in range(count):
            speeds.append(_speed(speeds, inboard, system.joints[i].u + n, places))
            inboard = len(speeds) - 1
            places += chunks(speeds[-1].level + 1)
        last_speed[i] = inboard
        at, modes = behind[i], -1
        if i in moving_modes:
            modes, at = at, at + 6 * count**2
        bodies.append(BodyRow(number.get(parent, -1), first, count, start[i], modes))
        for row in range(rotors.get(i, 0)):
            for column in range(row + 1):
                entries.append(Entry(first + row, first + column, at))
                at += 1
        change_places[i] = at
    slots = {speed.slot: n for n, speed in enumerate(speeds)}
    return TreeTable(
        tuple(order),
        tuple(bodies),
        tuple(speeds),
        slots,
        tuple(entries),
        change_places,
        tuple(start),
    )


def speeds_of(system: System, i: int) -> int:
    """Number of the speeds of a joint."""
    joint = system.joints[i]
    return len(joint.element.speeds) if joint.u >= 0 else 0


def inboard_pairs(system: System) -> int:
    """Number of pairs of a speed and one between it and the ground."""
    pairs, levels = 0, list[int]()
    for i, body in enumerate(system.bodies):
        level, count = levels[body.parent] if body.parent >= 0 else 0, speeds_of(system, i)
        pairs += count * level + count * (count - 1) // 2
        levels.append(level + count)
    return pairs


def _speed(speeds: Sequence[SpeedRow], inboard: int, slot: int, place: int) -> SpeedRow:
    """Row of the next speed: it goes on with the run of the one inboard of it, or begins one."""
    if inboard < 0:
        return SpeedRow(slot, 0, len(speeds), -1, place)
    level = speeds[inboard].level + 1
    if inboard == len(speeds) - 1:
        return SpeedRow(slot, level, speeds[inboard].run, speeds[inboard].before, place)
    return SpeedRow(slot, level, len(speeds), inboard, place)


def all_entries(count: int) -> tuple[int, ...]:
    """Nodes of entries any of which may be other than 0."""
    return (Graph().atom("assembled"),) * count


def entry_pattern(table: TreeTable, system: System, related: bool) -> tuple[int, ...]:
    """Nodes of a matrix over the speeds that say which entries may be other than 0.

    Args:
        related: Whether only entries of a speed and its ancestors are; else all of one tree.
    """
    some, n = Graph().atom("assembled"), system.nu
    nodes = [ZERO] * (n * n)
    tree = Tree(table.bodies, table.speeds)
    base = [list(tree.inboard(k))[-1] for k in range(n)]
    for k, speed in enumerate(table.speeds):
        blocks_at = tree.inboard(k) if related else (j for j in range(n) if base[j] == base[k])
        for j in blocks_at:
            slot = table.speeds[j].slot
            nodes[speed.slot * n + slot] = nodes[slot * n + speed.slot] = some
    return tuple(nodes)
