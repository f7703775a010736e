"""Forces of elements by name: along a line, along a joint, or the wrench on a frame.

Entries are ``<element>.force`` where the force is one number, else ``<element>.force.x`` and so on;
of an element on frames also ``<element>.moment.x``. An element that keeps its force as a state of
that name has none here.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from ...elements.forces.force import FRAME, JOINT, LINE
from ...elements.forces.line import direction
from ...ir.arithmetic import norm
from ...ir.function import Output
from ...ir.matrix import Matrix
from ...schema.entries import ForceRow
from ...topology.system import Force, System
from ..constraints.reaction_friction import friction_forces
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import actions, places
from .context import Context, recipe
from .dynamics import Dynamics

XYZ = ("x", "y", "z")


class NamedForce(NamedTuple):
    """An element whose force has a name.

    Attributes:
        number: In the forces of the system.
        name: Of the element; with that of the body where it acts on several, or on beams, by their
            mass.
        entries: (name, unit) of its numbers.
    """

    number: int
    name: str
    entries: tuple[tuple[str, str], ...]


def named_forces(system: System) -> Iterator[NamedForce]:
    """The elements whose forces have names, in the order of the system."""
    records = Counter(force.name for force in system.forces)
    records.update({one.force for segment in system.segments for one in segment.fields})
    for number, force in enumerate(system.forces):
        element = force.element
        states = [entry.name for entry in element.internals()]
        states += [mode.name for mode in element.modes()]
        if not element.acts_on()[0] or "force" in states:
            continue
        name = force.name
        if records[name] > 1:
            name = f"{name}.{system.frames[force.frames['body']].name}"
        yield NamedForce(number, name, tuple(_entries(system, force, name)))


def force_rows(system: System) -> list[ForceRow]:
    """The numbers of all elements as a manifest lists them."""
    return [
        ForceRow(element=one.name, name=name, unit=unit)
        for one in named_forces(system)
        for name, unit in one.entries
    ]


def _entries(system: System, force: Force, name: str) -> Iterator[tuple[str, str]]:
    what, role = force.element.acts_on()
    if what == LINE:
        yield f"{name}.force", "N"
    elif what == JOINT:
        speeds = system.joints[force.joints[role]].element.speeds
        for speed in speeds:
            entry = f"{name}.force.{speed.name}" if len(speeds) > 1 else f"{name}.force"
            yield entry, "N" if speed.unit == "m/s" else "N*m"
    else:
        for part, unit in (("force", "N"), ("moment", "N*m")):
            yield from ((f"{name}.{part}.{x}", unit) for x in XYZ)


def force_of(k: Kinematics, force: Force, multipliers: Matrix | None = None) -> Matrix:
    """The numbers of one element.

    Args:
        multipliers: Of the velocities that it holds in some modes.
    """
    what, role = force.element.acts_on()
    with k.graph.made_by(force.name, "force"):
        if what == JOINT:
            return _along_joint(k, force, force.joints[role], multipliers)
        frame, exerted = force.frames[role], actions(k, force)
        loads = [load for action in exerted for load in action.loads if load.frame == frame]
        total, moment = Matrix.zeros(k.graph, 3), Matrix.zeros(k.graph, 3)
        for load in loads:
            # axes of the ground are those of frame 0
            axes = load.axes
            total = total + (k.in_frame(load.force, axes, 0) if axes else load.force)
            moment = moment + (k.in_frame(load.torque, axes, 0) if axes else load.torque)
        if what == FRAME:
            return Matrix.vstack(total, moment)
        span = k.position(force.frames["b"]) - k.position(frame)
        along = direction(span, norm(*span))
        return Matrix.vector(k.graph, [along.dot(total)])


def _along_joint(k: Kinematics, force: Force, joint: int, multipliers: Matrix | None) -> Matrix:
    """Force along the speeds of a joint, with what holds it in some modes."""
    total = Matrix.zeros(k.graph, k.u(joint).rows)
    for action in actions(k, force):
        for load in action.joint_loads:
            if load.joint == joint:
                total = total + load.force
    if multipliers is not None:
        holds = force.element.holds(places(k, force))
        values = [one.active * lam for one, lam in zip(holds, multipliers, strict=True)]
        total = total + Matrix.vector(k.graph, [sum(values[1:], values[0])])
    return total


def _multipliers(d: Dynamics, force: Force) -> Matrix | None:
    """Multipliers of what an element holds under the forces of the scene and tau."""
    velocities = force.element.locked_velocities()
    if not velocities:
        return None
    _, lam = d.bound(d.tau)
    rows = [row.name for row in d.constraints.rows]
    nodes = [lam.nodes[rows.index(f"{force.name}.{name}")] for name, _ in velocities]
    return Matrix(d.k.graph, len(nodes), 1, nodes)


@recipe
def element_forces(c: Context) -> tuple[Output, ...]:
    system, nodes, entries = c.k.system, list[int](), list[tuple[str, str]]()
    if friction_forces(system):
        # what presses follows from the motion under tau
        c.d.forward(c.d.tau)
    for one in named_forces(system):
        force = system.forces[one.number]
        nodes += force_of(c.k, force, _multipliers(c.d, force)).nodes
        entries += one.entries
    names, units = ([entry[i] for entry in entries] for i in (0, 1))
    return (Output("element_forces", (len(nodes),), tuple(nodes), tuple(names), tuple(units)),)
