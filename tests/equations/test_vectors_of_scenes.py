"""Vectors of scenes with beams, of closed loops and of joints that inputs drive."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import cardan as cd


def assert_equal(first: sp.Matrix, second: sp.Matrix) -> None:
    difference = sp.Matrix(first) - sp.Matrix(second)
    assert difference.applyfunc(sp.simplify) == sp.zeros(*difference.shape)


def rod() -> cd.Scene:
    """A beam on a slide and a crank, with a sensor."""
    scene = cd.Scene("rod", gravity=(0, 0, -9.81))
    slide, crank = scene.body("slide", mass=1.0), scene.body("crank", mass=2.0)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, slide)
    scene.joint("crank", cd.Revolute("y"), slide.at(0, 0, 0.1), crank)
    steel = cd.material(E=210e9, nu=0.3, rho=7850)
    start, section = crank.at(0.1, 0, 0), cd.section.tube(0.02, 0.002)
    beam = scene.beam("rod", start, (1.1, 0, 0.1), section, steel, elements=2)
    beam.at(0.5, name="middle")
    crank.at(0, 0, 0.2, rotation=("XYZ", 0, 0.3, 0), name="sensor")
    return scene


@pytest.mark.parametrize("coordinates", ["auto", "absolute"])
def test_bodies_and_nodes_beside_beams(coordinates: str) -> None:
    equations = cd.derive(rod(), coordinates=coordinates)
    model, vectors = cd.compile(equations), cd.vectors(equations)
    x = model.initial(q={"slide": 0.2, "crank": 0.3}, u={"slide": 0.4, "crank": -0.7})
    q, u = x[: model.nq], x[model.nq : model.nq + model.nu]
    udot = model.forward_dynamics(q, u)
    for name in ("sensor", "slide", "middle", "rod.end"):
        twist, rate = model.velocity(name, q, u), model.acceleration(name, q, u, udot)
        expected = {
            "position": model.pose(name, q)[:3, 3],
            "angular_velocity": twist[:3],
            "velocity": twist[3:],
            "angular_acceleration": rate[:3],
            "acceleration": rate[3:],
        }
        for quantity, value in expected.items():
            result = getattr(vectors, quantity)(name).evaluate(q, u, udot)
            # rows of constraints hold as far as the start is solved
            np.testing.assert_allclose(result, value, atol=1e-8 * max(1, np.abs(value).max()))
    phi, rate, slide, z = sp.symbols("crank crank.u slide.u sensor.position.z")
    expected = [slide + rate * z * sp.cos(phi), 0, -rate * z * sp.sin(phi)]
    assert_equal(vectors.velocity("sensor").express("slide"), expected)
    # nodes have no mass of their own, the beam is in no body
    assert {*vectors.augmented_bodies()} == {"slide", "crank"}
    assert vectors.augmented_bodies()["slide"].mass == sp.Symbol("slide.mass") + sp.Symbol(
        "crank.mass"
    )


def test_nodes_in_a_plane_are_refused() -> None:
    with pytest.raises(cd.DerivationError, match=r"'middle\.px'.*derive with plane=None"):
        cd.vectors(cd.derive(rod(), plane="y"))


def four_bar() -> cd.Scene:
    scene = cd.Scene("four_bar")
    crank, coupler = scene.body("crank", mass=1.0), scene.body("coupler", mass=1.0)
    rocker = scene.body("rocker", mass=1.0)
    scene.joint("A", cd.Revolute("z"), scene.ground, crank, q0=1.0)
    scene.joint("B", cd.Revolute("z"), crank.at(0.3, 0, 0), coupler, q0=-0.6)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.8, 0, 0), rocker, q0=1.5)
    scene.joint("C", cd.Revolute("z"), coupler.at(0.7, 0, 0), rocker.at(0.5, 0, 0), cut=True)
    coupler.at(0.2, 0.1, 0, name="point")
    coupler.at(0.7, 0, 0, name="near")
    rocker.at(0.5, 0, 0, name="far")
    return scene


def test_loops_that_are_cut() -> None:
    """Vectors over the tree: where the loop is closed both sides of the cut agree."""
    equations = cd.derive(four_bar())
    model, vectors = cd.compile(equations), cd.vectors(equations)
    x = model.simulate(0.1, q={"A": 1.0}, u={"A": 0.7}).x[0]
    q, u = x[: model.nq], x[model.nq : model.nq + model.nu]
    assert len(q) == 3
    udot = model.forward_dynamics(q, u)
    gap = vectors.position("near", wrt="far")
    assert gap.express() != sp.zeros(3, 1)
    for vector in (gap, gap.dt(), gap.dt().dt()):
        np.testing.assert_allclose(vector.evaluate(q, u, udot), 0, atol=1e-10)
    rate = model.acceleration("point", q, u, udot)[3:]
    np.testing.assert_allclose(vectors.acceleration("point").evaluate(q, u, udot), rate, rtol=1e-10)
    assert list(vectors.path_vectors("far")) == ["ground", "rocker"]


def test_joints_that_inputs_drive() -> None:
    """An input that prescribes a joint has value, rate and acceleration."""
    scene = cd.Scene("driven")
    turntable, slider = scene.body("turntable", mass=1.0), scene.body("slider", mass=1.0)
    turn = scene.input("angle", default=0.2)
    scene.joint("turn", cd.Revolute("z"), scene.ground, turntable, prescribed=turn)
    scene.joint("slide", cd.Prismatic("x"), turntable, slider, q0=0.5)
    equations = cd.derive(scene)
    vectors, model = cd.vectors(equations), cd.compile(equations)
    phi, rate, acceleration = (sp.Symbol(name) for name in equations.blocks["r"].entries)
    x, v, a = sp.symbols("slide slide.u slide.udot")
    radial = [a - x * rate**2, 2 * v * rate + x * acceleration, 0]
    assert_equal(vectors.acceleration("slider").express("turntable"), radial)
    assert_equal(vectors.position("slider").express(), [x * sp.cos(phi), x * sp.sin(phi), 0])
    r, q, u, udot = [0.3, -0.8, 1.7], [0.5], [0.2], [0.1]
    result = vectors.acceleration("slider").evaluate(q, u, udot, r=r)
    expected = model.acceleration("slider", q, u, udot, r=r)[3:]
    np.testing.assert_allclose(result, expected, rtol=1e-12)
    with pytest.raises(cd.DerivationError, match="input"):
        vectors.acceleration("slider").dt()


def test_loops_in_closed_form() -> None:
    equations = cd.derive(four_bar(), constraints="closed_form")
    vectors = cd.vectors(equations)
    q, u, udot, h = np.array([1.0]), np.array([0.7]), np.array([-0.4]), 1e-5

    def at(name: str, time: float) -> np.ndarray:
        state = (q + u * time + udot * time**2 / 2, u + udot * time, udot)
        return getattr(vectors, name)("point").evaluate(*state)

    for name, rate in (("position", "velocity"), ("velocity", "acceleration")):
        difference = (at(name, h) - at(name, -h)) / (2 * h)
        # truncation h^2, rounding 1e-16 / h
        np.testing.assert_allclose(at(rate, 0), difference, rtol=0, atol=1e-9)
