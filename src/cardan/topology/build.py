"""Model -> System: the spanning tree, coordinate slots, and everything written as expressions."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from ..elements.forces.force import ForceElement
from ..elements.forces.gravity.gravitation import Gravitation
from ..elements.forces.line_load import LineLoad
from ..elements.limits import NumberLimits, check
from ..errors import ModelError, TopologyError, near
from ..ir.function import live
from ..ir.graph import ZERO, Graph
from ..processes import collector_paused
from ..scene import checks
from ..scene.beam import UNITS, Beam, Cable
from ..scene.body import Body
from ..scene.masses import pulled
from ..scene.origins import located
from ..scene.scene import SceneRecord
from . import internal_states, prescribed_motion, scene_warnings
from .assembly import Assembly
from .beams.nodal_scene import with_beams
from .beams.segment_tables import GravityOnBeam
from .beams.segments import segments, settle, with_line_loads
from .cables.cable_parts import with_cables
from .conversion import Converter
from .drawing import announcements
from .drawing.shapes import pictures
from .loops.circuits import Numbers, independent
from .loops.closed_forms import closed_forms
from .loops.legs import Axes
from .rotors import with_rotors, with_rotors_on
from .structural_parameters import BuiltIn
from .superelements.superelement_parts import parts_of_system, with_superelements
from .system import Atom, Closure, Cut, Force, Joint, Named, System
from .tree import rooted_tree

# leaves of expressions that move with the system
MOVING = (("var", "q"), ("var", "u"))


@collector_paused()
def build(
    model: SceneRecord,
    specialize: bool | Sequence[str] | Mapping[str, float] = False,
    branches: Mapping[str, str] | None = None,
    independent: Collection[str] | None = None,
) -> System:
    """The system graph of a model.

    Args:
        model: The scene; it is not changed.
        specialize: Parameters that become numbers of the equations: names, or values by name;
            True for all.
        branches: Solve loops in closed form where that can be: joint that closes one -> "+" or
            "-". None: solve none.
        independent: Joints that no loop is solved for; a single one may be a name alone.

    Returns:
        The system, with notes on what does not act.

    Raises:
        TopologyError: loops, loose bodies, reversed joints; ``independent`` names no joint.
        ModelError: quantities that cannot be what they say.
    """
    try:
        independent_joints = (independent,) if isinstance(independent, str) else independent or ()
        checks.check_distinguishable(model)
        cables = tuple(model.cables.values())
        model = with_superelements(with_cables(model, _assembled))
        return _build(model, cables, BuiltIn.of(specialize), branches, independent_joints)
    except ZeroDivisionError as problem:
        raise ModelError(
            f"{problem}. With specialize= a number that is built in may be 0: leave it free, or "
            "give another value"
        ) from problem
    except (ModelError, TopologyError) as problem:
        located_problem = located(problem, model.origins)
        if located_problem is problem:
            raise
        raise located_problem from problem


def _build(
    model: SceneRecord,
    cables: Sequence[Cable],
    built_in: BuiltIn | None,
    branches: Mapping[str, str] | None,
    independent: Collection[str],
    placing: Collection[str] = (),
) -> System:
    empty = _empty(model, built_in)
    scene, convert = empty.model, empty.convert
    inputs = prescribed_motion.declare_inputs(scene, convert)
    with convert.graph.made_by("ground", "gravity"):
        gravity = convert.vector(scene.gravity, "gravity", "m/s^2")

    # the tree: bodies, frames, joints and their slots
    assembly = _grown(empty)
    settle(assembly)
    cuts, solved = _circuits(assembly, branches, independent)
    closures, closable = ((), solved) if branches is None else (solved, ())
    assembly.number(closures)
    for frame in [one for one in scene.frames.values() if one.named]:
        assembly.frame(frame, frame.name)

    expression_inertias = announcements.check_masses(assembly.unchecked, convert)
    beams, limits = segments(scene, assembly)
    if assembly.beams.geometry:
        # where beams are is numbers: so are the parameters that say it
        placing = assembly.beams.geometry
        names = BuiltIn.with_names(built_in, placing)
        return _build(model, cables, names, branches, independent, placing)
    announcements.check_lone_moments(model, assembly, expression_inertias)

    # what expressions may speak of, then the expressions
    convert.moving = True
    places = internal_states.numbered(scene, convert)
    atoms = _atoms(scene, assembly)
    forces, fields = _pointwise(model, assembly, places)
    beams = with_line_loads(beams, scene, convert)
    joints = prescribed_motion.prescribed(
        scene, assembly.joints, assembly.joint_number, convert, inputs
    )
    all_cuts = (*cuts, *(closure.cut for closure in closures))
    parents = [rigid.parent for rigid in assembly.bodies]
    scene_warnings.check_concurrent_forces(
        model, forces, assembly.frames, joints, parents, all_cuts, convert
    )
    scene_warnings.check_prescribed(model, joints, all_cuts)
    outputs = tuple([_output(scene, convert, name) for name in scene.outputs])
    constraints = tuple([_constraint(scene, convert, name) for name in scene.constraints])
    bodies = tuple([rigid.body(convert.graph) for rigid in assembly.bodies])
    convert.finish()
    limits += _limits(forces, fields, [*joints, *all_cuts], cables, convert)
    system = System(
        name=scene.name,
        graph=convert.graph,
        gravity=gravity,
        bodies=bodies,
        joints=tuple(joints),
        frames=tuple(assembly.frames),
        forces=forces,
        parameters=tuple(convert.parameters),
        inputs=inputs,
        outputs=outputs,
        atoms=atoms,
        nq=assembly.nq,
        nu=assembly.nu,
        cuts=cuts,
        closures=closures,
        closable=closable,
        constraints=constraints,
        superelements=parts_of_system(scene, assembly),
        segments=tuple(replace(one, fields=fields.get(one.name, ())) for one in beams),
        ground_parts=tuple(assembly.ground.parts),
        fixed=tuple(assembly.fixed),
        shapes=pictures(scene, assembly.numbers),
        snaps=tuple(scene.snaps),
        structural=convert.structural,
        number_limits=limits,
    )
    return announcements.announce(system, scene, convert, placing)


def _limits(
    forces: Sequence[Force],
    fields: Mapping[str, Sequence[GravityOnBeam]],
    joints: Sequence[Joint | Cut],
    cables: Sequence[Cable],
    convert: Converter,
) -> tuple[NumberLimits, ...]:
    """Limits of the numbers of cables, of joints and of force elements.

    Raises:
        ModelError: one is exceeded at the defaults.
    """
    limits: list[NumberLimits] = []
    for cable in cables:
        nodes = {
            key: (convert.converted(f"{cable.name}.{key}", getattr(cable, key), unit),)
            for key, unit in UNITS.items()
        }
        limits.append(NumberLimits(f"cable '{cable.name}'", cable.limits(), nodes))
    for joint in joints:
        data = {key: nodes for key, (*_, nodes) in joint.data.items()}
        owner = f"joint '{joint.name}' ({joint.element.called})"
        limits.append(NumberLimits(owner, joint.element.limits(), data))
    # those that act on several bodies or beams once
    on_beams = (field for several in fields.values() for field in several)
    acting: dict[str, tuple[ForceElement, Mapping[str, tuple[int, int, tuple[int, ...]]]]]
    acting = {field.force: (field.element, field.data) for field in on_beams}
    acting |= {force.name: (force.element, force.data) for force in forces}
    for name, (element, quantities) in acting.items():
        data = {key: nodes for key, (*_, nodes) in quantities.items()}
        # such as the inertia of a rotor, which is that of a body
        for limit in element.limits():
            value = getattr(element, limit.name, None)
            if limit.name not in data and value is not None:
                data[limit.name] = (convert.converted(f"{name}.{limit.name}", value, ""),)
        limits.append(NumberLimits(element.title, element.limits(), data))
    check(limits, convert.graph, convert.defaults)
    return tuple(limits)


def _assembled(model: SceneRecord) -> Assembly:
    """The bodies of a scene in its reference configuration."""
    assembly = _empty(model, None)
    assembly.reference.active = True
    return _grown(assembly)


def _empty(model: SceneRecord, built_in: BuiltIn | None) -> Assembly:
    """The assembly of a scene, with its rotors and the nodes of its beams, without bodies yet."""
    scene, rotors = with_rotors(model)
    scene, nodes = with_beams(scene)
    nodes.check()
    convert = Converter(scene, Graph(), built_in)
    convert.same.update(rotors.same)
    return Assembly(scene, convert, rotors.place, nodes)


def _grown(assembly: Assembly) -> Assembly:
    """All bodies and joints of its scene."""
    tree, closing = rooted_tree(assembly.model)
    keeping_coordinates = {joint.joint.name for joint in closing if joint.keeps_coordinates}
    # rotors sit where the joints do that they drive
    late = [
        branch for branch in tree if assembly.rotors.get(branch.joint.name) in keeping_coordinates
    ]
    for branch in tree:
        if branch not in late:
            assembly.add(branch)
    for joint in closing:
        assembly.close(joint)
    for branch in late:
        assembly.add(branch)
    assembly.couple()
    return assembly


def _circuits(
    assembly: Assembly, branches: Mapping[str, str] | None, independent_joints: Collection[str]
) -> tuple[tuple[Cut, ...], tuple[Closure, ...]]:
    """The cuts that are left, and those that are or could be solved in closed form.

    Args:
        assembly: Bodies and joints.
        branches: As :func:`build` takes them.
        independent_joints: Joints that are not solved for.

    Raises:
        TopologyError: one of these does not exist.
    """
    for name in independent_joints:
        if name not in assembly.model.joints:
            hint = near(name, assembly.model.joints)
            raise TopologyError(f"independent: joint '{name}' does not exist.{hint}")
    parents = [rigid.parent for rigid in assembly.bodies]
    convert, joints = assembly.convert, assembly.joints
    cuts = independent(assembly.cuts, joints, parents, assembly.frames, convert)
    if not cuts and not branches:
        return cuts, ()
    user_joints = assembly.model.joints
    free = [
        user_joints[j.name].prescribed is None and j.name not in independent_joints for j in joints
    ]
    axes = Axes(joints, parents, Numbers(convert))
    solved, open_cuts = closed_forms(cuts, axes, free, branches or {})
    return (cuts if branches is None else open_cuts), solved


def _atoms(scene: SceneRecord, assembly: Assembly) -> dict[str, Atom]:
    """The placeholders of expressions, by number of frame or joint.

    Raises:
        ModelError: coordinates of a fixed joint, or a name that is taken.
    """
    convert = assembly.convert
    atoms: dict[str, Atom] = {}
    for name, entry in scene.atoms.items():
        if entry.quantity == "state":
            internal_states.check_state(name, scene, convert)
            continue
        if entry.quantity in ("q", "u"):
            number = assembly.joint_number.get(entry.place)
            if number is None:
                raise ModelError(f"'{name}': joint '{entry.place}' is fixed; it has no coordinates")
            # coordinates with slots are variables already
            if assembly.joints[number].q >= 0:
                continue
            atoms[name] = Atom(entry.quantity, number)
        else:
            place, wrt, in_ = (
                assembly.frame(p, p.name) if p is not None else 0
                for p in (entry.place, entry.wrt, entry.in_)
            )
            atoms[name] = Atom(entry.quantity, place, wrt, in_, entry.component)
        if name in convert.symbols:
            raise ModelError(
                f"'{name}' stands for the motion of a frame or joint, and for a parameter or an "
                "input; rename one of them"
            )
        convert.define(name, convert.graph.atom(name))
    return atoms


def _pointwise(
    model: SceneRecord, assembly: Assembly, places: Mapping[str, tuple[int, int, int]]
) -> tuple[tuple[Force, ...], dict[str, tuple[GravityOnBeam, ...]]]:
    """All force elements but the loads along beams; by the name of a beam, fields that pull it."""
    forces, fields = list[Force](), dict[str, tuple[GravityOnBeam, ...]]()
    for name, user in model.forces.items():
        if isinstance(user.element, LineLoad):
            continue
        force = _force(model, assembly, name, places[name])
        if user.element.masses() is None:
            forces.append(force)
            continue
        members = pulled(model, user)
        # along beams their elements carry it
        for beam in (one for one in members if isinstance(one, Beam)):
            assert isinstance(user.element, Gravitation)
            field = GravityOnBeam(name, user.element, force.frames["center"], force.data)
            fields[beam.name] = (*fields.get(beam.name, ()), field)
        rigid = [one for one in members if isinstance(one, Body)]
        forces += [
            replace(
                force,
                data=force.data | assembly.weights[body],
                frames=force.frames | {"body": assembly.frame(body, body.name)},
            )
            for body in with_rotors_on(assembly.model, rigid)
        ]
    return tuple(forces), fields


def _force(model: SceneRecord, assembly: Assembly, name: str, slots: tuple[int, int, int]) -> Force:
    """A force element with its data, frames and joints found; its first slots in z, s and e."""
    convert, element = assembly.convert, model.forces[name].element
    joints = _joints(assembly, name, element)
    sliding = internal_states.slides(assembly.joints, joints.values())
    if element.misfit(sliding):
        raise ModelError(f"force '{name}' ({element.kind}): {element.misfit(sliding)}")
    with convert.graph.made_by(name, "data"):
        data = {
            key: convert.quantity(entry, internal_states.dotted(name, key), sliding)
            for key, entry in element.quantities().items()
        }
        frames = {
            role: assembly.frame(model.place(f"force '{name}'", place, role), f"{name}.{role}")
            for role, place in element.frames().items()
        }
    return Force(name, element, data, frames, joints, *slots)


def _joints(assembly: Assembly, force: str, element: ForceElement) -> dict[str, int]:
    """Numbers of the joints an element acts on, by role; the rotor of a drive included."""
    numbers: dict[str, int] = {}
    for role, name in element.joints().items():
        if name not in assembly.joint_number:
            what = "is fixed" if name in assembly.model.joints else "does not exist"
            listed = near(name, assembly.joint_number).replace(" Known:", " Joints:")
            raise ModelError(f"force '{force}' ({element.kind}): joint '{name}' {what}.{listed}")
        numbers[role] = assembly.joint_number[name]
    if element.rotor() is not None:
        numbers["rotor"] = assembly.joint_number[f"{force}.rotor"]
    return numbers


def _constraint(scene: SceneRecord, convert: Converter, name: str) -> Named:
    entry = scene.constraints[name]
    with convert.graph.made_by(name, "constraint"):
        node = convert.scalar(entry.expression, f"constraint.{name}", entry.unit)
    if node == ZERO:
        raise ModelError(f"constraint '{name}' is 0 always; leave it out")
    nodes = convert.graph.nodes
    if not any(
        nodes[i][0] == "atom" or nodes[i][:2] in MOVING for i in live(convert.graph, [node])
    ):
        raise ModelError(
            f"constraint '{name}' contains no coordinate, speed or motion of a frame: nothing "
            "could keep it at 0. Take them from scene.q(...), scene.u(...) or frame.position()"
        )
    return Named(name, node, entry.unit)


def _output(scene: SceneRecord, convert: Converter, name: str) -> Named:
    entry = scene.outputs[name]
    with convert.graph.made_by(name, "output"):
        node = convert.scalar(entry.expression, f"output.{name}", entry.unit)
    return Named(name, node, entry.unit)
