"""Equations to read: SymPy matrices, LaTeX."""

from __future__ import annotations

from abc import ABC, abstractmethod
from functools import cached_property
from typing import TYPE_CHECKING, Any

from ..errors import DerivationError
from ..ir.function import Block, Function

if TYPE_CHECKING:
    import sympy


class Readable(ABC):
    """The forms for people of equations that can be derived."""

    _read: dict[str, Any]

    @property
    @abstractmethod
    def blocks(self) -> dict[str, Block]:
        """Input blocks by letter."""

    @abstractmethod
    def function(self, name: str, of: str | None = None) -> Function:
        """One function as expressions."""

    @property
    @abstractmethod
    def as_described(self) -> Readable:
        """The same in the frames and numbers of the user."""

    @cached_property
    def symbols(self) -> dict[tuple[str, int], sympy.Symbol]:
        """SymPy symbol of every entry of every block."""
        import sympy

        return {
            (b.name, i): sympy.Symbol(entry)
            for b in self.blocks.values()
            for i, entry in enumerate(b.entries)
        }

    def written(self, name: str) -> sympy.Matrix:
        """A function as a SymPy matrix in readable form.

        Raises:
            DerivationError: an entry is too long to write out; :meth:`symbolic` is not.
        """
        from ..ir.readable import TooLong, readable

        if name not in self._read:
            try:
                self._read[name] = readable(self.as_described.function(name), self.symbols)
            except TooLong as problem:
                raise DerivationError(
                    f"{name} has an entry of {problem.operations:,} operations: too long to write "
                    f"out. Use equations.symbolic('{name}'), which keeps shared intermediates"
                ) from problem
        return self._read[name].copy()

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
        return self.written("applied")

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
    def inertial_parameters(self) -> dict[str, Any]:
        """phi by name, as SymPy expressions of the parameters: ``arm.mass``, ``arm.xx`` ..."""
        names = self.as_described.function("inertial_parameters").outputs[0].entries
        return dict(zip(names, self.written("inertial_parameters"), strict=True))

    def symbolic(self, name: str) -> tuple[list[tuple[Any, Any]], sympy.Matrix]:
        """A function with named intermediates, like :func:`sympy.cse`; for systems of any size.

        Returns:
            (replacements, matrix): (symbol, expression), each in terms of the ones before it. A
            symbol is called after body or joint and quantity, such as ``lower.omega_y``.
        """
        from ..ir.sympy_bridge import to_sympy_shared
        from ..passes.trig import trig

        function = trig(self.as_described.function(name))
        replacements, matrix = to_sympy_shared(function, self.symbols, named=True)
        return replacements, matrix
