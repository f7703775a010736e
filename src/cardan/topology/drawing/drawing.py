"""Drawings of the graph of a scene: text, Graphviz, SVG, TikZ. Names are escaped for each."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from html import escape
from typing import NamedTuple

from ...elements.joints.joint import Joint as JointElement
from ...elements.superelement_joints import Elastic
from ...errors import counted
from ...ir.printing import quoted
from ...records import dataclass
from ...scene.connections import Joint
from ..tree import Branch

ROW, COLUMN = 58, 158
BOX = (144, 36)
# controls of arcs that bend around boxes
ASIDE, ABOVE = 190.0, 56.0
Point = tuple[float, float]


class BeamArc(NamedTuple):
    """A cable, or a piece of a beam between named nodes.

    Attributes:
        kind: "beam" or "cable".
        name: Of the beam or cable.
        start, end: Names of the bodies that it joins.
        elements: Number of its finite elements.
    """

    kind: str
    name: str
    start: str
    end: str
    elements: int


# nodes of a piece of a beam that are drawn one by one
MAX_NODES = 12


def text(
    branches: Sequence[Branch], closing: Sequence[Joint], beams: Sequence[BeamArc] = ()
) -> str:
    """The tree with one line per body."""
    outboard: dict[str, list[Branch]] = {}
    for branch in branches:
        outboard.setdefault(branch.inner.name, []).append(branch)
    lines = ["ground"]
    stack = [("", branch, k == 0) for k, branch in enumerate(reversed(outboard.get("ground", [])))]
    while stack:
        indent, branch, last = stack.pop()
        mark = "└─ " if last else "├─ "
        joint = branch.joint
        lines.append(f"{indent}{mark}{branch.outer.name}  [{joint.name}: {joint.kind.kind}]")
        deeper = indent + ("   " if last else "│  ")
        below = list(reversed(outboard.get(branch.outer.name, [])))
        stack += [(deeper, child, k == 0) for k, child in enumerate(below)]
    for joint in closing:
        ends = f"{joint.parent.body.name} .. {joint.child.body.name}"
        lines.append(f"closes a loop: {ends}  [{joint.name}: {joint.kind.kind}]")
    for beam in beams:
        elements = counted(beam.elements, "element")
        lines.append(f"{beam.kind}: {beam.start} == {beam.end}  [{beam.name}: {elements}]")
    return "\n".join(lines)


def dot(
    name: str,
    bodies: Sequence[str],
    branches: Sequence[Branch],
    closing: Sequence[Joint],
    beams: Sequence[BeamArc] = (),
) -> str:
    """A directed graph; loops are closed by dashed arcs, what bends is thick."""
    lines = [f"digraph {quoted(name)} {{", "  rankdir=BT;", "  node [shape=box];"]
    lines += [f"  {quoted(body)};" for body in bodies]
    thick = ", style=bold, penwidth=4"
    for joint, style in (
        *((one.joint, thick * isinstance(one.joint.kind, Elastic)) for one in branches),
        *((joint, ", style=dashed") for joint in closing),
    ):
        ends = f"{quoted(joint.parent.body.name)} -> {quoted(joint.child.body.name)}"
        # \n is the line break of Graphviz
        label = quoted(joint.name)[:-1] + "\\n" + joint.kind.kind + '"'
        lines.append(f"  {ends} [label={label}{style}];")
    for beam in beams:
        ends = f"{quoted(beam.start)} -> {quoted(beam.end)}"
        label = quoted(beam.name)[:-1] + f"\\n{counted(beam.elements, 'element')}" + '"'
        lines.append(f"  {ends} [label={label}{thick}, dir=none];")
    return "\n".join([*lines, "}"])


@dataclass(frozen=True)
class Arc:
    """A joint or a piece of a beam in a drawing.

    Attributes:
        name, kind: What it is.
        inner, outer: Names of the bodies it joins; of a branch of the tree ``inner`` is nearer to
            the ground.
        style: ``"tree"``, ``"elastic"`` (in the tree, too), ``"closing"`` or ``"beam"``.
        elements: Number of finite elements of a piece of a beam.
    """

    name: str
    kind: str
    inner: str
    outer: str
    style: str = "tree"
    elements: int = 0

    @property
    def is_branch(self) -> bool:
        """True for arcs of the spanning tree."""
        return self.style in BRANCHES


BRANCHES = ("tree", "elastic")


def arcs(
    branches: Sequence[Branch], closing: Sequence[Joint], beams: Sequence[BeamArc] = ()
) -> list[Arc]:
    """The graph of a model as arcs."""
    arcs_listed = [
        branch_arc(b.joint.name, b.joint.kind, b.inner.name, b.outer.name) for b in branches
    ]
    arcs_listed += [
        Arc(j.name, j.kind.kind, j.parent.body.name, j.child.body.name, "closing") for j in closing
    ]
    return arcs_listed + [beam_arc(beam) for beam in beams]


def branch_arc(name: str, joint: JointElement, inner: str, outer: str) -> Arc:
    """The arc of a joint in the tree; those inside of a flexible body are thick."""
    style = "elastic" if isinstance(joint, Elastic) else "tree"
    return Arc(name, joint.kind, inner, outer, style)


def beam_arc(beam: BeamArc) -> Arc:
    """The arc of a cable, or of a piece of a beam."""
    kind = f"{beam.kind}, {counted(beam.elements, 'element')}"
    return Arc(beam.name, kind, beam.start, beam.end, "beam", beam.elements)


def svg(bodies: Sequence[str], arcs: Sequence[Arc]) -> str:
    """Layers of boxes, the ground at the bottom."""
    place = _Places(arcs)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {place.width:g} {place.height:g}" '
        f'width="{place.width:g}" height="{place.height:g}" font-family="sans-serif" '
        'font-size="11">'
    ]
    labels = []
    for arc in place.drawn(arcs):
        points = place.path(arc)
        bend, fill = ("C", ' fill="none"') if len(points) == 4 else ("L", "")
        line = " ".join(f"{x:g} {y:g}" for x, y in points[1:])
        start = f"M{points[0][0]:g} {points[0][1]:g}"
        parts.append(f'<path d="{start}{bend}{line}"{fill} {_LINES[arc.style]}/>')
        for x, y in _nodes(arc, points):
            parts.append(f'<circle cx="{x:g}" cy="{y:g}" r="4" fill="#fff" stroke="#456"/>')
        if not arc.is_branch:
            x, y = _middle(points)
            halo = ' stroke="#fff" stroke-width="3" paint-order="stroke"'
            # beside the nodes of a beam
            labels.append(_label(arc, x, y - 8 if arc.elements > 1 else y + 3, halo))
    # every body but the ground stands on one joint of the tree: it is named in the same box
    inboard = {arc.outer: arc for arc in arcs if arc.is_branch}
    for body in bodies:
        if body in place:
            parts.append(_box(body, inboard.get(body), *place.center(body)))
    return "\n".join([*parts, *labels, "</svg>"])


_LINES = {
    "tree": 'stroke="#456"',
    "elastic": 'stroke="#8ab" stroke-width="6" stroke-linecap="round"',
    "closing": 'stroke="#456" stroke-dasharray="5 4"',
    "beam": 'stroke="#8ab" stroke-width="6" stroke-linecap="round"',
}


def tikz(bodies: Sequence[str], arcs: Sequence[Arc], escaped: Callable[[str], str]) -> str:
    """The same for TeX, as wide as a page at most.

    Args:
        bodies: Names of the bodies, ground first.
        arcs: What joins them.
        escaped: What names go through.
    """
    place = _Places(arcs)
    size = min(1.0, WIDEST / place.width, TALLEST / place.height)
    unit = f"x={0.028 * size:.5f}cm,y={0.028 * size:.5f}cm"
    lines = [
        rf"\begin{{tikzpicture}}[{unit},body/.style={{draw,rounded corners=2pt,fill=white,"
        rf"align=center,scale={max(size, 0.2):.3f},inner sep=3pt,font=\small}}]"
    ]

    def at(x: float, y: float) -> str:
        return f"({x:g},{place.height - y:g})"

    def named(arc: Arc) -> str:
        return rf"{{\scriptsize {escaped(_short(arc.name))} \itshape {escaped(arc.kind)}}}"

    labels = []
    for arc in place.drawn(arcs):
        points = place.path(arc)
        ends = [at(x, y) for x, y in points]
        inner = f" .. controls {ends[1]} and {ends[2]} .. " if len(points) == 4 else " -- "
        lines.append(rf"\draw[{_STROKES[arc.style]}] {ends[0]}{inner}{ends[-1]};")
        for point in _nodes(arc, points):
            lines.append(rf"\node[draw,circle,fill=white,inner sep=1pt] at {at(*point)} {{}};")
        if not arc.is_branch:
            label = rf"\node[fill=white,inner sep=1pt] at {at(*_middle(points))} {{{named(arc)}}};"
            labels.append(label)
    inboard = {arc.outer: arc for arc in arcs if arc.is_branch}
    for body in bodies:
        if body in place:
            below = rf"\\{named(inboard[body])}" if body in inboard else ""
            content = f"{escaped(_short(body))}{below}"
            lines.append(rf"\node[body] at {at(*place.center(body))} {{{content}}};")
    return "\n".join([*lines, *labels, r"\end{tikzpicture}"])


_STROKES = {
    "tree": "",
    "elastic": "line width=3pt,gray",
    "closing": "dashed",
    "beam": "line width=3pt,gray",
}
# of a drawing in its own units that need not shrink to fit a page
WIDEST, TALLEST = 550.0, 750.0


def _short(name: str) -> str:
    return name if len(name) <= 18 else name[:17] + "…"


def _label(arc: Arc, x: float, y: float, halo: str = "") -> str:
    """Name and kind of a joint or beam."""
    full = f"<title>{escape(f'{arc.name}: {arc.kind}')}</title>"
    name = f'{escape(_short(arc.name))}<tspan dx="4" fill="#789">{escape(arc.kind)}</tspan>'
    at = f'x="{x:g}" y="{y:g}" text-anchor="middle"'
    return f'<text {at} font-size="9" fill="#345"{halo}>{name}{full}</text>'


def _box(body: str, joint: Arc | None, x: float, y: float) -> str:
    width, height = BOX
    rise = 4 if joint is None else -2
    box = (
        f'<rect x="{x - width / 2:g}" y="{y - height / 2:g}" width="{width}" height="{height}" '
        f'rx="5" fill="#eef3f8" stroke="#456"/><text x="{x:g}" y="{y + rise:g}" '
        f'text-anchor="middle">{escape(_short(body))}<title>{escape(body)}</title></text>'
    )
    return box if joint is None else box + _label(joint, x, y + 12)


def _spanning(arcs: Sequence[Arc]) -> list[tuple[str, str]]:
    """(inner, outer) body by body from the ground: along joints first, then along beams."""
    edges: list[tuple[str, str]] = []
    connected, left = {"ground"}, list(arcs)
    while left:
        on = next(
            (
                (arc, ends)
                for styles in (BRANCHES, ("beam",), ("closing",))
                for arc in left
                if arc.style in styles
                for ends in ((arc.inner, arc.outer), (arc.outer, arc.inner))
                if ends[0] in connected and ends[1] not in connected
            ),
            None,
        )
        if on is None:
            break
        edges.append(on[1])
        connected.add(on[1][1])
        left.remove(on[0])
    return edges


def _middle(points: Sequence[Point]) -> Point:
    """Middle of a line or a cubic curve."""
    return _along(points, 0.5)


def _along(points: Sequence[Point], s: float) -> Point:
    """A point of a line or a cubic curve, at 0 its start and at 1 its end."""
    r = 1 - s
    weights = (r**3, 3 * r * r * s, 3 * r * s * s, s**3) if len(points) == 4 else (r, s)
    pairs = list(zip(weights, points, strict=True))
    return sum(w * x for w, (x, _) in pairs), sum(w * y for w, (_, y) in pairs)


def _nodes(arc: Arc, points: Sequence[Point]) -> list[Point]:
    """The nodes inside a piece of a beam; none where there is no room for them."""
    if arc.elements - 1 > MAX_NODES:
        return []
    return [_along(points, k / arc.elements) for k in range(1, arc.elements)]


class _Places:
    """Column and level of every body: leaves side by side, inner bodies over their middle.

    Args:
        arcs: The graph; bodies that nothing joins to the ground have no place.
    """

    def __init__(self, arcs: Sequence[Arc]) -> None:
        level, outboard = {"ground": 0}, dict[str, list[str]]({"ground": []})
        for inner, outer in _spanning(arcs):
            level[outer] = level[inner] + 1
            outboard[inner].append(outer)
            outboard[outer] = []
        # leaves get their columns in the order of a walk through the tree
        column: dict[str, float] = {}
        stack = ["ground"]
        while stack:
            body = stack.pop()
            if not outboard[body]:
                column[body] = float(len(column))
            stack += reversed(outboard[body])
        for body in reversed(list(level)):
            if outboard[body]:
                columns = [column[child] for child in outboard[body]]
                column[body] = (min(columns) + max(columns)) / 2
        self._where = {body: (column[body], level[body]) for body in level}
        bends = [self._bend(arc) for arc in self.drawn(arcs)]
        right = max((x for x, _ in bends), default=0.0)
        up = max((-y for _, y in bends), default=0.0)
        self.width = COLUMN * (1 + max(column.values())) + 20 + 0.65 * right
        self.height = ROW * (max(level.values()) + 1) + 20 + 0.5 * up

    def __contains__(self, body: object) -> bool:
        return body in self._where

    def center(self, body: str) -> tuple[float, float]:
        """Center of the box, y downwards."""
        column, level = self._where[body]
        return COLUMN * (column + 0.5) + 10, self.height - ROW * (level + 0.5) - 10

    def path(self, arc: Arc) -> list[Point]:
        """From body to body: a line by its ends, or a curve with two controls between them."""
        ends = [self.center(arc.inner), self.center(arc.outer)]
        right, down = self._bend(arc)
        if not right and not down:
            return ends
        return [ends[0], *((x + right, y + down) for x, y in ends), ends[1]]

    def _bend(self, arc: Arc) -> Point:
        """Offset of the controls of an arc that would run behind boxes."""
        (a, low), (b, high) = self._where[arc.inner], self._where[arc.outer]
        if arc.is_branch or (a != b and low != high):
            return 0.0, 0.0
        if a == b:
            return (ASIDE, 0.0) if abs(high - low) > 1 else (0.0, 0.0)
        return 0.0, -ABOVE

    def drawn(self, arcs: Sequence[Arc]) -> list[Arc]:
        """The arcs between bodies that have places."""
        return [arc for arc in arcs if arc.inner in self and arc.outer in self]
