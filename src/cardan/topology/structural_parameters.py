"""Parameters that are written into the equations as numbers."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from math import isfinite

from ..errors import ModelError, near, shown
from ..scene.checks import is_number
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
        """From what the user wrote; None for nothing.

        Raises:
            ModelError: it is neither names nor finite numbers by name.
        """
        if isinstance(asked, bool):
            return BuiltIn(None) if asked else None
        names = (asked,) if isinstance(asked, str) else asked
        if not isinstance(names, Iterable) or not all(isinstance(name, str) for name in names):
            raise ModelError(
                f"specialize: names, numbers by name, or True for all are wanted, not "
                f"{shown(asked)}"
            )
        if not isinstance(asked, Mapping):
            return BuiltIn(frozenset(names)) if names else None
        for name, value in asked.items():
            if not is_number(value) or not isfinite(value):
                raise ModelError(
                    f"specialize: '{name}' must be a finite number, not {shown(value)}"
                )
        return BuiltIn(frozenset(asked), {name: float(x) for name, x in asked.items()})

    @staticmethod
    def with_names(asked: BuiltIn | None, names: Iterable[str]) -> BuiltIn:
        """The same and more names."""
        if asked is None:
            return BuiltIn(frozenset(names))
        wanted = None if asked.wanted is None else asked.wanted | frozenset(names)
        return BuiltIn(wanted, asked.values)

    def takes(self, name: str) -> bool:
        """Whether a parameter becomes a number."""
        if self.wanted is not None and name not in self.wanted:
            return False
        self.found.add(name)
        return True

    def finish(self, left: Sequence[Parameter], structural: Collection[str]) -> None:
        """All that was asked for was met, or is part of the equations' form anyway.

        Raises:
            ModelError: a name that no parameter has.
        """
        for name in sorted((self.wanted or frozenset()) - self.found - set(structural)):
            known = [*self.found, *(parameter.name for parameter in left)]
            listed = near(name, known).replace(" Known:", " Parameters:")
            raise ModelError(f"specialize: no parameter is called '{name}'.{listed}")
