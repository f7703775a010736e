"""Runs of a combination by two routes that must agree: joint coordinates and nodes."""

from __future__ import annotations

import functools
import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

import cardan as cd

from .features import mechanism
from .mechanism import SPAN, Mechanism
from .refusals import expected

FINE = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-12}
TIMES = np.linspace(0.0, SPAN, 7)
OUTPUTS = tuple(f"{place}_{axis}" for place in ("tip", "hand") for axis in "xyz")
# of places of about 1 m: what two integrations with 1e-10 of a step leave, sticking and impacts
# between
NEAR = 1e-6
# features with coordinates of their own beside those of joints
FLEXIBLE = {"beam", "superelement"}
Names = tuple[str, ...]


@dataclass(frozen=True)
class Route:
    """A compiled combination.

    Attributes:
        made: The scene and its inputs.
        model: The model in one kind of coordinates.
    """

    made: Mechanism
    model: cd.CompiledModel

    @property
    def start(self) -> dict[str, dict[str, Any]]:
        """Coordinates and speeds of its joints at the start.

        Loops are closed at the nearest place, which every route finds to the root of rounding only.
        """
        q, u, _ = self.model.parts_of(self.model.initial())
        rows = self.model.manifest.joints
        return {
            "q": {row.name: q[row.q[0] : sum(row.q)] for row in rows if row.q and row.q[1]},
            "u": {row.name: u[row.u[0] : sum(row.u)] for row in rows if row.u and row.u[1]},
        }

    def run(self, **options: Any) -> cd.Trajectory:
        """A motion with the inputs of the scene."""
        inputs = self.made.inputs or None
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", cd.SolveWarning)
            return self.model.simulate(
                options.pop("t", [*TIMES]),
                inputs=inputs,
                **(options if "method" in options else FINE | options),
            )


@functools.lru_cache(maxsize=8)
def route(
    names: Names, coordinates: str = "auto", without: str | None = None, by_conditions: bool = False
) -> Route:
    """A combination in one kind of coordinates."""
    made = mechanism(names, without, by_conditions)
    return Route(made, cd.compile(made.scene, coordinates=coordinates))


def other_route(names: Names) -> Route:
    """The route that is compared with: everything in nodes; joint by joint where nodes refuse.

    Frames of superelements are bodies there that conditions place among the interfaces.

    Raises:
        DerivationError: a refusal that is not on the list.
    """
    try:
        return route(names, "absolute", by_conditions=True)
    except cd.DerivationError as problem:
        expected(names, "absolute", str(problem))
    made = mechanism(names)
    equations = cd.derive(made.scene, coordinates="relative", method="newton_euler", rewrites=())
    return Route(made, cd.compile(equations))


def places(motion: cd.Trajectory) -> Any:
    """The outputs of a motion at the times (times, outputs)."""
    return np.column_stack([np.asarray(motion[name]) for name in OUTPUTS])


def happened(motion: cd.Trajectory) -> list[tuple[str, float]]:
    """Events in order, those of one time by name."""
    return sorted(
        ((event.name, event.t) for event in motion.events), key=lambda e: (round(e[1], 6), e[0])
    )


def apart(mine: cd.Trajectory, theirs: cd.Trajectory, near: float = NEAR) -> str:
    """What differs between two motions; "" where nothing does."""
    for motion in (mine, theirs):
        if not motion.success:
            return f"{motion.status}: {motion.message}"
    gap = np.abs(outputs_at(mine) - outputs_at(theirs)).max(axis=0)
    worst = int(gap.argmax())
    if not gap[worst] < near:
        return f"{OUTPUTS[worst]} differs by {gap[worst]:.2e}"
    ours, other = happened(mine), happened(theirs)
    if [name for name, _ in ours] != [name for name, _ in other]:
        return f"events differ: {ours} and {other}"
    late = max((abs(a - b) for (_, a), (_, b) in zip(ours, other, strict=True)), default=0.0)
    return f"times of events differ by {late:.2e}" if late > 10 * near else ""


def outputs_at(motion: cd.Trajectory) -> Any:
    """Outputs at the last times (the rows behind a change)."""
    rows = [int(np.flatnonzero(motion.t == t)[-1]) for t in TIMES if (motion.t == t).any()]
    return places(motion)[rows]
