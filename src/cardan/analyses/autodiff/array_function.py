"""A function of a model of plain arrays, with its products with derivatives.

Blocks are arrays (..., n) of one number of axes; t has n = 1. Derivatives along q are those along
its entries, at quaternions of length 1.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, partial
from itertools import accumulate
from math import prod

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, near
from ...records import dataclass
from ...runtime.models.derivatives import has_columns
from ...runtime.models.loaded_model import LoadedModel
from ...schema.blocks import COORDINATES, DIRECTIONS, STATE, Blocks
from ...schema.functions import DIFFERENTIABLE, FUNCTIONS
from ...schema.rows import column

# modes are whole numbers, by which there is no derivative
CONSTANT = "s"


@dataclass(frozen=True)
class ArrayFunction:
    """A function of a model.

    Attributes:
        model: Whose it is.
        name, of: The function and its frame or joint.
        arguments: What users hand over, those that are needed first.
        needed: How many of them are needed.
        blocks: What is handed on: parts of the state in place of x, parameters last.
        sizes: Length of every block.
        shape: Of the result.
    """

    model: LoadedModel
    name: str
    of: str | None
    arguments: tuple[str, ...]
    needed: int
    blocks: tuple[str, ...]
    sizes: Mapping[str, int]
    shape: tuple[int, ...]

    @classmethod
    def read(cls, what: str, model: LoadedModel, function: str | tuple[str, str]) -> ArrayFunction:
        """A function by its name, or by that and its frame or joint.

        Raises:
            ModelError: there is none, it has no derivative, or it reads what has none.
        """
        name, of = (function, None) if isinstance(function, str) else function
        if name not in DIFFERENTIABLE:
            hint = near(name, DIFFERENTIABLE)
            raise ModelError(f"{what}: '{name}' does not exist, or has no derivative.{hint}")
        model._check_of(name, of)
        row = FUNCTIONS[name]
        odd = [x for x in row.arguments if x not in (*DIRECTIONS, CONSTANT, STATE.name)]
        if odd:
            raise ModelError(
                f"{what}: {name} reads {', '.join(odd)}, by which it has no derivative"
            )
        # compiled now, so that an unknown compiler or a wrong model is told here
        outputs = model._function(name, of).outputs
        shapes = [tuple(output.shape) for output in outputs]
        shape = shapes[0] if len(shapes) == 1 else (sum(map(prod, shapes)),)
        parts = [b for x in row.arguments for b in (("q", "u", "z") if x == STATE.name else (x,))]
        sizes = _sizes(model)
        # solvers call rhs(t, x)
        needed = [x for x in ("t", STATE.name) if STATE.name in row.arguments] or row.required
        arguments = (*needed, *(x for x in row.arguments if x not in needed))
        blocks = tuple(block for block in (*parts, "p") if sizes[block])
        plain = cls(model, name, of, arguments, len(needed), blocks, sizes, shape)
        if model.manifest.absolute:
            # not every function has products over elements: that too is told here
            for wrt in plain._groups(plain.moving)[:1]:
                model.prepare(("vjp", model.vjp(plain._key, wrt=Blocks(map(_stored, wrt))).request))
        return plain

    @property
    def size(self) -> int:
        """Length of the result."""
        return prod(self.shape)

    def bound(self, states: Sequence[object], keywords: Mapping[str, object]) -> dict[str, object]:
        """Arguments by name, ``parameters`` as p; what nobody gave is None.

        Raises:
            ArgumentError: one of them is missing, or there is no such one.
        """
        # by place come those that solvers or people never leave out
        names = (*self.arguments, "parameters")
        values = dict(zip(self.arguments, states, strict=False))
        unknown = [x for x in keywords if x not in names or x in values]
        if unknown or len(states) > self.needed:
            wrong = f"not {brief(unknown[0])}" if unknown else f"not {len(states)} by place"
            raise ArgumentError(
                f"{self.name} takes {', '.join(self.arguments[: self.needed])} by place and "
                f"{', '.join(names[self.needed :])} by name, {wrong}"
            )
        values |= keywords
        missing = [x for x in self.arguments[: self.needed] if values.get(x) is None]
        if missing:
            raise ArgumentError(f"{self.name} needs {missing[0]}")
        values["p"] = values.pop("parameters", None)
        return {name: values.get(name) for name in (*self.arguments, "p")}

    def default(self, block: str) -> Array:
        """What a block is where nobody gives it."""
        if block == "p":
            return np.array([*self.model.parameters.values()], dtype=float)
        if block in ("z", "s", "r"):
            rows = self.model.manifest.z if block == "z" else self.model.manifest.s
            rows = self.model.manifest.inputs if block == "r" else rows
            return np.array([float(x) for x in column(rows, "default")])
        return np.zeros(self.sizes[block])

    def entry(self, block: str, name: str) -> int:
        """Place of an input or parameter.

        Raises:
            ArgumentError: there is no such one.
        """
        rows = self.model.manifest.parameters if block == "p" else self.model.manifest.inputs
        names = [row.name for row in rows]
        if block not in ("p", "r") or name not in names:
            where = "parameters" if block == "p" else block
            raise ArgumentError(f"{self.name}: {where} has no {brief(name)}.{near(name, names)}")
        return names.index(name)

    def value(self, *arrays: Array) -> Array:
        """Results (..., size); NaN where there are none."""
        return self._by_sets(self._value, arrays)

    def _value(self, *arrays: Array) -> Array:
        """The same with one set of parameters, or in joint coordinates."""
        lead = np.broadcast_shapes(*(np.shape(x)[:-1] for x in arrays))
        values, parameters = self._values(arrays)
        row = FUNCTIONS[self.name].arguments
        ordered = tuple(values.get(name, 0.0 if name == "t" else None) for name in row)

        def call() -> Array:
            return self.model._evaluate((self.name, self.of), ordered, parameters, None)

        return _filled(call, (*lead, self.size), self.shape)

    def gradient(self, along: Sequence[str], *arrays: Array) -> Array:
        """Derivatives of the weighted sum of results, (..., columns) of blocks one after the other.

        Args:
            along: Blocks in their order.
            arrays: Blocks, then weights (..., size).
        """
        return self._by_sets(partial(self._gradient, along), arrays)

    def _gradient(self, along: Sequence[str], *arrays: Array) -> Array:
        """The same with one set of parameters, or in joint coordinates."""
        *blocks, weights = map(np.asarray, arrays)
        lead = np.broadcast_shapes(*(x.shape[:-1] for x in (*blocks, weights)))
        values, parameters = self._values(blocks)
        values["weights"] = weights.reshape(*weights.shape[:-1], *self.shape)
        by_block: dict[str, Array] = {}
        for wrt in self._groups(along):
            product = self.model.vjp(self._key, wrt=Blocks(map(_stored, wrt)))
            ends = [*accumulate(self.sizes[block] for block in wrt)]
            call = partial(_joined, product, wrt, lead, {**values, "parameters": parameters})
            flat = _filled(call, (*lead, ends[-1]), (ends[-1],))
            # columns of one C function, of which perhaps not all are wanted
            for block, end in zip(wrt, ends, strict=True):
                by_block[block] = flat[..., end - self.sizes[block] : end]
        return np.concatenate([by_block[block] for block in along], axis=-1)

    def change(self, along: Sequence[str], *arrays: Array) -> Array:
        """Changes of the results (..., size) along a direction.

        Args:
            along: Blocks that move, in their order.
            arrays: Blocks, then the direction (..., columns) of those that move.
        """
        return self._by_sets(partial(self._change, along), arrays)

    def _change(self, along: Sequence[str], *arrays: Array) -> Array:
        """The same with one set of parameters, or in joint coordinates."""
        *blocks, direction = map(np.asarray, arrays)
        lead = np.broadcast_shapes(*(x.shape[:-1] for x in (*blocks, direction)))
        values, parameters = self._values(blocks)
        ends = accumulate(self.sizes[block] for block in along)
        moves = {b: direction[..., e - self.sizes[b] : e] for b, e in zip(along, ends, strict=True)}
        total = np.zeros((*lead, self.size))
        for wrt in self._groups(along):
            product: Callable[..., Array] = self.model.jvp(self._key, wrt=Blocks(map(_stored, wrt)))
            # what stands still costs little beside another C function for every choice of blocks
            parts = [moves.get(block, np.zeros(self.sizes[block])) for block in wrt]
            parts = [x if has_columns(b) else x[..., 0] for b, x in zip(wrt, parts, strict=True)]
            arguments = {**values, "direction": tuple(parts), "parameters": parameters}
            call = partial(product, **arguments)
            total = total + _filled(call, (*lead, self.size), self.shape)
        return total

    def _by_sets(self, function: Callable[..., Array], arrays: Sequence[Array]) -> Array:
        """Results (..., n) of a function of blocks, for one set of parameters after the other.

        Tables of elements are filled for one set; in joint coordinates a call takes any.
        """
        arrays = [np.asarray(x) for x in arrays]
        if not self.model.manifest.absolute or "p" not in self.blocks:
            return function(*arrays)
        place = self.blocks.index("p")
        sets, which = np.unique(
            arrays[place].reshape(-1, arrays[place].shape[-1]), axis=0, return_inverse=True
        )
        if len(sets) == 1:
            lead = np.broadcast_shapes(*(x.shape[:-1] for x in arrays))
            arrays[place] = sets[0]
            result = function(*arrays)
            return np.broadcast_to(result, (*lead, result.shape[-1]))
        lead = np.broadcast_shapes(*(x.shape[:-1] for x in arrays))
        which = np.broadcast_to(which.reshape(arrays[place].shape[:-1]), lead).ravel()
        flat = [np.broadcast_to(x, (*lead, x.shape[-1])).reshape(-1, x.shape[-1]) for x in arrays]
        results: Array | None = None
        for k, one in enumerate(sets):
            part = [x[which == k] for x in flat]
            part[place] = one
            rows = function(*part)
            if results is None:
                results = np.zeros((len(which), rows.shape[-1]))
            results[which == k] = rows
        assert results is not None
        return results.reshape(*lead, -1)

    @property
    def _key(self) -> str | tuple[str, str]:
        return self.name if self.of is None else (self.name, self.of)

    @cached_property
    def moving(self) -> tuple[str, ...]:
        """Blocks by which there are derivatives."""
        return tuple(block for block in self.blocks if block != CONSTANT)

    def _groups(self, along: Sequence[str]) -> list[tuple[str, ...]]:
        """Blocks of the functions to call: one for all states, one for parameters."""
        states = tuple(block for block in self.moving if block != "p")
        groups = [states] if any(block != "p" for block in along) else []
        return [*groups, *([("p",)] if "p" in along else [])]

    def _values(self, arrays: Sequence[Array]) -> tuple[dict[str, object], dict[str, Array] | None]:
        """Arguments by name, and parameters where they are others than those of the model."""
        blocks = dict(zip(self.blocks, map(np.asarray, arrays), strict=True))
        p = blocks.pop("p", None)
        if "t" in blocks:
            blocks["t"] = blocks["t"][..., 0]
        values: dict[str, object] = {**blocks}
        # solvers' functions take the state in one piece
        if STATE.name in self.arguments:
            parts = [blocks[block] for block in ("q", "u", "z") if block in blocks]
            lead = np.broadcast_shapes(*(x.shape[:-1] for x in parts))
            wide = [np.broadcast_to(x, (*lead, x.shape[-1])) for x in parts]
            values = {name: x for name, x in values.items() if name not in ("q", "u", "z")}
            values[STATE.name] = np.concatenate([*wide, np.zeros((*lead, 0))], axis=-1)
        if p is None or not (p - self.default("p")).any():
            return values, None
        return values, {name: p[..., k] for k, name in enumerate(self.model.parameters)}


def _sizes(model: LoadedModel) -> dict[str, int]:
    """Length of every block."""
    manifest = model.manifest
    size = {"t": 1, "q": model.nq, "u": model.nu, "z": model.nz, "s": len(manifest.s)}
    size |= {"r": len(manifest.inputs), "p": len(manifest.parameters)}
    return size | {"udot": model.nu, "tau": model.nu}


def _stored(block: str) -> str:
    """The name of the derivative along q as it is stored."""
    return COORDINATES if block == "q" else block


def _joined(
    product: Callable[..., Sequence[Array]],
    wrt: Sequence[str],
    lead: tuple[int, ...],
    arguments: Mapping[str, object],
) -> Array:
    """Results of a product by block, one after the other."""
    parts = zip(wrt, product(**arguments), strict=True)
    wide = [x if has_columns(block) else x[..., None] for block, x in parts]
    return np.concatenate([np.broadcast_to(x, (*lead, x.shape[-1])) for x in wide], axis=-1)


def _filled(call: Callable[[], Array], shape: tuple[int, ...], inner: tuple[int, ...]) -> Array:
    """Results (..., size), which are not numbers where a single state has none."""
    try:
        result = np.asarray(call())
    except SolveError:
        return np.full(shape, np.nan)
    flat = result.reshape(*result.shape[: result.ndim - len(inner)], shape[-1])
    return np.array(np.broadcast_to(flat, shape))
