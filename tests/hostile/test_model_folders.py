"""Mutants of what a model's folder holds: manifest, saved expressions, tables of elements."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import cardan as cd
from hostile.harness import campaign
from hostile.kinds import MODELS, folder
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
    "servo": {
        "ticks at one time": lambda parts: parts["ticks"][0].update(period=1e-320),
    },
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


@pytest.mark.parametrize("which", MODELS)
def test_a_manifest_that_lacks_a_part(which: str, tmp_path: Path) -> None:
    """Every part that all manifests have is looked for where one is read."""
    kind = folder(f"manifest.json of {which}", tmp_path / "good")
    assert kind.unpack is not None
    assert kind.pack is not None
    whole = kind.unpack(kind.file.read_bytes())
    # what is said only where there is something to say
    parts = set(whole) - {"events", "ticks", "isolated", "projected"}
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
