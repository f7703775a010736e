"""What beams carry, against statics: forces, moments, strains and stresses along them."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd

LENGTH, LOAD, PULL, E = 2.0, 0.1, 0.03, 2.1e11


def bracket(**more: object) -> cd.CompiledModel:
    """A beam along x with a node in the middle, loaded there and at its end."""
    scene = cd.Scene("bracket", gravity=(0, 0, 0))
    F, P, M = (scene.parameter(name, 0.0) for name in "FPM")
    section, steel = cd.section.rectangle(0.02, 0.03), cd.material(E=E, nu=0.3, rho=7850)
    beam = scene.beam("rod", scene.ground, (LENGTH, 0, 0), section, steel, elements=4, **more)
    scene.force("middle", cd.Force(beam.at(0.5), (0, 0, F)))
    scene.force("end", cd.Force(beam.end, (P, 0, 0)))
    scene.force("turn", cd.Torque(beam.end, (M, 0, 0)))
    return cd.compile(scene)


@pytest.fixture(scope="module")
def model() -> cd.CompiledModel:
    return bracket()


def test_small_loads_as_in_linear_theory(model: cd.CompiledModel) -> None:
    found = model.equilibrium(parameters={"F": LOAD, "P": PULL, "M": 0.005})
    beam = model.beam("rod", found.q)
    s = np.array([0, 0.5, 0.5, 1, 1, 1.5, 1.5, 2])
    np.testing.assert_allclose(beam.s, s, atol=1e-12)
    before = np.repeat([1.0, 0.0], 4)
    np.testing.assert_allclose(beam.force[:, 0], PULL, rtol=1e-4)
    np.testing.assert_allclose(beam.force[:, 2], LOAD * before, atol=1e-5)
    np.testing.assert_allclose(beam.moment[:, 0], 0.005, rtol=1e-4)
    # of what lies ahead: a force upward turns about -y
    np.testing.assert_allclose(beam.moment[:, 1], -LOAD * before * (1 - s), atol=1e-5)
    A, EI2 = 0.02 * 0.03, E * 0.02 * 0.03**3 / 12
    np.testing.assert_allclose(beam.strain[:, 0], beam.force[:, 0] / (E * A), rtol=1e-9)
    np.testing.assert_allclose(beam.curvature[:, 1], beam.moment[:, 1] / EI2, rtol=1e-9, atol=1e-12)
    # bent upward, the lower side is stretched
    lower = beam.normal_stress(0.0, -0.015)
    assert lower[0] == pytest.approx(PULL / A + LOAD * 0.015 * E / EI2, rel=1e-3)
    assert beam.extreme[0] == pytest.approx(lower[0], rel=1e-3)


def test_the_clamp_carries_what_the_first_section_does(model: cd.CompiledModel) -> None:
    # stress varies linearly along an element: it is that of its ends up to how far it bends
    found = model.equilibrium(parameters={"F": 200.0})
    beam = model.beam("rod", found.q)
    arm = found.pose("rod.at1")[0, 3]
    np.testing.assert_allclose(beam.force[0], [0, 0, 200], atol=0.2)
    np.testing.assert_allclose(beam.moment[0], [0, -200 * arm, 0], atol=0.2)
    assert "4 elements" in repr(beam)


def test_along_a_motion() -> None:
    model = bracket(element="classical")
    motion = model.simulate(np.linspace(0, 0.01, 3), method=cd.GeneralizedAlpha(0.8), step=1e-3)
    assert model.beam("rod", motion.q).force.shape == (3, 8, 3)
    np.testing.assert_allclose(motion.beam("rod").force, 0, atol=1e-6)


def test_what_is_missing_is_named(model: cd.CompiledModel) -> None:
    with pytest.raises(cd.ModelError, match=r"no beam 'rdo'.*Did you mean 'rod'"):
        model.beam("rdo", model.initial()[: model.nq])
    with pytest.raises(cd.ArgumentError, match=r"q has shape \(3,\)"):
        model.beam("rod", np.zeros(3))
    scene = cd.Scene("plain")
    section = cd.section.general(EA=1e6, GA=1e6, GJ=1, EI=1, rhoA=1)
    scene.beam("rod", scene.ground, (1, 0, 0), section, elements=1)
    model = cd.compile(scene)
    with pytest.raises(cd.ModelError, match="without material and shape"):
        _ = model.beam("rod", model.initial()[: model.nq]).extreme
