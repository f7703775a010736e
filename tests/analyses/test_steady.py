"""Steady motions in absolute coordinates: equal to relative ones, closed forms, what they keep."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

import cardan as cd
from cardan.analyses.statics.static_problem import Point, Problem
from cardan.analyses.systems import dynamic_system_of

Array = NDArray[np.float64]
G = 9.81


# rigid scenes: joint coordinates have an independent derivation


def governor() -> cd.Scene:
    """An arm on a shaft, hinged beside its axis."""
    scene = cd.Scene("governor", gravity=(0, 0, -G))
    shaft = scene.body("shaft", mass=1.0, inertia=(0.1, 0.1, 0.1))
    arm = scene.body("arm", mass=1.0, com=(0, 0, -0.5), inertia=(0.01, 0.012, 0.005))
    scene.joint("spin", cd.Revolute("z"), scene.ground, shaft)
    scene.joint("arm", cd.Revolute("y"), shaft.at(0.1, 0, 0), arm, q0=0.5)
    return scene


def turntable() -> cd.Scene:
    """A mass on springs and dampers that turn with a table."""
    scene = cd.Scene("turntable", gravity=(0, 0, 0))
    table, slide, mass = (
        scene.body(name, mass=m, inertia=(0.1, 0.1, 0.1))
        for name, m in (("table", 1.0), ("slide", 0.2), ("mass", 1.0))
    )
    scene.joint("spin", cd.Revolute("z"), scene.ground, table)
    scene.joint("x", cd.Prismatic("x"), table.at(0.3, 0, 0), slide)
    scene.joint("y", cd.Prismatic("y"), slide, mass)
    for name in "xy":
        force = -100.0 * scene.q(name) - 0.5 * scene.u(name)
        scene.force(f"k{name}", cd.JointForce(name, force))
    return scene


def gyroscope() -> cd.Scene:
    """A wheel that spins on an arm that precesses: two speeds about two axes."""
    scene = cd.Scene("gyroscope", gravity=(0, 0, -G))
    shaft = scene.body("shaft", mass=1.0, inertia=(0.1, 0.1, 0.1))
    arm = scene.body("arm", mass=0.1, com=(0.1, 0, 0), inertia=(0.01, 0.02, 0.015))
    wheel = scene.body("wheel", mass=1.0, com=(0.3, 0, 0), inertia=(0.02, 0.01, 0.01))
    scene.joint("spin", cd.Revolute("z"), scene.ground, shaft)
    scene.joint("tilt", cd.Revolute("y"), shaft.at(0.05, 0, 0.2), arm, q0=0.2)
    scene.joint("wheel", cd.Revolute("x"), arm.at(0.1, 0, 0), wheel)
    return scene


def flyball() -> cd.Scene:
    """Watt's governor: two arms and a sleeve, closed loops that turn."""
    scene = cd.Scene("flyball", gravity=(0, 0, -G))
    shaft, sleeve = (scene.body(n, mass=1.0, inertia=(0.1, 0.1, 0.1)) for n in ("shaft", "sleeve"))
    scene.joint("spin", cd.Revolute("z"), scene.ground, shaft)
    scene.joint("slide", cd.Prismatic("z"), shaft, sleeve, q0=-0.7)
    for side in (1, -1):
        arm, rod = (
            scene.body(f"{name}{side}", mass=m, com=(0, 0, z), inertia=(0.02, 0.02, 0.001))
            for name, m, z in (("arm", 0.5, -0.5), ("rod", 0.2, -0.25))
        )
        near, hinge = 0.05 * side, cd.Revolute("y")
        scene.joint(f"a{side}", hinge, shaft.at(near, 0, 0), arm, q0=-0.8 * side)
        scene.joint(f"b{side}", hinge, arm.at(0, 0, -0.5), rod, q0=1.6 * side)
        scene.joint(f"c{side}", hinge, rod.at(0, 0, -0.5), sleeve.at(near, 0, 0))
    return scene


