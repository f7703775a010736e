"""The graph of a system as a figure."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..topology.drawing import drawing
from ..topology.drawing.drawing import Arc
from ..topology.system import Part, System
from . import content as d
from .writers.latex import escaped


def figure(system: System) -> d.Figure:
    """Bodies and joints, as the user named them."""
    arcs = list(_arcs(system))
    names = (name for arc in arcs for name in (arc.inner, arc.outer))
    return drawn(list(dict.fromkeys(("ground", *names))), arcs)


def drawn(bodies: Sequence[str], arcs: Sequence[Arc]) -> d.Figure:
    """Boxes and lines, the ground first."""
    svg, tikz = drawing.svg(bodies, arcs), drawing.tikz(bodies, arcs, escaped)
    return d.Figure(svg, tikz, caption(arcs))


def caption(arcs: Sequence[Arc]) -> str:
    """Legend of the lines in the figure."""
    styles = {arc.style for arc in arcs}
    said = "Bodies on their joints, the ground at the bottom"
    said += "; dashed: joints that close loops" * ("closing" in styles)
    said += "; thick: beams with their nodes" * ("beam" in styles)
    return said + "; thick: what is inside of a flexible body" * ("elastic" in styles) + "."


def _arcs(system: System) -> Iterator[Arc]:
    yield from _fixed(system.ground_parts)
    carriers = {cut.carrier for cut in system.cuts}
    for i, (body, joint) in enumerate(zip(system.bodies, system.joints, strict=True)):
        if not joint.implicit and i not in carriers:
            inner = _part(system, joint.parent_frame)
            yield drawing.branch_arc(joint.name, joint.element, inner, body.name)
        yield from _fixed(body.parts)
    for cut in system.closing:
        kind, start = cut.element.kind, cut.parent_frame
        if cut.carrier is not None:
            carrier = system.joints[cut.carrier]
            kind, start = carrier.element.kind, carrier.parent_frame
        ends = _part(system, start), _part(system, cut.child_frame)
        yield Arc(cut.name, kind, *ends, "closing")
    for segment in system.segments:
        ends = _part(system, segment.frame_a), _part(system, segment.frame_b)
        yield drawing.beam_arc(drawing.BeamArc("beam", segment.name, *ends, segment.line.elements))


def _fixed(parts: tuple[Part, ...]) -> Iterator[Arc]:
    """Parts of one body that fixed joints hold together."""
    for part in parts:
        if part.inboard >= 0:
            yield Arc(part.joint, "fixed", parts[part.inboard].name, part.name)


def _part(system: System, frame: int) -> str:
    """The user's body to which a frame belongs."""
    row = system.frames[frame]
    if row.body < 0:
        return system.ground_parts[row.part].name if system.ground_parts else "ground"
    parts = system.bodies[row.body].parts
    return parts[row.part].name if parts else system.bodies[row.body].name
