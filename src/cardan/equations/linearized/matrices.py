"""Matrices at a reference motion as SymPy and as numbers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import DerivationError, near
from ...ir.function import Function, Output
from ...ir.interpreter import evaluate
from ...ir.matrix import Matrix
from .numbers import by_name
from .reference import Reference
from .reference_input import NOMINAL

if TYPE_CHECKING:
    import sympy


class Written:
    """Named matrices of one reference.

    Args:
        reference: The reference.
        matrices: By name.
    """

    def __init__(self, reference: Reference, matrices: Mapping[str, Matrix]) -> None:
        self.reference, self.matrices = reference, dict(matrices)
        self._read: dict[str, sympy.Expr] = {}

    @property
    def symbols(self) -> dict[tuple[str, int], sympy.Expr]:
        """SymPy symbol of every input entry."""
        import sympy

        by_key = {
            (NOMINAL, k): sympy.Symbol(name) for k, name in enumerate(self.reference.symbols.names)
        }
        return {**self.reference.equations.symbols, **by_key}

    def read(self, name: str) -> sympy.Matrix:
        """A matrix in readable form.

        Raises:
            DerivationError: an entry is too long to write out.
        """
        from ...ir.forms.readable import TooLong, readable

        if name not in self._read:
            try:
                self._read[name] = readable(self.matrices[name], self.symbols)
            except TooLong as problem:
                raise DerivationError(
                    f"{name} has an entry of {problem.operations:,} operations: too long to write "
                    f"out. Use symbolic('{name}'), which keeps shared intermediates, give numbers "
                    "for parameters by derive(specialize=), or at() for numbers alone"
                ) from problem
        return self._read[name].copy()

    def symbolic(self, name: str) -> tuple[list[tuple[sympy.Expr, sympy.Expr]], sympy.Matrix]:
        """A matrix with named intermediates, like :func:`sympy.cse`; of any size."""
        from ...ir.forms.sympy_bridge import to_sympy_shared
        from ...passes.trig import trig

        replacements, matrix = to_sympy_shared(trig(self.function([name])), self.symbols, True)
        x = self.matrices[name]
        return replacements, matrix.reshape(x.rows, x.columns)

    def function(self, names: list[str] | None = None) -> Function:
        """Matrices as a Function of t, the parameters p and the symbols of the reference."""
        outputs = []
        for name in names or list(self.matrices):
            if name not in self.matrices:
                raise DerivationError(
                    f"linearize: there is no matrix '{name}'.{near(name, self.matrices)}"
                )
            x = self.matrices[name]
            outputs.append(Output(name, (x.rows, x.columns), x.nodes))
        at = self.reference
        return Function("linear", at.graph, at.inputs, tuple(outputs), about="a linear model")

    def numbers(self, values_by_name: Mapping[str, object]) -> dict[str, Array]:
        """Values of all matrices.

        Args:
            values_by_name: Parameters, symbols of the reference and ``t`` by name; numbers or
                arrays that broadcast (...). The rest by default.

        Returns:
            Name -> (..., rows, columns).
        """
        values = by_name(self.reference, values_by_name)
        function = self.function()
        results = evaluate(function, values, "numpy")
        batch = np.broadcast_shapes(*(np.shape(x)[:-1] for x in values.values()))
        return {
            o.name: np.broadcast_to(results[o.name], (*batch, *o.shape)).copy()
            for o in function.outputs
        }
