"""Request for a derivative, as one line of text: ``forward_dynamics: q u``.

Names that are more than letters, digits, dots and underscores stand in quotes:
``pose("left hand"): q "upper mass"``.
"""

from __future__ import annotations

import json
import re
from functools import lru_cache

from ..records import dataclass
from .functions import FUNCTIONS

_NAME = r'"(?:[^"\\]|\\.)*"|[\w.]+'
_LINE = re.compile(rf"\s*(\w+)\s*(?:\(\s*({_NAME})\s*\))?\s*:((?:\s*(?:{_NAME}))*)\s*")


@dataclass(frozen=True)
class Request:
    """A derivative of a function.

    Attributes:
        function: Name of the function.
        of: Its frame or joint.
        wrt: Input blocks by letter, parameters and inputs by name.
    """

    function: str
    of: str | None
    wrt: tuple[str, ...]

    @staticmethod
    def read(text: str) -> Request:
        """The request of a line.

        Raises:
            ValueError: it is none.
        """
        match = _LINE.fullmatch(text)
        if match is None or not match[3].strip():
            raise ValueError(
                f"'{text}' names no derivative: write it like 'forward_dynamics: q u' or "
                "'pose(hand): q'"
            )
        wrt = tuple(_plain(name) for name in re.findall(_NAME, match[3]))
        return Request(match[1], _plain(match[2]) if match[2] else None, wrt)

    def __str__(self) -> str:
        of = "" if self.of is None else f"({_quoted(self.of)})"
        return f"{self.function}{of}: {' '.join(map(_quoted, self.wrt))}"


@lru_cache(maxsize=1024)
def reads(function: str, of: str | None) -> tuple[str, ...]:
    """Names of the arguments of a function; of a derivative those of its function come first."""
    row = FUNCTIONS[function]
    if row.of != "function":
        return (*row.arguments,)
    return (*FUNCTIONS[Request.read(of or "").function].arguments, *row.arguments)


def _quoted(name: str) -> str:
    return name if re.fullmatch(r"[\w.]+", name) else json.dumps(name, ensure_ascii=False)


def _plain(name: str) -> str:
    return str(json.loads(name)) if name.startswith('"') else name
