"""The folder of a model whose elements stand in tables: what the manifest says, and numbers."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ...equations.finite_elements.derivatives import derivative_of, rates_derivative_of
from ...equations.finite_elements.expressions import expression_of
from ...equations.finite_elements.record import BlockKind, FiniteElementRecord, Group, Kind
from ...equations.reading.typesetting import text_of
from ...errors import DerivationError
from ...ir.function import Function
from ...ir.trees.assembly import Form
from ...processes import collector_paused
from ...schema.entries import MultiplierRow, OutputRow
from ...schema.finite_elements import (
    DERIVATIVES,
    FORMULAS,
    RATES,
    ElementKind,
    FiniteElements,
    GroupRow,
    PlaceKind,
    requested_name,
)
from ...schema.manifest import Manifest
from ...schema.mechanism import BeamRow, BodyRow, FrameRow
from ...schema.records import PARTS
from ...schema.tree import Tree
from .. import flat_scene, layout
from ..manifest import Base, common, event_rows, tick_rows
from ..writing import generate
from .manifest_rows import plane_of, rows
from .superelement_surfaces import superelement_rows, surface_files

FILE = "mesh.npz"
# left sides of the formulas of a kind that open the C of a function
IN_HEAD = {
    "balance": ("R_q", "p_q", "R", "p", "sigma", "g", "s", "b_m", "b_f", "b"),
    "energy": ("T", "V"),
}


def base(absolute: FiniteElementRecord, functions: Sequence[str]) -> Base:
    """Manifest before any function is written.

    Args:
        absolute: The equations.
        functions: Names that may be asked for.
    """
    system, places = absolute.system, absolute.places
    coordinates, speeds, joints = rows(absolute)
    data = Manifest(
        **common(system, "absolute", functions),
        coordinates=coordinates,
        speeds=speeds,
        events=event_rows(system),
        ticks=tick_rows(system),
        multipliers=_multipliers(absolute),
        cuts=[],
        joints=joints,
        bodies=[
            BodyRow(name=b.name, parent="ground", parts=[p.name for p in b.parts])
            for b in system.bodies
            if b.parts
        ],
        beams=list(_beams(absolute)),
        superelements=list(superelement_rows(absolute)),
        frames=[_frame(absolute, k) for k in range(len(system.frames))],
        outputs=[OutputRow(name=name, unit=unit) for name, unit in absolute.results],
        quaternions=_quaternions(absolute),
        scene=Tree(parents=[], kinds=[], rotations=[], forces=[], unknown=[]),
        finite_elements=FiniteElements(
            places=[_place(kind) for kind in places.kinds],
            kinds=[_kind(kind, absolute.groups) for kind in absolute.kinds],
            groups=[_group(k, group) for k, group in enumerate(absolute.groups)],
            beam_nodes=_beam_nodes(absolute),
            segments=len(absolute.lines),
            frames="frames__data",
            states=absolute.state_visits.name,
            reference=_reference(absolute),
            power_sources=list(absolute.powers),
            reactions={name: (int(group), int(k)) for name, (group, k) in absolute.joints.items()},
            reaction_frames=_reaction_frames(absolute),
            tree_joints=list(absolute.tree_joints),
            forces={name: (int(group), int(k)) for name, (group, k) in absolute.forces.items()},
        ),
    )
    return Base(data, lambda: saved(absolute))


def saved(absolute: FiniteElementRecord) -> tuple[Form, ...]:
    """Functions of the parameters that the runtime evaluates as they are."""
    jumps = flat_scene.time_jumps(absolute.system)
    some = (jumps,) if jumps is not None else ()
    return (*commons(absolute), absolute.frames.poses, absolute.state_visits, *some)


def commons(absolute: FiniteElementRecord) -> tuple[Function, ...]:
    """Functions that give the data of elements from the parameters, for groups with such data."""
    return tuple(
        replace(group.common, name=common_name(k, group))
        for k, group in enumerate(absolute.groups)
        if group.common is not None
    )


def common_name(k: int, group: Group) -> str:
    """Name of what gives the data of group k by the parameters, "" where nothing does."""
    return f"data_{k}__{group.kind.name}" if group.common is not None else ""


def functions(absolute: FiniteElementRecord) -> tuple[Function, ...]:
    """Functions written as C: those of all kinds of elements and places."""
    kinds: Sequence[Kind | BlockKind] = (*absolute.kinds, *absolute.places.kinds)
    return tuple({f.name: f for kind in kinds for f in kind.functions.values()}.values())


def files(absolute: FiniteElementRecord) -> dict[str, bytes]:
    """Files of numbers, by name."""
    return {FILE: numbers(absolute), **surface_files(absolute)}


def numbers(absolute: FiniteElementRecord) -> bytes:
    """The tables as a file of NumPy; the same bytes for the same tables."""
    tables: dict[str, Any] = {"kind": absolute.places.kind}
    tables |= {f"line_{k}": line for k, line in enumerate(absolute.lines)}
    segments = absolute.system.segments
    tables |= {f"stations_{k}": segment.line.stations for k, segment in enumerate(segments)}
    for k, group in enumerate(absolute.groups):
        tables[f"place_{k}"] = group.places
        names = ("z", "s", "events", "outputs", "powers", "reactions")
        integers = {name: getattr(group, name) for name in names}
        for name, values in {"own": group.attributes, **integers}.items():
            if values is not None:
                tables[f"{name}_{k}"] = values
    room = io.BytesIO()
    with zipfile.ZipFile(room, "w", zipfile.ZIP_DEFLATED) as file:
        for name, table in tables.items():
            # without a date: the same tables are the same bytes
            with file.open(zipfile.ZipInfo(f"{name}.npy"), "w", force_zip64=True) as entry:
                np.lib.format.write_array(entry, np.ascontiguousarray(table), allow_pickle=False)
    return room.getvalue()


@collector_paused()
def write(folder: Path, absolute: FiniteElementRecord, available: Sequence[str]) -> None:
    """Write a model: manifest, tables, and the C of every kind of element.

    Args:
        folder: Made if it does not exist.
        absolute: The equations.
        available: Names of the functions of the whole model.
    """
    files_by_name = files(absolute)
    functions_by_name = {f.name: f for f in functions(absolute)}
    # no word of the model: what its elements share with those of others is compiled once
    notes = {
        f.name: _notes(kind, name) for kind in absolute.kinds for name, f in kind.functions.items()
    }

    def with_functions(manifest: Manifest) -> Manifest:
        missing = layout.missing(folder, list(functions_by_name), manifest)
        chosen = [functions_by_name[name] for name in missing]
        texts = [(generate(f, notes=notes.get(f.name, ())), f) for f in chosen]
        return layout.with_functions(folder, manifest, texts) if texts else manifest

    steps = (partial(layout.with_files, folder, files=files_by_name), with_functions)
    layout.write_model(folder, base(absolute, available), steps)


def add_requested(
    folder: Path, absolute: FiniteElementRecord, keys: Sequence[tuple[str, str | None]]
) -> list[str]:
    """Write functions that derivatives need, as far as they are not there yet.

    Args:
        folder: Of the model.
        absolute: The equations.
        keys: Derivatives with the names of kinds of elements or places, and formulas.

    Returns:
        Their C names.

    Raises:
        DerivationError: something else is asked for, a kind has no such derivative, or a formula
            cannot be read.
    """
    for form, _ in keys:
        if form not in (*DERIVATIVES, *RATES, *FORMULAS):
            raise DerivationError(f"'{form}' is not written for elements in tables")
    symbols = [requested_name(form, of or "") for form, of in keys]
    missing = {*layout.missing(folder, symbols)}
    functions_missing = [
        _requested(absolute, form, of or "", symbol)
        for (form, of), symbol in zip(keys, symbols, strict=True)
        if symbol in missing
    ]
    if functions_missing:
        layout.add_functions(folder, [(generate(f), f) for f in functions_missing])
    return symbols


def _requested(absolute: FiniteElementRecord, form: str, of: str, symbol: str) -> Function:
    if form in FORMULAS:
        return expression_of(absolute, form, of, symbol)
    if form in RATES:
        return rates_derivative_of(next(k for k in absolute.places.kinds if k.name == of), form)
    group = next(group for group in absolute.groups if group.kind.name == of)
    return derivative_of(group.kind, form, group, len(absolute.inputs))


def _notes(kind: Kind, function: str) -> tuple[str, ...]:
    """Formulas of a function of a kind, and the source of the kind, for the head of its C."""
    lefts = IN_HEAD.get(function, ())
    formulas = (line for _, line in kind.formulas if line.partition(" = ")[0] in lefts)
    source = (f"Source: {kind.source}",) if kind.source else ()
    return (*map(text_of, formulas), *source)


def _place(kind: BlockKind) -> PlaceKind:
    return PlaceKind(
        name=kind.name,
        nq=kind.nq,
        nu=kind.nu,
        quaternion=kind.quaternion,
        functions={name: f.name for name, f in kind.functions.items()},
        plane=plane_of(kind),
    )


def _kind(kind: Kind, groups: Sequence[Group]) -> ElementKind:
    group = next(group for group in groups if group.kind.name == kind.name)
    return ElementKind(
        name=kind.name,
        nq=kind.nq,
        nu=kind.nu,
        m=kind.m,
        mp=kind.mp,
        nz=0 if group.z is None else group.z.shape[1],
        ns=0 if group.s is None else group.s.shape[1],
        switched=kind.switched,
        strain=kind.strain,
        **_event_sizes(kind)._asdict(),
        functions={name: f.name for name, f in kind.functions.items()},
        parts=parts(kind.functions),
    )


class _EventSizes(NamedTuple):
    """Numbers of the events of a kind, and of the states that change at them."""

    states: tuple[int, int] = (0, 0)
    ne: int = 0
    jumps: int = 0
    responses: int = 0
    frictions: int = 0


def _event_sizes(kind: Kind) -> _EventSizes:
    outputs = {name: f.outputs for name, f in kind.functions.items()}
    counts = {output.name: output.size for output in outputs.get("change", ())}
    z = outputs["zdot"][0].size if "zdot" in outputs else 0
    sizes = _EventSizes((counts.get("z", z), counts.get("s", 0)))
    if "reaction_friction" in outputs:
        sizes = sizes._replace(frictions=outputs["reaction_friction"][0].size)
    if "signs" in outputs:
        sizes = sizes._replace(ne=next(o.size for o in outputs["signs"] if o.name == "signs"))
    if "jumps" in outputs:
        blocks = {block.name: len(block.entries) for block in kind.functions["jumps"].inputs}
        count = outputs["jumps"][0].shape[0]
        responses = blocks.get("tau", 0) - sizes.frictions
        sizes = sizes._replace(jumps=count, responses=responses)
    return sizes


def parts(functions_by_name: Mapping[str, Function]) -> dict[str, int]:
    """Offsets of the matrices of a tangent in its results."""
    if "balance_tangent" not in functions_by_name:
        return {}
    starts, at = {}, 0
    for output in functions_by_name["balance_tangent"].outputs:
        if output.name in PARTS:
            starts[output.name] = at
        at += output.size
    return starts


def _group(k: int, group: Group) -> GroupRow:
    return GroupRow(kind=group.kind.name, common=common_name(k, group), members=list(group.members))


def _reference(absolute: FiniteElementRecord) -> list[float]:
    """Coordinates of the joints in the reference configuration, as ``states`` takes them."""
    values: list[float] = []
    for joint in absolute.system.joints:
        defaults = [c.default for c in joint.element.coordinates]
        if joint.q >= 0:
            values += joint.q0 if joint.implicit and joint.q0 is not None else defaults
    return [float(x) for x in values]


def _beam_nodes(absolute: FiniteElementRecord) -> list[int]:
    """Places of nodes that only beams hold."""
    implicit = {joint.name for joint in absolute.system.joints if joint.implicit}
    named = len(absolute.places) - len(absolute.inner)
    return [k for k in range(named) if absolute.places.names[k] in implicit]


def _quaternions(absolute: FiniteElementRecord) -> list[int]:
    """First entry of every unit quaternion in q."""
    places = absolute.places
    at = np.array([-1 if k.quaternion is None else k.quaternion for k in places.kinds])
    offsets = at[places.kind] if len(at) else np.zeros(0, dtype=int)
    return [int(start) for start in (places.q[:-1] + offsets)[offsets >= 0]]


def _multipliers(absolute: FiniteElementRecord) -> list[MultiplierRow]:
    """Rows of the multipliers, those of positions first."""
    rows: list[MultiplierRow] = []
    for group in absolute.groups:
        first = [
            MultiplierRow(
                name=f".{row}" if row else "",
                unit=unit,
                joint="",
                level="position" if k < group.kind.mp else "velocity",
                switched=k >= group.kind.m - group.kind.switched,
            )
            for k, (row, unit) in enumerate(group.kind.rows)
        ]
        # those of other members differ by their name alone
        plain = [(row.name, vars(row)) for row in first]
        rows += [
            MultiplierRow.trusted({**entries, "name": f"{member}{end}", "joint": member})
            for member in group.members
            for end, entries in plain
        ]
    return sorted(rows, key=lambda row: row.level != "position")


def _reaction_frames(absolute: FiniteElementRecord) -> dict[str, str]:
    """The child frame, as the user declared it, of every joint with a reaction."""
    system = absolute.system
    children = {
        joint.name: joint.parent_frame if joint.reversed else joint.child_frame
        for joint in system.joints
    }
    children |= {cut.name: cut.child_frame for cut in system.cuts}
    having = {*absolute.joints, *absolute.tree_joints}
    return {n: system.frames[k].name for n, k in children.items() if n in having}


def _beams(absolute: FiniteElementRecord) -> Iterator[BeamRow]:
    """Rows of the segments: ends, first of the q of the nodes between, their number, length."""
    system, places = absolute.system, absolute.places
    # the nodes inside of beams are the last places, in the order of the segments
    at, size = absolute.places.nq - absolute.reference.size, absolute.inner.shape[1]
    for segment, line in zip(system.segments, absolute.lines, strict=True):
        inner = segment.line.elements - 1
        outline = segment.outline
        yield BeamRow(
            name=segment.name,
            start=system.frames[segment.frame_a].name,
            end=system.frames[segment.frame_b].name,
            q=(at, inner),
            outline=(outline.e2, outline.e3, outline.round),
            contour=outline.contour,
            length=float(segment.line.stations[-1] - segment.line.stations[0]),
            plane=plane_of(places.kinds[places.kind[line[1]]]) if inner else None,
        )
        at += size * inner


def _frame(absolute: FiniteElementRecord, k: int) -> FrameRow:
    system, places = absolute.system, absolute.places
    frame, place = system.frames[k], int(absolute.frames.place[k])
    body = system.bodies[frame.body] if frame.body >= 0 else None
    parts = body.parts if body is not None else ()
    fixed = place < 0
    return FrameRow(
        name=frame.name,
        body=body.name if body is not None and parts else "ground",
        part=parts[frame.part].name if parts else None,
        node=None if fixed else (int(places.q[place]), int(places.u[place])),
        tree=absolute.frames.bodies.get(k),
        plane=None if fixed else plane_of(places.kinds[places.kind[place]]),
    )
