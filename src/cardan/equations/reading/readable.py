"""Equations to read: SymPy matrices, LaTeX."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...arguments import checked
from ...errors import DerivationError
from ..record import EquationRecord

if TYPE_CHECKING:
    import sympy


class Readable(EquationRecord):
    """The forms for people of equations that can be derived."""

    @checked
    def written(self, name: str, of: str | None = None) -> sympy.Matrix:
        """A function as a SymPy matrix in readable form.

        Args:
            name: Such as ``"mass_matrix"``.
            of: Frame or joint of functions that take one: ``written("reaction", of="elbow")``.

        Raises:
            DerivationError: an entry is too long to write out; :meth:`symbolic` is not.
        """
        from ...ir.forms.readable import TooLong, readable

        key = (name, of)
        if key not in self._read:
            try:
                self._read[key] = readable(self.without_rewrites.function(name, of), self.symbols)
            except TooLong as problem:
                names = f"equations.named('{name}'), which names what follows, or " * self.follows
                raise DerivationError(
                    f"{name} has an entry of {problem.operations:,} operations: too long to write "
                    f"out. Use {names}equations.symbolic('{name}'), which keeps shared "
                    "intermediates"
                ) from problem
        return self._read[key].copy()

    @property
    def mass_matrix(self) -> sympy.Matrix:
        """M (nu, nu) as SymPy."""
        return self.written("mass_matrix")

    @property
    def bias(self) -> sympy.Matrix:
        """h (nu, 1) as SymPy: M udot + h = f + tau."""
        return self.written("bias")

    @property
    def forces(self) -> sympy.Matrix:
        """f (nu, 1) as SymPy: applied forces of the model."""
        return self.written("applied_forces")

    @property
    def kinematics(self) -> sympy.Matrix:
        """qdot (nq, 1) as SymPy."""
        return self.written("qdot")

    @property
    def constraints(self) -> sympy.Matrix:
        """g (mp, 1) as SymPy: what vanishes at position level."""
        return self.written("constraints")

    @property
    def constraint_jacobian(self) -> sympy.Matrix:
        """G (m, nu) as SymPy: G udot = gamma."""
        return self.written("constraint_jacobian")

    @property
    def regressor(self) -> sympy.Matrix:
        """Y (nu, n) as SymPy: forces are Y phi and what does not depend on phi."""
        return self.written("regressor")

    @property
    def inertial_parameters(self) -> dict[str, sympy.Expr]:
        """phi by name, as SymPy expressions of the parameters: ``arm.mass``, ``arm.xx`` ..."""
        names = self.without_rewrites.function("inertial_parameters").outputs[0].entries
        return dict(zip(names, self.written("inertial_parameters"), strict=True))

    @property
    def constraint_bias(self) -> sympy.Matrix:
        """gamma (m, 1) as SymPy: G udot = gamma."""
        return self.written("constraint_bias")

    @checked
    def named(self, name: str) -> tuple[list[tuple[sympy.Expr, sympy.Expr]], sympy.Matrix]:
        """A function of a mechanism as books write it, with names for what its loops determine.

        Where loops are solved in closed form, a joint that follows keeps the name of its
        coordinate, ``phi``; ``phi.theta`` is its rate by that of ``theta``, ``phi.theta.theta``
        that of ``phi.theta``, ``phi.bias`` its acceleration at udot = 0 where several speeds move
        it, and ``phi.t`` its rate where they rest. Without such loops nothing needs a name.

        Returns:
            (definitions, matrix): (symbol, expression), each in terms of the ones before it.

        Raises:
            DerivationError: an entry is too long to write out; :meth:`symbolic` is not.
        """
        from .named import named

        if not self.follows:
            return [], self.written(name)
        key = f"named {name}", None
        if key not in self._read:
            self._read[key] = named(self, name)
        definitions, matrix = self._read[key]
        return list(definitions), matrix.copy()

    def _repr_latex_(self) -> str:
        """M udot + h = f + tau in notebooks; the general form where the entries are too long."""
        from .formula import latex

        return rf"$\displaystyle {latex(self)}$"

    @checked
    def symbolic(
        self, name: str, of: str | None = None
    ) -> tuple[list[tuple[sympy.Expr, sympy.Expr]], sympy.Matrix]:
        """A function with named intermediates, like :func:`sympy.cse`; for systems of any size.

        Args:
            name, of: As :meth:`written` takes them.

        Returns:
            (replacements, matrix): (symbol, expression), each in terms of the ones before it. A
            symbol is called after body or joint and quantity, such as ``lower.omega_y``.
        """
        from ...ir.forms.sympy_bridge import to_sympy_shared
        from ...passes.trig import trig

        function = trig(self.without_rewrites.function(name, of))
        replacements, matrix = to_sympy_shared(function, self.symbols, named=True)
        return replacements, matrix
