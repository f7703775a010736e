"""The flat scene: what an independent program needs to know about a system, as numbers of p.

``runtime/verification/verify`` runs a Newton-Euler recursion of its own over it, and pictures
place their shapes with it. Nothing here knows how equations are made.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from ..elements.joints.joint import Joint as Element
from ..elements.joints.joint import Reversed
from ..equations.functions.blocks import blocks, parameters
from ..equations.kinematics.kinematics import Kinematics
from ..equations.kinematics.loads import places
from ..ir.function import Block, Function, Output, live
from ..ir.graph import ZERO, Graph
from ..ir.matrix import Matrix
from ..schema.mechanism import ForceElementRow, ShapeRow
from ..schema.tree import CloserRow, SampleRow
from ..spatial.axis import complement, unit
from ..topology.system import Cut, Joint, System, joint_lengths

TIME_JUMPS = "time_jumps"


def force_element_rows(system: System) -> list[ForceElementRow]:
    """Force elements with the names of their frames, for pictures."""
    names = [frame.name for frame in system.frames]
    return [
        ForceElementRow(
            name=force.name,
            kind=force.element.kind,
            frames={role: names[k] for role, k in force.frames.items()},
        )
        for force in system.forces
    ]


def shape_rows(system: System) -> list[ShapeRow]:
    """Shapes with the names of their frames."""
    rows: list[tuple[int, Mapping[str, Any]]] = [*system.shapes]
    return [ShapeRow(frame=system.frames[k].name, **shape) for k, shape in rows]


def scene(system: System) -> Function:
    """The Function ``scene`` of p: masses, frames and axes of the tree, row by row per body.

    Outputs (nb bodies, nf frames): gravity (3); mass (nb); first_moment (nb, 3) and inertia
    (nb, 3, 3) about the body's origin in body axes; rotation (nb, 3, 3) and position (nb, 3) of
    the parent-side joint frame in axes of the parent body; axis, axis2 (nb, 3), pitch (nb) of the
    joint, 0 where it has none; ratio, offset (nb) of coupled joints, else 0; rotor (nb): inertia
    that drives add to the joint's coordinate; frame_rotation (nf, 3, 3) and frame_position (nf, 3)
    in axes of the frame's body; sizes (nb, 2) where joints have lengths of their own; cut_axis,
    cut_axis2 (nc, 3), cut_pitch (nc) and cut_sizes (nc, 2) of the joints that close loops, where
    there are any.
    """
    graph = system.graph.fork()
    bodies, joints, frames = system.bodies, system.joints, system.frames
    axes = [_axes(graph, joint) for joint in joints]
    nb, nf = len(bodies), len(frames)
    outputs = (
        _output("gravity", (3,), [system.gravity]),
        _output("mass", (nb,), [(b.mass,) for b in bodies]),
        _output("first_moment", (nb, 3), [b.first_moment for b in bodies]),
        _output("inertia", (nb, 3, 3), [b.inertia for b in bodies]),
        _output("rotation", (nb, 3, 3), [j.rotation for j in joints]),
        _output("position", (nb, 3), [j.position for j in joints]),
        _output("axis", (nb, 3), [first for first, _ in axes]),
        _output("axis2", (nb, 3), [second for _, second in axes]),
        _output("pitch", (nb,), [_pitch(j) for j in joints]),
        _output("ratio", (nb,), [(j.coupling.ratio if j.coupling else 0,) for j in joints]),
        _output("offset", (nb,), [(j.coupling.offset if j.coupling else 0,) for j in joints]),
        _output("rotor", (nb,), [(node,) for node in _rotors(system, graph)]),
        _output("frame_rotation", (nf, 3, 3), [f.rotation for f in frames]),
        _output("frame_position", (nf, 3), [f.position for f in frames]),
        *_sizes(joints),
        *_cuts(graph, system.closing),
    )
    return _function("scene", system, graph, outputs, "the scene as numbers")


def time_jumps(system: System) -> Function | None:
    """The Function ``time_jumps`` of t, p: what passes zero where the scene jumps at a time.

    Outputs: jumps (n): the two sides of every comparison of t with what is constant along a run,
    one less the other. None where there is no such comparison.
    """
    graph = system.graph.fork()
    timed, fixed = set[int](), set[int]()
    conditions = list[int]()
    for i, node in enumerate(system.graph.nodes):
        operands = node[1:] if node[0] not in ("const", "var", "atom") else ()
        if node[0] == "var" and node[1] == "t":
            timed.add(i)
        elif node[0] == "const" or (node[0] == "var" and node[1] == "p"):
            fixed.add(i)
        elif operands and all(k in timed or k in fixed for k in operands):
            (timed if any(k in timed for k in operands) else fixed).add(i)
            if node[0] in ("lt", "le") and i in timed:
                conditions.append(graph.sub(*operands))
    outputs = (_output("jumps", (len(conditions),), [(node,) for node in conditions]),)
    if not conditions:
        return None
    return _function(TIME_JUMPS, system, graph, outputs, "what jumps at times passes zero there")


def _sizes(joints: Sequence[Joint | Cut], name: str = "sizes") -> list[Output]:
    """Lengths of rods, radii of wheels and of their crowns, where there are any."""
    rows = [joint_lengths(joint) for joint in joints]
    used = any(any(row) for row in rows)
    return [_output(name, (len(rows), 2), rows)] if used else []


def _pitch(joint: Joint | Cut) -> tuple[int, ...]:
    return joint.data["pitch"][2] if "pitch" in joint.data else (ZERO,)


def kind(joint: Joint | Cut) -> str:
    """Kind of a joint, after the word ``reversed`` where its pose is told backwards."""
    backwards = isinstance(joint.element, Reversed)
    return f"reversed {joint.element.kind}" if backwards else joint.element.kind


def _cuts(graph: Graph, cuts: Sequence[Cut]) -> list[Output]:
    """Axes and lengths of the joints that close loops, where there are any."""
    if not cuts:
        return []
    first, second = zip(*(_axes(graph, cut) for cut in cuts), strict=True)
    return [
        _output("cut_axis", (len(cuts), 3), first),
        _output("cut_axis2", (len(cuts), 3), second),
        _output("cut_pitch", (len(cuts),), [_pitch(cut) for cut in cuts]),
        *_sizes(cuts, "cut_sizes"),
    ]


def declared(joint: Joint | Cut) -> Element:
    """The element of a joint as the user gave it, whichever of its bodies carries the other."""
    return joint.element.element if isinstance(joint.element, Reversed) else joint.element


def curve(graph: Graph, joint: Joint) -> list[Any] | None:
    """Breaks, coefficients by component and piece, and period (0 for none) of a joint's curve."""
    if "curve" not in joint.data:
        return None
    numbers = [graph.value(graph.nodes[node][1]) for node in joint.data["curve"][2]]
    tables = [graph.tables[int(number or 0)] for number in numbers]
    breaks = list(tables[0].breaks)
    period = breaks[-1] if getattr(declared(joint), "closed", False) else 0.0
    return [breaks, [[list(c) for c in t.coefficients] for t in tables], period]


