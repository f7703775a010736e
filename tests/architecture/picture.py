"""The rooms and their imports as a picture: ``docs/architecture.svg``, drawn from the sources.

``python tests/architecture/picture.py`` writes it.
"""

from __future__ import annotations

import sys
from collections import Counter
from html import escape
from math import log2
from pathlib import Path

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parents[1]))

from architecture.counts import pairs
from architecture.sources import ROOT, all_imports, room
from architecture.table import ORDER

PATH = ROOT / "docs" / "architecture.svg"
TEXT = {
    "foundation": "errors, arrays, files, locks",
    "ir": "expressions",
    "passes": "fewer operations",
    "spatial": "rotations, moments of mass",
    "schema": "data that compiler and runtime share",
    "elements": "joints, forces, beams",
    "superelements": "reduced matrices",
    "scene": "what the user wrote; file readers",
    "topology": "numbered system, loops",
    "equations": "M, h, f, constraints, derivatives",
    "codegen": "C files",
    "runtime": "built, loaded, called, verified",
    "solids": "meshes of solids, their matrices",
    "view": "pictures and pages",
    "analyses": "runs, rest, linear models",
    "explain": "equations as documents",
    "api": "what users hold",
    "pipeline": "derive",
    "compilation": "compile",
    "parts": "ready subsystems",
    "live": "pages in which models run",
    "peers": "other programs",
    "cli": "commands",
}
ROW, LEFT, WIDTH, ARCS = 30, 16, 330, 180


def group(module: str) -> str:
    """The row of a module; small rooms at the bottom share one."""
    name = room(module)
    return name if name in TEXT else "" if name in ("__init__", "__main__") else "foundation"


def svg() -> str:
    """A row per room, the lowest at the bottom; arcs lead from rooms to those they import.

    All import the foundation.
    """
    rows = ["foundation", *(name for name in ORDER if name in TEXT)]
    arcs = Counter((group(source), group(target)) for _, source, target in pairs(all_imports()))
    height = ROW * len(rows) + 2 * LEFT
    y = {name: height - LEFT - ROW * k - ROW / 2 for k, name in enumerate(rows)}
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {LEFT + WIDTH + ARCS} {height}" '
        'font-family="sans-serif" font-size="13">',
        "<title>Rooms of cardan: each imports only rooms below it</title>",
        "<style>text{fill:#222}path{stroke:#4a6fa5}rect{fill:#eef2f8;stroke:#9db2cf}"
        "@media(prefers-color-scheme:dark){text{fill:#ddd}path{stroke:#8fb0e0}"
        "rect{fill:#25303f;stroke:#56708f}}</style>",
    ]
    for (source, target), count in sorted(arcs.items()):
        if source and target not in (source, "", "foundation"):
            top, bottom = y[source], y[target]
            reach = LEFT + WIDTH + (bottom - top) * 0.52
            lines.append(
                f'<path d="M{LEFT + WIDTH} {top:g} Q{reach:.1f} {(top + bottom) / 2:g} '
                f'{LEFT + WIDTH} {bottom:g}" fill="none" opacity="0.55" '
                f'stroke-width="{0.6 + 0.5 * int(log2(count)):g}">'
                f"<title>{source} imports {target}</title></path>"
            )
    for name in rows:
        lines.append(
            f'<rect x="{LEFT}" y="{y[name] - ROW / 2 + 3:g}" width="{WIDTH}" height="{ROW - 6}" '
            f'rx="4"/><text x="{LEFT + 10}" y="{y[name] + 4.5:g}"><tspan font-weight="bold">{name}'
            f'</tspan> <tspan opacity="0.75">{escape(TEXT[name])}</tspan></text>'
        )
    return "\n".join([*lines, "</svg>"]) + "\n"


if __name__ == "__main__":
    PATH.write_text(svg(), "utf-8")
