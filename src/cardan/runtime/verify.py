"""Check compiled functions against an independent Newton-Euler in NumPy."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import BuildError, SolveWarning
from .calling import Array
from .joint_motion import KINDS, REVERSED, Curve, joint_motion
from .newton_euler import Scene, inverse_dynamics, mass_matrix, own
from .objects import Key
from .rotations import PARAMETERS

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
# Inputs go this far from their defaults, as a part of them.
INPUT = 0.3
CHECKED = (
    "mass_matrix",
    "bias",
    "gravity",
    "coriolis",
    "inverse_dynamics",
    "forward_dynamics",
    "qdot",
    "rhs",
)


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
    """

    model: str
    states: int
    checks: tuple[Check, ...]

    @property
    def worst(self) -> float:
        """Largest error of all functions checked; NaN if there are none."""
        return max((c.error for c in self.checks if not c.reason), default=float("nan"))

    @property
    def checked(self) -> tuple[str, ...]:
        """Functions that were checked."""
        return tuple(c.function for c in self.checks if not c.reason)

    def __str__(self) -> str:
        lines = [f"'{self.model}' at {self.states} random states against NumPy Newton-Euler"]
        for c in self.checks:
            lines.append(f"  {c.function:18} {c.reason or f'{c.error:.1e}'}")
        return "\n".join(lines)


