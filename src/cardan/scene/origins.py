"""Places of the items of a model in its file, for errors that show later."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from warnings import WarningMessage

from ..errors import CardanError

# kind and name of an item -> file, line and column
Origins = Mapping[tuple[str, str], str]
KINDS = (
    "body",
    "frame",
    "beam",
    "cable",
    "superelement",
    "joint",
    "force",
    "output",
    "parameter",
    "input",
    "constraint",
)
# items that make others, whose names begin with theirs
MAKERS = ("include", "dh")
_DOUBT = re.compile(rf"({'|'.join(KINDS)}) '([^']*)': (.*)", re.S)
MAX_PRINTED = 6  # names in one warning
_NAMED = re.compile(rf"^()'([^']*)'|\b({'|'.join(KINDS)}) '([^']*)'")


def located(problem: CardanError, origins: Origins) -> CardanError:
    """The error with the place of the item it names first, such as ``'upper.mass'``.

    An error that names no item of a file comes back as it is.
    """
    place = place_of(str(problem), origins)
    return problem if place is None else type(problem)(f"{place}: {problem}")


def place_of(text: str, origins: Origins) -> str | None:
    """Place of the item that a message names first, if it names one of the file."""
    match = _NAMED.search(text) if origins else None
    if match is None:
        return None
    kind, name = match.group(3), match.group(4) if match.group(3) else match.group(2)
    return _place(kind, name, origins)


def gathered(said: Iterable[WarningMessage], origins: Origins) -> list[Warning]:
    """Warnings of reading a file, each with its place; one for all items with the same doubt."""
    alike: dict[tuple[type[Warning], str, str], list[str]] = {}
    for one in said:
        text = str(one.message)
        match = _DOUBT.match(text)
        kind, name, doubt = match.groups() if match else ("", "", text)
        alike.setdefault((one.category, kind, doubt), []).append(name)
    return [
        category(_joined_warning(kind, names, doubt, origins))
        for (category, kind, doubt), names in alike.items()
    ]


def _joined_warning(kind: str, names: list[str], doubt: str, origins: Origins) -> str:
    if not kind:
        return doubt
    listed = ", ".join(f"'{name}'" for name in names[:MAX_PRINTED])
    more = f" and {len(names) - MAX_PRINTED} more" if len(names) > MAX_PRINTED else ""
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
