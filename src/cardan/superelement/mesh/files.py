"""Meshes of files: whatever meshio reads, with the names in the file."""

from __future__ import annotations

from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ... import regular_file
from ...arrays import Array, Integers
from ...errors import ModelError, ModelWarning, brief, counted, warn
from .cells import CELLS, FACES, SOLIDS
from .checks import checked_cells, checked_points
from .record import Mesh, from_arrays

if TYPE_CHECKING:
    import meshio

KINDS = {cell.meshio: cell.kind for cell in CELLS.values()}
# cells of meshio that have a volume: none of them may be left out in silence
VOLUMES = ("tetra", "hexahedron", "wedge", "pyramid", "polyhedron", "VTK_LAGRANGE")
GEOMETRY = "gmsh:"  # sets that describe the geometry of Gmsh, not names of the user


@dataclass
class Contents:
    """What a file has, in its numbering of nodes.

    Attributes:
        points: Positions (nodes, 3), in the unit of the file.
        cells: Nodes of solid cells by kind.
        node_sets: Node numbers by name.
        surfaces: Nodes of faces by kind, by name.
        regions: Numbers of solid cells by kind, by name.
    """

    points: Array
    cells: dict[str, Integers] = field(default_factory=dict)
    node_sets: dict[str, Integers] = field(default_factory=dict)
    surfaces: dict[str, dict[str, Integers]] = field(default_factory=dict)
    regions: dict[str, dict[str, Integers]] = field(default_factory=dict)


def read(
    path: str | Path, scale: float | None = None, merge: float | None = None, parts: int = 1
) -> Mesh:
    """Read a mesh from a file of any format that meshio reads, such as Gmsh, Abaqus, Nastran, VTK.

    Names are physical groups of Gmsh, and NSET and ELSET of Abaqus and CalculiX: those of solid
    cells become regions, those of faces surfaces, those of lines and nodes node sets. Nodes that no
    solid cell has are left out, and the others are numbered anew, in their order.

    Args:
        path: The file.
        scale: Length of its unit [m]: 1e-3 for millimeters; meters by default.
        merge: Nodes nearer than this become one [m], the one with the lowest number.
        parts: How many unconnected parts are meant.

    Returns:
        The mesh, checked.

    Raises:
        ModuleNotFoundError: meshio is not installed (extra ``fem``).
        ModelError: the file cannot be read, has no cells of a kind that is treated, or a fault
            that :func:`from_arrays` names.
    """
    source = Path(path).name
    contents = _contents(source, _meshio(Path(path)))
    if merge is not None:
        _merge(source, contents, merge / (1.0 if scale is None else scale))
    _drop_unused(source, contents)
    return from_arrays(
        contents.points,
        contents.cells,
        contents.node_sets,
        contents.surfaces,
        contents.regions,
        scale,
        parts,
        source,
    )


def _meshio(path: Path) -> meshio.Mesh:
    """The mesh as meshio has it.

    Raises:
        ModuleNotFoundError, ModelError: as :func:`read`.
    """
    try:
        import meshio
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(
            "reading a mesh needs meshio, which is not installed: pip install 'cardan[fem]'"
        ) from error
    try:
        regular_file.open_regular(path).close()
    except OSError as error:
        raise ModelError(f"{path}: it cannot be read: {error.strerror}") from error
    said = StringIO()
    try:
        # meshio prints what it thinks, and ends the process where it cannot go on
        with redirect_stdout(said), redirect_stderr(said):
            return meshio.read(path)
    except (Exception, SystemExit) as error:
        lines = said.getvalue().split("\n")
        reason = " ".join(line.strip() for line in lines if line.strip()) or (
            f"{type(error).__name__}: {error}"
        )
        raise ModelError(
            f"{path}: meshio cannot read it ({brief(reason, 200)}). Its ending says what it is, "
            "such as .msh for Gmsh, .inp for Abaqus and CalculiX, .bdf for Nastran, .vtu"
        ) from error


def _contents(source: str, mesh: meshio.Mesh) -> Contents:
    """What a mesh of meshio has of use here, with numbers checked."""
    contents = Contents(checked_points(source, mesh.points, None))
    blocks: dict[str, list[Integers]] = {}
    for block in mesh.cells:
        if block.type not in KINDS and block.type.startswith(VOLUMES):
            raise ModelError(
                f"{source}: it has cells of the kind {block.type}; treated are "
                f"{', '.join(SOLIDS)}: mesh the body with these"
            )
        blocks.setdefault(KINDS.get(block.type, block.type), []).append(block.data)
    joined = {kind: np.concatenate(arrays) for kind, arrays in blocks.items()}
    count = len(contents.points)
    solids = {kind: array for kind, array in joined.items() if kind in SOLIDS}
    contents.cells = checked_cells(source, solids, count)
    for name, rows in _named(source, mesh).items():
        for kind, numbers in rows.items():
            cells = joined[kind]
            if len(numbers) and (numbers.min() < 0 or numbers.max() >= len(cells)):
                raise ModelError(f"{source}: set '{name}' has a {kind} cell that does not exist")
            if kind in SOLIDS:
                contents.regions.setdefault(name, {})[kind] = numbers
            elif kind in FACES:
                faces = {kind: cells[numbers]}
                checked = checked_cells(f"{source}: surface '{name}'", faces, count, dimension=2)
                contents.surfaces.setdefault(name, {}).update(checked)
            else:
                _add_nodes(source, contents, name, cells[numbers].ravel())
    for name, numbers in mesh.point_sets.items():
        _add_nodes(source, contents, name, np.asarray(numbers))
    return contents


