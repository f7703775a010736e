"""Elements whose energy depends on one strain: that of the relative pose of their ends.

The strain of an element of length L is (theta, e) / L less that of its reference shape: theta the
rotation vector of end 2 seen from end 1, and e = d + first theta x d + second theta x (theta x d),
d the position of end 2 in axes of end 1. A member says what ``first`` and ``second`` are, functions
of |theta|², and what stress (m, n) a strain makes.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, ClassVar

from ...ir.arithmetic import Number, Scalar
from ...ir.function import Function, Output
from ...ir.graph import Graph
from ...ir.interpreter import evaluate
from ...ir.matrix import Matrix
from ...records import dataclass
from ...spatial.short_rotations import Slopes
from .element import FlexibleElement, balance, energy, matrix
from .element_ends import NODE, STRESS_UNITS, STRESSES, Ends
from .relative import (
    Relative,
    Response,
    forces,
    mirrored,
    moved,
    tangent,
    transport,
    transport_bend,
    transport_slope,
    upper,
)
from .section import diagonal, flat

STRAINS = ("K1", "K2", "K3", "E1", "E2", "E3")
# the same of the whole element
STRAIN_DATA = ("theta1", "theta2", "theta3", "e1", "e2", "e3")
STRAIN_UNITS = ("rad/m",) * 3 + ("",) * 3


@dataclass(frozen=True)
class Law:
    """Response to a strain; all in angles theta and lengths e of the full element.

    Attributes:
        moment, force: Derivatives of the energy by theta and e (3, 1).
        tangent: Second derivatives (3, 3): by theta and theta, theta and e, e and e.
        energy: (1, 1) [J], where the stress is that of the strain.
        ends: Stress (m, n) at ends 1 and 2, (6, 1) each.
        strains: Strain there beyond that without stress, (6, 1) each.
    """

    moment: Matrix
    force: Matrix
    tangent: tuple[Matrix, Matrix, Matrix]
    energy: Matrix
    ends: tuple[Matrix, Matrix]
    strains: tuple[Matrix, Matrix]


@dataclass(frozen=True)
class Field(ABC):
    """Stress and strain of an element at a relative pose.

    What it stores is y · s less an energy of the stress s alone, s · F s / 2 where it is linear:
    ``stress = s: F s = y, y = (theta, e) - free``.

    Attributes:
        strain: y (6, 1): (theta, e) less what it is without stress.
    """

    strain: Matrix

    @abstractmethod
    def relaxed(self, stress: Matrix) -> Matrix:
        """F s: the strain that belongs to a stress (6, 1)."""

    @abstractmethod
    def solved(self, right: Matrix) -> Matrix:
        """F⁻¹ y: the stress that belongs to a strain (6, 1)."""

    @abstractmethod
    def slope(self, stress: Matrix) -> Matrix:
        """Derivative of y - F s by theta and e at fixed stress (6, 6)."""

    @abstractmethod
    def law(self, stress: Matrix) -> Law:
        """Response of the element to that stress."""


class StrainElement(FlexibleElement):
    """An element with a helicoidal or mean strain.

    The functions ``mixed`` and ``mixed_step`` keep the stress z (6) as an unknown of Newton's
    method: from far away it then takes a few steps where it diverges without. ``mixed`` gives the
    balance [b] and [K] with the stress eliminated; when the increments du of the nodes are known,
    ``mixed_step`` gives the new z, before the nodes are moved; with du = 0 and any z it gives the
    stress there is, from which z starts. At the solution both are ``balance`` and its tangent, and
    z is the stress.

    Attributes:
        mixed: Whether it has them.

    Source: Magisano, Leonetti and Garcea, CMAME 313 (2017).
    """

    mixed: ClassVar[bool] = True

    @property
    def strain(self) -> str:
        return "mixed" if self.carries else "alone"

    @abstractmethod
    def measures(self, at: Relative) -> tuple[Slopes, Slopes]:
        """``first`` and ``second`` of e, functions of |theta|²."""

    @abstractmethod
    def field(self, ends: Ends, at: Relative, e: Matrix) -> Field:
        """Stress and strain at a relative pose with the strain e."""

    def functions(self, ends: Ends) -> dict[str, Function]:
        made_by = ends.graph.made_by
        with made_by("", "pose"):
            at = Relative.of(ends.pose(0), ends.pose(1))
        with made_by("", "strain"):
            first, second = self.measures(at)
            e = transported_strain(at, first, second)
        ends.graph.describe(Field)
        with made_by("", "stress"):
            field = self.field(ends, at, e)
            law = field.law(field.solved(field.strain))
        with made_by("", "response"):
            response = respond(at, first, second, law)
        with made_by("", "loads"):
            loads = forces(at, response.moment, response.force)
        with made_by("", "tangent"):
            stiffness = ends.derivative(tangent(at, response), loads)
        outputs_by_name = {
            "balance": (balance(ends, ends.assembled(loads)),),
            "balance_tangent": (matrix(ends, "K", stiffness),),
            "energy": (energy(None, law.energy),),
            "stress": (stresses(law),),
        }
        plain = {
            name: self.function(ends, name, ends.blocks("q", "p"), *outputs)
            for name, outputs in outputs_by_name.items()
        }
        return plain | (self._mixed(ends, at, field) if self.mixed else {})

    def _mixed(self, ends: Ends, at: Relative, field: Field) -> dict[str, Function]:
        """Balance and tangent at a stress that is not yet that of the strain, and its increment."""
        first, second = self.measures(at)
        stress = unknown(ends)
        gap = (field.strain - field.relaxed(stress)).hint("", "gap", STRAINS)
        slope, law = field.slope(stress), field.law(stress)
        response = respond(at, first, second, law)
        stiffness = ends.derivative(
            tangent(at, response), forces(at, response.moment, response.force)
        )
        # what the missing strain adds to the forces
        added = (slope.T @ field.solved(gap)).hint("", "added", STRESSES)
        shifted = replace(
            law,
            moment=law.moment + added.block(slice(3)),
            force=law.force + added.block(slice(3, 6)),
        )
        mixed_response = respond(at, first, second, shifted)
        loads = ends.assembled(forces(at, mixed_response.moment, mixed_response.force))
        change = moved(at, ends.increments(), first, second)
        missing = (gap + slope @ change).hint("", "missing_strain", STRAINS)
        new = stress + field.solved(missing)
        outputs_by_name = {
            "mixed": (balance(ends, loads), matrix(ends, "K", stiffness)),
            "mixed_step": (increment(new),),
        }
        blocks = ends.blocks("q", "z", "p", "du")
        return {name: self.function(ends, name, blocks, *o) for name, o in outputs_by_name.items()}

    def reference(self) -> Function:
        """theta and e (6) of two poses q: what they are in the reference shape."""
        ends = Ends(Graph(), (NODE, NODE), ())
        at = Relative.of(ends.pose(0), ends.pose(1))
        e = transported_strain(at, *self.measures(at))
        output = Output("reference", (6,), Matrix.vstack(at.turn, e).nodes, STRAINS)
        return self.function(ends, "reference", ends.blocks("q"), output)

    def shapes(self, length: Any, poses: Any) -> dict[str, Any]:
        strain = evaluate(self.reference(), {"q": poses}, "numpy")["reference"]
        density = strain / length[:, None]
        return dict(zip(STRAIN_DATA, strain.T, strict=True)) | dict(
            zip(STRAINS, density.T, strict=True)
        )


def stresses(law: Law) -> Output:
    """Stress at both ends and strain that belongs to it (4, 6)."""
    entries = ("start", "end")
    names = [f"{end}.{x}" for kind in (STRESSES, STRAINS) for end in entries for x in kind]
    units = STRESS_UNITS * 2 + STRAIN_UNITS * 2
    nodes = Matrix.vstack(*law.ends, *law.strains).nodes
    return Output("stress", (4, 6), nodes, tuple(names), units)


def unknown(ends: Ends) -> Matrix:
    """The stress z (6, 1) as an unknown."""
    nodes = [ends.graph.var("z", k) for k in range(len(STRESSES))]
    return flat(ends, Matrix(ends.graph, len(nodes), 1, nodes))


def increment(stress: Matrix) -> Output:
    """The new stress."""
    return Output("z", (len(STRESSES),), stress.nodes, STRESSES, STRESS_UNITS)


def transported_strain(at: Relative, first: Slopes, second: Slopes) -> Matrix:
    """e (3, 1) [m]: ``strain = e: U d, U = 1 + first [theta] + second [theta]²``."""
    at.turn.graph.describe(transported_strain)
    return (transport(at.turn, first, second).note("U") @ at.position).note("e")


def respond(at: Relative, first: Slopes, second: Slopes, law: Law) -> Response:
    """Force and tangent in the increments of the relative pose.

    ``response = m, n: Dᵀ (by_theta + e_by_thetaᵀ by_e), Uᵀ by_e`` and their derivatives.
    """
    at.turn.graph.describe(respond)
    turn, d, slope = at.turn, at.position, at.slope
    transported = transport(turn, first, second).note("U")
    bent = transport_slope(turn, first, second, d).note("e_by_theta")
    # derivatives by theta and d
    by_theta = (law.moment + bent.T @ law.force).note("by_theta")
    force = (transported.T @ law.force).note("by_d")
    theta_theta, theta_e, e_e = law.tangent
    across = (theta_e + bent.T @ e_e).note("across")
    stretching = transported.T.congruence(e_e).note("by_d_d")
    bend = transport_bend(turn, first, second, d, law.force).note("bend")
    both = mirrored(theta_theta + theta_e @ bent + (across @ bent).T + bend).note("by_theta_theta")
    mixed = (across @ transported).T + transport_slope(turn, -first, second, law.force, "n")
    # theta changes by D rho, and D with it
    moment = (slope.T @ by_theta).note("by_rho")
    theta_rho = slope.T @ both + transport_slope(
        turn, Slopes(-0.5), at.inverse, by_theta, "by_theta"
    )
    rho_rho = upper(theta_rho.note("by_theta_rho") @ slope, moment).note("by_rho_rho")
    mixed = (mixed.note("by_d_theta") @ slope).note("by_d_rho")
    return Response(moment, force, rho_rho, mixed, stretching)


@dataclass(frozen=True)
class Elastic(Field):
    """A stress that is proportional to the strain and the same all along the element.

    Attributes:
        stiffness: Stress of the element by its strain (6, 6).
        flexibility: Its inverse; None where that does not exist.
        length: What makes strain of (theta, e) [m].
    """

    stiffness: Matrix
    flexibility: Matrix | None
    length: Number

    @staticmethod
    def of(strain: Matrix, free: Matrix, stiffness: Sequence[Scalar], length: Scalar) -> Elastic:
        """With the stiffness of a section, six numbers, and what (theta, e) is without stress."""
        g = strain.graph
        return Elastic(
            strain - free,
            diagonal(g, [x / length for x in stiffness]),
            diagonal(g, [length / x for x in stiffness]),
            length,
        )

    def relaxed(self, stress: Matrix) -> Matrix:
        assert self.flexibility is not None
        return self.flexibility @ stress

    def solved(self, right: Matrix) -> Matrix:
        return self.stiffness @ right

    def slope(self, stress: Matrix) -> Matrix:
        return Matrix.identity(stress.graph, 6)

    def law(self, stress: Matrix) -> Law:
        upper, below = slice(3), slice(3, 6)
        blocks = ((upper, upper), (upper, below), (below, below))
        first, second, third = (self.stiffness.block(*block) for block in blocks)
        strain = self.strain / self.length
        return Law(
            stress.block(upper),
            stress.block(below),
            (first, second, third),
            stress.T @ self.strain * 0.5,
            (stress, stress),
            (strain, strain),
        )
