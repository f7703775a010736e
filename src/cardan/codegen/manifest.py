"""Manifest of equations; its fields are those of :mod:`cardan.schema.manifest`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import field
from math import isfinite
from typing import Any

from ..elements.internal_states import TICK
from ..elements.joints.joint import entries
from ..elements.limits import limit_rows
from ..elements.quantity import written_unit
from ..equations.constraints import reaction_friction
from ..equations.constraints.constraints import Row, left_out
from ..equations.functions import blocks
from ..equations.functions.dynamics import Dynamics
from ..equations.functions.element_forces import force_rows
from ..equations.kinematics.kinematics import Kinematics
from ..equations.record import EquationRecord
from ..errors import lasting
from ..ir.function import Function
from ..ir.trees.assembly import Form
from ..processes import collector_paused
from ..records import dataclass
from ..schema import mechanism
from ..schema.entries import (
    CoordinateRow,
    Entry,
    EventRow,
    ModeRow,
    MultiplierRow,
    OutputRow,
    ParameterRow,
    SpeedRow,
    TickRow,
)
from ..schema.manifest import Manifest
from ..schema.tree import Treatment, Tree
from ..topology.beams.segment_tables import Segment
from ..topology.beams.segments import LOADS
from ..topology.internal_states import slides
from ..topology.loops.welds import passed
from ..topology.prescribed_motion import driving_outputs
from ..topology.system import Cut, Frame, Joint, System
from ..version import ABI, MANIFEST, VERSION
from . import flat_scene


@dataclass(frozen=True)
class Base:
    """The manifest of a model without functions yet.

    Attributes:
        data: The manifest.
        saved: Makes the Functions of the flat scene, which are saved beside it.
    """

    data: Manifest
    saved: Callable[[], tuple[Form, ...]] = field(repr=False, compare=False)


@collector_paused()
def base(equations: EquationRecord, functions: Sequence[str] = ()) -> Base:
    """Manifest before any function is written.

    Args:
        equations: Of the system.
        functions: Names that may be asked for.
    """
    system = equations.system
    joints = [_joint(equations, i) for i in range(len(system.joints))]
    absent = {name: why for joint in system.joints for name, why in joint.element.lacks.items()}
    data = Manifest(
        **common(system, equations.method, functions),
        coordinates=_coordinates(system),
        speeds=_speeds(equations),
        events=event_rows(system),
        ticks=tick_rows(system),
        multipliers=[_multiplier(row) for row in equations.constraint_rows],
        # what holds such a system together is that its constraints give way
        projected=not equations.constraint_rows or equations.treatment.exact,
        cuts=[_cut(equations, cut) for cut in system.closing],
        joints=joints,
        bodies=[
            mechanism.BodyRow(
                name=b.name, parent=_body(system, b.parent), parts=[p.name for p in b.parts]
            )
            for b in system.bodies
        ],
        frames=[_frame(system, frame) for frame in system.frames],
        outputs=_outputs(system),
        quaternions=[j.quaternion for j in joints if j.quaternion is not None],
        absent=absent,
        scene=_scene(equations),
    )
    return Base(data, lambda: _saved(equations))


def _outputs(system: System) -> list[OutputRow]:
    """Those of the scene, then the driving forces of prescribed joints."""
    rows = [(entry.name, entry.unit) for entry in system.outputs]
    rows += driving_outputs(system).values()
    return [OutputRow(name=name, unit=unit) for name, unit in rows]


def common(system: System, method: str, functions: Sequence[str]) -> dict[str, Any]:
    """Entries that manifests share, independent of the coordinates of a model."""
    return {
        "abi": ABI.version,
        "schema": MANIFEST.version,
        "cardan": VERSION,
        "name": system.name,
        "method": method,
        "z": [Entry(name=n, unit=u, default=d) for n, u, d in blocks.internals(system)],
        "s": [
            ModeRow(name=n, default=m.default, labels={str(k): v for k, v in m.labels})
            for n, m in blocks.discrete(system)
        ],
        "inputs": [Entry(name=i.name, unit=i.unit, default=i.default) for i in system.inputs],
        "parameters": [
            ParameterRow(name=p.name, unit=p.unit, default=p.value, declared=p.declared)
            for p in system.parameters
        ],
        "structural": dict(system.structural),
        "limits": limit_rows(
            system.number_limits, system.graph, [p.name for p in system.parameters]
        ),
        "element_forces": force_rows(system),
        "isolated": isolated(system),
        "fixed": list(system.fixed),
        "forces": flat_scene.force_element_rows(system),
        "shapes": flat_scene.shape_rows(system),
        "notes": lasting(system.notes),
        "snaps": list(system.snaps),
        "available": list(functions),
        "functions": {},
        "sha256": {},
    }


def isolated(system: System) -> bool:
    """True when nothing but gravity acts on a scene from outside, so that its momenta stay.

    Joints leave everything free from the ground, and what forces do comes in pairs.
    """
    first = [
        joint for body, joint in zip(system.bodies, system.joints, strict=True) if body.parent < 0
    ]
    free = all(j.element.kind == "free" and j.motion is None and j.coupling is None for j in first)
    closing = [
        system.frames[k].body for cut in system.closing for k in (cut.parent_frame, cut.child_frame)
    ]
    ends = [
        system.frames[k].body
        for segment in system.segments
        for k in (segment.frame_a, segment.frame_b)
    ]
    ends += [system.frames[one.center].body for s in system.segments for one in s.fields]
    frames = [system.frames[k].body for force in system.forces for k in force.frames.values()]
    across = [system.bodies[k].parent for force in system.forces for k in force.joints.values()]
    return (
        free
        and not system.written
        and not system.constraints
        and min([*closing, *ends, *frames, *across], default=0) >= 0
        and all(force.element.paired() for force in system.forces)
        and not any(_loaded(system, segment) for segment in system.segments)
    )


def _loaded(system: System, segment: Segment) -> bool:
    """True when a segment of a beam carries a load from outside."""
    loads = [segment.data[name] for name in LOADS] + [*segment.variable_loads.values()]
    nodes = [node for *_, entries in loads for node in entries]
    return any(system.graph.nodes[node] != ("const", 0.0) for node in nodes)


def _multiplier(row: Row) -> MultiplierRow:
    return MultiplierRow(
        name=row.name,
        unit=row.force_unit,
        joint=row.owner,
        level=row.level,
        switched=bool(row.switched),
    )


def event_rows(system: System) -> list[EventRow]:
    """Everything that can happen, in the order of the block e."""
    return [
        EventRow(
            name=name,
            element=force.name,
            kind=event.kind,
            about=event.about,
            unit=written_unit(event.unit, slides(system.joints, force.joints.values())),
            beyond=event.beyond,
            decides={} if event.decides is None else {force.name: event.decides},
        )
        for name, (force, event) in zip(blocks.event_names(system), system.events, strict=True)
    ]


def tick_rows(system: System) -> list[TickRow]:
    """When events at known times happen."""
    return [
        TickRow(event=i, period=event.period, phase=event.phase)
        for i, (_, event) in enumerate(system.events)
        if event.kind == TICK
    ]


def _saved(equations: EquationRecord) -> tuple[Function, ...]:
    """Functions that a check of the model needs besides its compiled ones."""
    system = equations.system
    functions = [flat_scene.scene(system), *flat_scene.scene_poses(system)]
    optional = (flat_scene.scene_motion(system), flat_scene.time_jumps(system))
    functions += [one for one in optional if one is not None]
    if system.forces and "applied_forces" in equations.names():
        functions += [equations.function("applied_forces"), equations.function("wrenches")]
    if reaction_friction.verified_joints(system, equations.chosen):
        dynamics = Dynamics(Kinematics(system), equations.method)
        functions.append(reaction_friction.function(dynamics))
    if system.closures:
        functions.append(equations.function("dependents"))
    return tuple(functions)


def _scene(equations: EquationRecord) -> Tree:
    """The structure of the tree; its numbers are in the saved Function ``scene``."""
    system = equations.system
    unknown = ["the speeds are chosen by the user"] if equations.chosen else []
    verified = reaction_friction.verified_joints(system, equations.chosen)
    unknown += [
        f"the friction of '{force.name}' follows from reactions of closed loops"
        for force in reaction_friction.friction_forces(system)
        if not verified
    ]
    moved = (joint.name for joint in system.joints if flat_scene.has_speeds(joint))
    unknown += [f"the speeds of joint '{name}' are of its own making" for name in moved]
    curves = [flat_scene.curve(system.graph, joint) for joint in system.joints]
    treatment = equations.treatment
    closing: dict[str, Any] = {
        "cuts": [flat_scene.kind(cut) for cut in system.closing],
        "closers": flat_scene.closers(system),
        "treatment": Treatment(name=treatment.name, exact=treatment.exact),
    }
    return Tree(
        parents=[b.parent for b in system.bodies],
        kinds=[flat_scene.kind(j) for j in system.joints],
        rotations=[flat_scene.rotation_of(j) for j in system.joints],
        poses=flat_scene.pose_names(system)[: len(system.joints)],
        forces=list(dict.fromkeys(force.name for force in system.forces)),
        unknown=unknown,
        curves=curves if any(curves) else (),
        pressed=verified,
        samples=flat_scene.samples(system),
        locked=flat_scene.locked_at_start(system),
        # what closes loops, and how accelerations are made to obey
        **(closing if system.closed or system.closures else {}),
    )


def _body(system: System, number: int) -> str:
    return system.bodies[number].name if number >= 0 else "ground"


def _owners(system: System) -> tuple[list[str], list[str]]:
    """The joint of every entry of q and of u."""
    q = [j.name for j in system.joints if j.q >= 0 for _ in j.element.coordinates]
    u = [j.name for j in system.joints if j.u >= 0 for _ in j.element.speeds]
    return q, u


def _coordinates(system: System) -> list[CoordinateRow]:
    rows = zip(blocks.coordinates(system), _owners(system)[0], strict=True)
    components = (c for j in system.joints if j.q >= 0 for c in j.element.coordinates)
    return [
        CoordinateRow(name=name, unit=unit, default=default, joint=joint, reach=component.reach)
        for ((name, unit, default), joint), component in zip(rows, components, strict=True)
    ]


def _speeds(equations: EquationRecord) -> list[SpeedRow]:
    block = equations.blocks["u"]
    if equations.chosen:
        rows = zip(block.entries, block.units, strict=True)
        return [SpeedRow(name=name, unit=unit) for name, unit in rows]
    owners = _owners(equations.system)[1]
    components = [c for j in equations.system.joints if j.u >= 0 for c in j.element.speeds]
    return [
        SpeedRow(name=name, unit=unit, joint=joint, of=component.of)
        for name, unit, joint, component in zip(
            block.entries, block.units, owners, components, strict=True
        )
    ]


def limits_of(joint: Joint) -> dict[str, float]:
    """Declared limits of a joint, by name."""
    limits = zip(mechanism.LIMITS, joint.limits, strict=True)
    return {name: value for name, value in limits if value is not None and isfinite(value)}


def _joint(equations: EquationRecord, number: int) -> mechanism.JointRow:
    system = equations.system
    joint, element = system.joints[number], system.joints[number].element
    quaternion = element.quaternion
    has_speeds = joint.u >= 0 and not equations.chosen
    coupled = None
    if joint.coupling is not None:
        coupled = mechanism.Coupling(leader=system.joints[joint.coupling.leader].name)
    # as declared, not as the tree goes
    bodies = _body(system, system.bodies[number].parent), system.bodies[number].name
    frames = system.frames[joint.parent_frame].name, system.frames[joint.child_frame].name
    parent, child = reversed(bodies) if joint.reversed else bodies
    parent_frame, child_frame = reversed(frames) if joint.reversed else frames
    return mechanism.JointRow(
        name=joint.name,
        kind=element.kind,
        parent=parent,
        child=child,
        parent_frame=parent_frame,
        child_frame=child_frame,
        q=(joint.q, len(element.coordinates)) if joint.q >= 0 else None,
        u=(joint.u, len(element.speeds)) if has_speeds else None,
        q0=list(joint.q0) if joint.q0 is not None else None,
        u0=list(joint.u0) if joint.u0 is not None else None,
        limits=limits_of(joint),
        quaternion=joint.q + quaternion if quaternion is not None and joint.q >= 0 else None,
        rotation=flat_scene.rotation_of(joint),
        domain=element.domain,
        coupled=coupled,
        solved=_solved(system, joint),
        prescribed=joint.motion is not None,
    )


def _solved(system: System, joint: Joint) -> mechanism.LoopSolution | None:
    """The loop that determines a joint, and the names of its coordinates and speeds."""
    if joint.closure < 0:
        return None
    return mechanism.LoopSolution(
        loop=system.closures[joint.closure].cut.name,
        q=entries(joint.name, joint.element.coordinates),
        u=entries(f"{joint.name}.u", joint.element.speeds),
    )


def _cut(equations: EquationRecord, cut: Cut) -> mechanism.CutRow:
    system = equations.system
    return mechanism.CutRow(
        name=cut.name,
        kind=cut.element.kind,
        parent_frame=system.frames[cut.parent_frame].name,
        child_frame=system.frames[cut.child_frame].name,
        loop=[system.joints[i].name for i, _ in cut.path],
        reason=cut.reason,
        fixed=[
            mechanism.WeldRow(
                joint=weld.joint, frame=system.frames[weld.frame].name, side=weld.side
            )
            for weld in passed(system, cut)
        ],
        left_out=[mechanism.ConditionRow(**row) for row in left_out(cut)],
    )


def _frame(system: System, frame: Frame) -> mechanism.FrameRow:
    parts = system.bodies[frame.body].parts if frame.body >= 0 else ()
    part = parts[frame.part].name if parts else None
    return mechanism.FrameRow(name=frame.name, body=_body(system, frame.body), part=part)
