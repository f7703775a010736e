"""Names of the symbols and functions of time in written equations. Loads SymPy."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import sympy
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from ...errors import ModelError, near
from ...records import dataclass
from .leaves import is_table, leaves
from .sources import Source

# what the derivatives of an input are called behind its name
DERIVED = ("", ".rate", ".acceleration")


@dataclass(frozen=True)
class Names:
    """Names of everything that equations speak of.

    Attributes:
        q, u: Names in the order of the source.
        inputs: Input or derivative of one -> name; the value stands before its derivatives.
        parameters: Name -> default value.
        names: Symbol or function of time -> name, of all of these and the time.
    """

    q: tuple[str, ...]
    u: tuple[str, ...]
    inputs: Mapping[sympy.Expr, str]
    parameters: Mapping[str, float]
    names: Mapping[sympy.Expr, str]


def names_of(
    source: Source,
    expressions: Iterable[sympy.Expr],
    parameter_values: Mapping[sympy.Expr, float],
    inputs: Iterable[sympy.Expr],
) -> Names:
    """Names for what the expressions of a source have.

    Args:
        source: The equations.
        expressions: All that is computed.
        parameter_values: Symbol or name -> default value of parameters.
        inputs: Functions of time that shall be inputs even if nothing depends on them.

    Raises:
        ModelError: unknown functions, accelerations, names given twice, parameters without value.
    """
    t = dynamicsymbols._t
    q = tuple(_called(x, "coordinate") for x in source.q)
    coordinate_names = dict(zip(source.q, q, strict=True))
    u = tuple(_speed(x, coordinate_names) for x in source.u)
    names: dict[sympy.Expr, str] = {t: "t"} | coordinate_names | dict(zip(source.u, u, strict=True))
    rates = {x.diff(t) for x in source.q}
    zero = {x for v in source.zero for x in (v, v.diff(t))}
    leaves_of_all = leaves(expressions)
    moving = {x: _input(x, source) for x in leaves_of_all if not x.is_Symbol}
    moving = {x: name for x, name in moving.items() if not (x in names or x in rates or x in zero)}
    moving |= {x: _called(x, "input") for x in inputs}
    ordered = dict(sorted(moving.items(), key=lambda pair: pair[1]))
    parameters = _parameters(
        {x for x in leaves_of_all if x.is_Symbol} - {t}, source, parameter_values
    )
    names |= ordered | {symbol: symbol.name for symbol in parameters}
    _differ(names)
    values = {symbol.name: value for symbol, value in parameters.items()}
    return Names(q, u, ordered, values, names)


def _called(x: sympy.Expr, what: str) -> str:
    """Name of a function of time.

    Raises:
        ModelError: it is none.
    """
    if not isinstance(x, AppliedUndef) or x.args != (dynamicsymbols._t,):
        raise ModelError(
            f"from_sympy: {what} {x} is not a function of time; make it with dynamicsymbols('{x}')"
        )
    return str(x.func.__name__)


def _speed(x: sympy.Expr, coordinate_names: Mapping[sympy.Expr, str]) -> str:
    """Name of a speed: ``<coordinate>.u`` where it is the derivative of a coordinate."""
    if isinstance(x, sympy.Derivative) and x.derivative_count == 1 and x.expr in coordinate_names:
        return f"{coordinate_names[x.expr]}.u"
    return _called(x, "speed")


def _input(x: sympy.Expr, source: Source) -> str:
    """Name of a function of time, or of the derivative of one, as an input.

    Raises:
        ModelError: it is a function of something else, or an acceleration.
    """
    if is_table(x):
        raise ModelError(
            f"from_sympy: {x} is a table of data, which cannot stand in written equations; write "
            "an expression, or let it come in by an input"
        )
    order, base = (x.derivative_count, x.expr) if isinstance(x, sympy.Derivative) else (0, x)
    if base in source.q or base in source.u:
        if order <= 1 and base in source.q:
            return ""
        if order == 0:
            return ""
        raise ModelError(
            f"from_sympy: {x} is an acceleration; all of them belong to the product of M, and "
            "neither into f, the kinematics or constraints nor into outputs"
        )
    if not isinstance(base, AppliedUndef) or base.args != (dynamicsymbols._t,):
        raise ModelError(
            f"from_sympy: '{base}' is not a function that C code can be written for. Give its "
            "expression; inputs are functions of the time alone"
        )
    if order >= len(DERIVED) or isinstance(base, sympy.Derivative):
        raise ModelError(f"from_sympy: {x}: inputs have two derivatives at most")
    return f"{base.func.__name__}{DERIVED[order]}"


def _many(count: int) -> str:
    return "1 symbol has" if count == 1 else f"{count} symbols have"


def _parameters(
    symbols: Iterable[sympy.Expr], source: Source, parameter_values: Mapping[sympy.Expr, float]
) -> dict[sympy.Expr, float]:
    """Symbol -> default value, by name; those that nothing depends on stand last.

    Raises:
        ModelError: one has no value.
    """
    ordered = sorted(symbols, key=lambda symbol: str(symbol.name))
    by_name = {symbol.name: symbol for symbol in ordered}
    if len(by_name) < len(ordered):
        _differ({symbol: symbol.name for symbol in ordered})
    values = {
        str(getattr(key, "name", key)): value
        for mapping in (source.values, parameter_values)
        for key, value in mapping.items()
    }
    names_listed = [str(getattr(key, "name", key)) for key in parameter_values]
    for name in names_listed:
        if name not in by_name:
            raise ModelError(
                f"from_sympy: parameters: '{name}' does not occur in the equations; leave it out."
                f"{near(name, by_name)}"
            )
    missing = [name for name in by_name if name not in values]
    if missing:
        listed = ", ".join(f"'{name}': ..." for name in missing)
        idle = [name for name in values if name not in by_name]
        hint = near(missing[0], idle).replace(" Known:", " Used by nothing:") if idle else ""
        raise ModelError(
            f"from_sympy: {_many(len(missing))} no value: give parameters={{{listed}}}.{hint}"
        )
    parameters = {symbol: float(values.pop(name)) for name, symbol in by_name.items()}
    return parameters | {sympy.Symbol(name): float(value) for name, value in values.items()}


def _differ(names: Mapping[sympy.Expr, str]) -> None:
    """Names that stand for one thing each.

    Raises:
        ModelError: one stands for two.
    """
    taken: dict[str, sympy.Expr] = {}
    for thing, name in names.items():
        if name in taken:
            raise ModelError(
                f"from_sympy: the name '{name}' stands for {sympy.srepr(taken[name])} and for "
                f"{sympy.srepr(thing)}; rename one of them"
            )
        taken[name] = thing


def scalars(source: Source) -> Sequence[sympy.Expr]:
    """All expressions of a source that are computed."""
    return (
        *source.rates,
        *source.M,
        *source.f,
        *source.positions.values(),
        *source.speeds.values(),
        *source.applied,
    )