@pytest.mark.parametrize(
    ("build", "speeds", "hold"),
    [
        (governor, {"spin": 6.0}, {}),
        (turntable, {"spin": 3.0}, {"spin": 0.2}),
        pytest.param(gyroscope, {"spin": 9.0, "wheel": 100.0}, {}, marks=pytest.mark.slow),
        pytest.param(flyball, {"spin": 9.0}, {"spin": 0.0}, marks=pytest.mark.slow),
    ],
)
def test_both_formulations_agree_in_motion(
    build: Any, speeds: Mapping[str, float], hold: Mapping[str, float]
) -> None:
    found, values = [], []
    for coordinates in ("relative", "absolute"):
        model = cd.compile(build(), coordinates=coordinates)
        steady = model.equilibrium(u=speeds, locked=hold, check=True)
        linear = model.linearize(steady)
        assert linear.acceleration == 0
        found.append(steady)
        values.append(linear.eigenvalues)
    one, two = found
    assert one.stable is two.stable is True
    for name in one.model.coordinates:
        assert two[name] == pytest.approx(one[name], abs=1e-10)
    for name in hold:
        assert two.holding_forces[name] == pytest.approx(one.holding_forces[name], abs=1e-10)
    apart = np.abs(values[0][:, None] - values[1])
    pairs = linear_sum_assignment(apart)
    largest = np.abs(values[0]).max()
    # eigenvalues 0 are double, or fourfold: roots of rounding, of 1e-13 and smaller
    still = np.abs(values[0][pairs[0]]) < 1e-5 * largest
    assert apart[pairs][~still].max() < 1e-9 * largest
    assert apart[pairs][still].max(initial=0.0) < 1e-5 * largest


def sleeping_top() -> cd.Scene:
    """A top on its tip, which spins about the vertical."""
    scene = cd.Scene("top", gravity=(0, 0, -G))
    top = scene.body("top", mass=1.0, com=(0, 0, 0.3), inertia=(0.012, 0.012, 0.02))
    scene.joint("ball", cd.Spherical(), scene.ground, top)
    return scene


@pytest.mark.parametrize("coordinates", ["relative", "absolute"])
def test_a_sleeping_top_has_known_frequencies(coordinates: str) -> None:
    """Its axes turn along: the rates of its nutation and precession, less that of the spin."""
    model, spin = cd.compile(sleeping_top(), coordinates=coordinates), 60.0
    steady = model.equilibrium(u={"ball": [0, 0, spin]}, check=True)
    # I r^2 - I_p spin r + m g L = 0 about the tip
    rates = np.roots([0.012 + 0.3**2, -0.02 * spin, G * 0.3]) - spin
    found = np.sort(model.linearize(steady).eigenvalues.imag)[-2:]
    np.testing.assert_allclose(found, np.sort(np.abs(rates)), rtol=1e-9)
    np.testing.assert_allclose(model.modes(x=steady).angular[1:], found, rtol=1e-9)


def test_a_hinge_of_two_balls_that_are_close_to_each_other() -> None:
    """Rows that are nearly redundant hold all the same: frequencies are those with the hinge."""
    scene, apart = governor(), 0.005
    hinged = cd.compile(scene, coordinates="absolute")
    balls = cd.Scene("balls", gravity=(0, 0, -G))
    shaft = balls.body("shaft", mass=1.0, inertia=(0.1, 0.1, 0.1))
    arm = balls.body("arm", mass=1.0, com=(0, 0, -0.5), inertia=(0.01, 0.012, 0.005))
    balls.joint("spin", cd.Revolute("z"), balls.ground, shaft)
    balls.joint("arm", cd.Spherical(), shaft.at(0.1, 0, 0), arm)
    balls.joint("beside", cd.Spherical(), shaft.at(0.1, apart, 0), arm.at(0, apart, 0))
    both = []
    for model in (hinged, cd.compile(balls, coordinates="absolute")):
        steady = model.equilibrium(u={"spin": 3.0}, locked={"spin": 0.0}, check=True)
        both.append(np.sort_complex(model.linearize(steady).eigenvalues))
    np.testing.assert_allclose(both[1], both[0], atol=1e-7)


# beams

