"""Records: dataclasses whose methods are written when the first one is made.

``dataclass`` of the standard library writes six functions as text for every class and has Python
compile them; a process that imports hundreds of records and makes few of them waits for that most
of all. Here a class waits for its first use: until then descriptors stand in the place of what the
standard library writes. What it then is, is the same dataclass: to ``fields``, ``replace``,
``pickle``, ``match`` and type checkers.
"""

from __future__ import annotations

import dataclasses
from threading import RLock
from typing import TYPE_CHECKING

__all__ = ["dataclass"]

# one class at a time: another thread waits until it is complete
_LOCK = RLock()
_FIELDS, _PARAMETERS = "__dataclass_fields__", "__dataclass_params__"
# what waits, by the option that leaves it out
_METHODS = {"init": ("__init__", "__match_args__"), "repr": ("__repr__",)}
_METHODS |= {"eq": ("__eq__", "__hash__")}
# what stays what it is in the class
_UNCHANGED = {"__module__", "__qualname__", "__doc__", "__dict__", "__weakref__", "__annotations__"}
_CHANGES = ("__setattr__", "__delattr__")
_UNCHANGED |= {"__post_init__", *_CHANGES}
# options of records whose ``__init__`` is written apart
_USUAL = {"frozen", "eq", "repr"}


class _Factory:
    """In place of a value that a function makes, as signatures show it."""

    def __repr__(self) -> str:
        return "<factory>"


_FACTORY = _Factory()

if TYPE_CHECKING:
    from dataclasses import dataclass
else:

    def dataclass(cls: type | None = None, /, **options: bool) -> object:
        """A dataclass.

        Args:
            options: ``frozen``, ``eq``, ``repr`` and others of the standard library. With
                ``slots`` another class takes the place of this one, which cannot wait.
        """

        def decorate(target: type) -> type:
            if options.get("slots"):
                return dataclasses.dataclass(**options)(target)
            _Unwritten(target, options)
            return target

        return decorate if cls is None else decorate(cls)


