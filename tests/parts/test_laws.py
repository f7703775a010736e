"""Laws of all parts: what they take, alone and twice in a scene, through files."""

from __future__ import annotations

import inspect
import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.parts import PARTS
from parts import page
from spread import some

# settings that are starts and structure: the scene has no parameter for them
STRUCTURE = {
    "double_wishbone": {"side"},
    "gyroscope": {"spin"},
    "planetary_gear": {"fixed", "planets"},
    "reaction_wheel_set": {"wheels"},
    "stewart_platform": {"height"},
}
# sources and sinks: what is dissipated is accounted for, and no energy is conserved
DISSIPATING = ("cam_and_follower", "double_wishbone", "stewart_platform")
FLOOR = 1e-5  # of the energy that is exchanged, at rtol 1e-8


@cache
def model(name: str) -> cd.CompiledModel:
    return cd.compile(PARTS[name]())


@pytest.mark.parametrize("name", PARTS)
def test_arguments_are_parameters_with_units_and_texts(name: str) -> None:
    """Every number is a declared parameter, and the docstring says its unit."""
    make = PARTS[name]
    scene = make()
    arguments = inspect.signature(make).parameters.values()
    text = inspect.getdoc(make) or ""
    listed = re.search(r"^Args:\n(.*?)\n\nReturns:", text, re.DOTALL | re.MULTILINE)
    assert listed
    entries = re.findall(
        r"^    ([\w, ]+): (.*?)(?=^    \w|\Z)", listed[1], re.DOTALL | re.MULTILINE
    )
    told = {word.strip(): said for words, said in entries for word in words.split(",")}
    assert set(told) == {one.name for one in arguments}
    for one in arguments:
        assert one.kind is one.KEYWORD_ONLY
        if one.name in STRUCTURE.get(name, set()):
            assert one.name not in scene.parameters
            continue
        values = np.atleast_1d(one.default)
        declared = [one.name] if values.size == 1 else [f"{one.name}.{axis}" for axis in "xyz"]
        for label, value in zip(declared, values, strict=True):
            entry = scene.parameters[label]
            assert entry.value == value
            assert entry.stated
            if entry.unit:
                assert "[" in told[one.name], f"{name}: {one.name} has no unit in its docstring"
    assert "Source:" in text
    assert scene.name == name


@pytest.mark.parametrize("name", PARTS)
def test_names_that_the_text_speaks_of_are_there(name: str) -> None:
    """Inputs, outputs, frames and joints of the docstring are those of the scene."""
    scene, text = PARTS[name](), inspect.getdoc(PARTS[name]) or ""
    told = set(re.findall(r"``([\w.]+)``", text))
    there = {
        *scene.inputs, *scene.outputs, *scene.frames, *scene.joints, *scene.constraints,
        *inspect.signature(PARTS[name]).parameters, "contact", "sun_teeth",
    }  # fmt: skip
    assert told <= there, told - there
    named = {frame.name for frame in scene.frames.values() if frame.named}
    for kind in (scene.inputs, scene.outputs, named):
        # a row such as leg1 ... is told by its first
        numbered = {re.sub(r"[2-9]$", "1", item) for item in kind}
        points = "points by their names" in text
        assert {n for n in numbered if not points or n in told} == numbered or points, (
            numbered - told
        )
        assert points or numbered <= told, numbered - told
    assert all(body.shapes for body in scene.bodies.values() if body.name != "toe")


@pytest.mark.parametrize("name", PARTS)
def test_a_part_runs_alone_and_keeps_its_energy(name: str) -> None:
    scene = PARTS[name]()
    made = model(name)
    start = made.simulate(1e-9)
    if made.nlam:
        # starts close as they are written: nothing is moved to assemble the loops
        declared = np.concatenate(
            [np.ravel(j.q0) for j in scene.joints.values() if j.q0 is not None] or [np.zeros(1)]
        )
        assert np.abs(start.q[0]).max() <= max(1.0, np.abs(declared).max()) + 1e-9
        assert np.abs(made.constraints(start.q[0])).max() < 1e-12
    motion = made.simulate(**scene.settings | {"t": min(scene.settings["t"], 0.5)}, rtol=1e-8)
    assert motion.success
    energy = motion.energy
    exchanged = np.ptp(energy.potential) + np.ptp(energy.kinetic) + energy.kinetic.max()
    assert np.abs(motion.energy_residual).max() < FLOOR * exchanged
    if name not in DISSIPATING:
        assert np.ptp(energy.total) < FLOOR * exchanged
    outputs = [row.name for row in made.manifest.outputs]
    assert all(np.isfinite(motion[output]).all() for output in outputs)


