"""Kernels that assemble results from numbers of the bodies of a tree, told as expressions.

Each is what ``kernels/trees`` computes: there with loops over a table, vectors over the ancestors
of a body and a factorization in place; here entry by entry.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...records import dataclass
from ..graph import Graph
from .slopes import column_at, derivative_expressions, mass_by_slots, outboard_sums, speed_places
from .table import BODY, MASS_BODY, MASS_SPEED, MASS_STRIDE, PANEL, PATHS, STRIDE, Tree


@dataclass(frozen=True)
class Kernel:
    """A kernel of ``kernels/trees``.

    Attributes:
        headers: Where it stands, those that it includes first.
        sizes: Its first arguments.
        work: Numbers of scratch.
        counts: Operations per call.
        expressions: What it computes, from a graph and the numbers of the bodies.
    """

    headers: tuple[str, ...]
    sizes: Callable[[Tree], tuple[int, ...]]
    work: Callable[[Tree], int]
    counts: Callable[[Tree], dict[str, int]]
    expressions: Callable[[Graph, Sequence[int], Tree], list[int]]


# the mass matrix


def _mass_expressions(g: Graph, numbers: Sequence[int], tree: Tree) -> list[int]:
    columns = [column_at(g, numbers, at) for at in speed_places(tree, MASS_BODY, MASS_SPEED)]
    sums = outboard_sums(tree, g, numbers, MASS_BODY)
    return list(mass_by_slots(g, tree, numbers, sums, columns).nodes)


def _serial(tree: Tree) -> int:
    """1 where every speed has its own number as slot and lies inboard of the next."""
    return int(all(speed.slot == speed.level == k for k, speed in enumerate(tree.speeds)))


def _inner(tree: Tree) -> int:
    """Number of bodies that hand something to a parent."""
    return sum(body.parent >= 0 for body in tree.bodies)


def _mass_counts(tree: Tree) -> dict[str, int]:
    n, entries = len(tree.speeds), tree.pairs + len(tree.speeds)
    add = MASS_BODY * _inner(tree) + 18 * n + 5 * entries + len(tree.rotors)
    return {"mul": 24 * n + 6 * entries, "add": add}


def _mass_sizes(tree: Tree) -> tuple[int, ...]:
    return len(tree.bodies), len(tree.speeds), tree.depth, _serial(tree), len(tree.rotors)


def _mass_work(tree: Tree) -> int:
    return MASS_STRIDE * len(tree.bodies) + 6 * tree.depth + tree.rows


# derivatives


def _derivative_sizes(tree: Tree) -> tuple[int, ...]:
    return (
        len(tree.bodies),
        len(tree.speeds),
        tree.depth,
        tree.rows,
        _serial(tree),
        int(tree.forward),
        tree.columns,
        len(tree.outputs),
        len(tree.changes),
        len(tree.rotors),
    )


def _derivative_work(tree: Tree) -> int:
    n, bodies = len(tree.speeds), len(tree.bodies)
    panels = -(-tree.width // PANEL)
    return (
        (STRIDE + 12) * bodies
        + (PATHS + 4) * tree.depth
        + tree.rows
        + 7 * n
        + (panels + 1) * n * PANEL
    )


def _derivative_counts(tree: Tree) -> dict[str, int]:
    """As the kernel does them; entries of chunks behind the end of a path are not counted."""
    n, pairs, bodies = len(tree.speeds), tree.pairs, len(tree.bodies)
    block_pairs = sum(body.speeds**2 for body in tree.bodies)
    modes = sum(body.speeds**2 for body in tree.bodies if body.modes >= 0)
    outboard = pairs - sum(body.speeds * (body.speeds - 1) // 2 for body in tree.bodies)
    inner = _inner(tree)
    # sums, rows of M, accelerations
    mul = 24 * n + 6 * (pairs + n) + 24 * n + 24 * bodies + 6 * modes
    add = BODY * inner + 18 * n + 5 * (pairs + n) + 24 * n + 24 * bodies + 6 * inner + 6 * modes
    # right sides
    mul += 135 * n + 12 * block_pairs + 6 * modes + 30 * outboard
    add += 123 * n + 10 * block_pairs + 6 * modes + 26 * outboard
    add += len(tree.changes) + len(tree.rotors)
    if not tree.forward:
        return {"mul": mul, "add": add}
    # drive, factors, one solution, all columns, half of the inverse
    triples = sum(s.level * (s.level + 1) // 2 for s in tree.speeds)
    wide = 2 * n + tree.columns + (n // 2 if any(row.of_mass for row in tree.outputs) else 0)
    mul += 6 * n + triples + pairs + (2 * pairs + n) * (wide + 1)
    add += 7 * n + triples + 2 * pairs * (wide + 1)
    return {"mul": mul, "add": add, "div": n}


KERNELS = {
    "tree_mass": Kernel(
        ("tree.h", "tree_mass.h"), _mass_sizes, _mass_work, _mass_counts, _mass_expressions
    ),
    "tree_derivatives": Kernel(
        ("tree.h", "tree_mass.h", "tree_solve.h", "tree_slopes.h", "tree_derivatives.h"),
        _derivative_sizes,
        _derivative_work,
        _derivative_counts,
        derivative_expressions,
    ),
}
