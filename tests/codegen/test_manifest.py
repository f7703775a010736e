"""The manifest: valid against its published schema, complete, true."""

import json
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

import cardan as cd
from cardan.codegen import flat_scene, generate, layout, manifest
from cardan.equations.record import EquationRecord
from cardan.ir.interpreter import evaluate
from cardan.ir.serialize import from_dict
from cardan.schema.fields import dumped
from cardan.schema.manifest import json_schema
from codegen.models import arm
from mechanisms import ZOO

PAGE = Path(__file__).parents[2] / "docs" / "manifest.schema.json"
SCHEMA = json.loads(json_schema())


def written(folder: Path, equations: EquationRecord, *names: str) -> dict[str, Any]:
    """The manifest of a model with some functions, read from disk."""
    layout.write_model(folder, manifest.base(equations, names))
    made = [(generate(equations.function(n)), equations.function(n)) for n in names]
    layout.add_functions(folder, made)
    found: dict[str, Any] = json.loads((folder / "manifest.json").read_text("utf-8"))
    return found


def undocumented(data: Any, schema: dict[str, Any], where: str = "") -> list[str]:
    """Entries of the data that the schema does not name."""
    if "anyOf" in schema:
        schema = next((s for s in schema["anyOf"] if s.get("type") != "null"), {})
    if isinstance(data, list):
        return [w for x in data for w in undocumented(x, schema.get("items", {}), where + "[]")]
    if not isinstance(data, dict) or "properties" not in schema:
        return []
    known = schema["properties"]
    found = [f"{where}.{name}" for name in data if name not in known]
    for name in data.keys() & known.keys():
        found += undocumented(data[name], known[name], f"{where}.{name}")
    return found


def test_schema_is_a_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


def test_published_schema_is_that_of_the_records(pytestconfig: pytest.Config) -> None:
    """``pytest tests/codegen/test_manifest.py --accept`` writes it anew."""
    if pytestconfig.getoption("--accept"):
        PAGE.write_text(json_schema(), "utf-8")
    assert PAGE.read_text("utf-8") == json_schema()


def test_what_is_written_is_what_is_read(tmp_path: Path) -> None:
    base = manifest.base(cd.derive(arm()), ["bias"])
    layout.write_model(tmp_path, base)
    again = layout.manifest_of(tmp_path)
    assert dumped(again.replaced(sha256={})) == dumped(base.data)
    assert again.joints[1].limits == {"lower": -2.0, "upper": 2.0}
    with pytest.raises(AttributeError):
        again.joints[1].name = "other"  # type: ignore[misc]


@pytest.mark.parametrize("mechanism", ZOO.values(), ids=str)
def test_zoo_is_valid_and_documented(mechanism: Any, tmp_path: Path) -> None:
    data = written(tmp_path, cd.derive(mechanism.build()), "inverse_dynamics")
    jsonschema.validate(data, SCHEMA)
    # shapes may say more: their measures depend on the kind
    assert undocumented({k: v for k, v in data.items() if k != "shapes"}, SCHEMA) == []


def test_names_stand_in_the_order_of_the_arrays(tmp_path: Path) -> None:
    equations = cd.derive(arm())
    data = written(tmp_path, equations, "forward_dynamics")
    assert tuple(row["name"] for row in data["coordinates"]) == equations.coordinates
    assert tuple(row["name"] for row in data["speeds"]) == equations.speeds
    assert tuple(row["name"] for row in data["parameters"]) == equations.parameters
    for joint in data["joints"]:
        for block, rows in (("q", "coordinates"), ("u", "speeds")):
            start, size = joint.get(block, (0, 0))
            assert all(r["joint"] == joint["name"] for r in data[rows][start : start + size])
    spin = next(j for j in data["joints"] if j["name"] == "spin")
    assert spin["prescribed"]
    assert "q" not in spin
    assert data["quaternions"] == [0]
    assert data["fixed"] == ["flange"]
    assert data["bodies"][2] == {"name": "lower", "parent": "upper", "parts": ["lower", "tool"]}
    assert data["joints"][1]["limits"] == {"lower": -2.0, "upper": 2.0}


def test_saved_functions_are_the_functions(tmp_path: Path) -> None:
    equations = cd.derive(arm())
    written(tmp_path, equations, "mass_matrix", "bias")
    saved = json.loads((tmp_path / "functions.json").read_text("utf-8"))
    poses = {f"scene_pose_{k}" for k in range(4)}
    others = {"scene", "scene_motion", "applied_forces", "wrenches"}
    assert set(saved) == {*others, *poses, "mass_matrix", "bias"}
    rng = np.random.default_rng(5)
    p = [parameter.value for parameter in equations.system.parameters]
    q, u = rng.uniform(-1, 1, 9), rng.uniform(-1, 1, 8)
    given = {"p": p, "q": q, "u": u, "t": [0.2]}
    again = evaluate(from_dict(saved["bias"]), given)
    assert again == evaluate(equations.function("bias"), given)


def test_flat_scene_holds_masses_and_frames() -> None:
    system = cd.derive(arm()).system
    p = [parameter.value for parameter in system.parameters]
    scene = evaluate(flat_scene.scene(system), {"p": p}, "numpy")
    assert scene["mass"].tolist() == [5.0, 2.0, 1.3, 0.2]
    # the tool is 0.4 below the lower arm, its center of mass 0.1 above that
    assert np.allclose(scene["first_moment"][2], [0, 0.3 * 0.02, -0.2 + 0.3 * (0.1 - 0.4)])
    assert scene["gravity"].tolist() == [0, 0, -9.81]
    assert np.allclose(scene["position"][2], [0, 0, -0.5])
    assert scene["axis"][1:].tolist() == [[0, 1, 0], [0, 0.6, 0.8], [1, 0, 0]]
    assert np.allclose(scene["inertia"], np.swapaxes(scene["inertia"], 1, 2))
    assert scene["frame_position"].shape == (len(system.frames), 3)
    motion = flat_scene.scene_motion(system)
    assert motion is not None
    rows = evaluate(motion, {"t": [0.5], "p": p}, "numpy")["motion"]
    assert rows.tolist() == [[0, 0, 0], [0, 0, 0], [0, 0, 0], [1.5, 3.0, 0.0]]


def test_nothing_prescribed_means_no_motion_function() -> None:
    assert flat_scene.scene_motion(cd.derive(ZOO[next(iter(ZOO))].build()).system) is None
