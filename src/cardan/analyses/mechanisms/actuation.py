"""Inverse and hybrid dynamics of closed systems: which actuators carry the load."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from typing import final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arguments import checked
from ...arrays import Array
from ...errors import ArgumentError, SolveError, SolveWarning, near
from ...records import dataclass
from ...runtime.calls.evaluation import State, Values
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.verification.joint_motion import times
from .actuated_states import SHARE, Place, listed, place_of, rounded, too_few

RANK = 1e-9  # singular values below this part of the largest count as zero
LIGHT = 1e-14  # inertia along a motion, relative to the largest, that is none
MET = 1e-7  # what is left of forces or accelerations, relative to their largest terms


@final
@dataclass(frozen=True, repr=False, eq=False)
class Actuation:
    """A motion and the forces that make it: M udot + h = f + tau + Gᵀ lam.

    Attributes:
        name: Of the model.
        actuators: Speeds along which actuators act.
        forces: Of the actuators [N, N m] (..., na).
        tau: All generalized applied forces, those given included (..., nu).
        udot: The accelerations (..., nu).
        multipliers: Forces of constraint (..., m); where constraints are redundant the smallest.
        freedoms: Motions that the actuators have to make, (...).
        rank: How many of the actuators are independent of each other there, (...).
        norm: ``"minimum"`` or ``"weighted"``: which forces were taken where they are not unique.
    """

    name: str
    actuators: tuple[str, ...]
    forces: Array
    tau: Array
    udot: Array
    multipliers: Array
    freedoms: NDArray[np.intp]
    rank: NDArray[np.intp]
    norm: str

    @property
    def unique(self) -> NDArray[np.bool_]:
        """True where no other forces of the actuators make the same motion (...)."""
        return np.asarray(self.rank == len(self.actuators))

    def __getitem__(self, actuator: str) -> Array:
        """Force of one actuator (...).

        Raises:
            ArgumentError: there is none of that name.
        """
        if actuator not in self.actuators and f"{actuator}.u" in self.actuators:
            actuator = f"{actuator}.u"
        if actuator not in self.actuators:
            raise ArgumentError(
                f"'{actuator}' is not an actuator here.{near(actuator, self.actuators)}"
            )
        return np.asarray(self.forces[..., self.actuators.index(actuator)])

    def __repr__(self) -> str:
        count, freedoms = len(self.actuators), int(np.max(self.freedoms, initial=0))
        lines = [f"'{self.name}': {_count(count, 'actuator')}, {_count(freedoms, 'freedom')}"]
        free = int(count - np.min(self.rank, initial=count))
        if free:
            norm = "of least norm" if self.norm == "minimum" else "of least weighted norm"
            lines.append(f"  {_count(free, 'force')} without effect on the motion: those {norm}")
        else:
            lines.append("  forces are unique")
        if self.forces.ndim == 1:
            lines += [f"  {n} = {x:.6g}" for n, x in zip(self.actuators, self.forces, strict=True)]
        return "\n".join(lines)


@checked
def actuation(
    model: LoadedModel,
    q: State,
    u: State,
    udot: State,
    actuators: Sequence[str] | None = None,
    *,
    norm: str | ArrayLike = "minimum",
    t: ArrayLike = 0.0,
    r: State | None = None,
    s: State | None = None,
    parameters: Values | None = None,
) -> Actuation:
    """Forces of actuators that make a motion: inverse dynamics of closed systems.

    Args:
        model: With or without loops.
        q, u, udot: A motion that the constraints allow (..., nq), (..., nu), (..., nu), as
            ``assemble`` and ``sweep`` give it.
        actuators: Joints or speeds along which they act; by default every speed.
        norm: Where more actuators than freedoms leave a choice: ``"minimum"``, the least sum of
            squares, or weights (na,) or a positive definite matrix W (na, na) for least cᵀ W c.
        t, r, parameters: Time, inputs and parameter values.
        s: Modes of elements (..., ns) or by name; those of a start if left out.

    Raises:
        ArgumentError: an unknown actuator; weights that are not positive.
        SolveError: the constraints do not allow the motion, or the actuators cannot make it.

    Source: Roberson and Schwertassek, Dynamics of Multibody Systems, chapter 8.
    """
    place = place_of(model, q, u, {"t": t, "r": r, "s": s, "parameters": parameters})
    motion = model._vector("udot", udot)
    if motion.shape[-1:] != (model.nu,):
        raise ArgumentError(
            f"actuation: udot has the shape {motion.shape}, expected (..., {model.nu}): "
            f"{', '.join(model.speeds[:6])}"
        )
    _refuse_impossible(place, motion)
    chosen = named_speeds(model, actuators)
    return _shared(place, motion, np.zeros(model.nu), chosen, norm)


@checked
def hybrid_dynamics(
    model: LoadedModel,
    q: State,
    u: State,
    udot: Mapping[str, ArrayLike],
    *,
    tau: State | None = None,
    t: ArrayLike = 0.0,
    r: State | None = None,
    s: State | None = None,
    parameters: Values | None = None,
) -> Actuation:
    """Some accelerations are given, the others follow, and so do the forces that it takes.

    Args:
        model: With or without loops.
        q, u: States on the constraints (..., nq), (..., nu).
        udot: Joint or speed -> its acceleration; actuators there provide what it takes.
        tau: Other generalized applied forces (..., nu).
        t, r, parameters: Time, inputs and parameter values.
        s: Modes of elements (..., ns) or by name; those of a start if left out.

    Raises:
        ArgumentError: an unknown joint or speed.
        SolveError: the constraints do not allow these accelerations together.

    Source: R. Featherstone, Rigid Body Dynamics Algorithms, section 9.1.
    """
    place = place_of(model, q, u, {"t": t, "r": r, "s": s, "parameters": parameters})
    chosen, prescribed = _prescribed_accelerations(model, udot)
    applied = np.zeros(model.nu) if tau is None else model._vector("tau", tau)
    # accelerations that keep to the constraints, corrected to those that are wanted
    unforced = model.forward_dynamics(place.q, place.u, tau=applied, **place.arguments)
    # least-norm correction that meets the constraints and the prescribed rows at once
    rows = np.eye(model.nu)[chosen]
    G = place.jacobian
    lead = np.broadcast_shapes(unforced.shape[:-1], G.shape[:-2], prescribed.shape[:-1])
    G, rows, unforced, prescribed = (
        np.broadcast_to(x, (*lead, *x.shape[-k:]))
        for x, k in ((G, 2), (rows, 2), (unforced, 1), (prescribed, 1))
    )
    both = np.concatenate([G, rows], axis=-2)
    change = np.concatenate([np.zeros(G.shape[:-1]), prescribed - unforced[..., chosen]], axis=-1)
    back = _pseudo_inverse(both)[0]
    one = unforced + times(back, change)
    left = one[..., chosen] - prescribed
    if not _small(np.concatenate([left, times(G, one - unforced)], axis=-1), prescribed, unforced):
        names = [model.speeds[i] for i in chosen]
        raise SolveError(
            f"model '{model.name}': the constraints do not allow these accelerations of "
            f"{listed(names)} together; give fewer of them, or those of assemble(...).udot"
        )
    # the balance along the motions that are left; across them anything regular will do
    free = np.eye(model.nu) - back @ both
    M = place.inertia
    size = np.trace(M, axis1=-2, axis2=-1)[..., None, None] / max(1, model.nu)
    inertia = free @ M @ free + size * (np.eye(model.nu) - free)
    missing = times(free, applied - place.force(one))
    motion = one + times(free @ np.linalg.pinv(inertia, rcond=LIGHT, hermitian=True), missing)
    return _shared(place, motion, applied, chosen, "minimum")


def _shared(
    place: Place, udot: Array, applied: Array, chosen: list[int], norm: str | ArrayLike
) -> Actuation:
    """Forces of the chosen speeds that do what given ones leave to do."""
    model, nu = place.model, place.model.nu
    load, G = place.force(udot) - applied, place.jacobian
    lead = np.broadcast_shapes(load.shape[:-1], G.shape[:-2])
    load, G = np.broadcast_to(load, (*lead, nu)), np.broadcast_to(G, (*lead, *G.shape[-2:]))
    # what constraints cannot bear must come from the actuators
    back = _pseudo_inverse(G)[0]
    free = np.eye(nu) - back @ G
    soft, word = _softness(norm, len(chosen))
    most, rank = _pseudo_inverse(free[..., chosen] @ soft)
    forces = times(soft @ most, times(free, load))
    tau = np.zeros((*lead, nu))
    tau[..., chosen] = forces
    left = times(free, load - tau)
    if not _small(left, load, tau) and not rounded(place, udot, left):
        raise SolveError(too_few(place, left, chosen))
    # the multipliers carry the rest, with the least norm
    lam = times(np.swapaxes(back, -1, -2), load - tau)
    return Actuation(
        model.name,
        tuple(model.speeds[i] for i in chosen),
        forces,
        tau + applied,
        np.broadcast_to(udot, (*lead, nu)),
        lam,
        np.rint(np.trace(free, axis1=-2, axis2=-1)).astype(int),
        rank,
        word,
    )


def _pseudo_inverse(A: Array) -> tuple[Array, NDArray[np.intp]]:
    """A⁺ (..., n, m) and the rank of A (..., m, n), from one decomposition."""
    if not A.size:
        return np.swapaxes(np.zeros(A.shape), -1, -2), np.zeros(A.shape[:-2], int)
    U, s, Vt = np.linalg.svd(A, full_matrices=False)
    counted = s > RANK * s[..., :1]
    inverse = np.divide(1.0, s, out=np.zeros_like(s), where=counted)
    inverted = np.swapaxes(Vt, -1, -2) @ (inverse[..., None] * np.swapaxes(U, -1, -2))
    return inverted, counted.sum(axis=-1)


def _softness(norm: str | ArrayLike, count: int) -> tuple[Array, str]:
    """A factor S of the inverse of the weights, W⁻¹ = S Sᵀ, and a word for them."""
    if isinstance(norm, str):
        if norm != "minimum":
            raise ArgumentError(f"norm='{norm}': 'minimum', or weights of the actuators")
        return np.eye(count), norm
    weights = np.asarray(norm, dtype=float)
    if weights.shape == (count,):
        weights = np.diag(weights)
    symmetric = weights.shape == (count, count) and np.allclose(weights, weights.T)
    if not symmetric or not np.linalg.eigvalsh(weights).min(initial=1.0) > 0:
        raise ArgumentError(
            f"norm: weights of {_count(count, 'actuator')} are as many positive numbers, or a "
            "symmetric positive definite matrix"
        )
    return np.linalg.inv(np.linalg.cholesky(weights)).T, "weighted"


def named_speeds(model: LoadedModel, names: Sequence[str] | None) -> list[int]:
    """Speeds of joints or speeds by name, each once."""
    if names is None:
        return list(range(model.nu))
    places: list[int] = []
    for name in [names] if isinstance(names, str) else names:
        places += [i for i in _named(model, name) if i not in places]
    return places


def _named(model: LoadedModel, name: str) -> list[int]:
    rows = model.manifest.speeds
    places = [i for i, row in enumerate(rows) if name in (row.name, row.joint)]
    if not places:
        joints = dict.fromkeys(row.joint for row in rows if row.joint)
        why = ""
        if name in model.joints:
            why = " The joint has no speed of its own here: it is cut, fixed, prescribed or solved."
        raise ArgumentError(
            f"model '{model.name}': '{name}' is neither a joint with speeds nor a speed; those "
            f"with speeds are {', '.join(joints)}.{why or near(name, [*joints, *model.speeds])}"
        )
    return places


def _prescribed_accelerations(
    model: LoadedModel, udot: Mapping[str, ArrayLike]
) -> tuple[list[int], Array]:
    """Speeds whose accelerations are given, and those (..., number of them)."""
    slots, values = list[int](), list[Array]()
    for name, value in udot.items():
        places, array = _named(model, name), np.asarray(value, dtype=float)
        if len(places) == 1:
            array = array[..., None]
        elif array.shape[-1:] != (len(places),):
            raise ArgumentError(
                f"udot['{name}'] has shape {array.shape}, expected (..., {len(places)})"
            )
        slots += places
        values += [array[..., k] for k in range(len(places))]
    if len(set(slots)) < len(slots):
        raise ArgumentError(f"udot names a speed twice: {', '.join(udot)}")
    if not values:
        return [], np.zeros(0)
    return slots, np.stack(np.broadcast_arrays(*values), axis=-1)


def _allowed(place: Place) -> Array | None:
    """Accelerations that the constraints allow; None where none has a force, without any mass.

    Raises:
        SolveError: M is singular, and not 0.
    """
    reason: SolveError | None = None
    with warnings.catch_warnings():
        # what it says of states without a solution is said here
        warnings.simplefilter("ignore", SolveWarning)
        try:
            possible = place.model.forward_dynamics(place.q, place.u, **place.arguments)
            if np.isfinite(possible).all():
                return possible
        except SolveError as error:
            reason = error
    if not np.any(place.inertia):
        return None
    raise SolveError(
        f"model '{place.model.name}': whether the constraints allow these accelerations follows "
        "from those under the forces of the model, but the mass matrix is singular at these "
        "parameters. Give the bodies without mass a small one; the forces change as little"
    ) from reason


def _refuse_impossible(place: Place, udot: Array) -> None:
    """Accelerations must keep to the constraints.

    Raises:
        SolveError: they do not.
    """
    model = place.model
    if not model.nlam:
        return
    possible = _allowed(place)
    if possible is None:
        return
    G = place.jacobian
    left = times(G, udot - possible)
    if not _small(left, times(np.abs(G), np.abs(udot)), times(np.abs(G), np.abs(possible))):
        size = np.abs(left).reshape(-1, left.shape[-1]).max(axis=0)
        names = [
            n for n, x in zip(model.multipliers_of, size, strict=True) if x > SHARE * size.max()
        ]
        raise SolveError(
            f"model '{model.name}': the constraints {listed(names)} do not allow these "
            f"accelerations, by {size.max():.3g}; assemble(...).udot and sweep(...) give some that "
            "they do, hybrid_dynamics finds the rest to a few that are given"
        )


def _small(left: Array, *terms: Array) -> bool:
    """True when a rest is nothing beside the largest term of its state."""
    most = [np.abs(term).max(axis=-1, initial=0.0) for term in terms]
    size = np.maximum.reduce(np.broadcast_arrays(*most))
    return bool(np.all(np.abs(left).max(axis=-1, initial=0.0) <= MET * np.maximum(size, 1e-12)))


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"
