"""Analyses in absolute coordinates: equal to relative ones, and to closed forms of beams."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from mechanisms import ZOO
from mechanisms.closed import CLOSED

EI, EA, GA, MASS = 1e3, 1e7, 1e9, 1.0


@pytest.mark.parametrize("name", ["double_pendulum", "four_bar"])
def test_both_formulations_agree(name: str) -> None:
    build = (ZOO[name] if name in ZOO else CLOSED[name]).build
    absolute, relative = cd.compile(build(), coordinates="absolute"), cd.compile(build())
    joint = relative.coordinates[0]
    # next to 0 a four-bar has two positions equally near, and rests in both
    one, two = (model.equilibrium(q={joint: -1.0}) for model in (absolute, relative))
    assert one.stable is two.stable is True
    # angles of links are the same up to whole turns
    assert np.cos(one[joint] - two[joint]) == pytest.approx(1, abs=1e-12)
    np.testing.assert_allclose(
        absolute.modes(x=one).frequencies, relative.modes(x=two).frequencies, rtol=1e-8
    )
    values = [np.sort(m.linearize(e).eigenvalues.imag) for m, e in
              ((absolute, one), (relative, two))]  # fmt: skip
    np.testing.assert_allclose(values[0], values[1], rtol=1e-8)
    one, two = (m.equilibrium(q=e.q, locked={joint: float(e[joint]) + 0.3}) for m, e in
                ((absolute, one), (relative, two)))  # fmt: skip
    assert one.holding_forces[joint] == pytest.approx(two.holding_forces[joint], rel=1e-9)
    np.testing.assert_allclose(one.reaction(joint), two.reaction(joint), atol=1e-9)


@pytest.mark.parametrize("damping", [0.0, 20.0])
def test_feedback_of_a_quaternion_stiffens_a_node(damping: float) -> None:
    """J s^2 + c s + k / 2 = 0 of a body that floats and reads its own quaternion."""
    k, J = 30.0, 40.0
    scene = cd.Scene("craft", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=200, inertia=(30, J, 35))
    scene.joint("drift", cd.Free(), scene.ground, hub)
    torque = -k * scene.q("drift.qy") - damping * scene.u("drift.y")
    scene.force("wheel", cd.Torque(hub, (0, torque, 0), in_=hub))
    model = cd.compile(scene, coordinates="absolute")
    values = model.linearize(model.initial()).eigenvalues
    expected = np.roots([J, damping, k / 2])
    for root in expected:
        assert np.abs(values - root).min() < 1e-9 * abs(root)


def cantilever_scene(elements: int) -> cd.Scene:
    """A beam of 1 m along x, clamped at its start, with forces and a moment at its end."""
    scene = cd.Scene("cantilever", gravity=(0, 0, 0))
    F, M, P = (scene.parameter(name, 0.0) for name in "FMP")
    section = cd.section.general(EA=EA, GA=GA, GJ=EI, EI=EI, rhoA=MASS, rhoI=1e-6)
    beam = scene.beam("beam", scene.ground, (1.0, 0, 0), section, elements=elements)
    scene.force("load", cd.Force(beam.end, (-P, 0, -F)))
    scene.force("moment", cd.Torque(beam.end, (0, -M, 0)))
    return scene


def cantilever(elements: int) -> cd.CompiledModel:
    return cd.compile(cantilever_scene(elements))


@pytest.fixture(scope="module")
def beam() -> cd.CompiledModel:
    return cantilever(6)


def test_a_small_load_bends_as_linear_theory_says(beam: cd.CompiledModel) -> None:
    found = beam.equilibrium(parameters={"F": 0.1})
    tip = found.pose("beam.end")[:3, 3]
    # bending and shear; the square of the slope, 5e-5, is what linear theory leaves out
    assert -tip[2] == pytest.approx(0.1 / (3 * EI) + 0.1 / GA, rel=1e-8)
    assert found.stable is True


def test_a_moment_rolls_it_up(beam: cd.CompiledModel) -> None:
    path = beam.statics(M=(0, 2 * np.pi * EI))
    assert path.success
    angle = path["M"] / EI
    tips = path.pose("beam.end")[:, :3, 3]
    radius = 1 / np.maximum(angle, 1e-12)
    x = np.where(angle > 0, radius * np.sin(angle), 1.0)
    np.testing.assert_allclose(tips[:, 0], x, atol=1e-9)
    np.testing.assert_allclose(np.abs(tips[:, 2]), radius * (1 - np.cos(angle)), atol=1e-9)
    # all at once too: what is out of balance comes on little by little
    found = beam.equilibrium(parameters={"M": 2 * np.pi * EI})
    np.testing.assert_allclose(found.pose("beam.end")[:3, 3], 0, atol=1e-9)


def test_buckling(beam: cd.CompiledModel) -> None:
    critical = np.pi**2 * EI / 4
    with pytest.warns(cd.SolveWarning, match=r"unstable from a load between P = 246.* and P = 247"):
        path = beam.statics(P=(0, 1.2 * critical), steps=5)
    # in both planes at once; six elements of order four, and the strain of 2.5e-4
    (found,) = path.critical()
    assert found["P"] == pytest.approx(critical, rel=1e-3)
    assert path.n_negative.tolist() == [0 if found["P"] > P else 2 for P in path["P"]]


def test_modes_of_a_beam_and_under_load(beam: cd.CompiledModel) -> None:
    roots = np.array([1.8751040687, 4.6940911330])
    expected = roots**2 * np.sqrt(EI / MASS) / (2 * np.pi)
    free = beam.modes(4).frequencies
    # in pairs of planes; consistent masses of six elements
    np.testing.assert_allclose(free[::2], expected, rtol=1e-2)
    np.testing.assert_allclose(free[1::2], free[::2], rtol=1e-6)
    half = beam.equilibrium(parameters={"P": np.pi**2 * EI / 8})
    pressed = beam.modes(2, half).frequencies
    np.testing.assert_allclose(pressed, column_frequency(np.pi**2 * EI / 8), rtol=2e-3)


def column_frequency(P: float) -> float:
    """First frequency of a clamped column of 1 m under a dead load P, from Euler's equation."""

    def boundary(omega: float) -> float:
        root = np.sqrt(P**2 + 4 * EI * MASS * omega**2)
        a, b = np.sqrt((root + P) / (2 * EI)), np.sqrt((root - P) / (2 * EI))
        cos, sin, cosh, sinh = np.cos(a), np.sin(a), np.cosh(b), np.sinh(b)
        # w = c1 (cos ax - cosh bx) + c2 (b sin ax - a sinh bx): no moment, no force at the end
        moment = -(a**2) * cos - b**2 * cosh, -(a**2) * b * sin - a * b**2 * sinh
        slope = -a * sin - b * sinh, a * b * (cos - cosh)
        third = a**3 * sin - b**3 * sinh, -(a**3) * b * cos - a * b**3 * cosh
        force = [EI * t + P * s for t, s in zip(third, slope, strict=True)]
        return float(moment[0] * force[1] - moment[1] * force[0])

    from scipy.optimize import brentq

    return float(brentq(boundary, 5.0, 150.0)) / (2 * np.pi)


