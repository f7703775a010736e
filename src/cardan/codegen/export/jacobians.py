"""Derivatives that come along where functions are called with their Jacobians."""

from __future__ import annotations

from collections.abc import Sequence

from ...equations.record import EquationRecord
from ...errors import DerivationError
from ...schema.blocks import COORDINATES, DIRECTIONS
from ...schema.functions import DIFFERENTIABLE, FUNCTIONS
from ...schema.request import Request

Pair = tuple[str, str | None]
# what is a constant to those that call: modes change at events alone
CONSTANT = ("s",)


def with_jacobians(
    equations: EquationRecord, language: str, named: Sequence[Pair], requested: Sequence[Pair]
) -> list[Pair]:
    """Functions of an export with the derivatives of those that a user named.

    They are along all that a function reads. Those by parameters are a C function of their own,
    which is called only where somebody wants it; a derivative that was named without them, such
    as ``forward_dynamics: q u``, leaves them out.

    Raises:
        DerivationError: one of them has no derivative.
    """
    blocks: dict[Pair, dict[str, None]] = {}
    for name, of in named:
        if FUNCTIONS[name].of != "function":
            _check(language, name)
            blocks.setdefault((name, of), {})
            continue
        request = Request.read(of or "")
        for block in request.wrt:
            if block not in DIRECTIONS:
                raise DerivationError(
                    f"language '{language}': derivatives of '{request.function}' are by whole "
                    f"blocks, not by '{block}' alone: take 'p' or 'r'"
                )
        blocks.setdefault((request.function, request.of), {}).update(dict.fromkeys(request.wrt))
    result = [pair for pair in requested if FUNCTIONS[pair[0]].of != "function"]
    result += [pair for pair in blocks if pair not in result]
    for (name, of), chosen in blocks.items():
        _check(language, name)
        readable = _readable(equations, name)
        states = [block for block in readable if block != "p"]
        parameters = ["p"] if "p" in readable and (not chosen or "p" in chosen) else []
        for part in (states, parameters):
            if part:
                result.append(("derivative", str(Request(name, of, tuple(part)))))
    return result


def _readable(equations: EquationRecord, name: str) -> list[str]:
    """Blocks by which a function can be differentiated, in the order of the ABI."""
    letters = {*FUNCTIONS[name].reads.replace("x", "q u z").split(), "p"}
    present = {block for block in letters if len(equations.blocks[block])}
    present |= {COORDINATES} if "q" in present else set()
    left_out = ("q", *CONSTANT)
    return [block for block in DIRECTIONS if block in present and block not in left_out]


def _check(language: str, name: str) -> None:
    """Refuse a function that has no derivative by all that it reads.

    Raises:
        DerivationError: it has none.
    """
    odd = [b for b in FUNCTIONS[name].arguments if b not in (*DIRECTIONS, "x")]
    if name in DIFFERENTIABLE and not odd:
        return
    why = f": it reads {', '.join(odd)}" if odd else ""
    raise DerivationError(
        f"language '{language}': function '{name}' has no derivative{why}, and what is called with "
        f"its Jacobian needs one. Leave it out, or take language='c'"
    )
