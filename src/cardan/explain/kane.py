"""Kane's equations on a page: generalized active and inertia forces, partial velocities.

Source: T. R. Kane and D. A. Levinson, Dynamics: Theory and Applications (1985), chapters 2, 4, 6.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING

from ..equations.reading.book_symbols import BookNotation
from ..equations.reading.contributions import VELOCITIES, WEIGHT, Contribution
from ..equations.reading.vectors import vectors
from ..errors import DerivationError
from ..records import dataclass
from ..schema.blocks import of_rate
from . import content as d

if TYPE_CHECKING:
    import sympy

    from ..equations.reading.explained import Explained

# bodies and speeds of systems whose partial velocities are listed, and operations of each
BODIES, SPEEDS, LONGEST = 12, 12, 200
# where F and F* are too long to write out
BY_FUNCTION = (
    "F and F* are too long to write out: F = f_a less the weight in h, and F* = -(m_rs udot + the "
    "velocity terms in h)."
)
# parts of h that are told apart
CAUSES = (VELOCITIES, WEIGHT)


def label(one: Contribution) -> str:
    """Body or force element, and of which kind its terms are."""
    return f"{one.owner}, {one.cause}" if one.cause in CAUSES else one.owner


@dataclass(frozen=True)
class GeneralizedForces:
    """Generalized active forces F = f - weight and inertia forces F* = -(M udot + velocity terms).

    Attributes:
        equations: Of joint coordinates.
        book: Symbols.
        readable: A function of the equations, by its name, as a SymPy matrix.
        shares: Contributions to a function and its matrix; None where they are too long.
    """

    equations: Explained
    book: BookNotation
    readable: Callable[[str], sympy.Matrix]
    shares: Callable[[str, sympy.Matrix], tuple[Contribution, ...] | None]

    def blocks(self) -> Iterator[d.Block]:
        """F and F*, row by row; nothing where they are too long to write out."""
        import sympy

        try:
            mass, velocities, weight, applied = (
                self.readable(name)
                for name in ("mass_matrix", "coriolis", "gravity", "applied_forces")
            )
        except DerivationError:
            return
        rates = sympy.Matrix([sympy.Symbol(name) for name in self.equations.blocks["udot"].entries])
        active, inertial = self._parts(rates)
        about = "generalized active forces"
        yield from self._rows("active_forces", about, applied - weight, active)
        about = "generalized inertia forces"
        yield from self._rows("inertia_forces", about, -(mass * rates + velocities), inertial)

    def _rows(
        self, quantity: str, about: str, matrix: sympy.Matrix, parts: Mapping[str, sympy.Matrix]
    ) -> Iterator[d.Block]:
        symbol = d.symbol(self.book.sign(quantity))
        if all(entry == 0 for entry in matrix):
            yield d.Paragraph((symbol, f", {about}: zero."))
            return
        yield d.Paragraph((symbol, f", {about}:"))
        for k, (name, value) in enumerate(zip(self.equations.speeds, matrix, strict=True)):
            terms = tuple((who, part[k]) for who, part in parts.items() if part[k] != 0)
            alone = terms[0][0] if len(terms) == 1 else ""
            left = self.book.sign(quantity, of_rate(name))
            yield d.Formula(left, value, () if alone else terms, alone)

    def _parts(
        self, rates: sympy.Matrix
    ) -> tuple[dict[str, sympy.Matrix], dict[str, sympy.Matrix]]:
        """What bodies and force elements add to active and to inertia forces; {} if too long."""
        active: dict[str, sympy.Matrix] = {}
        inertial: dict[str, sympy.Matrix] = {}
        for name in ("mass_matrix", "bias", "applied_forces"):
            shares = self.shares(name, self.readable(name))
            if shares is None:
                return {}, {}
            for one in shares:
                into = active if one.cause == WEIGHT or name == "applied_forces" else inertial
                part = one.matrix if name == "applied_forces" else -one.matrix
                part = part * rates if name == "mass_matrix" else part
                who = label(one) if into is active else one.owner
                into[who] = into[who] + part if who in into else part
        return active, inertial


def partial_velocities(equations: Explained) -> Iterator[d.Section]:
    """Partial velocities of the bodies; nothing for large systems or long expressions."""
    bodies = [part.name for body in equations.system.bodies for part in body.parts]
    if not 0 < len(equations.speeds) <= SPEEDS or len(bodies) > BODIES or equations.follows:
        return
    try:
        rows = tuple(_rows(equations, bodies))
    except DerivationError:
        return
    said = (
        "Derivatives of the velocity of the center of mass, and of the angular velocity, of a body "
        "by the generalized speeds, in axes of the body; those that vanish are left out."
    )
    head = ("body", "speed", "of", "x", "y", "z")
    blocks = (d.Paragraph((said,), quiet=True), d.Table(head, rows))
    yield d.Section("Partial velocities", blocks)


def _rows(equations: Explained, bodies: list[str]) -> Iterator[d.Cells]:
    """Body, speed, which velocity, three components.

    Raises:
        DerivationError: one is too long to read.
    """
    import sympy

    motion = vectors(equations)
    massive = {part.name for body in equations.system.bodies for part in body.parts if part.mass}
    for body in bodies:
        point = motion.center_of_mass(body) if body in massive else motion.position(body)
        kinds = (
            ("velocity", point.dt().express(body)),
            ("angular velocity", motion.angular_velocity(body).express(body)),
        )
        for of, components in kinds:
            for name in equations.speeds:
                partial = [entry.diff(sympy.Symbol(name)) for entry in components]
                if sum(entry.count_ops() for entry in partial) > LONGEST:
                    raise DerivationError(f"a partial velocity of '{body}' is too long to read")
                if any(entry != 0 for entry in partial):
                    cells = (d.Math(sympy.simplify(entry)) for entry in partial)
                    yield (body, d.Math(sympy.Symbol(name)), of, *cells)
