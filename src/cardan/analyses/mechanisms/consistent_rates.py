"""Speeds and accelerations that constraints allow, with some of them given."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, miscounted
from ...runtime.models.initial import missing
from ...runtime.models.loaded_model import LoadedModel
from .mechanism import Mechanism

CONSISTENT = 1e-9  # of the largest of the given values


def speeds(m: Mechanism, q: Array, named: Mapping[str, object], default: Array) -> Array:
    """Speeds (nu,) with G u + g_t = 0, the given ones held, the others next to wanted ones.

    Args:
        m, q: Mechanism and an assembled position (nq,).
        named: Joint or speed -> value.
        default: What the others are near to (nu,), in the metric of the mass matrix if there is
            one.

    Raises:
        ModelError: an unknown name, or inconsistent values.
        ArgumentError, SolveError: values of a wrong shape, or not finite.
    """
    chosen, values = read("u", m.model, named)
    u = default.copy()
    u[chosen] = values
    start = m.rates(q, m.speeds_at(q, np.zeros(m.nu)))
    locked, more, right = m.locked_speeds(q, chosen, values)
    desired = m.steps_of(u)
    G = np.concatenate([m.jacobian(q), more])
    steps = _meet(m, q, G, desired, locked, np.concatenate([-start, right]), list(named), "u")
    return m.speeds_at(q, steps)


def accelerations(m: Mechanism, q: Array, u: Array, named: Mapping[str, object]) -> Array:
    """Accelerations (nu,) with G udot = gamma, the given ones held, the others as forces have it.

    Args:
        m, q, u: Mechanism and a consistent state.
        named: Joint or speed -> value of its derivative.

    Raises:
        As :func:`speeds`.
    """
    free: Array = m.model.forward_dynamics(q, u, t=m.t, r=m.r)
    chosen, values = read("udot", m.model, named)
    if not len(chosen):
        return free
    # accelerations under forces fulfill the constraints: they know gamma
    G = m.jacobian(q)
    gamma = G @ (free / m.columns)
    udot = free.copy()
    udot[chosen] = values
    return m.columns * _meet(m, q, G, udot / m.columns, chosen, gamma, list(named), "udot")


def read(
    what: str, model: LoadedModel, named: Mapping[str, object]
) -> tuple[NDArray[np.intp], Array]:
    """Places of the named speeds, and their values.

    Args:
        what: ``"u"`` or ``"udot"``, for messages.
        model: Whose.
        named: Joint or speed -> value.
    """
    places = model._layout.slots["u"] if named else {}
    chosen, values = list[int](), list[float]()
    for name, value in named.items():
        where, place = f"{what}={{'{name}': ...}}", places.get(name)
        if place is None:
            raise ModelError(f"{where}: {missing(model.manifest, 'u', name, places)}")
        array = np.asarray(value, dtype=np.float64).reshape(-1)
        if array.size != place.stop - place.start:
            raise ArgumentError(miscounted(where, array.size, model.speeds[place]))
        if not np.isfinite(array).all():
            raise SolveError(f"{where} is {brief(value)}; it must be finite")
        if set(chosen) & set(range(place.start, place.stop)):
            raise ModelError(f"{where}: given twice, once by joint, once by entry")
        chosen += range(place.start, place.stop)
        values += array.tolist()
    return np.array(chosen, dtype=np.intp), np.array(values)


def _meet(
    m: Mechanism,
    q: Array,
    G: Array,
    desired: Array,
    locked: NDArray[np.intp],
    right: Array,
    names: list[str],
    what: str,
) -> Array:
    """The vector without units next to a wanted one with G v = right and the held entries kept."""
    missing_part, v = right - G @ desired, desired.copy()
    if missing_part.any():
        # the least change of the free entries that closes the gap
        free = np.setdiff1d(np.arange(len(desired)), locked)
        L = _metric(m, q, free)
        step, *_ = np.linalg.lstsq(G[:, free] @ L, missing_part, rcond=m.rank)
        v[free] += L @ step
    left = right - G @ v
    scale = max(1.0, float(np.abs(desired).max(initial=0.0)))
    worst = int(np.abs(left).argmax()) if len(left) else 0
    if len(left) and not abs(left[worst]) <= max(CONSISTENT, m.closure_tol) * scale:
        said = ", ".join(f"'{name}'" for name in names) or "prescribed motions"
        kind = "speeds" if what == "u" else "accelerations"
        raise ModelError(
            f"{kind} of {said} are inconsistent{_separation(m, worst, abs(left[worst]))}. "
            "Leave one of them out"
        )
    return v


def _separation(m: Mechanism, row: int, residual: float) -> str:
    """Name the joint that would come apart; "" where a row is not a constraint."""
    if row >= len(m.closing.rows):
        return ""
    multiplier = m.closing.rows[row]
    return f": joint '{multiplier.joint}' would come apart at {residual * m.rows[row]:.3g} in " + (
        f"'{multiplier.name}'"
    )


def _metric(m: Mechanism, q: Array, free: NDArray[np.intp]) -> Array:
    """L with L L^T the inverse mass matrix of the free speeds, without units; else the identity."""
    M = m.mass(q)
    return np.eye(len(free)) if M is None else inverse_root(M[np.ix_(free, free)])


def inverse_root(M: Array) -> Array:
    """L with L L^T the inverse of a mass matrix (n, n), which bounds what has hardly any mass."""
    values, vectors = np.linalg.eigh(M)
    least = 1e-9 * max(float(values.max(initial=0.0)), 1e-300)
    return np.asarray(vectors / np.sqrt(np.maximum(values, least)))
