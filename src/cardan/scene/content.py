"""All that a scene says, as a hash: scenes with equal hashes have equal equations.

Everything that can be reached from an object goes into it: the class and the attributes of records,
arrays bit by bit, expressions of SymPy term by term. What may hold more than it shows, such as a
function, a class of the user or an object of another package, has no hash: then nothing can be
said of the scene before its equations are derived. To say too much does no harm: a scene that was
read from another line of a file is derived anew.
"""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from pathlib import PurePath
from types import MappingProxyType, NoneType

PLAIN = (NoneType, bool, str, bytes)
NUMBERS = "biufc"  # kinds of arrays whose bytes say everything


class _Unnamed(Exception):
    """An object that may hold more than it shows."""


def content_hash(*parts: object) -> str | None:
    """Hash of a scene and of what is asked of it; None where something has none.

    Equal in all processes that run the same version of cardan.
    """
    content = _Content()
    try:
        content.add(parts)
    except (_Unnamed, RecursionError):
        return None
    return content.digest.hexdigest()


class _Content:
    """A hash that grows. Objects are numbered: a second reference to one is its number."""

    def __init__(self) -> None:
        self.digest = hashlib.sha256()
        self.numbers: dict[int, int] = {}
        # what is numbered lives on, so that no other object gets its place in memory
        self.objects: list[object] = []

    def add(self, value: object) -> None:
        """Add an object and all that it refers to.

        Raises:
            _Unnamed: there is something among it that may hold more than it shows.
        """
        kind = type(value)
        if kind is float:
            self.say("float", value.hex())  # type: ignore[attr-defined]
        elif kind in (int, Fraction):
            # in decimals Python refuses to write numbers of many digits
            self.say(kind.__name__, *map(hex, value.as_integer_ratio()))  # type: ignore[attr-defined]
        elif kind in PLAIN:
            self.say(kind.__name__, repr(value))
        elif kind in (tuple, list):
            self.each(kind.__name__, value)  # type: ignore[arg-type]
        elif kind in (dict, MappingProxyType):
            self.entries("dict", value)  # type: ignore[arg-type]
        elif kind in (set, frozenset):
            self.each("set", sorted(value, key=repr))  # type: ignore[call-overload]
        elif isinstance(value, PurePath):
            self.say("path", str(value))
        else:
            self.numbered(value)

    def say(self, *words: str) -> None:
        """Add words, so that no others give the same bytes."""
        for word in words:
            data = word.encode("utf-8", "surrogatepass")
            self.digest.update(b"%d:%b" % (len(data), data))

    def each(self, word: str, values: Iterable[object]) -> None:
        entries = [*values]
        self.say(word, str(len(entries)))
        for entry in entries:
            self.add(entry)

    def entries(self, word: str, values: Mapping[object, object]) -> None:
        """A mapping in its order, which may be that of bodies or joints."""
        self.say(word, str(len(values)))
        for key, entry in values.items():
            self.add(key)
            self.add(entry)

    def numbered(self, value: object) -> None:
        """An object that others may refer to."""
        number = self.numbers.get(id(value))
        if number is not None:
            self.say("again", str(number))
            return
        self.numbers[id(value)] = len(self.objects)
        self.objects.append(value)
        kind = value if isinstance(value, type) else type(value)
        # classes that SymPy makes for the functions of a user have no module
        module = str(kind.__module__)
        self.say("class" if value is kind else "object", module, kind.__qualname__)
        _BY_PACKAGE.get(module.partition(".")[0], _refused)(self, value)


def _of_cardan(content: _Content, value: object) -> None:
    """A record or another object of this package; of a class of a module its name is enough."""
    points = getattr(value, "cardan_points", None)
    if isinstance(value, type):
        if getattr(sys.modules.get(value.__module__), value.__qualname__, None) is not value:
            raise _Unnamed(value)
    elif points is not None:
        # a measured function of a term: its class is made for its points
        content.each("table", (points, value.cardan_derivative, *value.args))  # type: ignore[attr-defined]
    else:
        _as_built_in(content, value)
        slots = [name for one in type(value).__mro__ for name in vars(one).get("__slots__", ())]
        content.entries("slots", {k: getattr(value, k) for k in slots if hasattr(value, k)})
        content.entries("attributes", getattr(value, "__dict__", {}))


def _as_built_in(content: _Content, value: object) -> None:
    """Add what an object holds as a text, number, row or table, if its class derives from one."""
    for kind in (str, bytes, int, float):
        if isinstance(value, kind):
            content.say(kind.__name__, kind.__repr__(value))
    if isinstance(value, tuple | list):
        content.each("fields", value)
    elif isinstance(value, dict):
        content.entries("dict", value)
    elif isinstance(value, set | frozenset | bytearray):
        raise _Unnamed(value)


def _of_numpy(content: _Content, value: object) -> None:
    """An array or a number of NumPy."""
    import numpy as np

    # subclasses of arrays hold more, such as a mask
    if type(value) is not np.ndarray and not isinstance(value, np.generic):
        raise _Unnamed(value)
    if value.dtype.kind not in NUMBERS:
        raise _Unnamed(value)
    content.say(value.dtype.str, str(value.shape))
    content.digest.update(value.tobytes())


def _of_sympy(content: _Content, value: object) -> None:
    """An expression: its leaves as SymPy writes them for itself, its other nodes by their terms."""
    import sympy

    if isinstance(value, sympy.MatrixBase):
        content.each(str(value.shape), [*value])
    elif isinstance(value, sympy.Basic) and value.args:
        content.each("terms", value.args)
    elif isinstance(value, sympy.Basic) and not isinstance(value, sympy.Dummy):
        content.say(sympy.srepr(value))
    else:
        # one Dummy differs from another by a count of the process
        raise _Unnamed(value)


def _refused(content: _Content, value: object) -> None:
    raise _Unnamed(value)


_BY_PACKAGE: dict[str, Callable[[_Content, object], None]] = {
    "cardan": _of_cardan,
    "numpy": _of_numpy,
    "sympy": _of_sympy,
}
