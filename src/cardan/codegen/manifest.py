"""The manifest: everything the runtime must know about a model, as plain data.

Its schema is ``docs/manifest.schema.json``. Within an ABI version, entries are only added.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from math import isfinite
from typing import Any

from ..elements.internal import TICK
from ..elements.joints.joint import entries
from ..elements.quantity import written_unit
from ..equations import blocks, pressing
from ..equations.constraints import Row, left_out
from ..equations.dynamics import Dynamics
from ..equations.kinematics import Kinematics
from ..equations.record import Equations
from ..ir.function import Function
from ..topology.internals import slides
from ..topology.segment import Segment
from ..topology.system import Cut, Force, Frame, Joint, System
from ..topology.welds import passed
from ..version import ABI, MANIFEST, VERSION
from . import flat

LOADS = ("dead_force", "dead_moment", "follower_force", "follower_moment")
LIMITS = ("lower", "upper", "speed", "effort")


@dataclass(frozen=True)
class Base:
    """The manifest of a model without functions yet.

    Attributes:
        data: The manifest.
        saved: Makes the Functions of the flat scene, which are saved beside it.
    """

    data: dict[str, Any]
    saved: Callable[[], tuple[Function, ...]] = field(repr=False, compare=False)


def base(equations: Equations, functions: Sequence[str] = ()) -> Base:
    """What the manifest says before any function is written.

    Args:
        equations: Of the system.
        functions: Names that may be asked for.
    """
    system = equations.system
    joints = [_joint(equations, i) for i in range(len(system.joints))]
    # of those that act on several bodies once
    once = {force.name: force for force in system.forces}.values()
    limits = [row for force in once for row in _limits(system, force)]
    absent = {name: why for joint in system.joints for name, why in joint.element.lacks.items()}
    data: dict[str, Any] = {
        "abi": ABI.version,
        "schema": MANIFEST.version,
        "cardan": VERSION,
        "name": system.name,
        "method": equations.method,
        "coordinates": _coordinates(system),
        "speeds": _speeds(equations),
        "z": [
            {"name": name, "unit": unit, "default": default}
            for name, unit, default in blocks.internals(system)
        ],
        "s": [
            {"name": name, "default": mode.default, "labels": {str(k): v for k, v in mode.labels}}
            for name, mode in blocks.discrete(system)
        ],
        **({"events": _events(system), "ticks": _ticks(system)} if system.events else {}),
        "inputs": [{"name": i.name, "unit": i.unit, "default": i.default} for i in system.inputs],
        "parameters": parameter_rows(system),
        "structural": dict(system.structural),
        **({"limits": limits} if limits else {}),
        "multipliers": [_multiplier(row) for row in equations.constraint_rows],
        "cuts": [_cut(equations, cut) for cut in system.closing],
        "joints": joints,
        "fixed": list(system.fixed),
        "bodies": [
            {"name": b.name, "parent": _body(system, b.parent), "parts": [p.name for p in b.parts]}
            for b in system.bodies
        ],
        "frames": [_frame(system, frame) for frame in system.frames],
        "shapes": [{"frame": system.frames[k].name, **shape} for k, shape in system.shapes],
        "outputs": [{"name": o.name, "unit": o.unit} for o in system.outputs],
        "quaternions": [j["quaternion"] for j in joints if j["quaternion"] is not None],
        "notes": list(system.notes),
        "snaps": list(system.snaps),
        "available": list(functions),
        **({"absent": absent} if absent else {}),
        "scene": _scene(equations),
        "functions": {},
        "sha256": {},
    }
    if isolated(system):
        data["isolated"] = True
    if data["multipliers"] and not equations.treatment.exact:
        # what holds such a system together is that its constraints give way
        data["projected"] = False
    return Base(data, lambda: _saved(equations))


def isolated(system: System) -> bool:
    """Whether nothing but gravity acts on a scene from outside, so that its momenta stay.

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
    """Whether a segment of a beam carries a load from outside."""
    nodes = [node for name in LOADS for node in segment.data.get(name, (0, 0, ()))[2]]
    return any(system.graph.nodes[node] != ("const", 0.0) for node in nodes)


def parameter_rows(system: System) -> list[dict[str, Any]]:
    """What the manifest says about every entry of p."""
    return [
        {
            "name": p.name,
            "unit": p.unit,
            "default": p.value,
            "kind": "free",
            "declared": p.declared,
        }
        for p in system.parameters
    ]


