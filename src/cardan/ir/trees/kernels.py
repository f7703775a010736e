"""Kernels that assemble results from numbers of the bodies of a tree, told as expressions.

Each is what ``kernels/trees`` computes: there with loops over a table, vectors over the ancestors
of a body and a factorization in place; here entry by entry.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ...records import dataclass
from ..graph import Graph
from .slopes import column_at, derivative_expressions, mass_by_slots, outboard_sums, speed_places
from .table import (
    CAUSE,
    CHUNK,
    GAINS,
    MASS_BODY,
    MASS_SPEED,
    MASS_STRIDE,
    MATRIX,
    PANEL,
    PATHS,
    SIDE_STRIDE,
    WRENCH,
    Tree,
)


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
        len(tree.branching),
        int(tree.forward),
        tree.columns,
        len(tree.outputs),
        len(tree.changes),
        len(tree.rotors),
    )


def _derivative_work(tree: Tree) -> int:
    n, bodies = len(tree.speeds), len(tree.bodies)
    size = 2 * CHUNK * bodies + (CHUNK + 1) * n
    if tree.forward:
        waiting = 15 * PANEL * len(tree.branching)
        return size + MATRIX * bodies + (GAINS + CAUSE) * n + waiting + n * PANEL
    panels = -(-tree.width // PANEL)
    return size + SIDE_STRIDE * bodies + (PATHS + 4) * tree.depth + tree.rows + panels * n * PANEL


def _derivative_counts(tree: Tree) -> dict[str, int]:
    """As the kernel does them; what chunks and panels compute besides is not counted."""
    return _forward_counts(tree) if tree.forward else _inverse_counts(tree)


def _inverse_counts(tree: Tree) -> dict[str, int]:
    n, pairs, bodies = len(tree.speeds), tree.pairs, len(tree.bodies)
    block_pairs = sum(body.speeds**2 for body in tree.bodies)
    modes = sum(body.speeds**2 for body in tree.bodies if body.modes >= 0)
    outboard = pairs - sum(body.speeds * (body.speeds - 1) // 2 for body in tree.bodies)
    inner = _inner(tree)
    # sums, accelerations
    mul = 24 * n + 24 * bodies + 6 * modes
    add = WRENCH * inner + 24 * n + 24 * bodies + 6 * inner + 6 * modes
    if any(row.of_mass for row in tree.outputs):
        mul += 24 * n + 6 * (pairs + n)
        add += 18 * n + 5 * (pairs + n) + len(tree.rotors)
    # entries
    mul += 135 * n + 12 * block_pairs + 6 * modes + 30 * outboard
    add += 123 * n + 10 * block_pairs + 6 * modes + 26 * outboard + len(tree.changes)
    return {"mul": mul, "add": add}


def _forward_counts(tree: Tree) -> dict[str, int]:
    n, bodies, inner = len(tree.speeds), len(tree.bodies), _inner(tree)
    modes = sum(body.speeds**2 for body in tree.bodies if body.modes >= 0)
    joined = sum(body.speeds * (body.speeds - 1) // 2 for body in tree.bodies)
    handed = sum(body.speeds for body in tree.bodies if body.parent >= 0)
    # articulated bodies: A, gains, blocks of joints, what is left for the parent
    mul = 54 * n + 6 * (n + joined) + 24 * joined + 9 * n + 54 * handed
    add = 45 * n + 6 * (n + joined) + 23 * joined + 54 * handed + 54 * inner + 4 * bodies
    # udot, motion, causes
    mul += 13 * n + 6 * n + 2 * joined + 24 * n + 24 * bodies + 6 * modes + 126 * n
    add += 14 * n + 6 * n + 2 * joined + 24 * n + 24 * bodies + 12 * inner + 6 * modes + 114 * n
    # columns: inward along the paths, outward over all bodies
    on_paths = tree.pairs + n + joined
    for row in tree.outputs:
        along = row.of_mass or row.first < 2 * len(tree.speeds)
        inward = on_paths if along else row.columns * n
        mul += 13 * inward + 15 * n * row.columns + 2 * joined * row.columns
        add += 12 * inward + 15 * n * row.columns + 2 * joined * row.columns
        add += 21 * n if along and not row.of_mass else 0
    add += len(tree.changes) + len(tree.rotors)
    return {"mul": mul, "add": add, "div": n}


KERNELS = {
    "tree_mass": Kernel(
        ("tree.h", "tree_mass.h"), _mass_sizes, _mass_work, _mass_counts, _mass_expressions
    ),
    "tree_derivatives": Kernel(
        (
            "tree.h",
            "tree_mass.h",
            "tree_slopes.h",
            "tree_articulated.h",
            "tree_panels.h",
            "tree_sides.h",
            "tree_derivatives.h",
        ),
        _derivative_sizes,
        _derivative_work,
        _derivative_counts,
        derivative_expressions,
    ),
}
