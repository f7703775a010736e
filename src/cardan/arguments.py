"""Arguments of public functions, checked against their annotations.

An annotation says what an argument must be; ``@checked`` refuses what it is not, before the
function sees it, with the name of the argument and an example. Numbers of other libraries become
``int`` and ``float`` there. What only the function knows (shapes, names that exist) it checks
itself. Annotations that are not in ``KINDS`` are those of classes, which are known by their names;
``Any`` and generic types are not checked.
"""

from __future__ import annotations

import dataclasses
import math
import os
from collections.abc import Callable, Iterable, Mapping
from decimal import Decimal
from functools import wraps
from inspect import Parameter, signature
from numbers import Integral, Real
from typing import Any, NamedTuple, ParamSpec, TypeVar, cast

from .errors import ArgumentError, SolveError, brief, near

UNIT = 1e-6  # by how much the length of a quaternion that is given may differ from 1

# whole numbers of an argument, by what it counts: the annotation says how far they may go
Count = int  # of things that take memory or time each: at least 1
Number = int  # the place of something in a row, from the end if negative
Seed = int  # of random numbers: not negative
Times = Any  # a time or a row of times [s]
Complexes = Any  # a complex number or an array of them
# what is held at which values; its functions tell the names that there are
LockedValues = Mapping[str, Any]
Inputs = Mapping[Any, object]  # by the name of an input, or the names of several
LARGEST = 10**9  # of a count, far more than fits into memory
FARTHEST = 2**62

P = ParamSpec("P")
R = TypeVar("R")
UNFIT = object()


class Kind(NamedTuple):
    """Values that an argument accepts.

    Attributes:
        read: The value as the function wants it, ``UNFIT`` where it is of another kind.
        description: What is wanted, for messages.
    """

    read: Callable[[Any], Any]
    description: str


def _none(value: object) -> Any:
    return value if value is None else UNFIT


def _flag(value: object) -> Any:
    # NumPy before 2 calls its own bool_
    numpy_bool = type(value).__name__ in ("bool", "bool_")
    return bool(value) if numpy_bool else UNFIT


def _text(value: object) -> Any:
    return value if isinstance(value, str) else UNFIT


def _integer(least: int, most: int) -> Callable[[Any], Any]:
    def read(value: object) -> Any:
        if not isinstance(value, Integral) or isinstance(value, bool):
            return UNFIT
        return int(value) if least <= int(value) <= most else UNFIT

    return read


_INTEGER, _COUNT = _integer(-FARTHEST, FARTHEST), _integer(0, LARGEST)


def _real(value: Any) -> Any:
    """A number as a float; arrays of no dimension and exact numbers of SymPy are numbers too."""
    if type(value) is float:
        return value
    single = getattr(value, "shape", None) == () or getattr(value, "is_Number", False) is True
    boolean = isinstance(value, bool) or getattr(getattr(value, "dtype", None), "kind", "") == "b"
    if boolean or not (isinstance(value, Real | Decimal) or single):
        return UNFIT
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        return UNFIT


def _names(value: object) -> Any:
    """Names as a list; a tuple or list stays what it is, and one name alone too."""
    if isinstance(value, str):
        return value
    if isinstance(value, Mapping) or not isinstance(value, Iterable):
        return UNFIT
    try:
        names = value if isinstance(value, list | tuple) else list(value)
    except TypeError:
        return UNFIT
    return names if all(isinstance(name, str) for name in names) else UNFIT


def _by_name(value: object) -> Any:
    named = isinstance(value, Mapping) and all(isinstance(name, str) for name in value)
    return value if named else UNFIT


def _numbers_by_name(value: Any) -> Any:
    if _by_name(value) is UNFIT or any(_real(number) is UNFIT for number in value.values()):
        return UNFIT
    return {name: _real(number) for name, number in value.items()}


def _arrays_by_name(value: Any) -> Any:
    if _by_name(value) is UNFIT or any(_array(one) is UNFIT for one in value.values()):
        return UNFIT
    return value


