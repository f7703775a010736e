"""C in single precision: the same text with ``float`` where it says ``double``.

Exports for processors without doubles and batches of floats are made of it: one text of every
function, whatever its numbers are.
"""

from __future__ import annotations

import re

# what names nothing: comments, strings and names of files
SKIPPED = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|#include[^\n]*", re.S)
# decimals, but for those that say already what they are
_LITERAL = re.compile(r"(?<![\w.])((?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)(?![\w.])")
_NAMES = {
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
_NAME = re.compile(r"(?<!long )\b(?:" + "|".join(map(re.escape, _NAMES)) + r")\b")
# a function of the mathematical library, called or handed on; not a member of that name
_FUNCTION = re.compile(rf"(?<![\w.>])(?:{'|'.join(_CALLED)})(?=\s*[(])")
LEAST, MOST = 1.1754943508222875e-38, 3.4028234663852886e38


def single(text: str) -> str:
    """C in single precision, but in comments, strings and names of files."""
    parts, last = [], 0
    for skipped in SKIPPED.finditer(text):
        parts += [_code(text[last : skipped.start()]), skipped.group()]
        last = skipped.end()
    return "".join([*parts, _code(text[last:])])


def _code(text: str) -> str:
    text = _NAME.sub(lambda match: _NAMES[match.group()], text)
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
