"""Files with matrices of components: one format is one file here.

Formats are told by endings of names; Abaqus and MatrixMarket share one, and the latter says in its
first line what it is.
"""

from __future__ import annotations

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
    contents = {"stiffness": _content(main)}
    reader = _reader(main, contents["stiffness"])
    names = {"stiffness": str(main)}
    chosen = {"mass": mass, "nodes": nodes, "dofs": dofs}
    for role, named in chosen.items():
        file = Path(named) if named is not None else _companion(main, reader, role)
        if file is not None:
            contents[role], names[role] = _content(file), str(file)
    needed = "mass" if reader in (MATRIX_MARKET, ABAQUS) else "stiffness"
    if needed not in contents:
        raise ModelError(f"{main}: it has the stiffness alone; give mass=, the other file")
    return reader.read(contents, names)


def _companion(main: Path, reader: MatrixReader, role: str) -> Path | None:
    """The file of a role that the program writes beside another one."""
    if role not in reader.companions:
        return None
    file = main.with_suffix(reader.companions[role])
    # positions may come from elsewhere
    return file if role != "nodes" or file.exists() else None


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
