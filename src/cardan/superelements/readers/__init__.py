"""Files with matrices of components: one format is one file here.

Formats are told by endings of names; Abaqus and MatrixMarket share one, and the latter says in its
first line what it is.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from ...arguments import checked
from ...errors import ModelError
from ...regular_file import content
from .abaqus import ABAQUS
from .calculix import CALCULIX
from .matrix_files import MOST_BYTES, ComponentMatricesRecord, MatrixReader
from .matrix_market import MATRIX_MARKET
from .nastran import NASTRAN
from .npz import NPZ

READERS: tuple[MatrixReader, ...] = (NPZ, MATRIX_MARKET, CALCULIX, NASTRAN, ABAQUS)
MARKED = b"%%matrixmarket"


@checked
def read(
    path: Path, mass: Path | None = None, nodes: Path | None = None, dofs: Path | None = None
) -> ComponentMatricesRecord:
    """Mass and stiffness of a component out of files.

    Args:
        path: The stiffness, or both matrices: ``.npz``, MatrixMarket ``.mtx``, CalculiX ``.sti``,
            Nastran DMIG ``.pch``, Abaqus matrix text.
        mass: The mass; beside the stiffness by default where the program names it so.
        nodes: Positions [m]: x, y, z in each line, with numbers of nodes before them, or the input
            of the program.
        dofs: Node and direction of each row, for CalculiX.

    Returns:
        The matrices, with ``reduce()``.

    Raises:
        ModelError: a file that is missing, of another kind or damaged; it names the line.
    """
    main = Path(path)
    files = {role: file for role, file in companions(main).items() if _is_written(role, file)}
    chosen = {"mass": mass, "nodes": nodes, "dofs": dofs}
    return read_files(main, files | {role: Path(x) for role, x in chosen.items() if x is not None})


def read_files(main: Path, roles: Mapping[str, Path]) -> ComponentMatricesRecord:
    """Mass and stiffness of a component out of these files and no others.

    Args:
        main: The stiffness, or both matrices.
        roles: Files of mass, nodes and dofs, as far as there are such.

    Raises:
        ModelError: as :func:`read`.
    """
    contents = {"stiffness": _content(main)}
    reader = _reader(main, contents["stiffness"])
    names = {"stiffness": str(main)}
    for role, file in roles.items():
        contents[role], names[role] = _content(file), str(file)
    if reader in (MATRIX_MARKET, ABAQUS) and "mass" not in contents:
        raise ModelError(f"{main}: it has the stiffness alone; give mass=, the other file")
    for role, ending in reader.companions.items():
        if role != "nodes" and role not in contents:
            raise ModelError(
                f"{main}: there is no file {main.stem}{ending} beside it; give {role}="
            )
    return reader.read(contents, names)


def companions(main: Path) -> dict[str, Path]:
    """Files that the program of a file writes beside it, by their roles."""
    endings = (x.companions for x in READERS if main.suffix.lower() in x.endings)
    return {role: main.with_suffix(ending) for one in endings for role, ending in one.items()}


def _is_written(role: str, file: Path) -> bool:
    """False where a program need not write a file: positions may come from elsewhere."""
    return role != "nodes" or file.exists()


def _reader(path: Path, start: bytes) -> MatrixReader:
    """The kind of a file by its name and, where two share an ending, by its beginning."""
    marked = start[:64].lower().startswith(MARKED)
    for reader in READERS:
        if path.suffix.lower() in reader.endings and (reader is not MATRIX_MARKET or marked):
            return reader
    endings = ", ".join(f"{one.endings[0]} ({one.name})" for one in READERS)
    raise ModelError(f"{path}: matrices are read from files whose ending is one of {endings}")


def _content(path: Path) -> bytes:
    """Bytes of a file.

    Raises:
        ModelError: it cannot be read.
    """
    try:
        return content(path, MOST_BYTES)
    except FileNotFoundError:
        raise ModelError(f"{path}: there is no such file") from None
    except OSError as error:
        raise ModelError(f"{path} cannot be read: {error.strerror}") from None
    except MemoryError:
        raise ModelError(f"{path} does not fit into memory") from None
