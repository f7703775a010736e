"""Notation of names in formulas: ``theta1.u`` is a θ with the index 1 and a dot.

Names are whatever users called their joints: each writer escapes what it writes.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...schema.blocks import of_rate

if TYPE_CHECKING:
    from ..record import EquationRecord

_GREEK = """
    alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau
    upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega
"""
GREEK = frozenset(_GREEK.split())
# numbers of a body by their dotted names: upper.mass is m with the index upper
NUMBERS = {"mass": "m", "com": "c", "inertia": "I"}
# what TeX takes for commands or layout
_TEX = {
    "\\": r"\backslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "%": r"\%",
    "_": r"\_",
    "^": r"\hat{}",
    "~": r"\sim{}",
}


@dataclass(frozen=True)
class Notation:
    """A symbol as it is set.

    Attributes:
        letter: One letter, the name of a Greek one, or a word.
        index: Below it, "" without one.
        dots: Time derivatives, 0 to 2.
    """

    letter: str
    index: str = ""
    dots: int = 0

    @property
    def is_letter(self) -> bool:
        return self.letter in GREEK or len(self.letter) == 1

    @property
    def character(self) -> str:
        """The letter itself; Greek ones by their character."""
        if self.letter not in GREEK:
            return self.letter
        name = "lamda" if self.letter.lower() == "lambda" else self.letter
        from unicodedata import lookup

        case = "CAPITAL" if self.letter[0].isupper() else "SMALL"
        return lookup(f"GREEK {case} LETTER {name.upper()}")

    def latex(self) -> str:
        """Escaped for TeX's math mode."""
        if self.letter in GREEK:
            # capitals that look like Latin ones have no command; none of them is in GREEK
            base = f"\\{self.letter}"
        else:
            base = self.letter if self.is_letter and self.letter.isalnum() else _word(self.letter)
        if self.dots:
            base = f"\\{'d' * self.dots}ot{{{base}}}"
        return f"{base}_{{{_index(self.index)}}}" if self.index else base


def notation(name: str, dots: int = 0) -> Notation:
    """Notation of a name: digits at its end, and the part after a dot, are subscripts."""
    letters = re.fullmatch(r"([^\W\d_]+)_?(\d+)", name)
    if letters:
        return Notation(letters[1], letters[2], dots)
    number = re.fullmatch(r"(.+)\.(mass|com|inertia)(?:\.([xyz]+))?", name)
    if number:
        return Notation(NUMBERS[number[2]], ",".join(filter(None, (number[1], number[3]))), dots)
    head, sign, tail = name.partition("_")
    if sign and tail and (head in GREEK or len(head) == 1):
        return Notation(head, tail, dots)
    head, sign, tail = name.partition(".")
    if sign and head and tail:
        first = Notation("g") if head == "gravity" else notation(head, dots)
        return Notation(first.letter, ",".join(filter(None, (first.index, tail))), dots)
    return Notation(name, "", dots)


def symbols(equations: EquationRecord) -> Mapping[str, Notation]:
    """Notation by name of symbol, for coordinates, speeds, inputs and parameters.

    A speed that is the rate of a coordinate is that coordinate with a dot, any other one a u.
    """
    plain = _rates(equations)
    notations: dict[str, Notation] = {}
    for letter in ("p", "r", "q"):
        for name in equations.blocks[letter].entries:
            notations[name] = notation(name)
    for name, rate in zip(equations.speeds, equations.blocks["udot"].entries, strict=True):
        coordinate = plain.get(name)
        for key, dots in ((name, 0), (rate, 1)):
            if coordinate is not None:
                notations[key] = notation(coordinate, dots + 1)
            else:
                notations[key] = Notation("u", of_rate(name), dots)
    return _distinct(notations)


def _distinct(notations: Mapping[str, Notation]) -> Mapping[str, Notation]:
    """Names that would look the same are set as they are."""
    first: dict[Notation, str] = {}
    for name, sign in notations.items():
        first.setdefault(sign, name)
    return {n: s if first[s] == n else Notation(n) for n, s in notations.items()}


