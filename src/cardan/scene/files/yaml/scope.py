"""Names that expressions of a scene file may use."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from enum import Enum
from typing import Any

from ....errors import ModelError
from ...scene import SceneRecord
from ...terms import COMPONENTS


class Scope(Enum):
    """Scope of an expression; each level knows the entries before it."""

    NUMBERS = 0  # numbers only
    FIXED = 1  # parameters: what bodies weigh and where they are
    DRIVEN = 2  # inputs and t: prescribed motion
    MOVING = 3  # coordinates, speeds, frames, tables: forces and outputs


FIXED, DRIVEN, MOVING = Scope.FIXED, Scope.DRIVEN, Scope.MOVING


class Names(Mapping[str, Any]):
    """Names of expressions -> what they stand for; motion is looked up when it is asked for."""

    def __init__(
        self,
        model: SceneRecord,
        scope: Scope,
        tables: Mapping[str, object],
        local: Sequence[str],
        where: str,
        version: int,
    ) -> None:
        self.model = model
        self.level = scope.value
        self.tables = tables
        self.local = local
        self.where = where
        self.version = version

    def __getitem__(self, name: Any) -> Any:
        """A symbol, a table, or the motion that :func:`..expression.parse` asks for by a tuple.

        Raises:
            KeyError: no such name at this level.
        """
        if isinstance(name, tuple):
            return self._motion(*name)
        if name in self._plain():
            from sympy import Symbol

            return Symbol(name)
        return self.tables[name]

    def _motion(self, quantity: str, name: str, *words: str | None) -> Any:
        """Motion of a joint or frame; ``words`` are the component, wrt and in of a frame.

        Raises:
            ModelError: no such joint, frame or component, or nothing moves here.
        """
        call = f"{self.where}: {quantity}({name[:80]})"
        if self.level < MOVING.value:
            raise ModelError(f"{call}: this value cannot depend on the motion")
        if quantity in ("q", "u", "state"):
            try:
                return getattr(self.model, quantity)(name)
            except ModelError as problem:
                joint, _, last = name.rpartition(".")
                # format 1 called the components of a quaternion w, x, y and z
                if quantity == "q" and self.version == 1 and last in ("w", "x", "y", "z"):
                    return self.model.q(f"{joint}.q{last}")
                raise ModelError(f"{self.where}: {problem}") from problem
        component, *against_names = words
        cells = COMPONENTS[9 if quantity == "rotation" else 3]
        if component not in cells:
            raise ModelError(f"{call}.{component} has no such component: {', '.join(cells)}")
        against = [
            None if other is None else self.model.place(call, other) for other in against_names
        ]
        if quantity == "rotation" and against.pop() is not None:
            raise ModelError(f"{call}: a rotation has wrt, but no in")
        entries = getattr(self.model.place(call, name), quantity)(*against)
        return entries[cells.index(component)]

    def _plain(self) -> Iterator[str]:
        yield from self.local
        if self.level >= FIXED.value:
            yield from self.model.parameters
        if self.level >= DRIVEN.value:
            yield from self.model.inputs
            yield "t"

    def __iter__(self) -> Iterator[str]:
        yield from self._plain()
        if self.level >= DRIVEN.value:
            yield from self.tables

    def __len__(self) -> int:
        return sum(1 for _ in self)
