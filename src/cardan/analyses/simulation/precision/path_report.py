"""Cost and exactness of a path: what its points took, and what they miss their equations by."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np

from ....arguments import checked
from ....arrays import Array
from ....errors import SolveError, counted
from ....records import dataclass
from ...continuation.family import Point
from ...continuation.record import BranchRecord, ContinuationRecord

if TYPE_CHECKING:
    from rich.table import Table

TINY = float(np.finfo(float).tiny)
HEADS = ("points", "systems", "halved", "ms/point", "contraction", "residual")


@dataclass(frozen=True)
class BranchCost:
    """Cost and exactness of a branch.

    Attributes:
        name, status: Of the branch.
        points, special_points: How many it has.
        iterations, refused: Linear systems solved, steps that were halved.
        milliseconds: For each point, with stability and special points [ms].
        contraction: The largest of the corrections of a step; 1 would be none.
        residual: The largest of a point, computed anew; NaN where none could be.
        where: What is swept there, by name.
        unchecked: Points at which it could not be computed.
    """

    name: str
    status: str
    points: int
    special_points: int
    iterations: int
    refused: int
    milliseconds: float
    contraction: float
    residual: float
    where: Mapping[str, float]
    unchecked: int


@dataclass(frozen=True)
class PathReport:
    """Cost and exactness of a path and its branches.

    Attributes:
        model: Its name.
        kind: What the path consists of.
        rows: One per branch.
        note: The meaning of the residual.
    """

    model: str
    kind: str
    rows: tuple[BranchCost, ...]
    note: str

    @property
    def residual(self) -> float:
        """The largest residual of all branches."""
        return max((row.residual for row in self.rows if row.residual >= 0), default=math.nan)

    def __repr__(self) -> str:
        branches = counted(len(self.rows), "branch", "branches")
        return (
            f"PathReport('{self.model}': {branches} of {self.kind}, residual {self.residual:.1e})"
        )

    def table(self) -> Table:
        """The report as a table for the terminal."""
        from rich.table import Table
        from rich.text import Text

        title, caption = f"{self.model}: paths of {self.kind}", "; ".join(self._notes())
        table = Table(title=Text(title), caption=Text(caption))
        table.add_column("branch", max_width=24)
        for name in HEADS:
            table.add_column(name, justify="right", no_wrap=True)
        for row in self.rows:
            counts = map(str, (row.points, row.iterations, row.refused))
            numbers = f"{row.milliseconds:.3g}", f"{row.contraction:.2g}", f"{row.residual:.1e}"
            table.add_row(Text(row.name), *counts, *numbers)
        return table

    def _notes(self) -> Iterator[str]:
        """The meaning of residuals, where the largest is, and where none were computed."""
        yield self.note
        worst = [row for row in self.rows if row.residual == self.residual > 0]
        for row in worst[:1]:
            at = ", ".join(f"{name} = {value:.6g}" for name, value in row.where.items())
            yield f"the largest is on '{row.name}' at {at}"
        for row in self.rows:
            if row.unchecked:
                yield f"on '{row.name}' {counted(row.unchecked, 'point')} had none"


@checked
def report(path: ContinuationRecord) -> PathReport:
    """Measure a path: what every branch took and what its points miss; prints a table.

    Residuals are computed anew from the coordinates, forces and loads of every point, special ones
    among them: of equilibria by a system of its own for the parameters there, of positions over all
    conditions of the loops, of cycles by laps of another method. Times are of the following alone.
    """
    from rich.console import Console

    result = measured(path)
    Console().print(result.table())
    return result


def measured(path: ContinuationRecord) -> PathReport:
    """The report of a path, which is not printed."""
    rows = tuple(_measured(branch) for branch in path.branches.values())
    solutions = path.main.solutions
    note = f"residual: {solutions.residual_description}"
    return PathReport(path.model.name, solutions.kind, rows, note)


def _measured(branch: BranchRecord) -> BranchCost:
    """The row of a branch."""
    curve, of = branch.curve, branch.solutions
    points = [place.point for place in curve.places]
    points += [special.place.point for special in curve.special]
    checked_points, rows = list[Point](), list[tuple[Array, Array]]()
    for point in points:
        try:
            rows.append(of.independent_residual(point))
            checked_points.append(point)
        except SolveError:
            continue
    residual, where = math.nan, points[0]
    if rows:
        missed, scales_there = (np.array(columns) for columns in zip(*rows, strict=True))
        # by rows, so that a stiff part hides nothing in a soft one; rows that are 0 miss nothing
        scales = np.maximum(scales_there.max(axis=0, initial=0.0), TINY)
        shares = (missed / scales).max(axis=1, initial=0.0)
        worst = int(shares.argmax())
        residual, where = float(shares[worst]), checked_points[worst]
    return BranchCost(
        branch.name, branch.status, len(branch), len(curve.special), branch.iterations,
        branch.refused, 1e3 * curve.seconds / len(branch), curve.contraction, residual,
        of.values(where), len(points) - len(rows),
    )  # fmt: skip
