"""Where the items of a model stand in its file, for errors that show later."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from warnings import WarningMessage

from ..errors import CardanError

# kind and name of an item -> file, line and column
Origins = Mapping[tuple[str, str], str]
KINDS = ("body", "frame", "beam", "joint", "force", "output", "parameter", "input", "constraint")
# items that make others, whose names begin with theirs
MAKERS = ("include", "dh")
_DOUBT = re.compile(rf"({'|'.join(KINDS)}) '([^']*)': (.*)", re.S)
SHOWN = 6  # names in one warning
_NAMED = re.compile(rf"^()'([^']*)'|\b({'|'.join(KINDS)}) '([^']*)'")


def located(problem: CardanError, origins: Origins) -> CardanError:
    """The error with the place of the item it names first, such as ``'upper.mass'``.

    An error that names no item of a file comes back as it is.
    """
    place = place_of(str(problem), origins)
    return problem if place is None else type(problem)(f"{place}: {problem}")


def place_of(text: str, origins: Origins) -> str | None:
    """Place of the item that a message names first, if it names one of the file."""
    found = _NAMED.search(text) if origins else None
    if found is None:
        return None
    kind, name = found.group(3), found.group(4) if found.group(3) else found.group(2)
    return _place(kind, name, origins)


def gathered(said: Iterable[WarningMessage], origins: Origins) -> list[Warning]:
    """Warnings of reading a file, each with its place; one for all items with the same doubt."""
    alike: dict[tuple[type[Warning], str, str], list[str]] = {}
    for one in said:
        text = str(one.message)
        found = _DOUBT.match(text)
        kind, name, doubt = found.groups() if found else ("", "", text)
        alike.setdefault((one.category, kind, doubt), []).append(name)
    return [
        made(_together(kind, names, doubt, origins)) for (made, kind, doubt), names in alike.items()
    ]


def _together(kind: str, names: list[str], doubt: str, origins: Origins) -> str:
    if not kind:
        return doubt
    listed = ", ".join(f"'{name}'" for name in names[:SHOWN])
    more = f" and {len(names) - SHOWN} more" if len(names) > SHOWN else ""
    many = kind if len(names) == 1 else {"body": "bodies"}.get(kind, f"{kind}s")
    place = place_of(f"{kind} '{names[0]}'", origins)
    return (
        f"{place}: {many} {listed}{more}: {doubt}" if place else f"{many} {listed}{more}: {doubt}"
    )


def _place(kind: str | None, name: str, origins: Origins) -> str | None:
    """Place of the item that a dotted name belongs to: the one with the longest name."""
    name = name.removeprefix("output.") if kind is None else name
    parts = name.split(".")
    for count in range(len(parts), 0, -1):
        for one in (*(KINDS if kind is None else (kind,)), *MAKERS):
            place = origins.get((one, ".".join(parts[:count])))
            if place is not None:
                return place
    return None