SECTION = cd.section.general(EA=1e4, GA=1e4, GJ=20, EI=(30, 50), rhoA=1, rhoI=(1e-3, 2e-3))


def rotor(elements: int = 2, ends: int = 2) -> cd.CompiledModel:
    """A hub with elastic blades that are swept up a little; weight across and along its axis."""
    scene = cd.Scene("rotor")
    across, along = scene.parameter("across", 0.0), scene.parameter("along", 0.0)
    scene.gravity = (0, -across, -along)
    hub = scene.body("hub", mass=1, inertia=(0.1, 0.1, 0.2))
    scene.joint("spin", cd.Revolute("z"), scene.ground, hub)
    for k in range(ends):
        c, s = np.cos(2 * np.pi * k / ends), np.sin(2 * np.pi * k / ends)
        start = hub.at(0.1 * c, 0.1 * s, 0)
        scene.beam(f"blade{k}", start, (1.1 * c, 1.1 * s, 0.1), SECTION, elements=elements)
    return cd.compile(scene)


@pytest.fixture(scope="module")
def blades() -> cd.CompiledModel:
    return rotor()


def test_a_steady_motion_stays_steady(blades: cd.CompiledModel) -> None:
    found = blades.equilibrium(u={"spin": 6.0})
    assert found.stable is True
    # accelerations from forces are those of what an observer sees at rest
    at = found.point.at
    udot = blades.forward_dynamics(found.q, found.u)
    np.testing.assert_allclose(udot, at.udot, atol=1e-9 * np.abs(at.udot).max())
    assert np.abs(at.udot).max() > 30
    # and a run goes on like that: half a turn without a vibration
    motion = blades.simulate([0, np.pi / 6], x0=found, method="DOP853", rtol=1e-11, atol=1e-12)
    begin, end = (blades.pose("blade0.end", q)[:3, 3] for q in motion.q[[0, -1]])
    np.testing.assert_allclose(end, [-begin[0], -begin[1], begin[2]], atol=1e-9)
    # blades bend down towards the plane of the hub and stretch
    assert 0.05 < begin[2] < 0.1
    assert np.hypot(*begin[:2]) > 1.1


def test_stiffness_is_that_of_speeds_that_follow(blades: cd.CompiledModel) -> None:
    system = dynamic_system_of(blades)
    problem = Problem(system)
    found = blades.equilibrium(u={"spin": 6.0}, locked={"spin": 0.0})
    K, G_ = problem.tangent(found.point, found.load)
    K, rows = K.toarray(), G_.toarray()
    rng = np.random.default_rng(1)
    direction = rng.normal(size=K.shape[0])

    def force(h: float) -> Array:
        at = replace(found.point.at, q=system.integrate(found.q, h * direction * system.columns))
        moved = problem.under(Point(at, found.point.reaction_forces), found.load)
        return problem.residual(moved, found.load)[0]

    h = 1e-4
    slope = (8 * (force(h) - force(-h)) - force(2 * h) + force(-2 * h)) / (12 * h)
    # fourth order: 1e-16 of derivatives; rounding of forces of 1e4
    np.testing.assert_allclose(K @ direction, slope, atol=1e-7 * np.abs(K).max())
    # on what joints allow it is symmetric: an observer sees a potential
    Z = np.linalg.svd(rows)[2][np.linalg.matrix_rank(rows) :].T
    inner = Z.T @ K @ Z
    np.testing.assert_allclose(inner, inner.T, atol=1e-9 * np.abs(inner).max())


@pytest.mark.parametrize("hold", [{}, {"spin": 0.0}])
def test_modes_are_those_of_the_linear_model(
    blades: cd.CompiledModel, hold: dict[str, float]
) -> None:
    found = blades.equilibrium(u={"spin": 6.0}, locked=hold)
    # sparse and quadratic, against accelerations differentiated in joint and node coordinates
    modes = blades.modes(8, found)
    linear = blades.linearize(found)
    assert linear.acceleration == 0
    expected = np.sort(linear.eigenvalues.imag[linear.eigenvalues.imag > 1])
    oscillating = modes.angular[modes.angular > 1]
    np.testing.assert_allclose(oscillating, expected[: len(oscillating)], rtol=1e-7)
    assert modes.rigid.sum() == (0 if hold else 1)
    np.testing.assert_allclose(modes.damping[modes.angular > 1], 0, atol=1e-7)


