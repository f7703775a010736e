"""The absolute formulation in plain Python: dense sums over all members, solved by least squares.

The slow and simple road: every member's functions by the interpreter of expressions, their results
added where the tables say.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from cardan.equations.finite_elements.record import FiniteElementRecord, Group
from cardan.equations.functions.blocks import defaults
from cardan.ir.interpreter import evaluate

Array = np.ndarray
EPS = float(np.finfo(float).eps)


@dataclass
class Reference:
    """A scene in absolute coordinates at one state.

    Attributes:
        scene: Its equations.
        q, u: Coordinates and speeds of all places.
        t, r, z, s: Time, inputs, internal states and modes; by default 0 and the defaults.
    """

    scene: FiniteElementRecord
    q: Array
    u: Array
    t: float = 0.0
    r: Array | None = None
    z: Array | None = None
    s: Array | None = None

    @cached_property
    def p(self) -> Array:
        return np.array([parameter.value for parameter in self.scene.system.parameters])

    @property
    def m(self) -> int:
        return len(self.scene.multipliers)

    @property
    def inputs(self) -> Array:
        given = [entry.default for entry in self.scene.system.inputs]
        return np.array(given if self.r is None else self.r)

    @property
    def states(self) -> tuple[Array, Array]:
        """z and s."""
        start = defaults(self.scene.system)
        return (start["z"] if self.z is None else self.z, start["s"] if self.s is None else self.s)

    def data(self, group: Group) -> Array:
        """p of every member (n, k)."""
        n, found = len(group), []
        if group.common is not None:
            common = evaluate(group.common, {"p": self.p}, "numpy")["data"]
            found.append(np.broadcast_to(common, (n, common.shape[-1])))
        if group.attributes is not None:
            found.append(group.attributes)
        return np.concatenate(found, axis=1) if found else np.zeros((n, 0))

    def entries(self, group: Group, letter: str) -> Array:
        """Entries of q or u of the places of every member (n, nq or nu of the kind)."""
        starts = getattr(self.scene.places, letter)
        sizes = [getattr(block, f"n{letter}") for block in group.kind.blocks]
        parts = [
            starts[group.places[:, k]][:, None] + np.arange(size) for k, size in enumerate(sizes)
        ]
        return np.concatenate(parts, axis=1) if parts else np.zeros((len(group), 0), int)

    def rows(self, group: Group) -> Array:
        """Rows of every member (n, m of the kind)."""
        kind = group.kind
        own = (
            group.rows[:, :1] + np.arange(kind.mp),
            group.rows[:, 1:] + np.arange(kind.m - kind.mp),
        )
        return np.concatenate(own, axis=1)

    def call(
        self, group: Group, function: str, udot: Array | None = None, lam: Array | None = None
    ) -> dict[str, Any]:
        """A function for all members: results (n, *shape)."""
        n, at = len(group), self.entries(group, "u")
        udot = np.zeros(self.scene.places.nu) if udot is None else udot
        lam = np.zeros(self.m) if lam is None else lam
        none = np.zeros((n, 0))
        values = {
            "t": np.full((n, 1), self.t),
            "q": self.q[self.entries(group, "q")],
            "u": self.u[at],
            "r": np.broadcast_to(self.inputs, (n, len(self.inputs))),
            "p": self.data(group),
            "udot": udot[at],
            "lam": lam[self.rows(group)],
            "z": none if group.z is None else self.states[0][group.z],
            "s": none if group.s is None else self.states[1][group.s],
        }
        made = group.kind.functions[function]
        found = evaluate(made, values, "numpy")
        return {o.name: np.broadcast_to(found[o.name], (n, *o.shape)) for o in made.outputs}

    def assembled(self) -> tuple[Array, Array, Array, Array]:
        """M (nu, nu), bias h - f (nu), G (m, nu) and gamma (m)."""
        nu = self.scene.places.nu
        M, bias = np.zeros((nu, nu)), np.zeros(nu)
        G, gamma = np.zeros((self.m, nu)), np.zeros(self.m)
        for group in self.scene.groups:
            at, rows = self.entries(group, "u"), self.rows(group)
            if "balance" in group.kind.functions:
                np.add.at(bias, at, self.call(group, "balance")["balance"])
            if "balance_tangent" in group.kind.functions:
                found = self.call(group, "balance_tangent")
                if "M" in found:
                    np.add.at(M, (at[:, :, None], at[:, None, :]), found["M"])
                if "G" in found:
                    np.add.at(G, (rows[:, :, None], at[:, None, :]), found["G"])
            if "gamma" in group.kind.functions:
                np.add.at(gamma, rows, self.call(group, "gamma")["gamma"])
        return M, bias, G, gamma

    def constraints(self) -> tuple[Array, Array]:
        """g and G u + g_t of all rows; rows of velocities have no g."""
        g, rates = np.zeros(self.m), np.zeros(self.m)
        for group in self.scene.groups:
            if group.kind.m and "balance" in group.kind.functions:
                found, rows = self.call(group, "balance"), self.rows(group)
                g[rows[:, : group.kind.mp]] = found["g"]
                rates[rows] = found["rates"]
        return g, rates

    def solved(self) -> tuple[Array, Array, float]:
        """udot, lam (the smallest where rows are redundant), and the error bound of udot.

        Returns:
            udot (nu), lam (m), eps times the condition number of the scaled system.
        """
        M, bias, G, gamma = self.assembled()
        nu, m = G.shape[1], G.shape[0]
        whole = np.block([[M, -G.T], [G, np.zeros((m, m))]])
        right = np.concatenate([-bias, gamma])
        # rows and columns of like size: masses and lengths are of no matter
        scale = np.ones(nu + m)
        for _ in range(10):
            size = np.abs(whole * scale[:, None] * scale).max(axis=1)
            scale /= np.sqrt(np.where(size > 0, size, 1.0))
        scaled = whole * scale[:, None] * scale
        values = np.linalg.svd(scaled, compute_uv=False)
        kept = values > values[0] * 1e-11
        x = np.linalg.lstsq(scaled, right * scale, rcond=1e-11)[0] * scale
        return x[:nu], x[nu:], EPS * values[0] / values[kept][-1]

    def sum(self, function: str, udot: Array | None = None, lam: Array | None = None) -> dict:
        """A function summed over all members that have it."""
        total: dict[str, Any] = {}
        for group in self.scene.groups:
            if function in group.kind.functions:
                for name, value in self.call(group, function, udot, lam).items():
                    total[name] = total.get(name, 0) + value.sum(axis=0)
        return total

    def listed(self, function: str, udot: Array, lam: Array) -> Array:
        """Outputs or powers of the scene by its tables."""
        letter = "outputs" if function == "outputs" else "powers"
        names = self.scene.outputs if function == "outputs" else self.scene.powers
        found = np.zeros(len(names))
        for group in self.scene.groups:
            if function in group.kind.functions:
                np.add.at(
                    found, getattr(group, letter), self.call(group, function, udot, lam)[function]
                )
        return found

    def reaction(self, joint: str, udot: Array, lam: Array) -> Array:
        """Wrench (6,) of parent on child at the child joint frame in its axes."""
        if joint in self.scene.tree_joints:
            return self._sum_of_reactions(udot, lam)[self.scene.tree_joints.index(joint)]
        g, e = self.scene.joints[joint]
        return self.call(self.scene.groups[g], "reaction", lam=lam)["reaction"][e]

    def _sum_of_reactions(self, udot: Array, lam: Array) -> Array:
        """Of the joints of trees (n, 6)."""
        total = np.zeros((len(self.scene.tree_joints), 6))
        for group in self.scene.groups:
            if "reactions" in group.kind.functions:
                shares = self.call(group, "reactions", udot, lam)["reactions"]
                np.add.at(total, group.reactions, shares)
        return total

    def body(self, frame: int, udot: Array) -> tuple[Array, Array]:
        """Acceleration (6,) of the body of a tree that carries a frame, and the rest (18,)."""
        g, e, k = self.scene.frames.bodies[frame]
        row = self.call(self.scene.groups[g], "bodies", udot)["bodies"][e, k]
        return row[18:], row[:18]

    def node(self, frame: int) -> tuple[int, Array, Array]:
        """Place (-1: ground) of a frame, R (3, 3) and p (3) in its axes."""
        poses = evaluate(self.scene.frames.poses, {"p": self.p}, "numpy")
        R = poses["rotation"][frame].reshape(3, 3)
        return int(self.scene.frames.place[frame]), R, poses["position"][frame]
