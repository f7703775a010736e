"""The equation sheet of a scene as plain data: tables, formulas, counts, sources."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..codegen import flat, manifest
from ..equations.formula import mathml, rates_are_speeds
from ..errors import DerivationError
from ..ir.interpreter import evaluate

if TYPE_CHECKING:
    from ..equations.record import Equations
    from ..model import Model

Table = tuple[str, Sequence[str], Sequence[Sequence[Any]]]

# named intermediates that are listed
LISTED = 400
# characters of a row of a matrix that fit a page
WIDE = 130
UNTURNED = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
# letter, function and what it is
FORMULAS = (
    ("M", "mass_matrix", "mass matrix"),
    ("h", "bias", "bias: velocity products and gravity"),
    ("g", "constraints", "what vanishes at position level"),
    ("G", "constraint_jacobian", "constraint Jacobian: G udot = gamma"),
    ("f", "applied", "generalized applied forces"),
    ("qdot", "qdot", "kinematics: the rates of the coordinates"),
)


@dataclass(frozen=True)
class Formula:
    """One matrix of the equations.

    Attributes:
        letter: M, h, g, G, f or qdot.
        about: What it is.
        math: Name of what is set -> MathML: the matrix under "", or its entries one by one.
        lines: Its entries as text, or why there are none.
        shared: Lines of named intermediates and entries where it is too long.
    """

    letter: str
    about: str
    math: tuple[tuple[str, str], ...]
    lines: tuple[str, ...]
    shared: tuple[str, ...] = ()


@dataclass(frozen=True)
class Sheet:
    """Everything the page and the screen show.

    Attributes:
        name: Of the model.
        overview: Formalism, sizes and counts, as ``print(equations)``.
        graph_text, graph_svg: The graph of bodies and joints.
        tables: Title, heads of columns, rows.
        formulas: The equations.
        sources: Literature.
        notes: What the user should know.
    """

    name: str
    overview: str
    graph_text: str
    graph_svg: str
    tables: tuple[Table, ...]
    formulas: tuple[Formula, ...]
    sources: tuple[str, ...]
    notes: tuple[str, ...]


def facts(equations: Equations) -> dict[str, Any]:
    """What a program wants to know: the manifest without functions, with counts and sources."""
    data = dict(manifest.base(equations, ()).data)
    for key in ("abi", "available", "functions", "scene", "sha256", "shapes"):
        data.pop(key, None)
    data["frames"] = _placed(equations, data["frames"])
    data["operations"] = {
        name: {"total": counts.total, "operators": dict(counts), "blocks": counts.blocks}
        for name, counts in equations.operations.items()
    }
    data["sources"] = list(equations.sources)
    return data


def _placed(equations: Equations, frames: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Frames with position (3) and rotation (3, 3) in body axes at the defaults of parameters."""
    defaults = [parameter.value for parameter in equations.system.parameters]
    found = evaluate(flat.scene(equations.system), {"p": defaults})
    positions = np.reshape(found["frame_position"], (len(frames), 3)).astype(float)
    rotations = np.reshape(found["frame_rotation"], (len(frames), 3, 3)).astype(float)
    return [
        frame | {"position": p.tolist(), "rotation": r.tolist()}
        for frame, p, r in zip(frames, positions, rotations, strict=True)
        # bodies without parts only stand for joints
        if frame["part"] is not None or frame["body"] == "ground"
    ]


def sheet(scene: Model, equations: Equations) -> Sheet:
    """Collect the sheet of a scene."""
    view = scene.graph
    return Sheet(
        name=equations.system.name,
        overview=str(equations),
        graph_text=str(view),
        graph_svg=view.svg(),
        tables=tuple(_tables(facts(equations))),
        formulas=tuple(_formulas(equations)),
        sources=equations.sources,
        notes=tuple(dict.fromkeys((*scene.notes, *equations.system.notes))),
    )


