"""The folder of a model in absolute coordinates: complete, documented, the same every time."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

import cardan as cd
from cardan.codegen.finite_elements.model_folder import FILE, numbers
from codegen.test_manifest import SCHEMA, undocumented

READER = """
import sys
import cardan as cd
model = cd.CompiledModel(sys.argv[1])
q, u = model.split(model.initial())
print(model.energy(q, u).total, "sympy" in sys.modules)
"""


def crane(elements: int = 6) -> cd.Scene:
    """A beam on a driven column, with a load whose size is a parameter."""
    scene = cd.Scene("crane", gravity=(0, 0, -9.81))
    load = scene.parameter("load", 100.0, unit="N")
    stiffness = scene.parameter("EI", 2e4, unit="N*m^2")
    column = scene.body("column", mass=50, inertia=cd.inertia.box(50, 0.2, 0.2, 1))
    scene.joint("slew", cd.Revolute("z"), scene.ground, column)
    section = cd.section.general(EA=4e7, GA=2e7, GJ=2e4, EI=stiffness, rhoA=8.0, rhoI=1e-3)
    jib = scene.beam("jib", column, (3, 0, 0), section=section, elements=elements)
    scene.force("hook", cd.Force(jib.end, (0, 0, -load)))
    return scene


def folder(path: Path, elements: int = 6) -> Path:
    """A model written there."""
    return cd.compile(crane(elements), directory=path).directory


def test_what_it_says_is_documented(tmp_path: Path) -> None:
    data: dict[str, Any] = json.loads((folder(tmp_path) / "manifest.json").read_text("utf-8"))
    jsonschema.validate(data, SCHEMA)
    assert undocumented({k: v for k, v in data.items() if k != "shapes"}, SCHEMA) == []


def test_same_scene_same_bytes(tmp_path: Path) -> None:
    one, other = folder(tmp_path / "one"), folder(tmp_path / "other")
    names = sorted(path.name for path in one.iterdir() if not path.name.startswith("."))
    assert FILE in names
    for name in names:
        assert (one / name).read_bytes() == (other / name).read_bytes(), name
    equations = cd.derive(crane())
    assert numbers(equations) == (one / FILE).read_bytes()


def test_c_does_not_grow_with_the_elements(tmp_path: Path) -> None:
    few, many = folder(tmp_path / "few", 3), folder(tmp_path / "many", 300)
    texts = {path.name: path.read_text("utf-8") for path in few.glob("*.c")}
    assert texts == {path.name: path.read_text("utf-8") for path in many.glob("*.c")}


def test_parameters_change_without_a_compiler(tmp_path: Path) -> None:
    model = cd.compile(crane(), directory=tmp_path / "crane")
    sags = []
    for load, stiffness in ((0.0, 2e4), (100.0, 2e4), (100.0, 4e4)):
        changed = model.with_parameters(load=load, EI=stiffness)
        rest = changed.equilibrium(locked={"slew": 0.0})
        sags.append(float(changed.pose("jib.end", rest.q)[2, 3]))
    loaded, stiff = sags[1] - sags[0], sags[2]
    assert loaded == pytest.approx(-100 * 27 / (3 * 2e4) - 100 * 3 / 2e7, rel=2e-2)
    assert stiff == pytest.approx(sags[1] / 2, rel=2e-2)


def test_other_processes_read_it_without_sympy(tmp_path: Path) -> None:
    model = cd.compile(crane(), directory=tmp_path / "crane")
    q, u = model.split(model.initial())
    ran = subprocess.run(
        [sys.executable, "-c", READER, str(tmp_path / "crane")],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    total, sympy = ran.stdout.split()
    assert float(total) == model.energy(q, u).total
    assert sympy == "False"


def test_models_travel(tmp_path: Path) -> None:
    model = cd.compile(crane(), directory=tmp_path / "crane").with_parameters(load=7.0)
    again = pickle.loads(pickle.dumps(model))
    q, u = model.split(model.initial())
    np.testing.assert_array_equal(again.forward_dynamics(q, u), model.forward_dynamics(q, u))


def test_tables_that_are_missing_are_told(tmp_path: Path) -> None:
    model = cd.compile(crane(), directory=tmp_path / "crane")
    (tmp_path / "crane" / FILE).unlink()
    with pytest.raises(cd.ModelError, match="does not hold the elements"):
        cd.CompiledModel(tmp_path / "crane").energy(*model.split(np.zeros(model.nx)))
