"""Superelements where a model stands or moves: displacements and stress at their surfaces."""

from __future__ import annotations

import hashlib
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from .... import regular_file
from ....arguments import checked
from ....arrays import Array, Integers
from ....errors import ArgumentError, ModelError, counted, near
from ....number_file import unpacked
from ....records import dataclass
from ....schema.manifest import Manifest
from ....schema.mechanism import SuperelementRow
from ....superelements.moving_surface import FILE, MovingSurface, entry, surface_of_arrays
from ....superelements.section_forces import BeamSections, SectionForces, forces_of
from ....superelements.stress_recovery import von_mises
from ...calls.evaluation import State

if TYPE_CHECKING:
    from ...trajectory.trajectory import TrajectoryRecord
    from ..loaded_model import LoadedModel

ROWS = 64  # of which stress is computed together


@dataclass(frozen=True, repr=False, eq=False)
class DeformedSuperelementRecord:
    """A superelement with its deformation, at one or at many states (...).

    Attributes:
        name: Of the superelement.
        pose: Transforms (..., 4, 4) from the axes of its frame to those of the ground.
        z: Its coordinates (..., n) that move: of interfaces, then of modes [m, rad, 1].
        factors: Of the loads that act on it (..., loads), which may add to its stress.
        surface: What is drawn of it: points X, shapes Psi, triangles, lines, stress.
        beams: Beams of a scene that it was made of.
    """

    name: str
    pose: Array
    z: Array
    factors: Array
    surface: MovingSurface = field(repr=False)
    beams: tuple[str, ...] = ()

    @property
    def triangles(self) -> Integers:
        """Points of triangles (triangles, 3), counterclockwise from outside."""
        return self.surface.triangles

    @property
    def lines(self) -> Integers:
        """Points of lines (lines, 2)."""
        return self.surface.lines

    @property
    def stressed(self) -> Integers:
        """Points whose stress is known (k,)."""
        return self.surface.stressed

    @property
    def amplitudes(self) -> Array:
        """What shapes and stresses of the surface are multiplied by (..., n + loads)."""
        return np.concatenate([self.z, self.factors], axis=-1)

    @cached_property
    def displacements(self) -> Array:
        """Displacements Psi z of the points (..., points, 3) [m], in axes of its frame."""
        return np.tensordot(self.amplitudes, self.surface.shapes, 1)

    @cached_property
    def positions(self) -> Array:
        """Positions x0 + R0 (X + Psi z) of the points (..., points, 3) [m], in ground axes."""
        local = self.surface.points + self.displacements
        rotations, origins = self.pose[..., None, :3, :3], self.pose[..., None, :3, 3]
        return np.asarray((rotations @ local[..., None])[..., 0] + origins)

    @cached_property
    def stress(self) -> Array:
        """Stress (..., k, 6) [Pa] at the points ``stressed``, in axes of its frame.

        Components are xx, yy, zz, yz, zx, xy.

        Raises:
            ModelError: the record has no stress at points of its surface.
        """
        self.check_stress()
        return np.tensordot(self.amplitudes, self.surface.stresses, 1)

    @cached_property
    def von_mises(self) -> Array:
        """Equivalent stress (..., k) [Pa] at the points ``stressed``.

        Raises:
            ModelError: as :attr:`stress`.
        """
        return von_mises(self.stress)

    @cached_property
    def largest_stress(self) -> Array:
        """Largest equivalent stress of all points (...) [Pa].

        Raises:
            ModelError: as :attr:`stress`.
        """
        self.check_stress()
        z = self.amplitudes.reshape(-1, len(self.surface.stresses))
        most = [
            von_mises(np.tensordot(z[k : k + ROWS], self.surface.stresses, 1)).max(axis=1)
            for k in range(0, len(z), ROWS)
        ]
        return np.concatenate([*most, np.zeros(0)]).reshape(self.z.shape[:-1])

    def section_forces(self, beam: str) -> SectionForces:
        """Forces and moments in the sections of a beam that the component was made of.

        Args:
            beam: Its name, as in the scene that was reduced.

        Returns:
            N, Qy, Qz [N] and Mx, My, Mz [N m] at the ends of its elements (..., 2 n, 3), in axes of
            the section.

        Raises:
            ModelError: there is no such beam.
        """
        surface = self.surface
        names = tuple(self.beams[k] for k in surface.section_beams)
        rows = np.tensordot(self.amplitudes, surface.section_forces, 1)
        return forces_of(beam, BeamSections(names, surface.stations), rows)

    def check_stress(self) -> None:
        """Make sure that stress is known somewhere.

        Raises:
            ModelError: it is not.
        """
        if not len(self.stressed):
            raise ModelError(
                f"superelement '{self.name}' has no stress at points of its surface. Reduce its "
                "mesh with stress=, a surface or a set of nodes, and matrices with load_stresses= "
                "of every load that acts, and compile again"
            )

    def __repr__(self) -> str:
        moved = np.linalg.norm(self.displacements, axis=-1).max(initial=0.0)
        stress = f", stress up to {self.largest_stress.max():.6g} Pa" if len(self.stressed) else ""
        return (
            f"DeformedSuperelement('{self.name}', {counted(len(self.surface.points), 'point')}: "
            f"displacements up to {moved:.6g} m{stress})"
        )


