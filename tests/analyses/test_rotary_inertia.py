"""Rotary inertia of sections as the user chooses it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd

WIDTH, HEIGHT, RHO, E = 0.02, 0.04, 7800.0, 2e11


def cantilever(section: Any, material: Any, elements: int = 12) -> cd.Scene:
    scene = cd.Scene("cantilever", gravity=(0, 0, 0))
    scene.beam("beam", scene.ground, (0.5, 0, 0), section, material, elements=elements)
    return scene


def frequencies(section: Any, material: Any = None, **options: Any) -> Any:
    model = cd.compile(cantilever(section, material), coordinates="absolute", **options)
    return model.modes(4).frequencies


def steel() -> Any:
    return cd.material(E=E, nu=0.3, rho=RHO)


def test_a_shape_with_the_inertia_of_another() -> None:
    """The same numbers, given as a shape with rhoI and as a general section."""
    I2, I3 = WIDTH * HEIGHT**3 / 12, HEIGHT * WIDTH**3 / 12
    plain = cd.section.rectangle(WIDTH, HEIGHT)
    assert np.allclose(
        frequencies(cd.section.rectangle(WIDTH, HEIGHT, rhoI=(RHO * I2, RHO * I3)), steel()),
        frequencies(plain, steel()),
        rtol=1e-10,
    )
    heavy = cd.section.rectangle(WIDTH, HEIGHT, rhoI=0.02)
    slower = frequencies(heavy, steel())
    assert (slower < 0.99 * frequencies(plain, steel())).all()
    assert cd.compile(cantilever(heavy, steel())).parameters["beam.section.rhoI"] == 0.02


def test_none_of_it_gives_euler_and_bernoulli() -> None:
    """Without rotary inertia and with much shear stiffness: cos x cosh x = -1."""
    EI, rhoA, length = 40.0, 0.8, 0.5
    section = cd.section.general(EA=1e9, GA=1e9, GJ=30.0, EI=EI, rhoA=rhoA, rhoI=0)
    x = np.array([1.8751040687, 4.6940911330])
    expected = x**2 * np.sqrt(EI / (rhoA * length**4)) / (2 * np.pi)
    assert np.allclose(frequencies(section, plane="y")[:2], expected, rtol=1e-4)


def test_of_one_direction_alone() -> None:
    section = cd.section.tube(0.02, 0.015, rhoI=(0.01, 0))
    assert np.isfinite(frequencies(section, steel())).all()
    with pytest.raises(cd.ModelError, match="tube: rhoI is -1; give 0 or more"):
        cd.section.tube(0.02, 0.015, rhoI=-1)
