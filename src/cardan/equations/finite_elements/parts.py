"""Parts of a system: bodies, joints, force elements, relations and outputs, one by one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterator
from dataclasses import replace
from itertools import groupby
from typing import TypedDict

from ...elements.joints.fixed import Fixed
from ...elements.joints.joint import Joint as JointElement
from ...elements.outline import outline
from ...ir.graph import ZERO
from ...records import dataclass
from ...topology.loops.circuits import circuit
from ...topology.prescribed_motion import driver, driving_output
from ...topology.system import GROUND, Cut, Force, Named, System
from ..constraints.constraints import rows
from ..constraints.driven_rows import working
from ..functions.element_forces import named_forces
from .element_systems import MOVING_JOINT, Cutting
from .member_keys import Member, MemberKeys
from .nodal_scene import JOINT, NODE, Mass, Scene

TREE = "Roberson and Schwertassek, Dynamics of Multibody Systems, 1988, chapter 12"
BODY = "Géradin and Cardona, Flexible Multibody Dynamics, 2001, chapter 7 (rigid body)"


@dataclass(frozen=True)
class Part:
    """One member of a kind, as a small system.

    Attributes:
        name: Of the member.
        kind: What the kind may be called.
        cutting: How it was cut: its places and data.
        system: The small system.
        source: Literature.
        joint: Whether it transmits a reaction, as cut joint 0 of the small system.
        reversed_joint: The joint of the small system that was declared with parent and child
            exchanged, -1 for none.
        driven: Prescribed joints of the small system to whose driving force it contributes.
        results: Names of the outputs that it contributes to.
        powers: Names of the powers that it contributes to.
        tree: Whether it is a rigid tree, which tells how its bodies move.
        forces: Names of the elements in it that have a force with a name.
        events: Entries of the events of the scene that are its own.
        rigid: Whether it is a rigid body and nothing else.
    """

    name: str
    kind: str
    cutting: Cutting
    system: System
    source: str = ""
    joint: bool = False
    reversed_joint: int = -1
    driven: tuple[int, ...] = ()
    results: tuple[str, ...] = ()
    powers: tuple[str, ...] = ()
    tree: bool = False
    forces: tuple[str, ...] = ()
    events: tuple[int, ...] = ()
    rigid: bool = False

    @property
    def family(self) -> str:
        """Body, joint or force; "" of relations and outputs."""
        if self.joint:
            return "joint"
        return "body" if self.rigid else "force" * bool(self.system.forces)

    @property
    def rows(self) -> tuple[tuple[str, str], ...]:
        """Names of its rows of constraints behind its own name, and their units."""
        named, taken = list[tuple[str, str]](), Counter[str]()
        for row in rows(self.system):
            name = row.name.partition(".")[2]
            taken[name] += 1
            named.append((f"{name}{taken[name]}" if taken[name] > 1 else name, row.unit))
        return tuple(named)


class Driving(TypedDict):
    """What an element gives prescribed joints, as attributes of its part."""

    driven: tuple[int, ...]
    results: tuple[str, ...]
    powers: tuple[str, ...]


def parts(scene: Scene) -> Iterator[Part]:
    """The pieces of a system: bodies, joints of the tree, those that close loops, the rest."""
    system, without_node = scene.system, scene.in_trees | set(scene.joints_of_cuts)
    copies = _Copies(scene)
    for tree in scene.trees:
        yield _tree(scene, tree)
    for i in range(len(system.bodies)):
        if i not in without_node and _has_mass(system, i):
            yield copies.body(i)
    for i in range(len(system.joints)):
        if i not in scene.nodal and i not in without_node:
            yield copies.joint(i)
    for cut in system.cuts:
        yield _closing(scene, cut) if cut.carrier is None else _joint(scene, cut.carrier)
    names = {one.number: one.name for one in named_forces(system)}
    for number, force in enumerate(system.forces):
        if not force.element.by_reaction:
            yield _force(scene, force, names.get(number, ""))
    for name, entries in groupby(system.constraints, lambda entry: entry.name.rpartition(".")[0]):
        # those of one owner are rows of one element
        if name:
            yield _relations(scene, name, tuple(entries))
        else:
            yield from (_relations(scene, entry.name, (entry,)) for entry in entries)
    for entry in system.outputs:
        yield _output(scene, entry)


class _Copies:
    """Bodies and joints of the tree: of those that one small system serves, one is cut out.

    Args:
        scene: Where from.
    """

    def __init__(self, scene: Scene) -> None:
        self.scene, self.keys = scene, MemberKeys(scene)
        self._bodies: dict[Hashable, Part] = {}
        self._joints: dict[Hashable, Part] = {}

    def body(self, i: int) -> Part:
        """A rigid body."""
        member = self.keys.body(i)
        if member is None or (first := self._bodies.get(member.key)) is None:
            return self._first(self._bodies, member, _body(self.scene, i))
        cutting = first.cutting.like([(NODE, i)], member.data)
        return replace(first, name=self.scene.system.bodies[i].name, cutting=cutting)

    def joint(self, i: int) -> Part:
        """A joint of the tree between two bodies."""
        member, system = self.keys.joint(i), self.scene.system
        if member is None or (first := self._joints.get(member.key)) is None:
            return self._first(self._joints, member, _joint(self.scene, i))
        parent = system.bodies[i].parent
        base = [] if parent == GROUND else [(NODE, parent)]
        cutting = first.cutting.like([*base, (NODE, i), (JOINT, i)], member.data)
        return replace(first, name=system.joints[i].name, cutting=cutting)

    def _first(self, firsts: dict[Hashable, Part], member: Member | None, part: Part) -> Part:
        """A member that was cut out, for others with its key."""
        if member is not None:
            # what the key says of its data is what was cut out
            assert tuple(part.cutting.data) == member.data
            firsts[member.key] = part
        return part


def _has_mass(system: System, i: int) -> bool:
    body = system.bodies[i]
    return any(node != ZERO for node in (body.mass, *body.first_moment, *body.inertia))


def _mass(cutting: Cutting, i: int) -> Mass:
    body = cutting.system.bodies[i]
    (mass,) = cutting.expressions((body.mass,), "mass")
    moment = cutting.expressions(body.first_moment, "first_moment")
    return Mass(mass, moment, cutting.expressions(body.inertia, "inertia"))


def _tree(scene: Scene, tree: tuple[int, ...]) -> Part:
    """Bodies that joints carry from the ground or a node on."""
    cutting = Cutting(scene)
    for i in tree:
        cutting.tree_body(i, _mass(cutting, i))
    gravity = cutting.expressions(scene.system.gravity, "gravity")
    name = scene.system.joints[tree[0]].name
    system = cutting.system_of(gravity=gravity)
    return Part(name, "tree", cutting, system, TREE, tree=True, **_driven(cutting, {}))


def _driven(cutting: Cutting, driven: dict[int, int], *powers: str) -> Driving:
    """What an element gives prescribed joints.

    Args:
        cutting: Its places, with the joints of trees that carry it.
        driven: Other prescribed joints, number in the scene -> number here.
        powers: Names of its other powers.
    """
    system = cutting.system
    tree_joints = {i: n for i, n in cutting.moved.items() if system.joints[i].motion is not None}
    every = driven | tree_joints
    drivers = [driver(system.joints, i) for i in every]
    return {
        "driven": tuple(every.values()),
        "results": tuple(driving_output(system.joints[i])[0] for i in drivers),
        "powers": (*powers, *(f"{system.joints[i].name}.motion" for i in drivers)),
    }


def _body(scene: Scene, i: int) -> Part:
    cutting, body = Cutting(scene), scene.system.bodies[i]
    cutting.node(i, _mass(cutting, i))
    gravity = cutting.expressions(scene.system.gravity, "gravity")
    small = cutting.system_of(gravity=gravity)
    return Part(body.name, "body", cutting, small, BODY, rigid=True)


def _joint(scene: Scene, i: int) -> Part:
    """A joint that moves a body without mass, which is held on the child by its reaction."""
    cutting, joint = Cutting(scene), scene.system.joints[i]
    frictions = scene.frictions.get(i, [])
    for friction in frictions:
        # states that are its own come first
        _states(cutting, friction)
    parent = cutting.node(scene.system.bodies[i].parent)
    cut = scene.joints_of_cuts.get(i)
    end = cutting.body_frame(cutting.node(i)) if cut is None else cutting.frame(cut.child_frame)
    body = cutting.moving_body(i, parent)
    weld = _cut(cutting, Fixed(), (cutting.body_frame(body), end), body)
    driven = {i: body} if joint.motion is not None else {}
    local_forces = tuple(_local_force(cutting, friction) for friction in frictions)
    return Part(
        joint.name,
        joint.element.kind,
        cutting,
        cutting.system_of(cuts=(weld,), forces=local_forces),
        joint.element.source,
        joint=True,
        reversed_joint=body if joint.reversed else -1,
        forces=tuple(friction.name for friction in frictions),
        **_driven(cutting, driven, *(friction.name for friction in frictions)),
        events=tuple(n for friction in frictions for n in _events(friction)),
    )


def _closing(scene: Scene, cut: Cut) -> Part:
    """A joint without coordinates of its own: what it holds."""
    cutting = Cutting(scene)
    frames = (cutting.frame(cut.parent_frame), cutting.frame(cut.child_frame))
    local_cut = _cut(cutting, cut.element, frames, None, cutting.quantities(cut.data))
    system = cutting.system_of(cuts=(local_cut,))
    kind = f"{cut.element.kind}_held"
    return Part(
        cut.name, kind, cutting, system, cut.element.source, joint=True, **_driven(cutting, {})
    )


def _cut(
    cutting: Cutting,
    element: JointElement,
    frames: tuple[int, int],
    carrier: int | None,
    data: dict[str, tuple[int, int, tuple[int, ...]]] | None = None,
) -> Cut:
    """A constraint between two frames of a small system, with all its components."""
    ends = (cutting.frames[frame].body for frame in frames)
    base, path = circuit([body.parent for body in cutting.bodies], *ends)
    return Cut(
        MOVING_JOINT,
        element,
        data or {},
        *frames,
        base,
        path,
        rows=tuple(range(len(element.locked))),
        carrier=carrier,
    )


def _force(scene: Scene, force: Force, name: str) -> Part:
    cutting, element = Cutting(scene), force.element
    local_force = _local_force(cutting, force)
    driven = {
        i: number
        for i, number in zip(force.joints.values(), local_force.joints.values(), strict=True)
        if cutting.joints[number].motion is not None
    }
    return Part(
        force.name,
        element.kind,
        cutting,
        cutting.system_of(forces=(local_force,)),
        element.source,
        forces=(name,) * bool(name),
        **_driven(cutting, driven, force.name),
        events=_events(force),
    )


def _events(force: Force) -> tuple[int, ...]:
    """Entries of the events of the scene that belong to an element."""
    return tuple(range(force.e, force.e + len(force.element.events())))


def _local_force(cutting: Cutting, force: Force) -> Force:
    """A force element of a small system; its events stand behind those of others there."""
    element, e = force.element, cutting.events
    z, s = _states(cutting, force)
    frames = {role: cutting.frame(frame) for role, frame in force.frames.items()}
    joints = {role: cutting.joint(joint) for role, joint in force.joints.items()}
    cutting.events += len(element.events())
    data = cutting.quantities(force.data)
    name = f"{element.kind}_{e}" if e else element.kind
    return Force(name, element, data, frames, joints, z, s, e)


def _states(cutting: Cutting, force: Force) -> tuple[int, int]:
    """First of the internal states and of the modes of a force element in a small system."""
    counts = len(force.element.internals()), len(force.element.modes())
    z = [cutting.state("z", force.z + n) for n in range(counts[0])]
    s = [cutting.state("s", force.s + n) for n in range(counts[1])]
    return (z or [0])[0], (s or [0])[0]


def _relations(scene: Scene, name: str, entries: tuple[Named, ...]) -> Part:
    """Relations whose names begin with that of the element, or the one that has its name."""
    cutting = Cutting(scene)
    nodes = cutting.expressions([entry.node for entry in entries], "value")
    named = tuple(
        Named(f"relation{entry.name.removeprefix(name)}", node, entry.unit)
        for entry, node in zip(entries, nodes, strict=True)
    )
    system = cutting.system_of(constraints=named)
    work = zip(entries, working(system), strict=True)
    powers = tuple(f"{entry.name}.motion" for entry, works in work if works)
    driving = _driven(cutting, cutting.driven, *powers)
    return Part(name, "relation", cutting, system, **driving)


def _output(scene: Scene, entry: Named) -> Part:
    cutting = Cutting(scene)
    (node,) = cutting.expressions((entry.node,), "value")
    system = cutting.system_of(outputs=(Named("output", node, entry.unit),))
    return Part(entry.name, "output", cutting, system, results=(entry.name,))


def structure(part: Part) -> str:
    """Text that two pieces on equal places share if and only if the same functions serve both."""
    system = part.system
    signature = (
        system.bodies,
        [replace(joint, element=outline(joint.element)) for joint in system.joints],  # type: ignore[arg-type]
        [replace(cut, element=outline(cut.element)) for cut in system.cuts],  # type: ignore[arg-type]
        [replace(force, element=outline(force.element)) for force in system.forces],  # type: ignore[arg-type]
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
        system.graph.nodes,
    )
    return repr(signature)
