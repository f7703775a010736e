"""States on the constraints and what binds there, found by the judge of every build itself."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...records import dataclass
from ..models.constraint_projection import size_of
from ..models.initial import start_of
from .flat_scene import motion_of, unknown
from .joint_motion import Array, times
from .loop_constraints import (
    STEP,
    Circuits,
    circuits_of,
    conditions,
    jacobian,
    normalized,
    rates_of,
)

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel
    from .newton_euler import Scene

# Singular values below this part of the largest are those of redundant conditions.
RANK = 1e-9
# Conditions that are missed by more, relative to the size of the mechanism, are not closed.
CLOSED = 1e-12
MOST_STEPS = 40
# Newton's steps turn no joint farther.
LONGEST = 0.7
# In between the initial position and a random one.
NEAR, FAR = 0.05, 0.8


@dataclass(frozen=True)
class Bound:
    """States on the constraints, (n, ...).

    Coordinates and speeds are those of the model, of joints that loops determine, of joints
    that close loops. Conditions on accelerations: ``G [udot, y] + rest = 0`` for some y.

    Attributes:
        q, u: Of everything.
        r: Inputs (n, nr).
        G: (n, m, nu + k) for the speeds of the model, then for those of the joints that close
            loops; joints that loops determine are carried along.
        bias: (n, m), what accelerations of the model do not change.
        carries: Speeds of the tree by those of the model (n, nt, nu).
        rests: Accelerations of the tree at udot = 0, (n, nt).
        missed: How far the saved coordinates of determined joints are from closing, (n,).
    """

    q: Array
    u: Array
    r: Array
    G: Array
    bias: Array
    carries: Array
    rests: Array
    missed: Array

    def only(self, chosen: NDArray[np.intp]) -> Bound:
        """The same at some of the states."""
        return Bound(*(value[chosen] for value in vars(self).values()))


def bound(model: LoadedModel) -> bool:
    """True when anything beyond the tree binds a model."""
    # what modes of elements hold they do not hold where states are judged
    always = [row for row in model.manifest.multipliers if not row.switched]
    return bool(always or model.manifest.cuts)


def unbound(model: LoadedModel) -> str:
    """Why what binds a model cannot be judged; "" if it can."""
    complete = len(model.manifest.scene.closers) == len(model.manifest.cuts)
    return "" if complete else "not checked: the poses of joints that close loops are not saved"


def closed_states(
    model: LoadedModel, scene: Scene, starts: Array, u: Array, t: float, r: Array
) -> Bound | None:
    """States on the constraints near given ones, best conditioned first; None where none is found.

    Args:
        model, scene: What is judged, with its tree.
        starts, u: Coordinates and speeds of the model (n, nq), (n, nu).
        t, r: Time and inputs (n, nr).
    """
    tree = max((first + size for first, size in scene.q), default=0)
    circuits = circuits_of(model.manifest, scene, max(tree, model.nq))
    motion = motion_of(model, t, r)
    if motion is not None:
        motion = np.broadcast_to(motion, (len(starts), *motion.shape[-2:]))
    size, solved = size_of(model), _solved(model)
    q = _started(model, circuits, starts)
    cut_columns = slice(model.nq, max(tree, model.nq))
    if solved:
        saved = dependents(model, q, u, t, r)[0]
        q[:, cut_columns] = np.where(np.isfinite(saved), saved, q[:, cut_columns])
    q, missed = _assembled(circuits, q, motion, size, np.ones(circuits.nu))
    good = np.abs(missed).max(axis=-1, initial=0.0) <= CLOSED * size
    if solved:
        # which of several ways to close is the model's own choice
        saved = dependents(model, q, u, t, r)[0]
        good &= np.isfinite(saved).all(axis=-1)
        q[:, cut_columns] = np.where(good[:, None], saved, q[:, cut_columns])
        closers = (np.arange(circuits.nu) >= scene.nu).astype(float)
        q, missed = _assembled(circuits, q, motion, size, closers)
        good &= np.abs(missed[:, 6 * solved :]).max(axis=-1, initial=0.0) <= CLOSED * size
        closed = np.abs(missed).max(axis=-1, initial=0.0) <= CLOSED * size
        if closed.any():
            # the search ended when enough had closed: of the others it says nothing
            good &= closed
    chosen = np.flatnonzero(good)
    if not len(chosen):
        return None
    worst = np.abs(missed[chosen]).max(axis=-1, initial=0.0) / size
    wide = np.zeros((len(chosen), circuits.nu))
    wide[:, : model.nu] = u[chosen]
    motion = None if motion is None else motion[chosen]
    return _bound(circuits, solved, q[chosen], wide, motion, worst, r[chosen], model.nu)


def closers_at(
    model: LoadedModel, circuits: Circuits, q: Array, t: float, r: object, motion: Array | None
) -> tuple[Array, float]:
    """Coordinates (1, nq) of everything at those of the model (nq,), and what is missed [m, rad].

    Args:
        model, circuits: Whose.
        q, t, r: Where the loops are closed.
        motion: Of prescribed joints, (1, nb, 3).
    """
    full_q = _started(model, circuits, q[None])
    full_q[:, : model.nq] = q
    count = max((first + size for first, size in circuits.scene.q), default=0)
    if _solved(model):
        saved = dependents(model, q[None], np.zeros((1, model.nu)), t, np.asarray(r)[None])[0]
        full_q[:, model.nq : max(count, model.nq)] = saved
    moves = (np.arange(circuits.nu) >= circuits.scene.nu).astype(float)
    full_q, missed = _assembled(circuits, full_q, motion, size_of(model), moves)
    return full_q, float(np.abs(missed).max(initial=0.0))


def _solved(model: LoadedModel) -> int:
    """Number of loops in closed form."""
    joints = model.manifest.joints
    return len({joint.solved.loop for joint in joints if joint.solved})


def _started(model: LoadedModel, circuits: Circuits, starts: Array) -> Array:
    """Everything between the initial position and the starts, (n, nq)."""
    part = np.linspace(NEAR, FAR, len(starts))[:, None]
    first = model.split(start_of(model, {}, {})[0])[0]
    q = np.zeros((len(starts), circuits.nq))
    q[:, : model.nq] = first + part * (starts - first)
    for closer in circuits.closers:
        if closer.joint.rotation:
            q[:, closer.q[0]] = 1.0
    # nothing stands exactly at 0, where joints may be stretched
    waves = np.sin(1.0 + np.arange(circuits.nq - model.nq) + 10 * part)
    q[:, model.nq :] += 0.3 * waves
    return normalized(circuits, q)


def dependents(model: LoadedModel, q: Array, u: Array, t: float, r: Array) -> tuple[Array, Array]:
    """Coordinates and speeds of joints that loops determine, as saved with the model."""
    inputs: dict[str, Any] = {
        "t": np.array([t]),
        "q": q[:, : model.nq],
        "u": u[:, : model.nu],
        "r": r,
    }
    with np.errstate(invalid="ignore"):
        evaluated = model._evaluate_saved("dependents", p=model.parameters.vector, **inputs)
    values, speeds = (np.broadcast_to(evaluated[k], (len(q), evaluated[k].shape[-1])) for k in "qu")
    return values, speeds


def _assembled(
    circuits: Circuits, q: Array, motion: Array | None, size: float, moves: Array
) -> tuple[Array, Array]:
    """Newton's shortest steps of the speeds that move: coordinates, what they miss (n, rows)."""
    rows = 6 * len(circuits.closers)
    if not rows:
        return q, np.zeros((len(q), 0))
    enough, last = False, False
    for _ in range(MOST_STEPS):
        G, _, missed = jacobian(circuits, q, motion)
        closed = np.abs(missed).max(axis=-1) <= CLOSED * size
        # one step more costs little and squares what is missing
        enough, last = 2 * closed.sum() >= len(q), enough
        if last:
            break
        G = G[..., :rows, :] * moves
        square = G @ np.swapaxes(G, -1, -2)
        trace = np.trace(square, axis1=-2, axis2=-1)[:, None, None]
        # redundant conditions hold when the others do
        square = square + (1e-12 * trace + 1e-300) * np.eye(rows)
        step = -times(np.swapaxes(G, -1, -2), np.linalg.solve(square, missed[..., None])[..., 0])
        longest = np.abs(step).max(axis=-1, keepdims=True)
        step = step * np.minimum(1.0, LONGEST / np.maximum(longest, 1e-300))
        q = normalized(circuits, q + rates_of(circuits, q, step))
    return q, missed