def _array(value: Any) -> Any:
    """Real numbers in rows of equal length, as they were given."""
    # what solvers hand over, in calls that take microseconds
    if type(value).__name__ == "ndarray" and value.dtype.kind in "fiub":
        return value
    import numpy as np

    try:
        array = np.asarray(value)
        fits = array.dtype.kind in "fiub" or (array.dtype.kind == "O" and _exact(array))
    except (TypeError, ValueError, OverflowError, RecursionError):
        return UNFIT
    return value if fits else UNFIT


def _complexes(value: object) -> Any:
    """Complex numbers in rows of equal length, as they were given."""
    import numpy as np

    try:
        fits = np.asarray(value).dtype.kind == "c"
    except (TypeError, ValueError, OverflowError, RecursionError):
        return UNFIT
    return value if fits else _array(value)


def _exact(array: Any) -> bool:
    """True for objects that are numbers, such as fractions and those of SymPy."""
    return array.size > 0 and all(_real(entry) is not UNFIT for entry in array.flat)


def _pair(value: object) -> Any:
    if isinstance(value, str | Mapping) or _array(value) is UNFIT:
        return UNFIT
    import numpy as np

    array = np.asarray(value, dtype=float)
    fits = array.shape == (2,) and bool(np.isfinite(array).all())
    return (float(array[0]), float(array[1])) if fits else UNFIT


def _row(value: Any) -> Any:
    import numpy as np

    fits = not isinstance(value, Mapping) and _array(value) is not UNFIT
    return value if fits and np.ndim(value) == 1 else UNFIT


def _times(value: object) -> Any:
    if isinstance(value, str | bool | Mapping) or _array(value) is UNFIT:
        return UNFIT
    import numpy as np

    array = np.asarray(value, dtype=float)
    return value if array.ndim <= 1 and bool(np.isfinite(array).all()) else UNFIT


def _integer_row(value: Any) -> Any:
    if _row(value) is UNFIT or any(_INTEGER(one) is UNFIT for one in value):
        return UNFIT
    return [int(one) for one in value]


def _sizes(value: object) -> Any:
    """A shape: one number stands for itself."""
    row = (value,) if _COUNT(value) is not UNFIT else value
    if not isinstance(row, tuple | list) or any(_COUNT(one) is UNFIT for one in row):
        return UNFIT
    return tuple(int(one) for one in row) if math.prod(row) <= LARGEST else UNFIT


def _choice(value: object) -> Any:
    """Two rows of places."""
    rows = value if isinstance(value, tuple) and len(value) == 2 else ("", "")
    return value if all(_integer_row(row) is not UNFIT for row in rows) else UNFIT


def _complex(value: object) -> Any:
    return complex(value) if isinstance(value, complex) else _real(value)


def _ranges(value: Any) -> Any:
    if _by_name(value) is UNFIT or any(_pair(one) is UNFIT for one in value.values()):
        return UNFIT
    return {name: _pair(one) for name, one in value.items()}


def _path(value: Any) -> Any:
    text = os.fspath(value) if isinstance(value, os.PathLike) else value
    fits = isinstance(text, str) and text.strip() and "\0" not in text and len(text) < 4096
    return value if fits and max(map(len, text.replace("\\", "/").split("/"))) < 256 else UNFIT


def _paths(value: object) -> Any:
    """Folders as a list; one alone is one folder, not its letters."""
    if _path(value) is not UNFIT:
        return [value]
    if isinstance(value, str | Mapping) or not isinstance(value, Iterable):
        return UNFIT
    try:
        paths = list(value)
    except TypeError:
        return UNFIT
    return paths if all(_path(path) is not UNFIT for path in paths) else UNFIT


def _generator(value: object) -> Any:
    return value if type(value).__name__ == "Generator" else UNFIT


def _callable(value: object) -> Any:
    return value if callable(value) and not isinstance(value, type) else UNFIT


