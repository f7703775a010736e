"""Parameters that are written into the equations as numbers."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import field
from math import isfinite

from ..errors import ModelError, brief, near
from ..records import dataclass
from ..scene.checks import is_number
from .system import Parameter


@dataclass
class BuiltIn:
    """Values built into the equations by ``specialize=``.

    Attributes:
        names: Names; None for all parameters.
        values: Numbers that replace the defaults.
        used: Names that were met.
    """

    names: frozenset[str] | None
    values: dict[str, float] = field(default_factory=dict)
    used: set[str] = field(default_factory=set)

    @staticmethod
    def of(requested: bool | Sequence[str] | Mapping[str, float]) -> BuiltIn | None:
        """From what the user wrote; None for nothing.

        Raises:
            ModelError: it is neither names nor finite numbers by name.
        """
        if isinstance(requested, bool):
            return BuiltIn(None) if requested else None
        names = (requested,) if isinstance(requested, str) else requested
        if not isinstance(names, Iterable) or not all(isinstance(name, str) for name in names):
            raise ModelError(
                f"specialize: names, numbers by name, or True for all are wanted, not "
                f"{brief(requested)}"
            )
        if not isinstance(requested, Mapping):
            return BuiltIn(frozenset(names)) if names else None
        for name, value in requested.items():
            if not is_number(value) or not isfinite(value):
                raise ModelError(
                    f"specialize: '{name}' must be a finite number, not {brief(value)}"
                )
        return BuiltIn(frozenset(requested), {name: float(x) for name, x in requested.items()})

    @staticmethod
    def with_names(requested: BuiltIn | None, names: Iterable[str]) -> BuiltIn:
        """The same and more names."""
        if requested is None:
            return BuiltIn(frozenset(names))
        all_names = None if requested.names is None else requested.names | frozenset(names)
        return BuiltIn(all_names, requested.values)

    def takes(self, name: str) -> bool:
        """True when a parameter becomes a number."""
        if self.names is not None and name not in self.names:
            return False
        self.used.add(name)
        return True

    def finish(self, left: Sequence[Parameter], structural: Collection[str]) -> None:
        """All that was asked for was met, or is part of the equations' form anyway.

        Raises:
            ModelError: a name that no parameter has.
        """
        for name in sorted((self.names or frozenset()) - self.used - set(structural)):
            candidates = [*self.used, *(parameter.name for parameter in left)]
            listed = near(name, candidates).replace(" Known:", " Parameters:")
            raise ModelError(f"specialize: no parameter is called '{name}'.{listed}")
