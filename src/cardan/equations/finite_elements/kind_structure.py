"""What members of one kind have in common: all but their data."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields, is_dataclass, replace

from ...elements.forces.force import ForceElement
from ...elements.joints.joint import Joint as JointElement
from ...elements.joints.joint import Reversed
from .parts import Part
from .record import BlockKind


def structure(part: Part, places: Iterable[BlockKind]) -> str:
    """Text that two pieces share if and only if the same functions serve both."""
    system = part.system
    signature = (
        system.bodies,
        [replace(joint, element=_outline(joint.element)) for joint in system.joints],  # type: ignore[arg-type]
        [replace(cut, element=_outline(cut.element)) for cut in system.cuts],  # type: ignore[arg-type]
        [replace(force, element=_outline(force.element)) for force in system.forces],  # type: ignore[arg-type]
        system.frames,
        system.constraints,
        system.outputs,
        system.gravity,
        system.atoms,
        part.kind,
        part.joint,
        part.reversed_joint,
        part.driven,
        len(part.cutting.z),
        len(part.cutting.s),
        [(n, part.cutting.system.joints[i].reversed) for i, n in part.cutting.moved.items()],
        part.tree,
        [place.name for place in places],
        system.graph.nodes,
    )
    return repr(signature)


def _outline(element: JointElement | ForceElement) -> str:
    """An element without the numbers and names that a member may have of its own."""
    if isinstance(element, Reversed):
        return f"reversed {_outline(element.element)}"
    # a field may be several quantities, such as branches.0.time
    quantities = {name.partition(".")[0] for name in element.quantities()}
    assert is_dataclass(element)
    signature = [
        (field.name, _pattern(getattr(element, field.name), field.name in quantities))
        for field in fields(element)
        if field.type not in ("Place", "Bodies", "JointName")
    ]
    constrained = (element.locked, element.slips) if isinstance(element, JointElement) else ()
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
