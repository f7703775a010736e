"""SymPy expressions as text of scene files, such that reading it gives the same expression."""

from __future__ import annotations

import re
from functools import cache
from typing import TYPE_CHECKING

from ....errors import ModelError
from ...parameters import Placeholder
from ...scene import SceneRecord
from ...terms import COMPONENTS
from ..expression import AGAINST, FUNCTIONS

if TYPE_CHECKING:
    import sympy

    from ....elements.tables import Interpolation

PLAIN = re.compile(r"[A-Za-z_]\w*(\.\w+)*", re.ASCII)
# how tightly text binds: a sum, a product, a power, everything else
SUM, PRODUCT, POWER, ATOM = range(4)


class ExpressionText:
    """Writes the expressions of one model.

    Attributes:
        model: The model; its symbols may stand in expressions.
        local: Names of own coordinates that an element may use.
        tables: Name -> measured function, as far as written.
    """

    def __init__(self, model: SceneRecord) -> None:
        self.model = model
        self.local: tuple[str, ...] = ()
        self.tables: dict[str, Interpolation] = {}

    def text(self, expression: object, where: str) -> str:
        """The text of an expression.

        Raises:
            ModelError: it has what no scene file can say.
        """
        self.where = where
        return self._write(expression)[0]

    def _write(self, e: sympy.Expr) -> tuple[str, int]:
        """Text and how tightly it binds."""
        if getattr(e, "is_Relational", False) or getattr(e, "is_Boolean", False):
            return self._call(e), ATOM
        if e.is_Symbol:
            return self._symbol(e.name), ATOM
        if e.is_Number:
            return self._number(e)
        if e.is_Add:
            return self._sum(e), SUM
        if e.is_Mul:
            return self._product(e), PRODUCT
        if e.is_Pow:
            return self._power(e)
        data = getattr(e, "cardan_table", None)
        if data is not None:
            return f"{self._table(e)}({self._write(e.args[0])[0]})", ATOM
        return self._call(e), ATOM

    def _inside(self, e: object, least: int) -> str:
        """Text, in parentheses where it binds less than wanted."""
        text, binding = self._write(e)
        return text if binding >= least else f"({text})"

    def _number(self, e: sympy.Expr) -> tuple[str, int]:
        if not e.is_finite or not e.is_extended_real:
            raise self._refused(e)
        if e.is_Integer:
            text, binding = str(int(e)), ATOM
        elif e.is_Rational:
            text, binding = f"{int(e.p)}/{int(e.q)}", PRODUCT
        else:
            text, binding = repr(float(e)), ATOM
        return text, SUM if text[0] == "-" else binding

    def _sum(self, e: sympy.Expr) -> str:
        text = ""
        for term in e.args:
            term_text = self._inside(term, PRODUCT) if text else self._write(term)[0]
            if text and term_text.startswith("("):
                inner, binding = self._write(term)
                term_text = inner if inner.startswith("-") and binding == SUM else term_text
            minus = term_text.startswith("-")
            text += (" - " + term_text[1:] if minus else " + " + term_text) if text else term_text
        return text

    def _product(self, e: sympy.Expr) -> str:
        """A number before what it multiplies, but after a sum: it would be multiplied out."""
        number, factors = e.as_coeff_mul()
        above = [f for f in factors if not _reciprocal(f)]
        below = [1 / f for f in factors if _reciprocal(f)]
        sign, size = ("-", -number) if number.is_negative else ("", number)
        exact = size.is_Rational
        factor_text, q = (str(int(size.p)), int(size.q)) if exact else (self._number(size)[0], 1)
        texts = [self._inside(f, POWER) for f in above]
        if factor_text != "1":
            late = bool(above) and above[0].is_Add
            texts.insert(len(texts) if late else 0, factor_text)
        if sign and above and above[0].is_Add:
            texts, sign = [*texts, "(-1)"], ""
        text = sign + ("*".join(texts) or "1")
        for factor in below:
            text += "/" + self._inside(factor, POWER)
        return text if q == 1 else f"{text}/{q}"

    def _power(self, e: sympy.Expr) -> tuple[str, int]:
        base, exponent = e.args
        if exponent.is_Rational and exponent.p == 1 and exponent.q == 2:
            return f"sqrt({self._write(base)[0]})", ATOM
        if exponent.is_Rational and exponent.is_negative:
            return f"1/{self._inside(1 / e, POWER)}", PRODUCT
        return f"{self._inside(base, ATOM)}^{self._inside(exponent, ATOM)}", POWER

    # names

    def _symbol(self, name: str) -> str:
        model = self.model
        if name in self.local or name == "t" or name in model.parameters or name in model.inputs:
            return quoted(name)
        entry = model.atoms.get(name)
        if entry is None:
            raise ModelError(
                f"{self.where}: '{name}' is not a parameter, input, coordinate or motion of the "
                "model"
            )
        return self._motion(entry)

    def _motion(self, entry: Placeholder) -> str:
        """``q(elbow)``, ``velocity(tip wrt base).x``."""
        if entry.quantity == "state":
            return f"state({quoted(str(entry.place))})"
        if entry.quantity in ("q", "u"):
            component = f".{entry.component}" if entry.component else ""
            return f"{entry.quantity}({quoted(entry.place + component)})"
        cells = COMPONENTS[9 if entry.quantity == "rotation" else 3]
        frames = zip(AGAINST, (entry.wrt, entry.in_), strict=True)
        against = "".join(f" {word} {quoted(o.name)}" for word, o in frames if o is not None)
        name = quoted(entry.place.name) + against
        return f"{entry.quantity}({name}).{cells[entry.component]}"

    def _table(self, e: sympy.Expr) -> str:
        if e.cardan_derivative:
            raise self._refused(e)
        return self.table(e.cardan_points)

    def table(self, points: Interpolation) -> str:
        """The name of a table, which is written too."""
        self.tables[points.name] = points
        return points.name

    # functions

    def _call(self, e: sympy.Expr) -> str:
        if e.is_Atom:
            return self._constant(e)
        if e.is_Relational:
            left, right = (self._write(side)[0] for side in e.args)
            return f"{left} {e.rel_op} {right}"
        if type(e).__name__ == "Piecewise":
            return self._select(e)
        name = _functions().get(e.func)
        if name is None:
            raise self._refused(e)
        return f"{name}({', '.join(self._write(argument)[0] for argument in e.args)})"

    def _constant(self, e: object) -> str:
        text = {"pi": "pi", "E": "exp(1)"}.get(str(e))
        if text is None:
            raise self._refused(e)
        return text

    def _select(self, e: sympy.Expr) -> str:
        """``select(condition, a, b)``: the last piece must hold otherwise."""
        *cases, (otherwise, last) = e.args
        if str(last) != "True":
            raise self._refused(e)
        arguments = [part for value, condition in cases for part in (condition, value)]
        return f"select({', '.join(self._write(word)[0] for word in [*arguments, otherwise])})"

    def _refused(self, e: object) -> ModelError:
        return ModelError(f"{self.where}: '{str(e)[:80]}' cannot be said in a scene file")


def quoted(name: str) -> str:
    """A name as it stands in an expression: in quotes unless it is plain."""
    if PLAIN.fullmatch(name) and name not in AGAINST:
        return name
    escaped = name.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def _reciprocal(factor: sympy.Expr) -> bool:
    """True for 1/x, x**(-2) and the like, which stand below the line."""
    return bool(factor.is_Pow and factor.exp.is_Number and factor.exp.is_negative)


@cache
def _functions() -> dict[sympy.Basic, str]:
    """SymPy's functions -> their names in files."""
    import sympy

    return {getattr(sympy, theirs): ours for ours, theirs in FUNCTIONS.items() if ours != "sqrt"}
