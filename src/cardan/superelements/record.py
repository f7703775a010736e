"""A reduced component: a record of matrices that says what it is worth."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import checked
from ..arrays import Array, Complex, Integers
from ..errors import ArgumentError, ModelError, SolveError, brief, counted, near
from ..records import dataclass
from .checks import MassProperties, RigidCheck, rigid_text
from .cost import ReductionCost, cost
from .error_bounds import Residuals, relative_bounds
from .inertia import ProjectedInertia
from .interfaces import InterfaceFrame, frame_motions
from .node_dofs import NodeDofs
from .response import (
    MAX_PRINTED,
    ReducedModes,
    admittance,
    free_motions,
    frequencies_of,
    impedance,
    reduced_modes,
)
from .section_forces import COMPONENTS, BeamSections, SectionForces, forces_of
from .surface import Surface
from .values import numbers

ISOTROPIC = 1e-8  # of the largest mass: what rounded texts leave


@dataclass(frozen=True, eq=False)
class SuperelementRecord:
    """A component with n coordinates: n_b motions of its interfaces, then modal coordinates.

    Stiffness does not couple motions of interfaces with modal coordinates, whose modal mass is 1.

    Attributes:
        method: By which it was reduced.
        M, C, K: Mass, damping and stiffness (n, n) [kg, N s/m, N/m; rotations in rad].
        basis: Displacements of the rows of the nodes by the coordinates (rows, n).
        dofs: Nodes, and which motion of which node each row is.
        interfaces: Frames, in the order of their motions.
        frequencies: Of the modes that were chosen [rad/s].
        dropped: Of the first modes that were left out [rad/s].
        modes_of: What these are modes of: with all interfaces fixed, or free.
        massless: Coordinates without mass, only of ``"macneal"``.
        rigid: Rigid motions without strain in the coordinates (n, r).
        residuals: What gives error bounds of frequencies.
        properties: Mass, center and inertia.
        check: Forces by rigid motions.
        sound: Speed of sound in the mesh, roughly [m/s].
        density: Mass over the volume of the box around the nodes [kg/m^3].
        inertia: Constants of the inertia in a frame that moves far.
        anisotropy: Largest entry of the mass matrix that depends on directions, over its largest
            one; the constants are exact where it is 0.
        loads: Forces in the coordinates by the names of loads (n,).
        stress: Rows of stress by the coordinates (components, n).
        load_stresses: What loads add to these rows at z = 0, by name (components,).
        stress_names: Of these rows.
        sections: Sections of beams; if there are any, the rows of stress are their forces.
        geometric: Geometric stiffness by the names of loads of unit size (n, n).
        surface: What one sees of it.
        notes: What may not be meant.
    """

    method: str
    M: Array
    C: Array
    K: Array
    basis: Array
    dofs: NodeDofs
    interfaces: tuple[InterfaceFrame, ...]
    frequencies: Array
    dropped: Array
    modes_of: str
    massless: int
    rigid: Array
    residuals: Residuals
    properties: MassProperties
    check: RigidCheck
    sound: float
    density: float
    inertia: ProjectedInertia
    anisotropy: float
    loads: Mapping[str, Array]
    stress: Array
    load_stresses: Mapping[str, Array]
    stress_names: tuple[str, ...]
    sections: BeamSections
    geometric: Mapping[str, Array]
    surface: Surface
    notes: tuple[str, ...]

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if isinstance(value, np.ndarray):
                value.setflags(write=False)

    @property
    def n(self) -> int:
        """Coordinates."""
        return len(self.M)

    @property
    def n_boundary(self) -> int:
        """Motions of all interfaces, the first of the coordinates."""
        return sum(len(frame.components) for frame in self.interfaces)

    @property
    def labels(self) -> tuple[str, ...]:
        """Names of the coordinates, such as ``"hinge.rx"`` and ``"mode 1"``."""
        motions = [label for frame in self.interfaces for label in frame.labels]
        return (*motions, *(f"mode {k + 1}" for k in range(self.n - len(motions))))

    @property
    def gravity(self) -> Array:
        """Forces (n, 3) in the coordinates by accelerations of 1 m/s^2 along the axes."""
        return self.inertia.momentum.T.copy()

    @property
    def cost(self) -> ReductionCost:
        """The cost of the reduction: coordinates, frequencies that are left out, errors."""
        return cost(self)

    def interface(self, name: str) -> InterfaceFrame:
        """An interface by its name.

        Raises:
            ModelError: there is none of this name.
        """
        for frame in self.interfaces:
            if frame.name == name:
                return frame
        names = [frame.name for frame in self.interfaces]
        raise ModelError(f"there is no interface {brief(name)}.{near(name, names)}")

    def rigid_motions(self, about: ArrayLike = (0.0, 0.0, 0.0)) -> Array:
        """Coordinates (n, 6) of unit translations and rotations of the entire component.

        Args:
            about: Point that rotations leave where it is (3,) [m].
        """
        point = numbers("rigid_motions: about", about)
        if point.shape != (3,) or not np.isfinite(point).all():
            raise ArgumentError(f"rigid_motions: about={brief(about)}: give three finite numbers")
        blocks = [frame_motions(frame, point) for frame in self.interfaces]
        return np.vstack([*blocks, np.zeros((self.n - self.n_boundary, 6))])

    @checked
    def modes(self, locked: Sequence[str] = ()) -> ReducedModes:
        """Modes of the component alone, without damping.

        Args:
            locked: Interfaces that are fixed, or their motions, such as ``"hinge"``,
                ``"hinge.rx"``.

        Returns:
            Frequencies [rad/s] with error bounds, and shapes.

        Raises:
            ModelError: a name that does not exist.
            SolveError: the stiffness is not positive where nothing is fixed.
        """
        places = self._locked([locked] if isinstance(locked, str) else locked)
        omega, shapes = reduced_modes(self.M, self.K, self.rigid, places, self.massless)
        free = np.setdiff1d(np.arange(self.n_boundary), places)
        norms = self.residuals.norms(omega**2, shapes, free)
        energies = np.einsum("ij,ij->j", shapes, self.K @ shapes)
        bounds, estimates = relative_bounds(norms, energies, omega**2)
        n_rigid = free_motions(self.rigid, places).shape[1]
        names = tuple(self.labels[k] for k in places)
        moved = self.basis @ shapes
        return ReducedModes(omega, shapes, moved, bounds, estimates, n_rigid, names)

    @checked
    def impedance(self, frequencies: Sequence[float]) -> Complex:
        """Dynamic stiffness of the interfaces, Z(omega) = K - omega^2 M + i omega C condensed.

        Args:
            frequencies: omega [rad/s].

        Returns:
            Forces by motions of the interfaces (frequencies, n_b, n_b) [N, N m by m, rad].

        Raises:
            SolveError: at a frequency with all interfaces fixed, without damping.
        """
        omega = frequencies_of(frequencies, "impedance")
        return impedance(self.M, self.C, self.K, self.n_boundary, omega)

    @checked
    def admittance(self, frequencies: Sequence[float]) -> Complex:
        """Motions of the interfaces by harmonic forces there, the inverse of the impedance.

        Args:
            frequencies: omega [rad/s].

        Returns:
            Motions by forces (frequencies, n_b, n_b) [m, rad by N, N m].

        Raises:
            SolveError: at a frequency with all interfaces free, 0 among them, without damping.
        """
        omega = frequencies_of(frequencies, "admittance")
        return admittance(self.M, self.C, self.K, self.n_boundary, omega)

    def displacements(self, z: ArrayLike) -> Array:
        """Displacements of the rows of the nodes by coordinates.

        Args:
            z: Coordinates (..., n).

        Returns:
            (..., rows) [m, rad]; ``dofs`` says which motion of which node each row is.
        """
        return self._coordinates(z, "displacements") @ self.basis.T

    @cached_property
    def surface_points(self) -> Array:
        """Positions X of the points of the surface, undeformed (points, 3) [m]."""
        return self.surface.points(self.dofs)

    @cached_property
    def surface_basis(self) -> Array:
        """Displacements Psi of the points of the surface by the coordinates (points, 3, n)."""
        return self.surface.basis(self.basis, self.dofs)

    def surface_displacements(self, z: ArrayLike) -> Array:
        """Displacements of the points of the surface by coordinates.

        In a frame at x0 with the axes R0, the points stand at x0 + R0 (X + Psi z).

        Args:
            z: Coordinates (..., n).

        Returns:
            (..., points, 3) [m], in the axes of the component.
        """
        values = self._coordinates(z, "surface_displacements")
        moved: Array = np.einsum("...n,pin->...pi", values, self.surface_basis)
        return moved

    @checked
    def stresses(self, z: ArrayLike, loads: Mapping[str, float] | None = None) -> Array:
        """Rows of the stress operator by coordinates, and by loads that act.

        Free thermal expansion has displacements and no stress, so that loads must be given too.

        Args:
            z: Coordinates (..., n).
            loads: Factors of loads by name; none by default.

        Returns:
            (..., stress rows), in the order of ``stress_names``.

        Raises:
            ModelError: the reduction had no operator, or no ``load_stresses`` of a load.
        """
        if not len(self.stress):
            raise ModelError("stresses: the component has none; give stress= to the reduction")
        stress: Array = self._coordinates(z, "stresses") @ self.stress.T
        for name, factor in (loads or {}).items():
            stress = stress + factor * self.load_stress(name)
        return stress

    def section_forces(self, z: ArrayLike, beam: str) -> SectionForces:
        """Forces and moments in the sections of a beam by coordinates.

        Args:
            z: Coordinates (..., n).
            beam: Name of a beam from which the component was made.

        Returns:
            N, Qy, Qz [N] and Mx, My, Mz [N m] at the ends of its elements, in axes of the section.

        Raises:
            ModelError: there is no such beam.
        """
        self.sections.of(beam)
        rows = self.stresses(z)
        return forces_of(beam, self.sections, rows.reshape(*rows.shape[:-1], -1, len(COMPONENTS)))

    def load_stress(self, name: str) -> Array:
        """What a load adds to the rows of stress at z = 0 (components,).

        Raises:
            ModelError: there is no such load, or the reduction had no ``load_stresses`` of it.
        """
        if name not in self.loads:
            raise ModelError(f"there is no load {brief(name)}.{near(name, self.loads)}")
        if name not in self.load_stresses:
            raise ModelError(
                f"what load '{name}' adds to the stress is not known: give load_stresses= to the "
                f"reduction, {{'{name}': zeros}} for forces, -elasticity times expansion for heat"
            )
        return self.load_stresses[name]

    @checked
    def save(self, path: Path) -> Path:
        """Write the component to an ``.npz`` file, which :func:`load` reads.

        Args:
            path: Of the file; one that exists is replaced.

        Returns:
            The path.

        Raises:
            ModelError: the file cannot be written.
        """
        from .storage import save

        return save(self, Path(path))

    def _coordinates(self, z: ArrayLike, who: str) -> Array:
        values = numbers(f"{who}: z", z)
        if not values.ndim or values.shape[-1] != self.n:
            raise ArgumentError(f"{who}: shape {values.shape}, expected (..., {self.n})")
        return values

    def _locked(self, names: Sequence[str]) -> Integers:
        """Places of motions of interfaces by the names of these or of interfaces."""
        labels = self.labels[: self.n_boundary]
        by_name = {frame.name: frame.labels for frame in self.interfaces}
        places: set[int] = set()
        for name in names:
            motions = by_name.get(name, (name,))
            if not {*motions} <= {*labels}:
                raise ModelError(
                    f"locked: there is no interface {brief(name)} and no motion of that name."
                    f"{near(name, [*by_name, *labels])}"
                )
            places |= {labels.index(one) for one in motions}
        return np.array(sorted(places), dtype=np.intp)

    def __repr__(self) -> str:
        boundary, modal = self.n_boundary, self.n - self.n_boundary
        names = ", ".join(
            f"'{one.name}' ({counted(len(one.components), 'motion')}, {one.rigid})"
            for one in self.interfaces
        )
        chosen = ", ".join(f"{x:.6g}" for x in self.frequencies[:MAX_PRINTED])
        more = len(self.frequencies) - MAX_PRINTED
        lost = ", ".join(f"{x:.6g}" for x in self.dropped)
        mass, inertia = self.properties, np.array(self.properties.inertia)
        center = ", ".join(f"{x:.6g}" for x in mass.center)
        moments = ", ".join(f"{x:.6g}" for x in inertia.diagonal())
        products = ", ".join(f"{x:.3g}" for x in inertia[[0, 0, 1], [1, 2, 2]])
        density = "" if np.isnan(self.density) else f", about {self.density:.3g} kg/m^3"
        lines = [
            f"{self.method}: {counted(len(self.dofs), 'row')} of "
            f"{counted(len(self.dofs.positions), 'node')} reduced to {self.n}: {boundary} of "
            f"interfaces, {modal} modal",
            f"  interfaces   {names}",
            f"  frequencies  {chosen or 'none'}{f', ... {more} more' if more > 0 else ''} rad/s, "
            f"{self.modes_of}",
            f"  left out     {lost or 'none'}{' rad/s and above' if lost else ''}",
            f"  mass         {mass.mass:.9g} kg, center ({center}) m",
            f"  inertia      {moments} kg m^2 (xx, yy, zz); {products} (xy, xz, yz)",
            f"  rigid        K R relative: {rigid_text(self.check)}; largest at {self.check.row}",
            f"  self-stress  {max(self.check.self_stress[:3]):.2e} N for 1 m, "
            f"{max(self.check.self_stress[3:]):.2e} for 1 rad",
            f"  material     sound at about {self.sound:.3g} m/s{density}",
        ]
        if self.anisotropy > ISOTROPIC:
            lines.append(
                f"  inertia in a turning frame is approximate: M depends on directions by "
                f"{self.anisotropy:.1e}, as consistent masses of beams and shells do"
            )
        if self.massless:
            lines.append(f"  massless     {self.massless} coordinates: M has no inverse")
        return "\n".join([*lines, *self._free_lines(), *(f"  note: {x}" for x in self.notes)])

    def _free_lines(self) -> list[str]:
        """The lowest free modes with their errors."""
        try:
            free = self.modes()
        except SolveError as error:
            return [f"  no free modes: {error}"]
        return [
            f"  free mode {k + 1}  {free.frequencies[k]:.9g} rad/s, error about "
            f"{free.estimates[k]:.1e}, at most {free.bounds[k]:.1e}"
            for k in range(min(len(free.frequencies), 6))
        ]
