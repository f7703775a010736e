"""Equations of motion of a tree and its loops against the Newton-Euler of the judge's own."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from . import loops
from .differences import BOUND, relative
from .evaluation import Asked
from .joint_motion import Array, joint_motion, placed, times
from .loops import acceleration_error, borne, singular, unbalanced
from .newton_euler import own
from .reference_values import push

SINGULAR = "the mass matrix is singular"
STEP = 1e-30
SOLVED = ("forward_dynamics", "rhs", "multipliers")
# what loops bind
BOUND_BY_LOOPS = ("forward_dynamics", "rhs", *loops.JUDGES)


def mass_matrix(asked: Asked, of: str) -> float:
    """M, or its products where it is large."""
    truth, M = asked.truth, asked.call("mass_matrix")
    if truth.M is not None:
        return relative(M - truth.M, truth.M)
    pushed = push(asked.scene, truth, truth.udot)
    return relative(times(M, truth.udot) - pushed, pushed)


def _part_of_bias(name: str, part: Callable[[Any], Array]) -> Callable[[Asked, str], float]:
    """A function that is h or a part of it."""

    def error(asked: Asked, of: str) -> float:
        truth = asked.truth
        terms = truth.h, truth.gravity, _inertial(asked)
        return relative(asked.call(name) - part(truth), *terms)

    return error


def qdot(asked: Asked, of: str) -> float:
    """Rates of the coordinates."""
    return _rates_error(asked, asked.call("qdot"))


def inverse_dynamics(asked: Asked, of: str) -> float:
    """Forces of accelerations."""
    udot = asked.truth.udot
    return _balance(asked, udot, asked.call("inverse_dynamics"), free=False)


def forward_dynamics(asked: Asked, of: str) -> float:
    """Accelerations of forces."""
    return _balance(asked, asked.call("forward_dynamics"), asked.truth.tau)


def rhs(asked: Asked, of: str) -> float:
    """Rates of the state."""
    rates, udot = asked.model.split(asked.call("rhs"))
    return max(_rates_error(asked, rates), _balance(asked, udot, np.zeros(asked.model.nu)))


def _unknown(asked: Asked, name: str) -> str:
    """Why a function cannot be judged; "" if it can."""
    truth, treatment = asked.truth, asked.model.manifest.scene.treatment
    if asked.adrift and name in BOUND_BY_LOOPS:
        return asked.adrift
    if name in loops.JUDGES and name not in SOLVED and truth.bound is None:
        return "constraints that act in some modes alone"
    if name in SOLVED and singular(truth):
        return SINGULAR
    if truth.f is None and name in (*SOLVED, "inverse_dynamics"):
        return "the forces of the model are not saved"
    if name in SOLVED and treatment and not treatment.exact:
        return f"constraints treated by '{treatment.name}' give way"
    if name == "multipliers" and not asked.knows("constraint_jacobian"):
        return "constraint_jacobian is not compiled"
    return ""


def _judge(name: str, judge: Callable[[Asked, str], float]) -> Callable[[Asked, str], float | str]:
    """A judge that says why where its route does not lead to the function."""

    def error(asked: Asked, of: str) -> float | str:
        why, bound = _unknown(asked, name), asked.truth.bound
        if not why and bound is not None and bound.missed.max() > BOUND:
            # what the model says about the joints of its loops does not close them
            return float(bound.missed.max())
        return why or judge(asked, of)

    return error


def _balance(asked: Asked, udot: Array, tau: Array, free: bool = True) -> float:
    """Residual of M udot + h = f + tau, over the largest product or force in it.

    Where accelerations are free to obey constraints, these bear what they can, and are obeyed.
    """
    truth = asked.truth
    force = truth.force(udot)
    f = np.zeros_like(truth.h) if force is None else force
    if truth.M is None:
        pushed = most = push(asked.scene, truth, udot)
    else:
        products = truth.M * udot[:, None, :]
        pushed, most = products.sum(axis=-1), np.abs(products).max(axis=-1, initial=0.0)
    residual = pushed + truth.h - f - tau
    terms = most, truth.h, f, np.broadcast_to(tau, truth.h.shape), _inertial(asked)
    if truth.bound is None or not free:
        return relative(residual, *terms)
    held = borne(truth.bound, residual)
    error = relative(unbalanced(truth.bound, residual), *terms, held)
    loose = np.zeros_like(udot)
    if truth.M is not None:
        inertia = np.diagonal(truth.M, axis1=-2, axis2=-1)
        loose = (f + tau - truth.h) / np.where(inertia > 0, inertia, np.inf)
    return max(error, acceleration_error(truth.bound, udot, loose))


def _inertial(asked: Asked) -> Array:
    """Size of the products of speeds and masses (n, 1): where they cancel, rounding is left."""
    squares = (asked.truth.u**2).max(axis=-1, initial=0.0)
    return np.asarray(asked.truth.largest * squares)[:, None]


def _rates_error(asked: Asked, rates: Array) -> float:
    """Whether the rates of the coordinates turn and shift every joint as its speeds say.

    A complex step along qdot differentiates the pose of the joint exactly.
    """
    worst, scene, truth = 0.0, asked.scene, asked.truth
    for i in range(len(scene.parents)):
        solved = scene.q[i][0] >= truth.q.shape[-1]
        if scene.prescribed[i] or scene.leaders[i] >= 0 or solved:
            continue
        qi, ui = own(scene, i, truth.q, (truth.u,), truth.motion)
        ri = own(scene, i, rates, (), truth.motion)[0]
        now = joint_motion(scene.joints[i], qi, ui)
        moved, path = (x.imag / STEP for x in placed(scene.joints[i], qi + 1j * STEP * ri))
        turning: Any = np.swapaxes(now.rotation, -1, -2) @ moved
        spin = (now.turn @ ui[..., None])[..., 0]
        found = np.stack([turning[..., 2, 1], turning[..., 0, 2], turning[..., 1, 0]], axis=-1)
        shift = (now.shift @ ui[..., None])[..., 0]
        difference = np.concatenate([found - spin, path - shift], axis=-1)
        worst = max(worst, relative(difference, np.concatenate([spin, shift], axis=-1)))
    return worst


JUDGES = {
    name: _judge(name, judge)
    for name, judge in {
        "mass_matrix": mass_matrix,
        "bias": _part_of_bias("bias", lambda truth: truth.h),
        "gravity": _part_of_bias("gravity", lambda truth: truth.gravity),
        "coriolis": _part_of_bias("coriolis", lambda truth: truth.h - truth.gravity),
        "inverse_dynamics": inverse_dynamics,
        "forward_dynamics": forward_dynamics,
        "qdot": qdot,
        "rhs": rhs,
        **loops.JUDGES,
    }.items()
}
