"""Functions of a compiled model for PyTorch, with exact derivatives in both modes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from ...arguments import checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError
from ...runtime.models.loaded_model import LoadedModel
from .array_function import ArrayFunction

if TYPE_CHECKING:
    import torch
    from torch.autograd.function import FunctionCtx as Context


@checked
def to_torch(model: LoadedModel, function: str | tuple[str, str]) -> Callable[..., Any]:
    """A function of the model for PyTorch, with exact first derivatives.

    ``model.to_torch("forward_dynamics")(q, u, tau=tau).sum().backward()``

    It is a ``torch.autograd.Function`` and goes with ``backward``, forward mode, ``torch.func`` and
    its ``vmap`` (one call for all states), on the CPU. A unit quaternion counts by its direction.

    Args:
        function: Such as ``"forward_dynamics"``, or ``("pose", "hand")``: one that has derivatives.

    Returns:
        A function of the same arguments, tensors or numbers whose leading axes broadcast. ``r`` and
        ``parameters`` may be mappings of names to numbers, the rest then those of the model.
        Results are float64. What has no solution is not a number.

    Raises:
        ModuleNotFoundError: PyTorch is not installed.
        ModelError: no such function, or it has no derivatives.
    """
    try:
        import torch  # noqa: F401
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError("to_torch needs PyTorch: pip install torch") from missing
    plain = ArrayFunction.read("to_torch", model, function)

    def call(*states: object, **keywords: object) -> torch.Tensor:
        values = plain.bound(states, keywords)
        blocks = {name: _tensor(plain, name, value) for name, value in values.items()}
        if "x" in blocks:
            x, nq, nu = blocks.pop("x"), model.nq, model.nu
            blocks |= {"q": x[..., :nq], "u": x[..., nq : nq + nu], "z": x[..., nq + nu :]}
        if "q" in blocks:
            blocks["q"] = _with_unit_quaternions(blocks["q"], model.manifest.quaternions)
        # as many axes for all, so that those of vmap stand in front
        tensors = [blocks[name] for name in plain.blocks]
        most = max((tensor.ndim for tensor in tensors), default=1)
        tensors = [x.reshape((1,) * (most - x.ndim) + tuple(x.shape)) for x in tensors]
        flat = _classes()[0].apply(plain, *tensors)
        return flat.reshape(*flat.shape[:-1], *plain.shape)

    call.__name__ = call.__qualname__ = plain.name
    return call


def _tensor(plain: ArrayFunction, block: str, value: object) -> torch.Tensor:
    """A block (..., n)."""
    import torch

    if isinstance(value, Mapping):
        columns = [*torch.as_tensor(plain.default(block)).unbind(-1)]
        for name, number in value.items():
            columns[plain.entry(block, name)] = _float(plain, block, number)
        return torch.stack([*torch.broadcast_tensors(*columns)], -1)
    if block == "t":
        return _float(plain, block, 0.0 if value is None else value)[..., None]
    if value is None:
        return torch.as_tensor(plain.default(block))
    tensor, size = _float(plain, block, value), plain.sizes.get(block, plain.model.nx)
    if tensor.ndim == 0 or tensor.shape[-1] != size:
        raise ArgumentError(
            f"{plain.name}: {block} has shape {tuple(tensor.shape)}, expected (..., {size})"
        )
    return tensor


def _float(plain: ArrayFunction, block: str, value: object) -> torch.Tensor:
    """Numbers in float64."""
    import torch

    tensor = torch.as_tensor(value)
    if tensor.device.type != "cpu":
        raise ArgumentError(
            f"{plain.name}: {block} is on {tensor.device}, and the model is on the CPU: hand over "
            f"{block}.cpu()"
        )
    return tensor.to(torch.float64)


def _with_unit_quaternions(q: torch.Tensor, firsts: Sequence[int]) -> torch.Tensor:
    import torch

    parts, start = [], 0
    for first in firsts:
        part = q[..., first : first + 4]
        parts += [q[..., start:first], part / part.norm(dim=-1, keepdim=True)]
        start = first + 4
    return torch.cat([*parts, q[..., start:]], -1)


@cache
def _classes() -> tuple[torch.autograd.Function, torch.autograd.Function]:
    """The function, and its products with derivatives, which have none themselves."""
    import torch

    def value(plain: ArrayFunction, *tensors: torch.Tensor) -> torch.Tensor:
        return torch.from_numpy(plain.value(*_numbers(tensors)))

    def remember(ctx: Context, inputs: Sequence[object], output: torch.Tensor) -> None:
        ctx.plain = inputs[0]
        # both modes need the states alone
        ctx.save_for_backward(*inputs[1:])
        ctx.save_for_forward(*inputs[1:])

    def backward(ctx: Context, weights: torch.Tensor) -> tuple[torch.Tensor | None, ...]:
        plain, tensors = ctx.plain, ctx.saved_tensors
        pairs = zip(plain.blocks, ctx.needs_input_grad[1:], strict=True)
        along = tuple(block for block, needed in pairs if needed and block in plain.moving)
        if not along:
            return (None,) * (1 + len(tensors))
        flat = product_class.apply(plain.gradient, along, *tensors, weights)
        parts = flat.split([plain.sizes[block] for block in along], -1)
        by_block, shapes = (
            dict(zip(along, parts, strict=True)),
            zip(plain.blocks, tensors, strict=True),
        )
        # axes that were broadcast are summed over
        summed = {b: by_block[b].sum_to_size(x.shape) for b, x in shapes if b in by_block}
        return (None, *(summed.get(block) for block in plain.blocks))

    def forward_mode(ctx: Context, _: None, *changes: torch.Tensor | None) -> torch.Tensor:
        plain, tensors = ctx.plain, ctx.saved_tensors
        pairs = zip(plain.blocks, changes, strict=True)
        moves = {block: d for block, d in pairs if d is not None and block in plain.moving}
        # a direction is as wide as the result, whatever it was broadcast from
        lead = torch.broadcast_shapes(*(tensor.shape[:-1] for tensor in tensors))
        if not moves:
            return torch.zeros((*lead, plain.size), dtype=torch.float64)
        direction = torch.cat([d.expand(*lead, d.shape[-1]) for d in moves.values()], -1)
        return product_class.apply(plain.change, tuple(moves), *tensors, direction)

    def product(
        host: Callable[..., Array], along: tuple[str, ...], *tensors: torch.Tensor
    ) -> torch.Tensor:
        return torch.from_numpy(host(along, *_numbers(tensors)))

    def forget(ctx: Context, inputs: object, output: object) -> None:
        """A product needs nothing later on."""

    def refuse(ctx: Context, *changes: object) -> None:
        raise ModelError(
            "to_torch: functions have exact first derivatives and no second ones: take "
            "model.hessian"
        )

    def mapped(info: object, axes: Sequence[int | None], *inputs: object) -> tuple[object, int]:
        wide = [_in_front(x, axis) for x, axis in zip(inputs, axes, strict=True)]
        kind = function_class if isinstance(inputs[0], ArrayFunction) else product_class
        return kind.apply(*wide), 0

    rules: dict[str, Callable[..., object]]
    rules = {"forward": value, "setup_context": remember, "backward": backward}
    function_class = _class("ModelFunction", {**rules, "jvp": forward_mode, "vmap": mapped})
    rules = {"forward": product, "setup_context": forget, "backward": refuse}
    product_class = _class("ModelProduct", {**rules, "jvp": refuse, "vmap": mapped})
    return function_class, product_class


def _class(name: str, rules: Mapping[str, Callable[..., object]]) -> torch.autograd.Function:
    """A class as torch.autograd wants it."""
    import torch

    return type(name, (torch.autograd.Function,), {k: staticmethod(f) for k, f in rules.items()})


def _numbers(tensors: Sequence[torch.Tensor]) -> list[Array]:
    return [tensor.detach().numpy() for tensor in tensors]


def _in_front(value: object, axis: int | None) -> object:
    """A tensor with the axis of vmap in front: of one entry, where it does not depend on it."""
    import torch

    if not isinstance(value, torch.Tensor):
        return value
    return value[None] if axis is None else value.movedim(axis, 0)
