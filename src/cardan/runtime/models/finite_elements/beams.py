"""Forces, moments, strains and stresses along a beam."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING, final

import numpy as np
from numpy.typing import ArrayLike

from ....arguments import checked
from ....arrays import Array
from ....errors import ArgumentError, ModelError, counted, near
from ....records import dataclass
from ...calls.evaluation import State
from .elements import Elements
from .elements import State as ElementState

if TYPE_CHECKING:
    from ...trajectory.trajectory import TrajectoryRecord
    from ..loaded_model import LoadedModel

FORM = "stress"
ENDS, ROWS = 2, 4  # of an element; stress and strain there


@final
@dataclass(frozen=True, repr=False, eq=False)
class BeamStress:
    """Internal forces of a beam, at the start and at the end of each of its n elements.

    Axes are those of the section, e1 along the beam. Forces are those of what lies ahead on what
    lies behind: tension is positive. Two neighbors differ at their node by what is applied there.
    Structural damping has no part in it.

    Attributes:
        name: Of the beam.
        s: Arc length of the reference configuration from the start of the beam (2 n,) [m].
        force: n (..., 2 n, 3) [N]: axial, shear along e2 and e3.
        moment: m (..., 2 n, 3) [N m]: torsion, bending about e2 and e3.
        strain: (..., 2 n, 3): stretch, shear along e2 and e3.
        curvature: (..., 2 n, 3) [rad/m]: twist, bending about e2 and e3, beyond the shape that has
            no stress.
        outline: Half widths of the section along e2 and e3 [m], and whether it is round.
        modulus: Young's modulus [Pa], None for a section of given stiffnesses.
    """

    name: str
    s: Array
    force: Array
    moment: Array
    strain: Array
    curvature: Array
    outline: tuple[float, float, bool]
    modulus: float | None = field(default=None)

    def normal_stress(self, y: ArrayLike, z: ArrayLike) -> Array:
        """Stress along the beam (..., 2 n) [Pa] at a point of the section.

        Args:
            y, z: Of the point, along e2 and e3 [m].

        Raises:
            ModelError: the section was given by stiffnesses.
        """
        fiber = self.strain[..., 0] + self.curvature[..., 1] * np.asarray(z)
        stress: Array = self._modulus() * (fiber - self.curvature[..., 2] * np.asarray(y))
        return stress

    @property
    def extreme(self) -> Array:
        """Largest normal stress of each section, of either sign, as a magnitude (..., 2 n) [Pa]."""
        stress: Array = self._modulus() * self.extreme_strain
        return stress

    @property
    def extreme_strain(self) -> Array:
        """Largest normal strain of each section, of either sign, as a magnitude (..., 2 n)."""
        width, height, is_round = self.outline
        bent = np.abs(self.curvature[..., 1:])
        # the farthest point across the axis of bending; a corner where there is one
        far = width * np.hypot(bent[..., 0], bent[..., 1])
        corner = height * bent[..., 0] + width * bent[..., 1]
        strain: Array = np.abs(self.strain[..., 0]) + (far if is_round else corner)
        return strain

    @property
    def extreme_at_nodes(self) -> Array:
        """``extreme`` at every node (..., n + 1) [Pa]: the larger of the two values beside it.

        The nodes are those of ``motion.line(beam)`` and ``motion.sections(beam)``.
        """
        return at_nodes(self.extreme)

    def _modulus(self) -> float:
        if self.modulus is None:
            raise ModelError(
                f"beam '{self.name}' has a section of given stiffnesses, without material and "
                "shape: its stresses are force and moment. Take cd.section.tube(...) or another"
            )
        return self.modulus

    def __repr__(self) -> str:
        sizes = [f"{np.abs(x).max(initial=0.0):.6g}" for x in (self.force, self.moment)]
        return (
            f"BeamStress('{self.name}', {counted(len(self.s) // ENDS, 'element')}: "
            f"force up to {sizes[0]} N, "
            f"moment up to {sizes[1]} N m)"
        )


def at_nodes(values: Array) -> Array:
    """The larger of the values (..., 2 n) of elements that meet at each node (..., n + 1)."""
    inner = np.maximum(values[..., 1:-1:ENDS], values[..., ENDS::ENDS])
    return np.concatenate([values[..., :1], inner, values[..., -1:]], axis=-1)


@checked
def beam(model: LoadedModel, name: str, q: State) -> BeamStress:
    """Forces, moments and strains along a beam, in axes of the section.

    Args:
        model: In absolute coordinates.
        name: Of the beam.
        q: Coordinates (..., nq), such as those of an equilibrium.

    Raises:
        ModelError: there is no such beam. ArgumentError: q has another shape.
    """
    rows = [row for row in model.manifest.beams if row.name == name]
    if not rows:
        names = list(dict.fromkeys(row.name for row in model.manifest.beams))
        raise ModelError(f"model '{model.name}' has no beam '{name}'.{near(name, names)}")
    places = np.asarray(model._vector("q", q), dtype=np.float64)
    if places.shape[-1:] != (model.nq,):
        raise ArgumentError(f"q has shape {places.shape}, expected (..., {model.nq})")
    elements: Elements = model._source.results(model).mesh  # type: ignore[attr-defined]
    lead = places.shape[:-1]
    forces = _along(elements, _members(elements, name), places.reshape(-1, model.nq))
    forces = forces.reshape(*lead, -1, ROWS, 6)
    ends = [forces[..., k : k + ENDS, :].reshape(*lead, -1, 6) for k in (0, ENDS)]
    stations = [
        line
        for row, line in zip(model.manifest.beams, elements.tables.stations, strict=True)
        if row.name == name
    ]
    return BeamStress(
        name=name,
        s=np.concatenate([np.repeat(line, ENDS)[1:-1] for line in stations]),
        moment=ends[0][..., :3],
        force=ends[0][..., 3:],
        curvature=ends[1][..., :3],
        strain=ends[1][..., 3:],
        outline=(*rows[0].outline[:2], bool(rows[0].outline[2])),
        modulus=dict(model.parameters).get(f"{name}.material.E"),
    )


def _members(elements: Elements, name: str) -> list[tuple[int, int]]:
    """Table and row of every element of a beam, from its start."""
    having = [group for group in elements.tables.groups if FORM in group.kind.functions]
    at: dict[int, tuple[int, int]] = {}
    for number, group in enumerate(having):
        for row, member in enumerate(group.members):
            beam, _, place = member.rpartition(".")
            if beam == name and place.isdecimal():
                at[int(place)] = number, row
    return [at[k] for k in sorted(at)]


def _along(elements: Elements, members: list[tuple[int, int]], q: Array) -> Array:
    """Stress and strain at both ends of every element (states, n, 24)."""
    numbers, rows = np.array(members, dtype=np.intp).reshape(-1, 2).T
    stress = np.empty((len(q), len(members), ROWS * 6))
    for k, place in enumerate(q):
        tables = elements.results(FORM, ElementState(place))
        for number in np.unique(numbers):
            selected = numbers == number
            stress[k, selected] = tables[number][rows[selected]]
    return stress


@checked
def beam_of_run(motion: TrajectoryRecord, name: str) -> BeamStress:
    """Forces, moments and strains (nt, 2 n, 3) along a beam, in axes of the section."""
    return beam(motion._model(f"what beam '{name}' carries"), name, motion.q)
