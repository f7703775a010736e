"""Derivatives of the functions of a compiled model."""

from __future__ import annotations

from abc import ABC
from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cached_property
from itertools import accumulate
from math import prod
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from ...arguments import checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, brief, near
from ...records import dataclass
from ...schema.blocks import COORDINATES, DIRECTIONS, Blocks
from ...schema.functions import DIFFERENTIABLE, FUNCTIONS
from ...schema.request import Request, reads
from ..calls.calling import Arrangement, Attempt
from ..calls.evaluation import Values
from ..calls.functions import Functions
from ..calls.memory_order import into
from ..calls.methods import ByName
from .requests import STANDARD, once
from .wrenches import generalized, read_wrenches

if TYPE_CHECKING:
    from ..calls.loaded_function import LoadedFunction


# what a wrench on a frame can be felt through
PUSHED = ("forward_dynamics", "inverse_dynamics")


class Derivatives(Functions, ABC):
    """Derivatives of all functions above."""

    @once
    @checked
    def derivative(
        self, function: str | tuple[str, str], wrt: str | Sequence[str] = STANDARD
    ) -> Derivative:
        """The derivative of a function, itself a function of the same arguments.

        ``A, B = model.derivative("forward_dynamics", wrt=("q", "u"))(q, u, tau=tau)``

        Args:
            function: Such as ``"forward_dynamics"``, or ``("pose", "hand")``.
            wrt: Blocks ``t q u z r p udot tau``, or parameters and inputs by name, such as
                ``("q", "u", "upper.mass")``. ``"q"`` stands for nu columns along the speeds: the
                change of the function when q moves as it does at unit speeds (``integrate``),
                ``"coordinates"`` for nq columns along q as it is stored: a unit quaternion counts
                by its direction, along itself nothing changes. By default q, u, r and p as far as
                the function reads them.

        Returns:
            A :class:`Derivative`: called, it gives one array per block or name, ``(..., *shape,
            columns)``, shape that of the function; t and single names have no axis of columns. One
            array instead of a tuple where ``wrt`` is a text. Units: of the function over those of
            the argument.

        Raises:
            ModelError: no such function, block, parameter or input.
            ArgumentError: the function does not read what it is to be differentiated by.
        """
        request = self._request_of(Derivative.row, function, wrt)
        return Derivative(self, *request, isinstance(wrt, str))

    def _request_of(
        self, what: str, function: str | tuple[str, str], wrt: str | Sequence[str]
    ) -> tuple[str, str | None, tuple[str, ...]]:
        """Function, its frame or joint, and what it is differentiated by, checked."""
        pair = (function, None) if isinstance(function, str) else function
        if not isinstance(pair, tuple) or len(pair) != 2:
            raise ModelError(
                f"{what}: a name, or a pair such as ('pose', 'hand'), is wanted, "
                f"not {brief(function)}"
            )
        name, of = pair
        if name not in DIFFERENTIABLE:
            raise ModelError(f"derivative of '{name}' does not exist.{near(name, DIFFERENTIABLE)}")
        if bool(FUNCTIONS[name].of) != (of is not None):
            expected = "needs a frame or joint: ('pose', 'hand')" if of is None else "takes none"
            raise ModelError(f"{what}: {name} {expected}")
        self._check_of(name, of)
        reads = {*FUNCTIONS[name].reads.replace("x", "q u z").split(), "p"}
        reads |= {COORDINATES} if "q" in reads else set()
        if not wrt or not isinstance(wrt, (str, list, tuple)):
            raise ModelError(
                f"{what}: wrt is a block such as 'q', a parameter or input, or several of them, "
                f"not {brief(wrt)}"
            )
        entries = (wrt,) if isinstance(wrt, str) else tuple(wrt)
        if wrt is STANDARD:
            entries = tuple(block for block in STANDARD if block in reads)
        if wrt is not STANDARD and not isinstance(wrt, Blocks):
            self._check_one_meaning(what, entries)
        for entry in entries:
            self._check_wrt(what, name, entry, reads)
        return name, of, entries

    def _check_one_meaning(self, what: str, entries: tuple[str, ...]) -> None:
        """Refuse names of blocks that parameters or inputs have too, with the cure."""
        listed = {"parameter": self.manifest.parameters, "input": self.manifest.inputs}
        for kind, rows in listed.items():
            both = [row.name for row in rows if row.name in entries and row.name in DIRECTIONS]
            if both:
                raise ModelError(
                    f"{what}: wrt: '{both[0]}' is a block of the function and a {kind} of "
                    f"'{self.manifest.name}', and cannot be told from it: rename the {kind}"
                )

    def _check_wrt(self, what: str, function: str, entry: str, reads: set[str]) -> None:
        if entry in DIRECTIONS and entry not in reads:
            raise ArgumentError(
                f"{what}: {function} does not read {entry}; it reads {', '.join(sorted(reads))}"
            )
        inputs = tuple(row.name for row in self.manifest.inputs)
        parameters = tuple(row.name for row in self.manifest.parameters)
        if entry not in (*DIRECTIONS, *inputs, *parameters):
            raise ModelError(
                f"{what}: '{entry}' is not a block ({', '.join(DIRECTIONS)}), parameter or "
                f"input.{near(entry, (*DIRECTIONS, *parameters, *inputs))}"
            )


