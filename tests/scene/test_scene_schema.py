"""``docs/scene.schema.json`` says what the reader reads; ``pytest --accept`` writes it anew."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from ruamel.yaml import YAML

import cardan as cd
from cardan.elements.forces import FORCES
from cardan.elements.joints import JOINTS
from cardan.errors import CardanError
from mechanisms import ZOO, Mechanism
from scene.scene_schema import schema

ROOT = Path(__file__).parents[2]
PUBLISHED = ROOT / "docs" / "scene.schema.json"
SCENES = sorted((ROOT / "examples").glob("*.yaml"))


def document(path: Path) -> Any:
    return YAML(typ="safe", pure=True).load(path.read_text(encoding="utf-8"))


def complaints(found: Any) -> list[str]:
    validator = jsonschema.Draft202012Validator(json.loads(PUBLISHED.read_text(encoding="utf-8")))
    return [error.message for error in validator.iter_errors(found)]


def test_published_schema_is_up_to_date(pytestconfig: pytest.Config) -> None:
    text = json.dumps(schema(), indent=1) + "\n"
    if pytestconfig.getoption("--accept"):
        PUBLISHED.write_text(text, encoding="utf-8")
    jsonschema.Draft202012Validator.check_schema(json.loads(text))
    assert PUBLISHED.read_text(encoding="utf-8") == text, "run pytest tests/scene --accept"


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_scenes_of_the_examples_fit(path: Path) -> None:
    assert complaints(document(path)) == []


@pytest.mark.parametrize("mechanism", ZOO.values(), ids=repr)
def test_saved_scenes_fit(mechanism: Mechanism, tmp_path: Path) -> None:
    path = tmp_path / "scene.yaml"
    mechanism.build().save(path)
    assert complaints(document(path)) == []


def test_every_member_of_the_families_is_there() -> None:
    sections = schema()["properties"]
    for section, family in (("joints", JOINTS), ("forces", FORCES)):
        known = sections[section]["additionalProperties"]["oneOf"]
        assert [one["properties"]["type"]["const"] for one in known] == list(family)


WRONG = (
    "cardan: 3",
    "cardan: 2, extra: 1",
    "cardan: 2, bodies: {a: {mas: 1}}",
    "cardan: 2, bodies: {a: {mass: [1]}}",
    "cardan: 2, bodies: {a: {com: [0, 0]}}",
    "cardan: 2, bodies: {a: {inertia: {rod: {mass: 1}}}}",
    "cardan: 2, joints: {a: {type: revolute}}",
    "cardan: 2, joints: {a: {type: hinge, parent: ground, child: b}}",
    "cardan: 2, parameters: {m: {unit: kg}}",
    "cardan: 2, forces: {a: {type: joint_damper, joint: b}}",
    "cardan: 2, simulate: {end: 3}",
    "cardan: 2, cables: {a: {start: ground, end: [1, 0, 0]}}",
)


@pytest.mark.parametrize("text", WRONG)
def test_schema_and_reader_refuse_the_same(text: str, tmp_path: Path) -> None:
    path = tmp_path / "scene.yaml"
    path.write_text(f"{{{text}}}\n", encoding="utf-8")
    assert complaints(document(path))
    with pytest.raises(CardanError):
        cd.load(path)
