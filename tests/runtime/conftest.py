"""A private compile cache for tests that look into it or harm it, and the hand-made pendulum."""

from __future__ import annotations

from pathlib import Path

import pytest

from cardan.api.compiled_model import CompiledModel
from cardan.build import cache_folder
from cardan.runtime.calls import abi, abi_ctypes, interpreted
from runtime import pendulum

try:
    from cardan.runtime.calls import _abi
except ImportError:
    _abi = None

WAYS = ["ctypes"] + (["cython"] if _abi else [])


@pytest.fixture
def cache_directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache, and no temporary one beside it."""
    path = tmp_path / "cache"
    monkeypatch.setenv("CARDAN_CACHE", str(path))
    monkeypatch.setattr(cache_folder, "_SCRATCH", {})
    for remembered in (cache_folder._usable, cache_folder._temporary, interpreted.announce):
        remembered.cache_clear()
    return path


@pytest.fixture(params=WAYS)
def way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Both ways into the C, one after the other."""
    use(request.param, monkeypatch)
    return str(request.param)


def use(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Call through one of the two ways."""
    module = abi_ctypes if name == "ctypes" else _abi
    for function in ("run", "prepare", "first_bad", "fast"):
        monkeypatch.setattr(abi, function, getattr(module, function))


@pytest.fixture
def directory(tmp_path: Path) -> Path:
    """The model directory of the pendulum."""
    return pendulum.write(tmp_path / "model")


@pytest.fixture
def model(directory: Path) -> CompiledModel:
    """The pendulum: m = 2 kg, l = 0.5 m, g = 9.81 m/s²."""
    return CompiledModel(directory)