@dataclass(frozen=True)
class Derivative:
    """A derivative, ready to be called with the arguments of its function.

    Attributes:
        model: Whose function it is.
        function, of: The function and its frame or joint.
        wrt: What it is differentiated by: the order of the results.
        single: Whether ``wrt`` was one text.
    """

    # name in the table of functions, and what it takes after the states of its function
    row: ClassVar[str] = "derivative"
    added: ClassVar[tuple[str, ...]] = ()

    model: Derivatives = field(repr=False)
    function: str
    of: str | None
    wrt: tuple[str, ...]
    single: bool = False

    @cached_property
    def request(self) -> str:
        """Entry for ``functions=`` of an export: ``("derivative", request)``."""
        return str(Request(self.function, self.of, self._ordered))

    @cached_property
    def _ordered(self) -> tuple[str, ...]:
        """Blocks and names in the order in which the C has them, each once."""
        order = {block: n for n, block in enumerate(DIRECTIONS)}
        return tuple(sorted(dict.fromkeys(self.wrt), key=lambda x: (order.get(x, len(order)), x)))

    @property
    def operations(self) -> dict[str, int]:
        """Number of each operator of its C."""
        return dict(self._loaded.entry.operations)

    @property
    def _loaded(self) -> LoadedFunction:
        return self.model._function(self.row, self.request)

    def __call__(
        self,
        *states: object,
        wrenches: Values | None = None,
        parameters: Values | None = None,
        out: Any = None,
        **keywords: object,
    ) -> Any:
        """The derivatives at states of any leading shape.

        Args:
            states, keywords: As the function takes them; leading axes broadcast.
            wrenches: Frame -> (..., 6), for forward and inverse dynamics.
            parameters: Other values than the model's own.
            out: Arrays to fill and return, as many as there are results.

        Raises:
            ArgumentError, ModelError, SolveError: as the function itself.
        """
        if wrenches is None and parameters is None and out is None:
            quick = self._quick(states, keywords)
            if quick is not None:
                return quick
        values = self._named(states, keywords)
        if wrenches is None:
            results = self._results(values, parameters)
        else:
            results = self._pushed(values, wrenches, parameters)
        return self._delivered(results, out)

    def _quick(
        self, states: tuple[object, ...], keywords: Mapping[str, object]
    ) -> Array | tuple[Array, ...] | None:
        """Results of plain calls; None where something is out of the usual."""
        if len(states) > len(self._order[0]):
            return None
        if keywords:
            row = [*states, *[None] * (len(self._row) - len(states))]
            for name, value in keywords.items():
                place = self._row.get(name, -1)
                if place < len(states):
                    return None
                row[place] = value
            states = tuple(row)
        return self._attempt(states)

    @cached_property
    def _row(self) -> dict[str, int]:
        """Where arguments by place and by name stand in one row of all of them."""
        by_place, names = self._order
        return {name: k for k, name in enumerate(dict.fromkeys((*by_place, *names)))}

    def _delivered(self, results: Mapping[str, Array], out: Any) -> Array | tuple[Array, ...]:
        """Results in the order in which they were asked for."""
        listed = [results[name] for name in self.wrt]
        if out is not None:
            outs = (out,) if self.single else tuple(out)
            if len(outs) != len(listed):
                raise ArgumentError(f"out holds {len(outs)} arrays, expected {len(listed)}")
            listed = [into(x, o) for x, o in zip(listed, outs, strict=True)]
        return listed[0] if self.single else tuple(listed)

    def _named(self, states: Sequence[object], keywords: Mapping[str, object]) -> ByName:
        """Arguments by name."""
        # solvers call rhs(t, x, r)
        order, names = self._order
        if len(states) > len(order):
            raise ArgumentError(
                f"{self.row} of {self.function} takes {', '.join(order)} in this order and the "
                f"rest by name, not {len(states)} arguments"
            )
        values = dict(zip(order, states, strict=False))
        for name, value in keywords.items():
            if name not in names or name in values:
                what = "is given twice" if name in values else "is none of its arguments"
                raise ArgumentError(
                    f"{self.row} of {self.function}: {name} {what}.{near(name, names)}"
                )
            values[name] = value
        return values

    def _width(self, name: str) -> int:
        """Number of columns along a block, or a parameter or input."""
        if not has_columns(name):
            return 1
        # along the speeds, whatever q is
        block = {"q": "u", COORDINATES: "q"}.get(name, name)
        if block == "p":
            return len(self.model.manifest.parameters)
        return len(self.model._vector(block, {}))

    def _results(
        self, named_values: Mapping[str, object], parameters: Values | None
    ) -> dict[str, Array]:
        """One array per block or name."""
        return self._by_part(self._value(named_values, parameters))

    def _by_part(self, flat: Array) -> dict[str, Array]:
        """One array per block or name, of all numbers as the C gives them."""
        parts = self._parts
        if len(parts) == 1:
            return {self.wrt[0]: flat}
        lead = flat.shape[:-1]
        return {
            name: flat[..., start:end].reshape(lead + shape) for name, start, end, shape in parts
        }

    @cached_property
    def _parts(self) -> tuple[tuple[str, int, int, tuple[int, ...]], ...]:
        """Name, first and last number and shape of every result."""
        shapes = [(row.name.removeprefix("d_"), tuple(row.shape)) for row in self._loaded.outputs]
        ends = [*accumulate(prod(shape) for _, shape in shapes)]
        return tuple(
            (name, end - prod(shape), end, shape)
            for (name, shape), end in zip(shapes, ends, strict=True)
        )

    def _value(self, named_values: Mapping[str, object], parameters: Values | None) -> Array:
        """What the C gives."""
        values = tuple(named_values.get(name, 0.0 if name == "t" else None) for name in self._reads)
        return self.model._evaluate(self._key, values, parameters, None)

    @cached_property
    def _key(self) -> tuple[str, str]:
        """Of its C among the functions of the model."""
        return self.row, self.request

    @cached_property
    def _reads(self) -> tuple[str, ...]:
        """Arguments of its C."""
        return tuple(reads(*self._key))

    @cached_property
    def _attempt(self) -> Attempt:
        """The C, for one row of all arguments."""
        way: Attempt = self._loaded.fast.arranged(self._arrangement())
        return way

    def _arrangement(self) -> Arrangement:
        """Arguments by place and results as the caller has them."""
        names = self._row
        places = tuple(names.get(name, -1) for name in self._reads)
        return Arrangement(len(names), places, {}, -1, (), self._several)

    @property
    def _several(self) -> tuple[tuple[int, int, tuple[int, ...]], ...]:
        """First number, size and shape of every result in its order; none if there is one."""
        lies = {name: (start, end - start, shape) for name, start, end, shape in self._parts}
        return () if self.single else tuple(lies[name] for name in self.wrt)

    @cached_property
    def _order(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Arguments by place, and those that have a name."""
        row = FUNCTIONS[self.function]
        names = tuple(name for name in row.arguments if name != "wrench")
        return (*row.required, *self.added), (*names, *self.added)

    def _pushed(
        self, values: ByName, wrenches: Values, parameters: Values | None
    ) -> dict[str, Array]:
        """With wrenches on frames: tau grows by Jᵀ w, and J changes too."""
        if self.function not in PUSHED:
            raise ArgumentError(
                f"{self.row}: wrenches go with {' and '.join(PUSHED)}, not with {self.function}"
            )
        model, position = self.model, {name: values.get(name) for name in ("q", "r")}
        place: ByName = {**position, "t": values.get("t", 0.0), "parameters": parameters}
        changes = self._jacobians(read_wrenches(model, wrenches), place)
        if self.function == "forward_dynamics":
            forces = generalized(model, wrenches, place.pop("q"), **place)
            tau = values.get("tau")
            total = forces if tau is None else model._vector("tau", tau) + forces
            values = {**values, "tau": total}
        return self._with_forces(values, parameters, changes)

    def _with_forces(
        self, values: ByName, parameters: Values | None, changes: Mapping[str, Array]
    ) -> dict[str, Array]:
        """Results at generalized forces that change too (..., nu, columns), by block or name."""
        if self.function == "inverse_dynamics":
            results = self._results(values, parameters)
            return {
                name: x - changes[name] if name in changes else x for name, x in results.items()
            }
        # M^-1 is what udot gains by tau
        wrt = (*dict.fromkeys((*self.wrt, "tau")),)
        more = Derivative(self.model, self.function, None, wrt)
        results = more._results(values, parameters)
        for name, change in changes.items():
            columns = change if change.ndim >= 2 and has_columns(name) else change[..., None]
            gained = results["tau"] @ columns
            results[name] = results[name] + (gained if has_columns(name) else gained[..., 0])
        return results

    def _jacobians(
        self, wrenches: Mapping[str, Array], place: Mapping[str, Any]
    ) -> dict[str, Array]:
        """Changes of the sum of Jᵀ w by block or name."""
        felt = tuple(name for name in self.wrt if name not in ("u", "tau", "udot"))
        total: dict[str, Array] = {}
        values = {name: value for name, value in place.items() if name != "parameters"}
        for frame, wrench in wrenches.items() if felt else ():
            jacobian = Derivative(self.model, "frame_jacobian", frame, felt)
            for name, change in jacobian._results(values, place["parameters"]).items():
                letters = "...ijk,...i->...jk" if has_columns(name) else "...ij,...i->...j"
                contribution = np.einsum(letters, change, wrench)
                total[name] = total[name] + contribution if name in total else contribution
        return total


def has_columns(name: str) -> bool:
    """True when a derivative by this has an axis of columns."""
    return name in DIRECTIONS and name != "t"
