"""Where constraints do not determine the reactions of a joint, and what is given there instead."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from math import prod

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arrays import Array
from ...errors import SolveWarning, warn
from ...records import dataclass
from ...runtime.calls.evaluation import State, Values
from ...runtime.calls.parameters import Parameters
from ...runtime.models.loaded_model import LoadedModel
from .mechanism import Mechanism
from .redundancy import Redundancy, bound, report
from .self_stress import RANK, of_least_norm

SHARED = "constraints='perturbed' shares the others by compliance"
ELASTIC = "with a beam in place of one of its bodies elasticity shares the others"
JACOBIAN = ("constraint_jacobian", None)


@dataclass
class Determinacy:
    """What calls so far have told of the reactions of a model.

    Attributes:
        per_unit: What makes its constraint Jacobian one without units (m, nu); None where no
            constraint leaves reactions undetermined.
        rank: Largest rank of its constraints at any state.
        joints: Joint of a loop -> whether its reaction is determined where they have that rank.
        reported: Joints whose reactions a warning said to be undetermined.
    """

    per_unit: Array | None
    rank: int = -1
    joints: Mapping[str, bool] = field(default_factory=dict)
    reported: set[str] = field(default_factory=set)

    @staticmethod
    def of(model: LoadedModel) -> Determinacy:
        """That of a model, which stays with it."""
        if Determinacy not in model._derived:
            treatment = model.manifest.scene.treatment
            rests = any(cut.left_out for cut in model.manifest.cuts)
            per_unit = None
            if bound(model) and (not treatment or treatment.exact or rests):
                m = Mechanism(model)
                per_unit = m.columns / m.rows[:, None]
            model._derived[Determinacy] = Determinacy(per_unit)
        determinacy: Determinacy = model._derived[Determinacy]
        return determinacy


class States:
    """States of a model.

    Args:
        model: The compiled model.
        lead: Their leading axes; numbers of states count through these.
        q, t, r, parameters, s: As functions of the model take them (..., nq), (...), (..., nr),
            by name (...), (..., ns).
    """

    def __init__(
        self,
        model: LoadedModel,
        lead: tuple[int, ...],
        q: State,
        t: ArrayLike,
        r: State | None,
        parameters: Values | None,
        s: State | None = None,
    ) -> None:
        def rows(values: ArrayLike, size: int) -> Array:
            return np.broadcast_to(values, (*lead, size)).reshape(prod(lead), size)

        self.model = model
        self.q = rows(model._vector("q", q), model.nq)
        self.t = rows(np.reshape(0.0 if t is None else t, (*np.shape(t), 1)), 1)[:, 0]
        self.r = None if r is None else rows(model._vector("r", r), model.nr)
        self.s = None if s is None else rows(model._vector("s", s), len(model._layout.start("s")))
        vector = model._parameters.changed(parameters or {})
        self.parameters = rows(vector, vector.shape[-1])
        self._models = {model.parameters.vector.tobytes(): model}

    def __len__(self) -> int:
        return len(self.q)

    def mechanism(self, k: int) -> Mechanism:
        """The mechanism with the time, the inputs and the parameters of a state."""
        key = self.parameters[k].tobytes()
        if key not in self._models:
            changed = Parameters(self.model.manifest, self.parameters[k])
            self._models[key] = self.model._with(changed)
        r, s = (None if block is None else block[k] for block in (self.r, self.s))
        return Mechanism(self._models[key], float(self.t[k]), r, s)

    def report(self, k: int) -> Redundancy:
        """Redundancy at a state."""
        return report(self.mechanism(k), self.q[k])


@dataclass(frozen=True, eq=False)
class Undetermined:
    """States at which the reaction of a joint is not determined.

    Attributes:
        joint: Its name.
        joints: Names of all joints of loops.
        states: Number of a state -> mechanism and q (nq,).
    """

    joint: str
    joints: Sequence[str]
    states: Mapping[int, tuple[Mechanism, Array]]

    def least(self, reactions: Mapping[str, Array]) -> Array:
        """The reaction (..., 6) with least norm at these states.

        Args:
            reactions: Of all joints of loops (..., 6).
        """
        result = np.array(reactions[self.joint])
        rows = {name: np.reshape(x, (-1, 6)) for name, x in reactions.items()}
        flat = result.reshape(-1, 6)
        for k, (m, q) in self.states.items():
            flat[k] = of_least_norm(m, q, {n: x[k] for n, x in rows.items()})[self.joint]
        return result


def undetermined_reaction(
    model: LoadedModel,
    joint: str,
    lead: tuple[int, ...],
    q: State,
    t: ArrayLike,
    r: State | None,
    parameters: Values | None,
) -> Undetermined | None:
    """The states at which the reaction of a joint is not determined; None where all determine it.

    The first, the middle and the last state at which constraints have their largest rank tell it
    for all of these; where they have less each tells it for itself. In absolute coordinates, whose
    Jacobians are large, only the first, the middle and the last state of a call are looked at. A
    warning names the joints, each once.

    Args:
        model: The compiled model.
        joint: Whose reaction was asked for.
        lead, q, t, r, parameters: As of :class:`States`.
    """
    determinacy = Determinacy.of(model)
    if determinacy.per_unit is None or not prod(lead):
        return None
    ranks = _ranks(model, determinacy.per_unit, lead, q, t, r, parameters)
    largest = int(ranks.max())
    if largest == determinacy.rank == ranks.min() and determinacy.joints.get(joint, True):
        return None
    states = States(model, lead, q, t, r, parameters)
    if largest > determinacy.rank:
        reports = [states.report(k) for k in _some(np.flatnonzero(ranks == largest))]
        determinacy.rank = largest
        determinacy.joints = {
            name: all(one.joints.get(name, True) for one in reports) for name in reports[0].joints
        }
        _warn(model, determinacy, joint, reports)
    open_states = (ranks == determinacy.rank) & (not determinacy.joints.get(joint, True))
    for k in np.flatnonzero(ranks < determinacy.rank).tolist():
        one, at = states.report(k), f"at state {k}, " if lead else ""
        if not one.joints.get(joint, True):
            _warn(model, determinacy, joint, [one], f" {at}where constraints lose rank")
            open_states[k] = True
    if not open_states.any():
        return None
    here = {k: (states.mechanism(k), states.q[k]) for k in np.flatnonzero(open_states).tolist()}
    return Undetermined(joint, tuple(determinacy.joints), here)


def _ranks(
    model: LoadedModel,
    per_unit: Array,
    lead: tuple[int, ...],
    q: State,
    t: ArrayLike,
    r: State | None,
    parameters: Values | None,
) -> NDArray[np.int_]:
    """Rank of the constraints at every state; in absolute coordinates at three, else the largest.

    Args:
        model: The compiled model.
        per_unit: As :attr:`Determinacy.per_unit`.
        lead, q, t, r, parameters: As of :class:`States`.
    """
    count = prod(lead)
    if not len(per_unit):
        return np.zeros(count, int)
    if not model.manifest.absolute:
        G = model._evaluate(JACOBIAN, (t, q, r), parameters, None)
        return np.broadcast_to(_rank(G * per_unit), lead).ravel()
    states, some = States(model, lead, q, t, r, parameters), _some(np.arange(count))
    values = states.t[some], states.q[some], None if states.r is None else states.r[some]
    few = _rank(model._evaluate(JACOBIAN, values, parameters, None) * per_unit)
    ranks = np.full(count, few.max())
    ranks[some] = few
    return ranks


def _rank(G: Array) -> NDArray[np.int_]:
    """Ranks of Jacobians (..., m, nu) without units, 0 of those that are not finite."""
    s = np.linalg.svd(np.where(np.isfinite(G), G, 0.0), compute_uv=False)
    return np.asarray((s > RANK * s[..., :1]).sum(axis=-1))


def _some(numbers: NDArray[np.intp]) -> list[int]:
    """The first, the middle and the last."""
    return sorted({int(numbers[0]), int(numbers[len(numbers) // 2]), int(numbers[-1])})


def _warn(
    model: LoadedModel,
    determinacy: Determinacy,
    joint: str,
    reports: Sequence[Redundancy],
    at: str = "",
) -> None:
    """One warning of all joints whose reactions are not determined, if that of this one is not."""
    undetermined = {n: one for one in reports for n, firm in one.joints.items() if not firm}
    if joint not in undetermined or joint in determinacy.reported:
        return
    determinacy.reported.update(undetermined)
    alike: dict[str, list[str]] = {}
    for name, one in undetermined.items():
        alike.setdefault(one.released(name), []).append(f"'{name}'")
    components = "; ".join(f"{which} of {', '.join(names)}" for which, names in alike.items())
    rests = any(cut.left_out for cut in model.manifest.cuts)
    warn(
        f"reactions are not determined in {components}{at}: constraints are redundant, "
        f"{undetermined[joint].directions[0]}. There those of least norm are given; all other "
        "components are determined. model.redundancy(q) has the details; "
        f"{ELASTIC if rests or model.manifest.absolute else SHARED}",
        SolveWarning,
    )