def _rates(equations: EquationRecord) -> dict[str, str]:
    """Speed -> the coordinate whose rate it is."""
    if equations.chosen:
        return {}
    return {
        equations.speeds[joint.u]: equations.coordinates[joint.q]
        for joint in equations.system.joints
        if joint.u >= 0 and len(joint.element.coordinates) == len(joint.element.speeds) == 1
    }


def _word(text: str) -> str:
    return rf"\mathrm{{{''.join(_TEX.get(c, c) for c in text)}}}"


def _index(text: str) -> str:
    return text if text.isalnum() and len(text) <= 2 else _word(text)


# functions that are set by their name
NAMED = {"sin": "sin", "cos": "cos", "cot": "cot", "rotation_vector": "log"}
SUM, DOT, PRODUCT, UNARY, POWER, ATOM = range(6)
Set = tuple[str, str, str]  # text, MathML, LaTeX


def typeset(formula: str) -> Set:
    """A formula ``left = right``, written in Python, as text, MathML and LaTeX.

    Only what the formulas of elements use is known: arithmetic, ``@``, ``.T``, a few functions.
    """
    (statement,) = ast.parse(formula).body
    assert isinstance(statement, ast.Assign)
    left, right = _set(statement.targets[0])[1], _set(statement.value)[1]
    return (
        f"{left[0]} = {right[0]}",
        f"<mrow>{left[1]}<mo>=</mo>{right[1]}</mrow>",
        f"{left[2]} = {right[2]}",
    )


def _set(node: ast.expr) -> tuple[int, Set]:
    """How tightly an expression binds, and how it is set."""
    if isinstance(node, ast.Name):
        return ATOM, _typeset_name(node.id)
    if isinstance(node, ast.Constant):
        number = repr(node.value)
        return ATOM, (number, f"<mn>{number}</mn>", number)
    if isinstance(node, ast.Attribute):
        base = _at_least(node.value, ATOM)
        return ATOM, (f"{base[0]}ᵀ", f"<msup>{base[1]}<mi>T</mi></msup>", f"{{{base[2]}}}^T")
    if isinstance(node, ast.UnaryOp):
        inner = _at_least(node.operand, DOT)
        return SUM, (f"-{inner[0]}", f"<mo>−</mo>{inner[1]}", f"-{inner[2]}")
    if isinstance(node, ast.BinOp):
        return _operation(node)
    assert isinstance(node, ast.Call)
    return _call(node)


def _at_least(node: ast.expr, tightness: int) -> Set:
    """An expression, in brackets where it binds less tightly."""
    binding, done = _set(node)
    return done if binding >= tightness else _bracketed(done)


def _bracketed(inner: Set) -> Set:
    text, mathml, latex = inner
    brackets = '<mo stretchy="false">(</mo>{}<mo stretchy="false">)</mo>'
    return f"({text})", f"<mrow>{brackets.format(mathml)}</mrow>", rf"\left({latex}\right)"


def _operation(node: ast.BinOp) -> tuple[int, Set]:
    if isinstance(node.op, (ast.Add, ast.Sub)):
        sign, operator = ("+", "+") if isinstance(node.op, ast.Add) else ("-", "−")
        a, b = _set(node.left)[1], _at_least(node.right, DOT)
        return SUM, (f"{a[0]} {sign} {b[0]}", f"{a[1]}<mo>{operator}</mo>{b[1]}",
                     f"{a[2]} {sign} {b[2]}")  # fmt: skip
    if isinstance(node.op, ast.Div):
        a, b = _set(node.left)[1], _set(node.right)[1]
        text = f"{_at_least(node.left, PRODUCT)[0]} / {_at_least(node.right, UNARY)[0]}"
        mathml = f"<mfrac><mrow>{a[1]}</mrow><mrow>{b[1]}</mrow></mfrac>"
        return PRODUCT, (text, mathml, rf"\frac{{{a[2]}}}{{{b[2]}}}")
    if isinstance(node.op, ast.Pow):
        a, b = _at_least(node.left, ATOM), _set(node.right)[1]
        return POWER, (f"{a[0]}^{b[0]}", f"<msup>{a[1]}{b[1]}</msup>", f"{{{a[2]}}}^{{{b[2]}}}")
    a, b = _at_least(node.left, PRODUCT), _at_least(node.right, UNARY)
    times = "<mo>&#x2062;</mo>"
    return PRODUCT, (f"{a[0]} {b[0]}", f"{a[1]}{times}{b[1]}", rf"{a[2]} \, {b[2]}")


