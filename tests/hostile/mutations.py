"""Mutants of files: bytes, values, types, sizes, and things that are not files."""

from __future__ import annotations

import copy
import math
import os
import random
import socket
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from hostile.harness import Kind

INTEGERS = (0, 1, -1, 2, 3, 7, 1000, 10**6, 2**31, 2**31 - 1, 2**40, -(2**40), 2**62, 2**63, 2**64)
NUMBERS = (0.0, -0.0, 1.0, -1.0, 1e-320, 1e300, -1e300, math.inf, -math.inf, math.nan, 0.5, 1e15)
TEXTS = ("", "x", "t", "q", "../../etc/passwd", "/dev/zero", "a" * 100_000, "\x00", "\ud800", "nan")
ODD: tuple[Callable[[], Any], ...] = (
    lambda: None,
    lambda: True,
    lambda: [],
    lambda: {},
    lambda: [1, 2],
    lambda: {"x": 1},
    lambda: _deep(200),
    lambda: "1",
    lambda: 1.5,
    lambda: -1,
)


@dataclass(frozen=True)
class Mutant:
    """What becomes of a file.

    Attributes:
        told: How it was made.
        put: Does it to the file at a path.
        forged: Its hashes are correct.
        places: Where in its parts something was changed.
    """

    told: str
    put: Callable[[Path], None]
    forged: bool = False
    places: tuple[tuple[Any, ...], ...] = ()


def mutant(drawn: random.Random, kind: Kind, content: bytes, number: int) -> Mutant:
    """A mutant of a file: damaged bytes, forged parts, or no file at all."""
    ways = ["damaged"] * 4 + ["forged"] * 10 * (kind.unpack is not None) + ["special"]
    way = drawn.choice(ways)
    if way == "special":
        return special(drawn, kind, content, drawn.randrange(len(SPECIAL)))
    return (_damaged if way == "damaged" else _forged)(drawn, kind, content)


# bytes


def _damaged(drawn: random.Random, kind: Kind, content: bytes) -> Mutant:
    how = drawn.choice((_flip, _byte, _cut, _grow, _repeat, _zeros, _drop, _digit))
    return Mutant(how.__name__, lambda path: _write(path, how(drawn, content)))


def _flip(drawn: random.Random, content: bytes) -> bytes:
    data = bytearray(content)
    data[drawn.randrange(len(data))] ^= 1 << drawn.randrange(8)
    return bytes(data)


def _byte(drawn: random.Random, content: bytes) -> bytes:
    data = bytearray(content)
    for _ in range(drawn.choice((1, 1, 2, 20))):
        data[drawn.randrange(len(data))] = drawn.randrange(256)
    return bytes(data)


def _cut(drawn: random.Random, content: bytes) -> bytes:
    return content[: drawn.choice((0, 1, 10, len(content) - 1, drawn.randrange(len(content))))]


def _grow(drawn: random.Random, content: bytes) -> bytes:
    return content + drawn.randbytes(drawn.choice((1, 8, 32, 1000)))


def _repeat(drawn: random.Random, content: bytes) -> bytes:
    start, end = sorted(drawn.randrange(len(content)) for _ in range(2))
    return content[:end] + content[start:end] + content[end:]


def _zeros(drawn: random.Random, content: bytes) -> bytes:
    start = drawn.randrange(len(content))
    end = min(len(content), start + drawn.choice((1, 8, 512)))
    return content[:start] + bytes(end - start) + content[end:]


def _drop(drawn: random.Random, content: bytes) -> bytes:
    start = drawn.randrange(len(content))
    return content[:start] + content[start + drawn.choice((1, 8, 32, 512)) :]


def _digit(drawn: random.Random, content: bytes) -> bytes:
    places = [k for k, byte in enumerate(content) if 48 <= byte <= 57]
    if not places:
        return _byte(drawn, content)
    data = bytearray(content)
    data[drawn.choice(places)] = 48 + drawn.randrange(10)
    return bytes(data)


# parts


def _forged(drawn: random.Random, kind: Kind, content: bytes) -> Mutant:
    assert kind.unpack is not None
    assert kind.pack is not None
    parts = kind.unpack(content)
    places = []
    for _ in range(drawn.choice((1, 1, 1, 1, 2, 5))):
        # all of it may be gone already
        places += [_change(drawn, parts)] if parts else []
    try:
        made = kind.pack(parts)
    except (ValueError, TypeError, OverflowError, KeyError, AttributeError, RecursionError):
        # what no file of this kind can hold: damage instead
        return _damaged(drawn, kind, content)
    told = "; ".join(f"{place[:-1]} {place[-1]}" for place in places)
    return Mutant(told, lambda path: _write(path, made), True, tuple(p[:-1] for p in places))


def _change(drawn: random.Random, parts: dict[str, Any]) -> tuple[Any, ...]:
    """Change one place in the parts; returns where, and in words to what."""
    holder: Any = parts
    path: tuple[Any, ...] = ()
    if drawn.random() < 0.5:
        # any value alike, however deep
        *path, key = drawn.choice(list(_leaves(parts, ())))
        for step in path:
            holder = holder[step]
        return (*path, key, _put(drawn, holder, key))
    while True:
        keys = list(holder) if isinstance(holder, dict) else list(range(len(holder)))
        key = drawn.choice(keys)
        path = (*path, key)
        inside = holder[key]
        container = isinstance(inside, dict | list) and len(inside) > 0
        if container and drawn.random() < 0.9:
            holder = inside
            continue
        break
    return (*path, _put(drawn, holder, key))


