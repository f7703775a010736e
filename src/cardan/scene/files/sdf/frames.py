"""Models, links, joints and frames of an SDF and where they are.

Source: SDFormat, "Pose frame semantics": every pose is relative to one named frame of its model.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator
from dataclasses import field
from typing import TYPE_CHECKING

from ....errors import ModelError, near
from ....records import dataclass
from ..document import place
from ..pose import HERE, Pose
from .values import Item

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

MOST_ITEMS = 100_000
KINDS = ("link", "joint", "frame", "model")
WORLD = "world"
# names that the format keeps for itself
RESERVED = ("world", "__model__", "__root__")


@dataclass(eq=False)
class Node:
    """A link, joint, frame or model.

    Attributes:
        kind: Of ``KINDS``, or ``world``.
        name: With the names of the models around it, joined by dots.
        item: The element.
        model: The model (or world) around it, None for the outermost.
        members: What is in a model, by its name there.
        fixed: A model that does not move, or is in one.
    """

    kind: str
    name: str
    item: Item
    model: Node | None
    members: dict[str, Node] = field(default_factory=dict)
    fixed: bool = False

    @property
    def prefix(self) -> str:
        """The beginning of the names of members."""
        return f"{self.name}." if self.name else ""

    def find(self, name: str, role: str, where: str) -> Node:
        """A member by its name, those of inner models as ``inner::name``.

        Raises:
            ModelError: there is none.
        """
        if name == "__model__" and self.kind == "model":
            return self
        at = self
        for part in name.split("::"):
            if part not in at.members:
                listed = near(part, at.members).replace(" Known:", " Names here:")
                raise ModelError(f"{where}: {role} '{name[:80]}' does not exist.{listed}")
            at = at.members[part]
        return at

    def walk(self) -> Iterator[Node]:
        """All that is in a model and in its inner models, in the order of the file."""
        for node in self.members.values():
            yield node
            if node.kind == "model":
                yield from node.walk()


def tree(root: XmlElement, file: str, passed: Callable[[XmlElement, str], None]) -> Node:
    """The outermost model of a file, or its world.

    Args:
        passed: Receives elements that are passed over, and what they stand in.

    Raises:
        ModelError: no model or several worlds, includes, names that are missing, taken or reserved.
    """
    worlds, models = root.findall("world"), root.findall("model")
    for raw in root:
        if raw.tag not in ("world", "model"):
            passed(raw, "")
    _no_includes(root, file)
    if len(worlds) + len(models) != 1:
        counts = f"{len(worlds)} worlds and {len(models)} models"
        raise ModelError(
            f"file '{file}': it has {counts} at its root, but one model or one world is read"
        )
    outermost = (worlds or models)[0]
    inside = outermost.findall("model")
    if worlds and not inside:
        raise ModelError(f"file '{file}': its world has no model, so no body")
    if worlds:
        top = Node(WORLD, "", Item(outermost, place(outermost, file)), None)
    else:
        top = Node("model", "", Item(outermost, _where("model", outermost, file)), None)
        top.fixed = top.item.flag("static")
    alone = bool(worlds) and len(inside) == 1
    _fill(top, file, passed, alone)
    return top


def _no_includes(root: XmlElement, file: str) -> None:
    """No element of a file includes another file.

    Raises:
        ModelError: one does.
    """
    include = next(root.iter("include"), None)
    if include is not None:
        uri = (include.findtext("uri") or "").strip()
        raise ModelError(
            f"{place(include, file)}: <include> of '{uri[:80]}' is not read; put its <model> here"
        )


def _where(kind: str, raw: XmlElement, file: str) -> str:
    return f"{place(raw, file)}: {kind} '{(raw.get('name') or '')[:80]}'"


def _fill(top: Node, file: str, passed: Callable[[XmlElement, str], None], alone: bool) -> None:
    """Collect the members of a model and of those inside it.

    Args:
        alone: The model inside the world is the only one: its names need no prefix.
    """
    waiting, count = [top], 0
    while waiting:
        model = waiting.pop()
        kinds = KINDS if model.kind == "model" else ("model", "frame", "joint")
        for raw in model.item.raw:
            if raw.tag not in kinds:
                passed(raw, model.kind)
                continue
            where = _where(raw.tag, raw, file)
            name = raw.get("name")
            if not name or not name.strip():
                raise ModelError(f"{place(raw, file)}: <{raw.tag}> lacks the attribute 'name'")
            if name in RESERVED or "::" in name:
                raise ModelError(f"{where}: the name is reserved; rename it")
            key = name
            if key in model.members and model.members[key].kind != raw.tag:
                # of different kinds: older versions allow it
                key = f"{name}_{raw.tag}"
            if key in model.members:
                other = model.members[key].kind
                raise ModelError(f"{where}: the name is taken by a {other}; rename one of them")
            count += 1
            if count > MOST_ITEMS:
                raise ModelError(f"file '{file}' has more than {MOST_ITEMS} links, joints, frames")
            full_name = "" if alone and model is top and raw.tag == "model" else model.prefix + name
            node = Node(raw.tag, full_name, Item(raw, where), model)
            node.fixed = model.fixed or (raw.tag == "model" and node.item.flag("static"))
            model.members[key] = node
            if raw.tag == "model":
                waiting.append(node)


class Poses:
    """Poses of nodes in ground axes, each computed once.

    Args:
        read: The pose of an element, seen from the frame that it is relative to.
    """

    def __init__(self, read: Callable[[Item], Pose]) -> None:
        self.read = read
        self.computed: dict[Node, Pose] = {}

    def of(self, node: Node) -> Pose:
        """Pose of a node in ground axes.

        Raises:
            ModelError: poses that are relative to each other.
        """
        chain = self._chain(node, self.computed)
        for at in reversed(chain):
            base = base_of(at)
            outer = HERE if base is None else self.computed[base]
            self.computed[at] = outer.then(self._raw(at))
        return self.computed[node]

    def _chain(self, node: Node, ends: Container[Node]) -> list[Node]:
        """Nodes from this one to the first of some others, or to the outermost."""
        chain: list[Node] = []
        visited: set[Node] = set()
        at: Node | None = node
        while at is not None and at not in ends:
            if at in visited:
                raise ModelError(f"{node.item.where}: its pose is relative to itself")
            visited.add(at)
            chain.append(at)
            at = base_of(at)
        return chain

    def _raw(self, node: Node) -> Pose:
        """Pose of a node seen from its base; the pose of a model may be that of a frame of it."""
        if node.kind == WORLD:
            return HERE
        pose = self.read(node.item)
        name = node.item.raw.get("placement_frame") if node.kind == "model" else None
        if not name:
            return pose
        frame = node.find(name, "placement_frame", node.item.where)
        inside = HERE
        for at in self._chain(frame, {node}):
            if at is node.model:
                raise ModelError(f"{node.item.where}: its placement_frame is outside of it")
            inside = self.read(at.item).then(inside)
        return pose.then(inside.inverse())


def base_of(node: Node) -> Node | None:
    """The frame that the pose of a node is relative to, None for the ground.

    Raises:
        ModelError: it does not exist.
    """
    model = node.model
    if model is None:
        return None
    pose = node.item.raw.find("pose")
    name = None if pose is None else (pose.get("relative_to") or pose.get("frame"))
    if name == WORLD and model.kind == WORLD:
        return model
    if name:
        return model.find(name, "relative_to", node.item.where)
    if node.kind == "frame" and node.item.raw.get("attached_to"):
        return model.find(node.item.raw.get("attached_to", ""), "attached_to", node.item.where)
    if node.kind == "joint":
        child = node.item.text("child")
        return model if child == WORLD else model.find(child, "child", node.item.where)
    return model


def link_of(node: Node) -> Node | None:
    """The link that a node is fixed to, None for the ground.

    Raises:
        ModelError: it has none, or frames are attached to each other.
    """
    at, visited = node, {node}
    while at.kind != "link":
        if at.kind == WORLD:
            return None
        if at.kind == "joint":
            name: str = at.item.text("child")
        elif at.kind == "frame":
            name = at.item.raw.get("attached_to") or "__model__"
        else:
            name = at.item.raw.get("canonical_link") or next(
                (key for key, one in at.members.items() if one.kind in ("link", "model")), ""
            )
        model = at if at.kind == "model" else at.model
        assert model is not None
        if name == WORLD or (name == "__model__" and model.kind == WORLD):
            return None
        if not name:
            raise ModelError(f"{at.item.where}: it has no link")
        at = model.find(name, "link", at.item.where)
        if at in visited:
            raise ModelError(f"{node.item.where}: it is attached to itself")
        visited.add(at)
    return at
