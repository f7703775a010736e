"""A manifest that this process wrote is, part by part, the one that another process reads."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import cardan as cd
from cardan.schema import manifest
from cardan.schema.manifest import from_file
from mechanisms import ZOO
from mechanisms.chain import chain
from mechanisms.closed import CLOSED


def different(one: object, other: object, path: str = "it") -> Iterator[str]:
    """Paths of what differs in value or type."""
    if type(one) is not type(other):
        yield f"{path}: {type(one).__name__} and {type(other).__name__}"
    elif isinstance(one, dict) and isinstance(other, dict):
        if list(one) != list(other):
            yield f"{path}: other keys"
            return
        for key, value in one.items():
            yield from different(value, other[key], f"{path}.{key}")
    elif isinstance(one, (list, tuple)) and isinstance(other, (list, tuple)):
        if len(one) != len(other):
            yield f"{path}: {len(one)} and {len(other)}"
            return
        for k, (a, b) in enumerate(zip(one, other, strict=True)):
            yield from different(a, b, f"{path}[{k}]")
    elif hasattr(one, "__dict__"):
        yield from different(vars(one), vars(other), path)
    elif one != other:
        yield f"{path}: {one} and {other}"


def elements() -> cd.FiniteElementEquations:
    return cd.derive(chain(5), coordinates="absolute")


def many() -> cd.Scene:
    """Of so many bodies that the manifest is written without lines."""
    return chain(1100)


SCENES: list[Callable[[], object]] = [
    *(ZOO[name].build for name in ("branched", "satellite", "heavy_tip")),
    *(CLOSED[name].build for name in ("four_bar", "stewart")),
    elements,
    many,
]


@pytest.mark.parametrize("build", SCENES, ids=lambda build: build.__name__)
def test_what_was_written_is_what_is_read(
    build: Callable[[], object], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    model = cd.compile(build(), directory=tmp_path / "model")
    content = (model.directory / "manifest.json").read_bytes()
    assert content in manifest._CONTENTS
    remembered = from_file(content, "here")
    with monkeypatch.context() as patch:
        patch.setattr("cardan.schema.manifest._CONTENTS", {})
        read = from_file(content, "here")
    assert read is not remembered
    assert not list(different(remembered, read))
