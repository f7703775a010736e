"""Recursions of rigid-body dynamics written in CasADi, for trees of other programs' joints.

Body axes, angular part first, zeros of axes and placements left out as CasADi builds expressions.

Source: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, tables 5.1, 6.2, 7.1.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from ..api.comparison import SIZES, Scene
from ..records import dataclass
from .tree import directions


@dataclass(frozen=True)
class Tree:
    """A tree in symbols.

    Attributes:
        parents: By body.
        x: Transform of motion from parent to body (6, 6).
        s: Motion subspace (6, n).
        inertia: Spatial inertia (6, 6).
        slots: Entries of u.
        lift: Acceleration of the ground that stands for gravity (6).
    """

    parents: tuple[int, ...]
    x: list[ca.SX]
    s: list[ca.SX]
    inertia: list[ca.SX]
    slots: list[slice]
    lift: ca.SX


def exact(numbers: object) -> ca.SX:
    """A constant whose zeros, ones and signs are seen."""
    array = np.array(numbers, dtype=float)
    array[abs(array) < 1e-12] = 0.0
    return ca.sparsify(ca.DM(array))


def tree(scene: Scene, q: ca.SX) -> Tree:
    """The tree at coordinates q, joint after joint."""
    n, x, s, slots, inertia = scene.numbers, [], [], [], []
    axes = directions(scene)
    start = first = 0
    for i, kind in enumerate(scene.kinds):
        nq, nu = SIZES[kind]
        coordinates = q[start : start + nq]
        turn, shift, subspace = joint(kind, axes[i], coordinates)
        rotation = exact(n["rotation"][i])
        r = ca.mtimes(rotation, turn).T
        place = exact(n["position"][i]) + ca.mtimes(rotation, shift)
        low = ca.mtimes(-r, ca.skew(ca.densify(place)))
        x.append(ca.sparsify(ca.vertcat(ca.horzcat(r, ca.SX(3, 3)), ca.horzcat(low, r))))
        s.append(exact(subspace))
        slots.append(slice(first, first + nu))
        h = ca.skew(ca.DM(n["first_moment"][i]))
        mass = float(n["mass"][i]) * np.eye(3)
        inertia.append(
            ca.SX(exact(np.block([[n["inertia"][i], np.array(h)], [-np.array(h), mass]])))
        )
        start, first = start + nq, first + nu
    lift = exact(np.concatenate([np.zeros(3), -n["gravity"]]))
    return Tree(scene.parents, x, s, inertia, slots, lift)


def joint(kind: str, axis: ca.SX, q: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Rotation (3, 3) of a joint, displacement (3), and motion subspace in body axes (6, n)."""
    if kind in ("spherical", "free"):
        w, v = q[0], q[1:4]
        turn = (2 * w * w - 1) * ca.DM.eye(3) + 2 * ca.mtimes(v, v.T) + 2 * w * ca.skew(v)
        shift = q[4:7] if kind == "free" else ca.DM(3, 1)
        return turn, shift, np.eye(6)[:, : 6 if kind == "free" else 3]
    none = np.zeros(3)
    if kind == "prismatic":
        return ca.DM.eye(3), exact(axis) * q[0], np.concatenate([none, axis])[:, None]
    k = exact(np.array(ca.skew(ca.DM(axis))))
    turn = ca.DM.eye(3) + ca.sin(q[0]) * k + (1 - ca.cos(q[0])) * ca.sparsify(ca.mtimes(k, k))
    return turn, ca.DM(3, 1), np.concatenate([axis, none])[:, None]


def across(v: ca.SX) -> ca.SX:
    """Operator v x on motion vectors; its negative transpose acts on forces."""
    omega = ca.skew(v[:3])
    return ca.vertcat(ca.horzcat(omega, ca.SX(3, 3)), ca.horzcat(ca.skew(v[3:]), omega))


def velocities(t: Tree, u: ca.SX) -> tuple[list[ca.SX], list[ca.SX]]:
    """Velocity of every body, and what it adds to its acceleration."""
    v: list[ca.SX] = []
    c: list[ca.SX] = []
    for i, parent in enumerate(t.parents):
        relative = ca.mtimes(t.s[i], u[t.slots[i]])
        v.append(ca.mtimes(t.x[i], v[parent]) + relative if parent >= 0 else ca.SX(relative))
        c.append(ca.mtimes(across(v[i]), relative))
    return v, c


