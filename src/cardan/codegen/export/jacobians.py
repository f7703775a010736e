"""Derivatives that come along where functions are called with their Jacobians."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field

from ...equations.record import EquationRecord
from ...errors import DerivationError
from ...records import dataclass
from ...schema.blocks import COORDINATES, DIRECTIONS
from ...schema.functions import DIFFERENTIABLE, FUNCTIONS
from ...schema.request import Request

Pair = tuple[str, str | None]
# what is a constant to those that call: modes change at events alone
CONSTANT = ("s",)


@dataclass
class _Chosen:
    """What a user named of the derivatives of a function.

    Attributes:
        derivative: Blocks of Jacobians.
        products: Function with a vector -> its blocks.
    """

    derivative: dict[str, None] = field(default_factory=dict)
    products: dict[str, set[str]] = field(default_factory=dict)


def with_jacobians(
    equations: EquationRecord,
    language: str,
    products: Sequence[str],
    named: Sequence[Pair],
    requested: Sequence[Pair],
) -> list[Pair]:
    """Functions of an export with the derivatives of those that a user named.

    They are along all that a function reads. Those by parameters are a C function of their own,
    which is called only where somebody wants it; a derivative that was named without them, such
    as ``forward_dynamics: q u``, leaves them out. Second derivatives, and with them the product
    that they are derivatives of, come along where they are named, with parameters where these are.

    Args:
        equations, language: As an export takes them.
        products: Products with derivatives that the language has.
        named: What the user asked for.
        requested: The same, with what belongs to it.

    Raises:
        DerivationError: one of them has no derivative, or is none of the language.
    """
    chosen: dict[Pair, _Chosen] = {}
    for name, of in named:
        if FUNCTIONS[name].of != "function":
            _check(language, name)
            chosen.setdefault((name, of), _Chosen())
            continue
        request = _request(language, products, name, of or "")
        one = chosen.setdefault((request.function, request.of), _Chosen())
        if name == "derivative":
            one.derivative |= dict.fromkeys(request.wrt)
        else:
            one.products.setdefault(name, set()).update(request.wrt)
    result = [pair for pair in requested if FUNCTIONS[pair[0]].of != "function"]
    result += [pair for pair in chosen if pair not in result]
    for (name, of), one in chosen.items():
        _check(language, name)
        result += _derivatives(name, of, one, _readable(equations, name))
    return result


def _derivatives(name: str, of: str | None, one: _Chosen, readable: Sequence[str]) -> list[Pair]:
    """Derivatives of a function, those by parameters apart."""
    states, named = [block for block in readable if block != "p"], one.derivative
    by_second = "p" in one.products.get("hessian", ())
    by_parameters = "p" in readable and (not named or "p" in named or by_second)
    parts = [part for part in (states, ["p"] if by_parameters else []) if part]
    kinds = ["derivative", *(["vjp"] if one.products else [])]
    result = [(kind, str(Request(name, of, tuple(part)))) for kind in kinds for part in parts]
    if "hessian" in one.products:
        blocks = [*states, *(["p"] if by_second and by_parameters else [])]
        result += [("hessian", str(Request(name, of, tuple(blocks))))] if blocks else []
    return [*result]


def _request(language: str, products: Sequence[str], name: str, of: str) -> Request:
    """What stands behind the name of a derivative.

    Raises:
        DerivationError: the language has no such one, or it is by a single parameter or input.
    """
    if name not in ("derivative", *products):
        raise DerivationError(
            f"language '{language}' takes no '{name}' of a function, but "
            f"{', '.join(('derivative', *products))}. Take language='c'"
        )
    request = Request.read(of)
    for block in request.wrt:
        if block not in DIRECTIONS:
            raise DerivationError(
                f"language '{language}': derivatives of '{request.function}' are by whole "
                f"blocks, not by '{block}' alone: take 'p' or 'r'"
            )
    return request


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