def _leaves(holder: Any, path: tuple[Any, ...]) -> Iterator[tuple[Any, ...]]:
    """Paths of everything that is not a container."""
    for key in holder if isinstance(holder, dict) else range(len(holder)):
        inside = holder[key]
        if isinstance(inside, dict | list) and inside:
            yield from _leaves(inside, (*path, key))
        else:
            # an array is many values
            yield from [(*path, key)] * (10 if isinstance(inside, np.ndarray) else 1)


def _put(drawn: random.Random, holder: Any, key: Any) -> str:
    """Change what stands under a key; returns in words to what."""
    inside = holder[key]
    if isinstance(inside, np.ndarray) and drawn.random() < 0.9:
        holder[key], told = _array(drawn, inside)
        return told
    if drawn.random() < 0.15:
        told = drawn.choice(("gone", "twice"))
        if told == "gone":
            del holder[key]
        elif isinstance(holder, list):
            holder.insert(key, copy.deepcopy(inside))
        else:
            holder["twice"] = copy.deepcopy(inside)
        return told
    holder[key] = _value(drawn, inside)
    return f"= {holder[key]!r:.60}"


def _value(drawn: random.Random, old: Any) -> Any:
    """Another value: of its type mostly."""
    if drawn.random() < 0.3:
        return drawn.choice(ODD)()
    if isinstance(old, bool):
        return not old
    if isinstance(old, int):
        near = (old + 1, old - 1, 2 * old, -old)
        return drawn.choice((*near, *INTEGERS))
    if isinstance(old, float):
        return drawn.choice((old * (1 + 1e-9), -old, old * 1e9, *NUMBERS))
    if isinstance(old, str):
        return drawn.choice((old + "x", old[:-1], old.upper(), *TEXTS))
    return drawn.choice(ODD)()


def _array(drawn: random.Random, old: np.ndarray) -> tuple[Any, str]:
    """Another array: other numbers, another size, shape or type."""
    how = drawn.choice(("number", "number", "number", "longer", "shorter", "shape", "type", "many"))
    new = old.copy()
    if how == "number" and new.size:
        k = drawn.randrange(new.size)
        if new.dtype.kind == "f":
            value: Any = drawn.choice(NUMBERS)
        elif new.dtype.itemsize == 1:
            value = drawn.randrange(128)
        else:
            limits = np.iinfo(new.dtype) if new.dtype.kind in "iu" else None
            low, high = (limits.min, limits.max) if limits else (0, 1)
            value = drawn.choice([n for n in INTEGERS if low <= n <= high] or [0])
        with np.errstate(all="ignore"):
            new.flat[k] = value
        return new, f"[{k}] = {value!r}"
    if how == "longer":
        return np.concatenate([new.ravel(), new.ravel()[:1], new.ravel()[:1]]), how
    if how == "shorter":
        return new.ravel()[:-1], how
    if how == "shape":
        return new.reshape(1, *new.shape, 1), how
    if how == "many":
        return np.zeros(drawn.choice((0, 1, 10**5)), dtype=new.dtype), how
    kind = drawn.choice(("float32", "int64", "int8", "complex128", "S3", "U2", ">f8", "bool", "O"))
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return new.astype(kind), f"type {kind}"
        except (ValueError, TypeError, OverflowError):
            return new.astype("U5"), "type U5"


def _deep(levels: int) -> Any:
    found: Any = []
    for _ in range(levels):
        found = [found]
    return found


# what is not a file


def special(drawn: random.Random, kind: Kind, content: bytes, number: int) -> Mutant:
    """The mutant that is not a regular file, by its number."""
    how = SPECIAL[number % len(SPECIAL)]
    return Mutant(how.__name__, lambda path: _replace(path, how))


def _replace(path: Path, how: Callable[[Path], None]) -> None:
    path.unlink()
    how(path)


def _fifo(path: Path) -> None:
    os.mkfifo(path)


def _link_to_fifo(path: Path) -> None:
    os.mkfifo(path.with_name("fifo"))
    path.symlink_to("fifo")


def _zero(path: Path) -> None:
    path.symlink_to("/dev/zero")


def _null(path: Path) -> None:
    path.symlink_to("/dev/null")


def _terminal(path: Path) -> None:
    path.symlink_to("/dev/tty")


def _process(path: Path) -> None:
    path.symlink_to("/proc/self/mem")


def _folder(path: Path) -> None:
    path.mkdir()


def _gone(path: Path) -> None:
    del path


def _loop(path: Path) -> None:
    path.symlink_to(path.name)


def _dangling(path: Path) -> None:
    path.symlink_to("nowhere")


def _socket(path: Path) -> None:
    # names of sockets are short
    here = os.open(path.parent, os.O_RDONLY)
    try:
        with socket.socket(socket.AF_UNIX) as made:
            made.bind(f"/proc/self/fd/{here}/{path.name}")
    finally:
        os.close(here)


def _sparse(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(1 << 40)


SPECIAL = (
    _fifo,
    _link_to_fifo,
    _zero,
    _null,
    _terminal,
    _process,
    _folder,
    _gone,
    _loop,
    _dangling,
    _socket,
    _sparse,
)


def _write(path: Path, content: bytes) -> None:
    """New bytes in a file of its own: the good one may be linked to it."""
    path.unlink()
    path.write_bytes(content)