def number_of(manifest: Manifest, name: str) -> int:
    """Number of a superelement.

    Raises:
        ModelError: there is none of this name.
    """
    names = [row.name for row in manifest.superelements]
    if name not in names:
        raise ModelError(
            f"model '{manifest.name}' has no superelement '{name}'.{near(name, names)}"
        )
    return names.index(name)


def surfaces_of(model: LoadedModel) -> dict[str, Array]:
    """Arrays of the surfaces of all superelements of a model, by name.

    Raises:
        ModelError: the file with them is missing or damaged.
    """
    path, rows = model.directory / FILE, model.manifest.superelements
    try:
        content = regular_file.content(path)
        if hashlib.sha256(content).hexdigest() != model.manifest.sha256.get(FILE):
            raise ValueError("it is not the file its manifest speaks of")
        arrays = unpacked(content)
        surfaces = [surface_of(arrays, k, row) for k, row in enumerate(rows)]
    except (OSError, ValueError) as error:
        raise ModelError(
            f"{path} does not hold the surfaces of superelements: {error}. Compile the model again"
        ) from error
    return {
        entry(name, k): values
        for k, surface in enumerate(surfaces)
        for name, values in surface.arrays().items()
    }


def surface_of(arrays: dict[str, Array], number: int, row: SuperelementRow) -> MovingSurface:
    """The surface of a superelement out of the arrays of a file.

    Raises:
        ValueError: as :func:`.surface_of_arrays`.
    """
    names = MovingSurface.__dataclass_fields__
    places = {name: entry(name, number) for name in names}
    selected = {name: arrays[place] for name, place in places.items() if place in arrays}
    return surface_of_arrays(selected, row.amplitudes, len(row.beams))


@checked
def superelement(
    model: LoadedModel, name: str, q: State, *, t: float = 0.0, r: State | None = None
) -> DeformedSuperelementRecord:
    """A superelement with its deformation: positions and stress at points of its surface.

    Args:
        model: In absolute coordinates.
        name: Of the superelement.
        q: Coordinates (..., nq), such as those of an equilibrium.
        t, r: Time [s] and inputs (nr,), on which loads may depend; those of the model by default.

    Raises:
        ModelError: there is no such superelement. ArgumentError: q has another shape.
    """
    number = number_of(model.manifest, name)
    row = model.manifest.superelements[number]
    places = np.asarray(model._vector("q", q), dtype=np.float64)
    if places.shape[-1:] != (model.nq,):
        raise ArgumentError(f"q has shape {places.shape}, expected (..., {model.nq})")
    surface = surface_of(_cached(model), number, row)
    pose = model.pose(row.frame, places, t=t, r=r)
    factors = np.zeros((*places.shape[:-1], 0))
    if row.loads:
        speeds = np.zeros((*places.shape[:-1], model.nu))
        names = [output.name for output in model.manifest.outputs]
        chosen = [names.index(one) for one in row.outputs]
        factors = model.outputs(places, speeds, t=t, r=r)[..., chosen]
    z = places[..., list(row.q)]
    return DeformedSuperelementRecord(name, pose, z, factors, surface, tuple(row.beams))


def _cached(model: LoadedModel) -> dict[str, Array]:
    """The surfaces of a model, read once."""
    if FILE not in model._derived:
        model._derived[FILE] = surfaces_of(model)
    arrays: dict[str, Array] = model._derived[FILE]
    return arrays


def arrays_of_run(motion: TrajectoryRecord) -> dict[str, Array]:
    """Arrays of the surfaces of a run, of its model or of its file; none where no file has any."""
    if motion.model is not None:
        return _cached(motion.model) if motion.manifest.superelements else {}
    return {name: x for name, x in motion.numbers.items() if name.startswith("surface_")}


@checked
def superelement_of_run(motion: TrajectoryRecord, name: str) -> DeformedSuperelementRecord:
    """A superelement with its deformation (nt, ...): points of its surface and their stress.

    Args:
        name: Of the superelement.

    Raises:
        ModelError: there is no such superelement, or the file of the run does not hold it.
    """
    number = number_of(motion.manifest, name)
    row, arrays = motion.manifest.superelements[number], arrays_of_run(motion)
    if entry("points", number) not in arrays:
        motion._model(f"the surface of superelement '{name}'")
    try:
        surface = surface_of(arrays, number, row)
    except ValueError as error:
        raise ModelError(
            f"superelement '{name}' is damaged: {error}. Save the run again"
        ) from error
    factors = np.array([motion[one] for one in row.outputs]).reshape(-1, len(motion)).T
    return DeformedSuperelementRecord(
        name, motion.pose(row.frame), motion.q[:, list(row.q)], factors, surface, tuple(row.beams)
    )