def _call(node: ast.Call) -> tuple[int, Set]:
    assert isinstance(node.func, ast.Name)
    function, arguments = node.func.id, node.args
    if function == "dot":
        a, b = (_at_least(x, PRODUCT) for x in arguments)
        return DOT, (f"{a[0]} · {b[0]}", f"{a[1]}<mo>·</mo>{b[1]}", rf"{a[2]} \cdot {b[2]}")
    parts = [_set(x)[1] for x in arguments]
    if function == "skew":
        text, mathml, latex = parts[0]
        return ATOM, (f"[{text}]", f"<mover><mrow>{mathml}</mrow><mo>~</mo></mover>",
                      rf"\widetilde{{{latex}}}")  # fmt: skip
    if function == "inverse":
        text, mathml, latex = _at_least(arguments[0], ATOM)
        return ATOM, (f"{text}⁻¹", f"<msup>{mathml}<mrow><mo>−</mo><mn>1</mn></mrow></msup>",
                      f"{{{latex}}}^{{-1}}")  # fmt: skip
    if function == "sqrt":
        text, mathml, latex = parts[0]
        return ATOM, (f"sqrt({text})", f"<msqrt>{mathml}</msqrt>", rf"\sqrt{{{latex}}}")
    if function in NAMED:
        text, mathml, latex = _bracketed(parts[0])
        word = NAMED[function]
        return ATOM, (f"{word}{text}", f"<mi>{word}</mi>{mathml}", rf"\{word}{latex}")
    columns = {"column": 1, "block": 2}.get(function, len(parts))
    if function == "diagonal":
        head = ("diag", "<mi>diag</mi>", r"\operatorname{diag}")
        return ATOM, _joined(head, _matrix(parts, columns))
    return ATOM, _matrix(parts, columns)


def _joined(a: Set, b: Set) -> Set:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _matrix(parts: list[Set], columns: int) -> Set:
    rows = [parts[k : k + columns] for k in range(0, len(parts), columns)]
    text = "; ".join(", ".join(x[0] for x in row) for row in rows)
    mathml = "".join(
        "<mtr>" + "".join(f"<mtd>{x[1]}</mtd>" for x in row) + "</mtr>" for row in rows
    )
    latex = r" \\ ".join(" & ".join(x[2] for x in row) for row in rows)
    table = f"<mrow><mo>(</mo><mtable>{mathml}</mtable><mo>)</mo></mrow>"
    return f"({text})", table, rf"\begin{{pmatrix}} {latex} \end{{pmatrix}}"


def _typeset_name(name: str) -> Set:
    """A letter with dots and an index: ``omegadot_1``."""
    match = re.fullmatch(r"([A-Za-z]+?)(dot)?(?:_(\w+))?", name)
    assert match is not None, name
    letter, dotted, index = match.groups()
    letter = "lambda" if letter == "lam" else letter
    greek, sign = letter in GREEK, Notation(letter).character
    mathml = f"<mi>{sign}</mi>"
    latex = f"\\{letter}" if greek else letter if len(letter) == 1 else rf"\mathrm{{{letter}}}"
    if dotted:
        mathml, latex = f"<mover>{mathml}<mo>.</mo></mover>", rf"\dot{{{latex}}}"
    if index:
        tag = "mn" if index.isdigit() else "mi"
        mathml, latex = f"<msub>{mathml}<{tag}>{index}</{tag}></msub>", f"{latex}_{{{index}}}"
    return name, mathml, latex
