"""Meshes of files, with the names in them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from .. import regular_file
from ..arguments import checked
from ..errors import ModelError
from . import abaqus_files, meshio_files
from .contents import Contents, drop_unused, merge_nodes
from .record import Mesh, from_arrays

# readers by the ending of a file; meshio reads the others
READERS: dict[str, Callable[[Path], Contents]] = {".inp": abaqus_files.contents}


@checked
def read(
    path: str | Path, scale: float | None = None, merge: float | None = None, parts: int = 1
) -> Mesh:
    """Read a mesh from a file: .inp of Abaqus and CalculiX, or any that meshio reads.

    Names are physical groups of Gmsh, and NSET, ELSET and SURFACE of Abaqus and CalculiX: those of
    solid cells become regions, those of faces surfaces, those of lines and nodes node sets. Nodes
    that no solid cell has are left out, and the others are numbered anew, in their order.

    Args:
        path: The file.
        scale: Length of its unit [m]: 1e-3 for millimeters; meters by default.
        merge: Nodes nearer than this become one [m], the one with the lowest number.
        parts: How many unconnected parts are meant.

    Returns:
        The mesh, checked.

    Raises:
        ModuleNotFoundError: meshio is needed and not installed (extra ``fem``).
        ModelError: the file cannot be read, has no cells of a kind that is treated, or a fault
            that :func:`from_arrays` names.
    """
    source = Path(path).name
    try:
        regular_file.open_regular(path).close()
    except OSError as error:
        raise ModelError(f"{path}: it cannot be read: {error.strerror}") from error
    reader = READERS.get(Path(path).suffix.lower(), meshio_files.contents)
    contents = reader(Path(path))
    if scale is not None and not 0 < scale < np.inf:
        raise ModelError(f"{source}: scale={scale:g}: give the length of a unit [m], above 0")
    if merge is not None:
        merge_nodes(source, contents, merge / (1.0 if scale is None else scale))
    drop_unused(source, contents)
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
