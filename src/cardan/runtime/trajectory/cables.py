"""Tension of cables: in a state, and along a motion."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, final

import numpy as np

from ...arguments import Times, checked
from ...arrays import Array
from ...errors import ArgumentError, counted, near
from ...records import dataclass
from ...schema.manifest import Manifest
from ...schema.mechanism import ForceElementRow
from ..calls.evaluation import State

if TYPE_CHECKING:
    from ..models.loaded_model import LoadedModel
    from .trajectory import TrajectoryRecord

# an element of a cable of several
ELEMENT = re.compile(r"(.+)\.element([1-9][0-9]*)")


@final
@dataclass(frozen=True, repr=False, eq=False)
class CableTension:
    """Tension of a cable in each of its n straight elements.

    Attributes:
        name: Of the cable.
        s: Middles of the elements, as places in 0 ... 1 of its length (n,).
        tension: (..., n) [N], 0 where it is slack.
    """

    name: str
    s: Array
    tension: Array

    @property
    def taut(self) -> Array:
        """True where it pulls (..., n)."""
        return np.asarray(self.tension > 0)

    def __repr__(self) -> str:
        low, high = (f"{x:.6g}" for x in (self.tension.min(), self.tension.max()))
        elements = counted(len(self.s), "element")
        return f"CableTension('{self.name}', {elements}: {low} to {high} N)"


def elements_of(manifest: Manifest) -> dict[str, list[ForceElementRow]]:
    """The elements of every cable, from start to end."""
    cables: dict[str, list[ForceElementRow]] = {}
    for row in manifest.forces:
        if row.kind == "cable":
            element = ELEMENT.fullmatch(row.name)
            cables.setdefault(element[1] if element else row.name, []).append(row)
    return cables


def _element_names(manifest: Manifest, name: str) -> list[str]:
    """Names of the elements of a cable.

    Raises:
        ArgumentError: there is none.
    """
    cables = elements_of(manifest)
    if name not in cables:
        listed = near(name, cables) if cables else " The model has no cables."
        raise ArgumentError(f"cable '{name}' does not exist.{listed}")
    return [row.name for row in cables[name]]


def _middles(count: int) -> Array:
    return (np.arange(count) + 0.5) / count


@checked
def cable(
    model: LoadedModel,
    name: str,
    q: State,
    u: State | None = None,
    *,
    t: Times = 0.0,
    r: State | None = None,
) -> CableTension:
    """Tension along a cable.

    Args:
        model: The model.
        name: Of the cable.
        q, u: Coordinates (..., nq) and speeds (..., nu); u is 0 unless given.
        t, r: Time [s] and inputs (..., nr), where something is prescribed.

    Returns:
        Its tension in every element (..., n) [N].

    Raises:
        ArgumentError: there is no such cable.
    """
    elements = _element_names(model.manifest, name)
    coordinates = np.asarray(model._vector("q", q), dtype=np.float64)
    speeds = np.zeros((*coordinates.shape[:-1], model.nu)) if u is None else u
    forces = np.asarray(model.element_forces(coordinates, speeds, t=t, r=r))
    names = [row.name for row in model.manifest.element_forces]
    columns = [names.index(f"{element}.force") for element in elements]
    return CableTension(name, _middles(len(elements)), forces[..., columns])


@checked
def cable_of_run(motion: TrajectoryRecord, name: str) -> CableTension:
    """Tension along a cable at all times (nt, n).

    Args:
        motion: The motion.
        name: Of the cable.

    Raises:
        ArgumentError: there is no such cable.
    """
    elements = _element_names(motion.manifest, name)
    tension = np.stack([motion[f"{element}.force"] for element in elements], axis=-1)
    return CableTension(name, _middles(len(elements)), tension)
