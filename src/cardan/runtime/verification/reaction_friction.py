"""Friction that follows from reactions, judged by the reactions of free bodies.

What a joint presses with follows from the accelerations by Newton and Euler, body by body; how much
friction that makes is a coefficient. At given accelerations nothing has to be solved; at given
forces a plain iteration finds both.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...records import dataclass
from .joint_motion import Array, times
from .newton_euler import Scene, moving, rates_of_momentum, transmitted

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel

Loads = tuple[list[Array], list[Array]]
ROUNDS, SETTLED = 400, 1e-14


@dataclass(frozen=True)
class ReactionFriction:
    """Forces at some states, (n, ...), and what they press with.

    Attributes:
        scene: The flat scene.
        joints: Of every element, and whether its joint has a line along which nothing presses.
        other_forces: Generalized forces without this friction (n, nu).
        along: Generalized force per unit of friction of every element (n, k, nu).
        coefficient: Friction per force of reaction (n, k).
        moment, force: Of elements on every body, about its origin in its axes (n, nb, 3).
    """

    scene: Scene
    joints: tuple[tuple[int, bool], ...]
    other_forces: Array
    along: Array
    coefficient: Array
    moment: Array
    force: Array

    def only(self, chosen: NDArray[np.intp]) -> ReactionFriction:
        """The same at some of the states."""
        names = ("other_forces", "along", "coefficient", "moment", "force")
        return replace(self, **{name: getattr(self, name)[chosen] for name in names})

    def at(
        self, q: Array, u: Array, udot: Array, motion: Array | None, outside: Loads | None = None
    ) -> Array:
        """All generalized forces of the model (n, nu) at accelerations.

        Args:
            q, u, udot, motion: The motion of the tree.
            outside: Moment about its origin and force on every body, in ground axes.
        """
        scene, m = self.scene, moving(self.scene, q, u, udot, motion)
        moments, forces = [], []
        for i in range(len(scene.parents)):
            body = m.rotations[i + 1]
            moment, force = rates_of_momentum(
                scene.numbers, i, body, m.omega[i + 1], m.alpha[i + 1], m.accel[i + 1]
            )
            moment, force = (
                moment - times(body, self.moment[:, i]),
                force - times(body, self.force[:, i]),
            )
            if outside is not None:
                moment, force = moment - outside[0][i], force - outside[1][i]
            moments.append(moment)
            forces.append(force)
        _, _, handed = transmitted(scene, m, moments, forces, [rate for rate, _ in m.rotors])
        friction = np.zeros_like(self.coefficient)
        for k, (i, lined) in enumerate(self.joints):
            normal = handed[i]
            if lined:
                axis = scene.numbers["axis"][i] / np.linalg.norm(scene.numbers["axis"][i])
                line = times(m.rotations[i + 1], axis)
                normal = normal - line * (line * normal).sum(axis=-1, keepdims=True)
            friction[:, k] = self.coefficient[:, k] * np.linalg.norm(normal, axis=-1)
        return np.asarray(self.other_forces + np.einsum("nk,nkj->nj", friction, self.along))

    def under(
        self,
        M: Array,
        extra: Array,
        q: Array,
        u: Array,
        motion: Array | None,
        outside: Loads | None = None,
    ) -> Array:
        """The same under given forces (n, nu) beside those of the model, inertia's h taken off.

        NaN where the iteration finds none: friction has no unique solution there.
        """
        f = self.other_forces
        for _ in range(ROUNDS):
            udot = np.linalg.solve(M, (f + extra)[..., None])[..., 0]
            new = self.at(q, u, udot, motion, outside)
            size = np.abs(new).max(axis=-1, keepdims=True) + np.abs(extra).max(axis=-1)[:, None]
            left = np.abs(new - f).max(axis=-1, keepdims=True)
            f = new
            if (left <= SETTLED * size).all():
                break
        return np.where(left <= 100 * SETTLED * size, f, np.nan)


def reaction_friction(
    model: LoadedModel, scene: Scene, n: int, inputs: dict[str, Any]
) -> ReactionFriction | None:
    """Friction of a model that follows from reactions, at n states; None without any.

    Args:
        model, scene: What is judged.
        n: States.
        inputs: Blocks at the states.
    """
    rows = model.manifest.scene.pressed
    if not rows:
        return None

    def saved(name: str) -> dict[str, Array]:
        return dict(model._evaluate_saved(name, **inputs))

    def wide(values: Array, count: int) -> Array:
        return np.broadcast_to(values, (n, *np.shape(values)[-count:]))

    entries, loads = saved("scene_pressing"), saved("wrenches")
    return ReactionFriction(
        scene,
        tuple((int(i), bool(lined)) for i, lined in rows),
        wide(entries["rest"], 1),
        wide(entries["along"], 2),
        wide(entries["coefficient"], 1),
        wide(loads["moment"], 2),
        wide(loads["force"], 2),
    )
