"""Scenes that were written once are read for ever."""

from __future__ import annotations

import json
import warnings
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan import version
from cardan.scene.files.yaml import reader, tree
from compatibility.write import FILES, PARTS, described
from spread import some

# of every version of the format
CASES = [
    pytest.param(path, id=f"{path.parent.name}-{path.stem}")
    for path in sorted(FILES.glob("scene_*/*.yaml"))
    if path.stem not in PARTS
]


def told(path: Path) -> dict[str, object]:
    """What a scene said when it was kept."""
    return dict(json.loads(path.parent.with_suffix(".json").read_text("utf-8"))[path.stem])


@pytest.mark.parametrize("path", CASES)
def test_a_scene_says_what_it_said(path: Path) -> None:
    expected, found = told(path), described(cd.load(path))
    assert found == {name: expected[name] for name in found}


@pytest.mark.parametrize("path", some(CASES, 8))
def test_a_scene_moves_as_it_moved(path: Path) -> None:
    scene, expected = cd.load(path), told(path)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cd.SolveWarning)
        if scene.beams:
            model = cd.compile(scene, coordinates="absolute")
            found, x = "energy", np.array(expected["x"])
            values = list(model.energy(*model.split(x)[:2]))
        else:
            model = cd.compile(scene, functions=["rhs"])
            found, x = "xdot", np.array(expected["x"])
            values = model.rhs(0.0, x)
    scale = np.abs(expected[found]).max()
    np.testing.assert_allclose(values, expected[found], rtol=1e-9, atol=1e-9 * scale)


NAMED_BEFORE = """\
cardan: 1
name: before
bodies:
  rod: {mass: 2.0, inertia: [1, 1, 1]}
  hub: {mass: 2.0, inertia: [1, 1, 1]}
joints:
  drive: {type: revolute, axis: y, parent: ground, child: hub, motion: 0.1*t}
  ball: {type: spherical, parent: hub, child: rod}
forces:
  rope: {type: spring_damper, frame_a: ground, frame_b: rod, stiffness: 5, length: 1}
  look: {type: watch, expression: "q(ball.w) - 0.5", then: end}
outputs:
  turned: q(ball.x)
"""


def test_a_scene_of_format_1_has_the_names_of_today() -> None:
    scene = reader.from_text(NAMED_BEFORE)
    rope, look = scene.forces["rope"].element, scene.forces["look"].element
    assert (rope.rest_length, look.kind, look.terminal) == (1, "event", True)
    assert scene.joints["drive"].prescribed == 0.1 * cd.t
    assert scene.outputs["turned"].expression == scene.q("ball.qx")
    # today's names are for files of today
    with pytest.raises(cd.ModelError, match=r"q\('ball.w'\): no such component"):
        reader.from_text(
            NAMED_BEFORE.replace("cardan: 1", "cardan: 2")
            .replace("motion:", "prescribed:")
            .replace("length:", "rest_length:")
            .replace("watch", "event")
            .replace("then: end", "terminal: true")
        )


OLDER = """\
cardan: 1
name: pendulum
bodies:
  rod: {weight: 2.0, com: [0, 0, -1]}
joints:
  pivot: {type: revolute, axis: y, parent: ground, child: rod}
"""


def renaming(monkeypatch: pytest.MonkeyPatch) -> None:
    """A cardan of tomorrow, to which masses were once weights."""
    form = version.Format("scene", "cardan", 2, 1, "", {1: {"bodies.*.weight": "mass"}})
    for module in (reader, tree):
        monkeypatch.setattr(module, "SCENE", form)


def test_a_renamed_key_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    renaming(monkeypatch)
    scene = reader.from_text(OLDER)
    assert scene.bodies["rod"].mass == 2
    # a place of another name stays
    assert "pivot" in scene.joints


@pytest.mark.parametrize(
    "text",
    [OLDER.replace("cardan: 1", "cardan: 2"), OLDER.replace("weight: 2.0", "weight: 2, mass: 1")],
    ids=["in a new file", "beside the new one"],
)
def test_the_former_name_is_refused(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    renaming(monkeypatch)
    with pytest.raises(cd.ModelError, match="a body has no key 'weight'"):
        reader.from_text(text)
