"""Derivatives of the functions of a model in finite-element coordinates, and products with them."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from math import prod
from typing import TYPE_CHECKING, final

import numpy as np

from ....arrays import Array, Integers
from ....errors import ModelError, SolveError
from ....schema.blocks import COORDINATES, DIRECTIONS, ORDER
from ....schema.c_functions import FunctionRow, ResultRow
from ....schema.finite_elements import EXPRESSION, EXPRESSION_GRADIENT, requested_name
from ....schema.product_records import DataSlopes, ProductRecord
from ....schema.records import Form, MeshRecord, constants
from ....schema.request import Request
from ...calls.abi_ctypes import FUNCTION
from ...calls.code import Code
from ...calls.interpreted import SINGULAR, UNSOLVED
from ...calls.lanes import width
from .data_slopes import DataByParameters
from .massless import contradiction, refusal
from .mesh import NEEDED
from .table_loading import LANE_THRESHOLD

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel
    from .evaluation import Inputs, Results

ROWS = ("derivative", "vjp", "jvp")
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
}
# data of a superelement that say how it is turned, the first ones
ROTATION = 9
# what has to be loaded of elements
BASE = {
    **{name: NEEDED[name] for name in ("energy", "momentum", "power", "outputs", "qdot", "rhs")},
    **dict.fromkeys(("forward_dynamics", "multipliers"), NEEDED["accelerations"]),
    **{name: NEEDED[name] for name in ("close_position", "close_velocity")},
    "expression": NEEDED["outputs"],
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
        self._forms: dict[str, ctypes.Array[Form]] = {}
        self._local = self._work = self._lanes = 0

    # what is loaded

    def product(self, row: str, of: str) -> Product:
        """A derivative as it is asked for.

        Args:
            row: One of ``ROWS``.
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
        by_parameters = not {"p", *self._parameters}.isdisjoint(request.wrt)
        # whatever is less: rows by gradients, or columns by changes
        count = sum(prod(width) for width in self._widths(request).values())
        forward = row == "jvp" or (row == "derivative" and count < prod(shape))
        mode = "change" if forward else "gradient"
        mesh.connect("balance", *BASE.get(name, ()))
        forms: dict[str, ctypes.Array[Form] | ctypes.Array[DataSlopes]] = {
            "rates": self._rates(f"qdot_{mode}")
        }
        if name != "qdot" and DIRECT[name] not in ("energy", "momentum"):
            mesh.connect("balance_tangent", "gamma", "zdot")
            forms["dynamics"] = self._derivatives(f"dynamics_{mode}")
        if DIRECT[name]:
            forms["direct"] = self._derivatives(f"{DIRECT[name]}_{mode}")
        if name == EXPRESSION:
            forms["formula"] = self._formula(request.of or "")
        # changes of data are always read
        columns, parts = self._columns(request, by_parameters or forward)
        record_of_mesh = MeshRecord.from_buffer_copy(mesh.record)
        record_of_mesh.local += self._local
        record_of_mesh.work = max(record_of_mesh.work, self._work)
        record_of_mesh.lanes = max(record_of_mesh.lanes, self._lanes)
        quaternions = np.array(self.model.manifest.quaternions, dtype=np.intp)
        tables = {"column": columns, "part": parts, "quaternion": quaternions}
        if by_parameters or forward:
            forms["data"] = self._data_slopes.records
            self._check_rotations(request)
        record = ProductRecord(
            mesh=ctypes.addressof(record_of_mesh),
            function=constant[f"CARDAN_OF_{name.upper()}"],
            results=prod(shape),
            np=len(self._parameters) if by_parameters or forward else 0,
            quaternions=len(quaternions),
            columns=len(columns),
            parts=len(parts) - 1,
        )
        for field, table in tables.items():
            setattr(record, field, table.ctypes.data)
        for field, records in forms.items():
            setattr(record, field, ctypes.addressof(records))
        library = mesh.library
        library.cardan_mesh_product_work.restype = ctypes.c_ssize_t
        called = "columns" if forward and row == "derivative" else row
        function = getattr(library, f"cardan_mesh_call_{called}")
        work = int(library.cardan_mesh_product_work(ctypes.byref(record)))
        address = ctypes.cast(function, ctypes.c_void_p).value or 0
        entry = self._entry(row, request, shape, work)
        return Product(record, entry, address, (record_of_mesh, forms, tables, self))

    def _check(self, row: str, function: str) -> None:
        """Refuse what has no derivative.

        Raises:
            ModelError: with the cure.
        """
        where = f"{row} of {function}: model '{self.model.name}' is in absolute coordinates, where"
        if row not in (*ROWS, EXPRESSION):
            raise ModelError(
                f"{where} there are {', '.join(ROWS)}. Take differences of vjp for second "
                "derivatives"
            )
        if function not in DIRECT:
            raise ModelError(
                f"{where} these have derivatives: {', '.join(DIRECT)}. A point of a frame has one "
                "as an output of the scene"
            )
        if any(group.kind.frictions for group in self.tables.groups):
            raise ModelError(
                f"{where} friction that follows from reactions has no derivatives. Leave it out, "
                "or take differences"
            )

    def _check_rotations(self, request: Request) -> None:
        """Refuse parameters that turn a superelement on what carries it.

        Raises:
            ModelError: one is asked for.
        """
        names, saved = [*self._parameters], self.model._objects.saved()
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

    @cached_property
    def _parameters(self) -> dict[str, int]:
        return {row.name: k for k, row in enumerate(self.model.manifest.parameters)}

    def _derivatives(self, form: str) -> ctypes.Array[Form]:
        """Derivatives of every group, made once."""
        if form not in self._forms:
            tables, forms = self.tables, (Form * max(1, len(self.tables.groups)))()
            having = [k for k, g in enumerate(tables.groups) if form in g.kind.derivatives]
            names = {tables.groups[k].kind.derivatives[form]: tables.groups[k].kind for k in having}
            codes = self._loaded([(form, kind.name) for kind in names.values()], list(names))
            for k in having:
                group, data = tables.groups[k], self.mesh.data[k]
                code = codes[group.kind.derivatives[form]]
                self.mesh.form(forms[k], code, data)
                self._local = max(self._local, int(code.entry.output_size) + len(code.entry.vector))
            self._forms[form] = forms
        return self._forms[form]

    def _formula(self, formula: str) -> ctypes.Array[Form]:
        """Value of a formula and its slopes."""
        forms, keys = (Form * 2)(), [(EXPRESSION, formula), (EXPRESSION_GRADIENT, formula)]
        symbols = [requested_name(*key) for key in keys]
        codes = self._loaded(keys, symbols)
        for form, symbol in zip(forms, symbols, strict=True):
            self.mesh.form(form, codes[symbol], self.model.parameters.vector[None])
            self._local = max(self._local, int(codes[symbol].entry.output_size))
        return forms

    def _rates(self, form: str) -> ctypes.Array[Form]:
        """Derivatives of the rates of places that move by functions of their own."""
        if form not in self._forms:
            kinds = [kind for kind in self.tables.kinds if kind.name != "node"]
            forms = (Form * max(1, len(kinds)))()
            having = {k: kind for k, kind in enumerate(kinds) if kind.derivatives}
            keys = [(form, kind.name) for kind in having.values()]
            symbols = [kind.derivatives[form] for kind in having.values()]
            codes = self._loaded(keys, symbols)
            for (k, _), symbol in zip(having.items(), symbols, strict=True):
                self.mesh.form(forms[k], codes[symbol], np.zeros((1, 0)))
                entry = codes[symbol].entry
                self._local = max(self._local, int(entry.output_size) + len(entry.vector))
            self._forms[form] = forms
        return self._forms[form]

    def _loaded(self, keys: Sequence[tuple[str, str]], symbols: Sequence[str]) -> dict[str, Code]:
        """Functions that are written when they are asked for, checked."""
        objects = self.model._objects
        with objects.lock:
            missing = [
                key
                for key, symbol in zip(keys, symbols, strict=True)
                if symbol not in objects.manifest.functions
            ]
            if missing and objects._provide is None:
                raise ModelError(
                    f"model '{self.model.name}' was saved without the derivatives of its elements. "
                    "Use them once before saving it, or compile the scene again"
                )
            if missing:
                objects.symbols(missing)
            self._side_by_side(symbols)
            codes = self.mesh.loaded(symbols)
        self._work = max([self._work, *(code.entry.work_size for code in codes.values())])
        self._lanes = max([self._lanes, *(code.lanes for code in codes.values())])
        return codes

    def _side_by_side(self, symbols: Sequence[str]) -> None:
        """Functions of many elements are compiled for several of them side by side."""
        objects, lanes = self.model._objects, width()
        many = [group.kind for group in self.tables.groups if len(group) >= LANE_THRESHOLD]
        for kind in many if lanes > 1 else ():
            for symbol in {*kind.derivatives.values()}.intersection(symbols):
                if lanes in objects.manifest.functions[symbol].lanes:
                    objects.lanes[symbol] = lanes

    # columns

    def _columns(self, request: Request, by_parameters: bool) -> tuple[Integers, Integers]:
        """Which derivative every column is, and where the columns of every part begin."""
        record = ProductRecord(mesh=ctypes.addressof(self.mesh.record), np=len(self._parameters))
        starts = np.zeros(10, dtype=np.intp)
        self.mesh.library.cardan_mesh_product_starts(ctypes.byref(record), _pointer(starts))
        names = ("t", "q", COORDINATES, "u", "z", "s", "r", "p", "udot", "tau")
        first = dict(zip(names, starts.tolist(), strict=True))
        if not by_parameters:
            # nothing stands for them
            first |= {n: first[n] - len(self._parameters) for n in ("udot", "tau")}
        inputs = {row.name: k for k, row in enumerate(self.model.manifest.inputs)}
        columns, parts = list[int](), [0]
        for name in request.wrt:
            if name in first:
                columns += range(first[name], first[name] + self._count(name))
            elif name in self._parameters:
                columns.append(first["p"] + self._parameters[name])
            else:
                columns.append(first["r"] + inputs[name])
            parts.append(len(columns))
        return np.array(columns, dtype=np.intp), np.array(parts, dtype=np.intp)

    def _widths(self, request: Request) -> dict[str, tuple[int, ...]]:
        """Axis of columns by every block or name; none of single ones."""
        return {
            n: () if n == "t" or n not in DIRECTIONS else (self._count(n),) for n in request.wrt
        }

    def _count(self, name: str) -> int:
        if name == "t":
            return 1
        if name == "p":
            return len(self._parameters)
        return len(self.model._layout.names({"q": "u", COORDINATES: "q"}.get(name, name)))

    def _entry(self, row: str, request: Request, shape: tuple[int, ...], work: int) -> FunctionRow:
        """What is said of it as of other functions."""
        widths = self._widths(request)
        if row == EXPRESSION:
            outputs = {"expression": shape}
        elif row == "jvp":
            outputs = {"change": shape}
        else:
            lead = shape if row == "derivative" else ()
            outputs = {f"d_{name}": (*lead, *size) for name, size in widths.items()}
        entries = {"vjp": prod(shape), "jvp": sum(prod(x) for x in widths.values())}
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
        time, sizes = np.array([at.t]), {"tau": self.tables.nu, "v": len(product.row.vector)}
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