def _add_nodes(source: str, contents: Contents, name: str, numbers: Integers) -> None:
    if not len(numbers):
        return
    if numbers.min() < 0 or numbers.max() >= len(contents.points):
        raise ModelError(f"{source}: set '{name}' has a node that does not exist")
    there = contents.node_sets.get(name, np.zeros(0, np.intp))
    contents.node_sets[name] = np.unique(np.concatenate([there, numbers.astype(np.intp)]))


def _named(source: str, mesh: meshio.Mesh) -> dict[str, dict[str, Integers]]:
    """Numbers of cells by kind, all blocks of a kind counted on, by name."""
    result: dict[str, dict[str, list[Integers]]] = {}

    def add(name: str, block: int, numbers: Integers) -> None:
        kind = KINDS.get(mesh.cells[block].type, mesh.cells[block].type)
        before = sum(
            len(mesh.cells[k].data)
            for k in range(block)
            if mesh.cells[k].type == mesh.cells[block].type
        )
        rows = np.asarray(numbers).astype(np.intp) + before
        result.setdefault(name, {}).setdefault(kind, []).append(rows)

    for name, sets in mesh.cell_sets.items():
        if name.startswith(GEOMETRY):
            continue
        if len(sets) > len(mesh.cells):
            raise ModelError(f"{source}: set '{name}' has more blocks than there are cells")
        for block, numbers in enumerate(sets):
            if numbers is not None and len(numbers):
                add(name, block, numbers)
    # older files of Gmsh have a tag for each cell, and names of the tags
    tags = mesh.cell_data.get("gmsh:physical", []) if not result else []
    for name, tag in mesh.field_data.items():
        for block, numbers in enumerate(tags):
            rows = np.flatnonzero(np.asarray(numbers) == tag[0])
            if len(rows) and _dimension(mesh.cells[block].type) == tag[1]:
                add(name, block, rows)
    return {
        name: {kind: np.unique(np.concatenate(rows)) for kind, rows in kinds.items()}
        for name, kinds in result.items()
    }


def _dimension(kind: str) -> int:
    """Dimension of a kind of meshio."""
    if kind in KINDS:
        return CELLS[KINDS[kind]].dimension
    return 1 if kind.startswith("line") else 0 if kind == "vertex" else 2


def _merge(source: str, contents: Contents, distance: float) -> None:
    """Nodes nearer than a distance, in the unit of the file, become one."""
    from scipy.spatial import cKDTree

    if not distance >= 0:
        raise ModelError(f"{source}: merge={distance:g}: give a distance [m], 0 or more")
    _, first, inverse = np.unique(contents.points, axis=0, return_index=True, return_inverse=True)
    target = first[inverse.ravel()].astype(np.intp)
    while True:
        remaining = np.unique(target)
        if len(remaining) < 2:
            break
        near, neighbor = cKDTree(contents.points[remaining]).query(contents.points[remaining], k=2)
        pairs = np.flatnonzero(near[:, 1] <= distance)
        if not len(pairs):
            break
        # each of a pair to the lower one; chains shorten in the next round
        lower = np.arange(len(remaining))
        np.minimum.at(lower, pairs, neighbor[pairs, 1])
        np.minimum.at(lower, neighbor[pairs, 1], pairs)
        replaced = np.arange(len(contents.points))
        replaced[remaining] = remaining[lower]
        target = replaced[target]
    contents.cells = {kind: target[cells] for kind, cells in contents.cells.items()}
    contents.node_sets = {name: np.unique(target[x]) for name, x in contents.node_sets.items()}
    contents.surfaces = {
        name: {kind: target[rows] for kind, rows in kinds.items()}
        for name, kinds in contents.surfaces.items()
    }


def _drop_unused(source: str, contents: Contents) -> None:
    """Leave out nodes that no solid cell has, and what is named of them."""
    used = np.zeros(len(contents.points), bool)
    for cells in contents.cells.values():
        used[cells] = True
    number = np.cumsum(used) - 1
    contents.points = contents.points[used]
    contents.cells = {kind: number[cells] for kind, cells in contents.cells.items()}
    sets = {name: number[x[used[x]]] for name, x in contents.node_sets.items()}
    contents.node_sets = {name: numbers for name, numbers in sets.items() if len(numbers)}
    lost: list[str] = [name for name, numbers in sets.items() if not len(numbers)]
    surfaces: dict[str, dict[str, Integers]] = {}
    for name, kinds in contents.surfaces.items():
        complete = {kind: number[rows[used[rows].all(axis=1)]] for kind, rows in kinds.items()}
        if sum(map(len, complete.values())) < sum(map(len, kinds.values())):
            lost.append(name)
        complete = {kind: rows for kind, rows in complete.items() if len(rows)}
        if complete:
            surfaces[name] = complete
    contents.surfaces = surfaces
    if lost:
        warn(
            f"{source}: {counted(len(lost), 'set')} with nodes or faces of no solid cell, which "
            f"are left out: {', '.join(lost[:8])}",
            ModelWarning,
        )
