"""Drawings of the graph of a scene: text, Graphviz, SVG. Names are escaped for each."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from ..ir.printing import quoted
from ..model.connections import Joint
from .tree import Branch

ROW, COLUMN = 58, 158
BOX = (144, 36)


# a piece of a beam: its name and the bodies it joins
Piece = tuple[str, str, str]


def text(branches: Sequence[Branch], closing: Sequence[Joint], beams: Sequence[Piece] = ()) -> str:
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
        lines.append(f"closes a circuit: {ends}  [{joint.name}: {joint.kind.kind}]")
    lines += [f"beam: {start} == {end}  [{name}]" for name, start, end in beams]
    return "\n".join(lines)


def dot(
    name: str,
    bodies: Sequence[str],
    branches: Sequence[Branch],
    closing: Sequence[Joint],
    beams: Sequence[Piece] = (),
) -> str:
    """A directed graph; circuits are closed by dashed arcs, beams are thick ones."""
    lines = [f"digraph {quoted(name)} {{", "  rankdir=BT;", "  node [shape=box];"]
    lines += [f"  {quoted(body)};" for body in bodies]
    for joint, style in (
        *((branch.joint, "") for branch in branches),
        *((joint, ", style=dashed") for joint in closing),
    ):
        ends = f"{quoted(joint.parent.body.name)} -> {quoted(joint.child.body.name)}"
        # \n is the line break of Graphviz
        label = quoted(joint.name)[:-1] + "\\n" + joint.kind.kind + '"'
        lines.append(f"  {ends} [label={label}{style}];")
    for beam, start, end in beams:
        ends = f"{quoted(start)} -> {quoted(end)}"
        lines.append(f"  {ends} [label={quoted(beam)}, style=bold, penwidth=4, dir=none];")
    return "\n".join([*lines, "}"])


def svg(
    bodies: Sequence[str],
    branches: Sequence[Branch],
    closing: Sequence[Joint],
    beams: Sequence[Piece] = (),
) -> str:
    """Layers of boxes, the ground at the bottom."""
    where = _layout(branches)
    deepest = max(level for _, level in where.values())
    width = COLUMN * (1 + max(column for column, _ in where.values())) + 20
    height = ROW * (deepest + 1) + 20

    def center(body: str) -> tuple[float, float]:
        column, level = where[body]
        return COLUMN * (column + 0.5) + 10, height - ROW * (level + 0.5) - 10

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" '
        f'width="{width:g}" height="{height:g}" font-family="sans-serif" font-size="11" '
        'fill="currentColor">'
    ]
    arcs = [(branch.joint, "") for branch in branches]
    arcs += [(joint, ' stroke-dasharray="5 4"') for joint in closing]
    for joint, style in arcs:
        (x0, y0), (x1, y1) = center(joint.parent.body.name), center(joint.child.body.name)
        (xa, ya), (xb, yb) = _edge((x0, y0), (x1, y1)), _edge((x1, y1), (x0, y0))
        parts.append(f'<path d="M{xa:g} {ya:g}L{xb:g} {yb:g}" stroke="#789"{style}/>')
        if style:
            parts.append(_joint_label(joint, (x0 + x1) / 2, (y0 + y1) / 2))
    for beam, start, end in beams:
        if start not in where or end not in where:
            continue
        (x0, y0), (x1, y1) = center(start), center(end)
        line = 'stroke="#8ab" stroke-width="6" stroke-linecap="round"'
        parts.append(f'<path d="M{x0:g} {y0:g}L{x1:g} {y1:g}" {line}/>')
        parts.append(_label(beam, "beam", (x0 + x1) / 2, (y0 + y1) / 2))
    # every body but the ground stands on one joint of the tree: it is named in the same box
    inboard = {branch.outer.name: branch.joint for branch in branches}
    for body in bodies:
        if body in where:
            parts.append(_box(body, inboard.get(body), *center(body)))
    return "\n".join([*parts, "</svg>"])


def _edge(box: tuple[float, float], goal: tuple[float, float]) -> tuple[float, float]:
    """Where the line from the middle of a box to a place leaves the box."""
    x, y = goal[0] - box[0], goal[1] - box[1]
    share = 1 / max(1.0, 2 * abs(x) / BOX[0], 2 * abs(y) / BOX[1])
    return round(box[0] + share * x, 1), round(box[1] + share * y, 1)


def _short(name: str) -> str:
    return name if len(name) <= 18 else name[:17] + "…"


def _joint_label(joint: Joint, x: float, y: float) -> str:
    return _label(joint.name, joint.kind.kind, x, y)


def _label(name: str, kind: str, x: float, y: float) -> str:
    """Name and kind of a joint or beam."""
    full = f"<title>{escape(f'{name}: {kind}')}</title>"
    name = f'{escape(_short(name))}<tspan dx="4" fill="#789">{kind}</tspan>'
    at = f'x="{x:g}" y="{y:g}" text-anchor="middle"'
    return f'<text {at} font-size="9">{name}{full}</text>'


def _box(body: str, joint: Joint | None, x: float, y: float) -> str:
    width, height = BOX
    rise = 4 if joint is None else -2
    made = (
        f'<rect x="{x - width / 2:g}" y="{y - height / 2:g}" width="{width}" height="{height}" '
        f'rx="5" fill="#8ab" fill-opacity="0.2" stroke="#789"/><text x="{x:g}" y="{y + rise:g}" '
        f'text-anchor="middle">{escape(_short(body))}<title>{escape(body)}</title></text>'
    )
    return made if joint is None else made + _joint_label(joint, x, y + 12)


def _layout(branches: Sequence[Branch]) -> dict[str, tuple[float, int]]:
    """Column and level of every body: leaves side by side, inner bodies over their middle."""
    level = {"ground": 0}
    outboard: dict[str, list[str]] = {"ground": []}
    for branch in branches:
        level[branch.outer.name] = level[branch.inner.name] + 1
        outboard[branch.inner.name].append(branch.outer.name)
        outboard[branch.outer.name] = []
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
    return {body: (column[body], level[body]) for body in level}
