"""Equations that say where their terms come from and what their motions keep."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, cast

from ...arguments import checked
from ...notebooks import html
from .conserved import Conserved, conserved
from .contributions import Contribution, contributions

if TYPE_CHECKING:
    from ..finite_elements.record import Absolute
    from ..record import Equations


class Explainable:
    """What :func:`cardan.derive` hands over, in whatever coordinates."""

    _repr_html_ = html

    @checked
    def explain(self, path: str | Path) -> Path:
        """Everything about these equations as a page to read.

        Args:
            path: ``.html`` (self-contained, formulas in MathML), ``.tex`` (compiles by itself) or
                ``.md`` (formulas between dollar signs, the graph in a file beside it).

        Returns:
            The file.

        Raises:
            DerivationError: another ending.
        """
        from ...explain import explain

        return explain(cast("Equations | Absolute", self), path)


class Explained(Explainable):
    """Equations of joint coordinates, which are sums over bodies and forces."""

    @checked
    def contributions(self, name: str) -> tuple[Contribution, ...]:
        """What bodies and force elements add to M, h or f; they add up to the whole.

        Args:
            name: ``"mass_matrix"``, ``"bias"`` or ``"applied"``.

        Returns:
            One for every owner and cause, such as ``("lower", "weight")``, with ``.matrix`` as
            SymPy.

        Raises:
            DerivationError: another name.
        """
        return contributions(cast("Equations", self), name)

    def conserved(self) -> Conserved:
        """Momenta and energy that stay constant, and who takes energy where it does not."""
        return conserved(cast("Equations", self))
