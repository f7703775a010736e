"""Reduction of the matrices of a component to its interfaces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import checked
from ..arrays import Array
from ..errors import ModelError, ModelWarning, brief, counted, near, warn
from .additions import Additions, additions_of
from .checks import RIGID, check_free, mass_properties, node_notes, rigid_check, unit_notes
from .component import Component
from .error_bounds import residuals
from .inertia import anisotropy, project
from .interfaces import Connection, connect
from .matrices import check_diagonals, square_size, symmetric, symmetric_part
from .methods import METHODS, STATIC
from .node_dofs import NodeDofs, number_rows
from .record import SuperelementRecord
from .section_forces import BeamSections
from .static_shapes import with_static_shapes
from .surface import Surface, surface_of

if TYPE_CHECKING:
    from scipy.sparse import csc_matrix as Sparse

MODES = 10  # by default
INDEPENDENT = 1e-8  # of singular values: rigid motions of nodes on a line or in a plane


@checked
def reduce(
    M: object,
    K: object,
    nodes: ArrayLike,
    interface: Mapping[str, object],
    *,
    method: str = "craig_bampton",
    modes: int | None = None,
    rigid: str | Mapping[str, str] = "rbe2",
    at: Mapping[str, object] | None = None,
    frame_dofs: str | Sequence[str] | None = None,
    node_dofs: str | Sequence[str] | None = None,
    order: str = "node",
    dofs: Sequence[tuple[int, str]] | None = None,
    node_ids: Sequence[int] | None = None,
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
    """A component, reduced to motions of its interfaces and some modes.

    Args:
        M, K, C: Mass, stiffness, damping (rows, rows) [kg, N/m, N s/m; rad], dense or sparse.
        nodes: Positions (n_nodes, 3) [m] in the axes of the component.
        interface: A node, or nodes, for each interface by name: ``{"hinge": 17}``.
        method: ``"craig_bampton"``, ``"rubin"``, ``"macneal"`` or ``"guyan"``.
        modes: How many, lowest first; 10 by default, none for ``"guyan"``.
        rigid: Nodes make a frame ``"rbe2"`` rigidly or ``"rbe3"`` by their mean; one, or by name.
        at: Origins of frames by name (3,) [m]; the mean position of their nodes by default.
        frame_dofs: Motions of the frames; by default six in space, those of the nodes in a plane.
        node_dofs: Motions of a node; ``"x y z"`` for three rows each, ``"x y z rx ry rz"`` for six.
        order: Of the rows: ``"node"`` (all of node 0 first) or ``"component"`` (x of all first).
        dofs, node_ids: Node and motion of each row, ``[(17, "x"), ...]``; numbers of the nodes.
        damping, rayleigh: Modal ratio, one or each of free modes; a, b [1/s, s] of C = a M + b K.
        loads: Forces in the rows (rows,) by name, such as those by a unit rise of temperature.
        static_shapes: Loads and ``"gravity"`` whose static response is among the shapes.
        stress, stress_names: Rows of stress by the rows of K (components, rows), and their names.
        load_stresses: What loads add to these rows without displacements (components,) by name.
        geometric: Geometric stiffness (rows, rows) by name, for loads of unit size.
        triangles, lines: Nodes of what pictures draw (triangles, 3), (lines, 2).
        supported, make_free: K includes supports; take forces by rigid motions out of K.

    Returns:
        A record to print, save and use in scenes.

    Raises:
        ModelError, SolveError: what does not make a component, named by its row or node.
    """
    numbered = number_rows(
        nodes, square_size("K", K), node_ids=node_ids, node_dofs=node_dofs, order=order, dofs=dofs
    )
    K, M = symmetric("K", K, numbered), symmetric("M", M, numbered)
    return _reduced(
        numbered,
        M,
        K,
        connect(numbered, interface, rigid, at, frame_dofs),
        method=method,
        modes=modes,
        supported=supported,
        make_free=make_free,
        surface=surface_of(numbered, triangles, lines),
        additions=additions_of(
            numbered,
            (C, damping, rayleigh),
            (loads or {}, static_shapes),
            (stress, stress_names, load_stresses or {}),
            geometric or {},
        ),
    )


def _reduced(
    dofs: NodeDofs,
    M: Sparse,
    K: Sparse,
    connection: Connection,
    *,
    method: str,
    modes: int | None,
    supported: bool,
    make_free: bool,
    surface: Surface,
    additions: Additions,
) -> SuperelementRecord:
    """The reduced component by checked matrices."""
    check_diagonals(M, K, dofs)
    count = _mode_count(method, modes, len(connection.interior))
    properties, check = mass_properties(M, dofs), rigid_check(K, dofs)
    if not supported:
        check_free(check)
    sound, density, notes = unit_notes(M, K, dofs, properties.mass)
    notes = [*node_notes(properties, dofs), *notes]
    component = _component(dofs, M, K, connection, supported)
    basis = METHODS[method](component, count)
    component.free_memory()
    if additions.static_shapes:
        forces = connection.matrix.T @ additions.static_loads(M, dofs)
        basis = with_static_shapes(component, basis, forces, additions.static_shapes)
    shapes = connection.matrix @ basis.shapes
    # rigid motions move interfaces alone: constraint modes carry what is behind them
    modal = np.zeros((basis.shapes.shape[1] - component.n_boundary, component.rigid.shape[1]))
    moved = np.vstack([component.rigid[: component.n_boundary], modal])
    stiffness = _freed(basis.K, moved, component.boundary_scale) if make_free else basis.K
    for note in notes:
        warn(note, ModelWarning)
    return SuperelementRecord(
        method=method,
        M=basis.M,
        C=additions.damping(basis.M, stiffness, moved, shapes, basis.massless),
        K=stiffness,
        basis=shapes,
        dofs=dofs,
        interfaces=connection.frames,
        frequencies=basis.frequencies,
        dropped=basis.dropped,
        modes_of=basis.modes_of,
        massless=basis.massless,
        rigid=moved,
        residuals=residuals(component, basis),
        properties=properties,
        check=check,
        sound=sound,
        density=density,
        inertia=project(M, shapes, dofs),
        anisotropy=anisotropy(M, dofs, component.length),
        loads={name: shapes.T @ force for name, force in additions.loads.items()},
        stress=additions.stress @ shapes,
        load_stresses=additions.load_stresses,
        stress_names=additions.stress_names,
        sections=BeamSections(),
        geometric={
            name: symmetric_part(shapes.T @ (one @ shapes))
            for name, one in additions.geometric.items()
        },
        surface=surface,
        notes=tuple(notes),
    )


def _mode_count(method: str, modes: int | None, most: int) -> int:
    """Number of modes that a method shall keep, by default as many as there may be."""
    if method not in METHODS:
        raise ModelError(f"method={brief(method)}: there is no such method.{near(method, METHODS)}")
    if method in STATIC:
        if modes:
            raise ModelError(
                f"modes={modes}: '{method}' has none; take 'craig_bampton', which adds modes to it"
            )
        return 0
    count = min(MODES, most) if modes is None else modes
    if count < 0:
        raise ModelError(f"modes={count}: give 0 or more")
    return count


def _component(
    dofs: NodeDofs, M: Sparse, K: Sparse, connection: Connection, supported: bool
) -> Component:
    """Matrices in the unknowns that the interfaces leave."""
    followed = connection.matrix
    center = dofs.positions.mean(axis=0)
    length = float(np.linalg.norm(dofs.positions - center, axis=1).max()) or 1.0
    K = (followed.T @ K @ followed).tocsc()
    M = (followed.T @ M @ followed).tocsc()
    K, M = ((K + K.T) / 2).tocsc(), ((M + M.T) / 2).tocsc()
    motions = connection.rigid(dofs, center) / np.array([1.0] * 3 + [length] * 3)
    _, values, directions = np.linalg.svd(motions, full_matrices=False)
    independent = motions @ directions[values > INDEPENDENT * values[0]].T
    if supported:
        # those of them that no support resists
        force, size = K @ independent, abs(K) @ abs(independent)
        weighted = force / np.maximum(size.max(axis=1, keepdims=True), 1e-300)
        _, values, directions = np.linalg.svd(weighted, full_matrices=False)
        independent = independent @ directions[values <= RIGID].T
    component = Component(M, K, connection, dofs, center, length, independent)
    _check_fixed(component)
    return component


def _check_fixed(component: Component) -> None:
    """Refuse interfaces that leave the component rigid motions when all of them are fixed.

    Raises:
        ModelError: it says how many, and at which point or about which line.
    """
    rows = component.boundary_scale[:, None] * component.rigid[: component.n_boundary]
    _, values, directions = np.linalg.svd(rows, full_matrices=True)
    rank = int((values > INDEPENDENT * values.max(initial=0.0)).sum())
    mobile = component.rigid @ directions[rank:].T
    if mobile.shape[1]:
        row = int(np.argmax(abs(mobile[:, 0])))
        raise ModelError(
            f"interface: with all of them fixed the component still has "
            f"{counted(mobile.shape[1], 'rigid motion')}, of {component.label(row)} among others. "
            "Leave out frame_dofs, give several nodes to an interface, or more interfaces"
        )


def _freed(K: Array, rigid: Array, boundary_scale: Array) -> Array:
    """Stiffness without forces by rigid motions of the interfaces."""
    n = len(boundary_scale)
    orthonormal, _ = np.linalg.qr(boundary_scale[:, None] * rigid[:n])
    # in lengths, so that rotations and displacements weigh alike
    project = np.eye(n) - orthonormal @ orthonormal.T
    project = project * boundary_scale / boundary_scale[:, None]
    freed = K.copy()
    freed[:n, :n] = symmetric_part(project.T @ K[:n, :n] @ project)
    return freed
