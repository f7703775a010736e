"""The places that a frame of a mechanism reaches."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, Seed, checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, near
from ...records import dataclass
from ...runtime.calls.evaluation import State
from ...runtime.models.loaded_model import LoadedModel
from .assemble import assemble_by_constraints
from .branches import branches
from .mechanism import Mechanism, refuse_nodes
from .position_solver import PositionSolver
from .searches import drawn
from .targets import read

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SAMPLES = 1000
AGAIN = 3


@dataclass(frozen=True, repr=False, eq=False)
class WorkspaceRecord:
    """Places reached by the origin of a frame.

    Attributes:
        name, frame: Of the model, and the frame.
        points: In the ground (n, 3) [m].
        q: Coordinates there (n, nq).
        tried: Samples drawn, of which n could be assembled inside all limits.
    """

    name: str
    frame: str
    points: Array
    q: Array
    tried: int

    def __len__(self) -> int:
        return len(self.points)

    @property
    def box(self) -> Array:
        """Least and largest x, y and z (2, 3) [m]."""
        return np.stack([self.points.min(axis=0), self.points.max(axis=0)])

    def __repr__(self) -> str:
        lines = [
            f"workspace of '{self.frame}' of '{self.name}': {len(self)} of {self.tried} samples "
            "assembled"
        ]
        if len(self):
            ends = zip("xyz", *self.box.tolist(), strict=True)
            lines += [f"  {axis} from {low:.6g} to {high:.6g} m" for axis, low, high in ends]
        return "\n".join(lines)


@checked
def workspace(
    model: LoadedModel,
    frame: str,
    *,
    over: Mapping[str, tuple[float, float]] | None = None,
    samples: Count = SAMPLES,
    start: Mapping[str, ArrayLike] | ArrayLike | None = None,
    branch: Mapping[str, object] | None = None,
    seed: Seed = 0,
    t: float = 0.0,
    r: State | None = None,
) -> WorkspaceRecord:
    """Places that the origin of a frame reaches: samples of coordinates, each assembled.

    Args:
        model: The compiled model.
        frame: Whose origin.
        over: Coordinate -> range that is sampled; the others follow from the loops, next to
            those of the nearest sample before. By default everything is drawn inside its limits.
        samples: How many.
        start: Coordinates of the first one.
        branch: Coordinate -> ``"+"``, ``"-"`` or ``(low, high)``, as ``assemble`` takes it.
        seed: Of the samples.
        t, r: Time [s] and inputs, where something is prescribed.

    Raises:
        ModelError: unknown names, or a mechanism that cannot be assembled.
        ArgumentError: no range, no samples.
    """
    if frame not in model.frames:
        raise ModelError(f"workspace: there is no frame '{frame}'.{near(frame, model.frames)}")
    if samples < 1:
        raise ArgumentError(f"samples={samples}: at least one is needed")
    refuse_nodes(model, "workspace")
    m, requested = Mechanism(model, t, r), branches(model, branch or {})
    ranges = {name: _range(model, name, ends) for name, ends in (over or {}).items()}
    first = assemble_by_constraints(model, start=start, branch=branch, t=t, r=r).q
    rng, solutions = np.random.default_rng(seed), list[Array]()
    places = [model.coordinates.index(name) for name in ranges]
    for _ in range(samples):
        values = {name: float(rng.uniform(*ends)) for name, ends in ranges.items()}
        solver = PositionSolver(m, read(m, values))
        near_by = [_nearest(solutions or [first], places, values), first] if ranges else []
        # from a neighbor, else from where that does not lead to the branch
        for begin in (*near_by, *(drawn(m, first, rng) for _ in range(AGAIN if ranges else 1))):
            solution = solver.search(begin)
            if (
                solution.met
                and all(one.holds(solution.q) for one in requested)
                and not m.outside(solution.q)
            ):
                solutions.append(solution.q)
                break
    q = np.array(solutions).reshape(-1, model.nq)
    # assembled positions only: samples that do not assemble are not reached
    points = model.pose(frame, q, t=t, r=m.r)[:, :3, 3] if len(q) else np.zeros((0, 3))
    return WorkspaceRecord(model.name, frame, points, q, samples)


def _range(model: LoadedModel, name: str, ends: object) -> tuple[float, float]:
    if name not in model.coordinates:
        raise ModelError(f"over: there is no coordinate '{name}'.{near(name, model.coordinates)}")
    interval = np.asarray(ends, dtype=np.float64)
    if interval.shape != (2,) or not np.isfinite(interval).all() or interval[0] >= interval[1]:
        raise ArgumentError(f"over: '{name}' has the range {ends!r}; give (low, high)")
    return float(interval[0]), float(interval[1])


def _nearest(positions: list[Array], places: list[int], values: Mapping[str, float]) -> Array:
    """The position with sampled coordinates next to new ones."""
    table = np.array(positions)[:, places]
    return positions[int(np.argmin(np.linalg.norm(table - [*values.values()], axis=1)))]


@checked
def plot(workspace: WorkspaceRecord, path: str | Path | None = None) -> Figure:
    """The places from three sides as a Matplotlib figure, written to ``path`` if given.

    Raises:
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    from ...view.plot import plot_points

    title = f"'{workspace.frame}' of {workspace.name}"
    return plot_points(title, workspace.points, path)