def scene_motion(system: System) -> Function | None:
    """The Function ``scene_motion``: motion (nb, 3) = value, rate and acceleration of prescribed
    joints, 0 elsewhere; None where nothing is prescribed."""
    motions = [joint.motion for joint in system.joints]
    if not any(motions):
        return None
    rows = [(m.value, m.rate, m.acceleration) if m else (0, 0, 0) for m in motions]
    outputs = (_output("motion", (len(rows), 3), rows),)
    return _function("scene_motion", system, system.graph, outputs, "motion of prescribed joints")


def scene_poses(system: System) -> tuple[Function, ...]:
    """Functions of the coordinates q of one joint and p: rotation (3, 3) and position (3) of its
    child seen from its parent, as they were written. Joints that move alike share one."""
    return tuple(_poses(system)[0])


def pose_names(system: System) -> list[str]:
    """Index into :func:`scene_poses` of every joint: of the tree, then of those that close it."""
    return [f"scene_pose_{k}" for k in _poses(system)[1]]


def closers(system: System) -> list[CloserRow]:
    """Pose, and number of coordinates and speeds, of the joints that close loops."""
    rows = []
    poses = pose_names(system)[len(system.joints) :]
    for cut, pose in zip(system.closing, poses, strict=True):
        element, turns = _closer(cut), "quaternion" if rotation_of(cut) else None
        q, u = len(element.coordinates), len(element.speeds)
        rows.append(CloserRow(pose=pose, rotation=turns, q=q, u=u))
    return rows


def has_speeds(joint: Joint) -> bool:
    """True when speeds are neither rates of coordinates nor the angular velocity of a rotation."""
    rates = type(declared(joint)).rates
    return rates is not Element.rates and rotation_of(joint) is None


def _closer(cut: Cut) -> Element:
    """The element of a joint that closes a loop, a free rotation as a unit quaternion."""
    element = declared(cut)
    if rotation_of(cut):
        return replace(element, rotation="quaternion")  # type: ignore[type-var]
    return element


def rotation_of(joint: Joint | Cut) -> str | None:
    """Name of the parametrization of a joint's rotation."""
    name = getattr(joint.element, "rotation", None)
    return name if isinstance(name, str) else None