@dataclass(frozen=True)
class _Truth:
    """The independent numbers at some states, (n, ...).

    ``M`` is None for large systems; ``largest`` is the size of its entries, (n,).
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

    def only(self, chosen: NDArray[np.intp]) -> _Truth:
        """The same at some of the states."""
        names = ("q", "u", "udot", "tau", "r", "M", "largest", "h", "gravity", "f", "motion")
        found = {name: getattr(self, name) for name in names}
        rows: dict[str, Any] = {k: None if x is None else x[chosen] for k, x in found.items()}
        return replace(self, **rows)


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
    reason = unknown(model)
    if reason or not wanted:
        return Verification(model.name, 0, tuple(Check(n, np.nan, reason) for n in wanted))
    scene = scene_of(model)
    large = model.nu > WHOLE
    truth = _truth(model, scene, DRAWN if large else DRAWN * states, seed)
    truth = truth.only(_finite(truth)[: 1 if large else states])
    if large:
        truth = replace(truth, M=None, largest=_largest(scene, truth))
    else:
        M = mass_matrix(scene, truth.q, truth.motion)
        truth = replace(truth, M=M, largest=np.abs(M).max(axis=(1, 2), initial=0.0))
    checks = tuple(_check(model, scene, truth, name) for name in wanted)
    result = Verification(model.name, len(truth.q), checks)
    if any(c.reason == SINGULAR for c in checks):
        warnings.warn(_singular_words(model, truth.M), SolveWarning, stacklevel=2)
    wrong = [c for c in checks if not c.reason and not c.error <= BOUND]
    if wrong:
        raise BuildError(
            f"model '{model.name}': the compiled {wrong[0].function} differs from an independent "
            f"Newton-Euler by {wrong[0].error:.1e} of its largest term (bound {BOUND:.0e}). This "
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


def unknown(model: CompiledModel) -> str:
    """Why the scene of a model cannot be judged; "" if it can."""
    manifest = model.manifest
    scene = manifest.get("scene") or {}
    if not scene or "scene" not in model.saved:
        return "not checked: the directory holds no scene"
    reasons = [str(r) for r in scene.get("unknown", [])]
    for joint, kind, rotation in zip(
        manifest["joints"], scene["kinds"], scene["rotations"], strict=True
    ):
        if kind.removeprefix(REVERSED) not in KINDS:
            reasons.append(f"joint '{joint['name']}' is {kind}")
        elif rotation is not None and rotation not in PARAMETERS:
            reasons.append(f"joint '{joint['name']}' is described by {rotation}")
    moved = any(joint["prescribed"] for joint in manifest["joints"])
    if moved and "scene_motion" not in model.saved:
        reasons.append("the motion of prescribed joints is not saved")
    return "not checked: " + "; ".join(reasons[:3]) if reasons else ""


def scene_of(model: CompiledModel) -> Scene:
    """The flat scene of a model with its parameter values."""
    joints, scene = model.manifest["joints"], model.manifest["scene"]
    place = {joint["name"]: i for i, joint in enumerate(joints)}
    given = model._evaluate_saved("scene", p=model.parameters.vector)
    numbers = {"axis2": np.zeros((len(joints), 3)), **given}
    leaders = [place[j["coupled"]["leader"]] if j["coupled"] else -1 for j in joints]
    return Scene(
        parents=tuple(scene["parents"]),
        kinds=tuple(scene["kinds"]),
        rotations=tuple(scene["rotations"]),
        q=tuple((j["q"] or (0, 0))[:2] for j in joints),
        u=tuple((j["u"] or (0, 0))[:2] for j in joints),
        leaders=tuple(leaders),
        prescribed=tuple(bool(j["prescribed"]) for j in joints),
        numbers=numbers,
        nu=model.nu,
        curves=tuple(c and _curve(*c) for c in scene.get("curves", ())),
    )


def _curve(breaks: list[float], coefficients: list[list[list[float]]], period: float) -> Curve:
    return Curve(np.array(breaks), np.array(coefficients), period)


def _truth(model: CompiledModel, scene: Scene, states: int, seed: int) -> _Truth:
    """Everything but the mass matrix, which is the costly part."""
    rng = np.random.default_rng(seed)
    q, u = model.split(model.random_state(rng, (states,)))
    udot, tau = rng.uniform(-1, 1, (2, states, model.nu))
    t, p, start = 0.3, model.parameters.vector, model._layout.start("r")
    # near their defaults; rates and accelerations of inputs start from 0 and must not stay there
    r = start + INPUT * np.maximum(1.0, np.abs(start)) * rng.uniform(-1, 1, (states, model.nr))
    motion = None
    if any(scene.prescribed):
        motion = model._evaluate_saved("scene_motion", t=[t], r=r, p=p)["motion"]
        motion = np.broadcast_to(motion, (states, *motion.shape[-2:]))
    still = np.zeros(model.nu)
    h = inverse_dynamics(scene, q, u, still, motion)
    at_rest = None if motion is None else motion * [1.0, 0.0, 0.0]
    gravity = inverse_dynamics(scene, q, still, still, at_rest)
    f = None
    if "applied" in model.saved:
        values = model._evaluate_saved("applied", t=np.array([t]), q=q, u=u, r=r, p=p)
        f = np.broadcast_to(values["f"], h.shape)
    elif model.manifest["scene"].get("forces") == []:
        f = np.zeros_like(h)
    return _Truth(q, u, udot, tau, t, r, None, np.zeros(states), h, gravity, f, motion)


def _push(scene: Scene, truth: _Truth, udot: Array) -> Array:
    """M udot (..., nu), without M."""
    still = None if truth.motion is None else truth.motion * [1.0, 0.0, 0.0]
    return inverse_dynamics(scene, truth.q, np.zeros(scene.nu), udot, still, pull=0.0)


def _largest(scene: Scene, truth: _Truth) -> Array:
    """Size of the entries of M (n,): those of the first joint, which moves the most."""
    first = np.zeros(scene.nu)
    first[:1] = 1.0
    return np.asarray(np.abs(_push(scene, truth, first)).max(axis=-1, initial=0.0))


def _finite(truth: _Truth) -> NDArray[np.intp]:
    """Indices of the states at which every term is a number."""
    terms = [truth.h, truth.gravity] + ([] if truth.f is None else [truth.f])
    return np.flatnonzero(np.isfinite(np.concatenate(terms, axis=-1)).all(axis=-1))


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


def singular(M: Array) -> bool:
    """Whether one of some mass matrices (n, nu, nu) cannot be divided by."""
    values = np.linalg.eigvalsh(M)
    return bool(np.any(values[..., :1] * REGULAR <= values[..., -1:]))


def _check(model: CompiledModel, scene: Scene, truth: _Truth, name: str) -> Check:
    """One function; forces of the model come from its saved Function ``applied``."""
    if not len(truth.q):
        return Check(name, np.nan, "not checked: the forces of the model are nowhere finite")
    if name in ("forward_dynamics", "rhs") and truth.M is not None and singular(truth.M):
        return Check(name, np.nan, SINGULAR)
    if truth.f is None and name in ("inverse_dynamics", "forward_dynamics", "rhs"):
        return Check(name, np.nan, "not checked: the forces of the model are not saved")
    q, u = truth.q, truth.u
    given: dict[str, Any] = {"t": truth.t, "r": truth.r}
    if name == "mass_matrix":
        M = model.mass_matrix(q, **given)
        if truth.M is not None:
            return Check(name, _error(M - truth.M, truth.M))
        push = _push(scene, truth, truth.udot)
        return Check(name, _error((M @ truth.udot[..., None])[..., 0] - push, push))
    if name in ("bias", "gravity", "coriolis"):
        known = {"bias": truth.h, "gravity": truth.gravity, "coriolis": truth.h - truth.gravity}
        states = (q,) if name == "gravity" else (q, u)
        value = getattr(model, name)(*states, **given)
        terms = (truth.h, truth.gravity, _inertial(truth))
        return Check(name, _error(value - known[name], *terms))
    if name == "qdot":
        return Check(name, _rates_error(scene, truth, model.qdot(q, u, **given)))
    if name == "inverse_dynamics":
        value = model.inverse_dynamics(q, u, truth.udot, **given)
        return Check(name, _balance(scene, truth, truth.udot, value))
    if name == "forward_dynamics":
        value = model.forward_dynamics(q, u, tau=truth.tau, **given)
        return Check(name, _balance(scene, truth, value, truth.tau))
    xdot = model.rhs(truth.t, np.concatenate([q, u], axis=-1), truth.r)
    qdot, udot = model.split(xdot)
    error = max(_rates_error(scene, truth, qdot), _balance(scene, truth, udot, np.zeros(model.nu)))
    return Check(name, error)


def _error(difference: Array, *terms: Array) -> float:
    """Largest difference of a state over its largest term, the worst of all states."""
    axes = tuple(range(1, difference.ndim))
    size = np.max([np.abs(term).max(axis=axes, initial=0.0) for term in terms], axis=0)
    worst = np.abs(difference).max(axis=axes, initial=0.0)
    return float(np.max(worst / np.where(size > 0, size, 1.0), initial=0.0))


def _balance(scene: Scene, truth: _Truth, udot: Array, tau: Array) -> float:
    """Residual of M udot + h = f + tau, over the largest product or force in it."""
    f = np.zeros_like(truth.h) if truth.f is None else truth.f
    if truth.M is None:
        push = largest = _push(scene, truth, udot)
    else:
        products = truth.M * udot[:, None, :]
        push, largest = products.sum(axis=-1), np.abs(products).max(axis=-1, initial=0.0)
    residual = push + truth.h - f - tau
    tau = np.broadcast_to(tau, truth.h.shape)
    return _error(residual, largest, truth.h, f, tau, _inertial(truth))


def _inertial(truth: _Truth) -> Array:
    """Size of the products of speeds and masses (n, 1): where they cancel, rounding is left."""
    squares = (truth.u**2).max(axis=-1, initial=0.0)
    return np.asarray(truth.largest * squares)[:, None]


def _rates_error(scene: Scene, truth: _Truth, qdot: Array) -> float:
    """Whether the rates of the coordinates turn and shift every joint as its speeds say.

    A complex step along qdot differentiates the pose of the joint exactly.
    """
    worst = 0.0
    for i in range(len(scene.parents)):
        if scene.prescribed[i] or scene.leaders[i] >= 0:
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
        worst = max(worst, _error(difference, np.concatenate([spin, shift], axis=-1)))
    return worst
