"""Cells of notebooks: the parts of a page that are quick to derive."""

from __future__ import annotations

from functools import singledispatch

from ..equations.finite_elements.record import FiniteElementRecord
from ..equations.functions.base_parameters import BaseParameters
from ..equations.record import EquationRecord
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..scene.scene import SceneRecord
from ..topology.drawing.labeled_matrix import Labelled
from . import content as d
from . import histories, motion, scene, sheets
from .writers.html import fragment


def html(result: object) -> str:
    """The output of a cell."""
    return fragment(document(result))


@singledispatch
def document(result: object) -> d.Document:
    """Contents of a cell, before it is written."""
    raise TypeError(f"notebooks show {type(result).__name__} as text")


document.register(EquationRecord, sheets.cell)
document.register(FiniteElementRecord, sheets.cell)
document.register(SceneRecord, scene.document)
document.register(TrajectoryRecord, histories.document)


@document.register
def _(result: BaseParameters) -> d.Document:
    section = d.Section("", motion.combinations(result, "the joint forces"))
    return d.Document("Base parameters", (), (section,))


@document.register
def _(result: Labelled) -> d.Document:
    rows = tuple(
        (name, *(x or "·" for x in row))
        for name, row in zip(result.rows, result.entries, strict=True)
    )
    return d.Document(result.about, (), (d.Section("", (d.Table(("", *result.columns), rows),)),))
