"""Read the tables of a model from its folder and load the functions of its kinds."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .... import regular_file
from ....arrays import Array
from ....build_progress import listed, stage
from ....errors import ModelError
from ....number_file import unpacked
from ....schema.c_functions import FunctionRow
from ....schema.finite_elements import JUMP_NUMBERS
from ....schema.manifest import Manifest
from ....schema.records import PARTS
from ...calls.code import Code
from ...calls.lanes import width
from .elements import INNER, Elements
from .mesh import Mesh
from .tables import Table, Tables

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel

FILE = "mesh.npz"
# elements of a group from which on they go side by side: four of a beam take as long alone as eight
# lanes, of which half stay unused
LANE_THRESHOLD = 4
INTEGER_TABLES = ("z", "s", "events", "outputs", "powers", "reactions")


def tables(manifest: Manifest, directory: Path) -> Tables:
    """The tables of a model.

    Raises:
        ModelError: the file with its numbers is missing or damaged.
    """
    try:
        content = regular_file.content(directory / FILE)
        if hashlib.sha256(content).hexdigest() != manifest.sha256.get(FILE):
            raise ValueError("it is not the file its manifest speaks of")
        read = _tables(manifest, unpacked(content))
        _fit(read, manifest)
        _check_mesh(read, manifest)
        return read
    except (OSError, ValueError, KeyError, TypeError, IndexError, AttributeError) as error:
        raise ModelError(f"{directory / FILE} does not hold the elements: {error}") from error


def _fit(read: Tables, manifest: Manifest) -> None:
    """Make sure that the places that the kernels take from tables exist.

    Raises:
        ValueError: one does not.
    """
    kinds, places = len(read.kinds), len(read.kind)
    inside = read.kind.ndim == 1 and bool(np.all((read.kind >= 0) & (read.kind < kinds)))
    sizes = (read.nq, read.nu) if inside else ()
    if sizes != (len(manifest.coordinates), len(manifest.speeds)):
        raise ValueError("its nodes are not those of the coordinates")
    for group in read.groups:
        n = len(group.place)
        limits = (
            (places, group.place),
            (read.nz, group.z),
            (read.ns, group.s),
            (read.ne, group.events),
            (len(manifest.outputs), group.outputs),
            (len(read.powers), group.powers),
            (len(manifest.elements.tree_joints), group.reactions),
        )
        for most, table in limits:
            if table is not None and not (
                table.ndim == 2 and len(table) == n and np.all((table >= 0) & (table < most))
            ):
                raise ValueError(f"an element of '{group.kind.name}' is between no nodes")
        _check_sizes(read, group)
        if group.attributes is not None and (
            group.attributes.ndim != 2 or len(group.attributes) != n
        ):
            raise ValueError(f"the data of '{group.kind.name}' are not those of its elements")


def _check_sizes(elements: Tables, group: Table) -> None:
    """Make sure that elements are as large as what they couple.

    Raises:
        ValueError: they are not.
    """
    kind, sums = group.kind, {}
    for name in ("nq", "nu"):
        sizes = np.array([getattr(each, name) for each in elements.kinds], dtype=np.intp)
        widths = sizes[elements.kind][group.place]
        # kernels take numbers of all elements place by place, as the first of them has them
        sums[name] = np.where(widths == widths[:1], widths, -1).sum(axis=1)
    sums |= {
        name: np.array([0 if table is None else table.shape[1]])
        for name, table in (("nz", group.z), ("ns", group.s), ("ne", group.events))
    }
    for name, sizes in sums.items():
        stated = getattr(kind, name)
        if not np.all(sizes == stated):
            raise ValueError(f"elements of '{kind.name}' have {name} = {stated}")
    if any(first > count for first, count in zip(kind.states, (kind.nz, kind.ns), strict=True)):
        raise ValueError(f"elements of '{kind.name}' keep {kind.states} states")
    if kind.responses > min(kind.jumps, kind.nu):
        raise ValueError(f"elements of '{kind.name}' have {kind.responses} responses")
    if kind.mp > kind.m or kind.switched > kind.m - kind.mp:
        raise ValueError(f"elements of '{kind.name}' have {kind.m} constraints")


def _check_results(elements: Tables, entries: Mapping[str, FunctionRow]) -> None:
    """Make sure that functions give as many numbers as the kernels take from them.

    Raises:
        ValueError: one gives more or less.
    """
    checks: list[tuple[str, Mapping[str, str], dict[str, int]]] = []
    for place in elements.kinds:
        nq, nu = place.nq, place.nu
        sizes = {"move": nq + nu * nu, "qdot": nq}
        right = nq == nu or sizes.keys() <= place.functions.keys()
        if place.node:
            right = (nq, nu) == ((7, 6) if place.plane is None else (3, 3))
        if not right:
            raise ValueError(f"places of '{place.name}' have nq = {nq} and nu = {nu}")
        checks.append((place.name, place.functions, sizes))
    for group in elements.groups:
        kind, nu, m = group.kind, group.kind.nu, group.kind.m
        sizes = {"balance": nu + kind.mp + m, "gamma": m, "energy": 2, "momentum": 6}
        sizes |= {"reaction": 6, "stress": 24, "mixed": nu + nu * nu, "mixed_step": INNER}
        sizes |= {"zdot": kind.states[0], "signs": kind.ne + 1, "change": sum(kind.states)}
        sizes["generalized_momenta"] = 2 * nu
        sizes["jumps"] = kind.jumps * (JUMP_NUMBERS + nu)
        sizes["reaction_friction"] = kind.frictions * (1 + nu + 3 * m)
        sums = {"power": group.powers, "outputs": group.outputs}
        sizes |= {name: 0 if x is None else x.shape[1] for name, x in sums.items()}
        sizes["reactions"] = 0 if group.reactions is None else 6 * group.reactions.shape[1]
        checks.append((kind.name, kind.functions, sizes))
    for what, functions, sizes in checks:
        for name in sizes.keys() & functions.keys():
            if entries[functions[name]].output_size != sizes[name]:
                raise ValueError(f"{name} of '{what}' gives not {sizes[name]} numbers")


def _check_mesh(elements: Tables, manifest: Manifest) -> None:
    """Make sure that what the manifest says about elements is of these.

    Raises:
        ValueError: it is not.
    """
    mesh, available, places = manifest.elements, manifest.functions, len(elements.kind)
    kinds = [group.kind for group in elements.groups]
    functions = [kind.functions for kind in elements.kinds] + [kind.functions for kind in kinds]
    missing = [name for each in functions for name in each.values() if name not in available]
    if missing:
        raise ValueError(f"functions of elements are not there: {missing!r:.80}")
    _check_results(elements, available)
    for kind in kinds:
        most = available[kind.functions["balance_tangent"]].output_size if kind.parts else 0
        for name, start in kind.parts.items():
            size = (kind.m if name in "RGHL" else kind.nu) * (kind.m if name == "H" else kind.nu)
            if name not in PARTS or start > most - size:
                raise ValueError(f"matrices of '{kind.name}' lie outside of its tangent")
    inside = all(_on_places(line, places) for line in elements.beams)
    for right, what in (
        (
            (elements.mp, elements.m) == (manifest.position_rows, len(manifest.multipliers)),
            "multipliers",
        ),
        (inside and len(elements.beams) == len(manifest.beams), "beams"),
        (all(k < places for k in mesh.beam_nodes), "loose nodes"),
        # squares of them are numbers
        (all(abs(x) < 1e150 for x in mesh.reference), "rest"),
    ):
        if not right:
            raise ValueError(f"its {what} are not those of the manifest")


def _on_places(line: Any, places: int) -> bool:
    """True when a line of nodes has places of the model; its ends may be elsewhere."""
    return bool(len(line) > 1 and np.all(line < places) and np.all(line[1:-1] >= 0))


def _tables(manifest: Manifest, numbers: Mapping[str, Any]) -> Tables:
    elements = manifest.elements
    kinds = {kind.name: kind for kind in elements.kinds}
    groups = tuple(
        Table(
            kind=kinds[row.kind],
            place=numbers[f"place_{k}"].astype(np.intp),
            common=row.common,
            attributes=numbers.get(f"own_{k}"),
            members=row.members,
            **{name: _integers(numbers.get(f"{name}_{k}")) for name in INTEGER_TABLES},
        )
        for k, row in enumerate(elements.groups)
    )
    return Tables(
        kinds=tuple(elements.places),
        kind=numbers["kind"].astype(np.intp),
        groups=groups,
        nr=len(manifest.inputs),
        nz=len(manifest.z),
        ns=len(manifest.s),
        ne=len(manifest.events),
        beams=tuple(numbers[f"line_{k}"].astype(np.intp) for k in range(elements.segments)),
        stations=tuple(numbers[f"stations_{k}"] for k in range(elements.segments)),
        powers=tuple(elements.power_sources),
        outputs=len(manifest.outputs),
    )


def _integers(array: Any) -> Any:
    return None if array is None else array.astype(np.intp)


def tables_of(model: LoadedModel) -> Tables:
    """The tables of a model, read once for all of its sets of parameters."""
    objects = model._objects
    with objects.lock:
        if objects.tables is None:
            objects.tables = tables(model.manifest, model.directory)
            objects.lanes = _side_by_side(objects.tables, model.manifest.functions)
        loaded: Tables = objects.tables
        return loaded


def _side_by_side(elements: Tables, entries: Mapping[str, FunctionRow]) -> dict[str, int]:
    """Functions that are compiled for elements side by side, by C name, and for how many."""
    lanes = width()
    kinds = [group.kind for group in elements.groups if len(group) >= LANE_THRESHOLD]
    symbols = [symbol for kind in kinds for symbol in kind.functions.values()]
    return {symbol: lanes for symbol in symbols if 1 < lanes in entries[symbol].lanes}


def data_of(model: LoadedModel, group: Table) -> Array:
    """Data (n, k) of the elements of a group at the parameters of a model."""
    n, parts = len(group), []
    if group.common:
        values = model._evaluate_saved(group.common, p=model.parameters.vector)
        common = np.asarray(values["data"], dtype=np.float64)
        # (k,) for all of them, or (n, k)
        parts.append(np.broadcast_to(common, (n, common.shape[-1])))
    if group.attributes is not None:
        parts.append(group.attributes)
    return np.ascontiguousarray(np.concatenate(parts, axis=1)) if parts else np.zeros((n, 0))


def load(model: LoadedModel) -> Mesh:
    """The elements of a model at its parameters, ready to be asked."""
    objects = model._objects
    with objects.lock:
        if objects.mesh is None:
            objects.mesh = model.parameters.vector.copy(), _loaded(model)
        vector, first = objects.mesh
    mesh: Mesh = first
    changed = {*np.flatnonzero(model.parameters.vector != vector).tolist()}
    groups = zip(mesh.tables.groups, mesh.data, strict=True)
    return mesh.with_data(
        [
            data if changed.isdisjoint(entries_read(model, group.common)) else data_of(model, group)
            for group, data in groups
        ]
    )


def entries_read(model: LoadedModel, saved: str, block: str = "p") -> frozenset[int]:
    """Numbers of the entries of a block that a saved function reads; "" reads none."""
    if not saved:
        return frozenset()
    read = model._objects.entries_read
    if (saved, block) not in read:
        read[saved, block] = model._objects.form(saved).entries_read(block)
    return read[saved, block]


def _loaded(model: LoadedModel) -> Mesh:
    """The same with all functions and data read."""
    group_tables = tables_of(model)
    objects = model._objects

    def codes(symbols: Sequence[str]) -> dict[str, Code]:
        """Functions of elements, several compiled at once."""
        names = list(dict.fromkeys(symbols))
        with objects.lock:
            return dict(zip(names, objects.load(names), strict=True))

    def judge(elements: Elements, fresh: Sequence[str]) -> None:
        """Functions of elements that pass their check are found by other processes."""
        try:
            with stage(f"model '{model.name}': checking {listed(fresh)}"):
                model._verify_elements(elements, fresh)
            for symbol in fresh:
                objects.publish(symbol)
        except BaseException:
            objects.forget(fresh)
            raise

    data = [data_of(model, group) for group in group_tables.groups]
    # of the model: whoever loads its functions holds it already
    lock, entries = objects.lock, model.manifest.functions
    lanes = max(objects.lanes.values(), default=1)
    return Mesh(group_tables, entries, codes, data, lanes, model._kernels(), lock, judge)