def articulated(t: Tree, u: ca.SX, tau: ca.SX) -> ca.SX:
    """udot by the articulated-body algorithm."""
    v, c = velocities(t, u)
    inertia = list(t.inertia)
    bias = [-ca.mtimes(across(a).T, ca.mtimes(i, a)) for a, i in zip(v, inertia, strict=True)]
    count = len(t.parents)
    reach: list[ca.SX] = [None] * count
    push: list[ca.SX] = [None] * count
    solved: list[ca.SX] = [None] * count
    # inwards
    for i in range(count - 1, -1, -1):
        reach[i] = ca.mtimes(inertia[i], t.s[i])
        d = ca.mtimes(t.s[i].T, reach[i])
        push[i] = tau[t.slots[i]] - ca.mtimes(t.s[i].T, bias[i])
        solved[i] = factorized(d)
        parent = t.parents[i]
        if parent >= 0:
            left = half(inertia[i] - ca.mtimes(reach[i], solved[i](reach[i].T)))
            pull = bias[i] + ca.mtimes(left, c[i]) + ca.mtimes(reach[i], solved[i](push[i]))
            inertia[parent] += half(ca.mtimes(t.x[i].T, ca.mtimes(left, t.x[i])))
            bias[parent] += ca.mtimes(t.x[i].T, pull)
    # outwards
    a: list[ca.SX] = []
    udot: list[ca.SX] = []
    for i, parent in enumerate(t.parents):
        propagated = ca.mtimes(t.x[i], a[parent] if parent >= 0 else t.lift) + c[i]
        udot.append(solved[i](push[i] - ca.mtimes(reach[i].T, propagated)))
        a.append(propagated + ca.mtimes(t.s[i], udot[i]))
    return ca.vertcat(*udot)


def half(matrix: object) -> ca.SX:
    """A symmetric matrix of which only the upper half is computed."""
    return ca.triu2symm(ca.triu(matrix))


def factorized(d: ca.SX) -> ca.SX:
    """A small symmetric system as its L D L^T, ready to solve for columns."""
    n = d.shape[0]
    low = ca.SX.eye(n)
    pivots: list[ca.SX] = []
    for j in range(n):
        pivots.append(d[j, j] - sum(low[j, k] ** 2 * pivots[k] for k in range(j)))
        for i in range(j + 1, n):
            remaining = sum(low[i, k] * low[j, k] * pivots[k] for k in range(j))
            low[i, j] = (d[i, j] - remaining) / pivots[j]

    def solve(b: ca.SX) -> ca.SX:
        rows = [b[i, :] for i in range(n)]
        for i in range(n):
            for k in range(i):
                rows[i] = rows[i] - low[i, k] * rows[k]
        rows = [row / pivot for row, pivot in zip(rows, pivots, strict=True)]
        for i in range(n - 1, -1, -1):
            for k in range(i + 1, n):
                rows[i] = rows[i] - low[k, i] * rows[k]
        return ca.vertcat(*rows)

    return solve


def newton_euler(t: Tree, u: ca.SX, udot: ca.SX) -> ca.SX:
    """tau by the recursion of Newton and Euler."""
    v, c = velocities(t, u)
    a: list[ca.SX] = []
    f: list[ca.SX] = []
    for i, parent in enumerate(t.parents):
        propagated = ca.mtimes(t.x[i], a[parent] if parent >= 0 else t.lift) + c[i]
        a.append(propagated + ca.mtimes(t.s[i], udot[t.slots[i]]))
        momentum = ca.mtimes(t.inertia[i], v[i])
        f.append(ca.mtimes(t.inertia[i], a[i]) - ca.mtimes(across(v[i]).T, momentum))
    tau: list[ca.SX] = [None] * len(t.parents)
    for i in range(len(t.parents) - 1, -1, -1):
        tau[i] = ca.mtimes(t.s[i].T, f[i])
        if t.parents[i] >= 0:
            f[t.parents[i]] += ca.mtimes(t.x[i].T, f[i])
    return ca.vertcat(*tau)


def composite(t: Tree) -> ca.SX:
    """M by composite bodies."""
    inertia = list(t.inertia)
    size = t.slots[-1].stop
    m = ca.SX(size, size)
    for i in range(len(t.parents) - 1, -1, -1):
        f, k = ca.mtimes(inertia[i], t.s[i]), i
        m[t.slots[i], t.slots[i]] = ca.mtimes(t.s[i].T, f)
        while t.parents[k] >= 0:
            f, k = ca.mtimes(t.x[k].T, f), t.parents[k]
            m[t.slots[i], t.slots[k]] = ca.mtimes(f.T, t.s[k])
            m[t.slots[k], t.slots[i]] = m[t.slots[i], t.slots[k]].T
        if t.parents[i] >= 0:
            inertia[t.parents[i]] += half(ca.mtimes(t.x[i].T, ca.mtimes(inertia[i], t.x[i])))
    return m
