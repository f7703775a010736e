"""Check what a model says about its loops against conditions of the judge's own."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..models.constraint_projection import size_of
from .closed_states import RANK, Bound, dependents
from .differences import relative
from .evaluation import Trial
from .joint_motion import Array, times
from .reference_values import ReferenceValues
from .user_constraints import written

# Beyond this condition number udot has lost what the bound asks for: M is singular to a program.
REGULAR = 1e13


def unbalanced(bound: Bound, force: Array) -> Array:
    """Check of a function that vanishes on the constraints."""
    back, wide = _wide(bound, force)
    return np.asarray(wide - times(back, times(np.linalg.pinv(back, rcond=RANK), wide)))


def borne(bound: Bound, force: Array) -> Array:
    """The part of generalized forces (n, nu) that constraints bear."""
    return np.asarray(_wide(bound, force)[1] - unbalanced(bound, force))


def _wide(bound: Bound, force: Array) -> tuple[Array, Array]:
    """Gᵀ, and forces with zeros for joints that close loops, which have no drive."""
    none = np.zeros((len(force), bound.G.shape[-1] - force.shape[-1]))
    return np.swapaxes(bound.G, -1, -2), np.concatenate([force, none], axis=-1)


def acceleration_error(bound: Bound, udot: Array, free: Array) -> float:
    """Error of accelerations (n, nu), which must keep velocities on the constraints.

    Constraints take from the free ones (n, nu): in a loop that cannot move only rounding of
    these is left.
    """
    nu = udot.shape[-1]
    of_speeds, of_unknowns = bound.G[..., :nu], bound.G[..., nu:]
    residual = times(of_speeds, udot) + bound.bias
    left = residual - times(of_unknowns, times(np.linalg.pinv(of_unknowns, rcond=RANK), residual))
    return relative(left, of_speeds * udot[:, None, :], of_speeds * free[:, None, :], bound.bias)


def accelerations(trial: Trial, force: Array) -> Array:
    """udot (n, nu) of generalized forces beside those of inertia and gravity, on constraints."""
    reference = trial.reference
    M, right = np.asarray(reference.M), force - reference.h
    if reference.bound is None:
        return np.asarray(np.linalg.solve(M, right[..., None])[..., 0])
    bound, nu = reference.bound, reference.u.shape[-1]
    # one acceleration that constraints allow, then along the motions they allow
    udot = -times(np.linalg.pinv(bound.G, rcond=RANK), bound.bias)[:, :nu]
    for k, Z in enumerate(motions_of(bound, nu)):
        left = Z.T @ (right[k] - M[k] @ udot[k])
        udot[k] += Z @ np.linalg.lstsq(Z.T @ M[k] @ Z, left, rcond=None)[0]
    return udot


def _dependents(trial: Trial, of: str) -> float:
    """Coordinates that close the loops, and rates that keep them closed."""
    reference, bound, value = trial.reference, _bound(trial), trial.call("dependents")
    count = dependents(trial.model, reference.q, reference.u, reference.t, reference.r)[0].shape[-1]
    nq, nu = reference.q.shape[-1], reference.u.shape[-1]
    q, u = bound.q[:, nq : nq + count], bound.u[:, nu : nu + value.shape[-1] - count]
    expected = np.concatenate([q, u], axis=-1)
    return relative(value - expected, expected, np.ones_like(expected))


def _residual(name: str) -> Callable[[Trial, str], float]:
    """Check of a function that vanishes on the constraints."""

    def error(trial: Trial, of: str) -> float:
        model, rates, value = trial.model, name == "constraint_rates", trial.call(name)
        # what the user wrote is judged by differences, at states that need not fulfil it
        generated_rows = [k for k in range(value.shape[-1]) if k not in written(model)]
        fastest = float(np.abs(_bound(trial).u).max()) if rates else 0.0
        size = max(1.0, size_of(model), fastest)
        return float(np.abs(value[..., generated_rows]).max(initial=0.0)) / size

    return error


def _jacobian(trial: Trial, of: str) -> float:
    """Error of the rows of G, which must leave exactly the motions that the joints allow."""
    reference, G = trial.reference, trial.call("constraint_jacobian")
    nu = reference.u.shape[-1]
    G = np.broadcast_to(G, (len(reference.q), *G.shape[-2:]))
    if not np.isfinite(G).all():
        return np.inf
    worst = 0.0
    for rows, allowed in zip(G, motions_of(_bound(trial), nu), strict=True):
        freedoms = np.linalg.matrix_rank(allowed, tol=RANK)
        size = np.abs(rows).max(initial=0.0) or 1.0
        worst = max(worst, float(np.abs(rows @ allowed).max(initial=0.0)) / size)
        if np.linalg.matrix_rank(rows, tol=RANK * size) != nu - freedoms:
            worst = 1.0
    return worst


def _multipliers(trial: Trial, of: str) -> float:
    """Error of the constraint forces, which must make the accelerations that constraints
    require.
    """
    reference, G = trial.reference, trial.call("constraint_jacobian")
    f = np.asarray(reference.f)
    force = reference.tau + f
    products = np.asarray(reference.M) * accelerations(trial, force)[:, None, :]
    constraint_forces = times(np.swapaxes(G, -1, -2), trial.call("multipliers"))
    left = products.sum(axis=-1) + reference.h - force - constraint_forces
    return relative(left, products, reference.h, f, reference.tau, constraint_forces)


def _bound(trial: Trial) -> Bound:
    """Constraints of a constrained model."""
    assert trial.reference.bound is not None
    return trial.reference.bound


def moved_masses(bound: Bound, M: Array) -> list[Array]:
    """Inertia along the motions that constraints allow, state by state."""
    return [Z.T @ m @ Z for Z, m in zip(motions_of(bound, M.shape[-1]), M, strict=True)]


def singular(reference: ReferenceValues) -> bool:
    """True when nothing resists some motion that constraints allow."""
    if reference.M is None:
        return False
    inertia = reference.M if reference.bound is None else moved_masses(reference.bound, reference.M)
    values = [np.linalg.eigvalsh(matrix) for matrix in inertia]
    return any(bool(np.any(v[:1] * REGULAR <= v[-1:])) for v in values)


def motions_of(bound: Bound, nu: int) -> list[Array]:
    """Columns of speeds (nu, k) that constraints allow, state by state."""
    bases = []
    for matrix in bound.G:
        _, values, directions = np.linalg.svd(matrix)
        rank = int((values > RANK * values.max(initial=0.0)).sum())
        bases.append(directions[rank:, :nu].T)
    return bases


JUDGES = {
    "dependents": _dependents,
    "constraints": _residual("constraints"),
    "constraint_rates": _residual("constraint_rates"),
    "constraint_jacobian": _jacobian,
    "multipliers": _multipliers,
}
