"""Records of ``cardan.records`` are the dataclasses of the standard library, and wait."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import pickle
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier
from typing import Any, ClassVar

import pytest

from architecture.sources import imports
from cardan.records import dataclass
from table import each

Decorate = Callable[..., Any]


def family(decorate: Decorate) -> list[Any]:
    """The same classes by another decorator."""

    @decorate(frozen=True)
    class Point:
        """A point."""

        x: float
        y: float = 2.0
        names: tuple[str, ...] = dataclasses.field(default_factory=tuple, repr=False)
        count: ClassVar[int] = 3

    @decorate(frozen=True, eq=False)
    class Named(Point):
        name: str = "P"

        def __post_init__(self) -> None:
            object.__setattr__(self, "y", self.y + 1)

    @decorate
    class Plain:
        a: Any
        b: Any = dataclasses.field(default=5, compare=False)

        def __repr__(self) -> str:
            return f"<{self.a}>"

    @decorate(order=True, kw_only=True)
    class Ordered(Plain):
        c: int = 0

        def __eq__(self, other: object) -> bool:
            return isinstance(other, type(self)) and self.c == other.c

    @decorate(frozen=True)
    class Empty:
        pass

    return [Point, Named, Plain, Ordered, Empty]


OURS, STANDARD = family(dataclass), family(dataclasses.dataclass)
ARGUMENTS: list[tuple[tuple[Any, ...], dict[str, Any]]] = [
    ((1.0,), {}),
    ((1.0, 2.5, ("a",)), {"name": "Q"}),
    ((1,), {"b": 7}),
    ((), {"a": 1, "c": 4}),
    ((), {}),
]
ROWS = [*zip(OURS, STANDARD, ARGUMENTS, strict=True)]


def outcome(work: Callable[[], object]) -> object:
    """What a call gives, or its error."""
    try:
        return work()
    except Exception as error:
        return type(error), str(error)


@each("ours, standard, arguments", ROWS)
def test_records_are_dataclasses(ours: Any, standard: Any, arguments: Any) -> None:
    def seen(kind: Any) -> list[Any]:
        one, same = (kind(*arguments[0], **arguments[1]) for _ in range(2))
        return [
            repr(one),
            one == same,
            outcome(lambda: hash(one) == hash(same)) if kind.__hash__ is not object.__hash__ else 0,
            outcome(lambda: one < same),
            outcome(lambda: setattr(one, "x", 0)),
            outcome(lambda: delattr(one, "x")),
            outcome(lambda: setattr(one, "other", 0)),
            [(f.name, f.type, f.default, f.repr, f.kw_only) for f in dataclasses.fields(kind)],
            repr(dataclasses.replace(same)),
            repr(copy.deepcopy(same)),
            dataclasses.asdict(same),
            str(inspect.signature(kind)),
            kind.__match_args__,
            repr(kind.__dataclass_params__),
            kind.__doc__ or "",
            kind.__init__.__qualname__.replace("standard", "ours"),
            sorted(k for k in vars(kind) if k not in ("__doc__", "__firstlineno__")),
        ]

    expected = seen(standard)
    expected[-3] = ours.__doc__ or ""  # the standard library makes a text where there is none
    assert seen(ours) == expected


@dataclass(frozen=True)
class Late:
    """Of this module, so that pickle finds it."""

    a: int
    b: list[int] = dataclasses.field(default_factory=list)


def waits(kind: type) -> bool:
    """True where nothing was written for a class yet."""
    return type(vars(kind)["__init__"]).__name__ == "_Waiting"


@each(
    "use",
    [
        dataclasses.is_dataclass,
        dataclasses.fields,
        inspect.signature,
        lambda kind: kind(a=1),
        lambda kind: kind.default,
        lambda kind: repr(object.__new__(type("Inner", (kind,), {"a": 1, "names": ()}))),
        lambda kind: outcome(lambda: kind.names),
    ],
)
def test_every_use_writes_a_class(use: Callable[[type], object]) -> None:
    @dataclass
    class Fresh:
        a: int
        names: list[str] = dataclasses.field(default_factory=list)
        default: int = dataclasses.field(default=3)

    assert waits(Fresh)
    use(Fresh)
    assert not waits(Fresh)
    assert Fresh.default == Fresh(1).default == 3
    with pytest.raises(AttributeError, match="names"):
        Fresh.names  # noqa: B018


def test_a_pickled_record_needs_no_methods() -> None:
    data = pickle.dumps(Late(3, [4]))
    assert pickle.loads(data) == Late(3, [4])


def test_a_base_is_written_before_the_class_that_builds_on_it() -> None:
    Point, Named = family(dataclass)[:2]
    assert repr(Named(1.0)).endswith("Named(x=1.0, y=3.0, name='P')")
    assert not waits(Named)
    assert repr(Point(1.0)).endswith("Point(x=1.0, y=2.0)")


def test_threads_that_use_a_class_at_once() -> None:
    count = 8
    for _ in range(50):
        (Point, *_) = family(dataclass)
        start = Barrier(count)

        def use(k: int, kind: Any = Point, start: Barrier = start) -> Any:
            start.wait()
            return kind(k), kind(k) == kind(k), hash(kind(k))

        with ThreadPoolExecutor(count) as pool:
            made = list(pool.map(use, range(count)))
        assert all(equal and one.x == k for k, (one, equal, _) in enumerate(made))


def test_a_frozen_record_has_no_setter() -> None:
    with pytest.raises(TypeError, match="frozen"):

        @dataclass(frozen=True)
        class _Wrong:
            a: int

            def __setattr__(self, name: str, value: object) -> None: ...


def test_records_of_the_package_wait() -> None:
    wrong = [
        str(one)
        for one in imports()
        if one.target == "dataclasses" and one.name == "dataclass" and one.kind != "type"
    ]
    # that of the standard library compiles text in every process that imports the module
    assert not wrong, "from cardan.records import dataclass:\n" + "\n".join(wrong)
