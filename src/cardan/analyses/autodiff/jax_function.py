"""Functions of a compiled model for JAX, with exact derivatives in both modes.

JAX calls Python for values and for products with derivatives. It transposes what is written as a
linear solve by a function that is handed over, under jit, vmap and scan too: the change y = J d of
a result stands as the solution of (d, y - J d) = (d, 0), whose transpose gives d + w J.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from ...arguments import checked
from ...errors import ArgumentError, ModelError
from ...runtime.models.loaded_model import LoadedModel
from .array_function import ArrayFunction

if TYPE_CHECKING:
    import jax


@checked
def to_jax(model: LoadedModel, function: str | tuple[str, str]) -> Callable[..., Any]:
    """A function of the model for JAX, with exact first derivatives in both modes.

    ``jax.grad(lambda m: model.to_jax("rhs")(0.0, x, parameters={"m": m})[3])(2.0)``

    It goes with ``jax.jit``, ``jax.vmap`` (one call for all states), ``jax.grad``, ``jax.jacfwd``
    and ``jax.jacrev``, on CPUs and in float64. Every call goes through Python, 0.3 ms: exports are
    quicker, ``equations.export(language="jax")``. A unit quaternion counts by its direction.

    Args:
        function: Such as ``"forward_dynamics"``, or ``("pose", "hand")``: one that has derivatives.

    Returns:
        A function of the same arguments, arrays whose leading axes broadcast. ``r`` and
        ``parameters`` may be mappings of names to numbers, the rest then those of the model. What
        has no solution is not a number.

    Raises:
        ModuleNotFoundError: JAX is not installed.
        ModelError: no such function, or it has no derivatives.
    """
    try:
        import jax
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError("to_jax needs JAX: pip install jax") from missing
    plain = ArrayFunction.read("to_jax", model, function)
    core = _differentiable(plain)

    def call(*states: object, **keywords: object) -> jax.Array:
        if not jax.config.jax_enable_x64:
            raise ModelError(
                'to_jax computes in float64: call jax.config.update("jax_enable_x64", True) first'
            )
        # NumPy's numbers, JAX's arrays and tracers alike
        values = plain.bound(states, keywords)
        blocks = {name: _array(plain, name, value) for name, value in values.items()}
        if "x" in blocks:
            x, nq, nu = blocks.pop("x"), model.nq, model.nu
            blocks |= {"q": x[..., :nq], "u": x[..., nq : nq + nu], "z": x[..., nq + nu :]}
        if "q" in blocks:
            blocks["q"] = _with_unit_quaternions(blocks["q"], model.manifest.quaternions)
        # one number of axes for all, so that those of jax.vmap stand in front
        arrays = [blocks[name] for name in plain.blocks]
        most = max((array.ndim for array in arrays), default=1)
        flat = core(*(array.reshape((1,) * (most - array.ndim) + array.shape) for array in arrays))
        return flat.reshape(*flat.shape[:-1], *plain.shape)

    call.__name__ = call.__qualname__ = plain.name
    return call


def _array(plain: ArrayFunction, block: str, value: object) -> jax.Array:
    """A block (..., n)."""
    import jax.numpy as jnp

    if block == "t":
        return jnp.asarray(0.0 if value is None else value, jnp.float64)[..., None]
    if value is None:
        return jnp.asarray(plain.default(block))
    if isinstance(value, Mapping):
        array = jnp.asarray(plain.default(block))
        for name, number in value.items():
            array = array.at[..., plain.entry(block, name)].set(number)
        return array
    array, size = jnp.asarray(value, jnp.float64), plain.sizes.get(block, plain.model.nx)
    if array.ndim == 0 or array.shape[-1] != size:
        raise ArgumentError(
            f"{plain.name}: {block} has shape {array.shape}, expected (..., {size})"
        )
    return array


def _with_unit_quaternions(q: jax.Array, firsts: Sequence[int]) -> jax.Array:
    import jax.numpy as jnp

    for first in firsts:
        part = q[..., first : first + 4]
        part = part / jnp.sqrt((part**2).sum(-1, keepdims=True))
        q = q.at[..., first : first + 4].set(part)
    return q


def _differentiable(plain: ArrayFunction) -> Callable[..., jax.Array]:
    """The function of blocks, with the rule of its derivative."""
    import jax

    def value(*arrays: jax.Array) -> jax.Array:
        return _called(plain.value, plain.size, arrays)

    function = jax.custom_jvp(value)

    def rule(
        arrays: Sequence[jax.Array], tangents: Sequence[object]
    ) -> tuple[jax.Array, jax.Array]:
        result, zero = function(*arrays), jax.custom_derivatives.SymbolicZero
        pairs = zip(plain.blocks, tangents, strict=True)
        moves = {b: d for b, d in pairs if not isinstance(d, zero) and b in plain.moving}
        return result, _tangent(plain, arrays, moves, result.shape)

    function.defjvp(rule, symbolic_zeros=True)
    core: Callable[..., jax.Array] = function
    return core


def _called(host: Callable[..., object], size: int, arrays: Sequence[jax.Array]) -> jax.Array:
    """Python at all states in one call."""
    import jax
    import jax.numpy as jnp

    lead = jnp.broadcast_shapes(*(array.shape[:-1] for array in arrays))
    shape = jax.ShapeDtypeStruct((*lead, size), jnp.float64)
    # an axis that jax.vmap adds comes as one entry where a block does not depend on it
    return jax.pure_callback(host, shape, *arrays, vmap_method="expand_dims")


def _one(*arrays: jax.Array) -> jax.Array:
    """The number 1, whose derivative is an error: the products below have none of their own."""
    import jax
    import jax.numpy as jnp

    def value(*arrays: jax.Array) -> jax.Array:
        return jnp.ones(())

    def refuse(arrays: object, tangents: object) -> None:
        raise ModelError(
            "to_jax: functions have exact first derivatives and no second ones (jax.hessian, a "
            "gradient of a gradient): take model.hessian"
        )

    one = jax.custom_jvp(value)
    one.defjvp(refuse)
    return one(*arrays)


def _tangent(
    plain: ArrayFunction,
    arrays: Sequence[jax.Array],
    moves: Mapping[str, jax.Array],
    shape: tuple[int, ...],
) -> jax.Array:
    """The change of the result."""
    import jax
    import jax.numpy as jnp

    if not moves:
        return jnp.zeros(shape)
    # of one vector on the right all parts must depend on the changes, zeros too: they are padding
    along, parts = (
        tuple(moves),
        [jnp.broadcast_to(d, (*shape[:-1], d.shape[-1])) for d in moves.values()],
    )
    right = jnp.concatenate(parts, -1)
    first = right.shape[-1]
    right = jnp.pad(right, [*[(0, 0)] * (len(shape) - 1), (0, plain.size)])

    def solve(_: object, x: jax.Array) -> jax.Array:
        change = _called(partial(plain.change, along), plain.size, [*arrays, x[..., :first]])
        return x.at[..., first:].add(change)

    def transposed(_: object, x: jax.Array) -> jax.Array:
        gradient = _called(partial(plain.gradient, along), first, [*arrays, x[..., first:]])
        return x.at[..., :first].add(gradient)

    # JAX reads the equations for derivatives of the solution by what they depend on alone
    solution = jax.lax.custom_linear_solve(lambda x: x * _one(*arrays), right, solve, transposed)
    return solution[..., first:]
