"""Matrices of made-up structures: nodes, elements between them, joints with multipliers."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from cardan.runtime.sparse.plan import Plan, plan

GROUND = -1
JOINT_ROWS = 6


@dataclass(frozen=True)
class Structure:
    """What couples what.

    Attributes:
        nodes: How many, of 6 unknowns each.
        beams: Pairs of nodes.
        joints: Node, node or ground, degrees of freedom.
        again: How many of the joints stand there twice.
        mass: What nodes have on their diagonal, at least.
        spring: What joints have on theirs.
        skew: How far from symmetric.
    """

    nodes: int
    beams: list[tuple[int, int]] = field(default_factory=list)
    joints: list[tuple[int, int, int]] = field(default_factory=list)
    again: int = 0
    mass: float = 1.0
    spring: float = 0.0
    skew: float = 0.0

    def plan(self) -> Plan:
        """Blocks: nodes, coordinates of joints, multipliers of joints, those of doubled joints."""
        n, nj = self.nodes, len(self.joints)
        free = [dof for *_, dof in self.joints]
        sizes = [6] * n + free + [JOINT_ROWS] * (nj + self.again)
        multiplier = [False] * (n + nj) + [True] * (nj + self.again)
        massless = [False] * n + [True] * nj + [False] * (nj + self.again)
        cliques = [np.array(self.beams).reshape(-1, 2)]
        for k in range(nj + self.again):
            cliques.append(np.array([[*self.held(k), n + nj + k]]))
        return plan(sizes, cliques, multiplier, massless)

    def held(self, k: int) -> list[int]:
        """The blocks of speeds that joint k couples."""
        a, b, _ = self.joints[k % len(self.joints)]
        return [x for x in (a, b) if x != GROUND] + [self.nodes + k % len(self.joints)]

    def matrix(self, made: Plan, seed: int = 0) -> NDArray[np.float64]:
        """A dense matrix of this structure, every joint a rotation of the coordinates it holds."""
        rng = np.random.default_rng(seed)
        first = made.pattern.first
        a = np.zeros((made.pattern.n,) * 2)
        part = [slice(first[i], first[i + 1]) for i in range(len(first) - 1)]

        def add(blocks: list[int], own: NDArray[np.float64]) -> None:
            at = np.concatenate([np.arange(part[b].start, part[b].stop) for b in blocks])
            a[np.ix_(at, at)] += own + self.skew * rng.standard_normal(own.shape)

        for i in range(self.nodes if self.mass else 0):
            add([i], definite(rng, 6) + self.mass * np.eye(6))
        for pair in self.beams:
            add(list(pair), definite(rng, 12))
        nj = len(self.joints)
        rows: list[list[NDArray[np.float64]]] = []
        for k in range(nj + self.again):
            held = self.held(k)
            if k < nj:
                own = [orthogonal(rng)[:, : made.pattern.sizes[block]] for block in held]
                a[part[held[-1]], part[held[-1]]] += self.spring * np.eye(self.joints[k][2])
                rows.append(own)
            else:
                turned = rng.standard_normal((JOINT_ROWS, JOINT_ROWS))
                own = [turned @ one for one in rows[k - nj]]
            for block, g in zip(held, own, strict=True):
                lam = part[self.nodes + nj + k]
                a[lam, part[block]] = g
                a[part[block], lam] = g.T
        return a


def definite(rng: np.random.Generator, n: int) -> NDArray[np.float64]:
    """A symmetric matrix without negative eigenvalues."""
    half = rng.standard_normal((n, n))
    return np.asarray(half @ half.T)


def orthogonal(rng: np.random.Generator) -> NDArray[np.float64]:
    """A rotation in six dimensions."""
    return np.asarray(np.linalg.qr(rng.standard_normal((6, 6)))[0])


def values(made: Plan, a: NDArray[np.float64]) -> NDArray[np.float64]:
    """The numbers of a dense matrix in the order of a pattern, which must hold all of it."""
    columns, starts = made.pattern.csr
    rows = np.repeat(np.arange(made.pattern.n), np.diff(starts))
    found = a[rows, columns]
    back = np.zeros_like(a)
    back[rows, columns] = found
    assert (back == a).all()
    return np.asarray(found)


def line(n: int) -> list[tuple[int, int]]:
    """Neighbours in a row of n nodes."""
    return [(i - 1, i) for i in range(1, n)]


def grid(m: int) -> list[tuple[int, int]]:
    """Neighbours in a square of m by m nodes."""
    across = [(m * i + j, m * i + j + 1) for i in range(m) for j in range(m - 1)]
    return across + [(m * i + j, m * i + j + m) for i in range(m - 1) for j in range(m)]


def bars(n: int, dof: int = 1) -> list[tuple[int, int, int]]:
    """A row of n bodies on the ground."""
    return [(0, GROUND, dof), *((i - 1, i, dof) for i in range(1, n))]


def around(n: int) -> list[tuple[int, int, int]]:
    """A ring of n bodies."""
    return [(i, (i + 1) % n, 1) for i in range(n)]


SPREAD = [(int(i // 2), i) for i in range(1, 40)]
STRUCTURES = {
    "one node": Structure(1),
    "beam": Structure(20, line(20), [(0, GROUND, 1)], mass=0),
    "branches": Structure(40, SPREAD),
    "ring of beams": Structure(12, [*line(12), (11, 0)]),
    "grid of beams": Structure(49, grid(7)),
    "bodies in a row": Structure(20, [], bars(20)),
    "bodies in a tree": Structure(30, [], [(0, GROUND, 2), *((i, j, 1) for i, j in SPREAD[:29])]),
    "ring of bodies": Structure(20, [], [*bars(20), (19, 0, 1)]),
    "arch of bodies": Structure(20, [], [*bars(20, 2), (19, GROUND, 2)]),
    "springs alone": Structure(20, [], bars(20), mass=0, spring=1),
    "arch on springs": Structure(8, [], [*bars(8, 3), (7, GROUND, 3)], mass=0, spring=1),
    "ring held by its shape": Structure(6, [], [(0, GROUND, 0), *around(6)], mass=0),
    "hub": Structure(30, line(29), [(29, i, 1) for i in range(29)] + [(29, GROUND, 1)], mass=0),
    "loops": Structure(12, [], [*around(12), (0, 6, 2), (3, 9, 4)]),
    "frame with joints": Structure(20, line(20), [(0, GROUND, 1), (5, 12, 2)], mass=0),
}
