"""Elements of a file that the model does not act on, by name."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement


class Unread:
    """Counts elements and attributes that are passed over."""

    def __init__(self) -> None:
        self.counts: Counter[str] = Counter()

    def element(self, raw: XmlElement, inside: str = "") -> None:
        """A whole element is passed over."""
        self.counts[f"{inside} {raw.tag}".strip()] += 1

    def notes(self) -> list[str]:
        """All of it in one note, the most frequent first."""
        if not self.counts:
            return []
        names = (f"{what} ({n})" if n > 1 else what for what, n in self.counts.most_common())
        return [f"not read: {', '.join(names)}"]
