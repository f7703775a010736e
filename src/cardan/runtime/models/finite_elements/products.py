"""Derivatives of the functions of a model in finite-element coordinates, and products with them."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from functools import cached_property, partial
from math import prod
from typing import TYPE_CHECKING, TypeAlias, final

import numpy as np

from ....arrays import Array, Integers
from ....errors import ModelError, SolveError
from ....records import dataclass
from ....schema.blocks import ORDER
from ....schema.c_functions import FunctionRow
from ....schema.finite_elements import EXPRESSION
from ....schema.product_records import DataSlopes, FrameRecord, ProductRecord, SummandRecord
from ....schema.records import Form, MeshRecord, constants
from ....schema.request import Request
from ...calls.abi_ctypes import FUNCTION
from ...calls.interpreted import SINGULAR, UNSOLVED
from . import data_slopes, summands
from .data_slopes import DataByParameters
from .frame_record import frame_record
from .massless import contradiction, refusal
from .mesh import NEEDED
from .product_columns import ProductColumns
from .product_forms import ProductForms
from .summands import Summands

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel
    from .evaluation import Inputs, Results

    Records: TypeAlias = (
        ctypes.Array[Form]
        | ctypes.Array[DataSlopes]
        | ctypes.Array[SummandRecord]
        | ctypes.Array[FrameRecord]
    )

FRAMES = ("pose", "velocity", "acceleration", "frame_jacobian")
MATRICES = ("mass_matrix", "constraint_jacobian")
# derivatives of elements that those of events take, by fields of the record
EVENTS = {
    "events": {"direct": "signs", "impulse": "impulse", "friction": "friction"},
    "transition": {"direct": "states", "impulse": "impulse", "jumps": "jumps"},
}
# what is solved for, and what else the balance of the elements gives
SOLVED = ("rhs", "forward_dynamics", "multipliers")
PROJECTIONS = ("close_position", "close_velocity")
BALANCED = ("inverse_dynamics", "constraints", "constraint_rates", *PROJECTIONS, *SOLVED, *EVENTS)
# what results of elements add up to
SUMMED = ("energy", "momentum", "power", "outputs", "expression", "reaction", "element_forces")
# functions with derivatives
DIRECT = (*BALANCED, *SUMMED, "qdot", *MATRICES, *FRAMES, *EVENTS)
# what has to be loaded of elements
LOADED = {"expression": "outputs", "reaction": "accelerations", "element_forces": "accelerations"}
LOADED |= {"forward_dynamics": "accelerations", "multipliers": "accelerations"}


@dataclass(frozen=True)
class Product:
    """A derivative, or a product with it, of a function over the elements.

    Attributes:
        record: As C knows it.
        row: What the manifest says of such functions.
        address: Of the C function.
        references: What must live as long.
    """

    record: ProductRecord
    row: FunctionRow
    address: int
    references: tuple[object, ...]


@final
class Products:
    """Products with the derivatives of the functions of a model at its parameters.

    Args:
        results: The functions.
        model: Whose.
    """

    def __init__(self, results: Results, model: LoadedModel) -> None:
        self.results, self.model, self.mesh = results, model, results.mesh
        self.tables = results.tables
        self.forms = ProductForms(self.mesh, model._objects, model.parameters.vector)
        self.columns = ProductColumns(self.mesh, model._layout)

    # what is loaded

    def product(self, row: str, of: str) -> Product:
        """A derivative as it is asked for.

        Args:
            row: A derivative, a product with one, or an expression.
            of: The function, and what it is differentiated by.

        Raises:
            ModelError: the function has none here.
        """
        # the value of an expression goes through outputs too
        request = Request("expression", of, ()) if row == EXPRESSION else Request.read(of)
        name = request.function
        self._check(row, name)
        mesh, constant = self.mesh, constants("mesh_product.h")
        shape = () if name == EXPRESSION else self.results.shape(name)[0]
        # whatever is less: rows by gradients, or columns by changes
        count = sum(prod(width) for width in self.columns.widths(request).values())
        forward = row == "jvp" or (row == "derivative" and count < prod(shape))
        # changes of data are always read
        data = forward or row == "hessian"
        data = data or not {"p", *self.columns.parameters}.isdisjoint(request.wrt)
        if name in MATRICES:
            self.results.check_small(name, shape[0])
        mesh.connect("balance", *NEEDED.get(LOADED.get(name, name), ()))
        modes = ["gradient", "change", "curvature"] if row == "hessian" else ["gradient"]
        sums, solved = self._summands(request), self._solved(name)
        forms = [self._forms_of(request, sums, mode) for mode in (["change"] if forward else modes)]
        columns, parts = self.columns.numbers(request, data)
        record_of_mesh = MeshRecord.from_buffer_copy(mesh.record)
        record_of_mesh.local += self.forms.local
        record_of_mesh.work = max(record_of_mesh.work, self.forms.work)
        record_of_mesh.lanes = max(record_of_mesh.lanes, self.forms.lanes)
        quaternions = np.array(self.model.manifest.quaternions, dtype=np.intp)
        tables = {"column": columns, "part": parts, "quaternion": quaternions}
        references: list[object] = [record_of_mesh, forms, tables, sums, self]
        if sums is not None:
            forms[0]["summands"] = self._summand_records(sums)
        if name in FRAMES:
            frame, more = self._frame(request.of or "", data, row == "hessian")
            forms[0]["frame"] = frame
            references += more
        if data:
            forms[0]["data"] = self._data_slopes.records
            self._check_rotations(request, forms[0])
        if row == "hessian":
            self._data_slopes.curve()
        records = [
            ProductRecord(
                mesh=ctypes.addressof(record_of_mesh),
                function=constant[f"CARDAN_OF_{name.upper()}"],
                results=prod(shape),
                solved=int(solved),
                sums=0 if sums is None else sums.count,
                np=len(self.columns.parameters) if data else 0,
                quaternions=len(quaternions),
                columns=len(columns),
                parts=len(parts) - 1,
                data_rows=self._data_slopes.rows if row == "hessian" else 0,
                **{field: table.ctypes.data for field, table in tables.items()},
                **{field: ctypes.addressof(x) for field, x in {**forms[0], **some}.items()},
            )
            for some in forms
        ]
        record = records[0]
        for field, other in zip(("change", "curvature"), records[1:], strict=False):
            setattr(record, field, ctypes.addressof(other))
        library = mesh.library
        called = "columns" if forward and row == "derivative" else row
        function = getattr(library, f"cardan_mesh_call_{called}")
        measured = "hessian" if row == "hessian" else "product"
        measure = getattr(library, f"cardan_mesh_{measured}_work")
        measure.restype = ctypes.c_ssize_t
        work = int(measure(ctypes.byref(record)))
        address = ctypes.cast(function, ctypes.c_void_p).value or 0
        entry = self.columns.entry(row, request, shape, work)
        return Product(record, entry, address, (*references, records))

    def _forms_of(self, request: Request, sums: Summands | None, mode: str) -> dict[str, Records]:
        """Derivatives of one mode that a function needs."""
        name, every = request.function, range(len(self.tables.groups))
        forms: dict[str, Records] = {"rates": self.forms.rates(f"qdot_{mode}")}
        if name in (*BALANCED, *EVENTS) or self._solved(name):
            self.mesh.connect("balance_tangent", "gamma", "zdot")
            forms["dynamics"] = self.forms.derivatives(f"dynamics_{mode}", every)
        if name in MATRICES:
            forms["direct"] = self.forms.derivatives(f"impulse_{mode}", every)
        if sums is not None:
            self.mesh.connect(sums.form)
            forms["direct"] = self.forms.derivatives(f"{sums.form}_{mode}", [*sums.which])
        for field, form in EVENTS.get(name, {}).items():
            forms[field] = self.forms.derivatives(f"{form}_{mode}", every)
        if name == EXPRESSION:
            forms["formula"] = self.forms.formula(request.of or "", mode == "curvature")
        return forms

    def _solved(self, function: str) -> bool:
        """True when a function follows from accelerations or multipliers."""
        record = self.mesh.record
        return {
            **dict.fromkeys((*SOLVED, "reaction"), True),
            **dict.fromkeys(("outputs", EXPRESSION), bool(record.solved)),
            "power": bool(record.driven),
            "element_forces": self.results.forces_solved,
        }.get(function, False)

    def _summands(self, request: Request) -> Summands | None:
        """What adds up to a function, None of others."""
        name, tables, manifest = request.function, self.tables, self.model.manifest
        if name == "reaction":
            return summands.of_reaction(tables, manifest, request.of or "")
        if name == "element_forces":
            return summands.of_forces(tables, manifest)
        if name in SUMMED:
            return summands.of_scene(tables, "outputs" if name == EXPRESSION else name)
        if name not in FRAMES:
            return None
        place = next(row.tree for row in manifest.frames if row.name == request.of)
        return None if place is None else summands.of_body(tables, manifest, place)

    def _summand_records(self, sums: Summands) -> Records:
        """Which sums the elements of every group add to, as C knows it."""
        records = (SummandRecord * max(1, len(self.tables.groups)))()
        for k, which in sums.which.items():
            records[k].size, records[k].which = which.shape[1], which.ctypes.data
        return records

    def _frame(self, name: str, data: bool, curved: bool) -> tuple[Records, list[object]]:
        """A frame as C knows it, and what must live as long.

        Args:
            name: Of the frame.
            data: Whether its place has slopes by parameters.
            curved: Whether these have slopes too.
        """
        listed = self.model.manifest.frames
        number = next(k for k, row in enumerate(listed) if row.name == name)
        slopes, more = data_slopes.of_frame(self.model, number, curved) if data else (None, [])
        place = self.results.frames.place(name)
        frame, references = frame_record(self.tables, listed[number], place, slopes)
        return frame, [*references, *more]

    def _check(self, row: str, function: str) -> None:
        """Refuse what has no derivative.

        Raises:
            ModelError: with the cure.
        """
        where = f"{row} of {function}: model '{self.model.name}' is in absolute coordinates, where"
        if function not in DIRECT:
            raise ModelError(f"{where} these have derivatives: {', '.join(DIRECT)}")

    def _check_rotations(self, request: Request, forms: Mapping[str, Records]) -> None:
        """Refuse parameters that turn a superelement on what carries it, where it takes part.

        Raises:
            ModelError: one is asked for.
        """
        names = [*self.columns.parameters]
        called = [forms[name] for name in ("dynamics", "direct") if name in forms]
        pairs = zip(self.tables.groups, self._data_slopes.records, strict=False)
        for k, (group, record) in enumerate(pairs):
            rotations = range(data_slopes.without_slopes(self.model, group.kind))
            if not rotations or not record.count or not any(listed[k].call for listed in called):
                continue
            moving = self._data_slopes.parameters_of(group.common, rotations, record.count)
            for name in (names[k] for k in moving):
                if "p" in request.wrt or name in request.wrt:
                    raise ModelError(
                        f"derivative of {request.function}: parameter '{name}' turns "
                        f"'{group.members[0]}' on what carries it, and superelements have no "
                        "derivatives by that. Name other parameters in place of 'p'"
                    )

    @cached_property
    def _data_slopes(self) -> DataByParameters:
        return DataByParameters(self.model, self.tables)

    # calls

    def evaluator(self, product: Product, of: str) -> Callable[[Inputs], Array]:
        """A product as a function of blocks."""
        return partial(self.value, product, of)

    def value(self, product: Product, of: str, inputs: Inputs) -> Array:
        """Result of a product at one state.

        Raises:
            SolveError: accelerations are not determined there.
        """
        at = self.results.state(inputs)
        state, _arrays = self.mesh.state(at)
        blocks = {name: getattr(state, name) for name in ("q", "u", "udot", "lam", "z", "s", "r")}
        time, sizes = np.array([at.t]), {"tau": self.tables.nu, "e": self.tables.ne}
        sizes["v"] = len(product.row.vector)
        more = {"t": time}
        more |= {n: np.ascontiguousarray(inputs[n][:k]) for n, k in sizes.items() if n in inputs}
        blocks |= {name: x.ctypes.data for name, x in more.items()}
        blocks["w"] = ctypes.addressof(product.record)
        pointers = (ctypes.c_void_p * len(ORDER))(*(blocks.get(name) for name in ORDER))
        out, memory = np.empty(product.row.output_size), np.empty(product.row.work_size)
        status = self.mesh.run(FUNCTION(product.address), pointers, _pointer(out), _pointer(memory))
        if status == SINGULAR:
            raise SolveError(refusal(self.mesh, at))
        if status == UNSOLVED:
            raise SolveError(contradiction(self.mesh, at))
        if status:
            raise SolveError(f"derivative of {of} has no solution (status {status})")
        return out


def _pointer(array: Array | Integers) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)