@pytest.mark.parametrize("speed", [0.0, 30.0, 120.0, 400.0])
def test_whirling_of_an_overhung_disk(speed: float) -> None:
    """Forward and backward whirl of a disk on a shaft without mass, seen from the shaft."""
    length, EI, GA, m, across, along = 0.5, 1e3, 1e9, 3.0, 0.025, 0.04
    scene = cd.Scene("overhung", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1, inertia=(0.1, 0.1, 0.1))
    disk = scene.body("disk", mass=m, inertia=(along, across, across), pose=(length, 0, 0))
    scene.joint("spin", cd.Revolute("x"), scene.ground, hub)
    section = cd.section.general(EA=1e8, GA=GA, GJ=2e3, EI=EI)
    scene.beam("shaft", hub, disk, section, elements=1)
    model = cd.compile(scene)
    steady = model.equilibrium(u={"spin": speed}, locked={"spin": 0.0})
    found = model.modes(x=steady)
    # complex displacement and tilt in ground axes: M z'' - i spin diag(0, along) z' + K z = 0
    give = np.array([[length**3 / 3, length**2 / 2], [length**2 / 2, length]]) / EI
    K = np.linalg.inv(give + np.diag([length / GA, 0]))
    inverse = np.diag([1 / m, 1 / across])
    first = np.block([[np.zeros((2, 2)), np.eye(2)],
                      [inverse @ K, inverse @ np.diag([0, along * speed])]])  # fmt: skip
    whirl = np.linalg.eigvals(first)
    forward, backward = (np.sort(np.abs(whirl[sign * whirl > 0])) for sign in (1, -1))
    if speed:
        assert np.all(forward > backward)
    seen = np.abs([*(forward - speed), *(backward + speed)])
    others = [np.sqrt(2e3 / length / along), np.sqrt(1e8 / length / m)]
    np.testing.assert_allclose(np.sort(found.angular), np.sort([*seen, *others]), rtol=1e-10)
    # beyond the first critical speed the disk is held by gyroscopic forces alone
    assert steady.stable is True
    assert steady.n_negative == (2 if speed > forward[0] else 0) + (2 if speed > forward[1] else 0)


@pytest.mark.slow
def test_nutation_of_a_free_body_with_stiff_booms() -> None:
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    bus = scene.body("bus", mass=2, inertia=(0.3, 0.35, 0.5))
    scene.joint("f", cd.Free(), scene.ground, bus)
    section = cd.section.general(EA=1e9, GA=1e9, GJ=1e9, EI=1e9, rhoA=0.3, rhoI=1e-3)
    for side in (1, -1):
        scene.beam(f"boom{side}", bus.at(0.2 * side, 0, 0), (1.2 * side, 0, 0), section, elements=2)
    model = cd.compile(scene)
    found = model.equilibrium(u={"f.u.z": 2.0})
    assert found.stable is True
    # two rods of 1 m from 0.2 m on, which has rotational inertia of 1e-3 about each axis across
    rods = 2 * (0.3 * (1.2**3 - 0.2**3) / 3 + 1e-3)
    A, B, C = 0.3 + 2 * 2e-3, 0.35 + rods, 0.5 + rods
    nutation = 2.0 * np.sqrt((C - A) * (C - B) / (A * B))
    values = np.abs(model.modes(6, found).values)
    print("nutation", nutation, values)
    assert np.abs(values - nutation).min() < 1e-6
    # drift across the axis, which an observer who turns along sees turn
    assert np.sum(np.abs(values - 2.0) < 1e-4) >= 2


