"""Matrices of a component as files give them, and the kinds of files.

Files may come from anybody: their sizes are limited before memory is taken, numbers are read as
numbers, and what does not fit is refused with its line.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ModelError, counted
from ...records import dataclass
from ..record import SuperelementRecord
from ..reduction import reduce

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

MOST_ROWS = 2_000_000
MOST_ENTRIES = 200_000_000
MOST_BYTES = 1 << 33


@dataclass(frozen=True, eq=False)
class ComponentMatricesRecord:
    """Mass and stiffness of a component, read from files.

    Attributes:
        M, K: Sparse (rows, rows) [kg, N/m].
        nodes: Positions (n_nodes, 3) [m]; None where the files have none.
        node_ids: Numbers of the nodes; None for 0, 1, 2, ...
        dofs: Node and motion of each row; None for three or six rows per node in their order.
        source: The files.
    """

    M: Sparse
    K: Sparse
    nodes: Array | None
    node_ids: tuple[int, ...] | None
    dofs: tuple[tuple[int, str], ...] | None
    source: str

    def __repr__(self) -> str:
        entries = f"{counted(int(self.K.nnz), 'entry', 'entries')} of K, {self.M.nnz} of M"
        nodes = "no positions" if self.nodes is None else counted(len(self.nodes), "node")
        return f"{self.source}: {counted(int(self.K.shape[0]), 'row')}, {entries}, {nodes}"


def reduced(
    matrices: ComponentMatricesRecord,
    interface: Mapping[str, object],
    *,
    nodes: Array | None = None,
    method: str = "craig_bampton",
    modes: int | None = None,
    rigid: str | Mapping[str, str] = "rbe2",
    at: Mapping[str, object] | None = None,
    frame_dofs: str | Sequence[str] | None = None,
    node_dofs: str | Sequence[str] | None = None,
    order: str = "node",
    supported: bool = False,
    C: object = None,
    damping: object = None,
    rayleigh: tuple[float, float] | None = None,
    loads: Mapping[str, object] | None = None,
    static_shapes: Sequence[str] = (),
    stress: object = None,
    stress_names: Sequence[str] | None = None,
    load_stresses: Mapping[str, object] | None = None,
    geometric: Mapping[str, object] | None = None,
    triangles: ArrayLike | None = None,
    lines: ArrayLike | None = None,
    make_free: bool = False,
) -> SuperelementRecord:
    """The component, reduced to its interfaces; as :func:`cardan.superelement.reduce`.

    Args:
        matrices: The matrices.
        interface: Nodes by the names of interfaces, by the numbers that the files give them.
        nodes: Positions (n_nodes, 3) [m] where the files have none, nodes in rising numbers.
        method, modes, rigid, at, frame_dofs, node_dofs, order: As there.
        supported, C, damping, rayleigh, loads, static_shapes, stress, stress_names: As there.
        load_stresses, geometric, triangles, lines, make_free: As there.

    Raises:
        ModelError: no positions of nodes, or as there.
    """
    positions = matrices.nodes if nodes is None else nodes
    if positions is None:
        raise ModelError(f"{matrices.source}: no positions of nodes in the files; give nodes=")
    return reduce(
        matrices.M,
        matrices.K,
        positions,
        interface,
        method=method,
        modes=modes,
        rigid=rigid,
        at=at,
        frame_dofs=frame_dofs,
        node_dofs=node_dofs,
        order=order,
        dofs=matrices.dofs,
        node_ids=matrices.node_ids,
        supported=supported,
        C=C,
        damping=damping,
        rayleigh=rayleigh,
        loads=loads,
        static_shapes=static_shapes,
        stress=stress,
        stress_names=stress_names,
        load_stresses=load_stresses,
        geometric=geometric,
        triangles=triangles,
        lines=lines,
        make_free=make_free,
    )


@dataclass(frozen=True)
class MatrixReader:
    """A kind of file.

    Attributes:
        name: Of the program or format.
        endings: Of the files, such as ``(".mtx",)``.
        read: From the contents of the files by their roles, and the names of the files, to a
            component; roles are "stiffness", "mass", "dofs" and "nodes".
        companions: Ending of the files of the other roles where their names are not given.
        untested: True where no file of the program itself was at hand.
    """

    name: str
    endings: tuple[str, ...]
    read: Callable[[Mapping[str, bytes], Mapping[str, str]], ComponentMatricesRecord]
    companions: Mapping[str, str]
    untested: bool = False
