"""Kinds of elements by name, and the energy of an element as SymPy expressions."""

from __future__ import annotations

from typing import TYPE_CHECKING, SupportsIndex, overload

from ...elements.flexible import BEAMS, INERTIAS
from ...elements.formulas import Lines, Shapes
from ...errors import DerivationError, near
from ...records import dataclass

if TYPE_CHECKING:
    from ..reading.energy_expressions import EnergyExpressions
    from .record import Kind


@dataclass(frozen=True)
class KindSelection:
    """The kinds of elements that a name selects.

    Attributes:
        name: That name.
        kinds: The kinds.
    """

    name: str
    kinds: tuple[Kind, ...]

    @property
    def formulas(self) -> Lines:
        """Formulas of all of them, each once."""
        return tuple(line for lines in self._elements() for line in lines)

    @property
    def energy(self) -> EnergyExpressions:
        """Kinetic and potential energy of one element as SymPy expressions, with definitions.

        That of a beam is the energy of its strain, of its mass and of its loads. Ends are those in
        space: an end at the ground does not move. Of superelements with different numbers of
        coordinates it is that of the kind with the name itself, such as ``"superelement_2"``.

        Raises:
            DerivationError: they are not one element: beams of several kinds, several joints.
        """
        from ..reading.energy_expressions import energy_of

        for family in (BEAMS, INERTIAS):
            members = {element.kind for element in family.values()}
            several = sorted({kind.element for kind in self.kinds} & members)
            if len(several) > 1:
                raise DerivationError(
                    f"kinds '{self.name}': beams of this scene have several elements, each with an "
                    f"energy of its own; ask for one: {', '.join(several)}"
                )
        elements = {kind.element for kind in self.kinds}
        if len(elements) > 1 and {kind.part for kind in self.kinds} != {"beam"}:
            raise DerivationError(
                f"kinds '{self.name}': these are several elements, each with an energy of its own; "
                f"ask for one: {', '.join(sorted(elements))}"
            )
        return energy_of([*self._elements().items()])

    def _elements(self) -> dict[Lines, Shapes]:
        """Formulas -> shapes of what they read; kinds that differ in their ends share them."""
        first_to_last = sorted(self.kinds, key=lambda kind: kind.name == self.name)
        return {kind.formulas: kind.symbol_shapes for kind in first_to_last if kind.formulas}


class Kinds(tuple["Kind", ...]):
    """Kinds of elements: a tuple, of which a name picks some.

    A name is that of a kind, of an element such as ``"revolute"``, or one of ``"body"``,
    ``"joint"``, ``"force"`` and ``"beam"``.
    """

    @overload
    def __getitem__(self, key: str) -> KindSelection: ...
    @overload
    def __getitem__(self, key: SupportsIndex) -> Kind: ...
    @overload
    def __getitem__(self, key: slice) -> tuple[Kind, ...]: ...

    def __getitem__(
        self, key: str | SupportsIndex | slice
    ) -> KindSelection | Kind | tuple[Kind, ...]:
        if not isinstance(key, str):
            return super().__getitem__(key)
        kinds = tuple(kind for kind in self if key in (kind.name, kind.element, kind.part))
        if not kinds:
            names = dict.fromkeys(x for kind in self for x in (kind.part, kind.element, kind.name))
            listed = near(key, [name for name in names if name]).replace(" Known:", " Kinds:")
            raise DerivationError(f"kind of element '{key}' does not exist.{listed}")
        return KindSelection(key, kinds)
