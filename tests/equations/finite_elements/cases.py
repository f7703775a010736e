"""Scenes in both formulations at the same states."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from cardan.equations.finite_elements.lowering import lowered
from cardan.equations.finite_elements.record import FiniteElementRecord
from cardan.equations.functions.blocks import defaults
from cardan.ir.interpreter import evaluate
from cardan.schema.finite_elements import ON_TREE
from equations.finite_elements.reference import Reference
from laws.cases import values

Array = np.ndarray
TIME = 0.3


@dataclass(frozen=True)
class Both:
    """A scene in relative and absolute coordinates.

    Attributes:
        relative: Its equations by joint coordinates.
        absolute: Its equations by nodes.
    """

    relative: Any
    absolute: FiniteElementRecord

    def call(self, function: str, of: str | None = None, **given: Any) -> dict[str, Any]:
        """A function of the relative formulation at one state."""
        start = defaults(self.relative.system)
        states = {"z": start["z"], "s": start["s"]}
        blocks = values(self.relative, t=[TIME], **(states | given))
        return evaluate(self.relative.function(function, of), blocks, "numpy")

    def at(self, q: Array, u: Array) -> State:
        """Both at a state of the joints."""
        return State(self, q, u)


@dataclass(frozen=True)
class State:
    """Both formulations at the same state.

    Attributes:
        both: The scene.
        q, u: Coordinates and speeds of its joints.
    """

    both: Both
    q: Array
    u: Array

    @cached_property
    def reference(self) -> Reference:
        """The absolute formulation there."""
        scene = self.both.absolute
        given = values(self.both.relative, t=[TIME], q=self.q, u=self.u)
        found = evaluate(scene.states, given, "numpy")
        return Reference(scene, found["q"], found["u"], t=TIME)

    @cached_property
    def solved(self) -> tuple[Array, Array, float]:
        """udot, lam and error bound of the absolute formulation."""
        return self.reference.solved()

    @cached_property
    def udot(self) -> Array:
        """Accelerations of the joints by the relative formulation."""
        return self.both.call("forward_dynamics", q=self.q, u=self.u)["udot"]

    @cached_property
    def frames(self) -> list[int]:
        """The frames of the user's bodies that move."""
        system = self.both.relative.system
        return [part.frame for body in system.bodies for part in body.parts]

    def accelerations(self) -> tuple[Array, Array]:
        """Of the user's bodies (n, 6) in ground axes, absolute and relative."""
        frames = self.both.relative.system.frames
        mine = [self._acceleration(k, self.solved[0]) for k in self.frames]
        given = {"q": self.q, "u": self.u, "udot": self.udot}
        other = [
            self.both.call("acceleration", frames[k].name, **given)["acceleration"]
            for k in self.frames
        ]
        return np.array(mine), np.array(other)

    def _acceleration(self, frame: int, udot: Array) -> Array:
        """Angular acceleration and that of the origin of a frame, by those of its node."""
        place, _, arm = self.reference.node(frame)
        if place == ON_TREE:
            (alpha, a), rest = (
                np.split(self.reference.body(frame, udot)[0], 2),
                self.reference.body(frame, udot)[1],
            )
            R, omega = rest[:9].reshape(3, 3), rest[12:15]
            return self._at_arm(alpha, omega, R @ arm, a)
        at = self.reference.scene.places.u[place]
        R, turning = self.axes(place), self.reference.u[at : at + 3]
        alpha, omega, arm = R @ udot[at : at + 3], R @ turning, R @ arm
        return self._at_arm(alpha, omega, arm, udot[at + 3 : at + 6])

    @staticmethod
    def _at_arm(alpha: Array, omega: Array, arm: Array, a: Array) -> Array:
        turned = np.cross(alpha, arm) + np.cross(omega, np.cross(omega, arm))
        return np.concatenate([alpha, a + turned])

    def axes(self, place: int) -> Array:
        """R of a node."""
        at = self.reference.scene.places.q[place]
        w, *xyz = self.reference.q[at : at + 4]
        return Rotation.from_quat([*xyz, w]).as_matrix()

    def reactions(self) -> tuple[dict[str, Array], dict[str, Array]]:
        """Wrenches of all joints that transmit one, absolute and relative."""
        parts, (udot, lam, _) = len(self.frames), self.solved
        given = {"q": self.q, "u": self.u, "wrench": np.zeros(6 * parts)}
        absolute = self.both.absolute
        joints = (*absolute.joints, *absolute.tree_joints)
        mine = {name: self.reference.reaction(name, udot, lam) for name in joints}
        other = {name: self.both.call("reaction", name, **given)["reaction"] for name in joints}
        return mine, other

    def certain(self, joint: str) -> bool:
        """Whether the reaction of a joint is the only one possible."""
        _, _, G, _ = self.reference.assembled()
        u, sizes, _ = np.linalg.svd(G)
        free = u[:, np.sum(sizes > 1e-9 * sizes[:1].sum()) :]
        if joint in self.both.absolute.tree_joints:
            return not free.size
        g, e = self.both.absolute.joints[joint]
        rows = self.reference.rows(self.both.absolute.groups[g])[e]
        return bool(np.abs(free[rows]).max(initial=0) < 1e-9)


def both(relative: Any) -> Both:
    """A scene by its relative equations."""
    return Both(relative, lowered(relative.system))
