"""Formulas written in Python as text, MathML and LaTeX, in segments between which lines may end.

Only what the formulas of elements use is known: arithmetic, ``@``, ``.T``, a few functions.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

from .notation import GREEK, Notation

# functions that are set by their name
NAMED = {"sin": "sin", "cos": "cos", "cot": "cot", "rotation_vector": "log", "atan2": "atan2"}
# functions whose arguments stand one beside the other in brackets
LISTED = {"diagonal": "diag"}
CONDITION, SUM, DOT, PRODUCT, UNARY, POWER, ATOM = range(7)
TIMES = "<mo>&#x2062;</mo>"


class Segment(NamedTuple):
    """A part of a formula that stays together on a line."""

    text: str
    mathml: str
    latex: str


Segments: TypeAlias = tuple[Segment, ...]


def typeset(formula: str) -> Segments:
    """A formula ``left = right`` or an expression, in segments."""
    (statement,) = ast.parse(formula).body
    if isinstance(statement, ast.Expr):
        return _set(statement.value)[1]
    assert isinstance(statement, ast.Assign)
    left, right = _set(statement.targets[0])[1], _set(statement.value)[1]
    return _before(_joined((*left, Segment("=", "<mo>=</mo>", "="))), right)


def text_of(formula: str) -> str:
    """A formula as text on one line."""
    return unbroken(typeset(formula)).text


def unbroken(segments: Sequence[Segment]) -> Segment:
    """A formula that stays on one line."""
    return _joined(segments)


def _joined(segments: Sequence[Segment]) -> Segment:
    texts, mathmls, latexes = zip(*segments, strict=True)
    return Segment(" ".join(texts), "".join(mathmls), " ".join(latexes))


def _before(first: Segment, segments: Segments, space: str = " ", tex: str = " ") -> Segments:
    """Segments of which the first has something before it."""
    text, mathml, latex = segments[0]
    led = Segment(first.text + space + text, first.mathml + mathml, first.latex + tex + latex)
    return (led, *segments[1:])


def _after(segments: Segments, last: Segment) -> Segments:
    """Segments of which the last has something right behind it."""
    text, mathml, latex = segments[-1]
    closed = Segment(text + last.text, mathml + last.mathml, latex + last.latex)
    return (*segments[:-1], closed)


def _set(node: ast.expr) -> tuple[int, Segments]:
    """How tightly an expression binds, and how it is set."""
    if isinstance(node, ast.Name):
        return ATOM, (_name(node.id),)
    if isinstance(node, ast.Constant):
        number = repr(node.value)
        return ATOM, (Segment(number, f"<mn>{number}</mn>", number),)
    if isinstance(node, ast.Attribute):
        base = unbroken(_at_least(node.value, ATOM))
        mathml = f"<msup><mrow>{base.mathml}</mrow><mi>T</mi></msup>"
        return ATOM, (Segment(f"{base.text}ᵀ", mathml, f"{{{base.latex}}}^T"),)
    if isinstance(node, ast.UnaryOp):
        minus = Segment("-", "<mo>−</mo>", "-")
        return SUM, _before(minus, _at_least(node.operand, DOT), "", "")
    if isinstance(node, ast.BinOp):
        return _operation(node)
    if isinstance(node, ast.Compare):
        left, right = _at_least(node.left, SUM), _at_least(node.comparators[0], SUM)
        sign = RELATIONS[type(node.ops[0])]
        return CONDITION, (*left, *_before(sign, right))
    if isinstance(node, ast.IfExp):
        value, condition, other = (_at_least(x, CONDITION)
                                   for x in (node.body, node.test, node.orelse))  # fmt: skip
        return CONDITION, (*value, *_before(_word("if"), condition), *_before(_word("else"), other))
    assert isinstance(node, ast.Call)
    return _call(node)


RELATIONS: dict[type[ast.cmpop], Segment] = {
    ast.Lt: Segment("<", "<mo>&lt;</mo>", "<"),
    ast.Gt: Segment(">", "<mo>&gt;</mo>", ">"),
    ast.LtE: Segment("<=", "<mo>≤</mo>", r"\le"),
    ast.Eq: Segment("==", "<mo>=</mo>", "="),
}


def _word(word: str) -> Segment:
    mathml = f"<mspace width='0.3em'/><mtext>{word}</mtext><mspace width='0.3em'/>"
    return Segment(word, mathml, rf"\text{{{word}}}")


def _at_least(node: ast.expr, tightness: int) -> Segments:
    """An expression, in brackets where it binds less tightly."""
    binding, done = _set(node)
    return done if binding >= tightness else _bracketed(done)


def _bracketed(inner: Segments) -> Segments:
    # brackets that may stand on two lines cannot grow with what they hold
    opening = Segment("(", '<mo stretchy="false">(</mo>', "(")
    return _after(_before(opening, inner, "", ""), Segment(")", '<mo stretchy="false">)</mo>', ")"))


def _operation(node: ast.BinOp) -> tuple[int, Segments]:
    if isinstance(node.op, (ast.Add, ast.Sub)):
        adds = isinstance(node.op, ast.Add)
        sign = Segment(*("+", "<mo>+</mo>", "+") if adds else ("-", "<mo>−</mo>", "-"))
        return SUM, (*_at_least(node.left, SUM), *_before(sign, _at_least(node.right, DOT)))
    if isinstance(node.op, ast.Div):
        above, below = unbroken(_set(node.left)[1]), unbroken(_set(node.right)[1])
        numerator = unbroken(_at_least(node.left, PRODUCT)).text
        text = f"{numerator} / {unbroken(_at_least(node.right, UNARY)).text}"
        mathml = f"<mfrac><mrow>{above.mathml}</mrow><mrow>{below.mathml}</mrow></mfrac>"
        return PRODUCT, (Segment(text, mathml, rf"\frac{{{above.latex}}}{{{below.latex}}}"),)
    if isinstance(node.op, ast.Pow):
        base, power = unbroken(_at_least(node.left, ATOM)), unbroken(_set(node.right)[1])
        mathml = f"<msup><mrow>{base.mathml}</mrow><mrow>{power.mathml}</mrow></msup>"
        latex = f"{{{base.latex}}}^{{{power.latex}}}"
        return POWER, (Segment(f"{base.text}^{power.text}", mathml, latex),)
    left, right = _at_least(node.left, PRODUCT), _at_least(node.right, UNARY)
    # a line ends before the last factor only where a factor is a sum
    text, mathml, latex = left[-1]
    product = _before(Segment(text, mathml + TIMES, latex), right, " ", r" \, ")
    return PRODUCT, (*left[:-1], *product)


def _call(node: ast.Call) -> tuple[int, Segments]:
    assert isinstance(node.func, ast.Name)
    function, arguments = node.func.id, node.args
    if function == "dot":
        left, right = (_at_least(x, PRODUCT) for x in arguments)
        text, mathml, latex = left[-1]
        dot = Segment(f"{text} ·", f"{mathml}<mo>·</mo>", rf"{latex} \cdot")
        return DOT, (*left[:-1], *_before(dot, right))
    parts = [_set(x)[1] for x in arguments]
    if function == "skew":
        inner = unbroken(parts[0])
        mathml = f"<mover><mrow>{inner.mathml}</mrow><mo>~</mo></mover>"
        return ATOM, (Segment(f"[{inner.text}]", mathml, rf"\widetilde{{{inner.latex}}}"),)
    if function == "inverse":
        inner = unbroken(_at_least(arguments[0], ATOM))
        mathml = f"<msup><mrow>{inner.mathml}</mrow><mrow><mo>−</mo><mn>1</mn></mrow></msup>"
        return ATOM, (Segment(f"{inner.text}⁻¹", mathml, f"{{{inner.latex}}}^{{-1}}"),)
    if function == "sqrt":
        inner = unbroken(parts[0])
        mathml = f"<msqrt>{inner.mathml}</msqrt>"
        return ATOM, (Segment(f"sqrt({inner.text})", mathml, rf"\sqrt{{{inner.latex}}}"),)
    if function == "total":
        return SUM, _sum([unbroken(x) for x in parts[:3]], _at_least(arguments[3], DOT))
    if function in MATRICES:
        return ATOM, (_matrix([unbroken(x) for x in parts], MATRICES[function] or len(parts)),)
    return ATOM, _applied(function, parts)


def _sum(limits: Sequence[Segment], terms: Segments) -> Segments:
    """The sum of terms over an index from first to last."""
    index, first, last = limits
    text = f"sum({index.text} = {first.text} .. {last.text})"
    low = f"<mrow>{index.mathml}<mo>=</mo>{first.mathml}</mrow>"
    mathml = f"<munderover><mo>∑</mo>{low}<mrow>{last.mathml}</mrow></munderover>"
    latex = rf"\sum_{{{index.latex} = {first.latex}}}^{{{last.latex}}}"
    return _before(Segment(text, mathml, latex), terms)


def _applied(function: str, parts: list[Segments]) -> Segments:
    """A function by its name, with its arguments in brackets."""
    word = NAMED.get(function) or LISTED.get(function) or function.replace("_", " ")
    latex = f"\\{word}" if word in ("sin", "cos", "cot", "log") else rf"\operatorname{{{word}}}"
    comma, listed = Segment(",", "<mo>,</mo>", ","), list[Segment]()
    for k, part in enumerate(parts):
        listed += part if k == len(parts) - 1 else _after(part, comma)
    return _before(Segment(word, f"<mi>{word}</mi>", latex), _bracketed(tuple(listed)), "", "")


# functions that make matrices of blocks -> blocks in a row, 0 for all
MATRICES = {"column": 1, "block": 2, "matrix": 3, "row": 0}


def _matrix(parts: list[Segment], columns: int) -> Segment:
    rows = [parts[k : k + columns] for k in range(0, len(parts), columns)]
    text = "; ".join(", ".join(x.text for x in row) for row in rows)
    mathml = "".join(
        "<mtr>" + "".join(f"<mtd>{x.mathml}</mtd>" for x in row) + "</mtr>" for row in rows
    )
    latex = r" \\ ".join(" & ".join(x.latex for x in row) for row in rows)
    table = f"<mrow><mo>(</mo><mtable>{mathml}</mtable><mo>)</mo></mrow>"
    return Segment(f"({text})", table, rf"\begin{{pmatrix}} {latex} \end{{pmatrix}}")


def _name(name: str) -> Segment:
    """A letter with dots and an index: ``omegadot_1``, ``zddot``."""
    match = re.fullmatch(r"([A-Za-z]+?)(star|bar)?(d?dot)?(?:_(\w+))?", name)
    assert match is not None, name
    letter, mark, dotted, index = match.groups()
    letter = "lambda" if letter == "lam" else letter
    greek, sign = letter in GREEK, Notation(letter).character
    mathml = f"<mi>{sign}</mi>"
    latex = f"\\{letter}" if greek else letter if len(letter) == 1 else rf"\mathrm{{{letter}}}"
    if mark == "bar":
        mathml, latex = f"<mover>{mathml}<mo>¯</mo></mover>", rf"\bar{{{latex}}}"
    elif mark:
        mathml, latex = f"<msup>{mathml}<mo>*</mo></msup>", f"{latex}^{{*}}"
    if dotted:
        above = "." * dotted.count("d")
        mathml, latex = f"<mover>{mathml}<mo>{above}</mo></mover>", rf"\{dotted}{{{latex}}}"
    if index:
        tag = "mn" if index.isdigit() else "mi"
        below = index if index.isdigit() or len(index) == 1 else rf"\mathrm{{{index}}}"
        mathml = f"<msub>{mathml}<{tag}>{index}</{tag}></msub>"
        latex = f"{latex}_{{{below.replace('_', ',')}}}"
    return Segment(name, mathml, latex)
