"""Check compiled functions against an independent Newton-Euler in NumPy."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import BuildError, SolveWarning
from . import verify_circuits
from .calling import Array
from .closed_states import bound, unbound
from .joint_motion import joint_motion
from .judged import scene_of, unknown
from .newton_euler import Scene, own
from .objects import Key
from .truth import Truth, finite, largest, masses, push, truth_of
from .verify_circuits import CHECKS, acceleration_error, borne, moved_masses, relative, unbalanced
from .verify_samples import error as sampled
from .verify_samples import samples_of

if TYPE_CHECKING:
    from .compiled import CompiledModel

# Rounding of either side stays below 1e-12 of the largest term even for chains of a hundred bodies;
# a wrong formula is wrong in the first digits. In between lies the bound.
BOUND = 1e-9
SINGULAR = "not checked: the mass matrix is singular"
# Beyond this condition number udot has lost what the bound asks for: M is singular to a program.
REGULAR = 1e13
# Speeds up to which M is written out and its eigenvalues looked at; beyond, its products do.
WHOLE = 200
# States drawn for each that is wanted: the model's own forces may not exist everywhere.
DRAWN = 4
STEP = 1e-30
NEWTON_EULER = "an independent Newton-Euler in NumPy"
SAMPLES = "the numbers of SymPy"
CHECKED = (
    "mass_matrix",
    "bias",
    "gravity",
    "coriolis",
    "inverse_dynamics",
    "forward_dynamics",
    "qdot",
    "rhs",
    *CHECKS,
)
# What circuits bind.
BOUND_BY_CIRCUITS = ("forward_dynamics", "rhs", *CHECKS)


@dataclass(frozen=True)
class Check:
    """One function against the independent route.

    Attributes:
        function: Its name.
        error: Largest difference over the largest term of its equation; NaN if not checked.
        reason: Why it could not be checked, "" if it was.
    """

    function: str
    error: float
    reason: str = ""


@dataclass(frozen=True)
class Verification:
    """What was checked, and how well it agrees.

    Attributes:
        model: Name of the model.
        states: Number of random states.
        checks: One per function.
        judge: What they were compared with.
    """

    model: str
    states: int
    checks: tuple[Check, ...]
    judge: str = NEWTON_EULER

    @property
    def worst(self) -> float:
        """Largest error of all functions checked; NaN if there are none."""
        return max((c.error for c in self.checks if not c.reason), default=float("nan"))

    @property
    def checked(self) -> tuple[str, ...]:
        """Functions that were checked."""
        return tuple(c.function for c in self.checks if not c.reason)

    def __str__(self) -> str:
        lines = [f"'{self.model}' at {self.states} random states against {self.judge}"]
        for c in self.checks:
            lines.append(f"  {c.function:18} {c.reason or f'{c.error:.1e}'}")
        return "\n".join(lines)


def verify(
    model: CompiledModel, states: int = 3, seed: int = 1, functions: Iterable[str] | None = None
) -> Verification:
    """Compare functions at random states; those that cannot be checked are named with the reason.

    Args:
        functions: Names; by default every one that is compiled or was written.

    Raises:
        BuildError: a function differs by more than 1e-9 of the largest term in its equation.
    """
    if functions is None:
        # a folder of the cache may hold more functions than this model was asked for
        known = set(model.manifest["functions"]) & set(model.manifest["available"])
        functions = [name for name in CHECKED if name in known]
    wanted = [name for name in functions if name in CHECKED]
    if samples_of(model):
        found = tuple(Check(name, *sampled(model, name)) for name in wanted)
        return _approved(model, Verification(model.name, len(samples_of(model)), found, SAMPLES))
    reason = unknown(model)
    if reason or not wanted:
        return Verification(model.name, 0, tuple(Check(n, np.nan, reason) for n in wanted))
    scene, why = scene_of(model), _unjudged(model)
    truth = _truth(model, scene, states, seed, circuits=not why and bound(model))
    if bound(model) and not why and truth.bound is None:
        why = (
            "not checked: no position was found in which the circuits close to 1e-12 of their "
            "size; redundant conditions of rounded numbers leave more"
        )
    if why and scene.nu > model.nu:
        return Verification(model.name, 0, tuple(Check(n, np.nan, why) for n in wanted))
    checks = tuple(
        Check(name, np.nan, why)
        if why and name in BOUND_BY_CIRCUITS
        else _check(model, scene, truth, name)
        for name in wanted
    )
    if any(c.reason == SINGULAR for c in checks):
        warnings.warn(_singular_words(model, truth.M), SolveWarning, stacklevel=2)
    return _approved(model, Verification(model.name, len(truth.q), checks))


def _approved(model: CompiledModel, result: Verification) -> Verification:
    """The result if no function is wrong.

    Raises:
        BuildError: one is.
    """
    wrong = [c for c in result.checks if not c.reason and not c.error <= BOUND]
    if wrong:
        raise BuildError(
            f"model '{model.name}': the compiled {wrong[0].function} differs from "
            f"{result.judge} by {wrong[0].error:.1e} of its largest term (bound {BOUND:.0e}). This "
            f"is a fault of cardan or of the compiler: please report it with {model.directory}. "
            "Until then try another method= or compiler (CC)"
        )
    return result


def verify_built(model: CompiledModel, fresh: Iterable[Key]) -> None:
    """Check functions that were compiled just now.

    Raises:
        BuildError: a function is wrong.
    """
    verify(model, functions=[name for name, of in fresh if of is None and name in CHECKED])


def _unjudged(model: CompiledModel) -> str:
    """Why what binds a model is not judged; "" where it is, or where nothing does."""
    if not bound(model):
        return ""
    if model.nu > WHOLE:
        return f"not checked: circuits with more than {WHOLE} speeds"
    return unbound(model)


def _truth(model: CompiledModel, scene: Scene, states: int, seed: int, circuits: bool) -> Truth:
    """What must come out at some states; M is written out if it is not too large."""
    large = model.nu > WHOLE
    truth = truth_of(model, scene, DRAWN if large else DRAWN * states, seed, circuits)
    truth = truth.only(finite(truth)[: 1 if large else states])
    if large:
        return replace(truth, largest=largest(scene, truth))
    M = masses(scene, truth)
    return replace(truth, M=M, largest=np.abs(M).max(axis=(1, 2), initial=0.0))


def _singular_words(model: CompiledModel, M: Array | None) -> str:
    """What nothing resists, and what to do about it."""
    names = ["some joint"]
    if M is not None:
        direction = np.abs(np.linalg.eigh(M[0])[1][:, 0])
        names = [n for n, size in zip(model.speeds, direction, strict=True) if size > 0.1]
    return (
        f"model '{model.name}': the mass matrix is singular: nothing resists a motion of "
        f"{', '.join(names[:6])}. forward_dynamics and simulate give no meaningful numbers; give "
        "the bodies that move there a mass or an inertia, or fix a joint"
    )


def singular(truth: Truth) -> bool:
    """Whether nothing resists some motion that constraints allow."""
    if truth.M is None:
        return False
    inertia = truth.M if truth.bound is None else moved_masses(truth.bound, truth.M)
    values = [np.linalg.eigvalsh(matrix) for matrix in inertia]
    return any(bool(np.any(v[:1] * REGULAR <= v[-1:])) for v in values)


def _check(model: CompiledModel, scene: Scene, truth: Truth, name: str) -> Check:
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
        return "not checked: the forces of the model are nowhere finite"
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
    f = np.zeros_like(truth.h) if truth.f is None else truth.f
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
        now, moved = (joint_motion(scene.told(i), x, ui) for x in (qi, qi + 1j * STEP * ri))
        turning: Any = np.swapaxes(now.rotation, -1, -2) @ (moved.rotation.imag / STEP)
        spin = (now.turn @ ui[..., None])[..., 0]
        found = np.stack([turning[..., 2, 1], turning[..., 0, 2], turning[..., 1, 0]], axis=-1)
        shift = (now.shift @ ui[..., None])[..., 0]
        path = moved.position.imag / STEP
        difference = np.concatenate([found - spin, path - shift], axis=-1)
        worst = max(worst, relative(difference, np.concatenate([spin, shift], axis=-1)))
    return worst
