"""Columns of derivatives of a model in finite-element coordinates: which they are, and how many."""

from __future__ import annotations

import ctypes
from math import prod
from typing import final

import numpy as np

from ....arrays import Integers
from ....schema.blocks import COORDINATES, DIRECTIONS
from ....schema.c_functions import FunctionRow, ResultRow
from ....schema.finite_elements import EXPRESSION
from ....schema.product_records import ProductRecord
from ....schema.request import Request
from ...calls.layout import Layout
from .mesh import Mesh


@final
class ProductColumns:
    """What derivatives are by, in the order in which C adds them up.

    Args:
        mesh: The elements.
        layout: Of the blocks of the model.

    Attributes:
        parameters: Numbers of the parameters by name.
    """

    def __init__(self, mesh: Mesh, layout: Layout) -> None:
        self.mesh, self.layout = mesh, layout
        rows = layout.manifest.parameters
        self.parameters = {row.name: k for k, row in enumerate(rows)}

    def numbers(self, request: Request, by_parameters: bool) -> tuple[Integers, Integers]:
        """Which derivative every column is, and where the columns of every part begin."""
        record = ProductRecord(mesh=ctypes.addressof(self.mesh.record), np=len(self.parameters))
        starts = np.zeros(10, dtype=np.intp)
        self.mesh.library.cardan_mesh_product_starts(
            ctypes.byref(record), ctypes.c_void_p(starts.ctypes.data)
        )
        names = ("t", "q", COORDINATES, "u", "z", "s", "r", "p", "udot", "tau")
        first = dict(zip(names, starts.tolist(), strict=True))
        if not by_parameters:
            # nothing stands for them
            first |= {n: first[n] - len(self.parameters) for n in ("udot", "tau")}
        inputs = {name: k for k, name in enumerate(self.layout.inputs)}
        columns, parts = list[int](), [0]
        for name in request.wrt:
            if name in first:
                columns += range(first[name], first[name] + self.count(name))
            elif name in self.parameters:
                columns.append(first["p"] + self.parameters[name])
            else:
                columns.append(first["r"] + inputs[name])
            parts.append(len(columns))
        return np.array(columns, dtype=np.intp), np.array(parts, dtype=np.intp)

    def widths(self, request: Request) -> dict[str, tuple[int, ...]]:
        """Axis of columns by every block or name; none of single ones."""
        return {n: () if n == "t" or n not in DIRECTIONS else (self.count(n),) for n in request.wrt}

    def count(self, name: str) -> int:
        if name == "t":
            return 1
        if name == "p":
            return len(self.parameters)
        return len(self.layout.names({"q": "u", COORDINATES: "q"}.get(name, name)))

    def entry(self, row: str, request: Request, shape: tuple[int, ...], work: int) -> FunctionRow:
        """What is said of it as of other functions."""
        widths = self.widths(request)
        if row == EXPRESSION:
            outputs = {"expression": shape}
        elif row == "jvp":
            outputs = {"change": shape}
        elif row == "hessian":
            columns = sum(prod(size) for size in widths.values())
            outputs = {"hessian": (columns, columns)}
        else:
            lead = shape if row == "derivative" else ()
            outputs = {f"d_{name}": (*lead, *size) for name, size in widths.items()}
        entries = dict.fromkeys(("vjp", "hessian"), prod(shape))
        entries["jvp"] = sum(prod(x) for x in widths.values())
        return FunctionRow(
            file="",
            symbol=row,
            work_size=work,
            prepared_size=0,
            output_size=sum(prod(x) for x in outputs.values()),
            outputs=[ResultRow(name=name, shape=list(x)) for name, x in outputs.items()],
            vector=[f"v{k + 1}" for k in range(entries.get(row, 0))],
            operations={},
            inputs=[],
            lanes=[1],
            sha256="",
        )