def _limits(system: System, force: Force) -> Iterator[dict[str, Any]]:
    """What parameters may be that are numbers of a force element."""
    for limit in force.element.limits():
        name, other = (_source(system, force, part) for part in (limit.name, limit.other))
        if not isinstance(name, str) or (limit.other and other is None):
            continue
        least = other if limit.other else limit.least
        row = {"who": force.element.title, "parameter": name, "told": limit.told}
        ends: dict[str, Any] = {"least": least, "most": limit.most}
        ends = {k: v for k, v in ends.items() if isinstance(v, str) or isfinite(v)}
        yield {**row, **ends, **({"open": True} if limit.open else {})}


def _source(system: System, force: Force, quantity: str) -> str | float | None:
    """The parameter or the number that a quantity is; None if it is something else."""
    rows, columns, nodes = force.data.get(quantity, (0, 0, ()))
    if (rows, columns) != (1, 1):
        return None
    node = system.graph.nodes[nodes[0]]
    if node[0] == "const":
        return float(node[1])
    return system.parameters[node[2]].name if node[:2] == ("var", "p") else None


def _multiplier(row: Row) -> dict[str, Any]:
    told = {"name": row.name, "unit": row.force_unit, "joint": row.owner, "level": row.level}
    return {**told, **({"switched": True} if row.switched else {})}


def _events(system: System) -> list[dict[str, Any]]:
    """Everything that can happen, in the order of the block e."""
    return [
        {
            **{"name": name, "element": force.name, "kind": event.kind, "about": event.about},
            "unit": written_unit(event.unit, slides(system.joints, force.joints.values())),
            **({"beyond": event.beyond} if event.beyond else {}),
            **({} if event.decides is None else {"decides": {force.name: event.decides}}),
        }
        for name, (force, event) in zip(blocks.event_names(system), system.events, strict=True)
    ]


def _ticks(system: System) -> list[dict[str, Any]]:
    """When events at known times happen."""
    return [
        {"event": i, "period": event.period, "phase": event.phase}
        for i, (_, event) in enumerate(system.events)
        if event.kind == TICK
    ]


def _saved(equations: Equations) -> tuple[Function, ...]:
    """What a check of the model needs besides its compiled functions."""
    system = equations.system
    found = [flat.scene(system), *flat.scene_poses(system)]
    motion = flat.scene_motion(system)
    jumps = flat.time_jumps(system)
    found += [one for one in (motion, jumps) if one is not None]
    if system.forces and "applied" in equations.names():
        found += [equations.function("applied"), equations.function("wrenches")]
    if pressing.judged(system, equations.chosen):
        found.append(pressing.told(Dynamics(Kinematics(system), equations.method)))
    if system.closures:
        found.append(equations.function("dependents"))
    return tuple(found)


def _scene(equations: Equations) -> dict[str, Any]:
    """The structure of the tree; its numbers are in the saved Function ``scene``."""
    system = equations.system
    unknown = ["the speeds are chosen by the user"] if equations.chosen else []
    judged = pressing.judged(system, equations.chosen)
    unknown += [
        f"the friction of '{force.name}' follows from reactions of closed circuits"
        for force in pressing.pressed(system)
        if not judged
    ]
    unknown += [
        f"the speeds of joint '{joint.name}' are of its own making"
        for joint in system.joints
        if flat.own_speeds(joint)
    ]
    samples = _samples(system)
    curves = [flat.curve(system.graph, joint) for joint in system.joints]
    return {
        "parents": [b.parent for b in system.bodies],
        "kinds": [flat.kind(j) for j in system.joints],
        "rotations": [flat.rotation_of(j) for j in system.joints],
        "poses": flat.pose_names(system)[: len(system.joints)],
        "forces": list(dict.fromkeys(force.name for force in system.forces)),
        "unknown": unknown,
        **({"curves": curves} if any(curves) else {}),
        **({"pressed": judged} if judged else {}),
        **({"samples": samples} if samples else {}),
        **(_circuits(equations) if system.closed or system.closures else {}),
    }


def _samples(system: System) -> list[Any]:
    """What another program says of written equations, unless the user added to them."""
    held = [entry.name for entry in system.constraints]
    if len(system.forces) != len(system.joints):
        return []
    found = (sample for joint in system.joints for sample in joint.element.samples)
    return [sample for sample in found if sample["held"] == held]


def _circuits(equations: Equations) -> dict[str, Any]:
    """What closes circuits, and how accelerations are made to obey."""
    treatment, system = equations.treatment, equations.system
    return {
        "cuts": [flat.kind(cut) for cut in system.closing],
        "closers": flat.closers(system),
        "treatment": {"name": treatment.name, "exact": treatment.exact},
    }


def _body(system: System, number: int) -> str:
    return system.bodies[number].name if number >= 0 else "ground"