_BY_NAME = Kind(_by_name, "values by name, such as {'elbow': 0.3}")
_NAMES = Kind(_names, "a list of names, such as ['elbow']")
_ARRAY = Kind(_array, "a number or rows of real numbers of equal length")
_NUMBERS = Kind(_numbers_by_name, "numbers by name, such as {'elbow': 0.3}")
_ARRAYS = Kind(_arrays_by_name, "numbers or arrays by name, such as {'elbow': 0.3}")
_PATH = Kind(_path, "the path of a file or folder, such as 'run.nc'")
_PATHS = Kind(_paths, "one folder or a list of folders")
_RANGE = Kind(_pair, "two finite numbers, such as (0, 1)")
# by the text of an annotation
KINDS: dict[str, Kind] = {
    "None": Kind(_none, "None"), "bool": Kind(_flag, "True or False"),
    "str": Kind(_text, "text, such as a name"),
    "int": Kind(_integer(-FARTHEST, FARTHEST), "a whole number"),
    "Count": Kind(_integer(1, LARGEST), "a whole number of at least 1"),
    "Number": Kind(_integer(-FARTHEST, FARTHEST), "a whole number, such as 0"),
    "Seed": Kind(_integer(0, FARTHEST), "a whole number that is not negative, such as 0"),
    "float": Kind(_real, "a number"),
    "Path": _PATH, "ArrayLike": _ARRAY,
    "Times": Kind(_times, "a time, or a row of finite times [s]"),
    "Complexes": Kind(_complexes, "a complex number or an array of them"),
    "Values": _ARRAYS,
    "State": Kind(lambda v: v if _array(v) is not UNFIT else _arrays_by_name(v),
                  "an array, or numbers by name, such as {'elbow': 0.3}"),
    "Sequence[str]": _NAMES, "Iterable[str]": _NAMES,
    "Sequence[str | Path]": _PATHS,
    "tuple[float, float]": _RANGE,
    "Sequence[float]": Kind(_row, "a row of numbers, such as (0, 0, 1)"),
    "Sequence[int]": Kind(_integer_row, "a row of whole numbers, such as (1, 2)"),
    "tuple[int, ...]": Kind(_sizes, "whole numbers that are not negative, such as (3, 2)"),
    "Choice": Kind(_choice, "independent increments and speeds, as another linear model has them"),
    "complex": Kind(_complex, "a number"),
    "Mapping[str, object]": _BY_NAME, "Mapping[str, str]": _BY_NAME,
    "Inputs": Kind(lambda v: v if isinstance(v, Mapping) else UNFIT, _BY_NAME.description),
    "Mapping[str, Value]": _BY_NAME, "Mapping[str, float]": _NUMBERS,
    "Mapping[str, Place | str]": Kind(_by_name, "frames or bodies by name, such as {'root': hub}"),
    "Mapping[str, ArrayLike]": _ARRAYS,
    "Mapping[str, tuple[float, float]]": Kind(_ranges, "pairs by name, such as {'A': (0, 1)}"),
    "np.random.Generator": Kind(_generator, "a generator of NumPy, such as default_rng(1)"),
    "Callable[[float], None]": Kind(_callable, "a function"),
    "Callable[[str], object]": Kind(_callable, "a function"),
    "Show": Kind(_callable, "a function of what is run and the fraction done"),
}  # fmt: skip
# Any, and other names of types that are not classes: their functions know what they are
_UNCHECKED = {"Any", "Array", "Key", "LockedValues", "Place", "JointElement", "Provide"}
_UNCHECKED |= {"AnyMaterial", "Direction", "Rows", "Value"}

# class that functions take -> the one of it that users have
OF_USERS = {
    "LoadedModel": "CompiledModel",
    "Cost": 'Cost, such as cd.cost(final="FORMULA")',
    "EquationRecord": "Equations",
    "Explained": "Equations",
    "FiniteElementRecord": "FiniteElementEquations",
    "SuperelementRecord": "Superelement, as cd.superelement.from_mesh, reduce and load give it",
}


