"""Choose between several ways to assemble a mechanism."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NoReturn

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, brief, near
from ...runtime.models.loaded_model import LoadedModel
from .mechanism import Mechanism

OFFSET = 1e-3  # of the size, and radians: beside a start that may be singular
# singular values of G below this part of the largest are zero: a search for a place where branches
# meet ends the root of rounding beside it
SINGULAR = 1e-7
# step of central differences of G along directions without units, and the rate of change that is
# more than their error and what rounded lengths leave [of the largest singular value]
ASIDE, CURVED = 1e-4, 1e-5
SIGNS = {"+": (0.0, math.inf), "-": (-math.inf, 0.0)}


@dataclass(frozen=True)
class Branch:
    """A range that a coordinate must lie in; an angle up to whole turns.

    Attributes:
        name: Of the coordinate.
        place: In q.
        low, high: The range.
        angle: Whether whole turns do not count.
    """

    name: str
    place: int
    low: float
    high: float
    angle: bool

    def value(self, q: Array) -> float:
        """The coordinate; an angle between -pi and pi."""
        value = float(q[self.place])
        return math.remainder(value, 2 * math.pi) if self.angle else value

    def holds(self, q: Array) -> bool:
        """True when coordinates (nq,) lie on it."""
        value = self.value(q)
        turns = (-1, 0, 1) if self.angle and math.isfinite(self.low + self.high) else (0,)
        return any(self.low <= value + 2 * math.pi * k <= self.high for k in turns)

    def __str__(self) -> str:
        if math.isinf(self.high):
            return f"'{self.name}' > {self.low:g}"
        if math.isinf(self.low):
            return f"'{self.name}' < {self.high:g}"
        return f"'{self.name}' between {self.low:g} and {self.high:g}"


def branches(model: LoadedModel, named: Mapping[str, Any]) -> list[Branch]:
    """Branches out of what the user wrote.

    Raises:
        ModelError: an unknown coordinate. ArgumentError: neither a sign nor a range.
    """
    ranges = []
    for name, value in named.items():
        if name not in model.coordinates:
            raise ModelError(
                f"branch: there is no coordinate '{name}'.{near(name, model.coordinates)}"
            )
        k = model.coordinates.index(name)
        if isinstance(value, str) and value in SIGNS:
            low, high = SIGNS[value]
        elif not isinstance(value, str) and np.shape(value) == (2,) and value[0] < value[1]:
            low, high = float(value[0]), float(value[1])
        else:
            raise ArgumentError(f"branch: '{name}' is {brief(value)}; give '+', '-' or (low, high)")
        ranges.append(Branch(name, k, low, high, model.manifest.coordinates[k].unit == "rad"))
    return ranges


def refuse(requested: Sequence[Branch], positions: Sequence[Array]) -> NoReturn:
    """Raise the error for positions that are all on other branches.

    Raises:
        ModelError: always.
    """
    said = " and ".join(str(branch) for branch in requested)
    values = [
        ", ".join(f"{branch.name} = {branch.value(q):.6g}" for branch in requested)
        for q in positions
    ]
    listed = "; ".join(dict.fromkeys(values[:6])) + ("; ..." if len(values) > 6 else "")
    many = "1 position was" if len(positions) == 1 else f"{len(positions)} positions were"
    raise ModelError(
        f"no assembled position has {said}. {many} found, with {listed}. Ask for one of these "
        "branches, or for more starts="
    )


def refuse_singular(m: Mechanism, q: Array) -> None:
    """Refuse a start at which branches meet, unless all speeds say which one is meant.

    Combinations w of constraints with wᵀ G = 0 are redundant where that holds along the motion as
    well: wᵀ dG(v) v' = 0 for all directions v, v' that G allows. Otherwise the rank is lost here
    alone: branches meet, or nothing moves although G lets it.

    Raises:
        ModelError: the rank of the constraints is lower here than beside the position.
    """
    U, s, Vt = np.linalg.svd(m.jacobian(q))
    rank = int(np.sum(s > SINGULAR * s.max(initial=0.0)))
    W, V = U[:, rank:], Vt[rank:].T
    if not W.size or not V.size:
        return
    steps = ASIDE * V.T
    slopes = [m.jacobian(m.advance(q, v)) - m.jacobian(m.advance(q, -v)) for v in steps]
    curvature = np.stack([W.T @ slope @ V for slope in slopes], axis=1) / (2 * ASIDE)
    curvature = curvature.reshape(W.shape[1], -1)
    lost = int(np.sum(np.linalg.svd(curvature, compute_uv=False) > CURVED * s.max(initial=1.0)))
    if lost == 0:
        return
    # what is lost here, and not what is redundant everywhere
    along = W @ np.linalg.svd(curvature)[0][:, :lost]
    weakest = int(np.abs(along).max(axis=1).argmax())
    raise ModelError(
        f"the start is a singular position: {rank} of {rank + lost} independent constraints hold "
        f"there, branches of the motion meet at joint '{m.closing.rows[weakest].joint}'. Give all "
        "speeds, u=: they say which branch is meant; or start beside it"
    )
