"""Sections of beams against closed forms, integrals over the section and published factors."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.elements.sections import SECTIONS, Section
from cardan.errors import ModelError
from cardan.topology import build
from table import each

E, NU, RHO = 2.1e11, 0.3, 7850.0
G = E / (2 * (1 + NU))
INSTANCES: dict[str, Section] = {
    "circle": cd.section.circle(0.03),
    "tube": cd.section.tube(outer=0.03, inner=0.02),
    "rectangle": cd.section.rectangle(width=0.02, height=0.05),
    "wide rectangle": cd.section.rectangle(width=0.05, height=0.02),
    "square": cd.section.rectangle(width=0.04, height=0.04),
    "box": cd.section.hollow_rectangle(width=0.04, height=0.06, thickness=0.004),
    "I": cd.section.i_beam(width=0.1, height=0.2, flange=0.0085, web=0.0056),
    "general": cd.section.general(
        EA=1e6, GA=(2e5, 3e5), GJ=50.0, EI=(60.0, 70.0), rhoA=2.0, rhoI=(0.01, 0.02)
    ),
}


def numbers(section: Section, **values: float) -> dict[str, float]:
    """Stiffness and inertia of a beam with a section."""
    scene = cd.Scene("one")
    scene.values.update(values)
    material = cd.material(E=E, nu=NU, rho=RHO) if section.shaped else None
    scene.beam("b", (0, 0, 0), (1, 0, 0), section, material)
    return data_of(scene)


def data_of(scene: cd.Scene) -> dict[str, float]:
    from cardan.ir.function import Function, Output
    from cardan.ir.interpreter import evaluate

    system = build(scene)
    data = system.segments[0].data
    p = {"p": [entry.value for entry in system.parameters]}
    names = [name for name, (rows, *_) in data.items() if rows == 1]
    nodes = tuple(data[name][2][0] for name in names)
    function = Function("data", system.graph, (), (Output("data", (len(nodes),), nodes),))
    return dict(zip(names, map(float, evaluate(function, p)["data"]), strict=True))


def test_every_section_is_tested() -> None:
    assert {section.kind for section in INSTANCES.values()} == set(SECTIONS)
    assert all(SECTIONS[s.kind] is type(s) and s.source for s in INSTANCES.values())


def inside(section: Any, y: Any, z: Any) -> Any:
    """Whether points (e2, e3) belong to a section."""
    kind = section.kind
    if kind == "circle":
        return np.hypot(y, z) < section.radius
    if kind == "tube":
        return (np.hypot(y, z) < section.outer) & (np.hypot(y, z) > section.inner)
    full = (abs(y) < section.width / 2) & (abs(z) < section.height / 2)
    if kind == "rectangle":
        return full
    if kind == "hollow_rectangle":
        t = section.thickness
        return full & ~((abs(y) < section.width / 2 - t) & (abs(z) < section.height / 2 - t))
    beside = (abs(z) < section.height / 2 - section.flange) & (abs(y) > section.web / 2)
    return full & ~beside


@pytest.mark.parametrize("name", [name for name, s in INSTANCES.items() if s.shaped])
def test_area_and_second_moments_are_integrals(name: str) -> None:
    section = INSTANCES[name]
    found, outline = numbers(section), section.outline(vars(section))
    n = 2000
    y = (np.arange(n) + 0.5) / n * 2 * outline.e2 - outline.e2
    z = (np.arange(n) + 0.5) / n * 2 * outline.e3 - outline.e3
    mask = inside(section, y[:, None], z[None, :])
    cell = 4 * outline.e2 * outline.e3 / n**2
    area, i2 = mask.sum() * cell, (mask @ z**2).sum() * cell
    i3 = (mask.T @ y**2).sum() * cell
    # a wall of k cells is resolved to 1 / k
    rough = 3e-2 if section.kind == "i_beam" else 6e-3
    assert found["EA"] == pytest.approx(E * area, rel=rough)
    assert found["EI2"] == pytest.approx(E * i2, rel=rough)
    assert found["EI3"] == pytest.approx(E * i3, rel=rough)
    for stiffness, inertia in (("EA", "rhoA"), ("EI2", "rhoI2"), ("EI3", "rhoI3")):
        assert found[inertia] == pytest.approx(RHO / E * found[stiffness], rel=1e-15)


# torsion constant / (long side * short side^3), from the table in Timoshenko and Goodier
TORSION = {1.0: 0.1406, 1.2: 0.166, 1.5: 0.196, 2.0: 0.229, 2.5: 0.249, 5.0: 0.291, 10.0: 0.312}


@pytest.mark.parametrize("ratio", TORSION)
def test_torsion_of_a_rectangle(ratio: float) -> None:
    found = numbers(cd.section.rectangle(width=ratio, height=1.0))
    assert found["GJ"] / G / ratio == pytest.approx(TORSION[ratio], abs=6e-4)
    assert numbers(cd.section.rectangle(width=1.0, height=ratio))["GJ"] == found["GJ"]


def test_torsion_of_a_square_to_more_digits() -> None:
    found = numbers(cd.section.rectangle(width=1.0, height=1.0))["GJ"] / G
    series = sum(math.tanh(n * math.pi / 2) / n**5 for n in range(1, 400, 2))
    assert found == pytest.approx((1 - 192 / math.pi**5 * series) / 3, rel=1e-11)


def test_torsion_of_round_and_thin_sections() -> None:
    assert numbers(INSTANCES["circle"])["GJ"] == pytest.approx(G * math.pi / 2 * 0.03**4)
    tube = numbers(INSTANCES["tube"])
    assert tube["GJ"] == pytest.approx(G * math.pi / 2 * (0.03**4 - 0.02**4))
    box = numbers(cd.section.hollow_rectangle(width=1.001, height=1.001, thickness=0.001))
    assert box["GJ"] == pytest.approx(G * 0.001, rel=1e-12)


# Cowper 1966, nu = 0.3: circle 0.886, rectangle 0.850, thin tube 0.531, thin square box 0.436
FACTORS = {
    0.886: cd.section.circle(0.01),
    0.850: cd.section.rectangle(width=0.01, height=0.02),
    0.531: cd.section.tube(outer=1.0, inner=0.9999),
    0.436: cd.section.hollow_rectangle(width=1.0, height=1.0, thickness=1e-5),
}


@pytest.mark.parametrize("factor", FACTORS)
def test_shear_correction_factors(factor: float) -> None:
    found = numbers(FACTORS[factor])
    area = found["EA"] / E
    assert found["GA2"] == found["GA3"] == pytest.approx(factor * G * area, abs=6e-4 * G * area)


def test_shear_of_an_i_beam_is_that_of_its_parts() -> None:
    found = numbers(INSTANCES["I"])
    web = 0.0056 * (0.2 - 0.0085)
    # rough: the web carries what runs along it
    assert found["GA3"] == pytest.approx(G * web, rel=0.06)
    assert found["GA2"] == pytest.approx(0.85 * G * 2 * 0.1 * 0.0085, rel=1e-3)


def test_given_factors_are_taken() -> None:
    one = numbers(cd.section.circle(0.01, shear=0.9))
    two = numbers(cd.section.rectangle(0.01, 0.02, shear=(5 / 6, 1.0)))
    area = math.pi * 1e-4
    assert one["GA2"] == one["GA3"] == pytest.approx(0.9 * G * area)
    assert two["GA2"] / two["GA3"] == pytest.approx(5 / 6)


def test_general_sections_say_it_themselves() -> None:
    found = numbers(INSTANCES["general"])
    wanted = {"EA": 1e6, "GA2": 2e5, "GA3": 3e5, "GJ": 50.0, "EI2": 60.0, "EI3": 70.0}
    wanted |= {"rhoA": 2.0, "rhoI2": 0.01, "rhoI3": 0.02, "damping": 0.0}
    assert found == wanted


def test_outline_of_numbers_is_that_of_a_round_bar() -> None:
    bar = numbers(INSTANCES["circle"])
    general = cd.section.general(EA=bar["EA"], GA=bar["GA2"], GJ=bar["GJ"], EI=bar["EI2"])
    scene = cd.Scene("one")
    scene.beam("b", (0, 0, 0), (1, 0, 0), general)
    outline = build(scene).segments[0].outline
    assert (outline.e2, outline.e3) == pytest.approx((0.03, 0.03))
    assert outline.round


def test_numbers_are_parameters_and_parameters_stay() -> None:
    found = numbers(INSTANCES["circle"], **{"b.section.radius": 0.06, "b.material.E": E / 16})
    assert found["EI2"] == pytest.approx(numbers(INSTANCES["circle"])["EI2"])
    scene = cd.Scene("one")
    r = scene.parameter("r", 30, unit="mm")
    scene.beam("b", (0, 0, 0), (1, 0, 0), cd.section.tube(r, 2 * r / 3), cd.material(E, NU))
    assert data_of(scene)["EI2"] == pytest.approx(numbers(INSTANCES["tube"])["EI2"])


def test_shear_modulus_instead_of_poissons_ratio() -> None:
    scene = cd.Scene("one")
    scene.beam("b", (0, 0, 0), (1, 0, 0), cd.section.circle(0.03), cd.material(E=E, G=G, rho=RHO))
    found, other = data_of(scene), numbers(INSTANCES["circle"])
    assert found == pytest.approx(other, rel=1e-14)


WRONG: Mapping[str, Any] = {
    "radius is -1": lambda: cd.section.circle(-1),
    "radius is nan": lambda: cd.section.circle(math.nan),
    "shear has 3 entries": lambda: cd.section.circle(1, shear=(1, 1, 1)),
    "width is 0": lambda: cd.section.rectangle(0, 1),
    "EI is -1": lambda: cd.section.general(EA=1, GA=1, GJ=1, EI=-1),
    "rhoA is -1": lambda: cd.section.general(EA=1, GA=1, GJ=1, EI=1, rhoA=-1),
    "nu is 0.7": lambda: cd.material(E=1, nu=0.7),
    "nu is -1": lambda: cd.material(E=1, nu=-1),
    "leave out one": lambda: cd.material(E=1, nu=0.3, G=1),
    "E is 0": lambda: cd.material(E=0, nu=0.3),
    "rho is -1; give": lambda: cd.material(E=1, nu=0.3, rho=-1),
    "damping is -1; give": lambda: cd.material(E=1, nu=0.3, damping=-1),
    "is not below": lambda: numbers(cd.section.tube(outer=0.01, inner=0.01)),
    "leave no room": lambda: numbers(cd.section.hollow_rectangle(1, 1, 0.5)),
    "leave no web": lambda: numbers(cd.section.i_beam(1, 1, 0.5, 0.1)),
    "wider than the flanges": lambda: numbers(cd.section.i_beam(0.1, 1, 0.1, 0.2)),
}


@each("words", WRONG)
def test_nonsense_is_refused(words: str) -> None:
    with pytest.raises(ModelError, match=words):
        WRONG[words]()


def test_nonsense_in_parameters_is_found_when_they_have_values() -> None:
    scene = cd.Scene("one")
    r = scene.parameter("r", 0.01)
    scene.beam("b", (0, 0, 0), (1, 0, 0), cd.section.tube(r, 2 * r), cd.material(E, NU))
    with pytest.raises(ModelError, match="beam 'b': tube: the inner radius"):
        build(scene)
    scene = cd.Scene("two")
    nu = scene.parameter("nu", 0.6)
    scene.beam("b", (0, 0, 0), (1, 0, 0), cd.section.circle(0.01), cd.material(E, nu))
    with pytest.raises(ModelError, match=r"beam 'b': material: nu is 0\.6"):
        build(scene)