def _poses(system: System) -> tuple[list[Function], list[int]]:
    """Every pose once, and which of them each joint has."""
    graph, block = system.graph.fork(), parameters(system)
    numbers: dict[tuple[int, ...], int] = {}
    # joints of equal elements and data have equal expressions: these are made once
    alike: dict[object, int] = {}
    functions, used = list[Function](), list[int]()
    joints: tuple[Joint | Cut, ...] = (*system.joints, *system.closing)
    for joint in joints:
        element = _closer(joint) if isinstance(joint, Cut) else declared(joint)
        form = _form(element, joint)
        if form in alike:
            used.append(alike[form])
            continue
        count = len(element.coordinates)
        q = Matrix(graph, count, 1, [graph.var("q", i) for i in range(count)])
        data = {name: Matrix(graph, *entry) for name, entry in joint.data.items()}
        rotation, position = element.pose(q, **data)
        key = (count, *rotation.nodes, *position.nodes)
        used.append(alike.setdefault(form, numbers.setdefault(key, len(functions))))
        if used[-1] < len(functions):
            continue
        outputs = (
            _output("rotation", (3, 3), [rotation.nodes]),
            _output("position", (3,), [position.nodes]),
        )
        coordinates = Block("q", tuple(c.name for c in element.coordinates), ("",) * count)
        name, about = f"scene_pose_{len(functions)}", f"pose of a {element.kind} joint"
        functions.append(Function(name, graph, (coordinates, block), outputs, about=about))
    return functions, used


def _form(element: Element, joint: Joint | Cut) -> object:
    """A key that is equal for joints of equal elements and data."""
    try:
        hash(element)
    except TypeError:  # equations that a user brings hold dictionaries
        return object()  # equal to nothing: an id may come again, once its element is gone
    return (element, tuple(joint.data.items()))


def _rotors(system: System, graph: Graph) -> list[int]:
    """Inertia of rotors that turn with joints of one coordinate, per joint."""
    inertias = [ZERO] * len(system.joints)
    for force in system.forces:
        data = {
            name: Matrix(graph, rows, columns, nodes)
            for name, (rows, columns, nodes) in force.data.items()
        }
        for role, inertia in force.element.rotor_inertia(data).items():
            joint = force.joints[role]
            if system.joints[joint].element.bodiless:
                continue
            inertias[joint] = graph.add(inertias[joint], inertia.nodes[0])
    return inertias


def _axes(graph: Graph, joint: Joint | Cut) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """First and second axis of a joint, in the joint frame."""
    none = (0, 0, 0)
    directions = {
        name: joint.data[name][2]
        for name in ("axis", "axis1", "axis2", "normal")
        if name in joint.data
    }
    # joints that move across a direction have the first of the two directions across it
    across = directions.get("normal", directions.get("axis"))
    if across is not None and not joint.element.line:
        first, _ = complement(unit(Matrix(graph, 3, 1, across)))
        return across, first.nodes
    return directions.get("axis", directions.get("axis1", none)), directions.get("axis2", none)


def _output(name: str, shape: tuple[int, ...], rows: Iterable[Iterable[int]]) -> Output:
    return Output(name, shape, tuple(node for row in rows for node in row))


def _function(
    name: str, system: System, graph: Graph, outputs: tuple[Output, ...], about: str
) -> Function:
    """A Function that declares the blocks it reads."""
    roots = [node for output in outputs for node in output.nodes]
    read = {graph.nodes[i][1] for i in live(graph, roots) if graph.nodes[i][0] == "var"}
    # names of coordinates and speeds take a while, and the scene alone reads parameters
    all_blocks = {"p": parameters(system)} if read <= {"p"} else blocks(system)
    return Function(
        name, graph, tuple(all_blocks[b] for b in all_blocks if b in read), outputs, about=about
    )


def locked_at_start(system: System) -> list[str]:
    """Elements that hold a velocity in the modes of the start."""
    k = Kinematics(system)
    names = []
    for force in system.forces:
        if force.element.locked_velocities():
            starts = [k.graph.const(mode.default) for mode in force.element.modes()]
            at = replace(places(k, force), s=Matrix(k.graph, len(starts), 1, starts))
            if any(one.active.node != ZERO for one in force.element.holds(at)):
                names.append(force.name)
    return names


def samples(system: System) -> list[SampleRow]:
    """Reference values of another program for written equations, unless the user added to them."""
    constraints = [entry.name for entry in system.constraints]
    if len(system.forces) != len(system.joints):
        return []
    rows = (sample for joint in system.joints for sample in joint.element.samples)
    return [SampleRow(**sample) for sample in rows if sample["held"] == constraints]
