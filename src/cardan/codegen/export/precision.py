"""C in single precision: the same text with ``float``, for processors that have no ``double``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from ...errors import CodegenError, near
from ...schema.integrators import KERNELS
from .. import layout
from . import linkage

PRECISIONS = ("double", "single")
# what headers see: numbers are float
MACRO = "#define CARDAN_FLOAT 1\n"
_GUARD = re.compile(r"^#define CARDAN_H\n", re.M)
# decimals, but for those that say already what they are
_LITERAL = re.compile(r"(?<![\w.])((?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)(?![\w.])")
_WORDS = {
    "double": "float",
    "DBL_EPSILON": "FLT_EPSILON",
    "DBL_MAX": "FLT_MAX",
    "DBL_MIN": "FLT_MIN",
}
_CALLED = (
    *("sqrt", "cbrt", "hypot", "pow", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan"),
    *("atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "floor", "ceil", "fabs"),
    *("fmax", "fmin", "fmod", "copysign", "nextafter", "nan"),
)
_WORD = re.compile(r"(?<!long )\b(?:" + "|".join(map(re.escape, _WORDS)) + r")\b")
# a function of the mathematical library, called or handed on; not a member of that name
_FUNCTION = re.compile(rf"(?<![\w.>])(?:{'|'.join(_CALLED)})(?=\s*[(])")
LEAST, MOST = 1.1754943508222875e-38, 3.4028234663852886e38


def check(precision: str, language: str, methods: Sequence[str]) -> None:
    """Refuse what is not offered.

    Raises:
        CodegenError: an unknown precision, one that does not go with the language or with elements.
    """
    if precision not in PRECISIONS:
        raise CodegenError(f"precision '{precision}' does not exist.{near(precision, PRECISIONS)}")
    if precision == "single" and language != "c":
        raise CodegenError(
            f"precision='single': it goes with language='c'; numbers of '{language}' are double"
        )
    # Newton's method and tangents want more digits
    offered = [name for name, method in KERNELS.items() if not (method.needs or method.multipliers)]
    wrong = [name for name in methods if precision == "single" and name not in offered]
    if wrong:
        raise CodegenError(
            f"precision='single': integrator '{wrong[0]}' solves equations in double precision; "
            f"those that go with it: {', '.join(offered)}"
        )


def single(text: str) -> str:
    """C in single precision, but in comments, strings and names of files."""
    parts, last = [], 0
    for skipped in linkage.SKIPPED.finditer(text):
        parts += [_code(text[last : skipped.start()]), skipped.group()]
        last = skipped.end()
    return "".join([*parts, _code(text[last:])])


def apply(folder: Path) -> None:
    """Rewrite the C of an export in single precision; the manifest says so."""
    paths = sorted(path for path in folder.iterdir() if path.suffix in (".c", ".h"))
    texts = {path.name: single(path.read_text("utf-8")) for path in paths}
    texts["cardan.h"] = _GUARD.sub(lambda match: match.group() + MACRO, texts["cardan.h"])
    layout.replace_texts(folder, texts, precision="single")


def _code(text: str) -> str:
    text = _WORD.sub(lambda match: _WORDS[match.group()], text)
    text = _FUNCTION.sub(lambda match: f"{match.group()}f", text)
    return _LITERAL.sub(_literal, text)


def _literal(match: re.Match[str]) -> str:
    """A decimal; what float cannot hold is the nearest number that it can."""
    value = float(match.group())
    if value > MOST:
        return "FLT_MAX"
    if 0 < value < LEAST:
        return f"{LEAST!r}f"
    return f"{match.group()}f"