def _of_class(name: str) -> Kind | None:
    """Objects of a class, which is known by its name: its module need not be loaded."""
    if not name.isidentifier() or name in _UNCHECKED or not name[0].isupper():
        return None

    def read(value: object) -> Any:
        return value if any(one.__name__ == name for one in type(value).__mro__) else UNFIT

    title = OF_USERS.get(name, name.removesuffix("Record"))
    return Kind(read, f"{'an' if title[0] in 'AEIO' else 'a'} {title}")


def _alternatives(annotation: str) -> list[str]:
    """``"str | Mapping[str, object] | None"`` -> its parts."""
    parts, depth = [""], 0
    for letter in annotation:
        depth += (letter in "[(") - (letter in "])")
        if letter == "|" and not depth:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def kinds_of(annotation: object) -> tuple[Kind, ...]:
    """Kinds that the annotation of an argument accepts; () for anything."""
    if not isinstance(annotation, str):
        return ()
    parts = _alternatives(annotation)
    # a text that may be a path is one
    parts = [part for part in parts if part != "str" or "Path" not in parts]
    kinds = [KINDS.get(part) or _of_class(part) for part in parts]
    return () if None in kinds else tuple(kind for kind in kinds if kind is not None)


def read(function: str, argument: str, value: object, kinds: tuple[Kind, ...]) -> Any:
    """The value of an argument as its function wants it.

    Raises:
        ArgumentError: it is of no kind that fits.
        SolveError: a number that is not one.
    """
    for kind in kinds:
        converted = kind.read(value)
        if converted is UNFIT:
            continue
        if type(converted) is float and math.isnan(converted):
            raise SolveError(f"{function}: {argument} is nan; it must be finite")
        return converted
    texts = [kind.description for kind in kinds if kind.read is not _none]
    texts = [one for one in texts if not any(other.startswith(f"{one} or ") for other in texts)]
    expected = (" or ".join(texts) or "None").replace("FORMULA", brief(value).strip("'"))
    raise ArgumentError(f"{function}: {argument}={brief(value)}: give {expected}")


def checked(function: Callable[P, R]) -> Callable[P, R]:
    """A function that refuses arguments which its annotations do not allow, and misspelt ones.

    Raises:
        ArgumentError: on a call with an argument of another kind, or with a keyword that the
            function does not have.
    """
    parameters = list(signature(function).parameters.values())
    names = [p.name for p in parameters if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)]
    kinds = {p.name: kinds_of(p.annotation) for p in parameters if not _gathers(p)}
    kinds = {name: kind for name, kind in kinds.items() if kind}
    positional_names = [p.name for p in parameters if not _gathers(p)]
    open_ended = any(p.kind is p.VAR_KEYWORD for p in parameters)
    title, plain = function.__name__.removeprefix("add_"), cast(Any, function)
    if title == "__init__":
        title = function.__qualname__.split(".")[-2]

    @wraps(function)
    def called(*given: P.args, **named: P.kwargs) -> R:
        values: list[Any] = list(given)
        keywords: dict[str, Any] = dict(named)
        for k, (name, value) in enumerate(zip(names, values, strict=False)):
            if name in kinds:
                values[k] = read(title, name, value, kinds[name])
        for name, value in named.items():
            if name in kinds:
                keywords[name] = read(title, name, value, kinds[name])
            elif name not in positional_names and not open_ended:
                hint = near(name, [x for x in positional_names if x not in ("self", "model")])
                raise ArgumentError(f"{title}({name}=...): there is no such argument.{hint}")
        return cast(R, plain(*values, **keywords))

    return called


def check_fields(record: Any) -> None:
    """Hold the fields of a new record against their annotations.

    Raises:
        ArgumentError: one of another kind.
    """
    for field in dataclasses.fields(record):
        kinds = kinds_of(field.type)
        if kinds:
            value = read(type(record).__name__, field.name, getattr(record, field.name), kinds)
            object.__setattr__(record, field.name, value)


def _gathers(parameter: Parameter) -> bool:
    return parameter.kind in (parameter.VAR_KEYWORD, parameter.VAR_POSITIONAL)
