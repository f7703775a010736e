"""Equations of motion of a tree and its loops against the Newton-Euler of the judge's own."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from . import loops
from .differences import BOUND, relative
from .evaluation import Trial
from .joint_motion import Array, joint_motion, joint_pose, times
from .loops import acceleration_error, borne, singular, unbalanced
from .newton_euler import joint_rows
from .reference_values import push
from .user_constraints import yields

SINGULAR = "the mass matrix is singular"
STEP = 1e-30
SOLVED = ("forward_dynamics", "rhs", "multipliers")
# what loops bind
BOUND_BY_LOOPS = ("forward_dynamics", "rhs", *loops.JUDGES)


def mass_matrix(trial: Trial, of: str) -> float:
    """M, or its products where it is large."""
    reference, M = trial.reference, trial.call("mass_matrix")
    if reference.M is not None:
        return relative(M - reference.M, reference.M)
    pushed = push(trial.scene, reference, reference.udot)
    return relative(times(M, reference.udot) - pushed, pushed)


def _part_of_bias(name: str, part: Callable[[Any], Array]) -> Callable[[Trial, str], float]:
    """A function that is h or a part of it."""

    def error(trial: Trial, of: str) -> float:
        reference = trial.reference
        terms = reference.h, reference.gravity, _inertial(trial)
        return relative(trial.call(name) - part(reference), *terms)

    return error


def qdot(trial: Trial, of: str) -> float:
    """Rates of the coordinates."""
    return _rates_error(trial, trial.call("qdot"))


def inverse_dynamics(trial: Trial, of: str) -> float:
    """Forces of accelerations."""
    udot = trial.reference.udot
    return _balance(trial, udot, trial.call("inverse_dynamics"), free=False)


def forward_dynamics(trial: Trial, of: str) -> float:
    """Accelerations of forces."""
    return _balance(trial, trial.call("forward_dynamics"), trial.reference.tau)


def rhs(trial: Trial, of: str) -> float:
    """Rates of the state."""
    rates, udot = trial.model.split(trial.call("rhs"))
    return max(_rates_error(trial, rates), _balance(trial, udot, np.zeros(trial.model.nu)))


def _unknown(trial: Trial, name: str) -> str:
    """Why a function cannot be judged; "" if it can."""
    reference, why = trial.reference, yields(trial.model)
    if trial.adrift and name in BOUND_BY_LOOPS:
        return trial.adrift
    if name in loops.JUDGES and name not in SOLVED and reference.bound is None:
        return "constraints that act in some modes alone"
    if name in SOLVED and singular(reference):
        return SINGULAR
    if reference.f is None and name in (*SOLVED, "inverse_dynamics"):
        return "the forces of the model are not saved"
    if name in SOLVED and trial.model.manifest.scene.locked:
        return f"'{trial.model.manifest.scene.locked[0]}' holds a joint from the start"
    if name in SOLVED and why:
        return why
    if name == "multipliers" and not trial.knows("constraint_jacobian"):
        return "constraint_jacobian is not compiled"
    return ""


def _judge(name: str, judge: Callable[[Trial, str], float]) -> Callable[[Trial, str], float | str]:
    """A judge that says why where its route does not lead to the function."""

    def error(trial: Trial, of: str) -> float | str:
        why, bound = _unknown(trial, name), trial.reference.bound
        if not why and bound is not None and bound.missed.max() > BOUND:
            # what the model says about the joints of its loops does not close them
            return float(bound.missed.max())
        return why or judge(trial, of)

    return error


def _balance(trial: Trial, udot: Array, tau: Array, free: bool = True) -> float:
    """Residual of M udot + h = f + tau, over the largest product or force in it.

    Where accelerations are free to obey constraints, these bear what they can, and are obeyed.
    """
    reference = trial.reference
    force = reference.force(udot)
    f = np.zeros_like(reference.h) if force is None else force
    if reference.M is None:
        pushed = most = push(trial.scene, reference, udot)
    else:
        products = reference.M * udot[:, None, :]
        pushed, most = products.sum(axis=-1), np.abs(products).max(axis=-1, initial=0.0)
    residual = pushed + reference.h - f - tau
    terms = most, reference.h, f, np.broadcast_to(tau, reference.h.shape), _inertial(trial)
    if reference.bound is None or not free:
        return relative(residual, *terms)
    constraint_forces = borne(reference.bound, residual)
    error = relative(unbalanced(reference.bound, residual), *terms, constraint_forces)
    free_acceleration = np.zeros_like(udot)
    if reference.M is not None:
        inertia = np.diagonal(reference.M, axis1=-2, axis2=-1)
        free_acceleration = (f + tau - reference.h) / np.where(inertia > 0, inertia, np.inf)
    return max(error, acceleration_error(reference.bound, udot, free_acceleration))


def _inertial(trial: Trial) -> Array:
    """Size of the products of speeds and masses (n, 1): where they cancel, rounding is left."""
    squares = (trial.reference.u**2).max(axis=-1, initial=0.0)
    return np.asarray(trial.reference.largest * squares)[:, None]


def _rates_error(trial: Trial, rates: Array) -> float:
    """Error of the coordinate rates: each joint must rotate and shift as its speeds say.

    A complex step along qdot differentiates the pose of the joint exactly.
    """
    worst, scene, reference = 0.0, trial.scene, trial.reference
    for i in range(len(scene.parents)):
        solved = scene.q[i][0] >= reference.q.shape[-1]
        if scene.prescribed[i] or scene.leaders[i] >= 0 or solved:
            continue
        qi, ui = joint_rows(scene, i, reference.q, (reference.u,), reference.motion)
        ri = joint_rows(scene, i, rates, (), reference.motion)[0]
        now = joint_motion(scene.joints[i], qi, ui)
        moved, path = (x.imag / STEP for x in joint_pose(scene.joints[i], qi + 1j * STEP * ri))
        skew: Any = np.swapaxes(now.rotation, -1, -2) @ moved
        spin = (now.turn @ ui[..., None])[..., 0]
        spin_rates = np.stack([skew[..., 2, 1], skew[..., 0, 2], skew[..., 1, 0]], axis=-1)
        shift = (now.shift @ ui[..., None])[..., 0]
        difference = np.concatenate([spin_rates - spin, path - shift], axis=-1)
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
