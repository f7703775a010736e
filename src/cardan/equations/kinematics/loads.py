"""Loads of the force elements of a system on its bodies and joints."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from typing import TypeAlias

from ...elements.forces.force import Action, JointLoad, Load, Places
from ...errors import StructuralZero
from ...ir.arithmetic import Scalar
from ...ir.graph import ZERO
from ...ir.matrix import Matrix
from ...records import dataclass
from ...topology.system import Force
from .kinematics import Kinematics
from .paths import into_body

NOTHING: Mapping[str, Matrix] = {}
# body -> (torque, force), (3, 1) each, at its origin in its axes
Wrenches: TypeAlias = "dict[int, tuple[Matrix, Matrix]]"


@dataclass(frozen=True)
class Loads:
    """Applied forces of all elements.

    Attributes:
        wrenches: body -> (torque, force), (3, 1) each, at the body's origin in body axes.
        joints: joint -> generalized force along its speeds (nu of the joint, 1).
        potential: Potential energy of the elements (gravity is not among them).
        power: (element name, power) of every action without a potential.
        rotors: joint -> inertia added to its speeds (nu, nu of the joint).
        outside: Of the wrenches what no element makes.
        energies: (body, energy) of the potential, one by one: of the joint of an element, or of
            the body of its first frame that moves.
    """

    wrenches: Wrenches
    joints: dict[int, Matrix]
    potential: Scalar
    power: tuple[tuple[str, Scalar], ...]
    rotors: dict[int, Matrix]
    outside: Wrenches = field(default_factory=dict)
    energies: tuple[tuple[int, Scalar], ...] = ()

    def with_outside(self, more: Wrenches) -> Loads:
        """The same with wrenches that no element makes."""
        outside = merged(self.outside, more)
        return replace(self, wrenches=merged(self.wrenches, more), outside=outside)


def merged(one: Wrenches, other: Wrenches) -> Wrenches:
    """Sums of two sets of wrenches."""
    total = dict(one)
    for body, (torque, force) in other.items():
        if body in total:
            torque, force = total[body][0] + torque, total[body][1] + force
        total[body] = (torque, force)
    return total


def none(k: Kinematics) -> Loads:
    """No forces, but the inertia of the rotors."""
    return Loads({}, {}, Scalar(k.graph, ZERO), (), _rotors(k, k.system.forces, {}))


def without_potential(k: Kinematics, loads: Loads) -> Loads:
    """Loads of a system without those that have a potential."""
    without_stored = summed(k, k.system.forces, {}, counts=_spends)
    return replace(without_stored, wrenches=merged(without_stored.wrenches, loads.outside))


def applied(k: Kinematics, frames: set[int] | None = None) -> Loads:
    """All force elements, summed per body and joint.

    Args:
        frames: Frames whose loads count, those of the ground too; by default all that move.
    """
    return summed(k, k.system.forces, {}, frames)


def strained(k: Kinematics) -> tuple[Loads, Scalar]:
    """Forces of strain energies, and the energies of all elements that have one.

    Also of those that time or inputs change: the energy is that at the present time.
    """
    forces = [force for force in k.system.forces if force.element.strained]
    energies = (action.potential for force in forces for action in actions(k, force))
    total = sum((e for e in energies if e is not None), Scalar(k.graph, ZERO))
    return summed(k, forces, {}, counts=_strains), total


def _all(_: Action) -> bool:
    return True


def _strains(action: Action) -> bool:
    return action.potential is not None


def _spends(action: Action) -> bool:
    return action.stored is None


def summed(
    k: Kinematics,
    forces: Sequence[Force],
    overrides: Mapping[str, Matrix],
    frames: set[int] | None = None,
    counts: Callable[[Action], bool] = _all,
) -> Loads:
    """Some force elements, with given numbers in place of their own quantities.

    Args:
        k, forces, overrides: The motion, the elements, the numbers by name.
        frames: As of :func:`applied`.
        counts: True of an action whose loads count.
    """
    wrenches: Wrenches = {}
    joints: dict[int, Matrix] = {}
    potential = Scalar(k.graph, ZERO)
    power: dict[str, Scalar] = {}
    energies: list[tuple[int, Scalar]] = []
    for force in forces:
        kind = force.element.kind
        k.graph.describe(type(force.element), kind)
        with k.graph.made_by(force.name, kind):
            for action in actions(k, force, overrides):
                counted = counts(action)
                for load in action.loads if counted else ():
                    frame = k.system.frames[load.frame]
                    load.force.hint(force.name, f"force_on_{frame.name}")
                    load.torque.hint(force.name, f"torque_on_{frame.name}")
                    moves = frame.body >= 0
                    if moves if frames is None else load.frame in frames:
                        _add_wrench(k, wrenches, load)
                for joint_load in action.joint_loads if counted else ():
                    _add_joint(joints, joint_load)
                if action.stored is not None:
                    potential = potential + action.stored
                    energies.append((_home(k, force), action.stored))
                else:
                    before = power.get(force.name, Scalar(k.graph, ZERO))
                    power[force.name] = before + _power(k, action)
    rotors = _rotors(k, forces, overrides)
    return Loads(
        wrenches, joints, potential, tuple(power.items()), rotors, energies=tuple(energies)
    )


def _home(k: Kinematics, force: Force) -> int:
    """The body at which a recursion computes the energy of an element."""
    bodies = [*force.joints.values(), *(k.system.frames[f].body for f in force.frames.values())]
    return next((body for body in bodies if body >= 0), 0)


def _data(k: Kinematics, force: Force) -> dict[str, Matrix]:
    return {name: k.matrix(*entry) for name, entry in force.data.items()}


def places(k: Kinematics, force: Force) -> Places:
    """Attachments and states of an element."""
    element = force.element
    z = k.block("z", force.z, len(element.internals()))
    s = k.block("s", force.s, len(element.modes()))
    reaction_atom = (
        Scalar(k.graph, k.graph.atom(f"{force.name}.pressing")) if element.by_reaction else None
    )
    return Places(k, _data(k, force), force.frames, force.joints, z, s, reaction_atom)


def actions(
    k: Kinematics, force: Force, overrides: Mapping[str, Matrix] = NOTHING
) -> tuple[Action, ...]:
    """Everything that an element does, with given numbers in place of its own quantities."""
    at = places(k, force)
    try:
        return force.element.act(replace(at, data={**at.data, **overrides}))
    except StructuralZero as problem:
        raise StructuralZero(
            f"force '{force.name}': it divides by what is always zero, such as the distance of two "
            "points that coincide in every position; place its frames elsewhere"
        ) from problem


def _rotors(
    k: Kinematics, forces: Sequence[Force], overrides: Mapping[str, Matrix]
) -> dict[int, Matrix]:
    rotors: dict[int, Matrix] = {}
    for force in forces:
        with k.graph.made_by(force.name, "rotor"):
            data = {**_data(k, force), **overrides}
            for role, inertia in force.element.rotor_inertia(data).items():
                joint = force.joints[role]
                rotors[joint] = rotors[joint] + inertia if joint in rotors else inertia
    return rotors


def _add_wrench(k: Kinematics, wrenches: Wrenches, load: Load) -> None:
    """Carry a load to the origin and the axes of its body."""
    frame = k.system.frames[load.frame]
    force = into_body(k, load.force, load.axes, frame.body)
    torque = into_body(k, load.torque, load.axes, frame.body)
    torque = torque + k.place(load.frame).cross(force)
    if frame.body in wrenches:
        before = wrenches[frame.body]
        torque, force = before[0] + torque, before[1] + force
    wrenches[frame.body] = (torque, force)


def _add_joint(joints: dict[int, Matrix], load: JointLoad) -> None:
    before = joints.get(load.joint)
    joints[load.joint] = load.force if before is None else before + load.force


def _power(k: Kinematics, action: Action) -> Scalar:
    total = Scalar(k.graph, ZERO)
    for load in action.loads:
        velocity, omega = k.velocity(load.frame), k.angular_velocity(load.frame)
        if load.axes:
            velocity, omega = (k.in_frame(x, 0, load.axes) for x in (velocity, omega))
        total = total + load.force.dot(velocity) + load.torque.dot(omega)
    for joint_load in action.joint_loads:
        total = total + joint_load.force.dot(k.u(joint_load.joint))
    return total


def generalized(k: Kinematics, loads: Loads) -> Matrix:
    """Generalized force of the joint loads alone (nu, 1)."""
    nodes = [ZERO] * k.system.nu
    for i, force in loads.joints.items():
        for slot, node in along_speeds(k, i, force).items():
            nodes[slot] = k.graph.add(nodes[slot], node)
    return Matrix(k.graph, len(nodes), 1, nodes)


def along_speeds(k: Kinematics, joint: int, force: Matrix) -> dict[int, int]:
    """A force along the speeds of one joint as a generalized force of the system: slot -> node."""
    shares = k.shares(joint)
    if shares is None:
        first = k.system.joints[joint].u
        return {first + n: node for n, node in enumerate(force.nodes)}
    return {slot: share.dot(force).node for slot, share in shares.items()}
