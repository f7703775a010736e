"""Products with derivatives of the functions of a compiled model."""

from __future__ import annotations

from abc import ABC
from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import accumulate
from math import prod
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from ...arguments import checked
from ...arrays import Array
from ...errors import ArgumentError, brief
from ...records import dataclass
from ...schema.functions import FUNCTIONS
from ..calls.argument_values import common, numbers
from ..calls.calling import ANY, Arrangement
from ..calls.evaluation import Values
from ..calls.memory_order import into
from ..calls.methods import ByName
from .derivatives import Derivative, Derivatives, has_columns
from .requests import STANDARD, once

if TYPE_CHECKING:
    from ..calls.loaded_function import LoadedFunction


class DerivativeProducts(Derivatives, ABC):
    """Weights times derivatives, changes along directions, and second derivatives."""

    @once
    @checked
    def vjp(self, function: str | tuple[str, str], wrt: str | Sequence[str] = STANDARD) -> Vjp:
        """The gradient of a weighted sum of results, for one sweep in reverse whatever it is by.

        ``by_q, by_p = model.vjp("forward_dynamics", wrt=("q", "p"))(q, u, weights, tau=tau)``

        Args:
            function, wrt: As :meth:`derivative` takes them.

        Returns:
            A :class:`Vjp`: called with the arguments of the function and ``weights`` (..., *shape)
            of its results, it gives one array (..., columns) per block or name. Units: of
            function times weights over those of the argument.

        Raises:
            ModelError, ArgumentError: as :meth:`derivative`.
        """
        request = self._request_of(Vjp.row, function, wrt)
        return Vjp(self, *request, isinstance(wrt, str))

    @once
    @checked
    def jvp(self, function: str | tuple[str, str], wrt: str | Sequence[str] = STANDARD) -> Jvp:
        """The change of a function along a direction, without the columns of its derivative.

        ``change = model.jvp("forward_dynamics", wrt=("q", "u"))(q, u, (dq, du), tau=tau)``

        Args:
            function, wrt: As :meth:`derivative` takes them.

        Returns:
            A :class:`Jvp`: called with the arguments of the function and ``direction``, an array
            (..., columns) per block or name or a mapping of them, it gives (..., *shape).

        Raises:
            ModelError, ArgumentError: as :meth:`derivative`.
        """
        request = self._request_of(Jvp.row, function, wrt)
        return Jvp(self, *request, isinstance(wrt, str))

    @once
    @checked
    def hessian(
        self, function: str | tuple[str, str], wrt: str | Sequence[str] = ("q", "u")
    ) -> Hessian:
        """The second derivatives of a weighted sum of results.

        ``H = model.hessian("forward_dynamics", wrt=("q", "u", "tau"))(q, u, weights, tau=tau)``

        Args:
            function, wrt: As :meth:`derivative` takes them. Along the speeds the Hessian is that
                of ``x -> f(integrate(q, x))`` at x = 0.

        Returns:
            A :class:`Hessian`: called with the arguments of the function and ``weights``
            (..., *shape) of its results, it gives one symmetric array (..., n, n), its columns
            those of all blocks and names in their order.

        Raises:
            ModelError, ArgumentError: as :meth:`derivative`.
        """
        request = self._request_of(Hessian.row, function, wrt)
        return Hessian(self, *request, isinstance(wrt, str))


@dataclass(frozen=True)
class Weighted(Derivative):
    """A derivative of a weighted sum of results; its attributes are those of a derivative."""

    added: ClassVar[tuple[str, ...]] = ("weights",)

    def _arrangement(self) -> Arrangement:
        """The weights are the block v, with the axes of the result."""
        plain = super()._arrangement()
        v = self._reads.index("v")
        places = (*plain.places[:v], self._row["weights"], *plain.places[v + 1 :])
        axes = len(FUNCTIONS[self.function].shape.split())
        return plain._replace(places=places, shapes={v: (ANY,) * axes})

    def _with_weights(self, states: Sequence[object], keywords: Mapping[str, object]) -> ByName:
        """Arguments by name, the weights as the block v."""
        values = self._named(states, keywords)
        value = values.pop("weights", None)
        if value is None:
            raise ArgumentError(f"{self.row} of {self.function} needs weights= of the results")
        weights = numbers(f"{self.row} of {self.function}: weights", value)
        axes, size = len(FUNCTIONS[self.function].shape.split()), len(self._loaded.entry.vector)
        lead = weights.shape[: weights.ndim - axes]
        if weights.ndim < axes or prod(weights.shape[weights.ndim - axes :]) != size:
            raise ArgumentError(
                f"{self.row} of {self.function}: weights has shape {weights.shape}, expected "
                f"(..., {FUNCTIONS[self.function].shape.replace(' ', ', ')}), {size} in all: one "
                "for every entry of the result"
            )
        values["v"] = weights.reshape(*lead, size)
        return values


