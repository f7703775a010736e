"""Equations that say where their terms come from and what their motions keep."""

from __future__ import annotations

from ...arguments import checked
from .conserved import Conserved, conserved
from .contributions import Contribution, contributions
from .readable import Readable


class Explained(Readable):
    """Equations of joint coordinates, which are sums over bodies and forces."""

    @checked
    def contributions(self, name: str) -> tuple[Contribution, ...]:
        """Contributions of bodies and force elements to M, h or f; they add up to the total.

        Args:
            name: ``"mass_matrix"``, ``"bias"`` or ``"applied_forces"``.

        Returns:
            One for every owner and cause, such as ``("lower", "weight")``, with ``.matrix`` as
            SymPy.

        Raises:
            DerivationError: another name.
        """
        return contributions(self, name)

    def conserved(self) -> Conserved:
        """Momenta and energy that stay constant, and who takes energy where it does not."""
        return conserved(self)
