"""Reference values of an independent Newton-Euler at random states."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...records import dataclass
from .closed_states import Bound, closed_states
from .flat_scene import motion_of
from .joint_motion import Array, times
from .newton_euler import Scene, inverse_dynamics, mass_matrix
from .reaction_friction import ReactionFriction, reaction_friction
from .user_constraints import with_written

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel

# Inputs go this far from their defaults, as a part of them.
INPUT = 0.3
TIME = 0.3


@dataclass(frozen=True)
class ReferenceValues:
    """The independent numbers at some states, (n, ...).

    ``M`` is None for large systems; ``largest`` is the size of its entries, (n,). ``bound`` is what
    binds the tree there, None where nothing does or it is not known.
    """

    q: Array
    u: Array
    udot: Array
    tau: Array
    t: float
    r: Array
    M: Array | None
    largest: Array
    h: Array
    gravity: Array
    f: Array | None
    motion: Array | None
    bound: Bound | None = None
    reaction_friction: ReactionFriction | None = None

    def force(self, udot: Array) -> Array | None:
        """Generalized forces of the model (n, nu) at accelerations; None where not known."""
        if self.reaction_friction is None:
            return self.f
        return self.reaction_friction.at(self.q, self.u, udot, self.motion)

    def under(self, extra: Array, outside: Any = None) -> Array:
        """The same with forces (n, nu) and wrenches on bodies beside those of the model."""
        if self.reaction_friction is None:
            return np.asarray(self.f)
        M, forces = np.asarray(self.M), extra - self.h
        return self.reaction_friction.under(M, forces, self.q, self.u, self.motion, outside)

    def only(self, chosen: NDArray[np.intp]) -> ReferenceValues:
        """The same at some of the states."""
        entries = {field.name: getattr(self, field.name) for field in fields(self)}
        rows: dict[str, Any] = {
            k: x[chosen] for k, x in entries.items() if isinstance(x, np.ndarray)
        }
        reaction_friction = self.reaction_friction and self.reaction_friction.only(chosen)
        return replace(
            self,
            **rows,
            bound=self.bound and self.bound.only(chosen),
            reaction_friction=reaction_friction,
        )


def drawn(model: LoadedModel, states: int, seed: int) -> ReferenceValues:
    """Random states of which nothing is known."""
    rng = np.random.default_rng(seed)
    q, u = model.split(model.random_state(rng, (states,)))
    udot, tau = rng.uniform(-1, 1, (2, states, model.nu))
    start = model._layout.start("r")
    r = start + INPUT * np.maximum(1.0, np.abs(start)) * rng.uniform(-1, 1, (states, model.nr))
    none = np.zeros(states)
    return ReferenceValues(q, u, udot, tau, TIME, r, None, none, none, none, None, None)


def reference_values(
    model: LoadedModel, scene: Scene, states: int, seed: int, circuits: bool = False
) -> ReferenceValues:
    """Everything but the mass matrix, which is the costly part.

    Args:
        model, scene: What is judged, with its tree.
        states: That are drawn.
        seed: Of the states.
        circuits: Whether states shall lie on the constraints; there may be fewer then, and they
            stay where they are (``bound`` is None) if none is found there.
    """
    rng = np.random.default_rng(seed)
    q, u = model.split(model.random_state(rng, (states,)))
    udot, tau = rng.uniform(-1, 1, (2, states, model.nu))
    p, start = model.parameters.vector, model._layout.start("r")
    # near their defaults; rates and accelerations of inputs start from 0 and must not stay there
    r = start + INPUT * np.maximum(1.0, np.abs(start)) * rng.uniform(-1, 1, (states, model.nr))
    bound = closed_states(model, scene, q, u, TIME, r) if circuits else None
    bound = bound and with_written(model, bound, TIME)
    if bound is not None:
        states, r = len(bound.q), bound.r
        q, u = bound.q[:, : model.nq], bound.u[:, : model.nu]
        udot, tau = udot[:states], tau[:states]
    motion = motion_of(model, TIME, r)
    if motion is not None:
        motion = np.broadcast_to(motion, (states, *motion.shape[-2:]))
    h, gravity = _biases(scene, q if bound is None else bound.q, u, motion, bound)
    f, friction = None, None
    if "applied_forces" in model.saved:
        inputs: dict[str, Any] = {block: model._layout.start(block) for block in ("z", "s")}
        inputs |= {"t": np.array([TIME]), "q": q, "u": u, "r": r, "p": p}
        friction = reaction_friction(model, scene, states, inputs)
        values = model._evaluate_saved("applied_forces", **inputs)
        f = np.broadcast_to(values["f"], h.shape)
    elif model.manifest.scene.forces == []:
        f = np.zeros_like(h)
    none = np.zeros(states)
    return ReferenceValues(
        q, u, udot, tau, TIME, r, None, none, h, gravity, f, motion, bound, friction
    )


def _biases(
    scene: Scene, q: Array, u: Array, motion: Array | None, bound: Bound | None
) -> tuple[Array, Array]:
    """h and its part at rest, along the speeds of the model."""
    still = np.zeros(scene.nu)
    still_motion = None if motion is None else motion * [1.0, 0.0, 0.0]
    gravity = inverse_dynamics(scene, q, still, still, still_motion)
    if bound is None:
        return inverse_dynamics(scene, q, u, still, motion), gravity
    # joints that loops determine move along and take their part
    moving = bound.u[:, : scene.nu]
    h = inverse_dynamics(scene, q, moving, bound.rests, motion)
    along = np.swapaxes(bound.carries, -1, -2)
    return times(along, h), times(along, gravity)


def masses(scene: Scene, reference: ReferenceValues) -> Array:
    """M (n, nu, nu) along the speeds of the model."""
    if reference.bound is None:
        return mass_matrix(scene, reference.q, reference.motion)
    M, carries = mass_matrix(scene, reference.bound.q, reference.motion), reference.bound.carries
    return np.asarray(np.swapaxes(carries, -1, -2) @ M @ carries)


def push(scene: Scene, reference: ReferenceValues, udot: Array) -> Array:
    """M udot (..., nu) of a tree, without M."""
    still = None if reference.motion is None else reference.motion * [1.0, 0.0, 0.0]
    return inverse_dynamics(scene, reference.q, np.zeros(scene.nu), udot, still, pull=0.0)


def largest(scene: Scene, reference: ReferenceValues) -> Array:
    """Size of the entries of M (n,): those of the first joint, which moves the most."""
    first = np.zeros(scene.nu)
    first[:1] = 1.0
    return np.asarray(np.abs(push(scene, reference, first)).max(axis=-1, initial=0.0))


def finite(reference: ReferenceValues) -> NDArray[np.intp]:
    """Indices of the states at which every term is a number."""
    terms = [reference.h, reference.gravity] + ([] if reference.f is None else [reference.f])
    return np.flatnonzero(np.isfinite(np.concatenate(terms, axis=-1)).all(axis=-1))