def _tables(data: dict[str, Any]) -> Iterable[Table]:
    kinds = {joint["name"]: joint["kind"] for joint in data["joints"]}
    yield (
        "coordinate",
        ("coordinate", "joint", "kind", "unit", "default"),
        [
            (c["name"], c["joint"], kinds[c["joint"]], c["unit"], float(c["default"]))
            for c in data["coordinates"]
        ],
    )
    yield (
        "speed",
        ("speed", "joint", "unit"),
        [(u["name"], u["joint"] or "", u["unit"]) for u in data["speeds"]],
    )
    if data["parameters"]:
        yield (
            "parameter",
            ("parameter", "value", "unit", ""),
            [
                (p["name"], p["default"], p["unit"], "declared" if p["declared"] else "")
                for p in data["parameters"]
            ],
        )
    if data["inputs"]:
        yield (
            "input",
            ("input", "default", "unit"),
            [(r["name"], float(r["default"]), r["unit"]) for r in data["inputs"]],
        )
    yield (
        "frame",
        ("frame", "body", "position [m]", "axes"),
        [
            (
                f["name"],
                f["body"],
                ", ".join(f"{x:.6g}" for x in f["position"]),
                "as the body's" if f["rotation"] == UNTURNED else "turned",
            )
            for f in data["frames"]
        ],
    )
    yield (
        "operations in",
        ("operations in", "total", "by body and joint"),
        [
            (name, found["total"], _by_owner(found["blocks"]))
            for name, found in data["operations"].items()
        ],
    )


def _by_owner(counts: dict[str, dict[str, int]]) -> str:
    """Largest first; what nobody owns last."""
    totals = sorted(((sum(c.values()), owner) for owner, c in counts.items()), reverse=True)
    shown = [f"{owner or 'other'} {total}" for total, owner in totals[:8]]
    return ", ".join(shown) + (", ..." if len(totals) > 8 else "")


def _formulas(equations: Equations) -> Iterable[Formula]:
    known = equations.names()
    for letter, name, about in FORMULAS:
        if name not in known:
            continue
        try:
            matrix = equations.written(name)
        except DerivationError as problem:
            lines = [f"{letter}: {problem}"]
            yield Formula(letter, about, (), tuple(lines), _shared(equations, letter, name))
            continue
        if letter == "f" and not any(matrix):
            continue
        if letter == "qdot" and rates_are_speeds(equations, matrix):
            continue
        named = zip(_entries(equations, letter), matrix, strict=True)
        # a symmetric matrix is said once
        entries = [
            (entry, value)
            for k, (entry, value) in enumerate(named)
            if letter != "M" or k // matrix.cols <= k % matrix.cols
        ]
        lines = [f"{letter}[{entry}] = {value}" for entry, value in entries]
        yield Formula(letter, about, _set(equations, matrix, entries), tuple(lines))


def _set(
    equations: Equations, matrix: Any, entries: Sequence[tuple[str, Any]]
) -> tuple[tuple[str, str], ...]:
    """The matrix as it stands where it fits a page, else entry by entry; zeros go unsaid."""
    rows = [sum(len(str(matrix[i, k])) for k in range(matrix.cols)) for i in range(matrix.rows)]
    if max(rows, default=0) <= WIDE:
        return (("", mathml(equations, matrix)),)
    return tuple((name, mathml(equations, value, lines=True)) for name, value in entries if value)


def _entries(equations: Equations, letter: str) -> Sequence[str]:
    """Rows and columns by coordinate or speed; the speed of a joint is called after it."""
    speeds = [name.replace(".u", "", 1) for name in equations.speeds]
    if letter == "M":
        return [f"{a}, {b}" for a in speeds for b in speeds]
    rows = equations.constraint_rows
    if letter == "G":
        return [f"{row.name}, {b}" for row in rows for b in speeds]
    if letter == "g":
        return [row.name for row in rows if row.level == "position"]
    return equations.coordinates if letter == "qdot" else speeds


def _shared(equations: Equations, letter: str, name: str) -> tuple[str, ...]:
    """A long function with named intermediates; () where there are too many to list."""
    replacements, matrix = equations.symbolic(name)
    if len(replacements) > LISTED:
        return ()
    lines = [f"{symbol} = {value}" for symbol, value in replacements]
    entries = zip(_entries(equations, letter), matrix, strict=True)
    return (*lines, *(f"{letter}[{entry}] = {value}" for entry, value in entries))
