"""Interface of the treatments of constraints."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import fields
from typing import Any, ClassVar, cast

from ....arguments import check_fields
from ....errors import ArgumentError
from ....ir.graph import ZERO, SystemNames
from ....ir.matrix import Matrix
from ....ir.solve import solve
from ....literature import HasSource
from ....records import dataclass

# of a number whose square is a constant of an expression
LARGEST = 1e100


@dataclass(frozen=True)
class Labels:
    """Names for the reader: of speeds, constraints, and the system for the multipliers."""

    speeds: tuple[str, ...] = ()
    rows: tuple[str, ...] = ()
    system: str = "circuit"
    right: str = "free_gamma"


@dataclass(frozen=True)
class Bound:
    """M udot = drive + Gᵀ lam with G udot = gamma.

    Attributes:
        mass: M (nu, nu).
        drive: tau + f - h (nu, 1).
        jacobian: G (m, nu), rows of position level first.
        gamma: (m, 1).
        position: g (mp, 1), of the first mp rows.
        rates: G u + g_t (m, 1).
        labels: Names of speeds and rows.
    """

    mass: Matrix
    drive: Matrix
    jacobian: Matrix
    gamma: Matrix
    position: Matrix
    rates: Matrix
    labels: Labels = Labels()


class Treatment(HasSource, ABC):
    """A way to make accelerations obey constraints."""

    name: ClassVar[str]
    # whether the accelerations fulfil the constraints to rounding
    exact: ClassVar[bool]

    def __post_init__(self) -> None:
        check_fields(self)
        for field in fields(cast(Any, self)):
            value = getattr(self, field.name)
            if isinstance(value, float) and not 0 <= value <= LARGEST:
                raise ArgumentError(
                    f"{type(self).__name__}: {field.name}={value:g}: give a number of at least 0, "
                    f"and at most {LARGEST:g}"
                )

    @abstractmethod
    def accelerations(self, bound: Bound) -> tuple[Matrix, Matrix]:
        """udot (nu, 1) and the multipliers lam (m, 1)."""


def by_multipliers(bound: Bound, gamma: Matrix, compliance: float = 0.0) -> tuple[Matrix, Matrix]:
    """udot and lam with G udot + compliance lam = gamma, column by column of drive and gamma.

    M is eliminated in static order, ``factor = L, D: M = Lᵀ D L, free_udot = M⁻¹ drive,
    response = M⁻¹ Gᵀ``; what is left, loop = G response, is factored with pivoting for
    ``multipliers = loop⁻¹ (gamma - G free_udot)``; then
    ``udot = free_udot + response multipliers``.
    """
    bound.mass.graph.describe(by_multipliers)
    G, count, labels = bound.jacobian, bound.drive.columns, bound.labels
    names = SystemNames("M", labels.speeds, ("free",) * (count == 1) + labels.rows)
    with G.graph.made_by("constraints", "factor"):
        both = solve("spd", bound.mass, Matrix.hstack(bound.drive, G.T), names)
    rows = slice(0, both.rows)
    free, answers = both.block(rows, slice(0, count)), both.block(rows, slice(count, both.columns))
    circuit, right = (G @ answers).mirrored, gamma - G @ free
    for row, name in enumerate(labels.rows):
        answers.column(row).hint(name, "response", labels.speeds)
        circuit.block(slice(row, row + 1)).hint(labels.system, name, labels.rows[: row + 1])
    if count == 1:
        free.hint("free_udot", "", labels.speeds)
        right.hint(labels.right, "", labels.rows)
    names = SystemNames(labels.system, labels.rows, ("lam",))
    if compliance:
        circuit = circuit + Matrix.identity(G.graph, G.rows) * compliance
        lam = solve("spd", circuit, right, names)
    else:
        lam = solve("semidefinite", circuit, right, names)
    return free + answers @ lam, lam


def by_penalty(
    bound: Bound, gamma: Matrix, weight: float, repetitions: int
) -> tuple[Matrix, Matrix]:
    """udot and lam of a penalty, with multipliers that take over its forces again and again."""
    G = bound.jacobian
    stiff = (bound.mass + G.T @ G * weight).mirrored
    lam = Matrix.zeros(G.graph, G.rows)
    for _ in range(repetitions + 1):
        udot = solve("spd", stiff, bound.drive + G.T @ (gamma * weight + lam))
        lam = lam + (gamma - G @ udot) * weight
    return udot, lam


def by_motions(bound: Bound, one: Matrix, projector: Matrix) -> tuple[Matrix, Matrix]:
    """udot = one + Z y from the balance along the motions, and the lam that goes with it.

    Args:
        bound: The equations.
        one: An acceleration that fulfils the constraints (nu, 1).
        projector: X (nu, nu), a projector whose complement Z = 1 - X leads onto all G Z = 0.
    """
    G, M = bound.jacobian, bound.mass
    n = M.rows
    motions = Matrix.identity(G.graph, n) - projector
    # X Z = 0: what X adds makes the matrix regular and changes nothing along Z
    masses = [M[i, i].node if i == j else ZERO for i in range(n) for j in range(n)]
    inertia = motions.T @ (M @ motions) + projector.T @ (Matrix(G.graph, n, n, masses) @ projector)
    y = solve("semidefinite", inertia.mirrored, motions.T @ (bound.drive - M @ one))
    udot = one + motions @ y
    missing = M @ udot - bound.drive
    return udot, solve("semidefinite", (G @ G.T).mirrored, G @ missing)


def stabilized(bound: Bound, frequency: float, damping: float) -> Matrix:
    """gamma - 2 damping frequency gdot - frequency² g (m, 1); velocity rows have no g."""
    m, g = bound.rates.rows, bound.position
    if m > g.rows:
        g = Matrix.vstack(g, Matrix.zeros(bound.rates.graph, m - g.rows))
    return bound.gamma - bound.rates * (2 * damping * frequency) - g * (frequency * frequency)