def _owners(system: System) -> tuple[list[str], list[str]]:
    """The joint of every entry of q and of u."""
    q = [j.name for j in system.joints if j.q >= 0 for _ in j.element.coordinates]
    u = [j.name for j in system.joints if j.u >= 0 for _ in j.element.speeds]
    return q, u


def _coordinates(system: System) -> list[dict[str, Any]]:
    rows = zip(blocks.coordinates(system), _owners(system)[0], strict=True)
    made: list[dict[str, Any]] = [
        {"name": name, "unit": unit, "default": default, "joint": joint}
        for (name, unit, default), joint in rows
    ]
    components = [c for j in system.joints if j.q >= 0 for c in j.element.coordinates]
    for row, component in zip(made, components, strict=True):
        if component.reach is not None:
            row["reach"] = component.reach
    return made


def _speeds(equations: Equations) -> list[dict[str, Any]]:
    block = equations.blocks["u"]
    owners: list[str | None] = [*_owners(equations.system)[1]]
    if equations.chosen:
        owners = [None] * len(block)
    rows = zip(block.entries, block.units, owners, strict=True)
    made: list[dict[str, Any]] = [
        {"name": name, "unit": unit, "joint": joint} for name, unit, joint in rows
    ]
    components = [c for j in equations.system.joints if j.u >= 0 for c in j.element.speeds]
    for row, component in zip(made, components if not equations.chosen else (), strict=False):
        if component.of:
            row["of"] = component.of
    return made


def limits_of(joint: Joint) -> dict[str, float]:
    """What is declared of the limits of a joint, by name."""
    limits = zip(LIMITS, joint.limits, strict=True)
    return {name: value for name, value in limits if value is not None and isfinite(value)}


def _joint(equations: Equations, number: int) -> dict[str, Any]:
    system = equations.system
    joint, element = system.joints[number], system.joints[number].element
    quaternion = element.quaternion
    own_speeds = joint.u >= 0 and not equations.chosen
    coupled = None
    if joint.coupling is not None:
        coupled = {"leader": system.joints[joint.coupling.leader].name}
    # as declared, not as the tree goes
    bodies = _body(system, system.bodies[number].parent), system.bodies[number].name
    frames = system.frames[joint.parent_frame].name, system.frames[joint.child_frame].name
    parent, child = reversed(bodies) if joint.reversed else bodies
    parent_frame, child_frame = reversed(frames) if joint.reversed else frames
    return {
        "name": joint.name,
        "kind": element.kind,
        "parent": parent,
        "child": child,
        "parent_frame": parent_frame,
        "child_frame": child_frame,
        "q": [joint.q, len(element.coordinates)] if joint.q >= 0 else None,
        "u": [joint.u, len(element.speeds)] if own_speeds else None,
        "q0": list(joint.q0) if joint.q0 is not None else None,
        "u0": list(joint.u0) if joint.u0 is not None else None,
        "limits": limits_of(joint),
        "quaternion": joint.q + quaternion if quaternion is not None and joint.q >= 0 else None,
        "rotation": flat.rotation_of(joint),
        "domain": element.domain,
        "coupled": coupled,
        "solved": _solved(system, joint),
        "prescribed": joint.motion is not None,
    }


def _solved(system: System, joint: Joint) -> dict[str, Any] | None:
    """The circuit that determines a joint, and the names of its coordinates and speeds."""
    if joint.closure < 0:
        return None
    names = {
        "q": entries(joint.name, joint.element.coordinates),
        "u": entries(f"{joint.name}.u", joint.element.speeds),
    }
    return {"circuit": system.closures[joint.closure].cut.name, **names}


def _cut(equations: Equations, cut: Cut) -> dict[str, Any]:
    system, rest = equations.system, left_out(cut)
    welds = [
        {"joint": weld.joint, "frame": system.frames[weld.frame].name, "side": weld.side}
        for weld in passed(system, cut)
    ]
    return {
        "name": cut.name,
        "kind": cut.element.kind,
        "parent_frame": system.frames[cut.parent_frame].name,
        "child_frame": system.frames[cut.child_frame].name,
        "circuit": [system.joints[i].name for i, _ in cut.path],
        "reason": cut.reason,
        **({"fixed": welds} if welds else {}),
        **({"left_out": rest} if rest else {}),
    }


def _frame(system: System, frame: Frame) -> dict[str, Any]:
    parts = system.bodies[frame.body].parts if frame.body >= 0 else ()
    part = parts[frame.part].name if parts else None
    return {"name": frame.name, "body": _body(system, frame.body), "part": part}
