"""A motion: its histories drawn, how it went, and how well energy was kept."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from ..runtime.trajectory.summary import headline, rows
from . import content as d

if TYPE_CHECKING:
    from ..runtime.trajectory.trajectory import TrajectoryRecord

# of tones that can be seen on light and on dark pages
COLORS = ("#2a7fd4", "#e07b20", "#2e9e4f", "#d0453e", "#9467bd", "#a0705f", "#d06bb0", "#8a8f98")
WIDTH, HEIGHT, LEFT, BELOW = 640, 150, 64, 18
# of a line of names, of a letter in it, and letters of a name that are shown
LINE, LETTER, LONGEST = 15, 7, 40
# pairs of points that are drawn of a history
BINS = 320


def document(motion: TrajectoryRecord) -> d.Document:
    """Coordinates over time, a panel for each unit; then the summary."""
    table = d.Table(("", ""), tuple(rows(motion)))
    blocks = (*_panels(motion), d.Folded("how it went", (table,)))
    lead = (d.Paragraph((headline(motion),)),)
    return d.Document(motion.manifest.name, lead, (d.Section("", blocks),))


def _panels(motion: TrajectoryRecord) -> Iterator[d.Block]:
    if len(motion) < 2:
        return
    t, q = motion.t, motion.q
    if motion.dense is not None and len(motion) < BINS:
        t = np.linspace(t[0], t[-1], BINS)
        q = motion.at(t)[:, : motion.nq]
    coordinates = motion.manifest.coordinates
    for unit in dict.fromkeys(row.unit for row in coordinates):
        curves = [(row.name, q[:, k]) for k, row in enumerate(coordinates) if row.unit == unit]
        yield d.Figure(panel(t, curves[: len(COLORS)], unit), "", "")
        if len(curves) > len(COLORS):
            yield d.Paragraph((f"and {len(curves) - len(COLORS)} more, motion.plot()",))


def panel(t: Array, histories: list[tuple[str, Array]], unit: str) -> str:
    """Curves over one axis of time, with the least and largest value and the names."""
    values = np.concatenate([y[np.isfinite(y)] for _, y in histories])
    low, high = (float(values.min()), float(values.max())) if values.size else (0.0, 0.0)
    if high - low <= 1e-9 * max(abs(low), abs(high), 1e-300):
        low, high = low - 0.5, high + 0.5
    frame = f"M{LEFT} 4V{HEIGHT}H{WIDTH - 4}"
    parts = [f'<path d="{frame}" fill="none" stroke="currentColor" stroke-opacity="0.5"/>']
    parts += [_text(LEFT - 6, at, f"{x:.3g}", "end") for at, x in ((12, high), (HEIGHT, low))]
    below = HEIGHT + BELOW - 4
    parts.append(_text(LEFT, below, f"{t[0]:g} s", "start"))
    parts.append(_text(WIDTH - 4, below, f"{t[-1]:g} s", "end"))
    x, y = LEFT, below + LINE
    for color, (name, history) in zip(COLORS, histories, strict=False):
        line = f'fill="none" stroke="{color}" stroke-width="1.4"'
        title = f"<title>{escape(name)}</title>"
        parts += [f'<path d="{p}" {line}>{title}</path>' for p in _lines(t, history, low, high)]
        short = name if len(name) <= LONGEST else name[: LONGEST - 1] + "…"
        wide = LETTER * (len(short) + 4)
        x, y = (x, y) if x + wide <= WIDTH else (LEFT, y + LINE)
        parts.append(_text(x, y, "━", "start", color) + _text(x + 2 * LETTER, y, short, "start"))
        x += wide
    parts.append(_text(LEFT - 6, below + LINE, f"[{unit}]", "end") if unit else "")
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {y + 6}" width="{WIDTH}" '
        'style="max-width:100%" font-family="sans-serif" font-size="11" fill="currentColor">'
        f"{''.join(parts)}</svg>"
    )


def _text(x: float, y: float, label: str, anchor: str, color: str = "currentColor") -> str:
    place = f'x="{x}" y="{y}" text-anchor="{anchor}" fill="{color}"'
    return f"<text {place}>{escape(label)}</text>"


def _lines(t: Array, y: Array, low: float, high: float) -> list[str]:
    """Paths through the least and largest value of every bin, broken where there is none."""
    edges = np.linspace(0, len(t), min(len(t), BINS) + 1).astype(int)
    picked = list[int]()
    for a, b in pairwise(edges):
        inside = y[a:b]
        if not np.isfinite(inside).all():
            picked.append(-1)
            continue
        picked += sorted({a + int(inside.argmin()), a + int(inside.argmax())})
    span = float(t[-1] - t[0]) or 1.0
    paths, points = list[str](), list[str]()
    for k in (*picked, -1):
        if k >= 0:
            x = LEFT + (WIDTH - 4 - LEFT) * float(t[k] - t[0]) / span
            points.append(f"{x:.1f} {HEIGHT - (HEIGHT - 8) * (y[k] - low) / (high - low):.1f}")
        elif points:
            paths.append("M" + "L".join(points))
            points = []
    return paths
