"""What the equations depend on of an element, apart from its numbers and names."""

from __future__ import annotations

from dataclasses import fields, is_dataclass

from .forces.force import ForceElement
from .joints.joint import Joint, Reversed


class Outlines:
    """Outlines of elements, each made once for all that are equal."""

    def __init__(self) -> None:
        self._texts: dict[Joint | ForceElement, str] = {}

    def __getitem__(self, element: Joint | ForceElement) -> str:
        try:
            text = self._texts.get(element)
        except TypeError:  # a field is a list
            return outline(element)
        if text is None:
            text = self._texts[element] = outline(element)
        return text


def outline(element: Joint | ForceElement) -> str:
    """An element without the numbers and names that a member may have of its own."""
    if isinstance(element, Reversed):
        return f"reversed {outline(element.element)}"
    # a field may be several quantities, such as branches.0.time
    quantities = {name.partition(".")[0] for name in element.quantities()}
    assert is_dataclass(element)
    signature = [
        (field.name, _pattern(getattr(element, field.name), field.name in quantities))
        for field in fields(element)
        if field.type not in ("Place", "Bodies", "JointName")
    ]
    constrained = (element.locked, element.slips) if isinstance(element, Joint) else ()
    return repr((type(element).__name__, signature, constrained))


def _pattern(value: object, by_value: bool) -> str:
    """Part of a field that the equations may depend on; of a quantity of a member only its form."""
    if isinstance(value, (tuple, list)):
        return f"({', '.join(_pattern(x, by_value) for x in value)})"
    if is_dataclass(value) and not isinstance(value, type):
        # of measured data, what its text leaves out too
        return _pattern(tuple(getattr(value, field.name) for field in fields(value)), by_value)
    if not by_value or value is None or isinstance(value, (str, bool)):
        return repr(value)
    if isinstance(value, (int, float)):
        return repr(float(value)) if value in (0, 1, -1) else "number"
    return "expression"
