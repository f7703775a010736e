"""The equilibria of a load path, as a record."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from pathlib import Path
from typing import Any

import numpy as np

from ...arguments import checked
from ...arrays import Array, Integers
from ...errors import ModelError, SolveWarning, counted, near, warn
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.wrenches import force_names, force_part, reaction_part
from ...runtime.trajectory.solver_info import FINISHED
from ...schema.rows import column
from .continuation_step import Crossing, Place
from .critical_load import located
from .equilibrium import EquilibriumRecord
from .load_path import Loading
from .static_problem import Problem

MAX_PRINTED = 12
SAID = {
    "held": "stability changes",
    "dead load": "stability under dead loads changes",
    "limit": "limit load",
}


@dataclass(frozen=True, repr=False, eq=False)
class StaticPathRecord:
    """Equilibria under loads that change; ``path["elbow"]`` is a history (n,) by name.

    ``path[k]`` is the equilibrium of row k; ``model.simulate(10, x0=path[-1])`` starts there.

    Attributes:
        loading: What was swept.
        s: Place of every row on the path, 0 to 1 (n,).
        rows: The equilibria (n,).
        status: ``"finished"``; ``"singular"`` where the end was not reached; ``"interrupted"``.
        message: The same as a sentence.
        crossings: Where stability changed, in their order.
        values: What was swept, by name (n,).
    """

    loading: Loading
    s: Array
    rows: Sequence[EquilibriumRecord]
    status: str
    message: str
    crossings: Sequence[Crossing] = ()
    values: Mapping[str, Array] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        way: Loading,
        rows: list[tuple[float, EquilibriumRecord]],
        crossed: Sequence[Crossing],
        status: str,
        failure: str,
    ) -> StaticPathRecord:
        """The record of a path that was followed."""
        s = np.array([place for place, _ in rows])
        values = {name: np.array([way.values(place)[name] for place in s]) for name in way.swept}
        message = failure or "reached the end"
        return cls(way, s, tuple(e for _, e in rows), status, message, tuple(crossed), values)

    @property
    def success(self) -> bool:
        """True when the end was reached."""
        return self.status == FINISHED

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def model(self) -> LoadedModel:
        """The model with the parameters of the last row."""
        return self.rows[-1].model

    @property
    def x(self) -> Array:
        """States (n, nx)."""
        return np.array([row.x for row in self.rows])

    @property
    def q(self) -> Array:
        """Coordinates (n, nq)."""
        return np.array([row.q for row in self.rows])

    @property
    def lam(self) -> Array:
        """Multipliers (n, m)."""
        return np.array([row.lam for row in self.rows])

    @property
    def iterations(self) -> Integers:
        """Linear systems solved for every row (n,)."""
        return np.array([row.iterations for row in self.rows], dtype=np.intp)

    @property
    def stable(self) -> list[bool | None]:
        """Stability of every row; None where it is not known.

        Under dead loads: where displacements are prescribed, with the forces that this takes as
        loads that stay. ``stable_held`` tells it of the system as it is held.
        """
        return [row.stable for row in self.rows]

    @property
    def stable_held(self) -> list[bool | None]:
        """The same with displacements that are prescribed."""
        return [row.stable_held for row in self.rows]

    @property
    def n_negative(self) -> Integers:
        """Negative eigenvalues of the stiffness on what constraints allow, under dead loads (n,).

        Independent directions in which every row is pushed away.
        """
        return np.array([row.n_negative for row in self.rows], dtype=np.intp)

    @property
    def n_negative_held(self) -> Integers:
        """The same with displacements that are prescribed (n,)."""
        return np.array([row.n_negative_held for row in self.rows], dtype=np.intp)

    def __getitem__(self, name: str | int) -> Any:
        """The equilibrium of a row; or a history: swept, holding force, what an equilibrium has.

        Raises:
            ModelError: no such history.
        """
        if isinstance(name, int | np.integer):
            return self.rows[name]
        if name in self.values and self.loading.kinds[name] != "locked":
            return self.values[name]
        first = self.rows[0]
        if name in first.named:
            return np.array([row.named[name] for row in self.rows])
        forces = {f"{n}.holding_force": n for n in first.holding_forces}
        if name in forces:
            return np.array([row.holding_forces[forces[name]] for row in self.rows])
        model = first.model
        outputs = column(model.manifest.outputs, "name")
        rows = model.manifest.element_forces
        exerted = force_part(name, rows) is not None
        if name in outputs or exerted or reaction_part(name, model.joints):
            return np.array([row[name] for row in self.rows])
        names = [*self.values, *first.named, *outputs, *force_names(rows), *forces]
        raise ModelError(f"path['{name}']: there is no such history.{near(name, names)}")

    @checked
    def reaction(self, joint: str) -> Array:
        """Wrench (n, 6) of parent on child at the child joint frame, in its axes."""
        return np.array([row.reaction(joint) for row in self.rows])

    @checked
    def pose(self, frame: str) -> Array:
        """Transforms (n, 4, 4) from frame axes to ground axes."""
        return np.array([row.pose(frame) for row in self.rows])

    @checked
    def sections(self, beam: str) -> Array:
        """Poses (n, nodes, 4, 4) of the sections of a beam, as :meth:`.Trajectory.sections`."""
        return np.array([row.sections(beam) for row in self.rows])

    def critical(self) -> list[dict[str, float]]:
        """Changes of stability: swept values, and the forces that hold prescribed displacements.

        The last one is the limit load where the path ended at one. Of displacements that are
        prescribed both are told: where the system that is held becomes unstable, and where it would
        under a dead load in place of what holds it (a limit load is such a place).

        Warns:
            SolveWarning: no equilibrium was found next to a critical load; what is told is the
                middle of the interval in which it lies, with the width of that as ``P.width``
                for a swept ``P``.
        """
        passages = [located(self.loading, crossing) for crossing in self.crossings]
        rows = [self._named_loads(place) for place, _ in passages]
        for values, (place, part) in zip(rows, passages, strict=True):
            if part:
                values.update(self._widths(place.s, part))
        return rows

    def _widths(self, s: float, part: float) -> dict[str, float]:
        """The swept interval in which a critical load lies, by name; warns of it."""
        low, high = (self.loading.values(s + sign * part / 2) for sign in (-1, 1))
        span = ", ".join(f"{name} = {low[name]:.6g} ... {high[name]:.6g}" for name in low)
        warn(
            f"critical: no equilibrium was found next to a critical load, which is known to lie "
            f"within {span} only. Sweep that interval alone, or with more steps",
            SolveWarning,
        )
        return {f"{name}.width": abs(high[name] - low[name]) for name in low}

    def _named_loads(self, place: Place) -> dict[str, float]:
        """Swept values at a place, and the forces that prescribe."""
        load, values = self.loading.at(place.s), self.loading.values(place.s)
        tau = Problem(self.loading.system).locked_forces(place.point, load)[1]
        for name in load.prescribed:
            values[f"{name}.holding_force"] = float(tau[self.loading.system.place(name)[1]])
        return values

    def __repr__(self) -> str:
        first = self.rows[0]
        ends = ", ".join(f"{n} = {v[0]:.6g} ... {v[-1]:.6g}" for n, v in self.values.items())
        lines = [
            f"statics of '{first.model.name}', {ends}: {self.message}",
            f"  {counted(len(self), 'equilibrium', 'equilibria')}, "
            f"{counted(int(self.iterations.sum()), 'iteration')}",
        ]
        last = self.rows[-1]
        names = list(last.named)[: min(last.model.nq, MAX_PRINTED)]
        lines += [f"  {n} = {first.named[n]:.6g} ... {last.named[n]:.6g}" for n in names]
        for crossing in self.crossings:
            low, high = (self.loading.values(p.s) for p in (crossing.before, crossing.after))
            span = ", ".join(f"{n} = {low[n]:.6g} ... {high[n]:.6g}" for n in self.values)
            lines.append(f"  {SAID[crossing.of]} between {span}")
        return "\n".join(lines)


@checked
def plot(
    static_path: StaticPathRecord,
    path: str | Path | None = None,
    names: Sequence[str] | None = None,
) -> Any:
    """Histories over the first swept value as a Matplotlib figure, written to ``path``.

    Raises:
        ModelError: unknown names, or a path that is not a picture file.
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    from ...view.plot import checked_names, plot_over

    chosen = checked_names(names) if names is not None else [*static_path.rows[0].model.coordinates]
    label = next(iter(static_path.values))
    curves = {name: static_path[name] for name in chosen}
    return plot_over(static_path.rows[0].model.name, label, static_path.values[label], curves, path)
