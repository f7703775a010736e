"""Default classes: attributes that elements take over where they say nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ....errors import ModelError, near
from ..document import Element, element_at, place
from .actuators import general
from .compiler import ORIENTATIONS
from .ignored import ACTUATORS, Unread, attributes_read

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

TOP = "main"
# elements that have defaults -> what is read of them
KINDS = {name: name for name in ("joint", "geom", "site", *ACTUATORS)} | {"equality": "weld"}
# of these only one may be said: the element's own word counts
ALTERNATIVES = (frozenset(ORIENTATIONS),)


class Defaults:
    """The classes of a file.

    Args:
        where: The file, for messages.
        unread: Collects what is passed over.
    """

    def __init__(self, where: str, unread: Unread) -> None:
        self.where = where
        self.unread = unread
        # class -> tag -> attributes
        self.classes: dict[str, dict[str, dict[str, str]]] = {TOP: {}}

    def read(self, element: XmlElement) -> None:
        """The classes of a <default> of the file, those inside it included.

        Raises:
            ModelError: a class without a name, or one that is defined twice.
        """
        waiting = [(element, TOP, TOP)]
        while waiting:
            raw, name, parent = waiting.pop()
            if name != TOP and name in self.classes:
                raise ModelError(
                    f"{place(raw, self.where)}: default class '{name[:80]}' is defined twice"
                )
            merged_class = dict(self.classes[parent])
            for child in raw:
                if child.tag in KINDS:
                    self.unread.attributes(child, KINDS[child.tag])
                    attributes = {
                        k: text
                        for k, text in child.items()
                        if k in attributes_read(KINDS[child.tag])
                    }
                    self._merge(merged_class, child, attributes)
                elif child.tag != "default":
                    self.unread.element(child, "default")
            self.classes[name] = merged_class
            inner = [child for child in raw if child.tag == "default"]
            for child in reversed(inner):
                inner_name = child.get("class")
                if not inner_name:
                    raise ModelError(
                        f"{place(child, self.where)}: a default inside another needs a class"
                    )
                waiting.append((child, inner_name, name))
        # the outermost class may have a name of its own
        self.classes[element.get("class") or TOP] = self.classes[TOP]

    def _merge(
        self, classes: dict[str, dict[str, str]], child: XmlElement, attributes: dict[str, str]
    ) -> None:
        """Put the attributes of an element into a class."""
        if child.tag not in ACTUATORS:
            classes[child.tag] = merged(classes.get(child.tag, {}), attributes)
            return
        # actuators of all sorts share one default, in the words of the general one
        where = f"{place(child, self.where)}: <{child.tag}>"
        element = Element(element_at(child, child.tag, attributes), where)
        classes["general"] = general(element, classes.get("general", {}))

    def actuator(self, raw: XmlElement, where: str) -> Element:
        """An actuator with what its class adds, in the words of the general one.

        Raises:
            ModelError: there is no such class, or numbers that are none.
        """
        defaults = self.of(element_at(raw, "general", {}), where, raw.get("class") or TOP).raw
        shared = general(Element(raw, where), defaults.attrib) if raw.tag in ACTUATORS else {}
        return Element(element_at(raw, raw.tag, {**raw.attrib, **shared}), where)

    def of(self, raw: XmlElement, where: str, inherited: str, tag: str | None = None) -> Element:
        """An element with what its class adds.

        Args:
            inherited: The class of the bodies around it.
            tag: Under which the classes know it; its own by default.

        Raises:
            ModelError: there is no such class.
        """
        name = raw.get("class") or inherited
        if name not in self.classes:
            listed = near(name, self.classes).replace(" Known:", " Classes:")
            raise ModelError(f"{where}: there is no default class '{name[:80]}'.{listed}")
        defaults = self.classes[name].get(tag or raw.tag, {})
        element = element_at(raw, raw.tag, merged(defaults, raw.attrib))
        element.extend(raw)
        return Element(element, where)


def merged(defaults: dict[str, str], attributes: dict[str, str]) -> dict[str, str]:
    """Attributes of a class with an element's own before them."""
    hidden = set(attributes)
    for alternatives in ALTERNATIVES:
        if alternatives & hidden:
            hidden |= alternatives
    return {key: text for key, text in defaults.items() if key not in hidden} | dict(attributes)
