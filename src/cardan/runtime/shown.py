"""A run in notebooks: histories drawn, how it went, and how well energy was kept."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Array
from ..ir.html import Html, block, details, paragraph, text_block, written
from .summary import summary

if TYPE_CHECKING:
    from .trajectory import Trajectory

# of tones that can be seen on light and on dark pages
COLORS = ("#2a7fd4", "#e07b20", "#2e9e4f", "#d0453e", "#9467bd", "#a0705f", "#d06bb0", "#8a8f98")
WIDTH, HEIGHT, LEFT, BELOW = 640, 150, 64, 18
# pairs of points that are drawn of a history
BINS = 320


def html(motion: Trajectory) -> str:
    """Coordinates over time, a panel for each unit; then the summary."""
    head, *rest = summary(motion).splitlines()
    t, q = motion.t, motion.q
    if motion.dense is not None and 1 < len(motion) < BINS:
        t = np.linspace(t[0], t[-1], BINS)
        q = motion.at(t)[:, : motion.nq]
    panels = [paragraph(head)]
    rows = motion.manifest.coordinates
    units = dict.fromkeys(row.unit for row in rows)
    for unit in units if len(motion) > 1 else ():
        own = [(k, row.name) for k, row in enumerate(rows) if row.unit == unit]
        shown = own[: len(COLORS)]
        histories = [(name, q[:, k]) for k, name in shown]
        panels.append(panel(t, histories, unit))
        if len(own) > len(shown):
            panels.append(paragraph(f"and {len(own) - len(shown)} more, motion.plot()"))
    panels.append(details("how it went", text_block("\n".join(rest))))
    return block(*panels)


def panel(t: Array, histories: list[tuple[str, Array]], unit: str) -> Html:
    """Curves over one axis of time, with the least and largest value and the names."""
    values = np.concatenate([y[np.isfinite(y)] for _, y in histories] or [np.zeros(1)])
    low, high = (float(values.min()), float(values.max())) if values.size else (0.0, 0.0)
    if high - low <= 1e-9 * max(abs(low), abs(high), 1e-300):
        low, high = low - 0.5, high + 0.5
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT + BELOW}" '
        f'width="{WIDTH}" style="max-width:100%" font-family="sans-serif" font-size="11" '
        'fill="currentColor">',
        f'<path d="M{LEFT} 4V{HEIGHT}H{WIDTH - 4}" fill="none" stroke="currentColor" '
        'stroke-opacity="0.5"/>',
    ]
    for at, value in ((12, high), (HEIGHT, low)):
        parts.append(f'<text x="{LEFT - 6}" y="{at}" text-anchor="end">{value:.3g}</text>')
    for at, time, anchor in ((LEFT, t[0], "start"), (WIDTH - 4, t[-1], "end")):
        place = f'x="{at}" y="{HEIGHT + BELOW - 4}" text-anchor="{anchor}"'
        parts.append(f"<text {place}>{time:g} s</text>")
    for color, (name, y) in zip(COLORS, histories, strict=False):
        title = f"<title>{written(name)}</title>"
        line = f'fill="none" stroke="{color}" stroke-width="1.4"'
        parts += [f'<path d="{d}" {line}>{title}</path>' for d in _lines(t, y, low, high)]
    names = Html(
        " ".join(
            f'<span style="margin-right:12px"><span style="color:{color}">━</span> '
            f"{written(name)}</span>"
            for color, (name, _) in zip(COLORS, histories, strict=False)
        )
    )
    label = Html(f"{names}{written(f'[{unit}]' if unit else '')}")
    return Html(f"{''.join(parts)}</svg>{paragraph(label)}")


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
    found, points = list[str](), list[str]()
    for k in (*picked, -1):
        if k >= 0:
            x = LEFT + (WIDTH - 4 - LEFT) * float(t[k] - t[0]) / span
            points.append(f"{x:.1f} {HEIGHT - (HEIGHT - 8) * (y[k] - low) / (high - low):.1f}")
        elif points:
            found.append("M" + "L".join(points))
            points = []
    return found
