"""Where the items of a model stand in its file, for errors that show later."""

from __future__ import annotations

import re
from collections.abc import Mapping

from ..errors import CardanError

# kind and name of an item -> file, line and column
Origins = Mapping[tuple[str, str], str]
KINDS = ("body", "frame", "beam", "joint", "force", "output", "parameter", "input", "constraint")
# items that make others, whose names begin with theirs
MAKERS = ("include", "dh")
_NAMED = re.compile(rf"^()'([^']*)'|\b({'|'.join(KINDS)}) '([^']*)'")


def located(problem: CardanError, origins: Origins) -> CardanError:
    """The error with the place of the item it names first, such as ``'upper.mass'``.

    An error that names no item of a file comes back as it is.
    """
    found = _NAMED.search(str(problem)) if origins else None
    if found is None:
        return problem
    kind, name = found.group(3), found.group(4) if found.group(3) else found.group(2)
    place = _place(kind, name, origins)
    return problem if place is None else type(problem)(f"{place}: {problem}")


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
