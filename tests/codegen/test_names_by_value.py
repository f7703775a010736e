"""Names in the generated C are judged by value: what a name says, found out on another way.

Bodies, joints and forces by Newton and Euler in NumPy over the flat scene, constraints by
differences of their rates, multipliers by one dense system of everything.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

import cardan as cd
from cardan import passes
from cardan.codegen.naming import ValueNames
from cardan.equations.constraints import rows as constraint_rows
from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from cardan.runtime.judged import motion_of, scene_of
from cardan.runtime.newton_euler import Moving, Scene, inverse_dynamics, mass_matrix, moving
from cardan.runtime.truth import truth_of
from cardan.runtime.verification.differences import REACH, central
from golden.scenes import EXAMPLES
from golden.scenes import scene_of as example
from table import each

Array = NDArray[np.float64]
Values = dict[tuple[str, str], float]
CELLS = [i + j for i in "xyz" for j in "xyz"]
STEP = 1e-3  # its eighth power is rounding
TOLERANCE = 1e-9
# example -> kinds of quantities that its names are judged by, at least
SCENES = {
    "01_double_pendulum": {"omega", "a", "M", "drive"},
    "02_robot_arm": {"omega", "alpha", "first_moment", "M", "drive"},
    "23_dual_spin": {"a", "drive", "udot"},
    "06_four_bar": {"G", "multiplier", "twist", "M", "udot"},
    "08_stewart_platform": {"G", "multiplier", "twist", "R", "origin_inertia"},
    "09_bicycle": {"G", "gamma", "multiplier", "twist", "R", "omega", "origin_inertia"},
    "10_rolling_disk": {"gamma", "multiplier", "R", "omega"},
    "07_andrews": {"G", "multiplier", "twist", "M", "drive"},
}


class Judge:
    """Independent values of the named quantities of a scene, at a random state."""

    def __init__(self, equations: cd.Equations) -> None:
        self.equations, self.system = equations, equations.system
        model = cd.compile(equations)
        self.scene: Scene = scene_of(model)
        truth = truth_of(model, self.scene, 1, 5)
        self.q, self.u = truth.q[0], truth.u[0]
        start = model._layout.start
        self.blocks = {
            "t": np.array([truth.t]),
            "q": self.q,
            "u": self.u,
            "r": truth.r[0],
            "p": model.parameters.vector,
            "tau": truth.tau[0],
            "z": start("z"),
            "s": start("s"),
        }
        motion = motion_of(model, truth.t, truth.r)
        self.motion = None if motion is None else np.asarray(motion).reshape(-1, 3)
        none = np.zeros(self.system.nu)
        self.moving: Moving = moving(self.scene, self.q, self.u, none, self.motion)
        h = inverse_dynamics(self.scene, self.q, self.u, none, self.motion)
        assert truth.f is not None
        self.drive = truth.tau[0] + truth.f[0] - h
        self.M = mass_matrix(self.scene, self.q, self.motion)

    def values(self) -> Values:
        """(owner, quantity) -> value."""
        found: Values = {}
        for name, value in (*self._bodies(), *self._joints(), *self._closing(), *self._balance()):
            found.setdefault(name, float(value))
        return found

    def _vector(self, owner: str, quantity: str, x: Array, axes: str = "xyz") -> Iterator[_Named]:
        for axis, value in zip(axes, x, strict=True):
            yield (owner, f"{quantity}_{axis}"), value

    def _tensor(self, owner: str, quantity: str, x: Array) -> Iterator[_Named]:
        for cell, value in zip(CELLS, x.reshape(-1), strict=True):
            yield (owner, f"{quantity}_{cell}"), value

    def _bodies(self) -> Iterator[_Named]:
        m, numbers = self.moving, self.scene.numbers
        for i, body in enumerate(self.system.bodies):
            back = m.turned[i + 1].T
            yield from self._vector(body.name, "omega", back @ m.omega[i + 1])
            yield from self._vector(body.name, "v", back @ m.velocity[i + 1])
            yield from self._vector(body.name, "alpha", back @ m.alpha[i + 1])
            yield from self._vector(body.name, "a", back @ m.accel[i + 1])
            yield (body.name, "whole_mass"), numbers["mass"][i]
            yield from self._vector(body.name, "first_moment", numbers["first_moment"][i])
            yield from self._tensor(body.name, "origin_inertia", numbers["inertia"][i])

    def _joints(self) -> Iterator[_Named]:
        m = self.moving
        for i, (body, joint) in enumerate(zip(self.system.bodies, self.system.joints, strict=True)):
            inner = m.turned[body.parent + 1].T
            yield from self._tensor(joint.name, "R", inner @ m.turned[i + 1])
            place = inner @ (m.place[i + 1] - m.place[body.parent + 1])
            yield from self._vector(joint.name, "p", place)

    def _frame(self, number: int) -> tuple[Array, Array, Array, Array]:
        """Rotation, origin, angular velocity and velocity of a frame, in ground axes."""
        frame, m = self.system.frames[number], self.moving
        outputs = (Output("R", (3, 3), frame.rotation), Output("p", (3,), frame.position))
        blocks = (Block("p", ("",) * len(self.blocks["p"]), ("",) * len(self.blocks["p"])),)
        given = evaluate(Function("frame", self.system.graph, blocks, outputs), self.blocks)
        R, p = np.reshape(given["R"], (3, 3)).astype(float), np.array(given["p"], dtype=float)
        k = frame.body + 1
        arm = m.turned[k] @ p
        omega = m.omega[k]
        velocity = m.velocity[k] + np.cross(omega, arm)
        return m.turned[k] @ R, m.place[k] + arm, omega, velocity

    def _closing(self) -> Iterator[_Named]:
        for cut in self.system.cuts:
            R_p, x_p, w_p, v_p = self._frame(cut.parent_frame)
            R_c, x_c, w_c, v_c = self._frame(cut.child_frame)
            yield from self._tensor(cut.name, "R", R_p.T @ R_c)
            yield from self._vector(cut.name, "p", R_p.T @ (x_c - x_p))
            sliding = v_c - v_p - np.cross(w_p, x_c - x_p)
            turning = w_c - w_p
            for letter, x in (("w", turning), ("v", sliding)):
                names = [f"{letter}{axis}" for axis in "xyz"]
                for name, value in zip(names, R_c.T @ x, strict=True):
                    yield (cut.name, f"twist_{name}"), value

    def _rates(self, t: float, q: Array, u: Array) -> Array:
        """Of the constraints."""
        function = self.equations.function("constraint_rates")
        given = self.blocks | {"t": np.array([t]), "q": q, "u": u}
        return np.array(next(iter(evaluate(function, given).values())), dtype=float)

    def _balance(self) -> Iterator[_Named]:
        speeds, nu = self.system.speed_names, self.system.nu
        for i in range(nu):
            for j in range(i + 1):
                yield ("M", f"{speeds[i]}_{speeds[j]}"), self.M[i, j]
        matrix, right, rows = self.M, self.drive, []
        if self.system.closed:
            rows = [(row.owner, row.component) for row in constraint_rows(self.system)]
            t, none = float(self.blocks["t"][0]), np.zeros(nu)
            rest = self._rates(t, self.q, none)
            G = np.array([self._rates(t, self.q, e) - rest for e in np.eye(nu)]).T
            # gamma is what the rates lose where speeds stay
            qdot = np.array(evaluate(self.equations.function("qdot"), self.blocks)["qdot"], float)
            steps = STEP * np.concatenate([REACH, -REACH])
            later = [self._rates(t + h, self.q + h * qdot, self.u) for h in steps]
            gamma = -central(*np.split(np.array(later), 2)) / STEP
            for k, (owner, component) in enumerate(rows):
                suffix = f"_{component}" if component else ""
                yield (owner, f"gamma{suffix}"), gamma[k]
                for speed, value in zip(speeds, G[k], strict=True):
                    yield (owner, f"G{suffix}_{speed}"), value
            matrix = np.block([[self.M, -G.T], [G, np.zeros((len(rows), len(rows)))]])
            right = np.concatenate([self.drive, gamma])
        solution = np.linalg.lstsq(matrix, right, rcond=1e-12)[0]
        for k, (owner, component) in enumerate(rows):
            yield (
                (owner, f"multiplier_{component}" if component else "multiplier"),
                solution[nu + k],
            )
        for joint in self.system.joints:
            for k, speed in enumerate(joint.element.speeds if joint.u >= 0 else ()):
                suffix = f"_{speed.name}" if speed.name else ""
                yield (joint.name, f"udot{suffix}"), solution[joint.u + k]
                yield (joint.name, f"drive{suffix}"), self.drive[joint.u + k]


_Named = tuple[tuple[str, str], float]


def named(judge: Judge) -> dict[tuple[str, str], float]:
    """Values of everything that has a label or a hint in forward dynamics, as it is written."""
    function = passes.optimize(judge.equations.function("forward_dynamics")).function
    graph, live = function.graph, set(function.live())
    names = [(i, n) for table in (graph.labels, graph.hints) for i, n in table.items() if i in live]
    output = Output("x", (len(names),), tuple(i for i, _ in names))
    whole = Function("names", graph, function.inputs, (output,))
    values = evaluate(whole, judge.blocks)["x"]
    return {name: float(x) for (_, name), x in zip(reversed(names), reversed(values), strict=True)}


@each("name", SCENES)
def test_names_say_what_they_hold(name: str) -> None:
    path = next(path for path in EXAMPLES if path.stem == name)
    judge = Judge(cd.derive(example(path), rewrites=()))
    truth, judged, wrong = judge.values(), set(), []
    for (owner, quantity), value in named(judge).items():
        minus = quantity.startswith("minus_")
        key = (owner, quantity.removeprefix("minus_"))
        if key not in truth:
            continue
        expected = -truth[key] if minus else truth[key]
        judged.add(key[1].split("_")[0] if key[0] != "M" else "M")
        if abs(value - expected) > TOLERANCE * max(1.0, abs(expected)) * 10:
            wrong.append((owner, quantity, value, expected))
    assert not wrong
    kinds = {kind.split("_")[0] for kind in SCENES[name]}
    assert kinds <= judged


def test_names_are_made_of_what_values_are_made_of() -> None:
    g = Graph()
    x, y, z = (g.var("q", k) for k in range(3))
    block = Block("q", ("arm.x", "arm.y", "lean"), ("",) * 3)
    sums, products = g.add(x, y), g.mul(x, z)
    said = {
        g.mul(x, y): "arm_x_times_y",
        products: "arm_x_times_lean",
        g.square(z): "lean_squared",
        g.square(sums): "sum_arm_x_plus_y_squared",
        g.div(x, products): "arm_x_per_product_arm_x_times_lean",
        g.sub(z, sums): "lean_minus_sum_arm_x_plus_y",
        g.apply("cos", z): "lean_cos",
        g.apply("sin", sums): "sin_of_arm_x_plus_y",
        g.mul(g.const(0.5), sums): "half_sum_arm_x_plus_y",
        g.add(z, g.const(0.75)): "lean_plus_c0p75",
    }
    function = Function("f", g, (block,), (Output("y", (len(said),), tuple(said)),))
    entries = dict(zip((x, y, z), block.entries, strict=True))
    names = ValueNames(
        function,
        function.live(),
        lambda i: (entries[i].replace(".", "_"), entries[i].partition(".")[0]),
    )
    assert {i: names.of(i) for i in said} == said
