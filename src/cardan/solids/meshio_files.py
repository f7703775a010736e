"""Meshes that meshio reads, such as those of Gmsh, Nastran and VTK."""

from __future__ import annotations

from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Integers
from ..errors import ModelError, brief
from .cells import CELLS, FACES, SOLIDS
from .checks import checked_cells, checked_points
from .contents import Contents

if TYPE_CHECKING:
    import meshio

KINDS = {cell.meshio: cell.kind for cell in CELLS.values()}
# cells of meshio that have a volume: none of them may be left out in silence
VOLUMES = ("tetra", "hexahedron", "wedge", "pyramid", "polyhedron", "VTK_LAGRANGE")
GEOMETRY = "gmsh:"  # sets that describe the geometry of Gmsh, not names of the user


def contents(path: Path) -> Contents:
    """Contents of a file that meshio reads.

    Raises:
        ModuleNotFoundError: meshio is not installed (extra ``fem``).
        ModelError: meshio cannot read it, or its numbers do not fit each other.
    """
    mesh, size = _meshio(path), path.stat().st_size
    # a wrong count in a file: memory for that many was reserved, but never written
    for noun, count in (("nodes", len(mesh.points)), ("cells", sum(map(len, mesh.cells)))):
        if count > size:
            raise ModelError(f"{path.name}: it says that it has {count} {noun}, in {size} bytes")
    return _contents(path.name, mesh)


def _meshio(path: Path) -> meshio.Mesh:
    """The mesh as meshio has it.

    Raises:
        ModuleNotFoundError, ModelError: as :func:`contents`.
    """
    try:
        import meshio
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(
            "reading a mesh needs meshio, which is not installed: pip install 'cardan[fem]'"
        ) from error
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
