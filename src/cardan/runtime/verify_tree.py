"""The functions of a tree and its circuits against an independent Newton-Euler in NumPy."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import verify_circuits
from .calling import Array
from .joint_motion import joint_motion, placed
from .newton_euler import Scene, own
from .truth import Truth, push
from .verify_circuits import CHECKS, acceleration_error, borne, relative, singular, unbalanced

if TYPE_CHECKING:
    from .compiled import CompiledModel

# Rounding of either side stays below 1e-12 of the largest term even for chains of a hundred bodies;
# a wrong formula is wrong in the first digits. In between lies the bound.
BOUND = 1e-9
SINGULAR = "not checked: the mass matrix is singular"
NOWHERE = "not checked: the forces of the model are nowhere finite"
STEP = 1e-30


@dataclass(frozen=True)
class Check:
    """One function against the independent route.

    Attributes:
        function: Its name.
        error: Largest difference over the largest term of its equation; NaN if not checked.
        reason: Why it could not be checked, "" if it was.
        written: Largest difference from its own expressions, which the C was written from; NaN
            where they were not asked.
    """

    function: str
    error: float
    reason: str = ""
    written: float = float("nan")

    @property
    def worst(self) -> float:
        """The larger error; NaN if there is none."""
        return float(np.fmax(self.error, self.written))


def check(model: CompiledModel, scene: Scene, truth: Truth, name: str) -> Check:
    """One function; forces of the model come from its saved Function ``applied``."""
    reason = _unchecked(model, truth, name)
    if reason:
        return Check(name, np.nan, reason)
    if truth.bound is not None and truth.bound.missed.max() > BOUND:
        # what the model says about the joints of its circuits does not close them
        return Check(name, float(truth.bound.missed.max()))
    if name in CHECKS and truth.bound is not None:
        return Check(name, verify_circuits.check(model, truth, truth.bound, name))
    q, u = truth.q, truth.u
    given: dict[str, Any] = {"t": truth.t, "r": truth.r}
    if name == "mass_matrix":
        M = model.mass_matrix(q, **given)
        if truth.M is not None:
            return Check(name, relative(M - truth.M, truth.M))
        pushed = push(scene, truth, truth.udot)
        return Check(name, relative((M @ truth.udot[..., None])[..., 0] - pushed, pushed))
    if name in ("bias", "gravity", "coriolis"):
        known = {"bias": truth.h, "gravity": truth.gravity, "coriolis": truth.h - truth.gravity}
        states = (q,) if name == "gravity" else (q, u)
        value = getattr(model, name)(*states, **given)
        terms = (truth.h, truth.gravity, _inertial(truth))
        return Check(name, relative(value - known[name], *terms))
    if name == "qdot":
        return Check(name, _rates_error(scene, truth, model.qdot(q, u, **given)))
    if name == "inverse_dynamics":
        value = model.inverse_dynamics(q, u, truth.udot, **given)
        return Check(name, _balance(scene, truth, truth.udot, value, free=False))
    if name == "forward_dynamics":
        value = model.forward_dynamics(q, u, tau=truth.tau, **given)
        return Check(name, _balance(scene, truth, value, truth.tau))
    z = np.broadcast_to(model._layout.start("z"), (len(q), model.nz))
    xdot = model.rhs(truth.t, np.concatenate([q, u, z], axis=-1), truth.r)
    qdot, udot = model.split(xdot)
    error = max(_rates_error(scene, truth, qdot), _balance(scene, truth, udot, np.zeros(model.nu)))
    return Check(name, error)


def _unchecked(model: CompiledModel, truth: Truth, name: str) -> str:
    """Why a function cannot be checked at some states; "" if it can."""
    if not len(truth.q):
        return NOWHERE
    solves = name in ("forward_dynamics", "rhs", "multipliers")
    if solves and singular(truth):
        return SINGULAR
    if truth.f is None and (solves or name == "inverse_dynamics"):
        return "not checked: the forces of the model are not saved"
    treatment = model.manifest["scene"].get("treatment")
    if solves and treatment and not treatment["exact"]:
        return f"not checked: constraints treated by '{treatment['name']}' give way"
    if name == "multipliers" and ("constraint_jacobian", None) not in model._functions:
        return "not checked: constraint_jacobian is not compiled"
    return ""


def _balance(scene: Scene, truth: Truth, udot: Array, tau: Array, free: bool = True) -> float:
    """Residual of M udot + h = f + tau, over the largest product or force in it.

    Where accelerations are free to obey constraints, these bear what they can, and are obeyed.
    """
    force = truth.force(udot)
    f = np.zeros_like(truth.h) if force is None else force
    if truth.M is None:
        pushed = most = push(scene, truth, udot)
    else:
        products = truth.M * udot[:, None, :]
        pushed, most = products.sum(axis=-1), np.abs(products).max(axis=-1, initial=0.0)
    residual = pushed + truth.h - f - tau
    terms = most, truth.h, f, np.broadcast_to(tau, truth.h.shape), _inertial(truth)
    if truth.bound is None or not free:
        return relative(residual, *terms)
    held = borne(truth.bound, residual)
    error = relative(unbalanced(truth.bound, residual), *terms, held)
    loose = np.zeros_like(udot)
    if truth.M is not None:
        inertia = np.diagonal(truth.M, axis1=-2, axis2=-1)
        loose = (f + tau - truth.h) / np.where(inertia > 0, inertia, np.inf)
    return max(error, acceleration_error(truth.bound, udot, loose))


def _inertial(truth: Truth) -> Array:
    """Size of the products of speeds and masses (n, 1): where they cancel, rounding is left."""
    squares = (truth.u**2).max(axis=-1, initial=0.0)
    return np.asarray(truth.largest * squares)[:, None]


def _rates_error(scene: Scene, truth: Truth, qdot: Array) -> float:
    """Whether the rates of the coordinates turn and shift every joint as its speeds say.

    A complex step along qdot differentiates the pose of the joint exactly.
    """
    worst = 0.0
    for i in range(len(scene.parents)):
        solved = scene.q[i][0] >= truth.q.shape[-1]
        if scene.prescribed[i] or scene.leaders[i] >= 0 or solved:
            continue
        qi, ui = own(scene, i, truth.q, (truth.u,), truth.motion)
        ri = own(scene, i, qdot, (), truth.motion)[0]
        now = joint_motion(scene.joints[i], qi, ui)
        moved, path = (x.imag / STEP for x in placed(scene.joints[i], qi + 1j * STEP * ri))
        turning: Any = np.swapaxes(now.rotation, -1, -2) @ moved
        spin = (now.turn @ ui[..., None])[..., 0]
        found = np.stack([turning[..., 2, 1], turning[..., 0, 2], turning[..., 1, 0]], axis=-1)
        shift = (now.shift @ ui[..., None])[..., 0]
        difference = np.concatenate([found - spin, path - shift], axis=-1)
        worst = max(worst, relative(difference, np.concatenate([spin, shift], axis=-1)))
    return worst