@dataclass(frozen=True)
class Vjp(Weighted):
    """The gradient of a weighted sum of results, ready to be called.

    Attributes are those of a :class:`Derivative`.
    """

    row: ClassVar[str] = "vjp"

    def __call__(
        self,
        *states: object,
        wrenches: Values | None = None,
        parameters: Values | None = None,
        out: Array | Sequence[Array] | None = None,
        **keywords: object,
    ) -> Any:
        """The gradient at states of any leading shape.

        Args:
            states, keywords: As the function takes them, ``weights`` after those that it needs;
                leading axes broadcast.
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
        values = self._with_weights(states, keywords)
        if wrenches is None:
            results = self._results(values, parameters)
        else:
            results = self._pushed(values, wrenches, parameters)
        return self._delivered(results, out)

    def _with_forces(
        self, values: ByName, parameters: Values | None, changes: Mapping[str, Array]
    ) -> dict[str, Array]:
        if self.function == "inverse_dynamics":
            results, by_tau = self._results(values, parameters), -values["v"]
        else:
            more = Vjp(self.model, self.function, None, (*dict.fromkeys((*self.wrt, "tau")),))
            results = more._results(values, parameters)
            by_tau = results["tau"]
        for name, change in changes.items():
            letters = "...i,...ij->...j" if has_columns(name) else "...i,...i->..."
            results[name] = results[name] + np.einsum(letters, by_tau, change)
        return results


@dataclass(frozen=True)
class Jvp(Derivative):
    """The change of a function along a direction, ready to be called.

    Attributes are those of a :class:`Derivative`.
    """

    row: ClassVar[str] = "jvp"
    added: ClassVar[tuple[str, ...]] = ("direction",)

    def __call__(
        self,
        *states: object,
        wrenches: Values | None = None,
        parameters: Values | None = None,
        out: Array | None = None,
        **keywords: object,
    ) -> Array:
        """The change at states of any leading shape.

        Args:
            states, keywords: As the function takes them, ``direction`` after those that it needs;
                leading axes broadcast.
            wrenches: Frame -> (..., 6), for forward and inverse dynamics.
            parameters: Other values than the model's own.
            out: Array to fill and return.

        Raises:
            ArgumentError, ModelError, SolveError: as the function itself.
        """
        if wrenches is None and parameters is None and out is None:
            change = self._quick(states, keywords)
            if isinstance(change, np.ndarray):
                return change
        values = self._named(states, keywords)
        direction = self._direction(values.pop("direction", None))
        if wrenches is not None:
            return into(self._pushed({**values, "v": direction}, wrenches, parameters)[""], out)
        values["v"] = self._joined(direction)
        return into(self._value(values, parameters), out)

    @property
    def _several(self) -> tuple[tuple[int, int, tuple[int, ...]], ...]:
        """There is one result."""
        return ()

    def _arrangement(self) -> Arrangement:
        """The direction is the block v; it comes by components, in the order of ``wrt``."""
        plain, v = super()._arrangement(), self._reads.index("v")
        places = (*plain.places[:v], self._row["direction"], *plain.places[v + 1 :])
        arranged = plain._replace(places=places)
        if self.single:
            return arranged._replace(shapes={v: (ANY,) if has_columns(self.wrt[0]) else ()})
        widths = [self._width(name) for name in self._ordered]
        first = dict(zip(self._ordered, accumulate(widths, initial=0), strict=False))
        components = [(first[name], self._width(name), not has_columns(name)) for name in self.wrt]
        return arranged._replace(joined=v, components=tuple(components))

    def _with_forces(
        self, values: ByName, parameters: Values | None, changes: Mapping[str, Array]
    ) -> dict[str, Array]:
        direction = values.pop("v")
        gained: Array | float = 0.0
        for name, change in changes.items():
            letters = "...ij,...j->...i" if has_columns(name) else "...i,...->...i"
            gained = gained + np.einsum(letters, change, direction[name])
        if self.function == "inverse_dynamics":
            return {"": self._value({**values, "v": self._joined(direction)}, parameters) - gained}
        more = Jvp(self.model, self.function, None, (*dict.fromkeys((*self.wrt, "tau")),))
        direction = {**direction, "tau": direction.get("tau", 0.0) + gained}
        return {"": more._value({**values, "v": more._joined(direction)}, parameters)}

    def _direction(self, value: object) -> dict[str, Array]:
        """Changes by block or name."""
        where = f"jvp of {self.function}: direction"
        if value is None:
            raise ArgumentError(f"jvp of {self.function} needs direction=")
        if isinstance(value, Mapping):
            unknown = [name for name in value if name not in self.wrt]
            if unknown or len(value) < len(set(self.wrt)):
                raise ArgumentError(
                    f"{where} has {', '.join(map(brief, value))}; it takes one for each of "
                    f"{', '.join(self.wrt)}"
                )
            by_name = dict(value)
        else:
            parts = [value] if self.single else value
            if not isinstance(parts, list | tuple) or len(parts) != len(self.wrt):
                raise ArgumentError(
                    f"{where} is one array for each of {', '.join(self.wrt)}, or a mapping of them"
                )
            by_name = dict(zip(self.wrt, parts, strict=True))
        result = {}
        for name, value in by_name.items():
            array, width = numbers(f"{where} of {name}", value), self._width(name)
            if has_columns(name) and array.shape[-1:] != (width,):
                raise ArgumentError(
                    f"{where} of {name} has shape {array.shape}, expected (..., {width})"
                )
            result[name] = array
        return result

    def _joined(self, direction: Mapping[str, Array]) -> Array:
        """All of a direction as the C takes it."""
        parts = [
            np.asarray(direction[name]) if has_columns(name) else direction[name][..., None]
            for name in self._ordered
        ]
        lead = common(
            f"jvp of {self.function}: direction",
            dict(zip(self._ordered, (x.shape[:-1] for x in parts), strict=True)),
        )
        return np.concatenate([np.broadcast_to(x, (*lead, x.shape[-1])) for x in parts], axis=-1)


@dataclass(frozen=True)
class Hessian(Weighted):
    """The second derivatives of a weighted sum of results, ready to be called.

    Attributes are those of a :class:`Derivative`.
    """

    row: ClassVar[str] = "hessian"

    @property
    def _loaded(self) -> LoadedFunction:
        return self._with_gradient[1]

    @cached_property
    def _with_gradient(self) -> list[LoadedFunction]:
        """The gradient and the matrix: slopes of one are what the other is checked against."""
        return self.model._load([(Vjp.row, self.request), (self.row, self.request)])

    @cached_property
    def _in_order(self) -> bool:
        """True if rows and columns are wanted as the C has them."""
        return self._ordered == self.wrt

    @property
    def _several(self) -> tuple[tuple[int, int, tuple[int, ...]], ...]:
        """There is one result."""
        return ()

    def __call__(
        self,
        *states: object,
        parameters: Values | None = None,
        out: Array | None = None,
        **keywords: object,
    ) -> Array:
        """The matrix at states of any leading shape.

        Args:
            states, keywords: As the function takes them, ``weights`` after those that it needs;
                leading axes broadcast.
            parameters: Other values than the model's own.
            out: Array to fill and return.

        Raises:
            ArgumentError, ModelError, SolveError: as the function itself.
        """
        if self._in_order and parameters is None and out is None:
            plain = self._quick(states, keywords)
            if isinstance(plain, np.ndarray):
                return plain
        if keywords.pop("wrenches", None) is not None:
            raise ArgumentError(
                "hessian: wrenches have none. Give the scene a Force with inputs there, and hand "
                "them over as r"
            )
        matrix = self._value(self._with_weights(states, keywords), parameters)
        if not self._in_order:
            widths = [self._width(name) for name in self._ordered]
            ends = [*accumulate(widths)]
            places = {
                name: range(end - width, end)
                for name, end, width in zip(self._ordered, ends, widths, strict=True)
            }
            order = [k for name in self.wrt for k in places[name]]
            matrix = matrix[..., order, :][..., order]
        return into(matrix, out)
