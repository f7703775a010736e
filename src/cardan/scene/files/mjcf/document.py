"""The document: included files in place, sections joined, bodies in order."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from ....errors import ModelError, TopologyError
from ....records import dataclass
from ..document import PLACE, Element, Numbered, content, element_at, parse, place
from ..meshes import Meshes
from ..options import Options
from ..pose import HERE, Pose
from .compiler import Compiler
from .defaults import TOP
from .ignored import Unread

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

MOST_BODIES = 100_000
# they make bodies by rules of their own; without them the model would be another
REFUSED = ("replicate", "composite", "flexcomp", "attach")


@dataclass(frozen=True)
class BodyElement:
    """A body of the file with what is in it.

    Attributes:
        raw: The element.
        name: Its own name or a made one; "" for the world.
        parent: Number of its parent, -1 for the world.
        pose: In axes of the parent, all joints as drawn.
        parts: Elements inside, each with the pose of the frames around it and its default class.
    """

    raw: XmlElement
    name: str
    parent: int
    pose: Pose
    parts: tuple[tuple[XmlElement, Pose, str], ...]


@dataclass(frozen=True)
class Document:
    """An MJCF document.

    Attributes:
        root: Its root element, included files in place.
        file: Its name, for messages.
        unread: Collects what is passed over.
    """

    root: XmlElement
    file: str
    unread: Unread

    def place(self, raw: XmlElement) -> str:
        """``arm.xml:12``: where an element begins."""
        return place(raw, self.file)

    def where(self, raw: XmlElement) -> str:
        """The place and name of an element: the head of a message."""
        name = raw.get("name")
        named = f" '{name[:80]}'" if name else ""
        return f"{self.place(raw)}: <{raw.tag}>{named}"

    @contextmanager
    def at_element(self, raw: XmlElement) -> Iterator[None]:
        """Errors that do not say where they are say that they are here."""
        try:
            yield
        except (ModelError, TopologyError) as problem:
            if PLACE.match(str(problem)):
                raise
            raise type(problem)(f"{self.place(raw)}: {problem}") from problem

    def section(self, name: str) -> Element:
        """All elements of the root of a name as one: their attributes, later ones count."""
        raws = self.root.findall(name)
        attributes = {k: text for raw in raws for k, text in raw.attrib.items()}
        joined = element_at(raws[-1] if raws else self.root, name, attributes)
        joined.extend(child for raw in raws for child in raw)
        return Element(joined, self.where(joined))

    def bodies(self, compiler: Compiler) -> Iterator[BodyElement]:
        """The world and all bodies, every parent before its children.

        Raises:
            ModelError: too many, or elements that make bodies by rules of their own.
        """
        taken, count = {"ground"}, 0
        # a body, the number of its parent, its pose there, the class around it
        waiting: list[tuple[XmlElement, int, Pose, str]] = [
            (self.section("worldbody").raw, -1, HERE, TOP)
        ]
        while waiting:
            raw, parent, pose, style = waiting.pop()
            parts, children = [], []
            for child, around, style_here in self._inside(
                raw, raw.get("childclass") or style, compiler
            ):
                if child.tag == "body":
                    self.unread.attributes(child)
                    place = around.then(compiler.pose(Element(child, self.where(child))))
                    children.append((child, count, place, style_here))
                else:
                    parts.append((child, around, style_here))
            name = "" if parent < 0 else self._name(raw, count, taken)
            yield BodyElement(raw, name, parent, pose, tuple(parts))
            count += 1
            if count > MOST_BODIES:
                raise ModelError(f"file '{self.file}' has more than {MOST_BODIES} bodies")
            waiting += reversed(children)

    def _name(self, raw: XmlElement, count: int, taken: set[str]) -> str:
        """The name of a body, its own or a made one.

        Raises:
            ModelError: another body has it.
        """
        name = raw.get("name") or f"body{count}"
        if raw.get("name") and name in taken and name != "ground":
            raise ModelError(f"{self.where(raw)}: another body has this name; rename one of them")
        while name in taken:
            name += "_"
        taken.add(name)
        return str(name)

    def _inside(
        self, raw: XmlElement, style: str, compiler: Compiler
    ) -> Iterator[tuple[XmlElement, Pose, str]]:
        """Contents of a body, with the poses of the frames around it."""
        waiting = [(child, HERE, style) for child in reversed(raw)]
        while waiting:
            child, around, style_here = waiting.pop()
            if child.tag in REFUSED:
                raise ModelError(
                    f"{self.where(child)} is not read, and without it bodies would be missing; "
                    "write its bodies out (MuJoCo saves models so)"
                )
            if child.tag != "frame":
                yield child, around, style_here
                continue
            self.unread.attributes(child)
            pose = around.then(compiler.pose(Element(child, self.where(child))))
            inner = child.get("childclass") or style_here
            waiting += [(grandchild, pose, inner) for grandchild in reversed(child)]


def expanded(root: XmlElement, options: Options, file: str, folder: Path | None) -> XmlElement:
    """The root with the content of included files in the place of every <include>.

    Raises:
        ModelError: a file that is missing, outside the declared folders, included twice, or one
            too many.
    """
    meshes, included_files = Meshes(options.packages, folder), {file}
    waiting = [root]
    while waiting:
        raw = waiting.pop()
        for number in range(len(raw) - 1, -1, -1):
            if raw[number].tag == "include":
                inner = _included(raw[number], options, meshes, file, included_files)
                raw[number : number + 1] = list(inner)
        waiting += list(raw)
    return root


def _included(
    raw: XmlElement, options: Options, meshes: Meshes, file: str, included_files: set[str]
) -> XmlElement:
    """The root of an included file; its own includes stand in it."""
    where = f"{place(raw, file)}: <include>"
    name = Element(raw, where).text("file")
    path = meshes.locate(name, where, "file")
    if path is None:
        raise ModelError(
            f"{where}: there is no file '{name[:80]}' below the folder of the model; packages= "
            "names other folders"
        )
    if str(path) in included_files or path.name == file:
        raise ModelError(f"{where}: file '{path.name}' is included twice; MuJoCo takes it once")
    included_files.add(str(path))
    options.budget.take()
    inner = parse(content(path), path.name)
    for element in inner.iter():
        assert isinstance(element, Numbered)
        element.file = path.name
    return inner
