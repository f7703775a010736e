"""Mutants of saved superelements and of matrices of other programs do no harm."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.number_file import packed, unpacked
from cardan.superelements import storage
from hostile.harness import Kind, campaign

SEED = 29
FILES = Path(__file__).parents[1] / "superelements" / "files"
FACES = {"root": [11, 12, 13, 14], "tip": [51, 52, 53, 54]}


def _used(record: cd.superelement.Superelement) -> bytes:
    """Everything that a user asks of a component."""
    parts = [record.M, record.basis, record.modes(["root"]).frequencies, record.modes().bounds]
    parts += [record.impedance([500.0]), record.gravity, record.inertia.matrix()]
    digest = hashlib.sha256(repr(record).encode())
    for part in parts:
        digest.update(np.ascontiguousarray(part).tobytes())
    return digest.digest()


def saved(folder: Path) -> Kind:
    """A component that cardan wrote."""
    folder.mkdir(parents=True)
    matrices = cd.superelement.read(FILES / "bar.sti")
    heat = np.ones(60)
    record = matrices.reduce(FACES, modes=3, damping=0.02, loads={"heat": heat})
    file = record.save(folder / "bar.npz")

    def unpack(content: bytes) -> dict[str, Any]:
        arrays = unpacked(content)
        about = json.loads(str(arrays.pop(storage.ABOUT)))
        del about["sha256"]
        return {"about": about, "arrays": arrays}

    def pack(parts: dict[str, Any]) -> bytes:
        about, arrays = parts["about"], parts["arrays"]
        try:
            about["sha256"] = storage._digest(about, arrays)
            return packed({**arrays, storage.ABOUT: np.array(json.dumps(about))})
        except Exception as error:
            raise ValueError("no such file can be written") from error

    load = cd.superelement.load
    return Kind("superelement", file, load, _used, unpack, pack, lambda place: True)


def matrices(ending: str) -> Callable[[Path], Kind]:
    """A file of CalculiX; its numbers have no hash, so that others give other results."""

    def make(folder: Path) -> Kind:
        folder.mkdir(parents=True)
        for other in (".sti", ".mas", ".dof", ".inp"):
            (folder / f"bar{other}").write_bytes((FILES / f"bar{other}").read_bytes())

        def read(path: Path) -> cd.superelement.ComponentMatrices:
            beside = {"mass": ".mas", "dofs": ".dof", "nodes": ".inp"}
            chosen = {role: folder / f"bar{e}" for role, e in beside.items()}
            chosen |= {role: path for role, e in beside.items() if e == ending}
            main = path if ending == ".sti" else folder / "bar.sti"
            return cd.superelement.read(main, **chosen)

        def use(one: cd.superelement.ComponentMatrices) -> bytes:
            return b"" if one.nodes is None else b"read"

        return Kind(f"matrices {ending}", folder / f"bar{ending}", read, use)

    return make


KINDS = {
    "saved": saved,
    **{ending: matrices(ending) for ending in (".sti", ".mas", ".dof", ".inp")},
}


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", KINDS)
def test_mutants_of_superelements_do_no_harm(name: str, tmp_path: Path) -> None:
    tally = campaign(KINDS[name](tmp_path / "good"), 50, SEED, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", KINDS)
def test_two_thousand_mutants_of_superelements(name: str, tmp_path: Path) -> None:
    tally = campaign(KINDS[name](tmp_path / "good"), 2000, SEED + 1, tmp_path)
    print(tally)
    assert not tally.failures, str(tally)
