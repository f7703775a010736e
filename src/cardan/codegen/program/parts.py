"""Long functions in parts: compilers need more than linear time for long straight-line code.

Values that one part makes and another reads go through the work array. A place in it is used
again when its value has been read for the last time.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from heapq import heappop, heappush

from .sections import Sections

# statements of a function that stays in one piece, and of the parts of a longer one: measured,
# compile time per statement grows above some hundreds, and so do the values that find no register;
# calls cost nothing
LONGEST, PART = 1000, 450


def split(sections: Sections, longest: int = LONGEST) -> list[Sections]:
    """Cut sections into parts of about equal length; one part if there are few statements.

    Args:
        sections: (title, statements).
        longest: Most statements of one piece; sections are cut only where they are long.
    """
    total = sum(len(statements) for _, statements in sections)
    if total <= longest:
        return [sections]
    size = -(-total // -(-total // min(longest, PART)))
    parts: list[Sections] = [[]]
    room = size
    for title, statements in sections:
        at = 0
        while at < len(statements):
            left = len(statements) - at
            # a section moves on to the next part rather than being cut, unless it fills parts
            if parts[-1] and left > room and (left <= size // 2 or room < size // 4):
                parts.append([])
                room = size
            take = min(left, room)
            parts[-1].append((title, statements[at : at + take]))
            at += take
            room -= take
            if room == 0 and (at < len(statements)):
                parts.append([])
                room = size
        if room == 0:
            parts.append([])
            room = size
    return [part for part in parts if part]


def crossing(
    parts: Sequence[Sections], reads: Mapping[int, tuple[int, ...]], start: int
) -> tuple[dict[int, int], int]:
    """Places in the work array for values that later parts read.

    Args:
        parts: As :func:`split` makes them.
        reads: Statement -> what it reads.
        start: First free place.

    Returns:
        Statement -> place, and the length of the array.
    """
    if len(parts) == 1:
        return {}, start
    part_of = {i: n for n, part in enumerate(parts) for _, statements in part for i in statements}
    last_read: dict[int, int] = {}
    for i, n in part_of.items():
        for k in reads[i]:
            if part_of.get(k, n) != n:
                last_read[k] = max(last_read.get(k, 0), n)

    # a place becomes free after the part that reads it last
    places: dict[int, int] = {}
    free: list[int] = []
    length = start
    ending: list[list[int]] = [[] for _ in parts]
    for n, part in enumerate(parts):
        for _, statements in part:
            for i in statements:
                if i in last_read:
                    places[i] = heappop(free) if free else length
                    length = max(length, places[i] + 1)
                    ending[last_read[i]].append(places[i])
        for place in ending[n]:
            heappush(free, place)
    return places, length
