"""Parameters have the values that constructors accept, and no others; by every way to give them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import fields, replace
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.elements.limits import limit_rows
from cardan.elements.sections import SECTIONS
from cardan.runtime.calls.parameters import ParameterLimits
from cardan.topology.build import build
from cardan.topology.system import System
from elements.force_bench import INSTANCES
from elements.joint_bench import INSTANCES as JOINT_INSTANCES
from table import each

SECTION_INSTANCES: dict[str, Any] = {
    "circle": cd.section.circle(0.02, shear=0.8),
    "tube": cd.section.tube(0.03, 0.02, rhoI=(0.3, 0.4)),
    "rectangle": cd.section.rectangle(0.02, 0.03, shear=(0.8, 0.9), rhoI=0.3),
    "hollow_rectangle": cd.section.hollow_rectangle(0.05, 0.03, 0.004),
    "i_beam": cd.section.i_beam(0.05, 0.08, 0.005, 0.004),
    "general": cd.section.general(EA=3.0, GA=(2.0, 2.5), GJ=4.0, EI=5.0, rhoA=0.7, rhoI=(0.3, 0.2)),
}
MATERIALS = {
    "by nu": cd.material(E=2e9, nu=0.3, rho=900.0, damping=1e-3, expansion=1e-5),
    "by G": cd.material(E=2e9, G=8e8, rho=900.0),
}
# what constructors refuse because nothing would be left to derive, and motion does not mind
LEFT_OUT = {("friction", "mu", 0.0)}


def values_near(value: float) -> list[float]:
    """Values on both sides of all limits that numbers like this one have."""
    ratios = [-1.0, -0.99, -1e-9, 0.0, 1e-9, 0.49999, 0.5, 0.50001, 0.99999, 1.0, 1.00001, 2.0]
    return [*ratios, *(ratio * value for ratio in (-1.0, 0.1, 0.4, 0.6, 1.7, 3.0, 30.0))]


def entries(record: Any) -> Iterator[tuple[str, str, Callable[[float], Any], float]]:
    """Numbers of a record: field, name of its parameter, the record with another one, value."""
    for entry in fields(record):
        value = getattr(record, entry.name)
        if isinstance(value, float):
            yield entry.name, entry.name, lambda x, n=entry.name: replace(record, **{n: x}), value
        elif entry.type == "Pair" and isinstance(value, tuple):
            for k, label in enumerate(("e2", "e3")):

                def changed(x: float, n: str = entry.name, k: int = k, v: Any = value) -> Any:
                    return replace(record, **{n: (*v[:k], x, *v[k + 1 :])})

                yield entry.name, f"{entry.name}.{label}", changed, value[k]
        elif entry.name == "branches":
            for k, (stiffness, time) in enumerate(value):

                def with_time(x: float, k: int = k, s: Any = stiffness, v: Any = value) -> Any:
                    return replace(record, branches=(*v[:k], (s, x), *v[k + 1 :]))

                yield entry.name, f"branches.{k}.time", with_time, time


def limits_of(system: System) -> ParameterLimits:
    """Limits of the parameters of a system."""
    names = [parameter.name for parameter in system.parameters]
    rows = limit_rows(system.number_limits, system.graph, names)
    return ParameterLimits(rows, {name: k for k, name in enumerate(names)})


def agree(scene: cd.Scene, owner: str, record: Any) -> int:
    """Compare what a constructor and what parameters refuse; how many values were refused."""
    system, refused = build(scene), 0
    names = [parameter.name for parameter in system.parameters]
    places = {name: k for k, name in enumerate(names)}
    limits = limits_of(system)
    start = np.array([parameter.value for parameter in system.parameters])
    assert not limits.exceeded(start).any()
    for field, key, changed, value in entries(record):
        if f"{owner}.{key}" not in places:
            continue
        for other in values_near(value):
            if (getattr(record, "kind", ""), field, other) in LEFT_OUT:
                continue
            message = ""
            try:
                changed(other)
            except cd.ModelError as refusal:
                message = str(refusal).partition(": ")[2]
            vector = start.copy()
            vector[places[f"{owner}.{key}"]] = other
            exceeded = np.flatnonzero(limits.exceeded(vector))
            assert bool(len(exceeded)) == bool(message), (key, other, message)
            if message:
                refused += 1
                with pytest.raises(cd.ModelError, match=re.escape(message)) as problem:
                    limits.refuse(int(exceeded[0]), vector)
                assert str(problem.value).startswith("parameter '")
    return refused


def beam(section: Any, material: Any) -> cd.Scene:
    scene = cd.Scene("beam")
    scene.beam("b", scene.ground, (1, 0, 0), section, material, elements=1)
    return scene


def test_every_section_is_tested() -> None:
    assert set(SECTION_INSTANCES) == set(SECTIONS)


@each("kind", SECTION_INSTANCES)
def test_sections(kind: str) -> None:
    section = SECTION_INSTANCES[kind]
    material = MATERIALS["by nu"] if section.shaped else cd.material(damping=1e-3)
    assert agree(beam(section, material), "b.section", section) > 5


@each("name", MATERIALS)
def test_materials(name: str) -> None:
    scene = beam(SECTION_INSTANCES["circle"], MATERIALS[name])
    assert agree(scene, "b.material", MATERIALS[name]) > 5


def scene_of(element: Any) -> cd.Scene:
    """A scene with the frames, joints and beams that elements of the bench act on."""
    scene = cd.Scene("bench")
    a, b = (scene.body(name, mass=2.0, inertia=(0.9, 1.3, 0.8)) for name in "AB")
    scene.joint("two", cd.Cylindrical("z"), scene.ground, a)
    scene.joint("one", cd.Revolute("x"), a, b)
    section, material = SECTION_INSTANCES["circle"], MATERIALS["by nu"]
    if element.kind == "line_load":
        scene.beam("blade", scene.ground, (1, 0, 0), section, material, elements=1)
    scene.force("it", element)
    return scene


LIMITED = [name for name, element in INSTANCES.items() if element.limits()]


@each("name", LIMITED)
def test_force_elements(name: str) -> None:
    element = INSTANCES[name]
    refused = agree(scene_of(element), "it", element)
    assert refused > 0 or name in ("rotor of constant momentum",)


@each("name", [name for name, joint in JOINT_INSTANCES.items() if joint.limits()])
def test_joints(name: str) -> None:
    joint, scene = JOINT_INSTANCES[name], cd.Scene("joint")
    body = scene.body("A", mass=2.0, inertia=(0.9, 1.3, 0.8))
    scene.joint("it", joint, scene.ground, body)
    assert agree(scene, "it", joint) > 0


def rope(elements: int, **numbers: Any) -> cd.Scene:
    scene = cd.Scene("rope")
    given = {"EA": 1e4, "rhoA": 0.2, "length": 1.1, "damping": 1e-3} | numbers
    scene.cable("rope", scene.ground, scene.ground.at(1, 0, 0), elements=elements, **given)
    if elements == 1:
        body = scene.body("A", mass=1.0, inertia=(1, 1, 1))
        scene.joint("free", cd.Free(), scene.ground, body)
    return scene


@each("elements", [1, 3])
@each("key", ["EA", "rhoA", "length", "damping"])
def test_cables(elements: int, key: str) -> None:
    system = build(rope(elements))
    start = {parameter.name: parameter.value for parameter in system.parameters}
    limits = limits_of(system)
    for other in values_near(start[f"rope.{key}"]):
        vector = np.array([*(start | {f"rope.{key}": other}).values()])
        message = ""
        try:
            rope(elements, **{key: other})
        except cd.ModelError as refusal:
            message = str(refusal)
        exceeded = np.flatnonzero(limits.exceeded(vector))
        assert bool(len(exceeded)) == bool(message), (other, message)
        if message:
            with pytest.raises(cd.ModelError, match=re.escape(message)):
                limits.refuse(int(exceeded[0]), vector)


def test_relations_with_numbers_that_are_built_in() -> None:
    """What is written into the equations bounds what is left."""
    tube = beam(cd.section.tube(0.03, 0.02), MATERIALS["by nu"])
    for name, other, message in (
        ("outer", 0.031, "the inner radius 0.031 m of the tube is not below the outer 0.03 m"),
        ("inner", 0.019, "the inner radius 0.02 m of the tube is not below the outer 0.019 m"),
    ):
        left = {"outer": "inner", "inner": "outer"}[name]
        model = cd.compile(tube, specialize=[f"b.section.{name}"], functions=[])
        with pytest.raises(cd.ModelError, match=re.escape(message)):
            model.with_parameters({f"b.section.{left}": other})
        model.with_parameters({f"b.section.{left}": 0.025})
        with pytest.raises(cd.ModelError, match="is not below the outer"):
            model.with_parameters({f"b.section.{left}": {"inner": 0.03, "outer": 0.02}[left]})


def test_multiples_of_parameters() -> None:
    scene = cd.Scene("beam")
    d = scene.parameter("d", 0.05)
    section = cd.section.tube(d / 2, 0.02)
    scene.beam("b", scene.ground, (1, 0, 0), section, MATERIALS["by nu"], elements=1)
    model = cd.compile(scene, functions=[])
    model.with_parameters(d=0.041)
    message = "parameter 'd': beam 'b': tube: the inner radius 0.02 m of the tube is not below"
    with pytest.raises(cd.ModelError, match=f"{message} the outer 0.019 m"):
        model.with_parameters(d=0.038)
    with pytest.raises(cd.ModelError, match="parameter 'd'"):
        model.with_parameters({"b.section.inner": 0.026})


WRONG = [
    ("b.material.E", -1.0, "E is -1; give more than 0 [Pa]"),
    ("b.material.nu", 0.6, "nu is 0.6; give Poisson's ratio, above -1 and at most 0.5"),
    ("b.material.rho", -2.0, "rho is -2; give 0 or more [kg/m^3]"),
    ("b.section.height", -1e-3, "height is -0.001; give more than 0"),
    ("hinge.turn", -1.0, "turn is -1; give 0 or more"),
]


@pytest.fixture(scope="module")
def plate() -> cd.CompiledModel:
    scene = beam(cd.section.rectangle(0.03, 0.002), cd.material(E=7e10, nu=0.3, rho=2700.0))
    hinge = cd.FlexibleHinge(scene.ground, "b.end", "x", 0.5, 80.0, 90.0, 70.0)
    scene.force("hinge", hinge)
    return cd.compile(scene)


WAYS: dict[str, Callable[[cd.CompiledModel, dict[str, Any]], Any]] = {
    "with_parameters": lambda model, values: model.with_parameters(values),
    "simulate": lambda model, values: model.simulate(1e-3, parameters=values),
    "equilibrium": lambda model, values: model.equilibrium(parameters=values),
    "modes": lambda model, values: model.modes(parameters=values),
    "ensemble": lambda model, values: model.ensemble(
        1e-3, parameters={key: [model.parameters[key], x] for key, x in values.items()}
    ),
}


@each("way", WAYS)
@pytest.mark.parametrize(("name", "value", "message"), WRONG)
def test_ways(plate: cd.CompiledModel, way: str, name: str, value: float, message: str) -> None:
    with pytest.raises(cd.ModelError, match=re.escape(message)) as problem:
        WAYS[way](plate, {name: value})
    assert f"'{name}'" in str(problem.value)


def test_saved_models_with_changed_values(plate: cd.CompiledModel) -> None:
    again = cd.load_model(plate.directory)
    with pytest.raises(cd.ModelError, match=r"'b.material.nu'.*nu is 0.6"):
        again.with_parameters({"b.material.nu": 0.6})
    make, (*head, values, reproducible, digest) = plate.__reduce__()
    changed = list(values)
    changed[list(plate.parameters).index("b.material.nu")] = 0.6
    assert dict(make(*head, values, reproducible, digest).parameters) == dict(plate.parameters)
    with pytest.raises(cd.ModelError, match=r"'b.material.nu'.*nu is 0.6"):
        make(*head, changed, reproducible, digest)


def test_values_that_are_built_in() -> None:
    scene = beam(SECTION_INSTANCES["circle"], MATERIALS["by nu"])
    with pytest.raises(cd.ModelError, match=r"beam 'b': material: nu is 0.6; give Poisson's"):
        cd.derive(scene, specialize={"b.material.nu": 0.6})
    drive = scene_of(INSTANCES["rigid drive"])
    with pytest.raises(cd.ModelError, match=r"drive.*: inertia is -1; give 0 or more"):
        cd.derive(drive, specialize={"it.inertia": -1.0})
    cable = rope(3)
    with pytest.raises(cd.ModelError, match="cable 'rope': EA is -1; give more than 0"):
        cd.derive(cable, specialize={"rope.EA": -1.0})


def test_values_that_expressions_have() -> None:
    for numbers, message in (({"EA": 2.0}, "EA is -2"), ({"damping": 0.1}, "damping is -0.1")):
        scene = cd.Scene("rope")
        k = scene.parameter("k", -1.0)
        given = {"EA": 1e4, "rhoA": 0.2} | {key: x * k for key, x in numbers.items()}
        scene.cable("rope", scene.ground, scene.ground.at(1, 0, 0), elements=3, **given)
        with pytest.raises(cd.ModelError, match=message):
            cd.derive(scene)
