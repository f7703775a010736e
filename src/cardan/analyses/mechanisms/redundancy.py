"""Redundant constraints, and what that leaves undetermined."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import compress
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...arguments import checked
from ...arrays import Array
from ...records import dataclass
from ...runtime.calls.evaluation import State
from ...runtime.models.initial import start_of
from ...runtime.models.loaded_model import LoadedModel
from ...schema.entries import MultiplierRow
from .mechanism import Mechanism
from .self_stress import COMPONENTS, RANK, determined, holds, passed

UNIQUE = 1e-7
SHARE = 0.2  # entries below this part of the largest are not told
FORMS = {"p": "translation along {}", "r": "rotation about {}"}
# fourth-order central differences: step without units, weights by its multiples, rounding left
NEARBY = 1e-3
DIFFERENCE = {1: 2 / 3, -1: -2 / 3, 2: -1 / 12, -2: 1 / 12}
ROUNDING = 1e-9


@final
@dataclass(frozen=True, repr=False, eq=False)
class Redundancy:
    """Rank and redundancy of the constraints at a position.

    Attributes:
        name: Of the model.
        freedoms: Degrees of freedom: speeds that all constraints allow.
        constraints: Number of constraints.
        rank: How many of them are independent here.
        loops: Cut joint or constraint -> (constraints, rank of them alone).
        left_out: Those of the constraints that the motion of their loop fulfills by itself: the
            model has no multipliers for them.
        directions: Redundant conditions in words, one for each redundant constraint.
        vectors: The same as combinations of the multipliers, then of what is left out
            (redundant, m): self-stresses. 0 at what its element does not hold in its mode.
        unique: Multiplier, or constraint that is left out -> whether it is determined.
        components: Joint -> which components of its reaction are, in the order of
            ``model.reaction``: Mx, My, Mz, Fx, Fy, Fz.
        singular_values: Of the Jacobian without units, from the largest (min(m, nu),).
    """

    name: str
    freedoms: int
    constraints: int
    rank: int
    loops: Mapping[str, tuple[int, int]]
    left_out: tuple[str, ...]
    directions: tuple[str, ...]
    vectors: Array
    unique: Mapping[str, bool]
    components: Mapping[str, tuple[bool, ...]]
    singular_values: Array

    @property
    def redundant(self) -> int:
        """Number of constraints that could be left out."""
        return self.constraints - self.rank

    @property
    def joints(self) -> Mapping[str, bool]:
        """Joint -> whether its whole reaction is determined."""
        return {name: all(determined) for name, determined in self.components.items()}

    @property
    def undetermined(self) -> list[str]:
        """Reaction components that are not determined, one line for joints alike."""
        alike: dict[str, list[str]] = {}
        for name in self.components:
            alike.setdefault(self.released(name), []).append(name)
        alike.pop("", None)
        return [
            f"reactions not determined: {', '.join(names)} ({components})"
            for components, names in alike.items()
        ]

    @checked
    def released(self, joint: str) -> str:
        """Components of the reaction of a joint that are not determined: ``"Mx, My, Fz"``.

        Returns:
            ``""`` where all are, as those of joints in no loop.
        """
        components = self.components.get(joint, ())
        return ", ".join(
            name for name, determined in zip(COMPONENTS, components, strict=False) if not determined
        )

    def __repr__(self) -> str:
        lines = [
            f"'{self.name}': {self.constraints} constraints, {self.rank} independent, "
            f"{self.redundant} redundant; {self.freedoms} "
            f"degree{'s' if self.freedoms != 1 else ''} of freedom"
        ]
        lines += [f"  redundant: {direction}" for direction in self.directions]
        lines += [f"  {line}" for line in self.undetermined]
        firm = [name for name, determined in self.joints.items() if determined]
        if firm and self.undetermined:
            lines.append(f"  reactions determined: {', '.join(firm)}")
        return "\n".join(lines)


@checked
def redundancy(
    model: LoadedModel,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    *,
    t: float = 0.0,
    r: State | None = None,
    s: State | None = None,
) -> Redundancy:
    """Find the redundant constraints of a closed system at a position.

    Args:
        model: The compiled model.
        q: An assembled position: coordinates (nq,) or by name; where the model starts if left out.
        t, r: Time [s] and inputs, where something is prescribed.
        s: Modes of elements (ns,) or by name, ``{"brake": 2}``; where a run begins if left out.
            What an element holds in other modes only does not count.

    Raises:
        ModelError: an unknown name.
    """
    return report(Mechanism(model, t, r, s), position(model, q))


def undetermined(model: LoadedModel, q: Array, t: float = 0.0) -> tuple[str, ...]:
    """Lines on the reactions that constraints do not determine at a position (nq,) and time [s]."""
    return tuple(report(Mechanism(model, t), q).undetermined) if bound(model) else ()


def bound(model: LoadedModel) -> bool:
    """True when constraints bind a model whose rows are known."""
    rows, available = model.manifest.multipliers, model.manifest.available
    return bool(model.manifest.cuts) or bool(rows and "constraint_jacobian" in available)


def position(model: LoadedModel, q: object) -> Array:
    """Coordinates (nq,) from an array, from names, or where the model starts."""
    if q is not None and not isinstance(q, Mapping):
        coordinates: Array = model._vector("q", q)
        return coordinates
    return start_of(model, q or {}, {})[0][: model.nq]


def rank_of(singular_values: NDArray[Any]) -> int:
    """Number of singular values that are not zero."""
    largest = float(singular_values.max(initial=0.0))
    return int(np.sum(singular_values > RANK * largest))


def report(m: Mechanism, q: Array) -> Redundancy:
    """The report of a mechanism at a position (nq,)."""
    active = holds(m, q)
    G, active_rows = m.jacobian(q)[active], list(compress(m.closing.rows, active))
    U, s, _ = np.linalg.svd(G, full_matrices=True)
    rank, left_out = rank_of(s), _left_out(m)
    rows = [*active_rows, *left_out]
    if left_out:
        U = np.linalg.svd(np.concatenate([G, _slopes(m, q, left_out)]), full_matrices=True)[0]
    # left null space of G: combinations of constraint forces that move nothing
    vectors = _plain(U[:, rank:].T)
    unique = {
        str(row.name): bool(np.abs(vectors[:, k]).max(initial=0.0) < UNIQUE)
        for k, row in enumerate(rows)
    }
    unique |= {str(row.name): True for row in compress(m.closing.rows, ~active)}
    owners = np.array([row.joint for row in active_rows])
    loops = {owner: (n, n) for owner, n in _solved(m).items()}
    # rank of the rows of each loop by itself
    for owner in dict.fromkeys(owners.tolist()):
        values = np.linalg.svd(G[owners == owner], compute_uv=False)
        rank_of_all = int(np.sum(values > RANK * float(s.max(initial=0.0))))
        loops[owner] = int(np.sum(owners == owner)), rank_of_all
    for row in left_out:
        count, rank_of_all = loops.get(row.joint, (0, 0))
        loops[row.joint] = count + 1, rank_of_all
    solved = sum(_solved(m).values())
    components = determined(m, q)
    return Redundancy(
        name=m.model.name,
        freedoms=G.shape[1] - rank,
        constraints=len(rows) + solved,
        rank=rank + solved,
        loops=loops,
        left_out=tuple(row.name for row in left_out),
        directions=tuple(_description(vector, rows, len(active_rows)) for vector in vectors),
        vectors=_with_zeros(vectors, active),
        unique=unique,
        components=_of_circuits(m, unique) if components is None else components,
        singular_values=s,
    )


def _with_zeros(vectors: Array, active: NDArray[np.bool_]) -> Array:
    """Combinations of what holds and what is left out, with zeros for what does not hold."""
    ones = np.ones(vectors.shape[1] - int(active.sum()), bool)
    full = np.zeros((len(vectors), len(active) + len(ones)))
    full[:, np.concatenate([active, ones])] = vectors
    return full


def _left_out(m: Mechanism) -> list[MultiplierRow]:
    """Conditions that the motion of their loop fulfills by itself, as rows of multipliers."""
    return [
        MultiplierRow(name=row.name, unit=row.unit, joint=cut.name, level="position")
        for cut in m.cuts
        for row in cut.left_out
    ]


def _solved(m: Mechanism) -> dict[str, int]:
    """Loops in closed form, and how many conditions each of them fulfills."""
    counts: dict[str, int] = {}
    for joint in m.model.manifest.joints:
        if solved := joint.solved:
            counts[solved.loop] = counts.get(solved.loop, 0) + len(solved.u)
    return counts


def _slopes(m: Mechanism, q: Array, left_out: Sequence[MultiplierRow]) -> Array:
    """G (k, nu), without units, of what is left out, by central differences along the speeds.

    Zeros where loops are in closed form: the joints that follow fulfill it.
    """
    slopes = np.zeros((len(left_out), m.nu))
    if "closure" not in m.model.manifest.available:
        return slopes
    steps = NEARBY * np.eye(m.nu)
    values = {
        k: np.array([m.evaluate("closure", m.advance(q, k * step)) for step in steps])
        for k in DIFFERENCE
    }
    entries = m.model.manifest.functions["closure"].outputs[0].entries
    for n, row in enumerate(left_out):
        if row.name in entries:
            k = entries.index(row.name)
            along = sum(weight * values[step][:, k] for step, weight in DIFFERENCE.items())
            slopes[n] = along / NEARBY / (m.size if row.unit == "N" else 1.0)
    return np.where(np.abs(slopes) > ROUNDING, slopes, 0.0)


def _of_circuits(m: Mechanism, unique: Mapping[str, bool]) -> dict[str, tuple[bool, ...]]:
    """Same as :func:`.self_stress.determined` where joints are not known by their poses:

    a self-stress is taken to load every joint of its loop in full.
    """
    rows = [*m.closing.rows, *_left_out(m)]
    undetermined = {row.joint for row in rows if not unique[row.name]}
    unique_joints: dict[str, bool] = {}
    for cut in m.cuts:
        for joint in passed(cut):
            unique_joints[joint] = unique_joints.get(joint, True) and cut.name not in undetermined
    return {joint: (is_unique,) * len(COMPONENTS) for joint, is_unique in unique_joints.items()}


def _plain(vectors: Array) -> Array:
    """A basis of the same space with as many zeros as elimination gives, largest entry 1."""
    if not vectors.size:
        return vectors
    basis, row = vectors.copy(), 0
    for column in range(basis.shape[1]):
        if row == len(basis):
            break
        best = row + int(np.abs(basis[row:, column]).argmax())
        if abs(basis[best, column]) < 1e-6:
            continue
        basis[[row, best]] = basis[[best, row]]
        basis[row] /= basis[row, column]
        remaining = np.arange(len(basis)) != row
        basis[remaining] -= np.outer(basis[remaining, column], basis[row])
        row += 1
    largest = np.take_along_axis(basis, np.abs(basis).argmax(axis=1)[:, None], axis=1)
    return np.asarray(basis / np.where(largest == 0, 1.0, largest))


def _description(vector: Array, rows: Sequence[MultiplierRow], count: int) -> str:
    """A combination of constraints in words: ``translation along y of joint 'J3'``.

    Args:
        vector: Entries of the rows (n,).
        rows: Constraints, then conditions that the motion of a loop fulfills by itself.
        count: How many are constraints.
    """
    descriptions: list[tuple[str, str]] = []  # part, owner
    sizes = np.abs(vector).round(9) / np.abs(vector).max()

    # a translation first, if it has much of it
    def order(k: int) -> tuple[bool, float]:
        return sizes[k] < 0.5 or rows[k].unit != "N", -float(sizes[k])

    for k in sorted(np.flatnonzero(sizes >= SHARE).tolist(), key=order):
        descriptions.append(_phrase(rows[k]))
    first, owner = descriptions[0]
    if len(descriptions) == 1 and sizes.argmax() >= count:
        return f"{first}{owner} (its loop moves in a group that holds it)"
    further = [part if other == owner else part + other for part, other in descriptions[1:]]
    count_left = f" (it follows from {', '.join(further)} and the other joints)" if further else ""
    return f"{first}{owner}{count_left}"


def _phrase(row: MultiplierRow) -> tuple[str, str]:
    """A constraint and whose it is: ``'stick'`` and `` of force 'brake'``."""
    owner, name = str(row.joint), str(row.name)
    if name == owner:
        return f"constraint '{name}'", ""
    part = name.removeprefix(f"{owner}.")
    form = FORMS.get(part[:1]) if len(part) == 2 and part[1] in "xyz" else None
    kind = "force" if row.switched else "joint"
    return form.format(part[1]) if form else f"'{part}'", f" of {kind} '{owner}'"
