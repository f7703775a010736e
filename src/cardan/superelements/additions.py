"""Additions to the matrices of a component: damping, loads, stress, geometric stiffness."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array, Integers
from ..errors import ModelError, brief, near
from ..records import dataclass
from .matrices import symmetric, symmetric_part, well_formed
from .node_dofs import NodeDofs
from .response import modal_damping, reduced_modes
from .values import LARGEST, checked_name, numbers

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix as Sparse

GRAVITY = "gravity"  # the name of a load that every component has
NOWHERE: Integers = np.zeros(0, dtype=np.intp)


@dataclass(frozen=True, eq=False)
class Additions:
    """Damping, loads, stress and geometric stiffness, in the rows of the nodes.

    Attributes:
        C: Damping (rows, rows); None for none.
        ratios: Damping ratios of free modes, the last for those above too; none for no damping.
        alpha, beta: Factors of mass [1/s] and stiffness [s] in the damping.
        loads: Forces by name (rows,).
        static_shapes: Names of loads whose static response is among the shapes.
        stress: Operator (components, rows).
        load_stresses: What loads add to its rows (components,).
        stress_names: Of its rows.
        geometric: Geometric stiffness by name (rows, rows).
    """

    C: Sparse | None
    ratios: Array
    alpha: float
    beta: float
    loads: Mapping[str, Array]
    static_shapes: tuple[str, ...]
    stress: Sparse
    load_stresses: Mapping[str, Array]
    stress_names: tuple[str, ...]
    geometric: Mapping[str, Sparse]

    def damping(self, M: Array, K: Array, rigid: Array, shapes: Array, massless: int) -> Array:
        """Damping in the reduced coordinates (n, n).

        Args:
            M, K: Reduced matrices.
            rigid: Rigid motions (n, r).
            shapes: Displacements of the rows by the coordinates (rows, n).
            massless: Coordinates without mass.
        """
        with np.errstate(over="ignore"):
            C = self.alpha * M + self.beta * K
        if self.C is not None:
            C = C + symmetric_part(shapes.T @ (self.C @ shapes))
        if len(self.ratios):
            free = reduced_modes(M, K, rigid, NOWHERE, massless)
            C = C + modal_damping(free, M, self.ratios)
        if not (abs(C) < LARGEST).all():
            raise ModelError(
                f"C: damping={brief(self.ratios.tolist())} and rayleigh={(self.alpha, self.beta)} "
                f"give entries of {LARGEST:g} and more; give ratios such as 0.01"
            )
        return C

    def static_loads(self, M: Sparse, dofs: NodeDofs) -> Array:
        """Forces (rows, loads) of ``static_shapes``; gravity is weight along all axes."""
        columns = [
            M @ dofs.rigid(np.zeros(3))[:, :3] if name == GRAVITY else self.loads[name][:, None]
            for name in self.static_shapes
        ]
        return np.hstack(columns)


def additions_of(
    dofs: NodeDofs,
    dampings: tuple[object, object, tuple[float, float] | None],
    loading: tuple[Mapping[str, object], Sequence[str]],
    stresses: tuple[object, Sequence[str] | None, Mapping[str, object]],
    geometric: Mapping[str, object],
) -> Additions:
    """What a user adds, checked.

    Args:
        dofs: Rows of the matrices.
        dampings: ``C``, ``damping`` and ``rayleigh`` of the reduction.
        loading: ``loads`` and ``static_shapes``.
        stresses: ``stress``, ``stress_names`` and ``load_stresses``.
        geometric: Geometric stiffness by name.

    Raises:
        ModelError: numbers of another shape, or that are negative or not finite.
    """
    C, damping, rayleigh = dampings
    loads, static_shapes = loading
    stress, stress_names, load_stresses = stresses
    ratios = np.zeros(0) if damping is None else np.atleast_1d(numbers("damping", damping))
    if ratios.ndim != 1 or not np.isfinite(ratios).all() or (ratios < 0).any():
        raise ModelError(
            f"damping={brief(damping)}: give a ratio, or one for each mode, 0 or more, such as 0.01"
        )
    alpha, beta = rayleigh or (0.0, 0.0)
    if alpha < 0 or beta < 0:
        raise ModelError(f"rayleigh={brief(rayleigh)}: give two numbers that are 0 or more")
    forces = {checked_name("loads", name): _load(name, one, dofs) for name, one in loads.items()}
    if GRAVITY in forces:
        raise ModelError(f"loads: '{GRAVITY}' is the weight, which is there already; rename yours")
    names = [static_shapes] if isinstance(static_shapes, str) else [*static_shapes]
    for name in names:
        if name not in (GRAVITY, *forces):
            hint = near(name, [GRAVITY, *forces])
            raise ModelError(f"static_shapes: there is no load {brief(name)}.{hint}")
    rows, labels = _stress(stress, stress_names, dofs)
    return Additions(
        C=None if C is None else symmetric("C", C, dofs),
        ratios=ratios,
        alpha=alpha,
        beta=beta,
        loads=forces,
        static_shapes=tuple(dict.fromkeys(names)),
        stress=rows,
        load_stresses={
            name: _load_stress(name, one, forces, len(labels))
            for name, one in load_stresses.items()
        },
        stress_names=labels,
        geometric={
            checked_name("geometric", name): symmetric(f"geometric '{name}'", one, dofs)
            for name, one in geometric.items()
        },
    )


def _load(name: str, values: object, dofs: NodeDofs) -> Array:
    """Forces in the rows of the nodes."""
    force = numbers(f"loads: '{name}'", values)
    if force.shape != (len(dofs),):
        raise ModelError(
            f"loads: '{name}' has shape {force.shape}, expected ({len(dofs)},): a force in each row"
        )
    bad = np.flatnonzero(~(abs(force) < LARGEST))
    if len(bad):
        raise ModelError(f"loads: '{name}' is {force[bad[0]]} at {dofs.label(bad[0])}")
    return force


def _load_stress(name: str, values: object, loads: Mapping[str, Array], rows: int) -> Array:
    """What a load adds to the rows of stress (rows,)."""
    if name not in loads:
        raise ModelError(f"load_stresses: there is no load {brief(name)}.{near(name, loads)}")
    stress = numbers(f"load_stresses: '{name}'", values)
    if stress.shape != (rows,) or not (abs(stress) < LARGEST).all():
        raise ModelError(
            f"load_stresses: '{name}' has shape {stress.shape}; give a finite number for each of "
            f"the {rows} rows of stress="
        )
    return stress


def _stress(
    operator: object, names: Sequence[str] | None, dofs: NodeDofs
) -> tuple[Sparse, tuple[str, ...]]:
    """Operator of stress by the rows of the nodes, and names of its rows."""
    from scipy.sparse import csr_matrix, issparse

    if operator is None:
        if names is not None:
            raise ModelError("stress_names: give stress= too, the rows that they name")
        return csr_matrix((0, len(dofs))), ()
    entries = (
        well_formed("stress", operator)
        if issparse(operator)
        else np.atleast_2d(numbers("stress", operator))
    )
    if entries.ndim != 2 or entries.shape[1] != len(dofs):
        raise ModelError(f"stress: shape {entries.shape}, expected (components, {len(dofs)})")
    rows = csr_matrix(entries, dtype=np.float64)
    if not (abs(rows.data) < LARGEST).all():
        raise ModelError(
            f"stress: an entry is not finite, or {LARGEST:g} and more; write the operator again"
        )
    labels = tuple(names) if names is not None else tuple(f"{k}" for k in range(rows.shape[0]))
    for one in labels:
        checked_name("stress_names", one)
    if len(labels) != rows.shape[0] or len({*labels}) != len(labels):
        raise ModelError(f"stress_names: {len(labels)} names for {rows.shape[0]} rows, each once")
    return rows, labels