@pytest.mark.parametrize("name", PARTS)
def test_parts_go_through_files(name: str, tmp_path: Path) -> None:
    scene = PARTS[name]()
    scene.save(tmp_path / "part.yaml")
    again = cd.load(tmp_path / "part.yaml")
    assert again.settings == scene.settings
    for kind in ("parameters", "inputs", "outputs", "joints", "frames"):
        assert set(getattr(again, kind)) == set(getattr(scene, kind)), kind
    one, other = model(name), cd.compile(again)
    x = one.simulate(0.01, u=scene.settings.get("u")).x[-1]
    np.testing.assert_allclose(other.rhs(0.01, x), one.rhs(0.01, x), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("name", some(PARTS, 4))
def test_parts_are_explained(name: str, tmp_path: Path) -> None:
    page = tmp_path / "part.md"
    cd.derive(PARTS[name]()).explain(page)
    text = page.read_text("utf-8")
    assert name.replace("_", "\\_") in text
    assert len(text) > 3000


@pytest.mark.parametrize("name", some(PARTS, 3))
def test_two_of_a_part_in_one_scene_move_as_one_alone(name: str) -> None:
    """Turned, shifted and carried along: outputs are those of the part's own ground.

    Along the vertical gravity is that of the part alone; the host stands still.
    """
    whole = cd.Scene("whole")
    table = whole.body("table", mass=1.0)
    whole.joint("table", cd.Fixed(), whole.ground, table)
    turned = table.at(0.3, -0.5, 0.7, rotation=("ZYX", 0.8, 0, 0))
    first = whole.include(PARTS[name](), "first", at=turned)
    whole.include(PARTS[name](), "second", at=table.at(0, 2.0, 0))
    assert {f"first.{output}" for output in PARTS[name]().outputs} <= set(whole.outputs)
    assert set(first.joints) == set(PARTS[name]().joints)
    speeds = PARTS[name]().settings.get("u", {})
    both = {f"{prefix}.{joint}": u for prefix in ("first", "second") for joint, u in speeds.items()}
    options = {"t": np.linspace(0, 0.1, 5), "rtol": 1e-9}
    together = cd.compile(whole).simulate(**options, u=both)
    alone = model(name).simulate(**options, u=speeds)
    for output in (row.name for row in model(name).manifest.outputs):
        for prefix in ("first", "second"):
            np.testing.assert_allclose(
                together[f"{prefix}.{output}"], alone[output], rtol=1e-6, atol=1e-6, err_msg=output
            )


def test_parts_are_listed() -> None:
    assert cd.parts.PARTS is PARTS
    assert all(getattr(cd.parts, name) is make for name, make in PARTS.items())


REFUSED = {
    "four_bar": ({"ground_length": 2.0}, "do not meet over"),
    "slider_crank": ({"rod_length": 0.02}, "does not reach"),
    "cam_and_follower": ({"rise": 6.0}, "at most one turn"),
    "planetary_gear": ({"fixed": "rign"}, "Did you mean 'ring'"),
    "double_wishbone": ({"side": "middle"}, "side='middle'"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_is_refused(name: str) -> None:
    options, match = REFUSED[name]
    with pytest.raises(cd.ModelError, match=match):
        PARTS[name](**options)
    with pytest.raises(cd.ArgumentError, match="there is no such argument"):
        PARTS[name](lenght=1.0)
    with pytest.raises(cd.ModelError, match="has 2 numbers"):
        cd.parts.double_wishbone(wheel_center=(0.0, 0.7))


def test_the_page_is_that_of_the_parts() -> None:
    assert page.PAGE.read_text("utf-8") == page.written(), "python tests/parts/page.py writes it"
    pictures = {path.stem for path in page.PAGE.parent.glob("parts_*.png")}
    assert pictures == {f"parts_{name}" for name in PARTS}


@pytest.mark.parametrize("name", PARTS)
def test_sizes_and_masses_that_cannot_be_are_refused(name: str) -> None:
    """By the name of the argument; what may point to either side takes both signs."""
    for argument in inspect.signature(PARTS[name]).parameters:
        if re.search("(mass|teeth|module|radius|length|thickness)$", argument):
            with pytest.raises(cd.ModelError, match=f"{argument}=-1: give a number"):
                PARTS[name](**{argument: -1.0})
    for argument in {"sun_teeth", "side_teeth"} & {*inspect.signature(PARTS[name]).parameters}:
        with pytest.raises(cd.ModelError, match=f"{argument}=0: give a number above 0"):
            PARTS[name](**{argument: 0.0})
