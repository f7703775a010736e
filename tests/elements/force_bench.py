"""An instance of every force element, and frames and joints on which one acts."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import sympy

import cardan as cd
from cardan.elements.forces.force import Action, ForceElement, Load, Places
from cardan.ir.arithmetic import Scalar
from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.spatial.exponential import exp, tangent
from elements.written_of import converted
from spatial.numbers_of import block, numbers

# of a symmetric positive definite stiffness
_ROOT = np.random.default_rng(3).uniform(-1, 1, (6, 6))
COUPLED = _ROOT @ _ROOT.T + np.diag((2.0, 3.0, 4.0, 20.0, 30.0, 25.0))
# moment and force over the strain, farther than the strain of the bench
MEASURED = {
    "ry": cd.table([-2.0, -0.5, 0.0, 0.5, 2.0], [-9.0, -1.0, 0.0, 0.8, 7.0]),
    "z": cd.table([-2.0, -1.0, -0.2, 0.0, 0.2, 2.0], [-90.0, -9.0, -1.0, 0.0, 2.0, 60.0], "pchip"),
}
INSTANCES: dict[str, ForceElement] = {
    "force": cd.Force("A", (1.0, -2.0, 0.5)),
    "force in axes": cd.Force("A", (1.0, -2.0, 0.5), in_="B"),
    "line load": cd.LineLoad("blade", force=(1.0, 0.0, -2.0), moment=(0.0, 3.0, 0.0)),
    "torque": cd.Torque("A", (0.3, 0.0, -2.0)),
    "torque in axes": cd.Torque("A", (0.3, 0.0, -2.0), in_="B"),
    "spring": cd.SpringDamper("A", "B", stiffness=30.0, rest_length=0.4),
    "spring of no length": cd.SpringDamper("A", "B", stiffness=30.0),
    "damper": cd.SpringDamper("A", "B", damping=4.0),
    "spring and damper": cd.SpringDamper("A", "B", stiffness=30.0, damping=4.0, rest_length=0.4),
    "maxwell": cd.Maxwell("A", "B", stiffness=30.0, damping=4.0, rest_length=0.4),
    "bushing": cd.Bushing("A", "B", stiffness=(3.0, 4.0, 5.0, 30.0, 20.0, 10.0)),
    "coupled bushing": cd.Bushing(
        "A", "B", stiffness=COUPLED, rest=(0.1, 0.0, -0.2, 0.3, 0.1, 0.0)
    ),
    "bushing and damper": cd.Bushing("A", "B", stiffness=COUPLED, damping=0.05 * COUPLED),
    "damper in six directions": cd.Bushing("A", "B", damping=(0.3, 0.2, 0.1, 3.0, 4.0, 5.0)),
    "bushing of tables": cd.Bushing("A", "B", tables=MEASURED),
    "coupled bushing of tables": cd.Bushing(
        "A", "B", stiffness=COUPLED, rest=(0.1, 0.0, -0.2, 0.3, 0.1, 0.0), tables=MEASURED
    ),
    "bushing of branches": cd.Bushing(
        "A",
        "B",
        damping=(0.3, 0.2, 0.1, 3.0, 4.0, 5.0),
        branches=[((1.0, 0.0, 2.0, 0.0, 0.0, 9.0), 0.2)],
    ),
    "bushing of everything": cd.Bushing(
        "A",
        "B",
        stiffness=COUPLED,
        damping=0.05 * COUPLED,
        rest=(0.1, 0.0, -0.2, 0.3, 0.1, 0.0),
        tables=MEASURED,
        branches=[(0.5 * COUPLED, 0.2), ((0.0, 0.0, 2.0, 0.0, 7.0, 0.0), 3.0)],
    ),
    "flexible hinge": cd.FlexibleHinge("A", "B", (1, -2, 0.5), 0.5, 80.0, 90.0, 70.0),
    "damped flexible hinge": cd.FlexibleHinge("A", "B", "z", 0.5, 80.0, 90.0, 70.0, damping=0.1),
    "cable": cd.Cable("A", "B", EA=300.0, length=0.9),
    "damped cable": cd.Cable("A", "B", EA=300.0, length=0.9, damping=0.02),
    "slack cable": cd.Cable("A", "B", EA=300.0, length=9.0, damping=0.02),
    "torsion spring": cd.JointSpring("one", stiffness=7.0, rest=0.2),
    "torsion spring and damper": cd.JointSpring("one", stiffness=7.0, damping=0.3),
    "joint force": cd.JointForce("one", 3.0),
    "joint forces": cd.JointForce("two", (3.0, -1.0)),
    "damping": cd.JointDamper("two", 0.8),
    "rigid drive": cd.Drive("one", inertia=0.1, ratio=50.0, torque=0.6, friction=0.02),
    "gyroscopic drive": cd.Drive("one", inertia=0.1, ratio=-4.0, torque=0.6, gyroscopic=True),
    "elastic drive": cd.Drive(
        "one", inertia=0.1, ratio=20.0, torque=0.6, friction=0.02, stiffness=90.0, damping=1.5
    ),
    "dry friction": cd.Friction("one", 0.7, static=0.9, stribeck=0.1, viscous=0.2, against=0.3),
    "smooth friction": cd.Friction("one", 0.7, smooth=0.05),
    "actuator": cd.Actuator("one", command=2.0, lag=0.1, limit=1.5),
    "controller": cd.Controller("one", ("a",), (sympy.Symbol("a") * -2,), sympy.Symbol("a") * 3),
    "sampled controller": cd.Controller("one", force=2.0, sample=0.01),
    "stop": cd.Stop("one", lower=-9.0, upper=9.0),
    "lock": cd.Lock("one", when=1.0, strength=3.0),
    "contact with a plane": cd.Contact("B", "A", radius=1.5, stiffness=1e3, damping=0.1, mu=0.2),
    "contact of spheres": cd.Contact("A", "B", radius=1.0, stiffness=1e3, other_radius=0.9),
    "event": cd.Event(1.0),
    "driven rotor": cd.Rotor("B", inertia=0.2, torque=0.5, friction=0.1),
    "rotor of constant speed": cd.Rotor("B", inertia=0.2, speed=30.0),
    "rotor of constant momentum": cd.Rotor("B", axis=(1, -2, 0.5), momentum=6.0),
    "central gravity": cd.CentralGravity("A", 3.0, "B"),
    "gravity gradient": cd.GravityGradient("A", 3.0, "B"),
    "gravity gradient, torque alone": cd.GravityGradient("A", 3.0, "B", force=False),
    "flattened planet": cd.J2("A", 3.0, 0.1, 0.7, pole=(0.2, -0.5, 1.0), bodies="B"),
    "flattened planet, extended body": cd.J2("A", 3.0, 0.1, 0.7, bodies="B", gradient=True),
}
# of a body, where an element acts by mass
WEIGHT = {
    "mass": (1, 1, [2.0]),
    "com": (3, 1, [0.2, -0.1, 0.4]),
    "inertia": (3, 3, [0.9, 0.1, -0.2, 0.1, 1.3, 0.05, -0.2, 0.05, 0.8]),
}
BY_MASS = [name for name, element in INSTANCES.items() if element.masses() is not None]
FRAMES, JOINTS = {"A": 0, "B": 1}, {"one": 0, "two": 1, "rotor": 2}
# positions and rotation vectors of two frames, coordinates of three joints; then their rates
STATE = {
    "x0": [0.3, -0.2, 1.0],
    "x1": [-0.6, 0.4, 0.1],
    "r0": [0.0, 0.0, 0.0],
    "r1": [0.5, -0.4, 1.1],
    "q0": [0.7],
    "q1": [0.4, -1.2],
    "q2": [9.0],
}
RATES = {
    "x0": [0.5, 1.5, -0.3],
    "x1": [-1.1, 0.2, 0.9],
    "r0": [0.2, -0.1, 0.4],
    "r1": [0.3, 0.3, -0.7],
    "q0": [-1.3],
    "q1": [0.6, 0.9],
    "q2": [4.0],
}


class Moving:
    """Two frames and three joints whose states are input blocks."""

    def __init__(self) -> None:
        self.graph = Graph()

    def position(self, frame: int) -> Matrix:
        return block(self.graph, f"x{frame}", 3)

    def rotation(self, frame: int) -> Matrix:
        return exp(block(self.graph, f"r{frame}", 3))

    def velocity(self, frame: int) -> Matrix:
        return block(self.graph, f"v_x{frame}", 3)

    def angular_velocity(self, frame: int) -> Matrix:
        return tangent(block(self.graph, f"r{frame}", 3)).T @ block(self.graph, f"v_r{frame}", 3)

    def spin(self, frame: int) -> Matrix:
        return self.rotation(frame).T @ self.angular_velocity(frame)

    def arm(self, start: int, end: int) -> Matrix:
        return self.rotation(end).T @ (self.position(end) - self.position(start))

    def in_frame(self, x: Matrix, start: int, end: int) -> Matrix:
        return self.rotation(end).T @ (self.rotation(start) @ x)

    def q(self, joint: int) -> Matrix:
        return block(self.graph, f"q{joint}", len(STATE[f"q{joint}"]))

    def u(self, joint: int) -> Matrix:
        return block(self.graph, f"v_q{joint}", len(STATE[f"q{joint}"]))

    @property
    def time(self) -> Scalar:
        return block(self.graph, "t", 1)[0]


class Bench:
    """An element on the moving frames and joints."""

    def __init__(self, element: ForceElement) -> None:
        self.element, self.motion = element, Moving()
        self.data, self.parameters = converted(self.motion.graph, element.quantities())
        self.state = STATE | {f"v_{name}": rates for name, rates in RATES.items()}
        self.state |= {"z": [0.4] * len(element.internals()), "s": [0.0] * len(element.modes())}
        self.actions = self.act()

    def act(self) -> tuple[Action, ...]:
        frames = {role: FRAMES[name] for role, name in self.element.frames().items()}
        joints = {role: JOINTS[name] for role, name in self.element.joints().items()}
        joints |= {"rotor": JOINTS["rotor"]}
        for name in self.element.masses() or ():
            frames |= {"body": FRAMES[name]}
            for key, (rows, columns, entries) in WEIGHT.items():
                nodes = [self.motion.graph.const(x) for x in entries]
                self.data[key] = Matrix(self.motion.graph, rows, columns, nodes)
        z = block(self.motion.graph, "z", len(self.element.internals()))
        s = block(self.motion.graph, "s", len(self.element.modes()))
        at = Places(self.motion, self.data, frames, joints, z, s)
        return tuple(map(self.in_ground, self.element.act(at)))

    def in_ground(self, action: Action) -> Action:
        """The same with its loads in ground axes."""
        loads = []
        for load in action.loads:
            if load.axes:
                r = self.motion.rotation(load.axes)
                load = Load(load.frame, r @ load.torque, r @ load.force)
            loads.append(load)
        return replace(action, loads=tuple(loads))

    def value(self, x: Matrix | Scalar, kind: str = "mp", **values: Any) -> Any:
        return numbers(x, kind, **(self.parameters | self.state | values))

    def power(self, action: Action) -> Scalar:
        motion, graph = self.motion, self.motion.graph
        total = Scalar(graph, 0)
        for load in action.loads:
            total = total + load.force.dot(motion.velocity(load.frame))
            total = total + load.torque.dot(motion.angular_velocity(load.frame))
        for load in action.joint_loads:
            total = total + load.force.dot(motion.u(load.joint))
        return total