def test_many_elements_go_the_sparse_way() -> None:
    fine = cantilever(60)
    found = fine.equilibrium(parameters={"F": 0.1})
    assert -found.pose("beam.end")[2, 3] == pytest.approx(0.1 / (3 * EI) + 0.1 / GA, rel=1e-7)
    frequency = 1.8751040687**2 * np.sqrt(EI / MASS) / (2 * np.pi)
    np.testing.assert_allclose(fine.modes(2).frequencies, frequency, rtol=2e-4)


def test_a_hinge_that_nothing_holds_is_named() -> None:
    scene = cd.Scene("loose", gravity=(0, 0, -9.81))
    arm = scene.body("arm", mass=0.1, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("hinge", cd.Revolute("x"), scene.ground, arm)
    section = cd.section.general(EA=EA, GA=GA, GJ=EI, EI=EI, rhoA=MASS, rhoI=1e-6)
    beam = scene.beam("beam", arm, (1.0, 0, 0), section, elements=2)
    scene.force("twist", cd.Torque(beam.end, (scene.parameter("T", 1.0), 0, 0)))
    model = cd.compile(scene)
    with pytest.warns(cd.SolveWarning, match=r"nothing holds .*'hinge'"):
        found = model.equilibrium()
    assert not found.converged
    held = model.equilibrium(locked={"hinge": 0.0})
    # the moment turns with the end, which hangs by a slope of 1e-3
    assert held.holding_forces["hinge"] == pytest.approx(-1.0, rel=1e-5)


def test_what_cannot_be_held_is_told(beam: cd.CompiledModel) -> None:
    with pytest.raises(cd.ModelError, match="can be held"):
        beam.equilibrium(locked={"beam.end.qw": 1.0})


def test_formulas_that_beams_lack_name_the_numbers() -> None:
    equations = cd.derive(cantilever_scene(1))
    with pytest.raises(cd.DerivationError, match=r"no 'mass_matrix'.*In numbers: .*mass_matrix\("):
        _ = equations.mass_matrix
    with pytest.raises(cd.DerivationError, match=r"see \.kinds\.$"):
        _ = equations.bias
