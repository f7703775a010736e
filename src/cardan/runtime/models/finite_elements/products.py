"""Derivatives of the functions of a model in finite-element coordinates, and products with them."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from math import prod
from typing import TYPE_CHECKING, TypeAlias, final

import numpy as np

from ....arrays import Array, Integers
from ....errors import ModelError, SolveError
from ....schema.blocks import ORDER
from ....schema.c_functions import FunctionRow
from ....schema.finite_elements import EXPRESSION
from ....schema.product_records import DataSlopes, ProductRecord
from ....schema.records import Form, MeshRecord, constants
from ....schema.request import Request
from ...calls.abi_ctypes import FUNCTION
from ...calls.interpreted import SINGULAR, UNSOLVED
from .data_slopes import DataByParameters
from .massless import contradiction, refusal
from .mesh import NEEDED
from .product_columns import ProductColumns
from .product_forms import ProductForms

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel
    from .evaluation import Inputs, Results

    Records: TypeAlias = ctypes.Array[Form] | ctypes.Array[DataSlopes]

# functions with derivatives, and what these need besides those of the dynamics
DIRECT = {
    **dict.fromkeys(
        (
            *("inverse_dynamics", "constraints", "constraint_rates", "rhs", "forward_dynamics"),
            *("multipliers", "close_position", "close_velocity"),
        ),
        "",
    ),
    "qdot": "",
    **{name: name for name in ("energy", "momentum", "power", "outputs")},
    "expression": "outputs",
    "events": "signs",
    "transition": "states",
}
# derivatives of elements that those of events take too, by fields of the record
MORE = {
    "events": {"impulse": "impulse", "friction": "friction"},
    "transition": {"impulse": "impulse", "jumps": "jumps"},
}
# data of a superelement that say how it is turned, the first ones
ROTATION = 9
# what has to be loaded of elements
BASE = {
    **{name: NEEDED[name] for name in ("energy", "momentum", "power", "outputs", "qdot", "rhs")},
    **dict.fromkeys(("forward_dynamics", "multipliers"), NEEDED["accelerations"]),
    **{name: NEEDED[name] for name in ("close_position", "close_velocity")},
    "expression": NEEDED["outputs"],
    **{name: NEEDED[name] for name in MORE},
}
# what is solved for
SOLVED = ("rhs", "forward_dynamics", "multipliers")


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
        mesh.connect("balance", *BASE.get(name, ()))
        modes = ["gradient", "change", "curvature"] if row == "hessian" else ["gradient"]
        forms = [self._forms_of(request, mode) for mode in (["change"] if forward else modes)]
        columns, parts = self.columns.numbers(request, data)
        record_of_mesh = MeshRecord.from_buffer_copy(mesh.record)
        record_of_mesh.local += self.forms.local
        record_of_mesh.work = max(record_of_mesh.work, self.forms.work)
        record_of_mesh.lanes = max(record_of_mesh.lanes, self.forms.lanes)
        quaternions = np.array(self.model.manifest.quaternions, dtype=np.intp)
        tables = {"column": columns, "part": parts, "quaternion": quaternions}
        if data:
            forms[0]["data"] = self._data_slopes.records
            self._check_rotations(request)
        if row == "hessian":
            self._data_slopes.curve()
        records = [
            ProductRecord(
                mesh=ctypes.addressof(record_of_mesh),
                function=constant[f"CARDAN_OF_{name.upper()}"],
                results=prod(shape),
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
        for field, more in zip(("change", "curvature"), records[1:], strict=False):
            setattr(record, field, ctypes.addressof(more))
        library = mesh.library
        called = "columns" if forward and row == "derivative" else row
        function = getattr(library, f"cardan_mesh_call_{called}")
        measured = "hessian" if row == "hessian" else "product"
        measure = getattr(library, f"cardan_mesh_{measured}_work")
        measure.restype = ctypes.c_ssize_t
        work = int(measure(ctypes.byref(record)))
        address = ctypes.cast(function, ctypes.c_void_p).value or 0
        entry = self.columns.entry(row, request, shape, work)
        return Product(record, entry, address, (record_of_mesh, forms, tables, records, self))

    def _forms_of(self, request: Request, mode: str) -> dict[str, Records]:
        """Derivatives of one mode that a function needs."""
        name = request.function
        forms: dict[str, Records] = {"rates": self.forms.rates(f"qdot_{mode}")}
        if name != "qdot" and DIRECT[name] not in ("energy", "momentum"):
            self.mesh.connect("balance_tangent", "gamma", "zdot")
            forms["dynamics"] = self.forms.derivatives(f"dynamics_{mode}")
        if DIRECT[name]:
            forms["direct"] = self.forms.derivatives(f"{DIRECT[name]}_{mode}")
        for field, form in MORE.get(name, {}).items():
            forms[field] = self.forms.derivatives(f"{form}_{mode}")
        if name == EXPRESSION:
            forms["formula"] = self.forms.formula(request.of or "", mode == "curvature")
        return forms

    def _check(self, row: str, function: str) -> None:
        """Refuse what has no derivative.

        Raises:
            ModelError: with the cure.
        """
        where = f"{row} of {function}: model '{self.model.name}' is in absolute coordinates, where"
        if function not in DIRECT:
            raise ModelError(
                f"{where} these have derivatives: {', '.join(DIRECT)}. A point of a frame has one "
                "as an output of the scene"
            )
        if row == "hessian" and function in MORE:
            raise ModelError(f"{where} events have no second derivatives. Take differences of vjp")

    def _check_rotations(self, request: Request) -> None:
        """Refuse parameters that turn a superelement on what carries it.

        Raises:
            ModelError: one is asked for.
        """
        names, saved = [*self.columns.parameters], self.model._objects.saved()
        for group, record in zip(self.tables.groups, self._data_slopes.records, strict=False):
            # routines of C have no expressions
            if not record.count or saved.keys() >= {*group.kind.functions.values()}:
                continue
            moving = self._data_slopes.parameters_of(group.common, range(ROTATION), record.count)
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
