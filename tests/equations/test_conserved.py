"""Conserved quantities: those of the books, on motions, and none where there is none."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from cardan.equations.reading.conserved import Quantity
from cardan.ir.interpreter import evaluate
from equations.classical import CLASSICAL
from laws.cases import derived
from mechanisms import ZOO
from spread import some

S = sp.Symbol
PLANE = {"linear momentum along x", "linear momentum along y", "angular momentum about z"}
EVERY = {
    *(f"linear momentum along {x}" for x in "xyz"),
    *(f"angular momentum about {x}" for x in "xyz"),
}
ABOUT = {f"angular momentum about {x} through the center of mass" for x in "xyz"}


def test_the_top_keeps_what_the_books_say() -> None:
    found = cd.derive(CLASSICAL["top"].scene()).conserved()
    I1, I3, m, g, l = sp.symbols("I1 I3 m g l")
    theta, p, n, s = S("theta"), S("phi.u"), S("theta.u"), S("psi.u")
    spin = I3 * (s + p * sp.cos(theta))
    # Goldstein, Classical Mechanics, section 5.7
    assert sp.simplify(found["momentum of psi"].expression - spin) == 0
    phi = I1 * p * sp.sin(theta) ** 2 + spin * sp.cos(theta)
    assert sp.simplify(found["momentum of phi"].expression - phi) == 0
    energy = I1 * (n**2 + p**2 * sp.sin(theta) ** 2) / 2 + spin**2 / (2 * I3)
    energy += m * g * l * sp.cos(theta)
    assert sp.simplify(found["energy"].expression - energy) == 0
    assert len(found.quantities) == 3
    assert found.cyclic == ("phi", "psi")
    assert all(one.condition == "" for one in found.quantities)


def test_cart_and_gyroscope() -> None:
    cart = cd.derive(CLASSICAL["cart"].scene()).conserved()
    assert cart.names == ("linear momentum along x", "energy")
    assert cart["linear momentum along x"].also == ("momentum of x",)
    gyroscope = cd.derive(CLASSICAL["gyroscope"].scene()).conserved()
    assert {"momentum of gamma", "energy"} < set(gyroscope.names)
    assert "momentum of alpha" in gyroscope["angular momentum about z"].also


def free(gravity: tuple[float, float, float], inertia: tuple[float, float, float]) -> cd.Scene:
    scene = cd.Scene("free", gravity=gravity)
    body = scene.body("body", mass=2.0, com=(0.1, 0.2, 0.3), inertia=inertia)
    scene.joint("free", cd.Free(), scene.ground, body)
    return scene


def test_free_and_thrown_bodies() -> None:
    body = (1.0, 2.0, 2.5)
    assert set(cd.derive(free((0, 0, 0), body)).conserved().names) == EVERY | {"energy"}
    thrown = cd.derive(free((0, 0, -9.81), body)).conserved()
    assert set(thrown.names) == PLANE | ABOUT | {"energy"}
    # down a slope: the direction across gravity is a combination, and belongs to these numbers
    slope = cd.derive(free((3.0, 0, -9.0), body)).conserved()
    across = slope["linear momentum along (1, 0, 0.333333)"]
    assert across.condition == "at these parameters"
    assert "linear momentum along y" in slope.names


def test_spin_of_a_body_of_revolution() -> None:
    scene = cd.Scene("spinning", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, com=(0, 0, 0.3), inertia=(0.2, 0.2, 0.05))
    scene.joint("tip", cd.Spherical(), scene.ground, body)
    found = cd.derive(scene).conserved()
    assert found["momentum of tip.z"].condition == "at these parameters"
    assert found["angular momentum about z"].condition == ""


def test_inputs_and_dampers_say_who() -> None:
    scene = cd.Scene("pushed")
    cart = scene.body("cart", mass=2.0)
    scene.joint("track", cd.Prismatic("x"), scene.ground, cart)
    scene.force("motor", cd.JointForce("track", scene.input("push")))
    found = cd.derive(scene).conserved()
    assert {one.condition for one in found.quantities} == {"while the inputs rest"}
    scene.force("brake", cd.JointForce("track", -0.5 * scene.u("track")))
    found = cd.derive(scene).conserved()
    assert found.names == ()
    assert found.powers == {"brake": "takes"}
    assert "'brake' takes energy" in str(found)


def test_rolling_keeps_energy_but_no_momentum() -> None:
    scene = cd.Scene("coin", gravity=(0, 0, -9.81))
    coin = scene.body("coin", mass=1.0, inertia=(0.0025, 0.005, 0.0025))
    scene.joint("rolling", cd.RollingDisk(0.1), scene.ground, coin)
    found = cd.derive(scene).conserved()
    assert found.names == ("energy",)
    # nothing depends on where it is, and yet the ground pushes
    assert {"rolling.x", "rolling.y"} <= set(found.cyclic)


@pytest.mark.parametrize("name", some(ZOO, 4, 1))
def test_energy_is_kept_where_the_zoo_says_so(name: str) -> None:
    found = derived(name).conserved()
    assert found.count > 0
    assert ("energy" in found.names) == ZOO[name].conservative
    assert found.residual < 1e-10


def _along(one: Quantity, motion: cd.Trajectory, model: cd.CompiledModel) -> np.ndarray:
    given = {
        "t": motion.t[:, None],
        "q": motion.q,
        "u": motion.u,
        "p": np.array(list(model.parameters.values())),
        "r": np.zeros(len(model.inputs)),
    }
    return np.asarray(evaluate(one.function, given, "numpy")["value"])[:, 0, 0]


def _tree() -> cd.Scene:
    """Two bodies on a floating third one."""
    scene = free((0, 0, -9.81), (1.0, 2.0, 2.5))
    inner = scene.bodies["body"]
    for k, axis in enumerate("xy"):
        arm = scene.body(f"arm{k}", mass=0.5, com=(0.2, 0.1, -0.3), inertia=(0.1, 0.2, 0.2))
        scene.joint(f"hinge{k}", cd.Revolute(axis), inner.at(0.4, 0.1 * k, 0), arm)
    return scene


@pytest.mark.parametrize("build", [CLASSICAL["top"].scene, _tree], ids=["top", "tree"])
def test_constant_along_motions(build: Callable[[], cd.Scene]) -> None:
    equations = cd.derive(build())
    model = cd.compile(equations)
    start = model.random_state(np.random.default_rng(2))
    motion = model.simulate(1.0, x0=start, rtol=1e-11, atol=1e-12)
    found = equations.conserved()
    assert len(found.quantities) >= 3
    for one in found.quantities:
        values = _along(one, motion, model)
        assert np.ptp(values) < 1e-7 * (1.0 + np.abs(values).max()), one.name
    # and the machine that measures can see a change
    other = model.momentum(motion.q, motion.u)
    assert np.ptp(other[:, 5]) > 1e-3 or np.ptp(other[:, 0]) > 1e-3


def test_a_small_pendulum_depends_on_its_angle() -> None:
    scene = cd.Scene("watch", gravity=(0, 0, -9.81))
    scene.joint("pin", cd.Revolute("y"), scene.ground, scene.body("a", 1e-9, com=(0, 0, -1e-4)))
    found = cd.derive(scene).conserved()
    assert found.cyclic == ()
    assert found.names == ("energy",)


def test_a_small_circuit_keeps_its_energy() -> None:
    size, mass = 1e-4, 1e-9
    inertia = (0.1 * mass * size**2,) * 3
    scene = cd.Scene("switch", gravity=(0, 0, -9.81))
    a, c = (scene.body(n, mass, com=(0, 0, -size / 2), inertia=inertia) for n in "ac")
    b = scene.body("b", mass, com=(size / 2, 0, 0), inertia=inertia)
    scene.joint("A", cd.Revolute("y"), scene.ground, a)
    scene.joint("B", cd.Revolute("y"), a.at(0, 0, -size), b)
    scene.joint("D", cd.Revolute("y"), scene.ground.at(size, 0, 0), c)
    scene.joint("C", cd.Revolute("y"), b.at(size, 0, 0), c.at(0, 0, -size), cut=True)
    found = cd.derive(scene).conserved()
    assert found.names == ("energy",)


def test_bodies_hard_to_shift_and_easy_to_turn_keep_no_more_than_others() -> None:
    scene = cd.Scene("dense", gravity=(0, 0, 0))
    ball = scene.body("ball", mass=1e3, inertia=(1e-11, 2e-11, 2.5e-11))
    scene.joint("free", cd.Free(), scene.ground, ball)
    found = cd.derive(scene).conserved()
    assert set(found.names) == {*EVERY, "energy"}


def test_a_light_pendulum_on_a_heavy_cart_depends_on_its_angle() -> None:
    scene = cd.Scene("cart", gravity=(0, 0, -9.81))
    cart = scene.body("cart", mass=1e3)
    bob = scene.body("bob", mass=1e-9, com=(0, 0, -1e-3))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("pin", cd.Revolute("y"), cart, bob)
    assert cd.derive(scene).conserved().cyclic == ("rail",)
