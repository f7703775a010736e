"""Records: dataclasses whose methods are written when the first one is made.

``dataclass`` of the standard library writes six functions as text for every class and has Python
compile them; a process that imports hundreds of records and makes few of them waits for that most
of all. Here a class waits for its first use: until then descriptors stand in the place of what the
standard library writes. From then on ``fields``, ``replace``, ``pickle``, ``match`` and type
checkers see the dataclass that the standard library makes.
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
        waiting = [_FIELDS, _PARAMETERS, *self.defaults]
        for option, names in _METHODS.items():
            waiting += [k for k in names if options.get(option, True) and k not in self.defined]
        for name in waiting:
            setattr(cls, name, _Waiting(self, name))
        if options.get("frozen"):
            _freeze(cls)

    def write(self) -> None:
        """Put in place what the standard library writes for a class of the same fields."""
        with _LOCK:
            waiting = [k for k, x in vars(self.cls).items() if isinstance(x, _Waiting)]
            if not waiting:
                return
            written = vars(dataclasses.dataclass(**self.options)(self._stand_in()))
            for name in waiting:
                if name in written:
                    setattr(self.cls, name, written[name])
                else:  # a field without a default
                    delattr(self.cls, name)
            # what further options and later Pythons write
            for name in written.keys() - vars(self.cls).keys() - _UNCHANGED:
                setattr(self.cls, name, written[name])

    def _stand_in(self) -> type:
        """A class with the same fields, those of its bases too, and nothing else that acts."""
        inherited: dict[str, object] = {}
        fields: dict[str, object] = {}
        for base in reversed(self.cls.__mro__[1:]):
            if _FIELDS in vars(base):
                fields |= getattr(base, _FIELDS)
                inherited = {_FIELDS: fields, _PARAMETERS: getattr(base, _PARAMETERS)}
        annotations = vars(self.cls).get("__annotations__", {})
        members = {k: x for k, x in vars(self.cls).items() if k in annotations}
        members |= self.defaults | self.defined
        members |= {k: getattr(self.cls, k) for k in ("__module__", "__qualname__")}
        # without a text the standard library would make one, of the signature
        members |= {"__annotations__": annotations, "__doc__": "Methods of a record."}
        if hasattr(self.cls, "__post_init__"):
            members["__post_init__"] = None
        bases = (type("Inherited", (), inherited),) if inherited else ()
        return type(self.cls.__name__, bases, members)


class _Waiting:
    """A name of a class that is written when it is asked for, as a method or as a value."""

    def __init__(self, owner: _Unwritten, name: str) -> None:
        self.owner = owner
        self.name = name

    def __get__(self, instance: object, kind: type) -> object:
        self.owner.write()
        cls = self.owner.cls
        if self.name not in vars(cls):
            # a field without a default: what a base has, or the error of Python
            return getattr(super(cls, kind if instance is None else instance), self.name)
        value = vars(cls)[self.name]
        bind = getattr(type(value), "__get__", None)
        return value if bind is None else bind(value, instance, kind)


def _freeze(cls: type[object]) -> None:
    """Refuse to set and delete fields as frozen dataclasses do; nothing is compiled for it."""

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
