"""Files of reduced components: arrays and a text, checked as if somebody else had made them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, fields
from hashlib import sha256
from pathlib import Path

import numpy as np

from ..arguments import checked
from ..arrays import Array, Integers
from ..atomic_file import replaced
from ..errors import ModelError
from ..number_file import packed, plain, unpacked
from ..regular_file import content
from ..version import SUPERELEMENT, VERSION
from .checks import MassProperties, RigidCheck
from .error_bounds import Residuals
from .inertia import ProjectedInertia
from .interfaces import SPIDERS, InterfaceFrame
from .methods import METHODS
from .node_dofs import COMPONENTS, NodeDofs
from .record import SuperelementRecord
from .section_forces import COMPONENTS as SECTION
from .section_forces import BeamSections
from .surface import MOST_POINTS, Surface, sampled
from .values import LARGEST

ABOUT = "about"
# array -> its sizes: n coordinates, b motions of interfaces, 2 n of residuals
SHAPES: dict[str, tuple[str | int, ...]] = {
    "M": ("n", "n"),
    "C": ("n", "n"),
    "K": ("n", "n"),
    "basis": ("rows", "n"),
    "positions": ("nodes", 3),
    "ids": ("nodes",),
    "node": ("rows",),
    "component": ("rows",),
    "frequencies": ("modes",),
    "dropped": ("more modes",),
    "rigid": ("n", "rigid motions"),
    "residual_inner": ("2n", "2n"),
    "residual_boundary": ("b", "2n"),
    "residual_stiffness": ("b", "b"),
    "loads": ("loads", "n"),
    "stress": ("stress", "n"),
    "load_stresses": ("load stresses", "stress"),
    "stations": ("sections",),
    "geometric": ("geometric", "n", "n"),
    "surface_nodes": ("points",),
    "surface_arms": ("points", 3),
    "surface_triangles": ("triangles", 3),
    "surface_lines": ("lines", 2),
    "inertia_mass": (3, 3),
    "inertia_first": (3, 3),
    "inertia_second": (3, 3),
    "inertia_momentum": (3, "n"),
    "inertia_angular": (3, "n"),
    "inertia_spin_momentum": (3, 3, "n"),
    "inertia_spin_angular": (3, 3, "n"),
    "inertia_spin_modal": (3, "n", "n"),
    "inertia_spin_spin": (3, 3, "n", "n"),
    "inertia_modal": ("n", "n"),
}
# names of rows -> the array that has them
NAMED = {
    "loads": "loads",
    "stress_names": "stress",
    "load_stresses": "load_stresses",
    "geometric": "geometric",
}
SYMMETRIC = ("M", "C", "K", "residual_inner", "residual_stiffness", "inertia_modal")
SURFACE = ("surface_nodes", "surface_triangles", "surface_lines")
INTEGERS = ("ids", "node", "component", *SURFACE)


def save(record: SuperelementRecord, path: Path) -> Path:
    """Write a component; the file appears complete or not at all.

    Raises:
        ModelError: the file cannot be written, or its name does not end in ``.npz``.
    """
    if path.suffix != ".npz":
        raise ModelError(f"{path}: superelements are written to files whose ending is .npz")
    n = record.n
    arrays: dict[str, Array | Integers] = {
        "M": record.M,
        "C": record.C,
        "K": record.K,
        "basis": record.basis,
        "positions": record.dofs.positions,
        "ids": record.dofs.ids,
        "node": record.dofs.node,
        "component": record.dofs.component,
        "frequencies": record.frequencies,
        "dropped": record.dropped,
        "rigid": record.rigid,
        "residual_inner": record.residuals.inner,
        "residual_boundary": record.residuals.boundary,
        "residual_stiffness": record.residuals.stiffness,
        "loads": np.array([*record.loads.values()]).reshape(len(record.loads), n),
        "stress": record.stress,
        "load_stresses": np.array([*record.load_stresses.values()]).reshape(
            len(record.load_stresses), len(record.stress)
        ),
        "stations": record.sections.stations,
        "geometric": np.array([*record.geometric.values()]).reshape(-1, n, n),
    }
    for part in ("inertia", "surface"):
        for field in fields(getattr(record, part)):
            arrays[f"{part}_{field.name}"] = getattr(getattr(record, part), field.name)
    about = {
        SUPERELEMENT.word: SUPERELEMENT.version,
        "cardan": VERSION,
        "method": record.method,
        "modes_of": record.modes_of,
        "massless": record.massless,
        "interfaces": [asdict(frame) for frame in record.interfaces],
        "properties": asdict(record.properties),
        "check": asdict(record.check),
        "sound": record.sound,
        "density": record.density,
        "anisotropy": record.anisotropy,
        "loads": [*record.loads],
        "stress_names": [*record.stress_names],
        "load_stresses": [*record.load_stresses],
        "sections": [*record.sections.beams],
        "geometric": [*record.geometric],
        "notes": [*record.notes],
    }
    try:
        _check_arrays(arrays, record.n_boundary)
    except ValueError as error:
        raise ModelError(f"{path}: the component cannot be saved: {error}") from None
    about["sha256"] = _digest(about, arrays)
    with replaced(path) as new:
        Path(new).write_bytes(packed({**arrays, ABOUT: np.array(json.dumps(about))}))
    return path


@checked
def load(path: Path) -> SuperelementRecord:
    """Read a component that :meth:`SuperelementRecord.save` wrote.

    Args:
        path: The ``.npz`` file.

    Returns:
        The component.

    Raises:
        ModelError: no such file, one of another kind or version, or a damaged one.
    """
    try:
        arrays = unpacked(content(path))
        about = plain(str(arrays.pop(ABOUT)).encode()) if ABOUT in arrays else {}
        if not isinstance(about, dict) or SUPERELEMENT.word not in about:
            raise ValueError("it does not say what it holds")
        version = about[SUPERELEMENT.word]
        if not SUPERELEMENT.reads(version):
            raise ModelError(SUPERELEMENT.refusal(path, version, about.get("cardan")))
        stated = about.pop("sha256", None)
        if stated != _digest(about, arrays):
            raise ValueError("its hash differs from that of its content")
        if version == 1:
            _add_surface(arrays)
        if version < 3:
            # these had neither stress of loads nor section forces
            arrays["load_stresses"] = np.zeros((0, len(arrays["stress"])))
            about["load_stresses"] = []
            arrays["stations"], about["sections"] = np.zeros(0), []
        return _record(about, arrays)
    except FileNotFoundError:
        raise ModelError(f"{path}: there is no such file") from None
    except OSError as error:
        raise ModelError(f"{path} cannot be read: {error.strerror}") from None
    except ModelError:
        raise
    except (ValueError, MemoryError, TypeError, KeyError, OverflowError, RecursionError) as error:
        raise ModelError(
            f"{path} is not a superelement of cardan, or is damaged: {error}. Save it again"
        ) from None


def _add_surface(arrays: dict[str, Array | Integers]) -> None:
    """The surface of a file of version 1, which has none: all nodes."""
    nodes = sampled(len(arrays["positions"]))
    arrays["surface_nodes"], arrays["surface_arms"] = nodes, np.zeros((len(nodes), 3))
    arrays["surface_triangles"] = np.zeros((0, 3), np.intp)
    arrays["surface_lines"] = np.zeros((0, 2), np.intp)


def _digest(about: Mapping[str, object], arrays: Mapping[str, Array | Integers]) -> str:
    """Hash of everything that counts."""
    hashed = sha256(json.dumps(about, sort_keys=True).encode())
    for name in sorted(arrays):
        array = np.ascontiguousarray(arrays[name])
        hashed.update(f"{name} {array.dtype.str} {array.shape}".encode())
        hashed.update(array.tobytes())
    return hashed.hexdigest()


def _record(
    about: Mapping[str, object], arrays: Mapping[str, Array | Integers]
) -> SuperelementRecord:
    """The component of a file, every part of it checked.

    Raises:
        ValueError, TypeError, KeyError: it is damaged.
    """
    if {*arrays} != {*SHAPES}:
        raise ValueError(f"it has the arrays {', '.join(sorted(arrays))[:80]}")
    interfaces = tuple(_frame(row) for row in _rows(about["interfaces"]))
    _check_arrays(arrays, sum(len(frame.components) for frame in interfaces))
    texts = {name: _texts(about[name]) for name in (*NAMED, "notes")}
    for name, array in NAMED.items():
        if len({*texts[name]}) != len(texts[name]) or len(texts[name]) != len(arrays[array]):
            raise ValueError(f"'{name}' does not name the rows of '{array}'")
    sections = _texts(about["sections"])
    if len(sections) != len(arrays["stations"]) or len(sections) * len(SECTION) not in (
        0,
        len(arrays["stress"]),
    ):
        raise ValueError("it does not have six rows of stress for each section")
    if not {*texts["load_stresses"]} <= {*texts["loads"]}:
        raise ValueError("'load_stresses' names loads that do not exist")
    method, massless = _text(about["method"]), about["massless"]
    if method not in METHODS or type(massless) is not int or not 0 <= massless <= len(arrays["M"]):
        raise ValueError("its method is unknown")
    properties, check = _table(about["properties"]), _table(about["check"])
    x, y, z = (_triple(row) for row in _rows(properties["inertia"], 3))
    numbers = {name: arrays[name].astype(np.float64) for name in SHAPES if name not in INTEGERS}
    labels = {name: arrays[name].astype(np.intp) for name in INTEGERS}
    return SuperelementRecord(
        method=method,
        **{name: numbers[name] for name in ("M", "C", "K", "basis", "frequencies", "dropped")},
        dofs=NodeDofs(numbers["positions"], labels["ids"], labels["node"], labels["component"]),
        interfaces=interfaces,
        modes_of=_text(about["modes_of"]),
        massless=massless,
        rigid=numbers["rigid"],
        residuals=Residuals(
            numbers["residual_inner"], numbers["residual_boundary"], numbers["residual_stiffness"]
        ),
        properties=MassProperties(
            _triple(properties["masses"]), _triple(properties["center"]), (x, y, z)
        ),
        check=RigidCheck(
            _floats(check["residual"], 6), _floats(check["self_stress"], 6), _text(check["row"])
        ),
        sound=_floats([about["sound"]], 1)[0],
        density=_floats([about["density"]], 1)[0],
        inertia=ProjectedInertia(
            **{one.name: numbers[f"inertia_{one.name}"] for one in fields(ProjectedInertia)}
        ),
        anisotropy=_floats([about["anisotropy"]], 1)[0],
        loads=dict(zip(texts["loads"], numbers["loads"], strict=True)),
        stress=numbers["stress"],
        load_stresses=dict(zip(texts["load_stresses"], numbers["load_stresses"], strict=True)),
        stress_names=texts["stress_names"],
        sections=BeamSections(sections, numbers["stations"]),
        geometric=dict(zip(texts["geometric"], numbers["geometric"], strict=True)),
        surface=Surface(
            labels["surface_nodes"],
            numbers["surface_arms"],
            labels["surface_triangles"],
            labels["surface_lines"],
        ),
        notes=texts["notes"],
    )


def _check_arrays(arrays: Mapping[str, Array | Integers], n_boundary: int) -> None:
    """Refuse arrays whose shapes or numbers do not make a component.

    Raises:
        ValueError: it names the array.
    """
    sizes: dict[str | int, int] = {"b": n_boundary, 2: 2, 3: 3}
    if arrays["M"].ndim == 2:
        sizes["2n"] = 2 * len(arrays["M"])
    for name, shape in SHAPES.items():
        array = arrays[name]
        if array.ndim != len(shape) or array.dtype.kind not in ("iu" if name in INTEGERS else "f"):
            raise ValueError(f"'{name}' has shape {array.shape} of {array.dtype}")
        for size, word in zip(array.shape, shape, strict=True):
            if sizes.setdefault(word, size) != size:
                raise ValueError(f"'{name}' has shape {array.shape}")
        if name not in INTEGERS and not (abs(array) < LARGEST).all():
            raise ValueError(f"'{name}' has entries that no component has")
    if not 0 < n_boundary <= sizes["n"] or not sizes["rows"] or sizes["rigid motions"] > 6:
        raise ValueError("its sizes are not those of a component")
    for name in SYMMETRIC:
        # to the bit, as it was written
        if not np.array_equal(arrays[name], arrays[name].T) and name != "inertia_modal":
            raise ValueError(f"'{name}' is not symmetric")
    node, component, ids = arrays["node"], arrays["component"], arrays["ids"]
    if node.min() < 0 or node.max() >= sizes["nodes"] or component.min() < 0 or component.max() > 5:
        raise ValueError("its rows name nodes that do not exist")
    if len(np.unique(ids)) != len(ids) or abs(ids.astype(np.float64)).max() > 2**62:
        raise ValueError("its nodes have the same numbers")
    if len(np.unique(6 * node.astype(np.int64) + component.astype(np.int64))) != len(node):
        raise ValueError("its rows are not different ones")
    for name, most in zip(SURFACE, ("nodes", "points", "points"), strict=True):
        ends = arrays[name]
        if len(ends) > MOST_POINTS or (
            ends.size and not 0 <= ends.min() <= ends.max() < sizes[most]
        ):
            raise ValueError(f"'{name}' names what does not exist, or too much")


def _table(value: object) -> Mapping[str, object]:
    if not isinstance(value, dict):
        raise ValueError("its text lacks a table")
    return value


def _rows(value: object, count: int | None = None) -> list[object]:
    if not isinstance(value, list) or count not in (None, len(value)):
        raise ValueError("its text lacks a list")
    return value


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise ValueError("its text lacks a name")
    # what cannot be printed raises here
    value.encode("utf-8")
    return value


def _texts(value: object) -> tuple[str, ...]:
    return tuple(_text(one) for one in _rows(value))


def _floats(value: object, count: int) -> tuple[float, ...]:
    numbers = _rows(value, count)
    if not all(type(one) in (int, float) for one in numbers):
        raise ValueError("its text lacks a number")
    return tuple(float(one) for one in numbers)  # type: ignore[arg-type]


def _triple(value: object) -> tuple[float, float, float]:
    x, y, z = _floats(value, 3)
    if not np.isfinite([x, y, z]).all():
        raise ValueError("its text has a number that is not finite")
    return x, y, z


def _frame(value: object) -> InterfaceFrame:
    """An interface."""
    row = _table(value)
    name, rigid, components = _text(row["name"]), _text(row["rigid"]), _texts(row["components"])
    nodes = _rows(row["nodes"])
    sane = not {*components} - {*COMPONENTS} and len({*components}) == len(components) > 0
    if not name or not sane or rigid not in ("node", *SPIDERS):
        raise ValueError("an interface is damaged")
    if not nodes or not all(type(one) is int and abs(one) < 2**62 for one in nodes):
        raise ValueError("an interface names no nodes")
    numbers = tuple(one for one in nodes if isinstance(one, int))
    return InterfaceFrame(name, _triple(row["position"]), components, numbers, rigid)
