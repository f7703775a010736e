"""Records of files: their fields said once, from which reading, checks and JSON schemas follow.

A record is a class whose fields are declared by :func:`field`. Its objects are what a file holds,
under attributes; they are made when a file is read, which checks every entry, or by the compiler,
by keywords. What has its default does not stand in the file.

These are not dataclasses: nothing is generated when the package is imported.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, Self, dataclass_transform

NUMBERS = 2**53  # in size of an integer that is a number as well
SIZES = 1 << 40  # numbers of a block, a result or work memory


class Misfit(ValueError):
    """An entry of a file is not what its field says."""

    def __init__(self, what: str) -> None:
        super().__init__(what)
        self.place = ""

    def within(self, part: str) -> Misfit:
        """The same, seen from around it."""
        self.place = part + self.place
        return self

    def __str__(self) -> str:
        return f"'{self.place.removeprefix('.')}' {self.args[0]}" if self.place else self.args[0]


Read = Callable[[Any, bool], Any]


class Kind(NamedTuple):
    """Kind of the values of an entry.

    Attributes:
        read: Entry of JSON, whether it is of a saved run -> what records have of it.
        schema: The same as a JSON schema.
    """

    read: Read
    schema: Mapping[str, Any]


def kind(what: str, good: Callable[[Any], bool], **schema: object) -> Kind:
    """Entries that fulfil a condition.

    Args:
        what: In messages, such as "a text".
        good: The condition.
        schema: What a JSON schema says about them.
    """

    def read(value: object, run: bool) -> Any:
        if good(value):
            return value
        raise Misfit(f"is {value!r:.60}, not {what}")

    return Kind(read, schema)


def is_text(value: object) -> bool:
    """True when a value is a text that can be printed and written."""
    return isinstance(value, str) and (
        value.isascii() or not any("\ud800" <= letter <= "\udfff" for letter in value)
    )


def is_integer(value: object) -> bool:
    """True when a value is an integer that is a number as well."""
    return isinstance(value, int) and not isinstance(value, bool) and abs(value) < NUMBERS


def is_number(value: object) -> bool:
    """True when a value is a number."""
    return isinstance(value, float) or is_integer(value)


def integer_from(least: int, end: int) -> Callable[[Any], bool]:
    """Kind of integers from the least one on, below the end."""
    return lambda value: type(value) is int and least <= value < end


text = kind("a text", is_text, type="string")
number = kind("a number", is_number, type="number")
positive = kind(
    "a number above 0", lambda x: is_number(x) and x > 0, type="number", exclusiveMinimum=0
)
integer = kind("an integer", is_integer, type="integer")
count = kind("an integer from 0 on", integer_from(0, NUMBERS), type="integer", minimum=0)
size = kind("a size", integer_from(0, SIZES), type="integer", minimum=0)
flag = kind("true or false", lambda value: isinstance(value, bool), type="boolean")


def one_of(*values: object) -> Kind:
    """One of some values."""
    listing = ", ".join(map(repr, values))
    return kind(f"one of {listing}", lambda value: value in values, enum=[*values])


def matching(pattern: str, what: str) -> Kind:
    """Texts that match a regular expression as a whole."""
    expression = re.compile(pattern.removesuffix("$") + r"\Z", re.ASCII)
    return kind(
        what,
        lambda value: isinstance(value, str) and expression.match(value) is not None,
        type="string",
        pattern=pattern,
    )


def listed(entry: Kind | type[Record], length: int | None = None) -> Kind:
    """Entries of one kind."""
    read_entry, schema = of(entry)
    sizes = {} if length is None else {"minItems": length, "maxItems": length}

    def read(value: object, run: bool) -> list[Any]:
        if not isinstance(value, list):
            raise Misfit(f"is {value!r:.60}, not a list")
        if length is not None and len(value) != length:
            raise Misfit(f"has {len(value)} entries, not {length}")
        entries: list[Any] = []
        try:
            for one in value:
                entries.append(read_entry(one, run))
        except Misfit as misfit:
            raise misfit.within(f"[{len(entries)}]") from None
        return entries

    return Kind(read, {"type": "array", "items": schema, **sizes})


def table(entry: Kind | type[Record], keys: Kind = text) -> Kind:
    """Entries of one kind by their names."""
    read_entry, schema = of(entry)

    def read(value: object, run: bool) -> dict[str, Any]:
        if not isinstance(value, dict):
            raise Misfit(f"is {value!r:.60}, not a table")
        entries = {}
        for name, one in value.items():
            keys.read(name, run)
            try:
                entries[name] = read_entry(one, run)
            except Misfit as misfit:
                raise misfit.within(f".{name}") from None
        return entries

    names = {} if keys is text else {"propertyNames": keys.schema}
    return Kind(read, {"type": "object", **names, "additionalProperties": schema})


def maybe(entry: Kind | type[Record]) -> Kind:
    """An entry, or null."""
    read_entry, schema = of(entry)
    return Kind(
        lambda value, run: None if value is None else read_entry(value, run),
        {"anyOf": [schema, {"type": "null"}]},
    )


def either(first: Kind, second: Kind) -> Kind:
    """An entry of one of two kinds."""

    def read(value: object, run: bool) -> Any:
        try:
            return first.read(value, run)
        except Misfit:
            return second.read(value, run)

    return Kind(read, {"anyOf": [first.schema, second.schema]})


def pair() -> Kind:
    """Two counts: where something begins, and how much it is."""
    two = listed(count, 2)

    def read(value: object, run: bool) -> tuple[int, int]:
        start, size = two.read(value, run)
        return start, size

    return Kind(read, two.schema)


def triple() -> Kind:
    """Three counts: a group, an element of it, and a part of that."""
    three = listed(count, 3)

    def read(value: object, run: bool) -> tuple[int, int, int]:
        group, member, number = three.read(value, run)
        return group, member, number

    return Kind(read, three.schema)


def of(entry: Kind | type[Record]) -> Kind:
    """The kind of an entry; a record stands for itself."""
    return entry if isinstance(entry, Kind) else Kind(entry.read, entry.json_schema())


class _Required:
    """The default of fields without one."""


REQUIRED: Any = _Required()
NOTHING: Mapping[str, Any] = MappingProxyType({})


class Field(NamedTuple):
    """A field of a record; see :func:`field`."""

    kind: Kind
    about: str
    default: Any
    run: Any


def field(
    entry: Kind | type[Record],
    about: str = "",
    *,
    default: object = REQUIRED,
    run: object = REQUIRED,
) -> Any:
    """A field of a record.

    Args:
        entry: What it may be.
        about: What it means, for the JSON schema.
        default: Its value where a file says nothing or null; files must say it without.
        run: The same in saved runs, which hold less, older ones less again.
    """
    return Field(of(entry), about, default, default if run is REQUIRED else run)


@dataclass_transform(
    kw_only_default=True, frozen_default=True, eq_default=False, field_specifiers=(field,)
)
class Record:
    """A part of a file. Entries are attributes; people may also read them by key."""

    # name, its reader, its default, its default in saved runs
    _rows: ClassVar[tuple[tuple[str, Read, Any, Any], ...]] = ()
    _about: ClassVar[dict[str, Field]] = {}

    def __init_subclass__(cls) -> None:
        entries_of_class = {name: x for name, x in vars(cls).items() if isinstance(x, Field)}
        cls._about = {**cls._about, **entries_of_class}
        cls._rows = tuple((name, x.kind.read, x.default, x.run) for name, x in cls._about.items())
        for name, one in entries_of_class.items():
            if one.default is REQUIRED:
                delattr(cls, name)
            else:
                setattr(cls, name, one.default)

    def __init__(self, **entries: object) -> None:
        attributes = vars(self)
        for name, _, default, _ in self._rows:
            value = entries.pop(name, default)
            if value is REQUIRED:
                raise TypeError(f"{type(self).__name__}: {name} is missing")
            # what is empty is the default where that is empty
            empty = default is not None and not default and not value
            if not (empty or value is default):
                attributes[name] = value
        if entries:
            raise TypeError(f"{type(self).__name__} has no {', '.join(entries)}")

    @classmethod
    def read(cls, plain: object, run: bool = False) -> Self:
        """A record of what JSON holds; entries that it does not know are left out.

        Args:
            plain: What JSON holds.
            run: Whether it is of a saved run.

        Raises:
            Misfit: an entry is not what its field says.
        """
        if not isinstance(plain, dict):
            raise Misfit(f"is {plain!r:.60}, not a table")
        record = object.__new__(cls)
        entries = vars(record)
        for name, read, default, lacking in cls._rows:
            value = plain.get(name)
            if value is not None:
                try:
                    entries[name] = read(value, run)
                except Misfit as misfit:
                    raise misfit.within(f".{name}") from None
                continue
            absent = lacking if run else default
            if absent is REQUIRED:
                raise Misfit("is missing").within(f".{name}")
            if absent is not default:
                entries[name] = absent
        record.fit(run)
        return record

    @classmethod
    def lacking(cls, name: str) -> Any:
        """Default of an entry that a saved run leaves out; true where it must not."""
        return cls._about[name].run

    @classmethod
    def trusted(cls, entries: Mapping[str, object]) -> Self:
        """A record of entries that are known to be good."""
        record = object.__new__(cls)
        vars(record).update(entries)
        return record

    def fit(self, run: bool) -> None:
        """Make sure that entries fit each other.

        Raises:
            Misfit: they do not.
        """

    def replaced(self, **changes: object) -> Self:
        """The same with other entries."""
        return type(self)(**{**vars(self), **changes})

    @classmethod
    def json_schema(cls) -> dict[str, Any]:
        """The JSON schema of such records."""
        return {
            "type": "object",
            "properties": {
                name: {**x.kind.schema, **({"description": x.about} if x.about else {})}
                for name, x in cls._about.items()
            },
            "required": [name for name, x in cls._about.items() if x.default is REQUIRED],
        }

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Mapping):
            return dumped(self) == dumped(other)
        return type(self) is type(other) and vars(self) == vars(other)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        entries = ", ".join(f"{name}={value!r}" for name, value in vars(self).items())
        return f"{type(self).__name__}({entries})"

    if not TYPE_CHECKING:
        # files are documented by their keys; the code of cardan reads attributes
        def __setattr__(self, name: str, value: object) -> None:
            raise AttributeError(f"{type(self).__name__} cannot be changed")

        def __delattr__(self, name: str) -> None:
            raise AttributeError(f"{type(self).__name__} cannot be changed")

        def __getitem__(self, key: str) -> Any:
            if key not in self._about:
                raise KeyError(key)
            return getattr(self, key)

        def get(self, key: str, default: object = None) -> Any:
            return vars(self).get(key, getattr(type(self), key, default))

        def keys(self) -> Iterator[str]:
            return iter(vars(self))

        def __iter__(self) -> Iterator[str]:
            return iter(vars(self))

        def __contains__(self, key: str) -> bool:
            return key in vars(self)

        def items(self) -> Iterator[tuple[str, Any]]:
            return iter(vars(self).items())


def plain(part: object) -> Any:
    """JSON form of a record or rows.

    Raises:
        TypeError: it is neither.
    """
    if isinstance(part, Record):
        return vars(part)
    if isinstance(part, Mapping):
        return dict(part)
    if hasattr(part, "plain"):
        return part.plain()
    raise TypeError(f"{type(part).__name__} cannot be written as JSON")


def dumped(data: Any, **options: Any) -> str:
    """Data with records as JSON."""
    return json.dumps(data, default=plain, **options)
