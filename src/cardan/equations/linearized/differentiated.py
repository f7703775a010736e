"""The linear model by differentiating the nonlinear equations and putting the reference in."""

from __future__ import annotations

from collections.abc import Sequence

from ...ir.derivative import directional
from ...ir.matrix import Matrix
from ..functions.directions import Direction, directions
from .all_coordinates import Whole
from .outward import outward
from .reference import Reference


def whole(at: Reference) -> Whole:
    """All matrices at the reference."""
    found = {name: at.put(x) for name, x in dynamic(at).items()}
    return Whole(**found, **outward(at, columns))


def dynamic(at: Reference) -> dict[str, Matrix]:
    """What :data:`whole.DYNAMIC` names, and by_z and by_r, at any state."""
    g, nu, own = at.graph, at.system.nu, at.d.constraints
    udot = Matrix(g, nu, 1, at.block("udot"))
    lam = Matrix(g, len(at.names["lam"]), 1, at.block("lam"))
    balance, G = at.balance, own.jacobian
    if lam.rows:
        balance = balance - G.T @ lam
    found = {"M": at.d.mass_matrix, "G": G}
    for name, wrt in (("K", "q"), ("C", "u"), ("by_z", "z"), ("by_r", "r")):
        found[name] = columns(at, balance, directions(at.k, wrt, at.names))
    found["by_r"] = -found["by_r"]
    along = directions(at.k, "q", at.names)
    found["R"] = columns(at, own.rates, along)
    accelerated = G @ udot - own.gamma
    found["Qe"] = columns(at, accelerated, along)
    found["Qv"] = columns(at, accelerated, directions(at.k, "u", at.names))
    return found


def columns(at: Reference, x: Matrix, along: Sequence[Direction]) -> Matrix:
    """Changes of the entries of a vector along directions (rows, len(along))."""
    found = directional(at.graph, x.nodes, [d.seeds for d in along])
    return Matrix(at.graph, x.rows, len(along), [c[i] for i in range(x.rows) for c in found])
