"""The linear model by differentiating the nonlinear equations and putting the reference in."""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.derivative import directional
from ...ir.matrix import Matrix
from ..functions.directions import Direction, directions
from .all_coordinates import FullMatrices
from .outward import outward
from .reference import Reference


def full_matrices(at: Reference) -> FullMatrices:
    """All matrices at the reference."""
    at_reference = {name: at.put(x) for name, x in dynamic(at).items()}
    return FullMatrices(**at_reference, **outward(at, columns))


def dynamic(at: Reference) -> dict[str, Matrix]:
    """Matrices of :data:`.all_coordinates.DYNAMIC`, and by_z and by_r, at any state."""
    g, nu, constraints = at.graph, at.system.nu, at.d.constraints
    udot = Matrix(g, nu, 1, at.block("udot"))
    lam = Matrix(g, len(at.names["lam"]), 1, at.block("lam"))
    balance, G = at.balance, constraints.jacobian
    if lam.rows:
        balance = balance - G.T @ lam
    matrices = {"M": at.d.mass_matrix, "G": G}
    for name, wrt in (("K", "q"), ("C", "u"), ("by_z", "z"), ("by_r", "r")):
        matrices[name] = columns(at, balance, directions(at.k, wrt, at.names))
    matrices["by_r"] = -matrices["by_r"]
    along = directions(at.k, "q", at.names)
    matrices["R"] = columns(at, constraints.rates, along)
    accelerated = G @ udot - constraints.gamma
    matrices["Qe"] = columns(at, accelerated, along)
    matrices["Qv"] = columns(at, accelerated, directions(at.k, "u", at.names))
    return matrices


def columns(at: Reference, x: Matrix, along: Sequence[Direction]) -> Matrix:
    """Changes of the entries of a vector along directions (rows, len(along))."""
    slopes = directional(at.graph, x.nodes, [d.seeds for d in along])
    return Matrix(at.graph, x.rows, len(along), [c[i] for i in range(x.rows) for c in slopes])
