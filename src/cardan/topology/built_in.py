"""Parameters that are written into the equations as numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from ..errors import ModelError, near
from .system import Parameter


@dataclass
class BuiltIn:
    """What ``specialize=`` asks for.

    Attributes:
        wanted: Names; None for all parameters.
        values: Numbers that replace the defaults.
        found: Names that were met.
    """

    wanted: frozenset[str] | None
    values: dict[str, float] = field(default_factory=dict)
    found: set[str] = field(default_factory=set)

    @staticmethod
    def of(asked: bool | Sequence[str] | Mapping[str, float]) -> BuiltIn | None:
        """From what the user wrote; None for nothing."""
        if isinstance(asked, Mapping):
            return BuiltIn(frozenset(asked), {name: float(x) for name, x in asked.items()})
        if isinstance(asked, bool):
            return BuiltIn(None) if asked else None
        names = (asked,) if isinstance(asked, str) else asked
        return BuiltIn(frozenset(names)) if names else None

    def takes(self, name: str) -> bool:
        """Whether a parameter becomes a number."""
        if self.wanted is not None and name not in self.wanted:
            return False
        self.found.add(name)
        return True

    def finish(self, left: Sequence[Parameter]) -> None:
        """All that was asked for was met.

        Raises:
            ModelError: a name that no parameter has.
        """
        for name in sorted((self.wanted or frozenset()) - self.found):
            known = [*self.found, *(parameter.name for parameter in left)]
            listed = near(name, known).replace(" Known:", " Parameters:")
            raise ModelError(f"specialize: no parameter is called '{name}'.{listed}")
