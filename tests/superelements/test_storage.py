"""Files of components: what was saved is loaded, what is damaged or forged is refused."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.number_file import packed, unpacked
from cardan.superelements import storage
from superelements.components import beam


def saved(path: Path) -> Any:
    stress = np.eye(2, 51)
    record = beam(
        modes=2,
        damping=0.01,
        loads={"heat": np.ones(51)},
        stress=stress,
        geometric={"a": np.eye(51)},
    )
    record.save(path / "beam.npz")
    return record


def flat(record: Any) -> dict[str, Any]:
    """Fields of a record and of the records in it."""
    result = {}
    for field in dataclasses.fields(record):
        value = getattr(record, field.name)
        if dataclasses.is_dataclass(value):
            result |= {f"{field.name}.{k}": x for k, x in flat(value).items()}
        else:
            result[field.name] = value
    return result


def test_a_saved_component_is_what_it_was(tmp_path: Path) -> None:
    record = saved(tmp_path)
    again = cd.superelement.load(tmp_path / "beam.npz")
    one, other = flat(record), flat(again)
    assert one.keys() == other.keys()
    for name, value in one.items():
        if isinstance(value, np.ndarray | dict | float):
            np.testing.assert_equal(other[name], value)
        else:
            assert other[name] == value
    assert repr(again) == repr(record)


def forged(path: Path, change: Any) -> Path:
    """A file with other content and the hash of that."""
    arrays = unpacked((path / "beam.npz").read_bytes())
    about = json.loads(str(arrays.pop("about")))
    del about["sha256"]
    change(arrays, about)
    about["sha256"] = storage._digest(about, arrays)
    file = path / "forged.npz"
    file.write_bytes(packed({**arrays, "about": np.array(json.dumps(about))}))
    return file


def _set(name: str, place: Any, value: Any) -> Any:
    def change(arrays: dict[str, Any], about: dict[str, Any]) -> None:
        arrays[name] = arrays[name].copy()
        arrays[name][place] = value

    return change


FORGERIES: dict[str, Any] = {
    "nan": _set("K", (0, 0), np.nan),
    "unsymmetric": _set("M", (0, 1), 7.0),
    "node": _set("node", 3, 99),
    "component": _set("component", 3, 6),
    "twice": _set("component", 0, 1),
    "shape": lambda arrays, about: arrays.update(basis=arrays["basis"][:-1]),
    "kind": lambda arrays, about: arrays.update(ids=arrays["ids"].astype(float)),
    "missing": lambda arrays, about: arrays.pop("rigid"),
    "method": lambda arrays, about: about.update(method="guess"),
    "massless": lambda arrays, about: about.update(massless=1e9),
    "names": lambda arrays, about: about.update(loads=["a", "b"]),
    "load stresses": lambda arrays, about: about.update(load_stresses=["a"]),
    "interfaces": lambda arrays, about: about.update(interfaces=[]),
    "frame": lambda arrays, about: about["interfaces"][0].update(components=["x", "x", "rz"]),
    "position": lambda arrays, about: about["interfaces"][0].update(position=[0, 0]),
    "text": lambda arrays, about: about.update(notes=[3]),
    "number": lambda arrays, about: about.update(sound="fast"),
    "table": lambda arrays, about: about.update(properties=[]),
    "deep": lambda arrays, about: about.update(check={}),
}


def test_a_forged_component_is_refused(tmp_path: Path) -> None:
    saved(tmp_path)
    assert cd.superelement.load(forged(tmp_path, lambda arrays, about: None))
    for change in FORGERIES.values():
        file = forged(tmp_path, change)
        with pytest.raises(cd.ModelError, match=r"forged\.npz is not a superelement"):
            cd.superelement.load(file)
    newer = forged(tmp_path, lambda arrays, about: about.update(superelement=4, cardan="9"))
    with pytest.raises(cd.ModelError, match=r"superelement format 4.*reduce its matrices again"):
        cd.superelement.load(newer)


def test_files_before_stresses_of_loads(tmp_path: Path) -> None:
    def earlier(arrays: dict[str, Any], about: dict[str, Any]) -> None:
        del arrays["load_stresses"], about["load_stresses"]
        about["superelement"] = 2

    saved(tmp_path)
    again = cd.superelement.load(forged(tmp_path, earlier))
    assert again.load_stresses == {}
    assert [*again.loads] == [*cd.superelement.load(tmp_path / "beam.npz").loads]


def test_a_damaged_component_is_refused(tmp_path: Path) -> None:
    saved(tmp_path)
    content = (tmp_path / "beam.npz").read_bytes()
    random = np.random.default_rng(11)
    for _ in range(60):
        damaged = bytearray(content)
        place = int(random.integers(len(content)))
        damaged[place] ^= int(random.integers(1, 256))
        file = tmp_path / "damaged.npz"
        file.write_bytes(bytes(damaged[: int(random.integers(10, len(content) + 1))]))
        with pytest.raises(cd.ModelError, match=r"damaged\.npz"):
            cd.superelement.load(file)
    with pytest.raises(cd.ModelError, match="there is no such file"):
        cd.superelement.load(tmp_path / "none.npz")
    with pytest.raises(cd.ModelError, match=r"end in one of \.npz"):
        beam(modes=1).save(tmp_path / "beam.txt")
