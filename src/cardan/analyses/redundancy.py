"""Constraints that say the same twice, and what that leaves undetermined."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import SolveWarning
from ..runtime.compiled import CompiledModel
from ..runtime.initial import start_of
from .mechanism import Mechanism

Array = NDArray[np.float64]
RANK = 1e-8  # singular values below this part of the largest count as zero
SHARE = 0.2  # entries below this part of the largest are not told
UNIQUE = 1e-7
WORDS = {"p": "translation along {}", "r": "rotation about {}"}


@final
@dataclass(frozen=True, repr=False, eq=False)
class Redundancy:
    """How many conditions are independent at a position.

    Attributes:
        name: Of the model.
        freedoms: Degrees of freedom: speeds that all constraints allow.
        constraints: Number of constraints.
        rank: How many of them are independent here.
        circuits: Cut joint or constraint -> (constraints, rank of them alone).
        directions: What is held twice, in words, one for each redundant constraint.
        vectors: The same as combinations of the constraints (redundant, m): self-stresses.
        unique: Multiplier -> whether it is determined.
        joints: Joint -> whether its reaction is determined, of all joints of the circuits.
        singular_values: Of the Jacobian without units, from the largest (min(m, nu),).
    """

    name: str
    freedoms: int
    constraints: int
    rank: int
    circuits: Mapping[str, tuple[int, int]]
    directions: tuple[str, ...]
    vectors: Array
    unique: Mapping[str, bool]
    joints: Mapping[str, bool]
    singular_values: Array

    @property
    def redundant(self) -> int:
        """Number of constraints that could be left out."""
        return self.constraints - self.rank

    def __repr__(self) -> str:
        lines = [
            f"'{self.name}': {self.constraints} constraints, {self.rank} independent, "
            f"{self.redundant} redundant; {self.freedoms} "
            f"degree{'s' if self.freedoms != 1 else ''} of freedom"
        ]
        lines += [f"  held twice: {words}" for words in self.directions]
        loose = [name for name, unique in self.joints.items() if not unique]
        if loose:
            lines.append(f"  reactions not determined: {', '.join(loose)}")
        firm = [name for name, unique in self.joints.items() if unique]
        if firm and loose:
            lines.append(f"  reactions determined: {', '.join(firm)}")
        return "\n".join(lines)


def redundancy(
    model: CompiledModel,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    *,
    t: float = 0.0,
    r: Any = None,
) -> Redundancy:
    """Which constraints of a closed system are redundant at a position.

    Args:
        model: The compiled model.
        q: An assembled position: coordinates (nq,) or by name; where the model starts if left out.
        t, r: Time [s] and inputs, where something is prescribed.

    Raises:
        ModelError: an unknown name.
    """
    m = Mechanism(model, t, r)
    here = position(model, q)
    G = m.jacobian(here)
    return report(m, G)


def doubt(model: CompiledModel, joint: str, q: Any, t: Any, r: Any) -> None:
    """Warn where the reaction of a joint is not determined at the first, middle and last state.

    Args:
        model: The compiled model.
        joint: Whose reaction was asked for.
        q, t, r: States as functions of the model take them (..., nq), (...), (..., nr).
    """
    treatment = model.manifest["scene"].get("treatment")
    if treatment and not treatment["exact"]:
        return
    states = np.reshape(model._vector("q", q), (-1, model.nq))
    times = np.broadcast_to(np.ravel(t), len(states)) if np.size(t) > 1 else np.ravel(t)
    inputs = None if r is None else np.reshape(model._vector("r", r), (-1, model.nr))
    for k in {0, len(states) // 2, len(states) - 1} if len(states) else ():
        own = None if inputs is None else inputs[min(k, len(inputs) - 1)]
        m = Mechanism(model, float(times[min(k, len(times) - 1)]), own)
        found = report(m, m.jacobian(states[k]))
        if found.joints.get(joint, True):
            return
    words = found.directions[0] if len(states) else ""
    if words:
        warnings.warn(
            f"the reaction of '{joint}' is not determined: constraints of its circuit say the same "
            f"twice, {words}. One of the possible wrenches is given. model.redundancy(q) tells "
            "which reactions are determined; constraints='perturbed' shares them by compliance",
            SolveWarning,
            stacklevel=4,
        )


def position(model: CompiledModel, q: Any) -> Array:
    """Coordinates (nq,) from an array, from names, or where the model starts."""
    if q is not None and not isinstance(q, Mapping):
        found: Array = model._vector("q", q)
        return found
    return start_of(model, q or {}, {})[0][: model.nq]


def rank_of(singular_values: NDArray[Any]) -> int:
    """How many singular values are not zero."""
    largest = float(singular_values.max(initial=0.0))
    return int(np.sum(singular_values > RANK * largest))


def report(m: Mechanism, G: Array) -> Redundancy:
    """The report of a Jacobian (m, nu) without units."""
    rows = m.closing.rows
    U, s, _ = np.linalg.svd(G, full_matrices=True)
    rank = rank_of(s)
    vectors = _plain(U[:, rank:].T)
    unique = {
        str(row["name"]): bool(np.abs(vectors[:, k]).max(initial=0.0) < UNIQUE)
        for k, row in enumerate(rows)
    }
    owners = np.array([row["joint"] for row in rows])
    circuits = {}
    for owner in dict.fromkeys(owners.tolist()):
        part = G[owners == owner]
        values = np.linalg.svd(part, compute_uv=False)
        circuits[owner] = (len(part), int(np.sum(values > RANK * float(s.max(initial=0.0)))))
    return Redundancy(
        name=m.model.name,
        freedoms=G.shape[1] - rank,
        constraints=len(rows),
        rank=rank,
        circuits=circuits,
        directions=tuple(_words(vector, rows) for vector in vectors),
        vectors=vectors,
        unique=unique,
        joints=_joints(m, unique),
        singular_values=s,
    )


def _plain(vectors: Array) -> Array:
    """A basis of the same space with as many zeros as elimination gives, largest entry 1."""
    basis, row = vectors.copy(), 0
    for column in range(basis.shape[1]):
        if row == len(basis):
            break
        best = row + int(np.abs(basis[row:, column]).argmax())
        if abs(basis[best, column]) < 1e-6:
            continue
        basis[[row, best]] = basis[[best, row]]
        basis[row] /= basis[row, column]
        others = np.arange(len(basis)) != row
        basis[others] -= np.outer(basis[others, column], basis[row])
        row += 1
    largest = np.take_along_axis(basis, np.abs(basis).argmax(axis=1)[:, None], axis=1)
    return np.asarray(basis / np.where(largest == 0, 1.0, largest))


def _words(vector: Array, rows: Sequence[Mapping[str, Any]]) -> str:
    """A combination of constraints in words: ``translation along y of joint 'J3'``."""
    told: list[tuple[str, str]] = []
    sizes = np.abs(vector).round(9) / np.abs(vector).max()

    # a translation first, if it has much of it
    def order(k: int) -> tuple[bool, float]:
        return sizes[k] < 0.5 or rows[k]["unit"] != "N", -float(sizes[k])

    for k in sorted(np.flatnonzero(sizes >= SHARE).tolist(), key=order):
        joint, name = str(rows[k]["joint"]), str(rows[k]["name"])
        part = name.removeprefix(f"{joint}.")
        form = WORDS.get(part[:1]) if len(part) == 2 and part[1] in "xyz" else None
        told.append((form.format(part[1]) if form else f"'{part}'", joint))
    first, joint = told[0]
    others = [
        words if owner == joint else f"{words} of joint '{owner}'" for words, owner in told[1:]
    ]
    rest = f" (it follows from {', '.join(others)} and the other joints)" if others else ""
    return f"{first} of joint '{joint}'{rest}"


def _joints(m: Mechanism, unique: Mapping[str, bool]) -> dict[str, bool]:
    """Whether reactions are determined: a self-stress passes through every joint of its circuit."""
    loose = {str(row["joint"]) for row in m.closing.rows if not unique[str(row["name"])]}
    found: dict[str, bool] = {}
    for cut in m.cuts:
        for joint in dict.fromkeys([*cut["circuit"], cut["name"]]):
            found[joint] = found.get(joint, True) and cut["name"] not in loose
    return found
