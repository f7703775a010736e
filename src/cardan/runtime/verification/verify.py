"""Check compiled functions against an independent Newton-Euler in NumPy."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, cast

import numpy as np

from ...arguments import Count, Seed, checked
from ...arrays import Array
from ...errors import BuildError, SolveWarning, warn
from ...records import dataclass
from ..calls.objects import Key
from . import constraints, core, samples
from .closed_states import bound, unbound
from .differences import BOUND
from .evaluation import Trial
from .flat_scene import scene_of, unknown
from .loops import singular
from .newton_euler import EMPTY, Scene
from .reference_values import ReferenceValues, drawn, finite, largest, masses, reference_values
from .routes import Check, by_text, check
from .user_constraints import written as constrained

if TYPE_CHECKING:
    from ..models.finite_elements.elements import Elements
    from ..models.loaded_model import LoadedModel

# Speeds up to which M is written out and its eigenvalues looked at; beyond, its products do.
LARGEST = 200
# What the accelerations that constraints of the user ask for follow from.
RATES = {"constraint_rates", "constraint_jacobian", "qdot"}
# States drawn for each that is wanted: the model's own forces may not exist everywhere.
DRAWN = 4
LAWS = "quadrature along elements, and the laws of mechanics"
NEWTON_EULER = "an independent Newton-Euler in NumPy"
SAMPLES = "the numbers of SymPy"
DIFFERENCES = "differences of the constraints"
NOWHERE = "not checked: the forces of the model are nowhere finite"
CHECKED: list[Key] = [(name, None) for name in core.JUDGES]


@dataclass(frozen=True)
class Verification:
    """Checked functions, and their errors.

    Attributes:
        model: Name of the model.
        states: Number of random states.
        checks: One per function.
        judge: What they were compared with.
        regular: Whether nothing says that accelerations have no digits.
    """

    model: str
    states: int
    checks: tuple[Check, ...]
    judge: str = NEWTON_EULER
    regular: bool = True

    @property
    def worst(self) -> float:
        """Largest error of all functions checked; NaN if there are none."""
        return max((c.error for c in self.checks if not c.reason), default=float("nan"))

    @property
    def unchecked(self) -> tuple[str, ...]:
        """Functions for which nothing speaks but, at most, their own expressions."""
        return tuple(c.function for c in self.checks if c.reason)

    @property
    def checked(self) -> tuple[str, ...]:
        """Functions that were checked."""
        return tuple(c.function for c in self.checks if not c.reason)

    def __str__(self) -> str:
        if not self.checks:
            return (
                f"'{self.model}': NOTHING CHECKED: no function is built yet. Each is built and "
                "checked at its first call, or by model.prepare('forward_dynamics')"
            )
        missing = ", ".join(self.unchecked)
        head = f"'{self.model}' at {self.states} random states against {self.judge}"
        lines = [f"{head}; NOT CHECKED: {missing}" if missing else f"{head}: all are checked"]
        for c in self.checks:
            expression_error = (
                "" if np.isnan(c.written) else f" (its own expressions: {c.written:.1e})"
            )
            lines.append(
                f"  {c.function:18} {c.reason + expression_error if c.reason else f'{c.error:.1e}'}"
            )
        return "\n".join(lines)


def verify(
    model: LoadedModel, states: int = 3, seed: int = 1, functions: Iterable[str | Key] | None = None
) -> Verification:
    """Compare functions at random states; those that cannot be checked are named with the reason.

    Args:
        model: Its functions.
        states, seed: How many states, and what they are drawn from.
        functions: Names, or pairs such as ``("pose", "hand")``; by default every one that is
            compiled or was written.

    Raises:
        BuildError: a function differs by more than 1e-9 of the largest term in its equation.
    """
    if functions is None:
        # a folder of the cache may hold more functions than this model was asked for
        keys = [key for key in model._written() if key[0] in model.manifest.available]
    else:
        keys = [(key, None) if isinstance(key, str) else key for key in functions]
    verification = _checked(model, states, seed, keys, functions is None)
    names = None if functions is None else [name for name, of in keys if of is None]
    differences = constraints.checks(model, names, states, seed)
    return _approved(model, _merged(verification, differences, states))


def _merged(
    verification: Verification, differences: Mapping[str, float | str], n: int
) -> Verification:
    """Combined result of both routes at n states:

    the larger error, a reason where there is none.
    """
    checks = {check.function: check for check in verification.checks}
    for name, error in differences.items():
        present = checks.get(name, Check(name, np.nan, "not checked"))
        if isinstance(error, str):
            checks[name] = present if not present.reason else replace(present, reason=error)
        elif present.reason:
            checks[name] = replace(present, error=error, reason="")
        else:
            checks[name] = replace(present, error=max(present.error, error))
    if not differences or verification.checks:
        return replace(verification, checks=tuple(checks.values()))
    return Verification(verification.model, n, tuple(checks.values()), DIFFERENCES)


def _checked(
    model: LoadedModel, states: int, seed: int, keys: Sequence[Key], thoroughly: bool
) -> Verification:
    """Every function by the routes that lead to it.

    Args:
        model, states, seed: As of :func:`verify`.
        keys: Functions.
        thoroughly: Whether C is compared with its expressions where something else judges it too.
    """
    if model.manifest.absolute:
        elements: Elements = model._source.results(model).mesh  # type: ignore[attr-defined]
        return _of_elements(model, elements, states, seed)
    order = [key for key in CHECKED if key in keys]
    order += [key for key in keys if key not in order]
    if samples.samples_of(model):
        sample_checks = [
            Check(key[0], *samples.error(model, key[0]))
            if key in CHECKED
            else _by_text(model, [key], states, seed, samples.NO_NUMBERS)[0]
            for key in order
        ]
        return Verification(
            model.name, len(samples.samples_of(model)), tuple(sample_checks), SAMPLES
        )
    trial = _trial(model, states, seed, keys)
    if isinstance(trial, str):
        return Verification(model.name, 0, tuple(_by_text(model, order, states, seed, trial)))
    if not len(trial.reference.q):
        return Verification(model.name, 0, tuple(_by_text(model, order, states, seed, NOWHERE)))
    checks = tuple(check(trial, key, thoroughly) for key in order)
    # slopes of accelerations are lost with them, asked for together or alone
    slopes = any(of and of.split(":")[0] in core.SOLVED for _, of in keys)
    lost = any(check.reason.endswith(core.SINGULAR) for check in checks)
    if lost or (slopes and singular(trial.reference)):
        warn(_singular_message(model, trial.reference.M), SolveWarning)
        return Verification(model.name, len(trial.reference.q), checks, regular=False)
    return Verification(model.name, len(trial.reference.q), checks)


def _trial(model: LoadedModel, states: int, seed: int, keys: Sequence[Key]) -> Trial | str:
    """A model at states at which it can be judged; or why there are none."""
    reason = unknown(model)
    if reason or not keys:
        return reason
    scene, why = scene_of(model), _unjudged(model)
    solved = scene.nu > model.nu
    if why and solved:
        # without states at which its loops are closed nothing of it can be compared
        return why
    reference = _reference(model, scene, states, seed, circuits=not why and bound(model))
    if bound(model) and not why and reference.bound is None:
        why = (
            "not checked: no position was found in which the loops close to 1e-12 of their "
            "size; redundant conditions of rounded numbers leave more"
        )
        if solved:
            return why
    callable_keys = frozenset([*keys, *model._functions])
    return Trial(model, scene, reference, callable_keys, why.removeprefix("not checked: "))


def _of_elements(
    model: LoadedModel,
    elements: Elements,
    states: int,
    seed: int,
    fresh: Iterable[str] | None = None,
) -> Verification:
    """Functions of every kind of element, by laws and by quadrature.

    Args:
        model, elements: Whose.
        states, seed: As of :func:`verify`.
        fresh: Kinds that have one of these functions are judged; all by default.
    """
    from .finite_elements.elements import check_kinds as by_laws
    from .finite_elements.members import members_of

    kinds = {group.kind.name: group.kind for group in elements.tables.groups}
    symbols = [s for kind in kinds.values() for s in kind.functions.values()]
    # derivatives are written when they are asked for
    requested = [s for kind in kinds.values() for s in kind.derivatives.values()]
    loaded = model._objects._loaded
    if fresh is not None:
        new = set(fresh)
        kinds = {
            n: k
            for n, k in kinds.items()
            if new.intersection(k.functions.values()) or new.intersection(k.derivatives.values())
        }
        symbols = [s for s in symbols if s in loaded]
    symbols += [s for s in requested if s in loaded]
    codes = dict(zip(symbols, model._objects.load(symbols), strict=True))
    checks = []
    for members in members_of(model, elements, codes, seed, states):
        name = members.table.kind.name
        for form, error, why in by_laws(members) if name in kinds else ():
            label = f"{name} {form}"
            entry = (
                Check(label, np.nan, f"not checked: {why}", error) if why else Check(label, error)
            )
            checks.append(entry)
    if fresh is None and elements.tables.ne:
        from ..models.finite_elements.mesh import Mesh
        from .finite_elements.impacts import check_events

        assert isinstance(elements, Mesh)
        for name, of in check_events(model, elements, codes, states, seed).items():
            checks.append(Check(name, np.nan, of) if isinstance(of, str) else Check(name, of))
    return Verification(model.name, states, tuple(checks), LAWS)


def _by_text(
    model: LoadedModel, keys: Sequence[Key], states: int, seed: int, reason: str
) -> list[Check]:
    """Functions that nothing speaks for but what they were written from."""
    trial = Trial(model, EMPTY, drawn(model, states, seed)) if keys else None
    return [by_text(trial, key, reason) for key in keys] if trial else []


def _approved(model: LoadedModel, result: Verification) -> Verification:
    """The result if no function is wrong.

    Raises:
        BuildError: one is.
    """
    wrong = [c for c in result.checks if c.worst > BOUND or (not c.reason and np.isnan(c.error))]
    if wrong:
        by_text = not wrong[0].error > BOUND and wrong[0].written > BOUND
        raise BuildError(
            f"model '{model.name}': the compiled {wrong[0].function} differs from "
            f"{'its own expressions' if by_text else result.judge} by {wrong[0].worst:.1e} of its "
            f"largest term (bound {BOUND:.0e}). This "
            f"is a fault of cardan or of the compiler: please report it with {model.directory}. "
            "Until then try another method= or compiler (CC)"
        )
    return result


@checked
def verify_model(model: LoadedModel, states: Count = 3, seed: Seed = 1) -> Verification:
    """Compare the C with an independent NumPy Newton-Euler; see :mod:`.verify`.

    Raises:
        BuildError: they differ.
    """
    return verify(model, states, seed)


def verify_built(model: LoadedModel, fresh: Iterable[Key]) -> bool:
    """Check functions that were compiled just now, or of which nobody knows what a check said.

    Returns:
        Whether accelerations have digits: False with a warning where the mass matrix is singular.

    Raises:
        BuildError: a function is wrong.
    """
    return verify(model, functions=list(fresh)).regular


def verify_elements(model: LoadedModel, elements: Elements, fresh: Iterable[str]) -> None:
    """Check functions of elements that were compiled just now.

    Args:
        model, elements: Whose.
        fresh: Names of the functions.

    Raises:
        BuildError: one is wrong.
    """
    from .finite_elements.members import STATES

    new = list(fresh)
    verification = _of_elements(model, elements, STATES, 1, new)
    differences: dict[str, float | str] = {}
    if model.manifest.multipliers and any(constraints.binds(name) for name in new):
        differences = constraints.said(constraints.of_elements(model, elements, 3, 1))
    _approved(model, _merged(verification, differences, STATES))


def _unjudged(model: LoadedModel) -> str:
    """Why what binds a model is not judged; "" where it is, or where nothing does."""
    if not bound(model):
        return ""
    if model.nu > LARGEST:
        return f"not checked: loops with more than {LARGEST} speeds"
    if constrained(model) and RATES - set(model.manifest.available):
        return "not checked: the rates of constraints that the user wrote were not asked for"
    return unbound(model)


def _reference(
    model: LoadedModel, scene: Scene, states: int, seed: int, circuits: bool
) -> ReferenceValues:
    """Reference values at some states; M is written out if it is not too large."""
    settings = (
        states,
        seed,
        circuits,
        "applied_forces" in model.saved,
        model.parameters.vector.tobytes(),
    )
    cached = model._objects.reference
    if cached is not None and cached[0] == settings:
        # one function after the other is judged at the same states
        return cast(ReferenceValues, cached[1])
    large = model.nu > LARGEST
    reference = reference_values(model, scene, DRAWN if large else DRAWN * states, seed, circuits)
    reference = reference.only(finite(reference)[: 1 if large else states])
    if large:
        reference = replace(reference, largest=largest(scene, reference))
    else:
        M = masses(scene, reference)
        reference = replace(reference, M=M, largest=np.abs(M).max(axis=(1, 2), initial=0.0))
        if reference.reaction_friction is not None and not singular(reference):
            # friction in the model's own motion, where there is one alone
            reference = replace(reference, f=reference.under(np.zeros_like(reference.h)))
            reference = reference.only(finite(reference))
    model._objects.reference = settings, reference
    return reference


def _singular_message(model: LoadedModel, M: Array | None) -> str:
    """Message about a singular mass matrix, with a remedy."""
    names = ["some joint"]
    if M is not None:
        direction = np.abs(np.linalg.eigh(M[0])[1][:, 0])
        names = [n for n, size in zip(model.speeds, direction, strict=True) if size > 0.1]
    return (
        f"model '{model.name}': the mass matrix is singular: nothing resists a motion of "
        f"{', '.join(names[:6])}. forward_dynamics and simulate give no meaningful numbers; give "
        "the bodies that move there a mass or an inertia, or fix a joint"
    )
