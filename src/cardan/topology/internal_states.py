"""Slots of what elements keep themselves, and the names by which expressions speak of it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..elements.internal_states import EventSpec, Internal, Mode
from ..errors import ModelError, near
from ..scene.scene import SceneRecord
from .conversion import Converter
from .system import Joint


def numbered(model: SceneRecord, convert: Converter) -> dict[str, tuple[int, int, int]]:
    """First slots in z, s and e of every force element; its states become symbols.

    Raises:
        ModelError: the name of a state is that of something else.
    """
    numbers: dict[str, tuple[int, int, int]] = {}
    z = s = e = 0
    for name, force in model.forces.items():
        element = force.element
        numbers[name] = z, s, e
        for state in element.internals():
            _define(convert, full_name(name, state), "z", z)
            z += 1
        for mode in element.modes():
            _define(convert, full_name(name, mode), "s", s)
            s += 1
        e += len(element.events())
    return numbers


def check_state(name: str, model: SceneRecord, convert: Converter) -> None:
    """Check that an element has a state of this name.

    Raises:
        ModelError: none does.
    """
    names: list[str] = []
    for force, entry in model.forces.items():
        names += [full_name(force, state) for state in entry.element.internals()]
        names += [full_name(force, mode) for mode in entry.element.modes()]
    if name not in names:
        listed = near(name, names).replace(" Known:", " States:")
        raise ModelError(f"state('{name}'): no force element keeps such a state.{listed}")


def slides(joints: Sequence[Joint], numbers: Iterable[int]) -> bool:
    """True when an element belongs to a joint that slides:

    of units with two forms the second holds.

    Args:
        joints: Those of the system.
        numbers: The joints the element acts on.
    """
    return "m" in [joints[j].element.coordinates[0].unit for j in numbers]


def dotted(owner: str, quantity: str) -> str:
    """Name of a number of an element; ``elbow.damping`` is not said twice."""
    return owner if owner.endswith(f".{quantity}") else f"{owner}.{quantity}"


def full_name(owner: str, part: Internal | Mode | EventSpec) -> str:
    """Name of a state, mode or event of an element."""
    return f"{owner}.{part.name}" if part.name else owner


def _define(convert: Converter, name: str, block: str, slot: int) -> None:
    if name in convert.symbols:
        raise ModelError(
            f"'{name}' is an internal state of a force element, and a parameter, an input or the "
            "motion of a joint or frame too; rename one of them"
        )
    convert.define(name, convert.graph.var(block, slot))
