"""Linear models in speeds that the user chose, constraints and motion included.

Formulas by both routes and numbers against finite differences of equations reduced in joint speeds:
nothing of these knows a linear model, or that speeds were chosen. And against themselves: a speed
in other units changes the units of its rows and columns, and nothing else.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.equations.linearized.linear import ROUTES
from laws.cases import states
from laws.reduced import Array, Reduced, along, slope
from laws.test_chosen_speeds import NAMES, chosen
from mechanisms.closed_planar import four_bar, four_bar_angles

Speeds = dict[str, sp.Expr]
# differences of fourth order over steps of 1e-3, of a result that holds such differences itself
DIFFERENCES = 1e-7
ROUNDING = 1e-11


@dataclass(frozen=True)
class Case:
    """A scene and speeds chosen for it.

    Attributes:
        build: The scene and the chosen speeds, all of which depend on the position.
        q, w: The position, and the independent speeds with their values; others follow.
        increments: Speeds along which increments are independent.
        y: As many coordinates, that determine the position.
    """

    build: Callable[[], tuple[cd.Scene, Speeds]]
    q: dict[str, float]
    w: dict[str, float]
    increments: tuple[str, ...]
    y: tuple[str, ...]


def bob(rod: bool) -> tuple[cd.Scene, Speeds]:
    """A car with a mass above or below it, in speeds about the origin and away from it."""
    scene = cd.Scene("bob", gravity=(0, 0, -9.81))
    car, mass = scene.body("car", mass=0.3), scene.body("mass", mass=1.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, car)
    scene.joint("z", cd.Prismatic("z"), car, mass, q0=-0.8)
    x, z, ux, uz = scene.q("x"), scene.q("z"), scene.u("x"), scene.u("z")
    scene.force("drive", cd.JointForce("x", scene.input("push") - 0.4 * ux * x))
    if rod:
        scene.constraint("rod", (x**2 + z**2 - 0.64) / 1.6, unit="m")
    return scene, {"turn": (x * uz - z * ux) / 0.64, "radial": x * ux + z * uz}


def sleigh() -> tuple[cd.Scene, Speeds]:
    """A sleigh on a blade, in speeds along the blade and across it."""
    scene = cd.Scene("sleigh", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=2.0, com=(0.3, 0.05, 0), inertia=(0.1, 0.1, 0.4))
    scene.joint("ice", cd.Planar(), scene.ground, body)
    angle, ux, uy = scene.q("ice.angle"), scene.u("ice.x"), scene.u("ice.y")
    forward, across = (
        sp.cos(angle) * ux + sp.sin(angle) * uy,
        sp.cos(angle) * uy - sp.sin(angle) * ux,
    )
    scene.constraint("blade", across - 0.1 * scene.u("ice.angle"), unit="m/s")
    spring = -3.0 * scene.q("ice.x") - 0.2 * ux + scene.input("push") * sp.cos(angle)
    scene.force("spring", cd.JointForce("ice", [spring, 0, -0.7 * angle]))
    x = scene.q("ice.x")
    turn = scene.u("ice.angle") * (1 + 0.2 * x**2)
    return scene, {"across": across + 0.3 * x * forward, "forward": forward, "turn": turn}


def linkage() -> tuple[cd.Scene, Speeds]:
    """A four-bar linkage in mixtures of its joint speeds."""
    scene = four_bar()
    a, b, d = (scene.q(name) for name in "ABD")
    ua, ub, ud = (scene.u(name) for name in "ABD")
    scene.force("motor", cd.JointForce("A", scene.input("torque") - 0.01 * ua))
    return scene, {
        "crank": ua * (1.5 + sp.sin(b)),
        "sum": ua + ub + 0.3 * sp.cos(d) * ud,
        "rocker": ud - 0.5 * sp.sin(a) * ub,
    }


def ball(held: bool) -> tuple[cd.Scene, Speeds]:
    """A body on a ball joint in angular velocities about the axes of the ground."""
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.3, com=(0.1, -0.05, 0.3), inertia=(0.05, 0.04, 0.02))
    scene.joint("ball", cd.Spherical(), scene.ground, body)
    w, x, y, z = (scene.q(f"ball.q{c}") for c in "wxyz")
    u = sp.Matrix([scene.u(f"ball.{c}") for c in "xyz"])
    rotation = sp.Matrix([
        [w**2 + x**2 - y**2 - z**2, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w**2 - x**2 + y**2 - z**2, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w**2 - x**2 - y**2 + z**2],
    ])  # fmt: skip
    ground = rotation * u
    push = scene.input("torque")
    scene.force("motor", cd.JointForce("ball", [push, -0.1 * u[1], 0.2 * push]))
    if held:
        scene.constraint("held", ground[2] - 0.2 * ground[0], unit="rad/s")
    return scene, {f"w{c}": ground[k] for k, c in enumerate("xyz")}


ANGLES = four_bar_angles(0.7)
TURNED = dict(zip(("ball.qw", "ball.qx", "ball.qy", "ball.qz"), np.array([0.8, 0.2, -0.3, 0.4])
                  / np.linalg.norm([0.8, 0.2, -0.3, 0.4]), strict=True))  # fmt: skip
PLACE = {"x": 0.8 * np.sin(np.pi / 3), "z": -0.4}
CASES = {
    "point": Case(
        lambda: bob(False), PLACE, {"turn": 2.0, "radial": 0.3}, ("turn", "radial"), ("x", "z")
    ),
    "rod": Case(lambda: bob(True), PLACE, {"turn": 2.0}, ("turn",), ("x",)),
    "sleigh": Case(
        sleigh,
        {"ice.x": 0.4, "ice.y": -0.2, "ice.angle": 0.6},
        {"forward": 1.3, "turn": -0.8},
        ("across", "forward", "turn"),
        ("ice.x", "ice.y", "ice.angle"),
    ),
    "linkage": Case(linkage, {k: ANGLES[k] for k in "ABD"}, {"crank": 3.0}, ("crank",), ("A",)),
    "ball": Case(
        lambda: ball(False),
        TURNED,
        {"wx": 0.7, "wy": -0.4, "wz": 1.1},
        ("wx", "wy", "wz"),
        ("ball.qx", "ball.qy", "ball.qz"),
    ),
    "held ball": Case(
        lambda: ball(True),
        TURNED,
        {"wx": 0.7, "wy": -0.4},
        ("wx", "wy", "wz"),
        ("ball.qx", "ball.qy", "ball.qz"),
    ),
}


class InJointSpeeds(Reduced):
    """The chosen speeds as functions of the motion, which is reduced in joint speeds.

    States are coordinates y and independent chosen speeds w.
    """

    def __init__(self, case: Case) -> None:
        scene, speeds = case.build()
        equations = cd.derive(scene)
        q = np.array([case.q[name] for name in equations.coordinates])
        super().__init__(equations, case.y, [], q)
        self.case, self.names, self.q0 = case, list(speeds), q
        self.w = [self.names.index(name) for name in case.w]
        self.e = [self.names.index(name) for name in case.increments]
        places = [scene.q(name) for name in equations.coordinates]
        rates = [scene.u(name.replace(".u", "")) for name in equations.speeds]
        chosen_speeds, leaves = sp.Matrix(list(speeds.values())), [*places, *rates]
        matrix = chosen_speeds.jacobian(rates)
        self._matrix = sp.lambdify(leaves, matrix, "numpy")
        self._by_q = sp.lambdify(leaves, (matrix * sp.Matrix(rates)).jacobian(places), "numpy")

    def matrix(self, q: Array) -> Array:
        """Y (nu, nu): chosen speeds by joint speeds."""
        return np.asarray(self._matrix(*q, *self._nothing), dtype=float)

    def speeds(self, q: Array, w: Array) -> Array:
        G = self.jacobian(q)
        kept = np.concatenate([G, self.matrix(q)[self.w]])
        return np.linalg.lstsq(kept, np.concatenate([np.zeros(len(G)), w]), rcond=1e-10)[0]

    def rates(self, x: Array) -> Array:
        q = self.position(x[: len(self.y)])
        u = self.speeds(q, x[len(self.y) :])
        qdot = self.moves(q) @ u
        wdot = self._by_q(*q, *u) @ qdot + self.matrix(q) @ self.accelerations(q, u)
        return np.concatenate([qdot[self.y], np.asarray(wdot, dtype=float)[self.w]])

    def columns(self, q: Array) -> Array:
        """P (n, n): coordinates y by independent increments, which go along the chosen speeds."""
        held = self.jacobian(q)[: self.count]
        kept = np.concatenate([held, self.matrix(q)[self.e]])
        unit = np.eye(len(kept))[:, len(held) :]
        return (self.moves(q) @ np.linalg.lstsq(kept, unit, rcond=1e-10)[0])[self.y]

    @cached_property
    def matrices(self) -> tuple[Array, Array, Array]:
        """A, B, xdot: of states x told as distances P e of coordinates that move along."""
        n, w = len(self.y), np.array(list(self.case.w.values()))
        x = np.concatenate([self.q0[self.y], w])
        A, T, Tdot = slope(self.rates, x), np.eye(len(x)), np.zeros((len(x), len(x)))
        u = self.speeds(self.q0, w)
        T[:n, :n] = self.columns(self.q0)
        Tdot[:n, :n] = along(lambda h: self.columns(self.path(u, h)))
        B = [
            along(lambda h, e=e: self.driven(x, h * e))
            for e in np.eye(len(self.equations.system.inputs))
        ]
        back = np.linalg.inv(T)
        return back @ (A @ T - Tdot), back @ np.stack(B, axis=1), back @ self.rates(x)

    def path(self, u: Array, h: float) -> Array:
        """A position on the motion, to second order."""
        return self.moved(self.q0, h * u)

    def driven(self, x: Array, r: Array) -> Array:
        self.inputs["r"] = r
        found = self.rates(x)
        self.inputs.clear()
        return found


@cache
def expected(name: str) -> tuple[Array, Array, Array]:
    return InJointSpeeds(CASES[name]).matrices


def derived(name: str, scales: dict[str, float]) -> Any:
    scene, speeds = CASES[name].build()
    return cd.derive(scene, speeds={k: scales.get(k, 1.0) * x for k, x in speeds.items()})


def symbolic(name: str, scales: dict[str, float], route: str) -> Any:
    case = CASES[name]
    u = {k: scales.get(k, 1.0) * value for k, value in case.w.items()}
    return derived(name, scales).linearize(
        q=case.q, u=u, udot="free", route=route, independent=list(case.w)
    )


def names(case: Case) -> tuple[str, ...]:
    return (*(f"along {name}" for name in case.increments), *case.w)


def in_order(found: Any, case: Case) -> list[int]:
    """Places of the states of a case among those of a linear model."""
    return [found.states.index(name) for name in names(case)]


def alike(found: Array, wanted: Array, atol: float) -> None:
    size = np.abs(wanted).max(initial=1.0)
    np.testing.assert_allclose(found, wanted, rtol=0, atol=atol * size)


@pytest.mark.parametrize("name", CASES)
def test_formulas_are_slopes_of_the_reduced_equations(name: str) -> None:
    A, B, xdot = expected(name)
    for route in ROUTES:
        found = symbolic(name, {}, route)
        order, numbers = in_order(found, CASES[name]), found.at()
        alike(numbers["A"][np.ix_(order, order)], A, DIFFERENCES)
        alike(numbers["B"][order], B, DIFFERENCES)
        alike(numbers["xdot"][order, 0], xdot, DIFFERENCES)


@pytest.mark.parametrize("name", CASES)
def test_numbers_are_the_same(name: str) -> None:
    case = CASES[name]
    formulas = symbolic(name, {}, "from_start")
    model = cd.compile(derived(name, {}))
    slots = (
        [model.speeds.index(k) for k in case.increments],
        [model.speeds.index(k) for k in case.w],
    )
    choice = tuple(np.sort(x) for x in slots)
    found = model.linearize(q=case.q, u=case.w, choice=choice)
    assert found.states == formulas.states
    numbers = formulas.at()
    for letter in "ABCD":
        alike(getattr(found, letter), numbers[letter], ROUNDING)
    alike(found.xdot, numbers["xdot"][:, 0], ROUNDING)


@pytest.mark.parametrize("name", CASES)
def test_the_units_of_a_speed_change_its_rows_and_columns_alone(name: str) -> None:
    rng = np.random.default_rng(5)
    plain = symbolic(name, {}, "from_start")
    entries = derived(name, {}).speeds
    for route in ROUTES:
        scales = dict(zip(entries, rng.uniform(0.2, 5.0, len(entries)), strict=True))
        found = symbolic(name, scales, route)
        assert found.states == plain.states
        by = np.array([scales[state.removeprefix("along ")] for state in plain.states])
        before, after = plain.at(), found.at()
        alike(after["A"] * by / by[:, None], before["A"], ROUNDING)
        alike(after["B"] / by[:, None], before["B"], ROUNDING)


# such as need no minutes to compile in mixtures of speeds
TREES = [
    "double_pendulum",
    "gear",
    "parabola",
    "cylindrical",
    "universal",
    "point_on_plane",
    "planar",
]
TREES += [name for name in NAMES if name not in TREES and not name.startswith("backwards")]


@pytest.mark.parametrize(
    "name", [*TREES[:4], *(pytest.param(x, marks=pytest.mark.slow) for x in TREES[4:])]
)
def test_mixtures_of_speeds_of_trees(name: str) -> None:
    equations = chosen(name, "kane")
    q, u = (x[-1] for x in states(name))
    q = dict(zip(equations.coordinates, q.tolist(), strict=True))
    u = dict(zip(equations.speeds, (0.3 * u).tolist(), strict=True))
    found = cd.compile(equations).linearize(q=q, u=u, t=0.3)
    for route in ROUTES:
        formulas = equations.linearize(q=q, u=u, t=0.3, udot="free", route=route)
        assert formulas.states == found.states
        numbers = formulas.at()
        for letter in "AB":
            alike(numbers[letter], getattr(found, letter), 1e-9)
        alike(numbers["xdot"][:, 0], found.xdot, 1e-9)
