"""Root loci: eigenvalues of a family of linear models, followed, and where stability changes.

From member to member eigenvalues are told by the shapes of their motions and by their values, all
at once (an assignment); where that is in doubt members between are looked at. Stability changes
where the number of growing motions does; a real eigenvalue that passes 0 is divergence, a complex
pair that passes the axis is flutter.

Source: H. Ziegler, Principles of Structural Stability (1968), chapter 3; A. P. Seyranian, A. A.
Mailybaev, Multiparameter Stability Theory with Mechanical Applications (2003), chapters 1 and 5.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import Count, LockedValues, checked
from ...arrays import Array, Booleans, Complex, Integers
from ...errors import SolveError, SolveWarning, warn
from ...records import dataclass
from .family import Family, Member, family
from .stability_change import Interval, StabilityChange, follow

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...runtime.models.loaded_model import LoadedModel

DOUBT = 0.4  # costs of an eigenvalue to be another one above which members between are looked at
DEEPEST = 6  # halvings of a step
MAX_PRINTED = 6
END = "reached the end"


@dataclass(frozen=True, repr=False, eq=False)
class LocusRecord:
    """Eigenvalues over what changes; ``locus["P"]`` is what changes (n,).

    Attributes:
        name: Of the model.
        values: What changes, by name (n,).
        eigenvalues: Followed (n, k) [1/s]: a column is a motion that changes continuously.
        members: The linear models with their states (n,).
        changes: Where stability changes, in their order.
        message: ``"reached the end"``, or why it ends early.
        family: For what goes on from here.
    """

    name: str
    values: Mapping[str, Array]
    eigenvalues: Complex
    members: Sequence[Member]
    changes: Sequence[StabilityChange]
    message: str
    family: Family = field(repr=False)

    def __getitem__(self, name: str) -> Array:
        return self.values[name]

    def __len__(self) -> int:
        return len(self.members)

    @property
    def stable(self) -> Booleans:
        """Mask of the members about which no small motion grows exponentially (n,)."""
        return np.array([member.stable for member in self.members])

    @property
    def moving(self) -> Booleans:
        """Mask of the columns that are not 0 all the way (k,)."""
        size = np.array([member.spectrum.size for member in self.members])[:, None]
        return np.asarray((np.abs(self.eigenvalues) > 1e-6 * size).any(axis=0))

    def __repr__(self) -> str:
        ends = ", ".join(f"{n} = {v[0] + 0.0:.6g} ... {v[-1]:.6g}" for n, v in self.values.items())
        lines = [f"'{self.name}', {ends}: {len(self)} linear models, {self.message}"]
        eigenvalues = self.eigenvalues[:, self.moving]
        for row in dict.fromkeys((0, len(self) // 2, len(self) - 1)):
            said = ", ".join(f"{n} = {v[row] + 0.0:.6g}" for n, v in self.values.items())
            least = 1e-9 * self.members[row].spectrum.size
            printed = [v for v in eigenvalues[row] if v.imag >= 0 and abs(v) > least]
            numbers = [
                _number(v) for v in sorted(printed, key=lambda v: (-v.real, v.imag))[:MAX_PRINTED]
            ]
            more = ", ..." if len(printed) > MAX_PRINTED else ""
            kind = "stable" if self.members[row].stable else "unstable"
            lines.append(f"  {said}: {kind}; {', '.join(numbers)}{more}")
        for change in self.changes:
            said = ", ".join(f"{n} = {v:.9g}" for n, v in change.values.items())
            word = "begins" if change.lost else "ends"
            tail = f", {change.frequency:.6g} rad/s" if change.kind == "flutter" else ""
            lines.append(f"  {change.kind} {word} at {said}{tail}")
        return "\n".join(lines)


@checked
def root_locus(
    model: LoadedModel,
    swept: Mapping[str, object] | None = None,
    *,
    count: Count | None = None,
    coordinates: Iterable[str] | None = None,
    q: Mapping[str, ArrayLike] | ArrayLike | None = None,
    u: Mapping[str, object] | None = None,
    locked: LockedValues | None = None,
    targets: Mapping[str, object] | None = None,
    free: Iterable[str] | None = None,
    inputs: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    t: float = 0.0,
    check: bool = False,
    **named: Any,
) -> LocusRecord:
    """Eigenvalues as something changes: ``model.root_locus(P=(0, 10))``.

    Args:
        model: The compiled model.
        swept, named: Parameter, input, ``t``, or joint whose speed it is -> (start, end), or values
            (n,). Several go together.
        count: Members of a range; 31 if left out.
        coordinates: Those whose motions count, if their equations are closed: lean and steer of a
            bicycle. All if left out.
        q, u, locked, inputs, parameters, t: As ``equilibrium`` takes them; arrays in ``u`` and
            ``locked`` are swept too.
        targets, free: As ``trim`` takes them, which finds the members then (no ``locked``);
            arrays in ``targets`` are swept too.
        check: Raise where the end is not reached, instead of warning.

    Returns:
        Eigenvalues followed from member to member, and where stability changes.

    Raises:
        ModelError: unknown names, nothing that changes. ArgumentError: values of a wrong shape.
        SolveError: no equilibrium or steady motion at the start; with ``check``, further on.
    """
    arguments = {"q": q, "u": u, "locked": locked, "targets": targets, "free": free,
                 "inputs": inputs,
             "parameters": parameters, "t": t}  # fmt: skip
    loci = locus(family(model, {**(swept or {}), **named}, arguments, count, coordinates), check)
    if loci.message != END:
        warn(loci.message, SolveWarning)
    return loci


def locus(members: Family, check: bool = False) -> LocusRecord:
    """The locus of a family.

    Raises:
        SolveError: no first member; with ``check``, none further on.
    """
    rows, orders, message = [members.at(0.0)], list[Integers](), END
    orders.append(np.arange(len(rows[0].values)))
    changes = list[StabilityChange]()
    try:
        for s in members.stations[1:]:
            here, order = _on(members, rows[-1], float(s), orders[-1])
            rows.append(here)
            orders.append(order)
        # what grows is known against all that moves, also where everything stands still
        rate = max(row.spectrum.size for row in rows)
        for low, high in pairwise(rows):
            changes += Interval(members, rate).changes(low, high)
    except SolveError as failed:
        said = ", ".join(f"{n} = {v:.6g}" for n, v in members.values_at(rows[-1].s).items())
        message = f"ends behind {said}: {failed}"
        if check:
            raise SolveError(message) from failed
    values = {n: np.array([members.values_at(row.s)[n] for row in rows]) for n in members.columns}
    eigenvalues = np.array([row.values[order] for row, order in zip(rows, orders, strict=True)])
    return LocusRecord(members.model.name, values, eigenvalues, rows, changes, message, members)


def _on(
    members: Family, before: Member, s: float, order: Integers, depth: int = 0
) -> tuple[Member, Integers]:
    """The next member, and places of the followed eigenvalues in it."""
    here = members.at(s, before)
    next_to, doubt = follow(before, here)
    if doubt <= DOUBT or depth == DEEPEST:
        return here, next_to[order]
    middle, half = _on(members, before, 0.5 * (before.s + s), order, depth + 1)
    return _on(members, middle, s, half, depth + 1)


def _number(value: complex) -> str:
    real = 0.0 if abs(value.real) < 1e-12 * abs(value) else value.real
    return f"{real:.5g}" + (f" +- {value.imag:.5g} i" if value.imag > 0 else "")


@checked
def plot(locus: LocusRecord, path: str | Path | None = None) -> Figure:
    """Loci in the complex plane, and real and imaginary parts over the first that changes.

    Args:
        path: Picture file, or None.

    Returns:
        The Matplotlib figure.

    Raises:
        ModelError: a path that is not a picture file.
        ModuleNotFoundError: Matplotlib is not installed (extra ``plot``).
    """
    from ...view.loci import plot_locus

    label, over = next(iter(locus.values.items()))
    eigenvalues = locus.eigenvalues[:, locus.moving]
    return plot_locus(
        locus.name, label, over, eigenvalues, [c.values[label] for c in locus.changes], path
    )
