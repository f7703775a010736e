"""Models as parts of models: copies with renamed parts."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from copy import copy as shallow
from dataclasses import field
from typing import TYPE_CHECKING, Any

from ..elements.forces.force import ForceElement
from ..elements.forces.line_load import LineLoad
from ..elements.joints.fixed import Fixed
from ..errors import ModelError
from ..records import dataclass
from . import checks
from .beam import UNITS, Beam, Cable, End
from .beam_arguments import add_cable_nodes, add_interfaces, add_nodes
from .body import Body
from .connections import Couple, Force, Joint
from .frame import Frame, Place
from .masses import pulled
from .parameters import Output

if TYPE_CHECKING:
    from .scene import SceneRecord
    from .superelement import PlacedSuperelement


@dataclass(frozen=True)
class Included:
    """The copies of an included model, by their old names.

    Attributes:
        ground: The body that its ground became.
        bodies, frames, joints: Its parts.
        symbols: SymPy symbols of its parameters and inputs, by name.
    """

    ground: Body
    bodies: Mapping[str, Body]
    frames: Mapping[str, Frame]
    joints: Mapping[str, Joint]
    symbols: Mapping[str, Any]


def include(model: SceneRecord, other: SceneRecord, prefix: str, at: Place) -> Included:
    """The work of :meth:`Model.include`: all of it is done, or nothing."""
    backup = {name: shallow(x) for name, x in vars(model).items() if isinstance(x, (dict, list))}
    try:
        return _include(model, other, prefix, at)
    except BaseException:
        vars(model).update(backup)
        raise


def _include(model: SceneRecord, other: SceneRecord, prefix: str, at: Place) -> Included:
    if other is model:
        raise ModelError(f"include '{prefix}': a model cannot be a part of itself; make another")
    for joint in other.joints.values():
        if joint.kind.bodiless:
            raise ModelError(
                f"include '{prefix}': '{other.name}' is made of written equations, whose names "
                "are their own; it cannot be a part of another model"
            )
    copy = _Copy(model, other, prefix if not prefix[-1].isalnum() else prefix + ".")
    for declared, make in ((other.parameters, model.parameter), (other.inputs, model.input)):
        for entry in declared.values():
            unit = entry.unit if entry.stated else None
            copy.symbols[entry.name] = make(copy.name(entry.name), entry.value, unit)
    ground = copy.ground(at)
    for body in other.bodies.values():
        copy.body(body)
    on_nodes = [frame for frame in other.frames.values() if frame.body.name in other.nodes]
    for frame in other.frames.values():
        if frame not in on_nodes:
            copy.frame(frame)
    for beam in other.beams.values():
        copy.beam(beam)
    for cable in other.cables.values():
        copy.cable(cable)
    for superelement in other.superelements.values():
        copy.superelement(superelement)
    for frame in on_nodes:
        copy.place(frame)
    for joint in other.joints.values():
        copy.joint(joint)
    copy.placeholders()
    for force in other.forces.values():
        model.force(copy.name(force.name), copy.element(force))
    for output in other.outputs.values():
        name = copy.name(output.name)
        checks.new("output", name, model.outputs)
        model.outputs[name] = Output(name, copy.value(output.expression), output.unit)
    for constraint in other.constraints.values():
        model.constraint(
            copy.name(constraint.name), copy.value(constraint.expression), constraint.unit
        )
    copy.motions()
    model.notes += [f"{prefix}: {note}" for note in other.notes]
    model.snaps += [f"{prefix}: {snap}" for snap in other.snaps]
    model.origins |= {(kind, copy.name(n)): place for (kind, n), place in other.origins.items()}
    model.values.update({copy.name(name): value for name, value in other.values.items()})
    return Included(ground, copy.bodies, copy.frames, copy.joints, copy.symbols)


@dataclass
class _Copy:
    """One inclusion: old objects and names to new ones."""

    model: SceneRecord
    other: SceneRecord
    prefix: str
    bodies: dict[str, Body] = field(default_factory=dict)
    frames: dict[str, Frame] = field(default_factory=dict)
    joints: dict[str, Joint] = field(default_factory=dict)
    symbols: dict[str, Any] = field(default_factory=dict)
    local: frozenset[str] = frozenset()

    def name(self, old: str) -> str:
        return self.prefix + old

    def value(self, value: Any) -> Any:
        """A quantity as written, with the new symbols, frames, bodies and beams."""
        if isinstance(value, Beam):
            return self.name(value.name)
        if isinstance(value, (Body, Frame)):
            return self.place(value)
        if isinstance(value, (tuple, list)):
            return tuple(self.value(entry) for entry in value)
        symbols = getattr(value, "free_symbols", None)
        if not symbols:
            return value
        from sympy import Symbol

        untouched = self.local | {"t"}
        names = {s: self.name(s.name) for s in symbols if s.name not in untouched}
        return value.xreplace({old: Symbol(new) for old, new in names.items()})

    def place(self, place: Place) -> Place:
        if isinstance(place, Frame):
            if place.name not in self.frames:
                self.frame(place)
            return self.frames[place.name]
        return self.bodies[place.name]

    def ground(self, at: Place) -> Body:
        """The old ground: a massless body fixed where the new model wants it."""
        copied = self.model.body(self.name("ground"))
        self.bodies["ground"] = copied
        self.model.joint(self.name("ground"), Fixed(), at, copied)
        return copied

    def body(self, old: Body) -> None:
        base = self.bodies["ground"] if old.base is None else self.bodies[old.base.name]
        shapes = tuple(
            dataclasses.replace(
                shape,
                position=self.value(shape.position),
                rotation=self.value(shape.rotation),
                size=tuple((key, self.value(size)) for key, size in shape.size),
            )
            for shape in old.shapes
        )
        copied = self.model.body(self.name(old.name), shape=shapes)
        copied = dataclasses.replace(
            copied,
            mass=self.value(old.mass),
            com=self.value(old.com),
            inertia=self.value(old.inertia),
            pose=self.value(old.pose),
            base=None if old.pose is None else base,
        )
        self.model.bodies[copied.name] = self.bodies[old.name] = copied

    def frame(self, old: Frame) -> None:
        name = self.name(old.name)
        self.model.new_place("frame", name)
        copied = Frame(
            self.bodies[old.body.name],
            self.value(old.coordinates),
            self.value(old.orientation),
            name,
            old.named,
            None if old.base is None else self.frames[old.base.name],
        )
        self.model.frames[name] = self.frames[old.name] = copied

    def beam(self, old: Beam) -> None:
        """The beam with its nodes; points and directions stay in axes of the old ground."""
        name = self.name(old.name)
        copied = dataclasses.replace(
            old,
            model=self.model,
            name=name,
            ends=self.ends(old.ends),
            section=self.record(old.section),
            material=self.record(old.material),
            line=self.record(old.line),
            up=self.value(old.up),
            temperature=self.value(old.temperature),
            prestrain={key: self.value(x) for key, x in old.prestrain.items()},
            base=self.bodies["ground" if old.base is None else old.base.name],
            stops={self.name(node): s for node, s in old.stops.items()},
        )
        add_nodes(copied)
        for node in (f"{old.name}.start", f"{old.name}.end", *old.stops):
            place = self.model.nodes[self.name(node)]
            if place.name == self.name(node):
                self.bodies[node] = place.body

    def cable(self, old: Cable) -> None:
        """The cable with its nodes."""
        numbers = {key: self.value(getattr(old, key)) for key in UNITS}
        copied = dataclasses.replace(
            old,
            model=self.model,
            name=self.name(old.name),
            ends=self.ends(old.ends),
            base=self.bodies["ground" if old.base is None else old.base.name],
            **numbers,
        )
        add_cable_nodes(copied)
        for node in old.inner_nodes():
            self.bodies[node] = self.model.nodes[self.name(node)].body

    def superelement(self, old: PlacedSuperelement) -> None:
        """The superelement with its interfaces; the record is the same."""
        joined = {interface: self.name(place) for interface, place in old.joined.items()}
        loads = {name: self.value(factor) for name, factor in old.loads.items()}
        copied = dataclasses.replace(old, name=self.name(old.name), joined=joined, loads=loads)
        checks.new("superelement", copied.name, self.model.superelements)
        add_interfaces(self.model, copied)
        for node in old.places:
            self.bodies[node] = self.model.nodes[self.name(node)].body

    def ends(self, old: tuple[End, End]) -> tuple[End, End]:
        first, last = (
            dataclasses.replace(
                end,
                place=None if end.place is None else self.place(end.place),
                point=self.value(end.point),
            )
            for end in old
        )
        return first, last

    def joint(self, old: Joint) -> None:
        """The joint; its motion follows when all symbols are known."""
        name = self.name(old.name)
        checks.new("joint", name, self.model.joints)
        base = self.bodies["ground"] if old.base is None else self.bodies[old.base.name]
        couple, follows = old.couple, old.kind.follows
        leader = frozenset() if follows is None else frozenset([follows[0]])
        if couple is not None:
            ratio, offset = self.value(couple.ratio), self.value(couple.offset)
            couple = Couple(self.name(couple.leader), ratio, offset)
        copied = dataclasses.replace(
            old,
            name=name,
            kind=self.record(old.kind, leader),
            parent=self.place(old.parent),
            child=self.place(old.child),
            at=self.value(old.at),
            base=None if old.at is None else base,
            couple=couple,
        )
        self.model.joints[name] = self.joints[old.name] = copied

    def motions(self) -> None:
        for name, joint in self.joints.items():
            if joint.prescribed is not None:
                copied = dataclasses.replace(joint, prescribed=self.value(joint.prescribed))
                self.model.joints[copied.name] = self.joints[name] = copied

    def placeholders(self) -> None:
        """Placeholders of the old model, as those of the new frames and joints."""
        for old, entry in self.other.atoms.items():
            places = [
                self.place(p) if isinstance(p, (Body, Frame)) else p
                for p in (entry.place, entry.wrt, entry.in_)
            ]
            if entry.quantity in ("q", "u"):
                places[0] = self.name(entry.place)
            new = self.name(old)
            self.model.atoms[new] = dataclasses.replace(
                entry, place=places[0], wrt=places[1], in_=places[2]
            )

    def element(self, force: Force) -> ForceElement:
        """A force element that acts on the new frames, joints and bodies."""
        element = force.element
        if element.masses() is not None:
            # all bodies are all of the old model
            element = dataclasses.replace(element, bodies=pulled(self.other, force))  # type: ignore[type-var]
        places = [p for p in element.frames().values() if isinstance(p, str)]
        places += [element.beam] if isinstance(element, LineLoad) else []
        names = frozenset([*element.joints().values(), *places])
        copied: ForceElement = self.record(element, names)
        return copied

    def record(self, element: Any, names: frozenset[str] = frozenset()) -> Any:
        """A joint kind or force element with its fields copied; ``names``: those to change."""
        # symbols that stand for the element's own coordinates keep their names
        self.local = frozenset(n for q in element.quantities().values() for n in q.local)
        # the fields are checked and normalized already: copied as they are
        copied = shallow(element)
        for entry in dataclasses.fields(element):
            value = getattr(element, entry.name)
            named = isinstance(value, str) and value in names
            new = self.name(value) if named else self.value(value)
            object.__setattr__(copied, entry.name, new)
        self.local = frozenset()
        return copied
