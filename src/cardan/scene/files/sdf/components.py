"""Links that hang together, and the one of each group that carries the others."""

from __future__ import annotations

from collections.abc import Sequence

from .frames import Node, link_of

Pair = tuple[Node | None, Node | None]


def roots(nodes: Sequence[Node], links: Sequence[Node], pairs: Sequence[Pair]) -> list[Node]:
    """The links to join to the ground: one of each group that no joint of the file holds.

    It is the only link that is nobody's child; where several are, or none, the canonical link of
    the model, or the first link of the group. All links of static models are joined.

    Args:
        nodes: All of the file.
        links: The links among them.
        pairs: The links that the joints join, parent first; None is the ground.
    """
    children = {child for _, child in pairs}
    canonical = {link_of(node) for node in nodes if node.kind == "model" and _has_links(node)}
    selected: set[Node] = set()
    for group in _groups(links, pairs):
        tops = [link for link in group if link not in children]
        named = [link for link in group if link in canonical]
        selected.add(tops[0] if len(tops) == 1 else (named or group)[0])
    # in the order of the file
    return [link for link in links if link.fixed or link in selected]


def _has_links(node: Node) -> bool:
    return any(inner.kind == "link" for inner in node.walk())


def _groups(links: Sequence[Node], pairs: Sequence[Pair]) -> list[list[Node]]:
    """Groups of links that joints join to each other, and not to the ground."""
    neighbors: dict[Node, list[Node]] = {link: [] for link in links}
    on_ground = {link for link in links if link.fixed}
    for one, other in pairs:
        if one is None or other is None:
            on_ground.update(link for link in (one, other) if link is not None)
        else:
            neighbors[one].append(other)
            neighbors[other].append(one)
    position = {link: k for k, link in enumerate(links)}
    groups = []
    visited: set[Node] = set()
    for start in links:
        if start in visited:
            continue
        group, waiting = [], [start]
        visited.add(start)
        while waiting:
            link = waiting.pop()
            group.append(link)
            for other in neighbors[link]:
                if other not in visited:
                    visited.add(other)
                    waiting.append(other)
        if not on_ground.intersection(group):
            groups.append(sorted(group, key=position.__getitem__))
    return groups
