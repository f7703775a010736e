"""Tables of a system: bodies, coordinates, speeds, parameters, inputs, frames."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ..elements.joints.joint import entries
from ..equations.functions import blocks
from . import content as d
from .facts import poses

if TYPE_CHECKING:
    from ..equations.record import EquationRecord
    from ..topology.system import System

UNTURNED = np.eye(3)


def coordinates(equations: EquationRecord) -> Iterator[d.Section]:
    """Coordinates and speeds with the symbols that formulas use for them."""
    system = equations.system
    rows_of_blocks = blocks.coordinates(system)
    if not rows_of_blocks:
        return
    kinds = _by_coordinate(system)
    content: list[d.Block] = [
        d.Table(
            ("coordinate", "symbol", "joint", "unit", "default"),
            tuple(
                (name, _symbol(name), kinds[name], unit(of), float(default))
                for name, of, default in rows_of_blocks
            ),
        )
    ]
    block = equations.blocks["u"]
    content.append(
        d.Table(
            ("speed", "symbol", "unit"),
            tuple(
                (name, _symbol(name), unit(of))
                for name, of in zip(block.entries, block.units, strict=True)
            ),
        )
    )
    states = blocks.internals(system)
    if states:
        rows = tuple((name, unit(of), float(default)) for name, of, default in states)
        content.append(d.Table(("internal state", "unit", "default"), rows))
    modes = blocks.discrete(system)
    if modes:
        rows = tuple(
            (name, ", ".join(f"{n} {word}" for n, word in mode.labels), float(mode.default))
            for name, mode in modes
        )
        content.append(d.Table(("mode", "values", "default"), rows))
    yield d.Section("Coordinates and speeds", tuple(content))


def parameters(system: System) -> Iterator[d.Section]:
    """Numbers that can be changed, and inputs."""
    content: list[d.Block] = []
    if system.parameters:
        rows = tuple(
            (p.name, _symbol(p.name), unit(p.unit), float(p.value)) for p in system.parameters
        )
        declared = sum(p.declared for p in system.parameters)
        if declared < len(rows):
            said = "numbers of the scene, under the names of what they belong to"
            said = f"The first {declared} are declared, the others " * bool(declared) + said
            content.append(d.Paragraph((said[0].upper() + said[1:] + ".",), quiet=True))
        content.append(d.Table(("parameter", "symbol", "unit", "default"), rows))
    if system.inputs:
        rows = tuple(
            (r.name, _symbol(r.name), unit(r.unit), float(r.default)) for r in system.inputs
        )
        content.append(d.Table(("input", "symbol", "unit", "default"), rows))
    if content:
        yield d.Section("Parameters", tuple(content))


def frames(system: System) -> Iterator[d.Section]:
    """Poses of frames on their bodies, in the axes in which the equations are written."""
    rows = tuple(
        (frame.name, _body(system, frame.body), _vector(position), _axes(rotation))
        for frame, position, rotation in zip(system.frames, *poses(system), strict=True)
        # bodies without parts only stand for joints
        if frame.body < 0 or system.bodies[frame.body].parts
    )
    said = (
        "Origins and axes relative to the axes of the joint that carries the body, at the default "
        "parameters. A turn is given by axis and angle.",
    )
    table = d.Table(("frame", "body", "position [m]", "axes"), rows)
    yield d.Section("Frames", (d.Paragraph(said, quiet=True), table))


def operations(equations: EquationRecord) -> Iterator[d.Section]:
    """Operation counts of functions by owner."""
    counts = equations.operations
    names = tuple(counts)
    heads = tuple(name.replace("_", " ") for name in names)
    kinds = (("multiplications", ("mul",)), ("additions", ("add", "sub")), ("divisions", ("div",)),
             ("sines and cosines", ("sin", "cos")))  # fmt: skip
    rows: list[d.Cells] = [
        (kind, *(sum(counts[name].get(op, 0) for op in ops) for name in names))
        for kind, ops in kinds
    ]
    rows.append(("all", *(counts[name].total for name in names)))
    rows.append(("of parameters alone, once", *(counts[name].prepared for name in names)))
    owners = dict.fromkeys(owner for name in names for owner in counts[name].blocks)
    shares: tuple[d.Cells, ...] = tuple(
        (
            OWNERS.get(owner, owner),
            *(sum(counts[name].blocks.get(owner, {}).values()) for name in names),
        )
        for owner in sorted(owners, key=lambda owner: (owner in OWNERS, list(owners).index(owner)))
    )
    said = "Operations of the C functions at every call, and for which body, joint or force."
    yield d.Section(
        "Operations",
        (
            d.Paragraph((said,), quiet=True),
            d.Table(("", *heads), tuple(rows)),
            *([d.Table(("for", *heads), shares)] if shares else []),
        ),
    )


_RAISED = str.maketrans({"2": "²", "3": "³", "*": "·", "^": None, " ": "\u00a0"})


def unit(name: str) -> str:
    """A unit as it is printed: m/s², N·m."""
    return name.translate(_RAISED)


OWNERS = {"shared": "shared by several", "": "others"}


def _symbol(name: str) -> d.Math:
    import sympy

    return d.Math(sympy.Symbol(name))


def _by_coordinate(system: System) -> dict[str, str]:
    """Coordinate -> its joint, and of what kind that is."""
    kinds = {}
    for joint in system.joints:
        if joint.q >= 0:
            for name in entries(joint.name, joint.element.coordinates):
                kind = joint.element.kind.replace("_", " ")
                kinds[name] = kind if name == joint.name else f"{joint.name}, {kind}"
    return kinds


def _body(system: System, body: int) -> str:
    return "ground" if body < 0 else system.bodies[body].name


def _vector(x: Any) -> str:
    return ", ".join(f"{value + 0.0:.5g}" for value in np.where(np.abs(x) < 1e-12, 0.0, x))


def _axes(rotation: Any) -> str:
    """A rotation in words."""
    if np.allclose(rotation, UNTURNED, atol=1e-12):
        return "as the body's"
    angle = float(np.arccos(np.clip((np.trace(rotation) - 1) / 2, -1.0, 1.0)))
    symmetric = (rotation + rotation.T) / 2 - np.cos(angle) * np.eye(3)
    column = symmetric[:, int(np.argmax(np.diag(symmetric)))]
    axis = column / np.linalg.norm(column)
    skew = rotation - rotation.T
    if np.dot(axis, (skew[2, 1], skew[0, 2], skew[1, 0])) < 0:
        axis = -axis
    return f"({_vector(axis.round(6))}), {np.degrees(angle):.5g}°"