@pytest.mark.slow
def test_many_elements_go_the_sparse_way() -> None:
    model = rotor(elements=40)
    found = model.equilibrium(u={"spin": 6.0})
    assert found.iterations < 8
    assert found.stable is True
    udot = model.forward_dynamics(found.q, found.u)
    np.testing.assert_allclose(udot, found.point.at.udot, atol=1e-6 * np.abs(udot).max())
    held = model.equilibrium(u={"spin": 6.0}, locked={"spin": 0.0})
    free, driven = (model.modes(6, x).angular for x in (found, held))
    coarse = rotor(elements=20)
    expected = coarse.modes(6, coarse.equilibrium(u={"spin": 6.0}, locked={"spin": 0.0})).angular
    np.testing.assert_allclose(driven, expected, rtol=1e-3)
    # a hub that may give way does not change what turns it not: of two blades that swing alike,
    # one motion of every pair
    assert np.abs(free[1:, None] - driven).min(axis=0).max() < 1e-8


@pytest.mark.slow
def test_in_a_plane() -> None:
    found = []
    for plane in ("z", None):
        scene = cd.Scene("blade", gravity=(0, 0, 0))
        hub = scene.body("hub", mass=1, inertia=(0.1, 0.1, 0.1))
        scene.joint("spin", cd.Revolute("z"), scene.ground, hub)
        section = cd.section.general(EA=1e4, GA=1e4, GJ=20, EI=(400, 50), rhoA=1, rhoI=1e-3)
        scene.beam("blade", hub.at(0.1, 0, 0), (1.1, 0, 0), section, elements=3)
        model = cd.compile(cd.derive(scene, coordinates="absolute", plane=plane))
        steady = model.equilibrium(u={"spin": 6.0}, locked={"spin": 0.0}, check=True)
        found.append(model.modes(8, steady).angular)
    lag, every = found
    np.testing.assert_allclose([np.abs(every - x).min() for x in lag[:2]], 0, atol=1e-7)


# what is not a steady motion


def test_weight_across_the_axis_is_told(blades: cd.CompiledModel) -> None:
    with pytest.warns(cd.SolveWarning, match="no steady motion: forces do not turn along"):
        found = blades.equilibrium(u={"spin": 6.0}, locked={"spin": 0.0}, parameters={"across": G})
    assert not found.converged
    # along the axis it does no harm
    assert blades.equilibrium(u={"spin": 6.0}, parameters={"along": G}, check=True).converged


def test_beams_about_two_axes_are_told() -> None:
    scene = cd.Scene("two", gravity=(0, 0, 0))
    for name, axis, x in (("a", "z", 0.0), ("b", "x", 3.0)):
        hub = scene.body(f"hub_{name}", mass=1, inertia=(0.1, 0.1, 0.1))
        scene.joint(f"spin_{name}", cd.Revolute(axis), scene.ground.at(x, 0, 0), hub)
        scene.beam(f"blade_{name}", hub, (x + 1, 0, 0), SECTION, elements=2)
    model = cd.compile(scene)
    words = "beams 'blade_a' and 'blade_b' do not turn together"
    with pytest.raises(cd.ModelError, match=words):
        model.equilibrium(u={"spin_a": 1.0, "spin_b": 1.0})
    with pytest.raises(cd.ModelError, match=words):
        model.equilibrium(u={"spin_a": 1.0})


def test_beams_without_nodes_of_their_own_stand() -> None:
    scene = cd.Scene("beside", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1, inertia=(0.1, 0.1, 0.1))
    scene.joint("spin", cd.Revolute("z"), scene.ground, hub)
    scene.beam("blade", hub, (1, 0, 0), SECTION, elements=2)
    scene.beam("bar", scene.ground.at(0, 0, 2), scene.ground.at(1, 0, 2), SECTION, elements=1)
    assert cd.compile(scene).equilibrium(u={"spin": 3.0}, check=True).converged


def test_speeds_that_contradict_are_told(blades: cd.CompiledModel) -> None:
    with pytest.raises(cd.ModelError, match=r"'spin', 'blade0.node1.u.z' are inconsistent"):
        blades.equilibrium(u={"spin": 6.0, "blade0.node1.u.z": 5.0})
    with pytest.raises(cd.ModelError, match="Did you mean 'spin'"):
        blades.equilibrium(u={"spine": 6.0})
