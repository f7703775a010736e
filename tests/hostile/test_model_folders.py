"""Mutants of what a model's folder holds: manifest, saved expressions, tables of elements."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.number_file import packed, unpacked
from cardan.schema.manifest import checked_manifest
from hostile.harness import campaign
from hostile.kinds import FILES, MODELS, folder
from spread import some

SEED = 17
NAMES = [
    "manifest.json of servo",
    "manifest.json of double",
    "manifest.json of linkage",
    "manifest.json of shaft",
    "functions.json of double",
    "mesh.npz of shaft",
]


@pytest.mark.parametrize("name", some(NAMES, every=4))
def test_mutants_of_folders_of_models_do_no_harm(name: str, tmp_path: Path) -> None:
    tally = campaign(folder(name, tmp_path / "good"), 50, SEED, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


def elements(parts: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = parts["finite_elements"]
    return found


def kinds(parts: dict[str, Any]) -> list[dict[str, Any]]:
    return list(elements(parts)["kinds"])


# what ended in errors from below, or crashed; by hand, as what a seed draws depends on what was
# compiled before
CHANGES: dict[str, dict[str, Callable[[dict[str, Any]], object]]] = {
    "linkage": {
        "cuts of another type": lambda parts: parts.update(cuts=1.5),
        "no cuts": lambda parts: parts.update(cuts=None),
        "a multiplier twice": lambda parts: parts["multipliers"].append(parts["multipliers"][1]),
        "a joint without limits": lambda parts: parts["joints"][0].pop("limits"),
        "a coordinate without unit": lambda parts: parts["coordinates"][1].pop("unit"),
        "a parameter less": lambda parts: parts["parameters"].pop(0),
    },
    "servo": {"ticks at one time": lambda parts: parts["ticks"][0].update(period=1e-320)},
    "shaft": {
        "modes beyond all memory": lambda parts: kinds(parts)[4].update(ns=2**62),
        "rows below none": lambda parts: kinds(parts)[2].update(mp=-1),
        "more coordinates than nodes have": lambda parts: kinds(parts)[1].update(nq=8),
        "a tangent elsewhere": lambda parts: kinds(parts)[1]["parts"].update(K=10**6),
        "a tangent that ends elsewhere": lambda parts: kinds(parts)[2]["parts"].update(K=2),
        "no such function": lambda parts: kinds(parts)[1]["functions"].update(mixed="t"),
        "no such place": lambda parts: elements(parts).update(beam_nodes=[3]),
        "no places": lambda parts: elements(parts).update(beam_nodes=None),
        "powers without names": lambda parts: elements(parts).update(power_sources=[1, 2]),
        "frames without name": lambda parts: elements(parts).update(frames=1.5),
        "frames that nobody knows": lambda parts: elements(parts).update(frames="nowhere"),
        "a node at rest without size": lambda parts: elements(parts)["reference"].insert(0, -1e300),
        "a frame less": lambda parts: parts["frames"].pop(),
        "no frames": lambda parts: parts.update(frames=[]),
        "a domain of another type": lambda parts: parts["joints"][0].update(domain=[1]),
        "a beam twice": lambda parts: parts["beams"].append(parts["beams"][0]),
        "no parameters": lambda parts: parts.update(parameters=[]),
    },
}


@pytest.mark.parametrize(
    ("which", "change"), [(which, change) for which in CHANGES for change in CHANGES[which]]
)
def test_manifests_that_did_harm_once(which: str, change: str, tmp_path: Path) -> None:
    kind = folder(f"manifest.json of {which}", tmp_path / "good")
    assert kind.unpack is not None
    assert kind.pack is not None
    parts = kind.unpack(kind.file.read_bytes())
    CHANGES[which][change](parts)
    kind.file.write_bytes(kind.pack(parts))
    with pytest.raises(cd.CardanError):
        kind.use(kind.read(kind.file))


def kind_of(parts: dict[str, Any], name: str) -> dict[str, Any]:
    (found,) = (kind for kind in kinds(parts) if kind["name"] == name)
    return found


def narrower(numbers: dict[str, Any], name: str) -> None:
    """A table of elements has a column less."""
    for key in [key for key in numbers if key.startswith(f"{name}_")]:
        numbers[key] = numbers[key][:, 1:]


# what the kernels would take from where nothing is, or put there
COUNTS: dict[str, Callable[[dict[str, Any], dict[str, Any]], object]] = {
    "a balance of two numbers": lambda parts, numbers: kind_of(parts, "body")["functions"].update(
        balance=kind_of(parts, "body")["functions"]["energy"]
    ),
    "one energy": lambda parts, numbers: kind_of(parts, "joint_force")["functions"].update(
        energy=kind_of(parts, "joint_force")["functions"]["power"]
    ),
    "a motion without tangent": lambda parts, numbers: elements(parts)["places"][0][
        "functions"
    ].update(move=elements(parts)["places"][0]["functions"]["qdot"]),
    "more coordinates than speeds": lambda parts, numbers: elements(parts)["places"].append(
        {"name": "line2", "nq": 8, "nu": 1}
    ),
    "fewer outputs": lambda parts, numbers: narrower(numbers, "outputs"),
    "fewer powers": lambda parts, numbers: narrower(numbers, "powers"),
    "a place below the first": lambda parts, numbers: numbers.update(
        place_0=np.pad(numbers["place_0"], ((0, 0), (0, 1)), constant_values=-1)
    ),
    "places the other way around": lambda parts, numbers: numbers.update(
        place_1=np.stack([numbers["place_1"][0], numbers["place_1"][1][::-1]])
    ),
}


@pytest.mark.parametrize("change", COUNTS)
def test_counts_are_what_kernels_take(change: str, tmp_path: Path) -> None:
    scene = cd.Scene("counted")
    bodies = [scene.body(name, mass=1, inertia=(1, 1, 1)) for name in ("arm", "hand", "tip")]
    scene.joint("float", cd.Free(), scene.ground, bodies[0])
    for name, ends in (("hinge", bodies[:2]), ("other", bodies[1:])):
        scene.joint(name, cd.Revolute("y"), *ends)
    scene.force("friction", cd.JointForce("hinge", -scene.u("hinge")))
    scene.output("angle", scene.q("hinge"))
    file = cd.compile(scene, coordinates="absolute", directory=tmp_path).directory / "manifest.json"
    unpack, pack = FILES["manifest.json"]
    mesh = file.with_name("mesh.npz")
    parts, numbers = unpack(file.read_bytes()), unpacked(mesh.read_bytes())
    COUNTS[change](parts, numbers)
    mesh.write_bytes(packed(numbers))
    parts["sha256"][mesh.name] = hashlib.sha256(mesh.read_bytes()).hexdigest()
    file.write_bytes(pack(parts))
    with pytest.raises(cd.ModelError, match="does not hold the elements"):
        cd.load_model(tmp_path).prepare("rhs")


@pytest.mark.parametrize("key", ["coordinates", "speeds", "joints"])
def test_a_manifest_cannot_speak_of_more_rows_than_it_has_numbers(key: str) -> None:
    unpack, _ = FILES["manifest.json"]
    parts = unpack((MODELS["shaft"][0]().directory / "manifest.json").read_bytes())
    run = {"count": 2**39, "pattern": parts[key][-1:], "values": ""}
    parts[key] = {"listed": parts[key], "runs": [run]}
    with pytest.raises(cd.ModelError, match="it has more"):
        checked_manifest(parts, "manifest.json")


@pytest.mark.parametrize("which", MODELS)
def test_a_manifest_that_lacks_a_part(which: str, tmp_path: Path) -> None:
    """Every part that all manifests have is looked for where one is read."""
    kind = folder(f"manifest.json of {which}", tmp_path / "good")
    assert kind.unpack is not None
    assert kind.pack is not None
    whole = kind.unpack(kind.file.read_bytes())
    # what is said only where there is something to say
    parts = set(whole) - {
        *("events", "ticks", "isolated", "projected"),
        *("forces", "element_forces", "limits"),
    }
    assert parts > {"method", "structural", "fixed", "shapes", "scene", "available"}
    for name in parts:
        kind.file.write_bytes(kind.pack({k: v for k, v in whole.items() if k != name}))
        with pytest.raises(cd.ModelError, match=r"manifest.json"):
            kind.read(kind.file)


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_two_thousand_mutants_of_folders_of_models(name: str, tmp_path: Path) -> None:
    tally = campaign(folder(name, tmp_path / "good"), 2000, SEED + 1, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


def test_a_function_that_a_manifest_lost() -> None:
    """Where a folder was removed while it was used, a KeyError came out."""
    model = MODELS["double"][0]()
    with pytest.raises(cd.BuildError, match="its manifest has no function 'nowhere'"):
        model._objects.text_path("nowhere")
