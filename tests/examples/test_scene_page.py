"""docs/scene_files.md is true: its blocks are one scene, its lists are complete."""

from __future__ import annotations

import re
import shutil
import textwrap
from pathlib import Path

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.elements.forces import FORCES
from cardan.elements.joints import JOINTS
from cardan.scene.files.expression import FUNCTIONS
from cardan.scene.files.yaml import keys

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "docs" / "scene_files.md").read_text(encoding="utf-8")
MISTAKEN = """\
cardan: 2
name: crane
gravity: [0, 0, -9.81]
bodies:
  upper: {mass: 1, com: [0, 0, -0.5], inertia: [0.1, 0.1, 0.01]}
  lower: {mass: 1, com: [0, 0, -0.5], inertia: [0.1, 0.1, 0.01]}
joints:
  shoulder: {type: revolute, axis: y, parent: ground, child: upper}
  elbow:
    type: revolute
    parent: {body: upper, at: [0, 0, -1]}
    child: lover
"""
BLOCKS = re.findall(r"```yaml\n(.*?)```", TEXT, flags=re.DOTALL)


def test_the_blocks_are_one_scene(tmp_path: Path) -> None:
    shutil.copy(ROOT / "src" / "cardan" / "scenes" / "bucket.yaml", tmp_path)
    path = tmp_path / "page.yaml"
    path.write_text("".join(BLOCKS), encoding="utf-8")
    scene = cd.load(path)
    assert scene.parameters["m"].value == 0.25
    assert scene.settings["inputs"] == {"push": 1}
    model = cd.compile(scene, functions=("rhs", "forward_dynamics", "outputs", "pose"))
    assert {"track", "elbow", "left.hang.angle1"} <= set(model.coordinates)
    q = np.linspace(0.1, 0.5, model.nq)
    assert model.outputs(q, 0 * q)[0] == pytest.approx(model.pose("tip", q)[2, 3], abs=1e-15)
    assert model.parameters["cart.mass"] == 2.5
    assert model.parameters["left.load"] == 3


def test_the_beams_are_a_scene(tmp_path: Path) -> None:
    (block,) = re.findall(r"^    beams:\n(?:     .*\n)+", TEXT, re.MULTILINE)
    path = tmp_path / "mast.yaml"
    path.write_text("cardan: 2\nname: mast\n" + textwrap.dedent(block), encoding="utf-8")
    scene = cd.load(path)
    assert scene.beams["mast"].elements == 6
    assert "mast.middle.px" in cd.derive(scene).coordinates


def test_the_error_is_that_of_the_page(tmp_path: Path) -> None:
    (shown,) = re.findall(r"^    (crane\.yaml:.*)$", TEXT, re.MULTILINE)
    path = tmp_path / "crane.yaml"
    path.write_text(MISTAKEN, encoding="utf-8")
    with pytest.raises(cd.ModelError) as problem:
        cd.load(path)
    assert str(problem.value).removeprefix(f"{tmp_path}/") == shown


def test_lists_are_complete() -> None:
    words = set(re.findall(r"\w+", TEXT))
    known = (JOINTS, FORCES, FUNCTIONS, keys.INERTIAS, keys.SHAPES)
    assert {name for family in known for name in family} <= words
    assert {key.name for key in keys.TOP} - words == set()


def test_expressions_are_those_of_python(tmp_path: Path) -> None:
    scene = cd.Scene("words")
    tip, cart = scene.body("tip"), scene.body("cart")
    scene.joint("elbow", cd.Revolute(), "ground", "cart")
    scene.joint("ball", cd.Spherical(), "cart", "tip")
    python = (
        scene.q("elbow") + scene.u("elbow") + scene.q("ball.qw") + scene.u("ball.x"),
        tip.position()[0],
        tip.velocity(wrt=cart, in_=cart)[0],
        tip.rotation(wrt=cart)[0, 2],
        sympy.Piecewise((1, cd.t < 1), (2, True)),
    )
    rows = [
        "q(elbow) + u(elbow) + q(ball.qw) + u(ball.x)",
        "position(tip).x",
        "velocity(tip wrt cart in cart).x",
        "rotation(tip wrt cart).xz",
        "select(t < 1, 1, 2)",
    ]
    path = tmp_path / "words.yaml"
    scene.save(path)
    text = path.read_text(encoding="utf-8") + "outputs:\n"
    path.write_text(text + "".join(f"  o{i}: {row}\n" for i, row in enumerate(rows)))
    found = [output.expression for output in cd.load(path).outputs.values()]
    assert found == list(python)
