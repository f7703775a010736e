"""A scene before anything is derived: bodies on their joints, forces, numbers with names."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..scene.summary import (
    beam_rows,
    body_rows,
    cable_rows,
    force_rows,
    notes_of,
    summary,
    superelement_rows,
)
from ..topology.drawing import drawing
from ..topology.drawing.graph_view import view
from . import content as d
from .graph import drawn
from .tables import unit

if TYPE_CHECKING:
    from ..scene.scene import SceneRecord


def document(model: SceneRecord) -> d.Document:
    """Everything that is said about a scene on one screen, with its graph drawn."""
    counts, gravity = summary(model).splitlines()[:2]
    lead = [d.Paragraph((line,)) for line in (counts, gravity)]
    lead += [d.Paragraph((f"Note: {note}",), quiet=True) for note in notes_of(model)]
    blocks: list[d.Block] = []
    tables = (body_rows(model), beam_rows(model), cable_rows(model), superelement_rows(model))
    for head, *rows in tables:
        if rows:
            blocks.append(d.Table(tuple(head), tuple(map(tuple, rows))))
    if model.forces:
        blocks.append(d.Listing(tuple((line,) for line in force_rows(model))))
    declared = tuple(
        (what, name, unit(number.unit), float(number.value))
        for what, numbers in (("parameter", model.parameters), ("input", model.inputs))
        for name, number in numbers.items()
    )
    if declared:
        table = d.Table(("", "name", "unit", "default"), declared)
        blocks.append(d.Folded("Parameters", (table,)))
    graph = view(model)
    arcs = drawing.arcs(graph.branches, graph.closing, graph.beams)
    section = d.Section("", (*blocks, drawn(graph.bodies, arcs)))
    return d.Document(model.name, tuple(lead), (section,))