def _bound(
    circuits: Circuits,
    solved: int,
    q: Array,
    u: Array,
    motion: Array | None,
    missed: Array,
    r: Array,
    nu: int,
) -> Bound:
    """Speeds that fulfil the conditions, and the conditions on accelerations."""
    G, explicit_rates, _ = jacobian(circuits, q, motion)
    u = u - times(np.linalg.pinv(G, rcond=RANK), times(G, u) + explicit_rates)
    change = None
    if motion is not None:
        later = np.concatenate([motion[..., 1:], 0 * motion[..., :1]], axis=-1)
        change = motion + 1j * STEP * later
    moved = q + 1j * STEP * rates_of(circuits, q, u)
    bias = np.asarray(conditions(circuits, moved, u, change)[1].imag / STEP)
    n, tree = len(q), circuits.scene.nu
    carries, rests = np.broadcast_to(np.eye(nu), (n, nu, nu)), np.zeros((n, nu))
    if solved:
        # joints that are solved close the first loops, with as many unknowns as conditions
        rows = 6 * solved
        last = circuits.closers[solved - 1].u
        unknown = np.r_[nu : last[0] + last[1]]
        back = np.linalg.pinv(G[:, :rows, unknown], rcond=RANK)
        share, fixed = -back @ G[:, :rows, :nu], -times(back, bias[:, :rows])
        bias = bias[:, rows:] + times(G[:, rows:, unknown], fixed)
        reduced = G[:, rows:, :nu] + G[:, rows:, unknown] @ share
        G = np.concatenate([reduced, G[:, rows:, unknown[-1] + 1 :]], axis=-1)
        carries = np.concatenate([carries, share[:, : tree - nu]], axis=1)
        rests = np.concatenate([rests, fixed[:, : tree - nu]], axis=1)
    constraints = Bound(q, u, r, G, bias, carries, rests, missed)
    return constraints.only(best_first(constraints.G))


def best_first(G: Array) -> NDArray[np.intp]:
    """Order of states by their conditions (n, m, k): best conditioned first, singular ones last.

    Where fewer conditions are independent than elsewhere, a position is singular.
    """
    if not G.shape[-2]:
        return np.arange(len(G))
    values = np.linalg.svd(G, compute_uv=False)
    independent = values > RANK * values[:, :1]
    smallest = np.where(independent, values, np.inf).min(axis=-1)
    return np.lexsort((-smallest / values[:, 0], -independent.sum(axis=-1)))


def unjudged(model: LoadedModel) -> str:
    """Why nothing but its own expressions speaks for a model; "" where something does."""
    if model.manifest.absolute or model.manifest.scene.samples:
        return ""
    return unknown(model) or (unbound(model) if bound(model) else "")
