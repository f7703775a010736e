"""Interfaces: frames by which a component is connected to others, and what moves with them.

The unknowns behind an interface are the motions of its frame. A node with rotations is a frame
itself. A spider makes one of several nodes: ``"rbe2"`` carries them like a rigid body, ``"rbe3"``
follows their mean motion by least squares and leaves them elastic.

Source: MSC Nastran, Quick Reference Guide, RBE2 and RBE3.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array, Integers
from ..errors import ModelError, brief, near
from ..records import dataclass
from .node_dofs import COMPONENTS, NodeDofs, component_names, rigid_rows
from .values import checked_name, numbers

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

SPIDERS = ("rbe2", "rbe3")
FARTHEST = 1e5  # of an origin from its nodes, in sizes of the interface
RANK = 1e-8  # of singular values, with rotations in lengths of the interface
MOST_AVERAGED = 2000  # nodes of an rbe3, all of which become connected with each other


@dataclass(frozen=True)
class InterfaceFrame:
    """A frame by which a component is connected to others.

    Attributes:
        name: By which users know it.
        position: Its origin (3,) [m]; its axes are those of the component.
        components: Its motions, such as ``("x", "y", "z", "rx", "ry", "rz")``.
        nodes: Numbers of the nodes that it stands for.
        rigid: ``"node"``, ``"rbe2"`` or ``"rbe3"``.
    """

    name: str
    position: tuple[float, float, float]
    components: tuple[str, ...]
    nodes: tuple[int, ...]
    rigid: str

    @property
    def labels(self) -> tuple[str, ...]:
        """Its motions by name, such as ``"hinge.rx"``."""
        return tuple(f"{self.name}.{one}" for one in self.components)


@dataclass(frozen=True)
class Connection:
    """Motions of all rows by those of the interfaces and of what is elastic behind them.

    Attributes:
        frames: The interfaces.
        matrix: Rows from unknowns: those of the frames first (n, n_b + n_i).
        interior: Rows that are unknowns themselves (n_i,).
    """

    frames: tuple[InterfaceFrame, ...]
    matrix: Sparse
    interior: Integers

    @property
    def n_boundary(self) -> int:
        """Motions of all interfaces together, n_b."""
        return sum(len(frame.components) for frame in self.frames)

    def rigid(self, dofs: NodeDofs, about: Array) -> Array:
        """Rigid motions (n_b + n_i, 6) in the unknowns."""
        blocks = [frame_motions(frame, about) for frame in self.frames]
        return np.vstack([*blocks, dofs.rigid(about, self.interior)])


def frame_motions(frame: InterfaceFrame, about: Array) -> Array:
    """Motions of an interface by rigid motions of the component (its motions, 6)."""
    component = np.array([COMPONENTS.index(one) for one in frame.components])
    arm = np.asarray(frame.position) - about
    return rigid_rows(np.tile(arm, (len(component), 1)), component)


def connect(
    dofs: NodeDofs,
    interface: Mapping[str, object],
    rigid: str | Mapping[str, str] = "rbe2",
    at: Mapping[str, object] | None = None,
    frame_dofs: str | Sequence[str] | None = None,
) -> Connection:
    """Frames of interfaces, and the motions of all rows by the unknowns that remain.

    Args:
        dofs: Of the component.
        interface: A node, or nodes, for each interface by name.
        rigid: How several nodes make a frame, for all interfaces or by name.
        at: Origins of frames (3,) [m]; the mean position of its nodes by default.
        frame_dofs: Motions of the frames; those that a rigid body has in the component by default.

    Raises:
        ModelError: nodes that do not exist, two interfaces over one node, or nodes whose motions
            do not determine those of their frame.
    """
    if not interface:
        raise ModelError("interface: give a node or nodes for at least one, {'hinge': 17}")
    components = _motions(dofs, frame_dofs)
    styles = dict.fromkeys(interface, rigid) if isinstance(rigid, str) else dict(rigid)
    origins = dict(at or {})
    for word, named in (("rigid", styles), ("at", origins)):
        for name in named:
            if name not in interface:
                raise ModelError(
                    f"{word}: there is no interface {brief(name)}.{near(name, interface)}"
                )
    from scipy.sparse import coo_matrix

    taken: dict[int, str] = {}
    frames, entries, gone, first = [], [], [np.zeros(0, np.intp)], 0
    for name, selection in interface.items():
        nodes = _nodes(dofs, name, selection)
        for node in nodes:
            if taken.setdefault(int(node), name) != name:
                raise ModelError(
                    f"interface '{name}': node {dofs.ids[node]} belongs to interface "
                    f"'{taken[int(node)]}' too; give it to one of them"
                )
        style = "node" if len(nodes) == 1 else styles.get(name, "rbe2")
        if style not in ("node", *SPIDERS):
            raise ModelError(f"interface '{name}': rigid={brief(style)}: give 'rbe2' or 'rbe3'")
        position = origin_of(name, dofs.positions[nodes], origins.get(name))
        ids = tuple(int(k) for k in dofs.ids[nodes])
        names = tuple(COMPONENTS[k] for k in components)
        frame = InterfaceFrame(name, position, names, ids, style)
        rows, tied = _tied(dofs, frame, nodes, components, first)
        frames.append(frame)
        entries += tied
        gone.append(rows)
        first += len(components)
    interior = np.setdiff1d(np.arange(len(dofs)), np.concatenate(gone))
    column = np.zeros(len(dofs), np.intp)
    column[interior] = first + np.arange(len(interior))
    # followers of averages refer to rows that are unknowns
    triples = [(r, c if is_frame else column[c], v) for r, c, v, is_frame in entries]
    row = np.concatenate([interior, *(r for r, _, _ in triples)])
    columns = np.concatenate([column[interior], *(c for _, c, _ in triples)])
    values = np.concatenate([np.ones(len(interior)), *(v for _, _, v in triples)])
    shape = (len(dofs), first + len(interior))
    matrix = coo_matrix((values, (row, columns)), shape=shape).tocsc()
    return Connection(tuple(frames), matrix, interior)


def _motions(dofs: NodeDofs, frame_dofs: str | Sequence[str] | None) -> tuple[int, ...]:
    """Motions of frames: all six in space, those of the nodes in a plane or along a line."""
    if frame_dofs is not None:
        return component_names(frame_dofs, "frame_dofs")
    present = np.unique(dofs.component)
    return tuple(range(6)) if {0, 1, 2} <= {*present} else tuple(int(k) for k in present)


def _nodes(dofs: NodeDofs, name: str, selection: object) -> Integers:
    """Places of the nodes of an interface."""
    if "." in checked_name("interface", name):
        raise ModelError(f"interface {brief(name)}: give a name without a dot, such as 'hinge'")
    numbers = np.asarray(selection)
    if numbers.dtype.kind not in "iu" or numbers.ndim > 1 or not numbers.size:
        raise ModelError(
            f"interface '{name}': {brief(selection)}; give a node or nodes, such as [3, 4]"
        )
    nodes = dofs.places(numbers.reshape(-1), f"interface '{name}'")
    if len({*nodes}) != len(nodes):
        raise ModelError(f"interface '{name}': a node is there twice; give each once")
    return nodes


def check_stiffening(stiffening: str, names: Collection[str]) -> None:
    """Make sure that ``stiffening=`` is an interface.

    Raises:
        ModelError: there is no interface of that name.
    """
    if stiffening not in names:
        raise ModelError(
            f"stiffening={brief(stiffening)}: there is no interface of that name."
            f"{near(stiffening, names)}"
        )


def origin_of(name: str, positions: Array, selection: object) -> tuple[float, float, float]:
    """Origin of a frame; that of a single node is the node."""
    if selection is None:
        return tuple(float(x) for x in positions.mean(axis=0))  # type: ignore[return-value]
    origin = numbers(f"at: '{name}'", selection)
    if origin.shape != (3,) or not np.isfinite(origin).all():
        raise ModelError(f"at: '{name}' is {brief(selection)}; give three finite numbers [m]")
    middle = positions.mean(axis=0)
    distance, size = float(np.linalg.norm(origin - middle)), float(np.ptp(positions, axis=0).max())
    if size > 0 and distance > FARTHEST * size:
        raise ModelError(
            f"at: '{name}' lies {distance:.3g} m from its nodes, which are within {size:.3g} m of "
            "each other; give the origin of the frame in meters, near to them"
        )
    return tuple(float(x) for x in origin)  # type: ignore[return-value]


def _tied(
    dofs: NodeDofs, frame: InterfaceFrame, nodes: Integers, components: tuple[int, ...], first: int
) -> tuple[Integers, list[tuple[Integers, Integers, Array, bool]]]:
    """Rows that follow a frame, and the entries by which they do."""
    rows = dofs.rows_of(nodes)
    if frame.rigid == "rbe3":
        rows = rows[dofs.component[rows] < 3] if len(nodes) > 2 else rows
    if frame.rigid == "node":
        # a frame of fewer motions leaves the others of its node elastic, as a pin does
        rows = rows[np.isin(dofs.component[rows], components)]
    about = np.asarray(frame.position)
    motions = dofs.rigid(about, rows)
    arms = np.linalg.norm(dofs.positions[nodes] - about, axis=1)
    _check_rank(frame, motions, components, float(arms.max(initial=0.0)) or 1.0)
    columns = first + np.arange(len(components))
    if frame.rigid != "rbe3":
        return rows, [_block(rows, columns, motions[:, list(components)], True)]
    if len(nodes) > MOST_AVERAGED:
        gigabytes = (3 * len(nodes)) ** 2 * 8e-9
        raise ModelError(
            f"interface '{frame.name}': a mean over {len(nodes)} nodes connects each with all "
            f"others, {gigabytes:.1f} GB; take every n-th node, or rigid='rbe2'"
        )
    from scipy.linalg import qr

    # motions of the frame = mean (motions of the nodes), solved for as many rows as it has motions
    mean = np.linalg.pinv(motions[:, list(components)])
    _, _, pivots = qr(mean, mode="economic", pivoting=True)
    dependent, free = pivots[: len(components)], np.sort(pivots[len(components) :])
    inverse = np.linalg.inv(mean[:, dependent])
    by_frame = _block(rows[dependent], columns, inverse, True)
    by_nodes = _block(rows[dependent], rows[free], -inverse @ mean[:, free], False)
    return rows[dependent], [by_frame, by_nodes]


def _block(
    rows: Integers, columns: Integers, values: Array, is_frame: bool
) -> tuple[Integers, Integers, Array, bool]:
    """Entries of a dense block."""
    row, column = np.meshgrid(rows, columns, indexing="ij")
    nonzero = values != 0
    return row[nonzero], column[nonzero], values[nonzero], is_frame


def _check_rank(
    frame: InterfaceFrame, motions: Array, components: tuple[int, ...], length: float
) -> None:
    """Refuse nodes that do not determine the motions of their frame, or that have more of them.

    Raises:
        ModelError: it names the motions.
    """
    scale = np.array([1.0] * 3 + [1.0 / length] * 3)
    scaled = motions * scale
    # with as many rows as columns at least, all directions; of many nodes, no more than these
    padded = np.vstack([scaled[:, list(components)], np.zeros((len(components),) * 2)])
    _, values, directions = np.linalg.svd(padded, full_matrices=False)
    lost = directions[values <= RANK * max(values[0], 1e-300)]
    if len(lost):
        weak = abs(lost).max(axis=0) > 0.3
        names = ", ".join(
            COMPONENTS[k] for k, is_lost in zip(components, weak, strict=True) if is_lost
        )
        able = " ".join(COMPONENTS[k] for k, gone in zip(components, weak, strict=True) if not gone)
        count = "a single node" if len(frame.nodes) == 1 else f"{len(frame.nodes)} nodes"
        raise ModelError(
            f"interface '{frame.name}': the motions of {count} do not determine {names} of its "
            f"frame. Give at least three nodes that are not on one line, nodes with rotations, or "
            f"a frame of fewer motions, such as frame_dofs='{able}'"
        )
    full = np.linalg.matrix_rank(scaled, tol=RANK * max(1.0, values[0]))
    if full > len(components):
        missing = " ".join(name for name in COMPONENTS if name not in frame.components)
        raise ModelError(
            f"interface '{frame.name}': its nodes can move like a rigid body in more ways than its "
            f"frame, which lacks {missing}; leave out frame_dofs, or give a single node"
        )
