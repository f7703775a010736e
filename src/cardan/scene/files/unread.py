"""Elements and attributes of a robot file that are passed over, and those that are misspelt."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING

from ...errors import ModelWarning, likely, warn
from ...records import dataclass
from .document import place

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

MAX_LISTED = 40  # names in the note on what is passed over
MAX_LETTERS = 60  # of one of them
MAX_MISSPELT = 8  # notes on these
MAX_COMPARED = 1000  # names that are compared with those that are read


@dataclass(frozen=True)
class Content:
    """Names that are read of an element.

    Attributes:
        attributes: Of its attributes.
        elements: Of the elements inside.
    """

    attributes: Collection[str]
    elements: Collection[str] = ()


class Unread:
    """Counts elements and attributes that are passed over.

    Attributes:
        counts: What is passed over, such as ``link collision``, -> how often.
        misspelt: Sentences on what looks like something that is read, -> how often.
    """

    def __init__(self) -> None:
        self.counts: Counter[str] = Counter()
        self.misspelt: Counter[str] = Counter()
        # element around and name -> the sentence on its first use, "" where it looks like nothing
        self._sentences: dict[tuple[str, str], str] = {}

    def element(self, raw: XmlElement, inside: str = "") -> None:
        """A whole element is passed over."""
        self.counts[f"{inside} {plain(raw.tag)}".strip()] += 1

    def document(self, root: XmlElement, contents: Mapping[str, Content], file: str) -> None:
        """Compare a whole document with what is read of it.

        Args:
            root: The outermost element.
            contents: Name of an element -> what is read of it.
            file: Its name, for messages.
        """
        waiting = [(root, "")]
        while waiting:
            raw, owner = waiting.pop()
            content = contents[raw.tag]
            # what has no name of its own belongs to the element around it that has one
            owner = f"{raw.tag} '{raw.get('name', '')[:80]}': " if raw.get("name") else owner
            where = f"{place(raw, file)}: {owner}"
            # what the element has already is not what another name stands for
            free = [name for name in content.attributes if name not in raw.attrib]
            for name in raw.attrib:
                if name not in content.attributes:
                    short = plain(name)
                    said = f"<{raw.tag} {short}=...>"
                    if not self._alike(name, free, raw.tag, f"{where}{said}"):
                        self.counts[f"{raw.tag} {short}="] += 1
            # the last is taken first: so they come in the order of the file
            waiting += [(child, owner) for child in reversed(raw) if child.tag in content.elements]
            for child in raw:
                if child.tag in content.elements:
                    continue
                said = f"{place(child, file)}: {owner}<{plain(child.tag)}>"
                if not self._alike(child.tag, content.elements, raw.tag, said):
                    self.element(child, "" if raw is root else raw.tag)

    def _alike(self, name: str, names: Collection[str], inside: str, said: str) -> bool:
        """Note a name that looks like one that is read; False where it looks like none."""
        sentence = self._sentences.get((inside, name))
        if sentence is None:
            comparable = len(name) <= MAX_LETTERS and len(self._sentences) < MAX_COMPARED
            close = likely(name, list(names)) if comparable else []
            sentence = f"{said} is not read. Did you mean '{close[0]}'?" if close else ""
            self._sentences[inside, name] = sentence
        if sentence:
            self.misspelt[sentence] += 1
        return bool(sentence)

    def announce(self) -> list[str]:
        """Warn of what is misspelt; the notes on it."""
        notes = []
        for sentence, count in self.misspelt.most_common(MAX_MISSPELT):
            notes.append(f"{sentence} ({count} times)" if count > 1 else sentence)
            warn(notes[-1], ModelWarning)
        return notes

    def notes(self) -> list[str]:
        """All that is passed over in one note, the most frequent first."""
        if not self.counts:
            return []
        names = [f"{what} ({n})" if n > 1 else what for what, n in self.counts.most_common()]
        more = f" and {len(names) - MAX_LISTED} more" if len(names) > MAX_LISTED else ""
        return [f"not read: {', '.join(names[:MAX_LISTED])}{more}"]


def plain(name: str) -> str:
    """The name of an element or attribute without its namespace, as short as a note needs it."""
    return name.rpartition("}")[2][:MAX_LETTERS]
