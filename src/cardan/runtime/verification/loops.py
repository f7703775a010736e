"""Check what a model says about its circuits against conditions of the judge's own."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..models.constraint_projection import size_of
from .closed_states import RANK, Bound, dependents
from .differences import relative
from .evaluation import Asked
from .joint_motion import Array, times
from .reference_values import Truth
from .user_constraints import written

# Beyond this condition number udot has lost what the bound asks for: M is singular to a program.
REGULAR = 1e13


def unbalanced(bound: Bound, force: Array) -> Array:
    """What of generalized forces (n, nu) no constraint can bear."""
    back, wide = _wide(bound, force)
    return np.asarray(wide - times(back, times(np.linalg.pinv(back, rcond=RANK), wide)))


def borne(bound: Bound, force: Array) -> Array:
    """The part of generalized forces (n, nu) that constraints bear."""
    return np.asarray(_wide(bound, force)[1] - unbalanced(bound, force))


def _wide(bound: Bound, force: Array) -> tuple[Array, Array]:
    """Gᵀ, and forces with zeros for joints that close circuits, which have no drive."""
    none = np.zeros((len(force), bound.G.shape[-1] - force.shape[-1]))
    return np.swapaxes(bound.G, -1, -2), np.concatenate([force, none], axis=-1)


def acceleration_error(bound: Bound, udot: Array, free: Array) -> float:
    """Whether accelerations (n, nu) leave velocities on the constraints.

    Constraints take from the free ones (n, nu): in a circuit that cannot move only rounding of
    these is left.
    """
    nu = udot.shape[-1]
    own, others = bound.G[..., :nu], bound.G[..., nu:]
    found = times(own, udot) + bound.rest
    left = found - times(others, times(np.linalg.pinv(others, rcond=RANK), found))
    return relative(left, own * udot[:, None, :], own * free[:, None, :], bound.rest)


def accelerations(asked: Asked, force: Array) -> Array:
    """udot (n, nu) of generalized forces beside those of inertia and gravity, on constraints."""
    truth = asked.truth
    M, right = np.asarray(truth.M), force - truth.h
    if truth.bound is None:
        return np.asarray(np.linalg.solve(M, right[..., None])[..., 0])
    bound, nu = truth.bound, truth.u.shape[-1]
    # one acceleration that constraints allow, then along the motions they allow
    udot = -times(np.linalg.pinv(bound.G, rcond=RANK), bound.rest)[:, :nu]
    for k, Z in enumerate(motions_of(bound, nu)):
        left = Z.T @ (right[k] - M[k] @ udot[k])
        udot[k] += Z @ np.linalg.lstsq(Z.T @ M[k] @ Z, left, rcond=None)[0]
    return udot


def _dependents(asked: Asked, of: str) -> float:
    """Coordinates that close the circuits, and rates that keep them closed."""
    truth, bound, value = asked.truth, _bound(asked), asked.call("dependents")
    count = dependents(asked.model, truth.q, truth.u, truth.t, truth.r)[0].shape[-1]
    nq, nu = truth.q.shape[-1], truth.u.shape[-1]
    q, u = bound.q[:, nq : nq + count], bound.u[:, nu : nu + value.shape[-1] - count]
    known = np.concatenate([q, u], axis=-1)
    return relative(value - known, known, np.ones_like(known))


def _residual(name: str) -> Callable[[Asked, str], float]:
    """Of a function that vanishes on the constraints."""

    def error(asked: Asked, of: str) -> float:
        model, rates, value = asked.model, name == "constraint_rates", asked.call(name)
        # what the user wrote is judged by differences, at states that need not fulfil it
        own = [k for k in range(value.shape[-1]) if k not in written(model)]
        fastest = float(np.abs(_bound(asked).u).max()) if rates else 0.0
        size = max(1.0, size_of(model), fastest)
        return float(np.abs(value[..., own]).max(initial=0.0)) / size

    return error


def _jacobian(asked: Asked, of: str) -> float:
    """Whether the rows of G leave exactly the motions that the joints allow."""
    truth, G = asked.truth, asked.call("constraint_jacobian")
    nu = truth.u.shape[-1]
    G = np.broadcast_to(G, (len(truth.q), *G.shape[-2:]))
    if not np.isfinite(G).all():
        return np.inf
    worst = 0.0
    for rows, allowed in zip(G, motions_of(_bound(asked), nu), strict=True):
        freedoms = np.linalg.matrix_rank(allowed, tol=RANK)
        size = np.abs(rows).max(initial=0.0) or 1.0
        worst = max(worst, float(np.abs(rows @ allowed).max(initial=0.0)) / size)
        if np.linalg.matrix_rank(rows, tol=RANK * size) != nu - freedoms:
            worst = 1.0
    return worst


def _multipliers(asked: Asked, of: str) -> float:
    """Whether the forces of constraint make the accelerations that constraints ask for."""
    truth, G = asked.truth, asked.call("constraint_jacobian")
    f = np.asarray(truth.f)
    force = truth.tau + f
    products = np.asarray(truth.M) * accelerations(asked, force)[:, None, :]
    held = times(np.swapaxes(G, -1, -2), asked.call("multipliers"))
    left = products.sum(axis=-1) + truth.h - force - held
    return relative(left, products, truth.h, f, truth.tau, held)


def _bound(asked: Asked) -> Bound:
    """What binds a model that something binds."""
    assert asked.truth.bound is not None
    return asked.truth.bound


def moved_masses(bound: Bound, M: Array) -> list[Array]:
    """Inertia along the motions that constraints allow, state by state."""
    return [Z.T @ m @ Z for Z, m in zip(motions_of(bound, M.shape[-1]), M, strict=True)]


def singular(truth: Truth) -> bool:
    """Whether nothing resists some motion that constraints allow."""
    if truth.M is None:
        return False
    inertia = truth.M if truth.bound is None else moved_masses(truth.bound, truth.M)
    values = [np.linalg.eigvalsh(matrix) for matrix in inertia]
    return any(bool(np.any(v[:1] * REGULAR <= v[-1:])) for v in values)


def motions_of(bound: Bound, nu: int) -> list[Array]:
    """Columns of speeds (nu, k) that constraints allow, state by state."""
    found = []
    for whole in bound.G:
        _, values, directions = np.linalg.svd(whole)
        rank = int((values > RANK * values.max(initial=0.0)).sum())
        found.append(directions[rank:, :nu].T)
    return found


JUDGES = {
    "dependents": _dependents,
    "constraints": _residual("constraints"),
    "constraint_rates": _residual("constraint_rates"),
    "constraint_jacobian": _jacobian,
    "multipliers": _multipliers,
}
