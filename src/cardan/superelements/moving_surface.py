"""The surface of a superelement that moves: points by coordinates, and their stress, in files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from functools import lru_cache

import numpy as np

from ..arrays import Array, Integers
from ..records import dataclass
from .coarsening import coarsened
from .record import SuperelementRecord
from .section_forces import COMPONENTS
from .stress_recovery import STRESSES, nodal_rows
from .surface import MOST_POINTS, MOST_TRIANGLES

# of the shapes and stresses of one superelement; meshes with more are coarsened
MOST_NUMBERS = 2_000_000
LARGEST = 1e100  # squares of such numbers exist
FILE = "surfaces.npz"  # of a model
COLUMNS = {"triangles": 3, "lines": 2}


@dataclass(frozen=True, eq=False)
class MovingSurface:
    """Points that move by the coordinates of a superelement, in axes of its frame.

    Behind n coordinates stand factors of loads, which move nothing and may add to the stress.

    Attributes:
        points: Undeformed (points, 3) [m].
        shapes: Displacements by coordinates of 1 (n + loads, points, 3).
        triangles, lines: Between the points (triangles, 3), (lines, 2).
        stressed: Points whose stress is known (k,).
        stresses: Their stress by coordinates of 1 (n + loads, k, 6): xx, yy, zz, yz, zx, xy.
        stations: Arc length of the sections of its beams (sections,) [m].
        section_beams: Which beam each of them is of (sections,).
        section_forces: Theirs by coordinates of 1 (n + loads, sections, 6).
    """

    points: Array
    shapes: Array
    triangles: Integers
    lines: Integers
    stressed: Integers
    stresses: Array
    stations: Array
    section_beams: Integers
    section_forces: Array

    def __post_init__(self) -> None:
        for array in self.arrays().values():
            array.setflags(write=False)

    def arrays(self) -> dict[str, Array]:
        """The arrays by name."""
        return {one.name: getattr(self, one.name) for one in fields(self)}


def entry(name: str, number: int) -> str:
    """Name of an array of the surface of a superelement in files of models and of runs."""
    return f"surface_{name}_{number}"


def stressed_points(record: SuperelementRecord) -> tuple[Integers, Integers]:
    """Points of the surface of a component that have all six components of stress.

    Returns:
        The points (k,) and their rows of stress (k, 6).
    """
    nodes, rows = nodal_rows(record.stress_names, record.dofs.ids)
    place = np.full(len(record.dofs.positions), -1)
    place[nodes] = np.arange(len(nodes))
    of_point = place[record.surface.nodes]
    points = np.flatnonzero(of_point >= 0)
    return points, rows[of_point[points]]


@lru_cache(maxsize=16)
def moving_surface(
    record: SuperelementRecord, rows: tuple[int, ...], loads: tuple[str, ...] = ()
) -> MovingSurface:
    """The surface of a component by some of its coordinates, with few enough numbers for a file.

    Args:
        record: The component.
        rows: Which coordinates move.
        loads: Names of the loads that act. If the record has no ``load_stresses`` of one of them,
            the surface has no stress.
    """
    points, rows_of_stress = stressed_points(record)
    if not record.load_stresses.keys() >= {*loads}:
        points, rows_of_stress = points[:0], rows_of_stress[:0]
    each = len(rows) * (3 + 6 * bool(len(points))) or 1
    most = max(100, MOST_NUMBERS // each)  # points
    surface, positions = record.surface, record.surface_points
    triangles, lines = surface.triangles, surface.lines
    chosen = np.arange(len(positions))
    if len(positions) > most:
        # a closed surface has two triangles for each point
        triangles = coarsened(positions, triangles, most) if len(triangles) else triangles
        used = np.unique(triangles)
        # of lines and loose points every k-th
        chosen = used if len(used) else chosen[:: -(-len(chosen) // most)]
        lines = lines[np.isin(lines, chosen).all(axis=1)]
    place = np.full(len(positions), -1)
    place[chosen] = np.arange(len(chosen))
    drawn = place[points] >= 0
    stresses = record.stress[rows_of_stress[drawn]] if drawn.any() else np.zeros((0, 6, record.n))
    shapes = record.surface_basis[chosen][..., list(rows)].transpose(2, 0, 1)
    added = [record.load_stresses[name][rows_of_stress[drawn]] for name in loads if drawn.any()]
    stress = stresses[..., list(rows)].transpose(2, 0, 1)
    return MovingSurface(
        points=positions[chosen],
        shapes=np.concatenate([shapes, np.zeros((len(loads), *shapes.shape[1:]))]),
        triangles=place[triangles],
        lines=place[lines],
        stressed=place[points[drawn]],
        stresses=np.concatenate([stress, np.reshape(added, (len(loads), *stress.shape[1:]))]),
        stations=record.sections.stations.copy(),
        section_beams=record.sections.numbers,
        section_forces=_section_forces(record, rows, len(loads)),
    )


def _section_forces(record: SuperelementRecord, rows: tuple[int, ...], loads: int) -> Array:
    """Forces in sections (n + loads, sections, 6); those by loads alone are 0 for beams."""
    count = len(record.sections.stations)
    stress = record.stress[: len(COMPONENTS) * count, list(rows)]
    forces = stress.T.reshape(len(rows), count, len(COMPONENTS))
    return np.concatenate([forces, np.zeros((loads, count, len(COMPONENTS)))])


def surface_of_arrays(arrays: Mapping[str, Array], n: int, beams: int = 0) -> MovingSurface:
    """The surface that arrays of a file say; what has no entries may be missing.

    Args:
        arrays: By the names of :class:`MovingSurface`.
        n: Number of coordinates and loads.
        beams: Number of its beams.

    Raises:
        ValueError: sizes that do not fit, points that do not exist, or no numbers.
    """
    points = _numbers(arrays, "points", (-1, 3))
    stressed = _places(arrays, "stressed", (-1,), len(points))
    stations = _numbers(arrays, "stations", (-1,))
    surface = MovingSurface(
        points=points,
        shapes=_numbers(arrays, "shapes", (n, len(points), 3)),
        stressed=stressed,
        stresses=_numbers(arrays, "stresses", (n, len(stressed), len(STRESSES))),
        stations=stations,
        section_beams=_places(arrays, "section_beams", (len(stations),), beams),
        section_forces=_numbers(arrays, "section_forces", (n, len(stations), len(COMPONENTS))),
        **{
            name: _places(arrays, name, (-1, width), len(points)) for name, width in COLUMNS.items()
        },
    )
    if len(np.unique(stressed)) != len(stressed):
        raise ValueError("its surface has two stresses at one point")
    return surface


def _numbers(arrays: Mapping[str, Array], name: str, shape: tuple[int, ...]) -> Array:
    values = _shaped(arrays, name, shape, MOST_POINTS)
    # NaN is not below anything
    if values.dtype.kind != "f" or not (np.abs(values) < LARGEST).all():
        raise ValueError(f"'{name}' of its surface has entries that are not numbers")
    numbers: Array = values.astype(np.float64)
    return numbers


def _places(arrays: Mapping[str, Array], name: str, shape: tuple[int, ...], count: int) -> Integers:
    values = _shaped(arrays, name, shape, max(MOST_TRIANGLES, MOST_POINTS))
    if values.dtype.kind not in "iuf" or not ((values >= 0) & (values < count)).all():
        raise ValueError(f"'{name}' of its surface names points that do not exist")
    if (values != np.floor(values)).any():
        raise ValueError(f"'{name}' of its surface names no points")
    places: Integers = values.astype(np.intp)
    return places


def _shaped(arrays: Mapping[str, Array], name: str, shape: tuple[int, ...], most: int) -> Array:
    """An array of a shape, whose first size may be any up to a limit where it says -1."""
    if name not in arrays:
        return np.zeros([max(size, 0) for size in shape])
    values = np.asarray(arrays[name])
    expected = (len(values) if values.ndim and shape[0] < 0 else shape[0], *shape[1:])
    if values.shape != expected or (shape[0] < 0 and len(values) > most):
        raise ValueError(f"'{name}' of its surface has shape {values.shape}")
    return values
