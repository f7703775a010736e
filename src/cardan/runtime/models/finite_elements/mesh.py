"""The elements of a model, loaded: balances, tangents and sums over tables."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from copy import copy
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from ....arrays import Array
from ....errors import SolveError
from ....schema.blocks import ORDER
from ....schema.c_functions import FunctionRow
from ....schema.finite_elements import ElementKind
from ....schema.planned import Fields
from ....schema.records import FORMS, Form, Group, MeshRecord, Movers, StateRecord
from ...calls.abi_ctypes import FUNCTION
from ...calls.code import Code
from ...calls.interpreted import SINGULAR, UNSOLVED, called_back
from ...calls.loaded_function import prepare, prepare_rows
from ...sparse.block_solver import plan_record
from ...sparse.matrices import Matrices
from .elements import INNER, Elements, State
from .massless import contradiction, refusal
from .record_fields import group_fields, mesh_fields, mover_fields
from .tables import Tables

# what functions of the whole mesh ask of the elements
SOLVED = ("balance", "balance_tangent", "gamma", "reaction_friction")
NEEDED = {
    "balance": ("balance",),
    "gamma": ("gamma",),
    "accelerations": SOLVED,
    "rhs": (*SOLVED, "zdot"),
    "events": ("signs", *SOLVED),
    "transition": ("jumps", "change", *SOLVED),
    "values": ("balance_tangent",),
    "close_position": ("balance", "balance_tangent"),
    "close_velocity": ("balance", "balance_tangent"),
    "constraint_jacobian": ("balance_tangent",),
    "energy": ("energy",),
    "power": ("power", *SOLVED),
    "outputs": ("outputs", *SOLVED),
    "momentum": ("momentum",),
    "qdot": (),
    "move": (),
}


def _block_sizes(kind: ElementKind, nr: int) -> dict[str, int]:
    """Sizes of the blocks that the functions of a kind are given."""
    along = dict.fromkeys(("u", "udot", "du"), kind.nu)
    # elements of mixed form are given their stress as z while one searches for rest
    nz = max(kind.nz, INNER if "mixed" in kind.functions else 0)
    events = {"e": kind.ne, "tau": kind.frictions + kind.responses}
    return {"q": kind.nq, "z": nz, "s": kind.ns, "lam": kind.m, "r": nr, **along, **events}


@final
class Mesh(Elements):
    """The tables of a model with loaded functions and data.

    Args:
        tables: Places and elements.
        entries: C name -> what the manifest says about a function.
        load: C names -> loaded functions.
        data: Of every group (n, k).
        lanes: Elements that functions take side by side at most.
        library: The kernels.
        lock: Held while functions are loaded; one that may be taken again by who has it.
        judge: Told the functions of elements that were compiled just now, when they are connected.
    """

    def __init__(
        self,
        tables: Tables,
        entries: Mapping[str, FunctionRow],
        load: Callable[[Sequence[str]], Mapping[str, Code]],
        data: Sequence[Array],
        lanes: int,
        library: ctypes.CDLL,
        lock: AbstractContextManager[Any],
        judge: Callable[[Elements, Sequence[str]], None],
    ) -> None:
        self.tables = tables
        self.library = library
        self._references: list[Any] = []
        self._load = load
        self.data = data
        self._codes = dict(load([c for kind in tables.kinds for c in kind.functions.values()]))
        self.interpreted = any(code.interpreted is not None for code in self._codes.values())
        # what the judge may call, who has the lock, and what every thread may
        self._source: Mesh | None = None  # elements that others share what is prepared with
        self._connected: set[str] = set()
        self._approved: set[str] = set()
        self._lock = lock
        self._judge = judge
        fields = group_fields(tables)
        self.inner = sum(INNER * len(g) for g in tables.groups if "mixed" in g.kind.functions)
        self._groups = groups = (Group * max(1, len(fields)))()
        for record, values_of_group in zip(groups, fields, strict=False):
            self._fill(record, values_of_group)
        movers = self._movers()
        self.plan = tables.once(Matrices.of).plan
        plan = plan_record(self.plan)
        self._references += [groups, movers, plan]
        self.record = MeshRecord(
            group_count=len(tables.groups),
            mover_count=len(movers),
            groups=ctypes.addressof(groups),
            movers=ctypes.addressof(movers),
            plan=ctypes.addressof(plan),
            lanes=lanes,
        )
        self._fill(self.record, mesh_fields(tables, entries))
        library.cardan_mesh_room.restype = ctypes.c_ssize_t
        library.cardan_mesh_call_work.restype = ctypes.c_ssize_t
        fresh = [symbol for symbol, code in self._codes.items() if code.fresh]
        if fresh:
            self._judge(self, fresh)

    @property
    def reference(self) -> Any:
        """The record, by reference."""
        return ctypes.byref(self.record)

    # loading

    def with_data(self, data: Sequence[Array]) -> Mesh:
        """The same elements with other data; what is prepared from the same data is shared."""
        with self._lock:
            other = copy(self)
            other.data, other._source = data, self
            other._references = [*self._references]
            other._codes, other._connected = dict(self._codes), set(self._connected)
            other._approved = set(self._approved)
            groups = type(self._groups).from_buffer_copy(self._groups)
            other._groups = groups
            other.record = MeshRecord.from_buffer_copy(self.record)
            other.record.groups = ctypes.addressof(groups)
            other._references.append(groups)
            places = zip(groups, self.tables.groups, self.data, data, strict=False)
            for record, group, before, after in places:
                for name in self._connected.intersection(group.kind.functions):
                    if after is not before:
                        code = self._codes[group.kind.functions[name]]
                        other.form(record.forms[FORMS.index(name)], code, after)
            return other

    def _pointer(self, array: NDArray[Any] | None) -> int | None:
        if array is None:
            return None
        array = np.ascontiguousarray(array)
        self._references.append(array)
        return array.ctypes.data

    def _fill(self, record: Group | Movers | MeshRecord, fields: Fields) -> None:
        """Fill in fields; arrays live as long as this."""
        for name, value in fields.items():
            setattr(record, name, value if isinstance(value, int) else self._pointer(value))

    def connect(self, *forms: str) -> None:
        """Load functions of all elements that are not there yet; those of one call side by side."""
        if self._approved.issuperset(forms):
            return
        with self._lock:
            # balances, tangents and accelerations are judged together
            more = () if set(SOLVED).isdisjoint(forms) else SOLVED
            missing = [
                name for name in dict.fromkeys((*forms, *more)) if name not in self._connected
            ]
            try:
                fresh = self._connect(missing) if missing else []
                if fresh:
                    self._judge(self, fresh)
            except BaseException:
                self._connected &= self._approved
                raise
            self._approved.update(missing)

    def _connect(self, missing: Sequence[str]) -> list[str]:
        """Load functions, alone; those that were compiled just now."""
        groups = self.tables.groups
        source = self._source
        if source is not None:
            source.connect(*missing)
        having = [(g, name) for g in groups for name in missing if name in g.kind.functions]
        loaded = self._load([group.kind.functions[name] for group, name in having])
        self._codes |= loaded
        for k, (record, group) in enumerate(zip(self._groups, groups, strict=False)):
            for name in missing:
                if name not in group.kind.functions:
                    continue
                place = FORMS.index(name)
                if source is not None and self.data[k] is source.data[k]:
                    record.forms[place] = source._groups[k].forms[place]
                    continue
                code = self._codes[group.kind.functions[name]]
                code.take(_block_sizes(group.kind, self.tables.nr))
                self.form(record.forms[place], code, self.data[k])
        self._connected.update(missing)
        return [symbol for symbol, code in loaded.items() if code.fresh]

    def loaded(self, symbols: Sequence[str]) -> dict[str, Code]:
        """Functions of elements and places that others call, checked where they are new."""
        with self._lock:
            loaded = dict(self._load(symbols))
            self._codes |= loaded
            fresh = [symbol for symbol, code in loaded.items() if code.fresh]
            if fresh:
                self._judge(self, fresh)
        return loaded

    def form(self, form: Form, code: Code, data: Array) -> None:
        """Connect a function of a kind, with the data of its elements prepared."""
        form.call, form.lanes = code.address, code.lanes
        w = prepare_rows(code, data)
        form.w, form.nw = self._pointer(w), w.shape[1] // code.lanes
        form.size = int(code.entry.output_size)

    def _movers(self) -> Any:
        """Places whose coordinates are not poses, kind by kind."""
        listed = mover_fields(self.tables)
        movers = (Movers * len(listed))()
        for record, (fields, functions) in zip(movers, listed, strict=True):
            self._fill(record, fields)
            for field, symbol in functions.items():
                code = self._codes[symbol]
                code.take({"q": record.nq, "u": record.nu, "du": record.nu})
                setattr(record, field, code.address)
                setattr(record, f"w_{field}", self._pointer(prepare(code, np.zeros(0))))
        return movers

    def closure(self, name: str) -> int:
        """Address of the C function of the whole mesh."""
        self.connect(*NEEDED[name])
        function = getattr(self.library, f"cardan_mesh_call_{name}")
        return ctypes.cast(function, ctypes.c_void_p).value or 0

    @property
    def work(self) -> int:
        """Numbers of work memory that functions of the whole mesh need."""
        return int(self.library.cardan_mesh_call_work(self.reference))

    def accelerations(self, at: State, tau: Array | None = None) -> tuple[Array, Array]:
        """Same as :meth:`Elements.accelerations`."""
        out = np.empty(self.tables.nu + self.tables.m)
        more = None if tau is None else _at(np.ascontiguousarray(tau))
        status = self._status("accelerations", at, more, _at(out))
        if status == SINGULAR:
            raise SolveError(refusal(self, at))
        if status == UNSOLVED:
            raise SolveError(contradiction(self, at))
        _done("accelerations", status)
        udot, lam = np.split(out, [self.tables.nu])
        return udot, lam

    # evaluation

    def state(self, at: State) -> tuple[StateRecord, list[Array]]:
        """A state as C knows it, and what must live as long."""
        blocks = {"q": at.q, "u": at.u, "udot": at.udot, "lam": at.lam}
        blocks |= {"z": at.z, "s": at.s, "r": at.r, "du": at.du, "inner": at.inner}
        arrays = {
            name: np.ascontiguousarray(x, float) for name, x in blocks.items() if x is not None
        }
        pointers = {name: x.ctypes.data for name, x in arrays.items()}
        return StateRecord(t=at.t, **pointers), list(arrays.values())

    def _call(self, name: str, at: State, *arguments: object) -> None:
        _done(name, self._status(name, at, *arguments))

    def _status(self, name: str, at: State, *arguments: object) -> int:
        self.connect(*NEEDED.get(name, ()))
        record, _arrays = self.state(at)
        function = getattr(self.library, f"cardan_mesh_{name}")
        memory = np.empty(self.work)
        return self.run(function, self.reference, ctypes.byref(record), *arguments, _at(memory))

    def run(self, function: Callable[..., int], *arguments: object) -> int:
        """Status of a function of the kernels."""
        with called_back() if self.interpreted else nullcontext():
            return int(function(*arguments))

    def balance(self, at: State) -> tuple[Array, Array, Array]:
        """M udot + h - f - Gᵀ lam (nu,), residuals of positions (mp,), of speeds (m,)."""
        tables = self.tables
        out = np.empty(tables.nu + tables.mp + tables.m)
        self._call("balance", at, _at(out))
        force, gaps, rates = np.split(out, [tables.nu, tables.nu + tables.mp])
        return force, gaps, rates

    def call(
        self, name: str, at: State, size: int, tau: Array | None = None, e: Array | None = None
    ) -> Array:
        """A function of the whole mesh with the interface of generated ones."""
        record, _arrays = self.state(at)
        more = {"tau": tau, "e": e}
        arrays = {n: np.ascontiguousarray(x, float) for n, x in more.items() if x is not None}
        blocks = {name: getattr(record, name) for name in ("q", "u", "z", "s", "r")}
        time = np.array([at.t])
        blocks |= {"t": time.ctypes.data, "w": ctypes.addressof(self.record)}
        blocks |= {n: x.ctypes.data for n, x in arrays.items()}
        pointers = (ctypes.c_void_p * len(ORDER))(*(blocks.get(name) for name in ORDER))
        out, memory = np.empty(size), np.empty(self.work)
        status = self.run(FUNCTION(self.closure(name)), pointers, *map(_at, (out, memory)))
        if status:
            raise SolveError(f"{name} has no solution (status {status})")
        return out

    def gamma(self, at: State) -> Array:
        """gamma (m,) with G udot = gamma."""
        out = np.empty(self.tables.m)
        self._call("gamma", at, _at(out))
        return out

    def total(self, form: str, size: int, at: State) -> Array:
        """Sum (size,) of a function over the elements: ``energy``, ``momentum``, ``power``."""
        out = np.empty(size)
        self.connect(form)
        self._call("sum", at, FORMS.index(form), ctypes.c_ssize_t(size), _at(out))
        return out

    def results(self, form: str, at: State) -> list[Array]:
        """Results of the elements (n, size), for every group that has the function."""
        self.connect(form)
        k = FORMS.index(form)
        with_it = [g for g in self.tables.groups if form in g.kind.functions]
        sizes = [int(self._codes[g.kind.functions[form]].entry.output_size) for g in with_it]
        counts = [len(g) * size for g, size in zip(with_it, sizes, strict=True)]
        out = np.empty(sum(counts))
        self._call("results", at, k, _at(out))
        parts = np.split(out, np.cumsum(counts)[:-1]) if counts else []
        return [part.reshape(-1, size) for part, size in zip(parts, sizes, strict=True)]

    def values(self, at: State, shares: tuple[float, float, float]) -> Array:
        """Values of shares of K, C and M with Gᵀ and G, as ``plan`` has them."""
        out, factors = np.empty(self.plan.pattern.values), np.array(shares, float)
        self._call("values", at, _at(factors), _at(out))
        return out

    def rates(self, q: Array, u: Array) -> Array:
        """qdot (nq,)."""
        out, q, u = np.empty(self.tables.nq), np.ascontiguousarray(q), np.ascontiguousarray(u)
        memory = np.empty(self.work)
        arguments = self.reference, *map(_at, (q, u, out, memory))
        _done("rates", self.run(self.library.cardan_mesh_rates, *arguments))
        return out

    def move(self, q: Array, du: Array) -> Array:
        """Coordinates (nq,) moved by an increment (nu,) along the speeds."""
        out, q, du = np.empty(self.tables.nq), np.ascontiguousarray(q), np.ascontiguousarray(du)
        memory = np.empty(self.work)
        arguments = self.reference, _at(q), _at(du), _at(out), None, _at(memory)
        _done("move", self.run(self.library.cardan_mesh_move, *arguments))
        return out


def _done(name: str, status: int) -> None:
    """Refuse the results of functions that failed."""
    if status:
        raise SolveError(f"an element returned the status {status} in {name}")


def _at(array: Array) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)
