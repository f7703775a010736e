"""The tree of links and joints of a URDF."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from ....errors import ModelError, TopologyError, near
from ....records import dataclass
from ..document import Element

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

MOST_LINKS = 100_000


@dataclass(frozen=True)
class Edge:
    """A joint element of the file with the links it joins."""

    name: str
    element: Element
    parent: str
    child: str


def links_of(root: XmlElement, file: str) -> dict[str, Element]:
    """The links by name.

    Raises:
        ModelError: none, too many, or a name twice.
    """
    links: dict[str, Element] = {}
    for raw in root.findall("link"):
        name = Element(raw, f"file '{file}'").text("name")
        if name in links:
            raise ModelError(f"link '{name}' is defined twice; rename one of them")
        links[name] = Element(raw, f"link '{name}'")
    if not links:
        xacro = any(isinstance(child.tag, str) and "xacro" in child.tag for child in root)
        hint = "; run xacro on it first" if xacro else ""
        raise ModelError(f"file '{file}': the robot has no links{hint}")
    if len(links) > MOST_LINKS:
        raise ModelError(f"file '{file}' has {len(links)} links, at most {MOST_LINKS}")
    return links


def edges_of(root: XmlElement, file: str) -> list[Edge]:
    """The joints of the tree.

    Raises:
        ModelError: a name twice, or an end that is missing.
    """
    edges: dict[str, Edge] = {}
    for raw in root.findall("joint"):
        name = Element(raw, f"file '{file}'").text("name")
        if name in edges:
            raise ModelError(f"joint '{name}' is defined twice; rename one of them")
        element = Element(raw, f"joint '{name}'")
        ends = []
        for role in ("parent", "child"):
            end = element.child(role)
            if end is None:
                raise ModelError(f"joint '{name}': <{role} link=.../> is missing")
            ends.append(end.text("link"))
        edges[name] = Edge(name, element, ends[0], ends[1])
    return list(edges.values())


def check_link(who: str, role: str, link: str, links: Iterable[str]) -> None:
    """A joint joins links that exist.

    Raises:
        ModelError: this one does not.
    """
    if link not in links:
        listed = near(link, links).replace(" Known:", " Links:")
        raise ModelError(f"{who}: {role} '{link}' is not a link.{listed}")


def _swapped(edges: list[Edge], *two: Edge) -> str:
    """Which of two joints with one child may have its links exchanged."""
    children = {edge.child for edge in edges}
    roots = {edge.parent for edge in edges} - children
    # a root of its own behind one of them
    names = [edge.name for edge in two if edge.parent in roots and edge.parent != edges[0].parent]
    return f" (are <parent> and <child> of '{names[0]}' exchanged?)" if names else ""


def base_of(links: dict[str, Element], edges: list[Edge], file: str) -> str:
    """The root link: the only one that is the child of no joint.

    Raises:
        ModelError: a joint of a link that does not exist.
        TopologyError: a link with two parents, no root or several.
    """
    inboard: dict[str, Edge] = {}
    for edge in edges:
        for role, link in (("parent", edge.parent), ("child", edge.child)):
            check_link(f"joint '{edge.name}'", role, link, links)
        if edge.child in inboard:
            raise TopologyError(
                f"link '{edge.child}' is the child of two joints, '{inboard[edge.child].name}' and "
                f"'{edge.name}'{_swapped(edges, inboard[edge.child], edge)}; write the one that "
                "closes a loop as <loop_joint> with <link1 link=.../> and <link2 link=.../>, or as "
                "<constraint>"
            )
        inboard[edge.child] = edge
    roots = [name for name in links if name not in inboard]
    if not roots:
        raise TopologyError(
            f"file '{file}': every link is the child of a joint, so the links form a loop and none "
            "is the root. Write the joint that closes the loop as <loop_joint> with "
            "<link1 link=.../> and <link2 link=.../>, or as <constraint>"
        )
    if len(roots) > 1:
        listed = ", ".join(f"'{r}'" for r in roots[:8])
        raise TopologyError(
            f"file '{file}' has {len(roots)} root links, which no joint has as its <child>: "
            f"{listed}. A robot has one root: add joints to the others, or correct the names in "
            "<parent> and <child>"
        )
    _check_connected(roots[0], edges, file)
    return roots[0]


def _check_connected(base: str, edges: list[Edge], file: str) -> None:
    """All links hang on the root.

    Raises:
        TopologyError: some links form a loop of their own.
    """
    outboard: dict[str, list[str]] = {}
    for edge in edges:
        outboard.setdefault(edge.parent, []).append(edge.child)
    visited, stack = {base}, [base]
    while stack:
        for child in outboard.get(stack.pop(), ()):
            visited.add(child)
            stack.append(child)
    loop = [f"'{edge.child}'" for edge in edges if edge.child not in visited]
    if loop:
        raise TopologyError(
            f"file '{file}': no chain of joints leads from the root link '{base}' to the links "
            f"{', '.join(loop[:8])}: their joints form a loop. Change the <parent> of one of these "
            "joints, or write it as <loop_joint> or <constraint> and join a link to the root"
        )