class _Unwritten:
    """The methods of a class that are still to be written."""

    def __init__(self, cls: type, options: dict[str, bool]) -> None:
        self.cls = cls
        self.options = options
        members = vars(cls)
        # those of the class itself stay; where it has __eq__ alone, Python puts __hash__ = None
        self.defined = {k: members[k] for names in _METHODS.values() for k in names if k in members}
        if "__eq__" in members and members.get("__hash__") is None:
            self.defined.pop("__hash__", None)
        # ``field(...)`` is no default yet
        self.defaults = {k: x for k, x in members.items() if isinstance(x, dataclasses.Field)}
        # what an instance needs; that is less than all where ``__init__`` is the usual one
        usual = options.keys() <= _USUAL and "__init__" not in members
        self.first = {_FIELDS, "__init__", *self.defaults} if usual else set[str]()
        waiting = [_FIELDS, _PARAMETERS, *self.defaults]
        for option, names in _METHODS.items():
            waiting += [k for k in names if options.get(option, True) and k not in self.defined]
        for name in waiting:
            setattr(cls, name, _Waiting(self, name))
        if options.get("frozen"):
            _freeze(cls)

    def write(self, name: str) -> None:
        """Put in place what stands under a name, and what is written along with it."""
        with _LOCK:
            if not isinstance(vars(self.cls).get(name), _Waiting):
                return
            first = name in self.first
            written = self._first() if first else self._all()
            waiting = [k for k, x in vars(self.cls).items() if isinstance(x, _Waiting)]
            for key in (k for k in waiting if first == (k in self.first)):
                if key in written:
                    setattr(self.cls, key, written[key])
                else:  # a field without a default
                    delattr(self.cls, key)
            # what further options and later Pythons write
            further = set[str]() if first else written.keys() - vars(self.cls).keys() - _UNCHANGED
            for key in further - self.first:
                setattr(self.cls, key, written[key])

    def _first(self) -> dict[str, object]:
        """Fields, their defaults and ``__init__``: the only text that is compiled."""
        nothing = dict.fromkeys(("init", "repr", "eq", "match_args"), False)
        stand_in: type = dataclasses.dataclass(**nothing)(type("Fields", (), self._members()))
        fields = self._inherited() | getattr(stand_in, _FIELDS)
        in_order = dataclasses.fields(type("Fields", (), {_FIELDS: fields}))
        return {**vars(stand_in), _FIELDS: fields, "__init__": self._init(in_order)}

    def _init(self, fields: tuple[dataclasses.Field[object], ...]) -> object:
        """``__init__`` as the standard library writes it."""
        names: dict[str, object] = {"__name__": self.cls.__module__}
        names |= {"_record_set": object.__setattr__, "_record_factory": _FACTORY}
        first, body = ["self"], list[str]()
        by_keyword = list[str]()
        for field in fields:
            name, value = field.name, field.name
            parameter, factory, default = name, f"_record_make_{name}", f"_record_default_{name}"
            if field.default_factory is not dataclasses.MISSING:
                names[factory], parameter = field.default_factory, f"{name}=_record_factory"
                otherwise = f" if {name} is _record_factory else {name}" if field.init else ""
                value = f"{factory}(){otherwise}"
            elif field.default is not dataclasses.MISSING:
                names[default], parameter = field.default, f"{name}={default}"
            if field.init:
                (by_keyword if field.kw_only else first).append(parameter)
            if value != name or field.init:
                as_frozen = f"_record_set(self, {name!r}, {value})"
                body.append(as_frozen if self.options.get("frozen") else f"self.{name} = {value}")
        if hasattr(self.cls, "__post_init__"):
            body.append("self.__post_init__()")
        head = ", ".join([*first, *(["*", *by_keyword] if by_keyword else ())])
        exec(f"def __init__({head}):\n " + "\n ".join(body or ["pass"]), names)
        init = names["__init__"]
        annotations = {field.name: field.type for field in fields if field.init}
        for name, x in {
            "__qualname__": f"{self.cls.__qualname__}.__init__",
            "__annotations__": {**annotations, "return": None},
        }.items():
            setattr(init, name, x)
        return init

    def _all(self) -> dict[str, object]:
        """What the standard library writes for a class of the same fields."""
        inherited: dict[str, object] = {}
        for base in reversed(self.cls.__mro__[1:]):
            if _FIELDS in vars(base):
                inherited = {_FIELDS: self._inherited(), _PARAMETERS: getattr(base, _PARAMETERS)}
        bases = (type("Inherited", (), inherited),) if inherited else ()
        stand_in = type(self.cls.__name__, bases, self._members())
        return {**vars(dataclasses.dataclass(**self.options)(stand_in))}

    def _inherited(self) -> dict[str, object]:
        """The fields of all bases, those of nearer ones in place of others."""
        fields: dict[str, object] = {}
        for base in reversed(self.cls.__mro__[1:]):
            if _FIELDS in vars(base):
                fields |= getattr(base, _FIELDS)
        return fields

    def _members(self) -> dict[str, object]:
        """What a class needs for the fields of this one to be written, and nothing that acts."""
        annotations = vars(self.cls).get("__annotations__", {})
        members = {k: x for k, x in vars(self.cls).items() if k in annotations}
        members |= self.defaults | self.defined
        members |= {k: getattr(self.cls, k) for k in ("__module__", "__qualname__")}
        # without a text the standard library would make one, of the signature
        members |= {"__annotations__": annotations, "__doc__": "Methods of a record."}
        if hasattr(self.cls, "__post_init__"):
            members["__post_init__"] = None
        return members


class _Waiting:
    """A name of a class that is written when it is asked for, as a method or as a value."""

    def __init__(self, owner: _Unwritten, name: str) -> None:
        self.owner = owner
        self.name = name

    def __get__(self, instance: object, kind: type) -> object:
        self.owner.write(self.name)
        cls = self.owner.cls
        if self.name not in vars(cls):
            # a field without a default: what a base has, or the error of Python
            return getattr(super(cls, kind if instance is None else instance), self.name)
        value = vars(cls)[self.name]
        bind = getattr(type(value), "__get__", None)
        return value if bind is None else bind(value, instance, kind)


def _freeze(cls: type[object]) -> None:
    """Refuse to set and to delete fields as frozen dataclasses do, by functions without text."""

    set_of_bases, delete_of_bases = cls.__setattr__, cls.__delattr__

    def of_record(self: object, name: str) -> bool:
        return type(self) is cls or name in getattr(cls, _FIELDS)

    def set_unless_frozen(self: object, name: str, value: object) -> None:
        if of_record(self, name):
            raise dataclasses.FrozenInstanceError(f"cannot assign to field {name!r}")
        set_of_bases(self, name, value)

    def delete_unless_frozen(self: object, name: str) -> None:
        if of_record(self, name):
            raise dataclasses.FrozenInstanceError(f"cannot delete field {name!r}")
        delete_of_bases(self, name)

    for name, method in zip(_CHANGES, (set_unless_frozen, delete_unless_frozen), strict=True):
        if name in vars(cls):
            raise TypeError(f"{cls.__name__} is frozen and has {name}; leave out one of them")
        setattr(cls, name, method)
